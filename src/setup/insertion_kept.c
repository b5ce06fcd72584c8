// Random positions of grains whose places others keep: batch by batch, the largest grains first. For
// each grain of a batch some draws are asked about at a time. A place that was free before the batch is
// the grain's if it is free of the grains of the batch before it, too. Grains are settled one after
// the other, so each gets the first of its draws that is free of all before it: what it gets from
// one process, which asks for one at a time.
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"
#include "setup/insertion_batch.h"

/** Grains of a batch, at least. */
#define BATCH_LEAST 256
/** A batch is so many times smaller than what has been put: few of its grains are in each other's way. */
#define BATCH_SHARE 16
/** Free places of a grain that an answer should have, in the mean: 0.6 was faster than 1 and 2. */
#define FREE_WANTED 0.6

/** Grains next in order whose free places are looked at again with each question: others can wait. */
#define LOOK_AHEAD 2048

#define NONE SIZE_MAX

/** A place that was free before the batch. */
typedef struct candidate {
    double place[4];
    size_t next; ///< of the same grain, in order of draws; NONE: that was the last
} candidate;

/** A grain of a batch. */
typedef struct slot {
    size_t number;
    double radius; ///< m, with its clearance
    uint64_t tried;
    size_t first, last; ///< candidates; NONE: none is left
    bool too_large;     ///< for the region
} slot;

typedef struct kept {
    clod_insertion_batch *batch;
    clod_insertion_space *space; ///< its grid has the grains of the batch
    const clod_setup_keeper *keeper;
    size_t piece;
    double range[2]; ///< m, heights between which grains are
    double free;     ///< share of the draws that were free, of the last that were asked about
    // of a batch
    slot *slot; ///< [slots] owned, as all arrays
    size_t slots, settled, slot_room;
    candidate *candidate;
    size_t candidates, candidate_room;
    clod_placed_sphere *put; ///< [settled]
    size_t put_room;
    // of a question
    double (*place)[4]; ///< [asked] places that are in the region and clear of walls
    size_t *owner;      ///< [asked] slots that they are for
    bool *clear;        ///< [asked]
    size_t asked, drawn, place_room, owner_room, clear_room;
} kept;

static bool fail_without_memory(const kept *self, clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "no memory for %zu grains",
                            self->batch->what->count);
}

// ---- what the keeper knows first

static bool give_sizes(const kept *self, clod_status *status)
{
    const size_t count = self->batch->what->count;
    double *radius = clod_memory_alloc(self->piece, sizeof *radius);
    bool good = radius != NULL || fail_without_memory(self, status);
    for (size_t first = 0; good && first < count; first += self->piece) {
        const size_t left = count - first, some = left < self->piece ? left : self->piece;
        for (size_t k = 0; k < some; k++) {
            radius[k] = clod_insertion_batch_radius(self->batch, first + k);
        }
        good = self->keeper->sizes(self->keeper->context, radius, some, status);
    }
    clod_memory_free(radius);
    return good;
}

static bool begin(kept *self, clod_status *status)
{
    clod_domain_box box;
    memcpy(box.low, self->space->low, sizeof box.low);
    memcpy(box.high, self->space->high, sizeof box.high);
    return self->keeper->begin(self->keeper->context, self->batch->state, &box,
                               self->batch->largest, self->batch->what->count, status) &&
           give_sizes(self, status);
}

// ---- questions

/** Note a place to be asked about. False without memory. */
static bool note(kept *self, size_t s, const double place[4])
{
    if (!clod_room_for_one(&self->place, &self->place_room, self->asked, sizeof *self->place) ||
        !clod_room_for_one(&self->owner, &self->owner_room, self->asked, sizeof *self->owner)) {
        return false;
    }
    memcpy(self->place[self->asked], place, sizeof *self->place);
    self->owner[self->asked++] = s;
    return true;
}

