// Numbers of all grains in the order of one process, found slab by slab: ranks agree on the key where
// a slab ends, and rank 0 sorts the keys in it.
#include <string.h>

#include "base/lower_bound.h"
#include "base/memory.h"
#include "base/room.h"
#include "base/sort.h"
#include "parallel/ranks_collect.h"
#include "step/crew_part.h"

/** A grain's place in the order. */
typedef struct keyed {
    uint64_t key, id;
} keyed;

/** The numbering of one rank. */
typedef struct numbering {
    clod_ranks *ranks;
    uint64_t *key; ///< [own] of own rows: they ascend
    size_t own, at;
    clod_bytes mine, all;
    size_t *begin;
    clod_sort_item *item, *scratch; ///< of rank 0
    uint64_t *number;
    size_t item_room, scratch_room, number_room;
} numbering;

static void add_count(const void *context, void *into, const void *from)
{
    (void)context;
    *(uint64_t *)into += *(const uint64_t *)from;
}

static void take_least(const void *context, void *into, const void *from)
{
    (void)context;
    uint64_t *mine = into;
    const uint64_t other = *(const uint64_t *)from;
    *mine = other < *mine ? other : *mine;
}

size_t clod_crew_below(const uint64_t *number, size_t count, uint64_t limit)
{
    clod_lower_bound in = {0, count};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        clod_lower_bound_halve(&in, number[middle] < limit);
    }
    return in.low;
}

/** Own rows from `at` on with a smaller key. */
static size_t below(const numbering *self, uint64_t key)
{
    return clod_crew_below(self->key + self->at, self->own - self->at, key);
}

/** The same of all ranks. */
static uint64_t all_below(const numbering *self, uint64_t key)
{
    uint64_t count = below(self, key);
    clod_ranks_merge(self->ranks, &count, sizeof count, add_count, NULL);
    return count;
}

/** The least key of all ranks' rows number `at` of those that are left. */
static uint64_t least_key(const numbering *self, size_t at)
{
    uint64_t key = at < self->own - self->at ? self->key[self->at + at] : UINT64_MAX;
    clod_ranks_merge(self->ranks, &key, sizeof key, take_least, NULL);
    return key;
}

/** Key below which the next slab is: as many rows as fit, or all with the next key. */
static uint64_t end_of_slab(const numbering *self)
{
    uint64_t low = least_key(self, 0); // none is below it
    uint64_t high = least_key(self, CLOD_CREW_SLAB);
    const uint64_t next = low;
    high += high < UINT64_MAX; // more than a slab is below it
    while (high - low > 1) {
        const uint64_t middle = low + (high - low) / 2;
        if (all_below(self, middle) <= CLOD_CREW_SLAB) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low > next ? low : next + 1;
}

/** Sort what has come, and number it. False without memory. */
static bool number_slab(numbering *self, uint64_t first)
{
    const keyed *from = (const keyed *)(const void *)self->all.data;
    const size_t count = self->all.count / sizeof *from;
    if (!clod_room_for(&self->item, &self->item_room, count + 1, sizeof *self->item) ||
        !clod_room_for(&self->scratch, &self->scratch_room, count + 1, sizeof *self->scratch) ||
        !clod_room_for(&self->number, &self->number_room, count + 1, sizeof *self->number)) {
        return false;
    }
    for (size_t k = 0; k < count; k++) {
        self->item[k] = (clod_sort_item){from[k].key, k};
    }
    clod_sort(self->item, self->scratch, count);
    for (size_t k = 1; k < count; k++) { // equal keys are rare: by id
        const clod_sort_item moving = self->item[k];
        size_t at = k;
        while (at > 0 && self->item[at - 1].key == moving.key &&
               from[self->item[at - 1].index].id > from[moving.index].id) {
            self->item[at] = self->item[at - 1];
            at--;
        }
        self->item[at] = moving;
    }
    for (size_t k = 0; k < count; k++) {
        self->number[self->item[k].index] = first + k;
    }
    return true;
}

/** The rows of all ranks up to a key. False on all alike. */
static bool number_next(numbering *self, const clod_crew *crew, size_t count, uint64_t *first,
                        clod_status *status)
{
    const clod_crew_slabs *slabs = &crew->slabs;
    clod_bytes_clear(&self->mine);
    for (size_t k = self->at; k < self->at + count; k++) {
        const keyed row = {self->key[k], crew->state.grains.id[slabs->row[k]]};
        clod_bytes_put(&self->mine, &row, sizeof row);
    }
    if (!clod_ranks_collect(self->ranks, &self->mine, &self->all, self->begin, status)) {
        return false;
    }
    const bool good = self->ranks->rank > 0 || number_slab(self, *first) ||
                      clod_status_fail(status, CLOD_FAILED, "no memory to sort a slab");
    if (!clod_ranks_agree(self->ranks, good, status)) {
        return false;
    }
    for (int r = 0; self->ranks->rank == 0 && r <= self->ranks->size; r++) {
        self->begin[r] = self->begin[r] / sizeof(keyed) * sizeof *self->number;
    }
    clod_ranks_return(self->ranks, self->number, self->begin, &slabs->number[self->at],
                      count * sizeof *self->number);
    *first += self->all.count / sizeof(keyed); // counts on rank 0, which numbers
    self->at += count;
    return true;
}

static bool number_all(numbering *self, const clod_crew *crew, clod_status *status)
{
    uint64_t first = 0;
    bool good = true;
    for (uint64_t left = all_below(self, UINT64_MAX); good && left > 0;
         left = all_below(self, UINT64_MAX)) {
        const size_t count =
            left <= CLOD_CREW_SLAB ? self->own - self->at : below(self, end_of_slab(self));
        good = number_next(self, crew, count, &first, status);
    }
    return good;
}

/** Keys of own rows, which are searched: they must ascend. */
static bool find_keys(numbering *self, const clod_crew *crew, clod_status *status)
{
    for (size_t k = 0; k < self->own; k++) {
        const int32_t row = crew->slabs.row[k];
        self->key[k] = clod_layers_key(&crew->spread.layers, crew->state.build_position[row]);
        if (k > 0 && self->key[k - 1] > self->key[k]) {
            return clod_status_fail(status, CLOD_FAILED,
                                    "the grains of a rank are not in their order");
        }
    }
    return true;
}

bool clod_crew_number(clod_crew *self, clod_status *status)
{
    const clod_crew_slabs *slabs = &self->slabs;
    numbering all = {.ranks = self->ranks,
                     .key = clod_memory_alloc(slabs->own + 1, sizeof *all.key),
                     .own = slabs->own,
                     .begin = slabs->begin};
    bool good = all.key != NULL || clod_status_fail(status, CLOD_FAILED,
                                                    "no memory to number %zu grains", all.own);
    good = good && find_keys(&all, self, status);
    good = clod_ranks_agree(self->ranks, good, status) && number_all(&all, self, status);
    clod_memory_free(all.key);
    clod_memory_free(all.item);
    clod_memory_free(all.scratch);
    clod_memory_free(all.number);
    clod_bytes_fini(&all.mine);
    clod_bytes_fini(&all.all);
    return good;
}
