#pragma once
/**
 * @file balance.h
 * How much work ranks have, and whether it is so uneven that the bed is to be cut anew. Work is the
 * processor time of thread 0 outside of messages since the last rebuild; a rank spreads it evenly
 * over its grains and contacts. All ranks decide by the same numbers, and no result depends on it.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/step/test_balance.c
 */

#include "parallel/ranks.h"

/** The most work of a rank over the mean at which a bed is cut anew (docs/adr/0038). */
#define CLOD_BALANCE_THRESHOLD 1.1

typedef struct clod_balance_options {
    double threshold; ///< most over mean at which to cut; 0 = CLOD_BALANCE_THRESHOLD; 1: always
    bool by_counts;   ///< grains and contacts are the work, not time
} clod_balance_options;

typedef struct clod_balance {
    clod_balance_options options;
    bool runs;     ///< the clock does
    double began;  ///< s, when it began to
    double time;   ///< s, until then
    int64_t moved; ///< grains of this rank that got another owner at the last rebuild
    double each;   ///< weight of a unit of this rank at the last look; 1 is the mean
} clod_balance;

/** Count time from now on, until clod_balance_pause. */
void clod_balance_go_on(clod_balance *self, const clod_ranks *ranks);
void clod_balance_pause(clod_balance *self, const clod_ranks *ranks);

/**
 * Look at the work of all ranks, which is counted anew from now on. self->each is known then, and
 * ranks->evenness tells it.
 *
 * @param units  of work of this rank: grains, and its halves of contacts
 * @return       whether it is too uneven, on all ranks alike
 */
bool clod_balance_asks(clod_balance *self, clod_ranks *ranks, double units);
