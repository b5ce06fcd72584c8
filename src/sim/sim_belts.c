// Belts of the shapes of a simulation's walls, driven by its owner.
#include <math.h>

#include "sim/sim.h"

static bool is_zero(const double v[3])
{
    return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
}

static clod_vec3 direction(const double v[3])
{
    return is_zero(v) ? clod_vec3_of(v) : clod_vec3_unit(clod_vec3_of(v));
}

/** Whether all numbers are finite, and what moves has a direction. */
static bool is_good(const clod_sim_belt *belt, const char *function, clod_status *status)
{
    if (!clod_sim_finite(belt->velocity, function, "velocity", status) ||
        !clod_sim_finite(belt->direction, function, "direction", status) ||
        !clod_sim_finite(belt->spin_axis, function, "spin_axis", status) ||
        !clod_sim_finite(belt->spin_point, function, "spin_point", status)) {
        return false;
    }
    if (!isfinite(belt->speed) || !isfinite(belt->spin)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: speed is %g and spin is %g; give finite numbers", function,
                                belt->speed, belt->spin);
    }
    if (belt->speed != 0.0 && is_zero(belt->direction)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: a speed of %g m/s has no direction; give one", function,
                                belt->speed);
    }
    return belt->spin == 0.0 || !is_zero(belt->spin_axis) ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: a spin of %g rad/s has no spin_axis; give one", function,
                            belt->spin);
}

bool clod_sim_set_belt(clod_sim *self, int32_t wall, int32_t shape, const clod_sim_belt *belt,
                       clod_status *status)
{
    if (!clod_sim_has_shape(self, wall, shape, __func__, status) || !CLOD_GIVEN(belt, status) ||
        !is_good(belt, __func__, status) || !clod_step_see(&self->step, status)) {
        return false;
    }
    self->state.walls.wall[wall].shapes[shape].belt =
        (clod_belt){.velocity = clod_vec3_of(belt->velocity),
                    .direction = direction(belt->direction),
                    .speed = belt->speed,
                    .spin = belt->spin,
                    .spin_axis = direction(belt->spin_axis),
                    .spin_point = clod_vec3_of(belt->spin_point)};
    clod_wall_rows_forget(&self->step.walls, wall);
    self->written |= clod_sim_is_spread(self); // ranks get shapes with the bed
    return true;
}

bool clod_sim_belt_look(const clod_sim *self, int32_t wall, int32_t shape, clod_sim_belt *belt,
                        clod_status *status)
{
    if (!clod_sim_has_shape(self, wall, shape, __func__, status) || !CLOD_GIVEN(belt, status)) {
        return false;
    }
    const clod_belt *from = &self->state.walls.wall[wall].shapes[shape].belt;
    *belt = (clod_sim_belt){.speed = from->speed, .spin = from->spin};
    clod_vec3_put(belt->velocity, from->velocity);
    clod_vec3_put(belt->direction, from->direction);
    clod_vec3_put(belt->spin_axis, from->spin_axis);
    clod_vec3_put(belt->spin_point, from->spin_point);
    return true;
}
