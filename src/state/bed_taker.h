#pragma once
/**
 * @file bed_taker.h
 * Who takes a bed that is read from a file, slab by slab, so that nobody has a list of all.
 */

#include "state/state.h"

typedef struct clod_bed_taker {
    void *context; ///< of the functions; borrowed

    /**
     * So many grains come. The state has all else but grains and contacts, and the columns that
     * grains have.
     *
     * @param takes  [out] false: the state is to keep all, and nothing else is called
     * Errors  CLOD_FAILED, as of the next two.
     */
    bool (*begin)(void *context, clod_state *state, size_t grains, bool *takes,
                  clod_status *status);

    /** Take the rows of the state from `kept` on; some of them may stay, behind the ones before. */
    bool (*grains)(void *context, clod_state *state, size_t kept, clod_status *status);

    /**
     * Take some contacts, when all grains have been taken.
     *
     * @param partners  [count] ids of both grains; id of the grain and number of the wall
     */
    bool (*contacts)(void *context, const clod_contact *contacts, const uint64_t (*partners)[2],
                     size_t count, clod_status *status);
} clod_bed_taker;
