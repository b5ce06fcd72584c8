// Grains and walls of a simulation that come and go.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "config/wall_text.h"
#include "setup/walls.h"
#include "sim/sim.h"

bool clod_sim_change(clod_sim *self, clod_status *status)
{
    return CLOD_GIVEN(self, status) && clod_step_change(&self->step, status);
}

/** Whether a request is in the queue now; else it is forgotten, and the others stay. */
static bool is_queued(clod_sim *self, const char *function, clod_status *status)
{
    const bool lacks_memory = self->state.changes.lacks_memory;
    self->state.changes.lacks_memory = false;
    return !lacks_memory || clod_status_fail(status, CLOD_FAILED,
                                             "%s: no memory for the request; those of before "
                                             "stay",
                                             function);
}

/** Bound of the time step with what there is and what was asked for by now. */
static bool know_bound(clod_sim *self, clod_status *status)
{
    const clod_changes *queue = &self->state.changes;
    if (self->bound.sizes != NULL && queue->new_grains + queue->new_walls > 0) {
        return true;
    }
    clod_setup_bound_fini(&self->bound); // of requests that were done or dropped since
    return clod_setup_bound_init(&self->bound, self->from, &self->state, status);
}

bool clod_sim_step_is_stable(const clod_sim *self, const char *function, const char *what,
                             clod_status *status)
{
    const clod_timestep t = clod_setup_bound_timestep(&self->bound, self->from);
    return !(t.limit > 0.0) || self->state.dt <= t.limit ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: with %s the time step of %.4g s is beyond the critical one, "
               "%.4g s under %.4g N between %s and %s: the run would blow up. Give "
               "time.step in the case, %.4g s or less",
               function, what, self->state.dt, t.limit, t.limit_force, t.limit_a, t.limit_b,
               t.automatic);
}

/** Whether the case has a law for grains of a material with `partners` of another. */
static bool has_law(const clod_sim *self, int grains, int other, const char *partners,
                    const char *function, clod_status *status)
{
    const char *a = self->from->materials[grains].name;
    const char *b = self->from->materials[other].name;
    return clod_case_pair(self->from, other, grains)->exponent > 0.0 ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: the case has no contact law for grains of '%s' with %s of "
                            "'%s'; add the section %s-%s to its contacts",
                            function, a, partners, b, a, b);
}

/** A grain of this material has a law for all that it can meet. */
static bool grain_has_laws(const clod_sim *self, int material, const char *function,
                           clod_status *status)
{
    for (int m = 0; m < (int)self->from->material_count; m++) {
        const bool grains = m == material || self->bound.sizes[m].count > 0.0;
        if ((grains && !has_law(self, material, m, "grains", function, status)) ||
            (self->bound.is_wall[m] &&
             !has_law(self, material, m, "a wall", function, status))) {
            return false;
        }
    }
    return true;
}

static bool grain_fits_step(clod_sim *self, const clod_sim_grain *grain, const char *function,
                            clod_status *status)
{
    if (!(grain->radius > 0.0 && isfinite(grain->radius))) {
        return true; // clod_step_change says what is wrong with it
    }
    clod_timestep_sizes *sizes = &self->bound.sizes[grain->material];
    const clod_timestep_sizes before = *sizes;
    char what[32];
    snprintf(what, sizeof what, "grain %llu", (unsigned long long)grain->id);
    clod_timestep_add(sizes, 1.0, grain->radius);
    const bool stable = clod_sim_step_is_stable(self, function, what, status);
    if (!stable) {
        *sizes = before;
    }
    return stable;
}

static bool wall_fits_step(clod_sim *self, const clod_wall *wall, const char *function,
                           clod_status *status)
{
    bool stable = true;
    for (int32_t s = 0; stable && s < wall->shape_count; s++) {
        bool *is_wall = &self->bound.is_wall[clod_wall_material(wall, s)];
        const bool before = *is_wall;
        char what[48];
        snprintf(what, sizeof what, "wall '%s'", wall->name);
        *is_wall = true;
        stable = before || clod_sim_step_is_stable(self, function, what, status);
        *is_wall = stable;
    }
    return stable;
}

