#pragma once
/**
 * @file job_bed.h
 * What the log says of a job's bed at the end of every phase and of the job, and the results then.
 */

#include "sim/job.h"
#include "step/step.h"

/** Measure contacts and largest stable step at the end, before the step that has them is gone;
 *  false without memory. */
bool clod_job_measure_bed(clod_job *job, clod_step *step, clod_status *status);

/** The largest stable step of a job that was finished before; false without memory. */
bool clod_job_measure_finished(clod_job *job, clod_status *status);

/** Into the log: a phase is over, why, and the largest stable step of the bed then; false without
 *  memory. */
bool clod_job_log_phase(clod_job *job, clod_step *step, const char *before, const char *after,
                        clod_status *status);

/** Into the log: the job is over, with what clod_job_measure_bed has found. */
void clod_job_log_end(const clod_job *job, const clod_step *step, bool ok,
                      const clod_status *status);

/** Warn at the beginning of an included card that was calibrated with another solid, or in vain (config/grain_solid.h). */
void clod_job_bed_tell_solid(const clod_job *job);
