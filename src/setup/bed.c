#include "setup/bed.h"

#include <math.h>
#include <string.h>

#include "geometry/wall_gap.h"
#include "setup/domain.h"

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

clod_setup_bed clod_setup_bed_of(const clod_state *state)
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

double clod_setup_bed_pressed_area(const clod_wall *wall, const clod_setup_bed *bed)
{
    return wall->area > 0.0 ? wall->area : bed->area;
}

/** Largest stress that a wall's load has in any stage, with the wall's weight [Pa]. */
static double load_stress(const clod_case *from, const clod_wall *wall,
                          const clod_setup_bed *bed)
{
    const double area = clod_setup_bed_pressed_area(wall, bed);
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
    const clod_setup_bed bed = clod_setup_bed_of(state);
    double wall_speed = 0.0;
    for (int32_t w = 0; w < state->walls.count; w++) {
        wall_speed = fmax(wall_speed, clod_wall_speed_bound(&state->walls.wall[w]));
    }
    return bed.speed + sqrt(2.0 * bed.gravity * fall_height(state)) + wall_speed;
}

double clod_setup_bed_stress(const clod_setup_bed *bed, const clod_case *from,
                             const clod_state *state)
{
    double stress = bed->area > 0.0 ? bed->mass * bed->gravity / bed->area : 0.0;
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        if (wall->load != CLOD_LOAD_NONE && clod_setup_bed_pressed_area(wall, bed) > 0.0) {
            stress = fmax(stress, load_stress(from, wall, bed));
        }
    }
    return stress;
}
