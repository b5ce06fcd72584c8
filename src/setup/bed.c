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

/** Height of grains above planes that they can fall on [m]. */
static double height_above(const clod_state *state, size_t first)
{
    const double g = length3(state->gravity);
    const clod_vec3 down = {state->gravity[0] / g, state->gravity[1] / g,
                            state->gravity[2] / g};
    double height = 0.0;
    for (int32_t w = 0; g > 0.0 && w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const clod_shape *shape = &wall->shapes[s];
            const double facing = -clod_vec3_dot(shape->axis[2], down);
            if (!clod_shape_kinds_row(shape->kind)->endless || facing < 0.1) {
                continue;
            }
            for (size_t i = first; i < state->grains.count; i++) {
                const double *p = state->grains.position[i];
                const clod_gap gap = clod_wall_gap(shape, clod_vec3_of(p));
                height = fmax(height, gap.distance / facing);
            }
        }
    }
    return height;
}

clod_setup_bed clod_setup_bed_begin(const clod_state *state, size_t grains)
{
    return (clod_setup_bed){.all = (double)grains,
                            .gravity = length3(state->gravity),
                            .low = {HUGE_VAL, HUGE_VAL, HUGE_VAL},
                            .high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
}

void clod_setup_bed_add(clod_setup_bed *self, const clod_state *state, size_t first)
{
    for (size_t g = first; g < state->grains.count; g++) {
        const double *place = state->grains.position[g];
        const double r = place[3];
        for (int a = 0; a < 3; a++) {
            self->low[a] = fmin(self->low[a], place[a] - r);
            self->high[a] = fmax(self->high[a], place[a] + r);
        }
        self->grains++;
        self->radius_mean += r / self->all;
        self->radius_sum += r;
        self->mass += state->grains.velocity[g][3];
        clod_exact_add(&self->mass_sum, state->grains.velocity[g][3]);
        self->last_id =
            state->grains.id[g] > self->last_id ? state->grains.id[g] : self->last_id;
        self->volume += 4.0 / 3.0 * M_PI * r * r * r;
        self->speed = fmax(self->speed, length3(state->grains.velocity[g]));
    }
    self->above = fmax(self->above, height_above(state, first));
    self->area = self->grains > 0 ? shadow(self->low, self->high, state->gravity) : 0.0;
}

clod_setup_bed clod_setup_bed_of(const clod_state *state)
{
    clod_setup_bed bed = clod_setup_bed_begin(state, state->grains.count);
    clod_setup_bed_add(&bed, state, 0);
    return bed;
}

/** Height through which a grain can fall: that of everything, and above planes [m]. */
static double fall_height(const clod_setup_bed *bed, const clod_state *state)
{
    double low[3], high[3];
    memcpy(low, bed->low, sizeof low);
    memcpy(high, bed->high, sizeof high);
    if (bed->gravity == 0.0 || !clod_setup_bounds_around(&state->walls, low, high)) {
        return 0.0;
    }
    double height = 0.0;
    for (int a = 0; a < 3; a++) {
        height += fabs(state->gravity[a]) / bed->gravity * (high[a] - low[a]);
    }
    return fmax(height, bed->above);
}

double clod_setup_bed_impact(const clod_setup_bed *bed, const clod_state *state)
{
    double wall_speed = 0.0;
    for (int32_t w = 0; w < state->walls.count; w++) {
        wall_speed = fmax(wall_speed, clod_wall_speed_bound(&state->walls.wall[w]));
    }
    return bed->speed + sqrt(2.0 * bed->gravity * fall_height(bed, state)) + wall_speed;
}

double clod_setup_impact_speed(const clod_state *state)
{
    const clod_setup_bed bed = clod_setup_bed_of(state);
    return clod_setup_bed_impact(&bed, state);
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
