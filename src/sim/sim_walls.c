// Walls of a simulation driven by its owner.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "setup/bound.h"
#include "sim/sim.h"

int32_t clod_sim_wall_count(const clod_sim *self)
{
    CLOD_NEED(self);
    return self->state.walls.count;
}

int32_t clod_sim_wall_index(const clod_sim *self, const char *name)
{
    CLOD_NEED(self);
    CLOD_NEED(name);
    return clod_walls_find(&self->state.walls, name);
}

bool clod_sim_has_wall(const clod_sim *self, int32_t wall, const char *function,
                       clod_status *status)
{
    return clod_given(self != NULL, function, "self", status) &&
           ((wall >= 0 && wall < self->state.walls.count) ||
            clod_status_fail(status, CLOD_USAGE, "%s: there is no wall %d; there are %d",
                             function, (int)wall, (int)self->state.walls.count));
}

bool clod_sim_has_shape(const clod_sim *self, int32_t wall, int32_t shape, const char *function,
                        clod_status *status)
{
    if (!clod_sim_has_wall(self, wall, function, status)) {
        return false;
    }
    const clod_wall *it = &self->state.walls.wall[wall];
    return (shape >= 0 && shape < it->shape_count) ||
           clod_status_fail(status, CLOD_USAGE, "%s: the wall '%s' has no shape %d; it has %d",
                            function, it->name, (int)shape, (int)it->shape_count);
}

bool clod_sim_wall_look(const clod_sim *self, int32_t wall, clod_sim_wall *view,
                        clod_status *status)
{
    if (!clod_sim_has_wall(self, wall, __func__, status) || !CLOD_GIVEN(view, status)) {
        return false;
    }
    const clod_wall *from = &self->state.walls.wall[wall];
    const double share = from->sum_steps > 0 ? 1.0 / (double)from->sum_steps : 0.0;
    *view = (clod_sim_wall){.name = from->name,
                            .angle = from->angle,
                            .spin = from->spin,
                            .material_spin = clod_wall_spin(from),
                            .power = from->power,
                            .mean_power = share * from->sum_power,
                            .mean_steps = from->sum_steps,
                            .loaded = from->load != CLOD_LOAD_NONE,
                            .load = from->load != CLOD_LOAD_NONE ? from->load_force : 0.0};
    const clod_quat turned = clod_quat_about(from->spin_axis, from->angle);
    const clod_quat q = clod_quat_product(turned, clod_wall_orientation(from));
    memcpy(view->orientation, (double[4]){q.w, q.x, q.y, q.z}, sizeof view->orientation);
    clod_vec3_put(view->position, from->shift);
    clod_vec3_put(view->velocity, from->velocity);
    clod_vec3_put(view->surface_velocity, from->surface_velocity);
    clod_vec3_put(view->angular_velocity, clod_vec3_scale(from->spin_axis, from->spin));
    clod_vec3_put(view->material_velocity,
                  clod_vec3_add(clod_wall_velocity(from), from->surface_velocity));
    clod_vec3_put(view->force, from->force);
    clod_vec3_put(view->torque, from->torque);
    clod_vec3_put(view->mean_force, clod_vec3_scale(from->sum_force, share));
    clod_vec3_put(view->mean_torque, clod_vec3_scale(from->sum_torque, share));
    return true;
}

bool clod_sim_set_wall_velocity(clod_sim *self, int32_t wall, const double velocity[3],
                                clod_status *status)
{
    if (!clod_sim_has_wall(self, wall, __func__, status) || !CLOD_GIVEN(velocity, status) ||
        !clod_sim_finite(velocity, __func__, "velocity", status)) {
        return false;
    }
    self->state.walls.wall[wall].velocity = clod_vec3_of(velocity);
    return true;
}

bool clod_sim_set_wall_surface_velocity(clod_sim *self, int32_t wall, const double velocity[3],
                                        clod_status *status)
{
    if (!clod_sim_has_wall(self, wall, __func__, status) || !CLOD_GIVEN(velocity, status) ||
        !clod_sim_finite(velocity, __func__, "velocity", status)) {
        return false;
    }
    self->state.walls.wall[wall].surface_velocity = clod_vec3_of(velocity);
    return true;
}

/** Whether a wall has an endless plane that would turn out of itself; then it is an error. */
static bool would_tilt(const clod_wall *wall, const char *function, clod_status *status)
{
    return clod_wall_plane_across(wall) >= 0 &&
           !clod_status_fail(
               status, CLOD_USAGE,
               "%s: the wall '%s' has a plane that would turn out of itself; only "
               "planes across the spin axis can turn",
               function, wall->name);
}

bool clod_sim_set_wall_spin(clod_sim *self, int32_t wall, double spin, clod_status *status)
{
    if (!clod_sim_has_wall(self, wall, __func__, status)) {
        return false;
    }
    clod_wall *to = &self->state.walls.wall[wall];
    if (!isfinite(spin)) {
        return clod_status_fail(status, CLOD_USAGE, "%s: spin is %g; give a finite number",
                                __func__, spin);
    }
    if (spin != 0.0 && would_tilt(to, __func__, status)) {
        return false;
    }
    to->spin = spin;
    return true;
}

