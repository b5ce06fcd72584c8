#pragma once
/**
 * @file lower_bound.h
 * Binary search for the first item of an ascending row that is not below a limit, whatever the items
 * are kept in:
 *
 *     clod_lower_bound in = {0, count};
 *     while (in.low < in.high) {
 *         const size_t middle = clod_lower_bound_middle(&in);
 *         clod_lower_bound_halve(&in, item[middle] < limit);
 *     }
 *     return in.low; // count: all are below
 *
 * Threads  pure.   Test  tests/base/test_lower_bound.c
 */

#include <stdbool.h>
#include <stddef.h>

typedef struct clod_lower_bound {
    size_t low, high; ///< items before `low` are below the limit, those from `high` on are not
} clod_lower_bound;

/** The item that is to be compared next. */
static inline size_t clod_lower_bound_middle(const clod_lower_bound *self)
{
    return self->low + (self->high - self->low) / 2;
}

/** Go on in one half: the item in the middle is below the limit, or is not. */
static inline void clod_lower_bound_halve(clod_lower_bound *self, bool below)
{
    const size_t middle = clod_lower_bound_middle(self);
    if (below) {
        self->low = middle + 1;
    } else {
        self->high = middle;
    }
}
