#pragma once
/**
 * @file job_steps.h
 * What the run loop asks of the step: how many threads, and what of the state it must bring.
 */

#include "sim/job.h"
#include "step/step.h"

/** Threads of the step; of several ranks each has one, unless somebody asked for more. */
int clod_job_threads(const clod_job *job);

/** After the planned steps: bring the state to what the procedure must see of it. */
bool clod_job_see(const clod_job *job, clod_step *step, clod_status *status);
