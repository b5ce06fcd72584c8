#pragma once
/**
 * @file requests.h
 * What state->changes asks for, checked as a whole before anything is changed.
 */

#include "law/law.h"
#include "state/state.h"

/** The requests by rows and numbers. */
typedef struct clod_requests {
    int64_t *lost_row;  ///< [lost_grains] of the grains that go; owned, as the next
    int32_t *wall_rank; ///< [walls] new number of each wall, -1: it goes; NULL: all stay
} clod_requests;

/**
 * Sort the queue by ids and names, so that the order of requests changes no bit, and look
 * everything up.
 *
 * @param found  [out] clod_requests_fini, also after a failure
 * Errors  CLOD_USAGE: a grain or wall that goes and is not there, one that comes and cannot be:
 *         the text says which and why. CLOD_FAILED: memory.
 * Threads one per state.   Test  tests/step/test_leave.c (wrong ones), test_change.c
 */
bool clod_requests_check(clod_requests *found, clod_state *state, const clod_laws *laws,
                         clod_status *status);

/**
 * Whether no grain has one of the ids of grains that are to come.
 *
 * Errors  CLOD_USAGE: names the first that one has; CLOD_FAILED without memory.
 * Threads one per state.   Test  tests/step/test_ranks.c
 */
bool clod_requests_check_ids(const clod_grains *grains, const uint64_t *ids, size_t count,
                             clod_status *status);

void clod_requests_fini(clod_requests *self);
