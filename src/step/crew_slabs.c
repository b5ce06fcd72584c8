#include "step/crew_slabs.h"

#include <string.h>

#include "base/lower_bound.h"
#include "base/memory.h"
#include "parallel/ranks_collect.h"
#include "step/crew_part.h"
#include "step/records.h"

/** Whether a row is own; those before it are passed by. Rows that are asked for ascend. */
static bool find_own(clod_crew_slabs *self, int32_t row)
{
    while (self->at < self->own && self->row[self->at] < row) {
        self->at++;
    }
    return self->at < self->own && self->row[self->at] == row;
}

// ---- the beginning

/** Own rows, and room for what belongs to them; false without memory. */
static bool list_own(clod_crew *self, bool each)
{
    clod_crew_slabs *slabs = &self->slabs;
    for (size_t k = 0; k < self->spread.runs; k++) {
        slabs->own += self->spread.run[k].end - self->spread.run[k].begin;
    }
    slabs->row = clod_memory_alloc(slabs->own + 1, sizeof *slabs->row);
    slabs->number = clod_memory_alloc(slabs->own + 1, sizeof *slabs->number);
    slabs->begin = clod_memory_alloc((size_t)self->ranks->size + 1, sizeof *slabs->begin);
    slabs->each = each ? clod_memory_alloc(slabs->own + 1, sizeof *slabs->each) : NULL;
    size_t count = 0;
    for (size_t k = 0; slabs->row != NULL && k < self->spread.runs; k++) {
        const clod_chunk run = self->spread.run[k];
        for (size_t g = run.begin; g < run.end; g++) {
            slabs->row[count++] = (int32_t)g;
        }
    }
    return slabs->row != NULL && slabs->number != NULL && slabs->begin != NULL &&
           (slabs->each != NULL || !each);
}

/** Place of a row among the own ones; own: there is none. */
static size_t place_of(const clod_crew_slabs *self, int32_t row)
{
    clod_lower_bound in = {0, self->own};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        clod_lower_bound_halve(&in, self->row[middle] < row);
    }
    return in.low < self->own && self->row[in.low] == row ? in.low : self->own;
}

static void note_each(clod_crew_slabs *self, int32_t row)
{
    const size_t place = self->each != NULL ? place_of(self, row) : self->own;
    if (place < self->own) {
        self->each[place]++;
    }
}

/** Count own contacts, and those of each own grain. */
static void count_contacts(clod_crew *self, clod_bed_counts *all)
{
    clod_crew_slabs *slabs = &self->slabs;
    const clod_contact *contact;
    clod_contact_walk_begin(&slabs->walk, &slabs->contacts);
    while ((contact = clod_contact_walk_next(&slabs->walk)) != NULL) {
        const bool own = clod_spread_owns(&self->spread, contact->i);
        all->pairs += own && contact->shape < 0;
        all->walls += own && contact->shape >= 0;
        note_each(slabs, contact->i);
        if (contact->shape < 0) {
            note_each(slabs, contact->j);
        }
    }
}

static void add_counts(const void *context, void *into, const void *from)
{
    (void)context;
    clod_bed_counts *mine = into;
    const clod_bed_counts *other = from;
    mine->grains += other->grains;
    mine->pairs += other->pairs;
    mine->walls += other->walls;
}

bool clod_crew_slabs_begin(clod_crew *self, clod_bed_wants wants, clod_bed_counts *all,
                           clod_status *status)
{
    clod_crew_slabs *slabs = &self->slabs;
    if (!clod_crew_part_is_whole(self, status)) {
        return false;
    }
    clod_crew_slabs_end(self); // of one that came to no end
    clod_ranks_tell(self->ranks, &wants, sizeof wants);
    slabs->lines = wants.lines;
    const bool good =
        list_own(self, wants.each) ||
        clod_status_fail(status, CLOD_FAILED, "no memory to write %zu grains", slabs->own);
    if (!clod_ranks_agree(self->ranks, good, status) || !clod_crew_number(self, status)) {
        return false;
    }
    slabs->contacts = clod_step_contacts(&self->step, &slabs->reader);
    slabs->all = (clod_bed_counts){.grains = slabs->own};
    count_contacts(self, &slabs->all);
    clod_ranks_merge(self->ranks, &slabs->all, sizeof slabs->all, add_counts, NULL);
    clod_contact_walk_begin(&slabs->walk, &slabs->contacts);
    slabs->due = clod_contact_walk_next(&slabs->walk);
    *all = slabs->all;
    return true;
}

