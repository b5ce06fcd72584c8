// The contacts of a step as a source for those who write or measure them.
#include "step/near_reader.h"
#include "step/step.h"

static size_t next_of_blocks(void *context, clod_contact *to, size_t room)
{
    clod_step_reader *self = context;
    return clod_near_reader_next(&self->blocks, to, room);
}

/** Count them on a first way along the blocks. */
static void begin_blocks(void *context, size_t *pairs, size_t *walls)
{
    clod_step_reader *self = context;
    clod_near *near = &self->step->near;
    *pairs = *walls = 0;
    for (int p = 0; p < near->parts; p++) {
        clod_near_gather_count(near, p);
        *pairs += near->gathered[p].pairs;
        *walls += near->gathered[p].walls;
    }
    self->blocks = clod_near_reader_begin(near, &self->step->walls);
}

clod_contact_source clod_step_contacts(clod_step *self, clod_step_reader *reader)
{
    *reader = (clod_step_reader){.step = self};
    if (!self->near.made) { // then the state has them
        return clod_contact_source_of(&reader->list, self->state);
    }
    return (clod_contact_source){
        .context = reader, .begin = begin_blocks, .next = next_of_blocks};
}
