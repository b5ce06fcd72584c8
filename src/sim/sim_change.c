// Grains and walls of a simulation that come and go.
#include <string.h>

#include "base/memory.h"
#include "setup/walls.h"
#include "sim/sim.h"

bool clod_sim_change(clod_sim *self, clod_status *status)
{
    return CLOD_SIM_GIVEN(self, status) && clod_step_change(&self->step, status);
}

bool clod_sim_add_grain(clod_sim *self, const clod_sim_grain *grain, clod_status *status)
{
    if (!CLOD_SIM_GIVEN(self, status) || !CLOD_SIM_GIVEN(grain, status)) {
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
    clod_changes_add_grain(&self->state.changes, &fresh);
    return true;
}

bool clod_sim_remove_grain(clod_sim *self, uint64_t id, clod_status *status)
{
    if (!CLOD_SIM_GIVEN(self, status)) {
        return false;
    }
    clod_changes_remove_grain(&self->state.changes, id);
    return true;
}

bool clod_sim_add_wall(clod_sim *self, const clod_case_wall *wall, clod_status *status)
{
    if (!CLOD_SIM_GIVEN(self, status) || !CLOD_SIM_GIVEN(wall, status) ||
        !clod_sim_given(wall->name, __func__, "wall->name", status) ||
        !clod_sim_given(wall->shapes, __func__, "wall->shapes", status)) {
        return false;
    }
    if (wall->material == NULL || clod_case_material_index(self->from, wall->material) < 0) {
        return clod_status_fail(status, CLOD_USAGE, "%s: the case has no material '%s'",
                                __func__, wall->material != NULL ? wall->material : "");
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
    const bool good = clod_setup_wall(self->from, &given, &made, status);
    if (good) {
        clod_changes_add_wall(&self->state.changes, &made);
    }
    clod_memory_free(made.shapes);
    return good;
}

bool clod_sim_remove_wall(clod_sim *self, const char *name, clod_status *status)
{
    if (!CLOD_SIM_GIVEN(self, status) || !CLOD_SIM_GIVEN(name, status)) {
        return false;
    }
    clod_changes_remove_wall(&self->state.changes, name);
    return true;
}
