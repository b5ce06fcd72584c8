#pragma once
/**
 * @file begin.h
 * The state with which a case begins, whatever kind of case it is.
 */

#include "clod/case.h"
#include "state/state.h"

/**
 * Build the cell of the case's tester, or the state of its free run.
 *
 * @param seed   of sizes and places
 * @param state  [out] owned by the caller (clod_state_fini), also after a failure
 * Errors  CLOD_USAGE: it cannot be built; CLOD_FAILED.   Threads  pure.
 * Test    tests/sim/test_check_uniaxial.c, tests/sim/test_check.c
 */
bool clod_begin_state(const clod_case *from, int64_t seed, clod_state *state,
                      clod_status *status);
