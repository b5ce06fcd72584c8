// What rank 0 gets of a bed that ranks step, as a source for those who write it.
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "base/room.h"
#include "base/sort.h"
#include "step/crew_part.h"
#include "step/records.h"

/** Grains whose contacts are asked for at a time. */
#define GRAINS 4096

/** One more order to all. */
static bool bring(clod_crew *self, const clod_crew_range *range, clod_status *status)
{
    clod_crew_give(self, CLOD_CREW_SLABS_BRING);
    return clod_crew_slabs_bring(self, range, status);
}

static bool begin(void *context, clod_bed_wants wants, clod_bed_counts *all,
                  clod_status *status)
{
    clod_crew *self = context;
    if (self->whole->failed) { // nor could it be gathered
        return clod_status_fail(status, CLOD_FAILED,
                                "the bed of steps that failed cannot be gathered");
    }
    clod_crew_give(self, CLOD_CREW_SLABS_BEGIN);
    return clod_crew_slabs_begin(self, wants, all, status);
}

// ---- grains

bool clod_crew_slabs_room(clod_crew *self, size_t count, clod_status *status)
{
    clod_crew_slabs *slabs = &self->slabs;
    clod_state *rows = &slabs->rows;
    const clod_grains *part = &self->state.grains;
    return clod_records_reserve(rows, count, status) &&
           (part->before == NULL || clod_grains_keep_before(&rows->grains, status)) &&
           (part->clump == NULL || clod_grains_keep_clumps(&rows->grains, status)) &&
           (clod_room_for(&slabs->rows_each, &slabs->each_room, count + 1,
                          sizeof *slabs->rows_each) ||
            clod_status_fail(status, CLOD_FAILED, "no memory for a slab of %zu grains", count));
}

bool clod_crew_slabs_take(clod_crew_slabs *self, size_t first)
{
    const size_t count = self->rows.grains.count;
    if (self->in.count == 0) { // then there may be no place of them
        return count == 0;
    }
    const char *at = self->in.data, *end = at + self->in.count;
    size_t taken = 0;
    while (at < end) {
        uint64_t number;
        memcpy(&number, at, sizeof number);
        at += sizeof number;
        if (number < first || number - first >= count) {
            return false;
        }
        const size_t row = (size_t)number - first;
        if (self->each != NULL) {
            memcpy(&self->rows_each[row], at, sizeof *self->rows_each);
            at += sizeof *self->rows_each;
        }
        at = clod_records_get_grain(at, &self->rows, row);
        taken++;
    }
    return taken == count;
}

static bool get_grains(void *context, size_t first, size_t count, clod_bed_slab *slab,
                       clod_status *status)
{
    clod_crew *self = context;
    clod_crew_slabs *slabs = &self->slabs;
    const clod_crew_range range = {first, count, 0};
    if (!clod_crew_slabs_room(self, count, status) || !bring(self, &range, status)) {
        return false;
    }
    slabs->rows.grains.count = count;
    if (!clod_crew_slabs_take(slabs, first)) {
        return clod_status_fail(status, CLOD_FAILED,
                                "the ranks sent other grains than the %zu from number %zu on",
                                count, first);
    }
    *slab = (clod_bed_slab){&slabs->rows, slabs->each != NULL ? slabs->rows_each : NULL};
    return true;
}

// ---- contacts

#define RECORD (sizeof(uint64_t) + CLOD_RECORDS_CONTACT)

/** Whether what comes has lines. */
static bool has_lines(const clod_crew_slabs *self)
{
    return self->lines && self->range.what == 1;
}

static size_t record_of(const clod_crew_slabs *self)
{
    return RECORD + (has_lines(self) ? sizeof(clod_bed_line) : 0);
}

bool clod_crew_slabs_sort(clod_crew_slabs *self, clod_status *status)
{
    const size_t record = record_of(self);
    self->items = self->in.count / record;
    self->next = 0;
    if (!clod_room_for(&self->item, &self->item_room, 2 * self->items + 1,
                       sizeof *self->item)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a slab of %zu contacts",
                                self->items);
    }
    for (size_t k = 0; k < self->items; k++) {
        uint64_t number;
        memcpy(&number, self->in.data + k * record, sizeof number);
        self->item[k] = (clod_sort_item){number, k};
    }
    clod_sort(self->item, self->item + self->items, self->items);
    return true;
}

/** Ask for contacts until there are some; none: at the end. */
static bool more_contacts(clod_crew *self, clod_status *status)
{
    clod_crew_slabs *slabs = &self->slabs;
    clod_crew_range *range = &slabs->range;
    const uint64_t grains = slabs->all.grains;
    bool good = true;
    while (good && slabs->next == slabs->items) {
        range->first += range->count;
        range->count = GRAINS;
        if (range->what == 0 || (range->what == 1 && range->first >= grains)) {
            range->what++;
            range->first = 0;
        }
        if (range->first >= grains) {
            break;
        }
        good = bring(self, range, status) && clod_crew_slabs_sort(slabs, status);
    }
    return good;
}

void clod_crew_slabs_contact(const clod_crew_slabs *self, size_t k, clod_contact *to,
                             uint64_t partners[2])
{
    const char *at = self->in.data + self->item[k].index * record_of(self);
    clod_records_get_contact(at + sizeof(uint64_t), to, partners);
}

static bool get_contacts(void *context, size_t *count, clod_contact *to,
                         uint64_t (*partners)[2], clod_bed_line *lines, clod_status *status)
{
    clod_crew *self = context;
    clod_crew_slabs *slabs = &self->slabs;
    const size_t room = *count;
    bool good = true;
    for (*count = 0; good && *count < room; ++*count) {
        good = slabs->next < slabs->items || more_contacts(self, status);
        if (!good || slabs->next == slabs->items) {
            break;
        }
        const char *at = slabs->in.data + slabs->item[slabs->next++].index * record_of(slabs);
        clod_records_get_contact(at + sizeof(uint64_t), &to[*count], partners[*count]);
        if (lines != NULL && has_lines(slabs)) {
            memcpy(&lines[*count], at + RECORD, sizeof *lines);
        }
    }
    return good;
}

static bool write(void *context, clod_bed_layout *layout, bool *done, clod_status *status)
{
    clod_crew *self = context;
    clod_crew_give(self, CLOD_CREW_SLABS_WRITE);
    return clod_crew_write(self, layout, done, status);
}

static bool hash_file(void *context, clod_bed_file *file, uint64_t *hash)
{
    clod_crew *self = context;
    clod_crew_give(self, CLOD_CREW_HASH);
    return clod_crew_hash(self, file, hash);
}

static void end(void *context)
{
    clod_crew *self = context;
    clod_crew_give(self, CLOD_CREW_SLABS_END);
    clod_crew_slabs_end(self);
}

clod_bed_source clod_step_bed_source(clod_step *step, clod_step_bed *self)
{
    if (step->failed) { // a rebuild may have left ranks' rows in no order; `begin` tells it
        clod_step_see(step, &(clod_status){0});
    }
    if (step->crew != NULL && step->crew->stale) {
        return (clod_bed_source){.context = step->crew,
                                 .begin = begin,
                                 .grains = get_grains,
                                 .contacts = get_contacts,
                                 .end = end,
                                 .write = write,
                                 .hash = hash_file};
    }
    self->contacts = clod_step_contacts(step, &self->reader);
    return clod_bed_source_of(&self->view, step->state, &self->contacts);
}
