#pragma once
/**
 * @file free_run.h
 * A case with grains, walls and stages of its own: each stage sets walls and adhesion and lasts
 * its time, or until the grains are at rest.
 */

#include "sim/parts.h"

/** Run all stages; the report lists the walls' last forces. */
bool clod_free_run(const clod_job_shared *sim, char **report, clod_status *status);

/** Whether it can begin with what the other run has. Errors  see clod_origin_try. */
bool clod_free_try_origin(const clod_job_shared *sim, clod_status *status);

/** Its stages for a trial: no row is filled in, and nothing is kept of how they ended. */
extern const clod_parts_tester CLOD_FREE_TRIAL;
