#pragma once
/**
 * @file steady_doubt.h
 * Whether the means of a run's blocks are those of a steady stream, and the warning where they are not
 * (docs/gauges.md, "Is it steady?"). Blocks are those of the steady time; NAN: nothing is known of one.
 */

#include <jansson.h>
#include <stdbool.h>

#include "sim/steady_time.h"

/** Fewest blocks that are judged. */
#define CLOD_STEADY_DOUBT_BLOCKS 5

/** What speaks against a steady stream. */
typedef struct clod_steady_doubt {
    int late; ///< first blocks that are 0, when no later one is; else 0
    double
        change; ///< over all blocks, by the line through them, in the blocks' unit; 0: none that
                ///< is more than 3 standard errors and a tenth of the mean
} clod_steady_doubt;

/**
 * Look at the means of blocks.
 *
 * @param block  [count], one behind the other in time
 * @return       no doubt where fewer than CLOD_STEADY_DOUBT_BLOCKS are known
 * Errors  none.   Threads  pure.   Test  tests/sim/test_steady_doubt.c
 */
clod_steady_doubt clod_steady_doubt_of(const double *block, int count);

/**
 * Whether the mean of blocks differs from 0 by more than 3 of its standard errors (from the blocks'
 * scatter) and a tenth of a scale.
 *
 * @param block  [count];  @param scale  in the blocks' unit
 * Errors  none.   Threads  pure.   Test  tests/sim/test_steady_doubt.c
 */
bool clod_steady_doubt_not_zero(const double *block, int count, double scale);

/**
 * Add a warning where blocks are in doubt.
 *
 * @param list   of texts
 * @param what   "Gauge lip: the mass flow";  @param unit  of the blocks, e.g. "kg/s"
 * @return       whether there was one
 * Test  tests/sim/test_steady_doubt.c, tests/cli/test_gauges.py
 */
bool clod_steady_doubt_warn(json_t *list, const char *what, const char *unit,
                            const double *block, int count, const clod_steady_time *steady);
