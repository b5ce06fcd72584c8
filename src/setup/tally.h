#pragma once
/**
 * @file tally.h
 * What setup asks of all grains, added up in the order of their ids: piece by piece it has the bits of a
 * whole list.
 *
 * Threads  pure.   Test  tests/sim/test_deal.c, tests/setup/test_setup_state.c
 */

#include "setup/bed.h"
#include "setup/timestep.h"

typedef struct clod_setup_tally {
    clod_setup_bed bed;
    clod_timestep_sizes *sizes; ///< [materials] owned
} clod_setup_tally;

/**
 * Begin.
 *
 * @param state   its walls and gravity
 * @param grains  there will be in all
 * @return        false without memory; clod_setup_tally_fini in any case
 */
bool clod_setup_tally_init(clod_setup_tally *self, const clod_case *from,
                           const clod_state *state, size_t grains, clod_status *status);

/** Add the grains of a state from `first` on. */
void clod_setup_tally_add(clod_setup_tally *self, const clod_state *state, size_t first);

void clod_setup_tally_fini(clod_setup_tally *self);
