#include "setup/state.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "config/sizes.h"
#include "config/testers.h"
#include "geometry/wall_gap.h"
#include "setup/domain.h"
#include "setup/grains.h"
#include "setup/walls.h"

/** Solid fraction assumed of a settled bed. */
#define BED_FRACTION 0.6

/** Totals of the grains of a state. */
typedef struct clod_setup_bed {
    double radius_mean;  ///< m
    double mass, volume; ///< kg, m3 of solid
    double speed;        ///< m/s, fastest grain
    double area;         ///< m2, of the grains' bounding box seen along gravity
    double gravity;      ///< m/s2
} clod_setup_bed;

static double length3(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/** Area of a box seen along gravity, or along z without it. */
static double shadow(const double low[3], const double high[3], const double gravity[3])
{
    const double g = length3(gravity);
    const double e[3] = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
    const double u[3] = {g > 0.0 ? fabs(gravity[0]) / g : 0.0,
                         g > 0.0 ? fabs(gravity[1]) / g : 0.0,
                         g > 0.0 ? fabs(gravity[2]) / g : 1.0};
    return u[0] * e[1] * e[2] + u[1] * e[2] * e[0] + u[2] * e[0] * e[1];
}

static clod_setup_bed measure_bed(const clod_state *state)
{
    clod_setup_bed bed = {.gravity = length3(state->gravity)};
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *place = state->grains.position[g];
        const double r = place[3];
        for (int a = 0; a < 3; a++) {
            low[a] = fmin(low[a], place[a] - r);
            high[a] = fmax(high[a], place[a] + r);
        }
        bed.radius_mean += r / (double)state->grains.count;
        bed.mass += state->grains.velocity[g][3];
        bed.volume += 4.0 / 3.0 * M_PI * r * r * r;
        bed.speed = fmax(bed.speed, length3(state->grains.velocity[g]));
    }
    bed.area = state->grains.count > 0 ? shadow(low, high, state->gravity) : 0.0;
    return bed;
}

/** Area on which a wall presses: its own, or the bed's. */
static double pressed_area(const clod_wall *wall, const clod_setup_bed *bed)
{
    return wall->area > 0.0 ? wall->area : bed->area;
}

/** Largest stress that a wall's load has in any stage, with the wall's weight [Pa]. */
static double load_stress(const clod_case *from, const clod_wall *wall,
                          const clod_setup_bed *bed)
{
    const double area = pressed_area(wall, bed);
    double force = wall->load_force;
    for (size_t s = 0; s < from->stage_count; s++) {
        const clod_case_stage *stage = &from->stages[s];
        for (size_t w = 0; w < stage->wall_count; w++) {
            const clod_case_wall_change *change = &stage->walls[w];
            if (strcmp(change->name, wall->name) == 0) {
                force = change->has_force ? fmax(force, change->force) : force;
                force = change->has_stress ? fmax(force, change->stress * area) : force;
            }
        }
    }
    return (force + wall->mass * bed->gravity) / area;
}

/** Height through which a grain can fall: that of everything, and above planes [m]. */
static double fall_height(const clod_state *state)
{
    double low[3], high[3];
    const double g = length3(state->gravity);
    if (g == 0.0 || !clod_setup_bounds(state, low, high)) {
        return 0.0;
    }
    double height = 0.0;
    for (int a = 0; a < 3; a++) {
        height += fabs(state->gravity[a]) / g * (high[a] - low[a]);
    }
    const clod_vec3 down = {state->gravity[0] / g, state->gravity[1] / g,
                            state->gravity[2] / g};
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const clod_shape *shape = &wall->shapes[s];
            const double facing = -clod_vec3_dot(shape->axis[2], down);
            if (!clod_shape_kinds_row(shape->kind)->endless || facing < 0.1) {
                continue;
            }
            for (size_t i = 0; i < state->grains.count; i++) {
                const double *p = state->grains.position[i];
                const clod_gap gap = clod_wall_gap(shape, clod_vec3_of(p));
                height = fmax(height, gap.distance / facing);
            }
        }
    }
    return height;
}

double clod_setup_impact_speed(const clod_state *state)
{
    const clod_setup_bed bed = measure_bed(state);
    double wall_speed = 0.0;
    for (int32_t w = 0; w < state->walls.count; w++) {
        wall_speed = fmax(wall_speed, clod_wall_speed_bound(&state->walls.wall[w]));
    }
    return bed.speed + sqrt(2.0 * bed.gravity * fall_height(state)) + wall_speed;
}

/** Stress and impact speed of a free run. */
static void free_load(const clod_case *from, const clod_state *state, const clod_setup_bed *bed,
                      clod_setup_bound *bound)
{
    bound->stress = bed->area > 0.0 ? bed->mass * bed->gravity / bed->area : 0.0;
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        if (wall->load != CLOD_LOAD_NONE && pressed_area(wall, bed) > 0.0) {
            bound->stress = fmax(bound->stress, load_stress(from, wall, bed));
        }
    }
    bound->speed = clod_setup_impact_speed(state);
}

