#pragma once
/**
 * @file begin.h
 * The state with which a case begins, whatever kind of case it is.
 */

#include "clod/case.h"
#include "state/state.h"

/**
 * Whether a case has grains of its own; one without is for a program that adds them.
 * Errors  CLOD_USAGE: it has none.   Threads  pure.   Test  tests/sim/test_sim_change.c
 */
bool clod_begin_has_grains(const clod_case *from, clod_status *status);

/**
 * Grains that a case will have for one seed, without making one; those of files do not count.
 *
 * @param share  of the grains of a free run, that this machine has to hold; 0: none
 * Errors  CLOD_USAGE: more than this machine can hold; an inlet that opens when the run has ended.
 * Threads pure.
 * Test    tests/setup/test_setup_amount.c
 */
bool clod_begin_expect(const clod_case *from, double share, double *grains,
                       clod_status *status);

/** Grains that fill the cell of the case's tester, whatever number it asks for. */
bool clod_begin_fill(const clod_case *from, double *grains, clod_status *status);

/**
 * A state as of clod_begin_state with about `most` of its grains, for estimates of a case that
 * has too many: every group has its share. Grains of files are all there.
 *
 * @param expected  number of grains of the whole case
 */
bool clod_begin_sample(const clod_case *from, double expected, double most, clod_state *state,
                       clod_status *status);

/**
 * Build the cell of the case's tester, or the state of its free run.
 *
 * @param seed   of sizes and positions
 * @param state  [out] owned by the caller (clod_state_fini), also after a failure
 * Errors  CLOD_USAGE: it cannot be built; CLOD_FAILED.   Threads  pure.
 * Test    tests/sim/test_check_uniaxial.c, tests/sim/test_check.c
 */
bool clod_begin_state(const clod_case *from, int64_t seed, clod_state *state,
                      clod_status *status);