bool clod_sim_add_grain(clod_sim *self, const clod_sim_grain *grain, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(grain, status)) {
        return false;
    }
    if (grain->material >= self->from->material_count) {
        return clod_status_fail(
            status, CLOD_USAGE, "%s: material %zu of grain %llu; the case has %zu", __func__,
            grain->material, (unsigned long long)grain->id, self->from->material_count);
    }
    clod_new_grain fresh = {.id = grain->id,
                            .density = self->from->materials[grain->material].density,
                            .material = (uint16_t)grain->material};
    memcpy(fresh.position, grain->position, sizeof grain->position);
    fresh.position[3] = grain->radius;
    memcpy(fresh.velocity, grain->velocity, sizeof fresh.velocity);
    memcpy(fresh.angular_velocity, grain->angular_velocity, sizeof fresh.angular_velocity);
    if (!know_bound(self, status) ||
        !grain_has_laws(self, (int)grain->material, __func__, status) ||
        !grain_fits_step(self, grain, __func__, status)) {
        return false;
    }
    clod_changes_add_grain(&self->state.changes, &fresh);
    return is_queued(self, __func__, status);
}

bool clod_sim_remove_grain(clod_sim *self, uint64_t id, clod_status *status)
{
    if (!CLOD_GIVEN(self, status)) {
        return false;
    }
    clod_changes_remove_grain(&self->state.changes, id);
    return is_queued(self, __func__, status);
}

/** A material of a wall: the case has it, with a law for the grains that there are. */
static bool has_laws(const clod_sim *self, const char *name, const char *function,
                     clod_status *status)
{
    const int material = name != NULL ? clod_case_material_index(self->from, name) : -1;
    if (material < 0) {
        return clod_status_fail(status, CLOD_USAGE, "%s: the case has no material '%s'",
                                function, name != NULL ? name : "");
    }
    for (int m = 0; m < (int)self->from->material_count; m++) {
        if (self->bound.sizes[m].count > 0.0 &&
            !has_law(self, m, material, "a wall", function, status)) {
            return false;
        }
    }
    return true;
}

/** The materials of a wall and of its shapes. */
static bool has_materials(const clod_sim *self, const clod_case_wall *wall,
                          const char *function, clod_status *status)
{
    bool good = has_laws(self, wall->material, function, status);
    for (size_t s = 0; good && s < wall->shape_count; s++) {
        const clod_case_shape *shape = &wall->shapes[s];
        const char *own = shape->surface.material;
        good = own == NULL || has_laws(self, own, function, status);
        own = shape->belt.skirts.material;
        good = good && (own == NULL || has_laws(self, own, function, status));
        for (size_t p = 0; good && p < shape->part_count; p++) {
            own = shape->parts[p].material;
            good = own == NULL || has_laws(self, own, function, status);
        }
    }
    return good;
}

bool clod_sim_add_wall(clod_sim *self, const clod_case_wall *wall, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(wall, status) ||
        !CLOD_GIVEN(wall->name, status) || !CLOD_GIVEN(wall->shapes, status) ||
        !know_bound(self, status) || !has_materials(self, wall, __func__, status)) {
        return false;
    }
    if (wall->load != CLOD_LOAD_NONE || wall->oscillation.frequency != 0.0) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: '%s' has a load or oscillates; such a wall must be part of "
            "the case",
            __func__, wall->name);
    }
    clod_case_wall given = *wall;
    const double *axis = given.spin_axis;
    if (axis[0] == 0.0 && axis[1] == 0.0 && axis[2] == 0.0) {
        given.spin_axis[2] = 1.0; // as in a case that does not say
    }
    clod_wall made = {0};
    bool good = clod_setup_wall(self->from, &given, &made, status) &&
                wall_fits_step(self, &made, __func__, status);
    if (good) {
        clod_changes_add_wall(&self->state.changes, &made);
        good = is_queued(self, __func__, status);
    }
    clod_wall_fini(&made);
    return good;
}

bool clod_sim_add_wall_from_text(clod_sim *self, const char *name, const char *text,
                                 clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(name, status) || !CLOD_GIVEN(text, status)) {
        return false;
    }
    pthread_mutex_lock(&clod_sim_case_lock);
    clod_case_wall *wall = clod_wall_text_read(self->from, name, text, status);
    pthread_mutex_unlock(&clod_sim_case_lock);
    const bool good = wall != NULL && clod_sim_add_wall(self, wall, status);
    clod_wall_text_destroy(&wall);
    return good;
}

bool clod_sim_remove_wall(clod_sim *self, const char *name, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(name, status)) {
        return false;
    }
    if (strlen(name) >= sizeof self->state.walls.wall->name) {
        return clod_status_fail(status, CLOD_USAGE,
                                "wall '%s' cannot be removed: there is none of this name",
                                name);
    }
    clod_changes_remove_wall(&self->state.changes, name);
    return is_queued(self, __func__, status);
}
