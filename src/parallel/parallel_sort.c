#include "parallel/parallel_sort.h"

static clod_chunk items_of(const clod_parallel_sort *self, size_t part)
{
    return clod_threads_chunk(self->count, (int)part, self->parts);
}

clod_sort_item *clod_parallel_sort_do(const clod_parallel_sort *self, clod_chunk parts,
                                      clod_barrier *barrier)
{
    clod_sort_item *from = self->items;
    clod_sort_item *to = self->scratch;
    for (size_t p = parts.begin; p < parts.end; p++) {
        const clod_chunk c = items_of(self, p);
        clod_sort_look(&self->part[p], from + c.begin, c.end - c.begin);
    }
    clod_barrier_wait(barrier);
    uint64_t differ = clod_sort_differ(self->part, self->parts);
    while (differ != 0) {
        const int shift = clod_sort_next_digit(&differ);
        for (size_t p = parts.begin; p < parts.end; p++) {
            const clod_chunk c = items_of(self, p);
            clod_sort_count(&self->part[p], from + c.begin, c.end - c.begin, shift);
        }
        clod_barrier_wait(barrier);
        for (size_t p = parts.begin; p < parts.end; p++) {
            const clod_chunk c = items_of(self, p);
            const clod_sort_pass pass = {self->part, self->parts, (int)p, shift};
            clod_sort_move(&pass, from + c.begin, c.end - c.begin, to);
        }
        clod_barrier_wait(barrier);
        clod_sort_item *swap = from;
        from = to;
        to = swap;
    }
    return from;
}
