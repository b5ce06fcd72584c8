#pragma once
/**
 * @file ranks.h
 * What rank 0 has for the others once they have served a bed, or none.
 */

#include "clod/ranks.h"

typedef enum clod_ranks_next {
    CLOD_RANKS_LEAVE, ///< nothing more
    CLOD_RANKS_PARTS  ///< parts of a test (sim/group.h)
} clod_ranks_next;

/** Tell it to those that clod_crew_dismiss has let go. Threads: rank 0. */
void clod_ranks_word(clod_ranks *self, clod_ranks_next next);
