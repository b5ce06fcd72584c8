#pragma once
/**
 * @file ranks_log.h
 * What log.jsonl tells of several ranks. With one there is nothing to tell.
 *
 * Test  tests/parallel/test_mpirun_limits.py
 */

#include "sim/job.h"

/** Log the hosts of all ranks, and warn where they have too few processors. */
void clod_ranks_log_places(const clod_job_shared *sim);

/** Log what rank 0 has said to the others and how long it waited for them, and how even the work of
 *  all ranks was. */
void clod_ranks_log_work(const clod_job_shared *sim);
