#include "state/changes.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"

bool clod_new_grain_join(const clod_new_grain *self, clod_grains *to, clod_status *status)
{
    return clod_grains_add(to, self->position, self->velocity, self->angular_velocity,
                           self->density, self->material, self->id, status);
}

void clod_changes_add_grain(clod_changes *self, const clod_new_grain *grain)
{
    if (!clod_room_for_one(&self->new_grain, &self->new_grain_room, self->new_grains,
                           sizeof *self->new_grain)) {
        self->lacks_memory = true;
        return;
    }
    self->new_grain[self->new_grains++] = *grain;
}

void clod_changes_remove_grain(clod_changes *self, uint64_t id)
{
    if (!clod_room_for_one(&self->lost_grain, &self->lost_grain_room, self->lost_grains,
                           sizeof *self->lost_grain)) {
        self->lacks_memory = true;
        return;
    }
    self->lost_grain[self->lost_grains++] = id;
}

void clod_changes_add_wall(clod_changes *self, clod_wall *wall)
{
    if (!clod_room_for_one(&self->new_wall, &self->new_wall_room, self->new_walls,
                           sizeof *self->new_wall)) {
        self->lacks_memory = true;
        return;
    }
    self->new_wall[self->new_walls++] = *wall;
    clod_wall_give(wall);
}

void clod_changes_remove_wall(clod_changes *self, const char *name)
{
    if (!clod_room_for_one(&self->lost_wall, &self->lost_wall_room, self->lost_walls,
                           sizeof *self->lost_wall)) {
        self->lacks_memory = true;
        return;
    }
    snprintf(self->lost_wall[self->lost_walls++], sizeof *self->lost_wall, "%s", name);
}

void clod_changes_fini(clod_changes *self)
{
    for (size_t w = 0; w < self->new_walls; w++) {
        clod_wall_fini(&self->new_wall[w]);
    }
    clod_memory_free(self->new_grain);
    clod_memory_free(self->lost_grain);
    clod_memory_free(self->new_wall);
    clod_memory_free(self->lost_wall);
    *self = (clod_changes){0};
}
