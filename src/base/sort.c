#include "base/sort.h"

#include <string.h>

#define DIGIT_BITS 8
#define DIGITS 256
#define PASSES (64 / DIGIT_BITS)

static size_t digit_of(uint64_t key, int pass)
{
    return (key >> (DIGIT_BITS * pass)) & (DIGITS - 1);
}

/** How often each digit is there, in one way through the keys. */
static void count_digits(const clod_sort_item *items, size_t count, size_t seen[PASSES][DIGITS])
{
    for (size_t k = 0; k < count; k++) {
        for (int pass = 0; pass < PASSES; pass++) {
            seen[pass][digit_of(items[k].key, pass)]++;
        }
    }
}

void clod_sort(clod_sort_item *items, clod_sort_item *scratch, size_t count)
{
    size_t seen[PASSES][DIGITS] = {0};
    clod_sort_item *from = items;
    clod_sort_item *to = scratch;
    count_digits(items, count, seen);
    for (int pass = 0; pass < PASSES && count > 0; pass++) {
        size_t *start = seen[pass];
        if (start[digit_of(items[0].key, pass)] == count) { // all the same: in order already
            continue;
        }
        size_t sum = 0;
        for (int d = 0; d < DIGITS; d++) {
            const size_t mine = start[d];
            start[d] = sum;
            sum += mine;
        }
        for (size_t k = 0; k < count; k++) {
            to[start[digit_of(from[k].key, pass)]++] = from[k];
        }
        clod_sort_item *swap = from;
        from = to;
        to = swap;
    }
    if (from != items) {
        memcpy(items, from, count * sizeof *items);
    }
}
