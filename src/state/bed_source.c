#include "state/bed_source.h"

#include <string.h>

#include "base/memory.h"
#include "state/contact_walk.h"

/** Contacts of each grain with grains and walls; false without memory. */
static bool count_each(clod_bed_view *self)
{
    const clod_contact *contact;
    clod_contact_walk walk;
    self->each = clod_memory_alloc(self->state->grains.count + 1, sizeof *self->each);
    if (self->each == NULL) {
        return false;
    }
    clod_contact_walk_begin(&walk, &self->contacts);
    while ((contact = clod_contact_walk_next(&walk)) != NULL) {
        self->each[contact->i]++;
        if (contact->shape < 0) {
            self->each[contact->j]++;
        }
    }
    return true;
}

static bool begin(void *context, clod_bed_wants wants, clod_bed_counts *all,
                  clod_status *status)
{
    clod_bed_view *self = context;
    all->grains = self->state->grains.count;
    if (wants.each && !count_each(self)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the contacts of %zu grains",
                                all->grains);
    }
    self->contacts.begin(self->contacts.context, &all->pairs, &all->walls);
    self->pairs = all->pairs;
    return true;
}

static bool get_grains(void *context, size_t first, size_t count, clod_bed_slab *slab,
                       clod_status *status)
{
    (void)status;
    clod_bed_view *self = context;
    const clod_state *state = self->state;
    self->rows = *state;
    self->rows.grains = clod_grains_view(&state->grains, first, count);
    if (state->build_position != NULL) {
        self->rows.build_position = state->build_position + first;
    }
    *slab = (clod_bed_slab){&self->rows, self->each != NULL ? self->each + first : NULL};
    return true;
}

clod_bed_line clod_bed_line_of(const clod_state *state, const clod_contact_source *from,
                               const clod_contact *contact)
{
    clod_bed_line line = {.pull_off = 0.0};
    memcpy(line.place[0], state->grains.position[contact->i], sizeof line.place[0]);
    memcpy(line.place[1], state->grains.position[contact->j], sizeof line.place[1]);
    if (from->strength != NULL) {
        line.pull_off = from->strength(from->laws, contact).pull_off;
    }
    return line;
}

static bool get_contacts(void *context, size_t *count, clod_contact *to,
                         uint64_t (*partners)[2], clod_bed_line *lines, clod_status *status)
{
    (void)status;
    clod_bed_view *self = context;
    const uint64_t *id = self->state->grains.id;
    *count = self->contacts.next(self->contacts.context, to, *count);
    for (size_t c = 0; c < *count; c++) {
        const bool pair = c < self->pairs;
        partners[c][0] = id[to[c].i];
        partners[c][1] = pair ? id[to[c].j] : (uint64_t)to[c].j;
        if (pair && lines != NULL) {
            lines[c] = clod_bed_line_of(self->state, &self->contacts, &to[c]);
        }
    }
    self->pairs -= *count < self->pairs ? *count : self->pairs;
    return true;
}

static void end(void *context)
{
    clod_bed_view *self = context;
    clod_memory_free(self->each);
    self->each = NULL;
}

clod_bed_source clod_bed_source_of(clod_bed_view *self, const clod_state *state,
                                   const clod_contact_source *contacts)
{
    *self = (clod_bed_view){.state = state};
    self->contacts = contacts != NULL ? *contacts : clod_contact_source_of(&self->list, state);
    return (clod_bed_source){.context = self,
                             .begin = begin,
                             .grains = get_grains,
                             .contacts = get_contacts,
                             .end = end};
}
