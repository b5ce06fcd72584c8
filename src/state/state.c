#include "state/state.h"

#include <string.h>

#include "base/memory.h"

/** Copy `count` items, or leave NULL when there are none; false without memory. */
static bool copy_items(void *to, const void *from, size_t count, size_t size)
{
    void *items = NULL;
    if (from != NULL && count != 0) {
        items = clod_memory_alloc(count, size);
        if (items == NULL) {
            return false;
        }
        memcpy(items, from, count * size);
    }
    memcpy(to, &items, sizeof items);
    return true;
}

bool clod_state_copy(clod_state *self, const clod_state *from, clod_status *status)
{
    *self = *from;
    self->grains = (clod_grains){0};
    self->walls = (clod_walls){0};
    self->build_position = NULL;
    self->build_walls = NULL;
    self->contacts = NULL;
    self->changes = (clod_changes){0};
    self->gone = (clod_gone){0};
    self->contact_capacity = from->contact_count;
    if (!clod_grains_copy(&self->grains, &from->grains, status) ||
        !clod_walls_copy(&self->walls, &from->walls, status)) {
        return false;
    }
    if (from->build_position != NULL) {
        if (!clod_state_reserve_build(self)) {
            return clod_status_fail(status, CLOD_FAILED, "no memory to copy the state");
        }
        memcpy(self->build_position, from->build_position,
               from->grains.count * sizeof *self->build_position);
    }
    if (!copy_items(&self->build_walls, from->build_walls, (size_t)from->walls.count,
                    sizeof *self->build_walls) ||
        !copy_items(&self->contacts, from->contacts, from->contact_count,
                    sizeof *self->contacts)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory to copy the state");
    }
    return true;
}

bool clod_state_reserve_build(clod_state *self)
{
    clod_memory_free(self->build_position);
    self->build_position =
        clod_memory_alloc(self->grains.capacity, sizeof *self->build_position);
    self->build_capacity = self->build_position != NULL ? self->grains.capacity : 0;
    return self->build_position != NULL;
}

void clod_state_fini(clod_state *self)
{
    clod_grains_fini(&self->grains);
    clod_walls_fini(&self->walls);
    clod_memory_free(self->build_position);
    clod_memory_free(self->build_walls);
    clod_memory_free(self->contacts);
    clod_changes_fini(&self->changes);
    clod_gone_fini(&self->gone);
    *self = (clod_state){0};
}