/** A wall that can be put at another pose: one that oscillates has its pose from that. */
static bool has_free_wall(const clod_sim *self, int32_t wall, const char *function,
                          clod_status *status)
{
    if (!clod_sim_has_wall(self, wall, function, status)) {
        return false;
    }
    const clod_wall *it = &self->state.walls.wall[wall];
    return it->oscillation.frequency == 0.0 ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: the wall '%s' oscillates, which gives its pose", function,
                            it->name);
}

bool clod_sim_set_wall_orientation(clod_sim *self, int32_t wall, const double orientation[4],
                                   clod_status *status)
{
    if (!has_free_wall(self, wall, __func__, status) || !CLOD_GIVEN(orientation, status)) {
        return false;
    }
    double square = 0.0;
    for (int k = 0; k < 4; k++) {
        square += orientation[k] * orientation[k];
    }
    if (!(square > 0.0 && isfinite(square))) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: orientation is %g, %g, %g, %g; give a quaternion w, x, y, z "
            "with finite numbers that are not all 0",
            __func__, orientation[0], orientation[1], orientation[2], orientation[3]);
    }
    double before;
    if (!clod_sim_balance(self, &before, status)) {
        return false;
    }
    clod_wall_set_orientation(
        &self->state.walls.wall[wall],
        (clod_quat){orientation[0], orientation[1], orientation[2], orientation[3]});
    clod_sim_moved(self, before);
    return true;
}

bool clod_sim_set_wall_angular_velocity(clod_sim *self, int32_t wall, const double velocity[3],
                                        const double point[3], clod_status *status)
{
    if (!has_free_wall(self, wall, __func__, status) || !CLOD_GIVEN(velocity, status) ||
        !CLOD_GIVEN(point, status) ||
        !clod_sim_finite(velocity, __func__, "velocity", status) ||
        !clod_sim_finite(point, __func__, "point", status)) {
        return false;
    }
    clod_wall *to = &self->state.walls.wall[wall];
    const clod_vec3 omega = {velocity[0], velocity[1], velocity[2]};
    const double spin = clod_vec3_length(omega);
    if (spin == 0.0) {
        to->spin = 0.0;
        return true;
    }
    const clod_vec3 axis = clod_vec3_scale(omega, 1.0 / spin), is = to->spin_axis;
    const clod_vec3 at = clod_vec3_add(to->spin_point, to->shift);
    const bool same = axis.x == is.x && axis.y == is.y && axis.z == is.z && at.x == point[0] &&
                      at.y == point[1] && at.z == point[2];
    if (!same) {
        double energy;
        const clod_wall before = *to;
        if (!clod_sim_balance(self, &energy, status)) {
            return false;
        }
        clod_wall_set_spin_axis(to, axis, clod_vec3_of(point));
        if (would_tilt(to, __func__, status)) {
            *to = before;
            clod_wall_find_symmetry(to);
            return false;
        }
        clod_sim_moved(self, energy);
    }
    to->spin = spin;
    return true;
}

/** The state has all grains, as the caller has written them. */
static bool see_all(clod_sim *self, clod_status *status)
{
    clod_sim_fetch(self);
    return clod_step_see(&self->step, status);
}

bool clod_sim_set_wall_load(clod_sim *self, int32_t wall, double force, clod_status *status)
{
    if (!clod_sim_has_wall(self, wall, __func__, status)) {
        return false;
    }
    clod_wall *to = &self->state.walls.wall[wall];
    if (to->load == CLOD_LOAD_NONE) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: the wall '%s' has no load; one that comes with a load also "
            "has its mass and damping",
            __func__, to->name);
    }
    if (!(force >= 0.0 && isfinite(force))) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: the load of '%s' is %g N; give a finite number, 0 or above", __func__,
            to->name, force);
    }
    const double before = to->load_force;
    char what[128];
    snprintf(what, sizeof what, "a load of %g N on '%s'", force, to->name);
    to->load_force = force;
    if (force > before && !(see_all(self, status) &&
                            clod_setup_bound_fits(self->from, &self->state, what, status))) {
        to->load_force = before;
        return false;
    }
    return true;
}

bool clod_sim_set_wall_position(clod_sim *self, int32_t wall, const double position[3],
                                clod_status *status)
{
    if (!has_free_wall(self, wall, __func__, status) || !CLOD_GIVEN(position, status) ||
        !clod_sim_finite(position, __func__, "position", status)) {
        return false;
    }
    double before;
    if (!clod_sim_balance(self, &before, status)) {
        return false;
    }
    self->state.walls.wall[wall].shift = clod_vec3_of(position);
    clod_sim_moved(self, before);
    return true;
}

void clod_sim_reset_wall_means(clod_sim *self)
{
    CLOD_NEED(self);
    clod_sim_sums_end(self);
    clod_walls_reset_sums(&self->state.walls);
}
