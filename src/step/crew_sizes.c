#include "step/crew_sizes.h"

#include <string.h>

#include "base/memory.h"
#include "base/room.h"
#include "step/crew_shares.h"

static bool fail_without_memory(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "no memory for the sizes of grains");
}

/** Behind those that this rank has. */
static bool keep(clod_crew_sizes *self, const clod_ranks *ranks, const clod_bytes *in)
{
    for (size_t k = 0; k < in->count / sizeof(double); k++) {
        uint64_t bits; // positive doubles have the order of their bits
        memcpy(&bits, in->data + k * sizeof bits, sizeof bits);
        if (!clod_room_for_one(&self->own, &self->own_room, self->count, sizeof *self->own)) {
            return false;
        }
        const uint64_t number = self->count * (uint64_t)ranks->size + (uint64_t)ranks->rank;
        self->own[self->count++] = (clod_sort_item){.key = ~bits, .index = number};
    }
    return true;
}

bool clod_crew_sizes_give(clod_crew_sizes *self, clod_ranks *ranks, const double *radius,
                          size_t count, clod_status *status)
{
    clod_crew_shares all;
    bool good = clod_crew_shares_init(&all, ranks, status);
    for (size_t k = 0; good && radius != NULL && k < count; k++) {
        const size_t to = (self->given + k) % (size_t)ranks->size;
        clod_bytes_put(&all.out[to], &radius[k], sizeof *radius);
    }
    good = good && clod_crew_shares_swap(&all, ranks, status);
    if (good) {
        const bool kept = keep(self, ranks, &all.in) || fail_without_memory(status);
        good = clod_ranks_agree(ranks, kept, status);
    }
    self->given += count;
    clod_crew_shares_fini(&all, ranks);
    return good;
}

static bool sort_own(clod_crew_sizes *self)
{
    clod_sort_item *scratch = clod_memory_alloc(self->count + 1, sizeof *scratch);
    if (scratch == NULL) {
        return false;
    }
    clod_sort(self->own, scratch, self->count); // numbers ascend: equal ones stay so
    clod_memory_free(scratch);
    self->sorted = true;
    return true;
}

static clod_sort_item turned(clod_sort_item item)
{
    return (clod_sort_item){.key = item.index, .index = item.key};
}

/** By size, and equal ones by number. */
static void sort_pool(clod_crew_sizes *self)
{
    for (int pass = 0; pass < 2; pass++) { // the sort is stable: the first key comes last
        for (size_t k = 0; pass == 0 && k < self->pooled; k++) {
            self->pool[k] = turned(self->pool[k]);
        }
        clod_sort(self->pool, self->scratch, self->pooled);
        for (size_t k = 0; pass == 0 && k < self->pooled; k++) {
            self->pool[k] = turned(self->pool[k]);
        }
    }
}

/** What came beside what was left. */
static bool fill_pool(clod_crew_sizes *self, const clod_bytes *in)
{
    const size_t left = self->pooled - self->ready, came = in->count / sizeof *self->pool;
    const clod_sort_item *from = (const clod_sort_item *)(const void *)in->data;
    if (!clod_room_for(&self->scratch, &self->scratch_room, left + came + 1,
                       sizeof *self->scratch)) {
        return false;
    }
    if (left > 0) {
        memcpy(self->scratch, self->pool + self->ready, left * sizeof *self->pool);
    }
    if (!clod_room_for(&self->pool, &self->pool_room, left + came + 1, sizeof *self->pool)) {
        return false;
    }
    if (left > 0) {
        memcpy(self->pool, self->scratch, left * sizeof *self->pool);
    }
    for (size_t k = 0; k < came; k++) {
        self->pool[left + k] = from[k];
    }
    self->pooled = left + came;
    sort_pool(self);
    return true;
}

static bool is_before(const clod_sort_item *a, const clod_sort_item *b)
{
    return a->key < b->key || (a->key == b->key && a->index < b->index);
}

/** As many of the pool as no rank can have any before: up to the earliest of what ranks that have
 *  more sent last. */
static void find_ready(clod_crew_sizes *self, const clod_ranks *ranks,
                       const clod_crew_shares *all)
{
    const clod_sort_item *from = (const clod_sort_item *)(const void *)all->in.data;
    const clod_sort_item *bound = NULL;
    const size_t size = (size_t)ranks->size;
    for (size_t r = 0; r < size; r++) {
        const size_t total = self->given / size + (r < self->given % size);
        const size_t end = all->begin[r + 1] / sizeof *from;
        // rank 0 has as many as any other: who has more than it has sent has more than was sent
        if (total > self->sent && (bound == NULL || is_before(&from[end - 1], bound))) {
            bound = &from[end - 1];
        }
    }
    self->ready = self->pooled;
    while (bound != NULL && self->ready > 0 && is_before(bound, &self->pool[self->ready - 1])) {
        self->ready--;
    }
}

bool clod_crew_sizes_next(clod_crew_sizes *self, clod_ranks *ranks, size_t chunk,
                          clod_status *status)
{
    bool good = self->sorted || sort_own(self) || fail_without_memory(status);
    if (!clod_ranks_agree(ranks, good, status)) {
        return false;
    }
    clod_crew_shares all;
    good = clod_crew_shares_init(&all, ranks, status);
    if (good) {
        const size_t left = self->count - self->sent, count = left < chunk ? left : chunk;
        if (count > 0) {
            clod_bytes_put(&all.out[0], &self->own[self->sent], count * sizeof *self->own);
        }
        self->sent += count;
        good = clod_crew_shares_collect(&all, ranks, status);
    }
    if (good && ranks->rank == 0) {
        good = fill_pool(self, &all.in) || fail_without_memory(status);
        if (good) {
            find_ready(self, ranks, &all);
        }
    }
    good = clod_ranks_agree(ranks, good, status);
    clod_crew_shares_fini(&all, ranks);
    return good;
}

void clod_crew_sizes_fini(clod_crew_sizes *self)
{
    clod_memory_free(self->own);
    clod_memory_free(self->pool);
    clod_memory_free(self->scratch);
    *self = (clod_crew_sizes){0};
}