/** The next draws of a grain, of which those that may be free will be asked about. */
static bool draw(kept *self, size_t s, uint64_t draws)
{
    slot *grain = &self->slot[s];
    bool good = true;
    for (uint64_t k = 0; good && k < draws && !grain->too_large; k++) {
        double u[3], place[4] = {0.0, 0.0, 0.0, grain->radius};
        clod_insertion_batch_draw(self->batch, grain->number, grain->tried, u);
        grain->too_large =
            !clod_insertion_space_draw(self->space, place, self->range[0], self->range[1], u);
        grain->tried += !grain->too_large;
        self->drawn += !grain->too_large;
        good = grain->too_large || !clod_insertion_space_open_at(self->space, place) ||
               note(self, s, place);
    }
    return good;
}

/** Whether no draw of a grain is left. */
static bool is_lost(const slot *grain)
{
    return grain->too_large || grain->tried == CLOD_INSERTION_TRIES;
}

/** Drop candidates in the way of grains that have been settled, up to the first that is not. */
static void drop_taken(kept *self, slot *grain)
{
    while (grain->first != NONE &&
           !clod_sphere_grid_clear(&self->space->grid, self->candidate[grain->first].place)) {
        grain->first = self->candidate[grain->first].next;
    }
}

static bool keep_candidate(kept *self, slot *grain, const double place[4])
{
    if (!clod_room_for_one(&self->candidate, &self->candidate_room, self->candidates,
                           sizeof *self->candidate)) {
        return false;
    }
    const size_t at = self->candidates++;
    self->candidate[at].next = NONE;
    memcpy(self->candidate[at].place, place, sizeof self->candidate[at].place);
    if (grain->first == NONE) {
        grain->first = at;
    } else {
        self->candidate[grain->last].next = at;
    }
    grain->last = at;
    return true;
}

/** Ask about the places noted, and keep those that are free. */
static bool ask(kept *self, clod_status *status)
{
    if (!clod_room_for(&self->clear, &self->clear_room, self->asked + 1, sizeof *self->clear)) {
        return fail_without_memory(self, status);
    }
    if (self->asked > 0 &&
        !self->keeper->ask(self->keeper->context, (const double(*)[4])self->place, self->asked,
                           self->clear, status)) {
        return false;
    }
    size_t found = 0;
    bool good = true;
    for (size_t k = 0; good && k < self->asked; k++) {
        found += self->clear[k];
        good = !self->clear[k] ||
               keep_candidate(self, &self->slot[self->owner[k]], self->place[k]);
    }
    self->free = fmax((double)found, 1.0) / fmax((double)self->drawn, 1.0);
    return good || fail_without_memory(self, status);
}

/** Ask about more draws of the grains that have no place to go to. */
static bool ask_more(kept *self, clod_status *status)
{
    const double draws = fmin(ceil(FREE_WANTED / self->free), CLOD_INSERTION_TRIES);
    bool good = true;
    self->asked = self->drawn = 0;
    for (size_t s = self->settled; good && s < self->slots && self->drawn < self->piece; s++) {
        slot *grain = &self->slot[s];
        if (s < self->settled + LOOK_AHEAD) {
            drop_taken(self, grain);
        }
        if (grain->first == NONE) {
            const uint64_t left = CLOD_INSERTION_TRIES - grain->tried;
            good = draw(self, s, left < (uint64_t)draws ? left : (uint64_t)draws);
        }
    }
    return (good || fail_without_memory(self, status)) && ask(self, status);
}

// ---- batches

/** Settle grains in their order, as far as one is known to have a place. */
static bool settle(kept *self, clod_status *status)
{
    bool good = true;
    for (; good && self->settled < self->slots; self->settled++) {
        slot *grain = &self->slot[self->settled];
        drop_taken(self, grain);
        if (grain->first == NONE) {
            break;
        }
        const double *place = self->candidate[grain->first].place;
        clod_placed_sphere *put = &self->put[self->settled];
        memcpy(put->place, place, sizeof put->place);
        put->number = grain->number;
        good = clod_insertion_space_take(self->space, place, status);
    }
    return good;
}

