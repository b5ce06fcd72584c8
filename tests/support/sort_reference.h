#pragma once
/**
 * @file sort_reference.h
 * The order of a stable sort, for the C library's qsort.
 */

#include "base/sort.h"

/** By key, then by the place in the input: what a stable sort does. */
static inline int sort_compare(const void *a, const void *b)
{
    const clod_sort_item *x = a;
    const clod_sort_item *y = b;
    if (x->key != y->key) {
        return x->key < y->key ? -1 : 1;
    }
    return (x->index > y->index) - (x->index < y->index);
}
