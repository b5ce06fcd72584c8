#include "base/sort.h"

#define DIGIT_BITS 8
#define DIGITS 256

void clod_sort(clod_sort_item *items, clod_sort_item *scratch, size_t count)
{
    clod_sort_item *from = items;
    clod_sort_item *to = scratch;
    for (int shift = 0; shift < 64; shift += DIGIT_BITS) {
        size_t start[DIGITS + 1] = {0};
        for (size_t k = 0; k < count; k++) {
            start[((from[k].key >> shift) & (DIGITS - 1)) + 1]++;
        }
        for (int d = 0; d < DIGITS; d++) {
            start[d + 1] += start[d];
        }
        for (size_t k = 0; k < count; k++) {
            to[start[(from[k].key >> shift) & (DIGITS - 1)]++] = from[k];
        }
        clod_sort_item *swap = from;
        from = to;
        to = swap;
    }
    // an even number of passes: the sorted items are back where they came from
}