/** Begin a batch with the next grains. */
static bool begin_batch(kept *self, const clod_sort_item *grain, size_t count,
                        clod_status *status)
{
    if (!clod_room_for(&self->slot, &self->slot_room, count, sizeof *self->slot) ||
        !clod_room_for(&self->put, &self->put_room, count, sizeof *self->put)) {
        return fail_without_memory(self, status);
    }
    self->slots = count;
    self->settled = self->candidates = 0;
    for (size_t k = 0; k < count; k++) {
        const size_t number = (size_t)grain[k].index;
        self->slot[k] = (slot){.number = number,
                               .radius = clod_insertion_batch_radius(self->batch, number) *
                                         (1.0 + CLOD_INSERTION_CLEARANCE),
                               .first = NONE};
    }
    return clod_insertion_space_band(self->space, self->range[0], self->range[1], count,
                                     status);
}

/** Put a batch, up to the first grain that finds no place. */
static bool put_batch(kept *self, const clod_sort_item *grain, size_t count,
                      clod_status *status)
{
    bool good = begin_batch(self, grain, count, status);
    while (good && self->settled < self->slots) {
        const slot *next = &self->slot[self->settled];
        if (next->first == NONE && is_lost(next)) {
            break;
        }
        good = ask_more(self, status) && settle(self, status);
    }
    self->batch->reached += good ? self->settled : 0;
    return good && self->keeper->put(self->keeper->context, self->put, self->settled, status);
}

/** Put some grains, in batches, up to the first that finds no place. */
static bool put_some(kept *self, const clod_sort_item *grain, size_t count, clod_status *status)
{
    bool good = true, all = true;
    for (size_t k = 0; good && all && k < count; k += self->slots) {
        const size_t share = self->batch->reached / BATCH_SHARE, left = count - k;
        const size_t wanted = share > BATCH_LEAST ? share : BATCH_LEAST;
        good = put_batch(self, grain + k, wanted < left ? wanted : left, status);
        all = good && self->settled == self->slots;
    }
    return good;
}

static bool put_all(kept *self, clod_status *status)
{
    size_t had = 0, count = 1;
    bool good = true;
    while (good && count > 0 && self->batch->reached == had) {
        const clod_sort_item *grain;
        good = self->keeper->next(self->keeper->context, &grain, &count, status) &&
               put_some(self, grain, count, status);
        had += count;
    }
    return good;
}

/** Append them in order of their numbers. */
static bool append(const kept *self, clod_status *status)
{
    const size_t count = self->batch->what->count;
    double(*place)[4] = clod_memory_alloc(self->piece, sizeof *place);
    bool good = place != NULL || fail_without_memory(self, status);
    for (size_t first = 0; good && first < count; first += self->piece) {
        const size_t left = count - first, some = left < self->piece ? left : self->piece;
        good = self->keeper->fetch(self->keeper->context, first, some, place, status);
        for (size_t k = 0; good && k < some; k++) {
            place[k][3] = clod_insertion_batch_radius(self->batch, first + k);
            good = clod_insertion_batch_put(self->batch, first + k, place[k], status);
        }
    }
    clod_memory_free(place);
    return good;
}

static void kept_fini(kept *self)
{
    self->keeper->end(self->keeper->context);
    clod_memory_free(self->slot);
    clod_memory_free(self->candidate);
    clod_memory_free(self->put);
    clod_memory_free(self->place);
    clod_memory_free(self->owner);
    clod_memory_free(self->clear);
}

bool clod_insertion_kept_fill(clod_insertion_batch *batch, clod_insertion_space *space,
                              clod_status *status)
{
    const clod_setup_taker *taker = batch->what->pieces->taker;
    kept self = {.batch = batch,
                 .space = space,
                 .keeper = taker->keeper,
                 .piece = taker->piece,
                 .range = {space->low[2], space->high[2]},
                 .free = 1.0};
    const bool good = begin(&self, status) && put_all(&self, status) &&
                      (batch->reached < batch->what->count || append(&self, status));
    kept_fini(&self);
    return good;
}
