#pragma once
/**
 * @file amount.h
 * How many grains a case asks for: estimated first, counted one by one only when this machine
 * can hold them.
 */

#include "clod/status.h"
#include "config/sizes.h"

/** Grains asked for: a number of them, or as many as have a solid volume. */
typedef struct clod_amount {
    const char *key; ///< of the case, for messages, for instance "grains.0.mass"
    const clod_sizes *sizes;
    int64_t count;  ///< 0: as many as have the volume
    double volume;  ///< m3, of solid
    double density; ///< kg/m3, for messages
    double share;   ///< of the grains, that this machine has to hold; 0: all
} clod_amount;

/** Number of grains to expect, from the mean volume of a grain. Threads: pure. */
double clod_amount_expect(const clod_amount *self);

/**
 * Whether this machine can hold its share of a number of grains: refused when their rows alone, and what
 * putting them takes, are more than all of its memory.
 *
 * Errors  CLOD_USAGE with the number and the memory.   Threads  pure.
 */
bool clod_amount_fits(const char *key, double grains, double share, clod_status *status);

/**
 * Number of grains: the one asked for, or the one whose solid volume comes nearest.
 *
 * @param seed      of the sizes
 * @param first_id  the grains' ids are first_id, first_id + 1, ...
 * @return          0 with a status
 * Errors  CLOD_USAGE: more than the machine can hold; or the nearest volume is less than half
 *         or more than one and a half times the one asked for, as a volume below one grain's.
 * Threads pure.   Test  tests/setup/test_setup_amount.c
 */
size_t clod_amount_count(const clod_amount *self, uint64_t seed, uint64_t first_id,
                         clod_status *status);
