#pragma once
/**
 * @file free_run.h
 * A case with grains, walls and stages of its own: each stage sets walls and adhesion and lasts
 * its time, or until the grains are at rest.
 */

#include "sim/job.h"

/** Run all stages; the report lists the walls' last forces. */
bool clod_free_run(const clod_job_shared *sim, char **report, clod_status *status);
