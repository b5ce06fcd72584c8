#include "state/contact_source.h"

#include <string.h>

static void begin(void *context, size_t *pairs, size_t *walls)
{
    clod_contact_list *self = context;
    self->at = 0;
    *walls = self->state->wall_contact_count;
    *pairs = self->state->contact_count - *walls;
}

static size_t next(void *context, clod_contact *to, size_t room)
{
    clod_contact_list *self = context;
    const size_t left = self->state->contact_count - self->at;
    const size_t count = left < room ? left : room;
    if (count > 0) {
        memcpy(to, self->state->contacts + self->at, count * sizeof *to);
        self->at += count;
    }
    return count;
}

clod_contact_source clod_contact_source_of(clod_contact_list *self, const clod_state *state)
{
    *self = (clod_contact_list){.state = state};
    return (clod_contact_source){.context = self, .begin = begin, .next = next};
}
