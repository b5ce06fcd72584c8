#include "base/sort.h"

#include <string.h>

static size_t digit_of(uint64_t key, int shift)
{
    return (key >> shift) & (CLOD_SORT_DIGITS - 1);
}

void clod_sort_look(clod_sort_part *self, const clod_sort_item *items, size_t count)
{
    uint64_t any = 0, all = UINT64_MAX;
    for (size_t k = 0; k < count; k++) {
        any |= items[k].key;
        all &= items[k].key;
    }
    self->any = any;
    self->all = all;
}

uint64_t clod_sort_differ(const clod_sort_part *part, int parts)
{
    uint64_t any = 0, all = UINT64_MAX;
    for (int p = 0; p < parts; p++) {
        any |= part[p].any;
        all &= part[p].all;
    }
    return any & ~all;
}

int clod_sort_next_digit(uint64_t *differ)
{
    const int shift = __builtin_ctzll(*differ);
    *differ &= ~((uint64_t)(CLOD_SORT_DIGITS - 1) << shift);
    return shift;
}

void clod_sort_count(clod_sort_part *self, const clod_sort_item *items, size_t count, int shift)
{
    memset(self->seen, 0, sizeof self->seen);
    for (size_t k = 0; k < count; k++) {
        self->seen[digit_of(items[k].key, shift)]++;
    }
}

void clod_sort_move(const clod_sort_pass *self, const clod_sort_item *items, size_t count,
                    clod_sort_item *to)
{
    size_t next[CLOD_SORT_DIGITS] = {0}; // behind smaller digits, and the same of earlier parts
    size_t seen[CLOD_SORT_DIGITS] = {0};
    for (int p = 0; p < self->parts; p++) {
        for (int d = 0; d < CLOD_SORT_DIGITS; d++) {
            next[d] += p < self->number ? self->part[p].seen[d] : 0;
            seen[d] += self->part[p].seen[d];
        }
    }
    size_t smaller = 0;
    for (int d = 0; d < CLOD_SORT_DIGITS; d++) {
        next[d] += smaller;
        smaller += seen[d];
    }
    for (size_t k = 0; k < count; k++) {
        to[next[digit_of(items[k].key, self->shift)]++] = items[k];
    }
}

void clod_sort(clod_sort_item *items, clod_sort_item *scratch, size_t count)
{
    clod_sort_part all;
    clod_sort_pass pass = {.part = &all, .parts = 1};
    clod_sort_item *from = items;
    clod_sort_item *to = scratch;
    clod_sort_look(&all, items, count);
    uint64_t differ = clod_sort_differ(&all, 1);
    while (differ != 0) {
        pass.shift = clod_sort_next_digit(&differ);
        clod_sort_count(&all, from, count, pass.shift);
        clod_sort_move(&pass, from, count, to);
        clod_sort_item *swap = from;
        from = to;
        to = swap;
    }
    if (from != items) {
        memcpy(items, from, count * sizeof *items);
    }
}
