// Grains and walls of a simulation that come and go.
#include <string.h>

#include "base/memory.h"
#include "config/wall_text.h"
#include "setup/walls.h"
#include "sim/sim.h"
#include "sim/wall_given.h"

bool clod_sim_change(clod_sim *self, clod_status *status)
{
    return CLOD_GIVEN(self, status) && clod_sim_settle(self, status);
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

/** A material of a wall, which the case must have. */
static bool has_material(const clod_sim *self, const char *name, const char *function,
                         clod_status *status)
{
    return (name != NULL && clod_case_material_index(self->from, name) >= 0) ||
           clod_status_fail(status, CLOD_USAGE, "%s: the case has no material '%s'", function,
                            name != NULL ? name : "");
}

/** The materials of a wall and of its shapes. */
static bool has_materials(const clod_sim *self, const clod_case_wall *wall,
                          const char *function, clod_status *status)
{
    bool good = has_material(self, wall->material, function, status);
    for (size_t s = 0; good && s < wall->shape_count; s++) {
        const clod_case_shape *shape = &wall->shapes[s];
        const char *own = shape->surface.material;
        good = own == NULL || has_material(self, own, function, status);
        own = shape->belt.skirts.material;
        good = good && (own == NULL || has_material(self, own, function, status));
        for (size_t p = 0; good && p < shape->part_count; p++) {
            own = shape->parts[p].material;
            good = own == NULL || has_material(self, own, function, status);
        }
    }
    return good;
}

/** A stress needs an area, which may be that of discs. */
static bool has_area(const clod_wall *wall, const char *function, clod_status *status)
{
    return wall->load != CLOD_LOAD_STRESS || wall->area > 0.0 ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: '%s' has a stress as its load, which needs an area; give one "
                            "in m2",
                            function, wall->name);
}

bool clod_sim_add_wall(clod_sim *self, const clod_case_wall *wall, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(wall, status) ||
        !CLOD_GIVEN(wall->name, status) || !CLOD_GIVEN(wall->shapes, status) ||
        !has_materials(self, wall, __func__, status)) {
        return false;
    }
    if (!clod_sim_wall_is_free(self, wall->name, __func__, status)) {
        return false;
    }
    const clod_case_wall given = clod_wall_given_directions(wall);
    clod_wall made = {0};
    bool good = clod_wall_given_holds(&given, __func__, status) &&
                clod_setup_wall(self->from, &given, &made, status) &&
                clod_setup_wall_pace(&(clod_walls){1, &made}, self->state.dt, status) &&
                has_area(&made, __func__, status);
    if (good) {
        clod_wall_join(&made, self->state.dt, self->state.step);
        clod_changes_add_wall(&self->state.changes, &made);
        self->row_is_old = true;
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
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(name, status) ||
        !clod_sim_wall_is_free(self, name, __func__, status)) {
        return false;
    }
    if (strlen(name) >= sizeof self->state.walls.wall->name) {
        return clod_status_fail(status, CLOD_USAGE,
                                "wall '%s' cannot be removed: there is none of this name",
                                name);
    }
    clod_changes_remove_wall(&self->state.changes, name);
    self->row_is_old = true;
    return is_queued(self, __func__, status);
}
