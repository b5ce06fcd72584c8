#pragma once
/**
 * @file ranks_check.h
 * What of a case can be computed on one rank only, so far: said before anything is written.
 */

#include "clod/case.h"
#include "clod/status.h"
#include "sim/job.h"

/** Log the hosts of several ranks, and warn where they have too few processors. */
void clod_ranks_tell_places(const clod_job_shared *sim);

/** Log what rank 0 has said to the others, and how long it waited for them. */
void clod_ranks_tell_work(const clod_job_shared *sim);

/**
 * Whether several ranks can run a case.
 *
 * Errors  CLOD_USAGE: names the key that they cannot.   Threads  pure.
 * Test    tests/cli/test_mpirun.py
 */
bool clod_ranks_check(const clod_case *from, clod_status *status);
