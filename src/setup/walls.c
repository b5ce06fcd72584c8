#include "setup/walls.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "mesh/surface_touch.h"
#include "setup/outlets.h"
#include "setup/surface.h"
#include "state/part_labels.h"
#include "state/wear.h"

/** The mean velocity of a step is then within (2 pi/50)^2/24 = 0.07 % of the velocity in it. */
#define STEPS_PER_PERIOD 50.0

static clod_shape make_shape(const clod_case_shape *from)
{
    clod_shape shape = {.kind = (clod_shape_kind)from->kind,
                        .center = clod_vec3_of(from->point)};
    const clod_shape_kind_row *kind = clod_shape_kinds_row(shape.kind);
    kind->make(from, &shape);
    if (!kind->solid) {
        clod_vec3_complete(shape.axis);
    }
    return shape;
}

/** Whether the wall turns at the start or in any stage. */
static bool ever_turns(const clod_case *from, const clod_case_wall *wall)
{
    bool turns = wall->spin != 0.0 || wall->oscillation.angle != 0.0;
    for (size_t s = 0; s < from->stage_count; s++) {
        const clod_case_stage *stage = &from->stages[s];
        for (size_t w = 0; w < stage->wall_count; w++) {
            const clod_case_wall_change *change = &stage->walls[w];
            turns |= change->has_spin && change->spin != 0.0 &&
                     strcmp(change->name, wall->name) == 0;
        }
    }
    return turns;
}

/** Area of the discs and annuli of a wall that face the load axis [m2]. */
static double facing_area(const clod_wall *wall)
{
    double area = 0.0;
    for (int32_t s = 0; s < wall->shape_count; s++) {
        const clod_shape *shape = &wall->shapes[s];
        if (clod_shape_kinds_row(shape->kind)->flat) {
            const double ring = shape->outer * shape->outer - shape->inner * shape->inner;
            area += M_PI * ring * fabs(clod_vec3_dot(shape->axis[2], wall->load_axis));
        }
    }
    return area;
}

static void make_load(const clod_case_wall *from, clod_wall *wall)
{
    wall->load = (clod_load_kind)from->load;
    wall->load_axis = (clod_vec3){0.0, 0.0, -1.0};
    if (wall->load == CLOD_LOAD_NONE) {
        return;
    }
    wall->load_axis = clod_vec3_unit(clod_vec3_of(from->load_axis));
    wall->mass = from->mass;
    wall->damping_fraction = from->damping;
    wall->area = from->area > 0.0 ? from->area : facing_area(wall);
    wall->load_force = wall->load == CLOD_LOAD_STRESS ? from->stress * wall->area : from->force;
}

static void make_oscillation(const clod_case_oscillation *from, clod_wall *wall)
{
    if (from->frequency == 0.0) {
        return;
    }
    wall->oscillation = (clod_oscillation){.amplitude = from->amplitude,
                                           .angle = from->angle,
                                           .frequency = from->frequency,
                                           .phase = from->phase};
    if (from->amplitude > 0.0) {
        wall->oscillation.direction = clod_vec3_unit(clod_vec3_of(from->direction));
    }
}

/** A direction of a case, as unit vector; zero where it says nothing. */
static clod_vec3 direction(const double v[3])
{
    const clod_vec3 given = clod_vec3_of(v);
    return clod_vec3_dot(given, given) > 0.0 ? clod_vec3_unit(given) : given;
}

static clod_belt make_belt(const clod_case_surface *from)
{
    return (clod_belt){.velocity = clod_vec3_of(from->velocity),
                       .direction = direction(from->direction),
                       .speed = from->speed,
                       .spin = from->spin,
                       .spin_axis = direction(from->spin_axis),
                       .spin_point = clod_vec3_of(from->spin_point)};
}

/** Turn and shift a shape with its belt, as the case asks for. */
static void place_shape(const clod_case_wall *given, clod_shape *shape)
{
    const clod_vec3 move = clod_vec3_of(given->move);
    if (given->rotate.angle != 0.0) {
        const clod_vec3 axis = clod_vec3_unit(clod_vec3_of(given->rotate.axis));
        const clod_vec3 point = clod_vec3_of(given->rotate.point);
        clod_vec3 *directions[] = {&shape->axis[0],        &shape->axis[1],
                                   &shape->axis[2],        &shape->belt.velocity,
                                   &shape->belt.direction, &shape->belt.spin_axis};
        clod_vec3 *points[] = {&shape->center, &shape->belt.spin_point};
        for (int k = 0; k < 6; k++) {
            *directions[k] = clod_vec3_rotate(*directions[k], axis, given->rotate.angle);
        }
        for (int k = 0; k < 2; k++) {
            const clod_vec3 arm = clod_vec3_sub(*points[k], point);
            *points[k] = clod_vec3_add(point, clod_vec3_rotate(arm, axis, given->rotate.angle));
        }
    }
    shape->center = clod_vec3_add(shape->center, move);
    shape->belt.spin_point = clod_vec3_add(shape->belt.spin_point, move);
}