// ---- what is asked for

/** Number of the grain, its contacts if they are wanted, and all that belongs to it. */
static void pack_grains(clod_crew *self, const clod_crew_range *range, clod_bytes *out)
{
    clod_crew_slabs *slabs = &self->slabs;
    const size_t end = clod_crew_below(slabs->number, slabs->own, range->first + range->count);
    for (size_t k = clod_crew_below(slabs->number, slabs->own, range->first); k < end; k++) {
        clod_bytes *to = &out[(slabs->number[k] - range->first) / CLOD_CREW_SLAB];
        clod_bytes_put(to, &slabs->number[k], sizeof *slabs->number);
        if (slabs->each != NULL) {
            clod_bytes_put(to, &slabs->each[k], sizeof *slabs->each);
        }
        clod_records_put_grain(to, &self->state, (size_t)slabs->row[k]);
    }
}

/** The line of the contact that is due, if lines are wanted and it is one of grains. */
static void put_line(const clod_crew_slabs *self, const clod_state *state, clod_bytes *to)
{
    if (self->lines && self->due->shape < 0) {
        const clod_bed_line line = clod_bed_line_of(state, &self->contacts, self->due);
        clod_bytes_put(to, &line, sizeof line);
    }
}

/** Number of the first grain, the contact, and its line, of those that come next. */
static void pack_contacts(clod_crew *self, const clod_crew_range *range, clod_bytes *out)
{
    clod_crew_slabs *slabs = &self->slabs;
    const bool walls = range->what == 2;
    if (range->first == 0) {
        slabs->at = 0; // wall contacts begin with the first grain again
    }
    while (slabs->due != NULL && (slabs->due->shape >= 0) == walls) {
        if (find_own(slabs, slabs->due->i)) {
            const uint64_t number = slabs->number[slabs->at];
            if (number >= range->first + range->count) {
                break;
            }
            clod_bytes *to = &out[(number - range->first) / CLOD_CREW_SLAB];
            clod_bytes_put(to, &number, sizeof number);
            clod_records_put_contact(to, &self->state.grains, slabs->due);
            put_line(slabs, &self->state, to);
        }
        slabs->due = clod_contact_walk_next(&slabs->walk);
    }
}

void clod_crew_slabs_pack(clod_crew *self, const clod_crew_range *range, clod_bytes *out)
{
    if (range->what == 0) {
        pack_grains(self, range, out);
    } else {
        pack_contacts(self, range, out);
    }
}

bool clod_crew_slabs_bring(clod_crew *self, const clod_crew_range *range, clod_status *status)
{
    clod_crew_slabs *slabs = &self->slabs;
    clod_crew_range told = range != NULL ? *range : (clod_crew_range){0};
    clod_ranks_tell(self->ranks, &told, sizeof told);
    clod_bytes_clear(&slabs->out);
    clod_crew_slabs_pack(self, &told, &slabs->out); // not more than a slab
    return clod_ranks_collect(self->ranks, &slabs->out, &slabs->in, slabs->begin, status);
}

void clod_crew_slabs_end(clod_crew *self)
{
    clod_crew_slabs *slabs = &self->slabs;
    clod_memory_free(slabs->row);
    clod_memory_free(slabs->number);
    clod_memory_free(slabs->each);
    clod_memory_free(slabs->begin);
    clod_bytes_fini(&slabs->out);
    clod_bytes_fini(&slabs->in);
    clod_state_fini(&slabs->rows);
    clod_memory_free(slabs->rows_each);
    clod_memory_free(slabs->item);
    *slabs = (clod_crew_slabs){0};
}
