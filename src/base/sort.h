#pragma once
/**
 * @file sort.h
 * Stable radix sort of 64-bit keys; allocates nothing.
 */

#include <stddef.h>
#include <stdint.h>

typedef struct clod_sort_item {
    uint64_t key;
    uint64_t index; ///< what the key belongs to
} clod_sort_item;

/**
 * Sort items by key, keeping the order of equal keys.
 *
 * @param items    [in,out] [count]
 * @param scratch  [count] overwritten
 * Errors  none.   Threads  pure.   Test  tests/base/test_sort.c
 */
void clod_sort(clod_sort_item *items, clod_sort_item *scratch, size_t count);

// ---- the same in pieces, for several parts of the items (parallel/parallel_sort.h)

/** Values of the digit that one pass sorts by. */
#define CLOD_SORT_DIGITS 256

/** What has been seen of the keys of one part; on its own cache lines. */
typedef struct clod_sort_part {
    _Alignas(64) uint64_t any;     ///< bits that are set in any of its keys
    uint64_t all;                  ///< and in all of them
    size_t seen[CLOD_SORT_DIGITS]; ///< how often each value of the digit is there
} clod_sort_part;

/** Which bits are set in the keys of a part's items, [count]. */
void clod_sort_look(clod_sort_part *self, const clod_sort_item *items, size_t count);

/** Bits that are not the same in all keys of all parts. */
uint64_t clod_sort_differ(const clod_sort_part *part, int parts);

/** First bit of the next digit; its bits, of those that differ, are taken out. Not without any. */
int clod_sort_next_digit(uint64_t *differ);

/** Count the digits from bit `shift` on of a part's items, [count]. */
void clod_sort_count(clod_sort_part *self, const clod_sort_item *items, size_t count,
                     int shift);

/** A pass: items of one part, in their order, to their places among those of all parts. */
typedef struct clod_sort_pass {
    const clod_sort_part *part; ///< [parts] all of them have counted
    int parts, number;          ///< the part is part[number]
    int shift;                  ///< first bit of the digit
} clod_sort_pass;

/**
 * @param items  [count] of the part
 * @param to     [items of all parts, out]
 */
void clod_sort_move(const clod_sort_pass *self, const clod_sort_item *items, size_t count,
                    clod_sort_item *to);