/** Room for more shapes behind those of a wall; NULL without memory. */
static clod_shape *more_shapes(clod_wall *wall, size_t count, clod_status *status)
{
    const size_t old = (size_t)wall->shape_count;
    clod_shape *grown = clod_memory_grow(wall->shapes, old, old + count, sizeof *grown);
    if (grown == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for the shapes of %s", wall->name);
        return NULL;
    }
    wall->shapes = grown;
    wall->shape_count = (int32_t)(old + count);
    return grown + old;
}

/** Belt of a surface, and its material where it has one of its own. */
static void dress(const clod_case *whole, const clod_case_surface *from, clod_shape *shape)
{
    shape->belt = make_belt(from);
    if (from->material != NULL) { // checked at load
        shape->material = 1 + clod_case_material_index(whole, from->material);
    }
}

/** The shape of a case, as a wall has it. */
static bool make_plain(const clod_case_wall *given, const clod_case_shape *from,
                       const clod_shape *common, clod_wall *wall, clod_status *status)
{
    clod_shape *shape = more_shapes(wall, 1, status);
    if (shape == NULL) {
        return false;
    }
    *shape = make_shape(from);
    shape->belt = common->belt;
    shape->material = common->material;
    place_shape(given, shape);
    return true;
}

/** Put the key of a mesh in the case before what is wrong with it. */
static void tell_key(const clod_case_wall *given, const clod_case_shape *from,
                     clod_status *status)
{
    const clod_status said = *status;
    const bool lost = strstr(said.text, "cannot be opened") != NULL;
    const char *below = strncmp(said.text, "parts.", 6) == 0 ? "." : ".file: ";
    if (from->file != NULL) {
        clod_status_fail(status, said.code, "walls.%s.shapes.%d.mesh%s%s%s", given->name,
                         (int)(from - given->shapes), below, said.text,
                         lost ? "; its path is taken from the folder of the case file" : "");
    }
}

/** A mesh is a shape for each contact that a grain can have with each of its patches. */
static bool make_patches(const clod_case *whole, const clod_case_wall *given,
                         const clod_case_shape *from, const clod_shape *common, clod_wall *wall,
                         clod_status *status)
{
    clod_setup_mesh mesh = clod_setup_mesh_read(given, from, status);
    clod_surface *surface = mesh.surface;
    if (surface == NULL) {
        tell_key(given, from, status);
    }
    clod_shape *shape =
        surface == NULL ? NULL
                        : more_shapes(wall, CLOD_SURFACE_SLOTS * surface->patch_count, status);
    for (size_t p = 0; shape != NULL && p < surface->patch_count; p++) {
        const clod_surface_patch *patch = &surface->patches[p];
        clod_shape made = *common;
        if (mesh.parts[patch->part] != NULL) {
            dress(whole, mesh.parts[patch->part], &made);
        }
        place_shape(given, &made);
        for (int32_t slot = 0; slot < CLOD_SURFACE_SLOTS; slot++, shape++) {
            *shape = made;
            clod_setup_surface_shape(surface, (int32_t)p, slot, shape);
        }
    }
    const bool good = shape != NULL;
    clod_setup_mesh_fini(&mesh); // the shapes are the users of its surface
    return good;
}

static bool make_shapes(const clod_case *from, const clod_case_wall *given, clod_wall *wall,
                        clod_status *status)
{
    for (size_t s = 0; s < given->shape_count; s++) {
        const clod_case_shape *shape = &given->shapes[s];
        clod_shape common = {0};
        dress(from, &shape->surface, &common);
        const bool mesh = clod_shape_kinds_row((clod_shape_kind)shape->kind)->faceted;
        if (!(mesh ? make_patches(from, given, shape, &common, wall, status)
                   : make_plain(given, shape, &common, wall, status))) {
            return false;
        }
    }
    if (!clod_part_labels_make(wall)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the surfaces of walls.%s",
                                wall->name);
    }
    clod_wall_find_symmetry(wall);
    const int32_t plane = clod_wall_plane_across(wall);
    return plane < 0 || !ever_turns(from, given) ||
           clod_status_fail(status, CLOD_USAGE,
                            "walls.%s.shapes.%d: an endless plane can turn only about "
                            "its own normal; use a box or a disc",
                            given->name, (int)plane);
}