/** The sizes of grains that are to come: two each of the smallest and of the median, which can
 *  meet their like. */
static bool add_coming(clod_setup_bound *self, const clod_case *from,
                       const clod_case_grains *group, clod_status *status)
{
    clod_sizes sizes;
    const bool good = clod_sizes_init(&sizes, group, status);
    if (good) {
        const int material = clod_case_material_index(from, group->material);
        clod_timestep_add(&self->sizes[material], 2.0, sizes.min);
        clod_timestep_add(&self->sizes[material], 2.0, clod_sizes_quantile(&sizes, 0.5));
    }
    clod_sizes_fini(&sizes);
    return good;
}

bool clod_setup_bound_init(clod_setup_bound *self, const clod_case *from,
                           const clod_state *state, clod_status *status)
{
    *self = (clod_setup_bound){.stress = from->time.design_stress};
    const size_t materials = from->material_count + 1; // never an array of none
    self->sizes = clod_memory_alloc(materials, sizeof *self->sizes);
    self->is_wall = clod_memory_alloc(materials, sizeof *self->is_wall);
    if (self->sizes == NULL || self->is_wall == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the time step");
    }
    for (size_t g = 0; g < state->grains.count; g++) {
        clod_timestep_add(&self->sizes[state->grains.material[g]], 1.0,
                          state->grains.position[g][3]);
    }
    for (size_t k = 0; k < from->grains_count; k++) {
        if (from->grains[k].comes && !add_coming(self, from, &from->grains[k], status)) {
            return false;
        }
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            self->is_wall[clod_wall_material(wall, s)] = true;
        }
    }
    if (self->stress == 0.0) {
        self->stress = clod_case_tester_stress(from);
    }
    if (self->stress == 0.0) {
        const clod_setup_bed bed = measure_bed(state);
        free_load(from, state, &bed, self);
    }
    return true;
}

clod_timestep clod_setup_bound_timestep(const clod_setup_bound *self, const clod_case *from)
{
    const clod_timestep_grains grains = {.sizes = self->sizes,
                                         .is_wall = self->is_wall,
                                         .stress = self->stress,
                                         .speed = self->speed};
    return clod_timestep_choose(from, &grains);
}

void clod_setup_bound_fini(clod_setup_bound *self)
{
    clod_memory_free(self->sizes);
    clod_memory_free(self->is_wall);
    *self = (clod_setup_bound){0};
}

bool clod_setup_timestep(const clod_case *from, const clod_state *state, clod_timestep *result,
                         clod_status *status)
{
    *result = (clod_timestep){0};
    clod_setup_bound bound;
    const bool good = clod_setup_bound_init(&bound, from, state, status);
    if (good) {
        *result = clod_setup_bound_timestep(&bound, from);
    }
    clod_setup_bound_fini(&bound);
    return good && clod_timestep_accept(result, status);
}

/** Fraction of critical that the case asks for a wall's damping. */
static double damping_fraction(const clod_case *from, const clod_wall *wall)
{
    for (size_t w = 0; w < from->wall_count; w++) {
        if (strcmp(from->walls[w].name, wall->name) == 0) {
            return from->walls[w].damping;
        }
    }
    return clod_config_tester_of(from)->lid_damping(from); // no other wall has a load
}

void clod_setup_damping(const clod_case *from, clod_state *state, const clod_timestep *timestep)
{
    const clod_setup_bed bed = measure_bed(state);
    for (int32_t w = 0; w < state->walls.count; w++) {
        clod_wall *wall = &state->walls.wall[w];
        const double area = pressed_area(wall, &bed);
        if (wall->load == CLOD_LOAD_NONE || !(area > 0.0)) {
            continue;
        }
        const double height = bed.volume / (BED_FRACTION * area);
        const double k =
            clod_setup_bed_stiffness(timestep->unloading, area, height, bed.radius_mean);
        clod_setup_wall_damping(wall, damping_fraction(from, wall), k);
    }
}

bool clod_setup_state(const clod_case *from, int64_t seed, clod_state *state,
                      clod_status *status)
{
    *state = (clod_state){.build_motion = -1.0,
                          .adhesion = from->stage_count > 0 ? from->stages[0].adhesion : 1.0};
    memcpy(state->gravity, from->gravity, sizeof state->gravity);
    if (!clod_setup_walls(from, &state->walls, status)) {
        return false;
    }
    if (from->has_domain) {
        clod_setup_domain(from, state); // insertion asks where space is periodic
    }
    clod_timestep timestep;
    if (!clod_setup_grains(from, seed, state, status) ||
        !clod_setup_timestep(from, state, &timestep, status)) {
        return false;
    }
    if (state->grains.count == 0 && !clod_config_begins_empty(from) &&
        clod_setup_grains_coming(from) == 0) {
        return clod_status_fail(status, CLOD_USAGE, "grains: the case has no grains");
    }
    clod_setup_domain(from, state);
    clod_setup_damping(from, state, &timestep);
    state->dt = timestep.step;
    return clod_setup_wall_pace(&state->walls, state->dt, status);
}
