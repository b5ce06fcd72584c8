#include "tester/bed.h"

#include <math.h>

#include "parallel/exact.h"
#include "tester/limits.h"

#define FILL_LEAST 0.05    ///< s of filling at least
#define SETTLED_SPEED 0.02 ///< m/s, root mean square of the grains at the end of filling
#define RAMP_TIME 0.02     ///< s over which the load is raised or lowered
#define CALM_SPEED 5e-4    ///< m/s of the lid, mean over a sample: nothing moves any more
#define CALM_SAMPLES 5     ///< in a row
#define CALM_FORCE 0.02    ///< relative error of the normal stress when calm

clod_wall *clod_bed_wall(const clod_state *state, const char *name)
{
    const int32_t w = clod_walls_find(&state->walls, name);
    return w >= 0 ? &state->walls.wall[w] : NULL;
}

double clod_bed_mass(const clod_state *state)
{
    clod_exact mass = {0};
    for (size_t g = 0; g < state->grains.count; g++) {
        clod_exact_add(&mass, state->grains.velocity[g][3]);
    }
    return clod_exact_value(&mass);
}

double clod_bed_largest(const clod_state *state)
{
    double largest = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        largest = fmax(largest, state->grains.position[g][3]);
    }
    return largest;
}

double clod_bed_bars_volume(const clod_state *state)
{
    double volume = 0.0;
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const clod_shape *shape = &wall->shapes[s];
            const double *half = shape->half;
            volume += clod_shape_kinds_row(shape->kind)->solid
                          ? 8.0 * half[0] * half[1] * half[2]
                          : 0.0;
        }
    }
    return volume;
}

double clod_bed_rms_speed(const clod_state *state)
{
    clod_exact sum = {0};
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *v = state->grains.velocity[g];
        clod_exact_add(&sum, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    return sqrt(clod_exact_value(&sum) / (double)state->grains.count);
}

double clod_bed_top(const clod_state *state)
{
    double top = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        top = fmax(top, state->grains.position[g][2] + state->grains.position[g][3]);
    }
    return top;
}

double clod_bed_fall_time(const clod_state *state, double speed)
{
    const double *g = state->gravity;
    return speed / sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
}

bool clod_bed_is_filled(const clod_state *state, double in_phase, double most, bool *late)
{
    const double least = fmax(FILL_LEAST, 2.0 * clod_bed_fall_time(state, SETTLED_SPEED));
    *late = in_phase > most;
    return *late || (in_phase > least && clod_bed_rms_speed(state) < SETTLED_SPEED);
}

void clod_bed_put_lid(clod_state *state, double height, double bars)
{
    clod_wall *lid = clod_bed_wall(state, "lid");
    lid->shift.z += fmin(clod_bed_top(state) + bars - height, 0.0);
    lid->velocity.z = -CLOD_LIMITS_LOWER_SPEED;
    state->build_motion = INFINITY;
}

void clod_bed_take_over(clod_wall *lid)
{
    lid->load = CLOD_LOAD_STRESS;
    lid->servo_velocity = CLOD_LIMITS_LOWER_SPEED;
    lid->velocity.z = 0.0;
}

double clod_bed_ramp(double in_phase)
{
    return fmin(in_phase / RAMP_TIME, 1.0);
}

bool clod_bed_is_calm(int64_t *calm, double speed, double stress)
{
    const bool rests = fabs(speed) < CALM_SPEED && fabs(stress - 1.0) < CALM_FORCE;
    *calm = rests ? *calm + 1 : 0;
    return *calm >= CALM_SAMPLES;
}