bool clod_setup_wall(const clod_case *from, const clod_case_wall *given, clod_wall *wall,
                     clod_status *status)
{
    if (strlen(given->name) >= sizeof wall->name) {
        return clod_status_fail(status, CLOD_USAGE,
                                "walls.%s: the name is too long, at most %zu characters",
                                given->name, sizeof wall->name - 1);
    }
    snprintf(wall->name, sizeof wall->name, "%s", given->name);
    const int material = clod_case_material_index(from, given->material);
    CLOD_ASSERT(material >= 0); // checked at load
    wall->material = (uint16_t)material;
    wall->velocity = clod_vec3_of(given->velocity);
    wall->surface_velocity = clod_vec3_of(given->surface_velocity);
    wall->spin = given->spin;
    wall->spin_axis = clod_vec3_unit(clod_vec3_of(given->spin_axis));
    wall->spin_point = clod_vec3_of(given->spin_point);
    if (!make_shapes(from, given, wall, status)) {
        return false;
    }
    make_load(given, wall);
    make_oscillation(&given->oscillation, wall);
    wall->start_up = (clod_start_up){given->start_up.at, given->start_up.duration};
    clod_wall_start(wall);
    return true;
}

/** How the materials of the shapes wear. */
static void set_wear(const clod_case *from, clod_wall *wall)
{
    for (int32_t s = 0; s < wall->shape_count; s++) {
        const clod_case_material *of = &from->materials[clod_wall_material(wall, s)];
        if (of->hardness > 0.0) {
            wall->shapes[s].archard = of->archard / of->hardness;
            wall->shapes[s].finnie = of->finnie / of->hardness;
        }
    }
}

/** Whether no wall `surface_NAME` stands beside one of this name that has a single surface: the
 *  columns of this would be called as its own. */
static bool check_names(const clod_walls *walls, clod_status *status)
{
    static const char BEFORE[] = "surface_"; // of the names of the columns (sim/surfaces.c)
    for (int32_t w = 0; w < walls->count; w++) {
        const char *name = walls->wall[w].name, *rest = name + sizeof BEFORE - 1;
        const bool begins = strncmp(name, BEFORE, sizeof BEFORE - 1) == 0;
        const int32_t other = begins ? clod_walls_find(walls, rest) : -1;
        char surface[CLOD_WEAR_NAME] = "";
        if (other >= 0) {
            clod_wear_name(&walls->wall[other], 0, surface, sizeof surface);
        }
        if (begins && strcmp(surface, rest) == 0) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "walls.%s: with output.surfaces the columns of walls.%s "
                                    "in series.csv have this name; rename one of the walls",
                                    name, rest);
        }
    }
    return true;
}

bool clod_setup_walls(const clod_case *from, clod_walls *walls, clod_status *status)
{
    *walls = (clod_walls){0};
    if (from->wall_count == 0) {
        return true;
    }
    walls->wall = clod_memory_alloc(from->wall_count, sizeof *walls->wall);
    if (walls->wall == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the walls");
    }
    for (size_t w = 0; w < from->wall_count; w++) {
        walls->count = (int32_t)(w + 1);
        if (!clod_setup_wall(from, &from->walls[w], &walls->wall[w], status)) {
            return false;
        }
        set_wear(from, &walls->wall[w]);
        if (from->output.surfaces && !clod_wear_begin(&walls->wall[w])) {
            return clod_status_fail(status, CLOD_FAILED, "no memory for the places of walls.%s",
                                    walls->wall[w].name);
        }
    }
    return (!from->output.surfaces || check_names(walls, status)) &&
           clod_setup_outlets(from, walls, status);
}

bool clod_setup_wall_stays(const clod_case *from, const clod_wall *wall)
{
    bool stays = wall->load == CLOD_LOAD_NONE &&
                 clod_vec3_dot(wall->velocity, wall->velocity) == 0.0 && wall->spin == 0.0 &&
                 !(wall->oscillation.frequency > 0.0);
    for (size_t s = 0; s < from->stage_count; s++) {
        for (size_t w = 0; w < from->stages[s].wall_count; w++) {
            stays = stays && strcmp(from->stages[s].walls[w].name, wall->name) != 0;
        }
    }
    return stays;
}

bool clod_setup_wall_pace(const clod_walls *walls, double dt, clod_status *status)
{
    for (int32_t w = 0; w < walls->count; w++) {
        const clod_wall *wall = &walls->wall[w];
        const double limit = 1.0 / (STEPS_PER_PERIOD * wall->oscillation.frequency);
        if (dt > limit) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "walls.%s.oscillation.frequency: %g Hz is too fast for the "
                                    "time step of %g s; a period needs at least %g steps, set "
                                    "time.step to at most %.3g s",
                                    wall->name, wall->oscillation.frequency, dt,
                                    STEPS_PER_PERIOD, limit);
        }
    }
    return true;
}

void clod_setup_wall_damping(clod_wall *wall, double stiffness)
{
    wall->damping = 2.0 * wall->damping_fraction * sqrt(stiffness * wall->mass);
}

double clod_setup_bed_stiffness(double tangent, double area, double height, double radius)
{
    const double diameter = 2.0 * radius;
    const double columns = fmax(1.0, area / (diameter * diameter));
    const double contacts = fmax(1.0, height / diameter);
    return tangent * columns / contacts;
}
