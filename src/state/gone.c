#include "state/gone.h"

#include "base/memory.h"
#include "base/room.h"

void clod_gone_add(clod_gone *self, const clod_gone_grain *grain)
{
    if (!self->kept) {
        return;
    }
    if (!clod_room_for_one(&self->rows, &self->room, self->count, sizeof *self->rows)) {
        self->lacks_memory = true;
        return;
    }
    self->rows[self->count++] = *grain;
}

void clod_gone_fini(clod_gone *self)
{
    clod_memory_free(self->rows);
    *self = (clod_gone){0};
}
