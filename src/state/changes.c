#include "state/changes.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"

/** Room for one more item of an array; its new address, or NULL. */
static void *room(void *array, size_t count, size_t *capacity, size_t size)
{
    if (count < *capacity) {
        return array;
    }
    const size_t more = 2 * *capacity + 8;
    void *grown = clod_memory_grow(array, *capacity, more, size);
    *capacity = grown != NULL ? more : *capacity;
    return grown;
}

void clod_changes_add_grain(clod_changes *self, const clod_new_grain *grain)
{
    void *grown =
        room(self->new_grain, self->new_grains, &self->new_grain_room, sizeof *self->new_grain);
    if (grown == NULL) {
        self->lacks_memory = true;
        return;
    }
    self->new_grain = grown;
    self->new_grain[self->new_grains++] = *grain;
}

void clod_changes_remove_grain(clod_changes *self, uint64_t id)
{
    void *grown = room(self->lost_grain, self->lost_grains, &self->lost_grain_room,
                       sizeof *self->lost_grain);
    if (grown == NULL) {
        self->lacks_memory = true;
        return;
    }
    self->lost_grain = grown;
    self->lost_grain[self->lost_grains++] = id;
}

void clod_changes_add_wall(clod_changes *self, clod_wall *wall)
{
    void *grown =
        room(self->new_wall, self->new_walls, &self->new_wall_room, sizeof *self->new_wall);
    if (grown == NULL) {
        self->lacks_memory = true;
        return;
    }
    self->new_wall = grown;
    self->new_wall[self->new_walls++] = *wall;
    wall->shapes = NULL;
    wall->shape_count = 0;
}

void clod_changes_remove_wall(clod_changes *self, const char *name)
{
    void *grown =
        room(self->lost_wall, self->lost_walls, &self->lost_wall_room, sizeof *self->lost_wall);
    if (grown == NULL) {
        self->lacks_memory = true;
        return;
    }
    self->lost_wall = grown;
    snprintf(self->lost_wall[self->lost_walls++], sizeof *self->lost_wall, "%s", name);
}

void clod_changes_fini(clod_changes *self)
{
    for (size_t w = 0; w < self->new_walls; w++) {
        clod_memory_free(self->new_wall[w].shapes);
    }
    clod_memory_free(self->new_grain);
    clod_memory_free(self->lost_grain);
    clod_memory_free(self->new_wall);
    clod_memory_free(self->lost_wall);
    *self = (clod_changes){0};
}
