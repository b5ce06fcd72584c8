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
