#pragma once
/**
 * @file scene.h
 * A small simulation built by hand: grains, walls and laws around the real step.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "step/step.h"
#include "support/check.h"
#include "support/materials.h"

#define SCENE_MATERIALS 3
#define SCENE_LAWS 6
#define SCENE_WALLS 8

typedef struct scene {
    clod_state state;
    clod_law law[SCENE_LAWS];
    clod_laws laws;
    clod_step step;
} scene;

/** An empty scene with one law for all pairs of materials; open 20 m domain, no gravity. */
static inline void scene_init(scene *self, double dt, const clod_case_contact *contact)
{
    *self =
        (scene){.state = {.dt = dt,
                          .build_motion = -1.0,
                          .adhesion = 1.0,
                          .domain = {.min = {-10.0, -10.0, -10.0}, .max = {10.0, 10.0, 10.0}}},
                .laws = {.materials = SCENE_MATERIALS, .count = SCENE_LAWS}};
    self->laws.law = self->law;
    for (int l = 0; l < SCENE_LAWS; l++) {
        self->law[l] = clod_law_make(contact, &ORE, &ORE);
    }
}

/** Another law for one pair of materials. */
static inline void scene_law(scene *self, int a, int b, const clod_case_contact *contact)
{
    self->law[clod_laws_index(&self->laws, a, b)] = clod_law_make(contact, &ORE, &ORE);
}

/** Add a grain; its id is its number. Returns the row, which holds until scene_start. */
static inline size_t scene_grain(scene *self, double x, double y, double z, double radius)
{
    clod_status status = {0};
    const size_t g = self->state.grains.count;
    const double place[4] = {x, y, z, radius};
    const double none[3] = {0.0, 0.0, 0.0};
    if (!clod_grains_add(&self->state.grains, place, none, none, ORE.density, 0, g, &status)) {
        fail_msg("%s", status.text);
    }
    return g;
}

static inline void scene_move(scene *self, size_t row, double vx, double vy, double vz)
{
    memcpy(self->state.grains.velocity[row], (double[3]){vx, vy, vz}, 3 * sizeof(double));
}

static inline void scene_turn(scene *self, size_t row, double wx, double wy, double wz)
{
    memcpy(self->state.grains.angular_velocity[row], (double[3]){wx, wy, wz},
           3 * sizeof(double));
}

/** Add a wall of one shape. The pointer holds until the scene ends. */
static inline clod_wall *scene_wall(scene *self, const char *name, clod_shape shape)
{
    clod_walls *walls = &self->state.walls;
    if (walls->wall == NULL) {
        walls->wall = clod_memory_alloc(SCENE_WALLS, sizeof *walls->wall);
    }
    assert_true(walls->count < SCENE_WALLS);
    clod_wall *wall = &walls->wall[walls->count++];
    snprintf(wall->name, sizeof wall->name, "%s", name);
    wall->spin_axis = wall->load_axis = (clod_vec3){0.0, 0.0, 1.0};
    wall->shape_count = 1;
    wall->shapes = clod_memory_alloc(1, sizeof *wall->shapes);
    wall->shapes[0] = shape;
    return wall;
}

/** axis[2] along a direction, the others anyhow across. */
static inline clod_shape shape_along(clod_shape_kind kind, clod_vec3 center, clod_vec3 axis)
{
    const clod_vec3 z = clod_vec3_unit(axis);
    const clod_vec3 help =
        fabs(z.x) < 0.9 ? (clod_vec3){1.0, 0.0, 0.0} : (clod_vec3){0.0, 1.0, 0.0};
    const clod_vec3 x = clod_vec3_unit(clod_vec3_cross(help, z));
    return (clod_shape){.kind = kind, .center = center, .axis = {x, clod_vec3_cross(z, x), z}};
}

static inline clod_shape shape_plane(clod_vec3 point, clod_vec3 normal)
{
    clod_shape shape = shape_along(CLOD_SHAPE_PLANE, point, normal);
    shape.symmetric = true;
    return shape;
}

/** The plane z = height with the grains above. */
static inline clod_shape shape_floor(double height)
{
    return shape_plane((clod_vec3){0.0, 0.0, height}, (clod_vec3){0.0, 0.0, 1.0});
}

static inline clod_shape shape_box(clod_vec3 center, double half_x, double half_y,
                                   double half_z)
{
    return (clod_shape){.kind = CLOD_SHAPE_BOX,
                        .center = center,
                        .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                        .half = {half_x, half_y, half_z}};
}

/** An upright cylinder about the z axis with the grains inside. */
static inline clod_shape shape_drum(double foot, double radius, double length)
{
    clod_shape shape = shape_along(CLOD_SHAPE_CYLINDER, (clod_vec3){0.0, 0.0, foot},
                                   (clod_vec3){0.0, 0.0, 1.0});
    shape.symmetric = true;
    shape.outer = radius;
    shape.half[2] = 0.5 * length;
    shape.side = CLOD_SIDE_INSIDE;
    return shape;
}

/** An upright cone about the z axis with the grains inside. */
static inline clod_shape shape_hopper(double foot, double foot_radius, double top_radius,
                                      double length)
{
    clod_shape shape = shape_drum(foot, foot_radius, length);
    shape.kind = CLOD_SHAPE_CONE;
    shape.inner = top_radius;
    return shape;
}

/** Threads of a test yield while they wait, and do not spin: other tests want their processors. */
static inline void scene_yields(clod_step *step)
{
    step->barrier.round.crowded = true;
    for (int t = 0; t < step->threads; t++) {
        step->gate[t].crowded = step->placed_gate[t].crowded = true;
    }
}

static inline void scene_start_with(scene *self, clod_step_options options)
{
    clod_status status = {0};
    if (!clod_step_init(&self->step, &self->state, &self->laws, &options, &status)) {
        fail_msg("%s", status.text);
    }
    if (self->step.gate != NULL) {
        scene_yields(&self->step);
    }
}

static inline void scene_start(scene *self)
{
    scene_start_with(self, (clod_step_options){.threads = 1});
}

/** Keep the energy ledger from now on. */
static inline void scene_open_ledger(scene *self)
{
    clod_status status = {0};
    if (!clod_step_open_ledger(&self->step, &status)) {
        fail_msg("%s", status.text);
    }
}

static inline void scene_run(scene *self, int64_t steps)
{
    clod_status status = {0};
    if (!clod_step_advance(&self->step, steps, &status)) {
        fail_msg("%s", status.text);
    }
}

static inline void scene_end(scene *self)
{
    clod_step_fini(&self->step);
    clod_state_fini(&self->state);
}

/** Row of the grain with an id. */
static inline size_t scene_row(const scene *self, uint64_t id)
{
    for (size_t g = 0; g < self->state.grains.count; g++) {
        if (self->state.grains.id[g] == id) {
            return g;
        }
    }
    fail_msg("no grain %llu", (unsigned long long)id);
    return 0;
}
