#pragma once
/**
 * @file crew.h
 * Ranks that step one bed. Rank 0 has the job and a state of the whole bed; every rank, this one
 * too, steps its part. The others wait for orders (clod_crew_serve). The whole state is gathered
 * when somebody wants to see it (clod_step_see), sums over it are made where the grains are
 * (clod_step_survey); all else of it, walls and numbers, is told to all before steps and taken back
 * after them.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/step/test_ranks.c
 */

#include "measure/survey.h"
#include "step/spread.h"

typedef struct clod_crew clod_crew;

/**
 * Spread the bed of a step over all ranks.
 *
 * @param whole  its state is whole, or with options.dealt its rows are rank 0's share (crew_deal.h);
 *               contacts are in the state, and it has no lists, or loses them
 * @param first  nobody sees the state before clod_step_see, and its rows are forgotten as soon as the
 *               ranks have them; else they stay as they are, in the order of one process
 * @return       false: something that works on one rank only, or no memory; then none steps it
 * Errors  CLOD_USAGE, CLOD_FAILED.   Threads  rank 0; the others serve.
 */
bool clod_crew_begin(clod_step *whole, const clod_step_options *options, bool first,
                     clod_status *status);

/** As clod_step_advance. Threads: rank 0. */
bool clod_crew_advance(clod_crew *self, int64_t steps, clod_status *status);

/** Gather the whole state, if steps have been made since. Threads: rank 0. */
bool clod_crew_see(clod_crew *self, clod_status *status);

/** As clod_step_see_near. Threads: rank 0. */
bool clod_crew_see_near(clod_crew *self, const clod_domain_box *box, int count,
                        clod_status *status);

/** Bring the list of grains that have left. Threads: rank 0. */
bool clod_crew_see_gone(clod_crew *self, clod_status *status);

/** As clod_survey_ask, of a bed that is not gathered; after a failure the next steps fail with its
 *  status. Threads: rank 0. */
bool clod_crew_survey(clod_crew *self, const clod_survey_question *question,
                      clod_status *status);

/** Grains of all ranks. Threads: rank 0. */
size_t clod_crew_grains(const clod_crew *self);

/**
 * As clod_step_change: grains that come, and are checked, go to their ranks; for anything else the
 * bed is gathered, changed by rank 0, and dealt anew.
 *
 * @param whole  a step with a crew
 * @return       as clod_step_change; if the bed could not be dealt anew the step has failed for good
 *               and the crew may be gone. Threads: rank 0.
 */
bool clod_crew_change(clod_step *whole, clod_status *status);

/** As clod_step_renew, of a step with a crew; after a failure as clod_crew_change. Threads: rank 0. */
bool clod_crew_renew(clod_step *whole, clod_status *status);

/** As clod_step_store, of the whole bed. Threads: rank 0. */
void clod_crew_store(clod_crew *self, clod_step_stored *sums);

/** The ranks are free for another bed; NULL is fine, and nulled. Threads: rank 0. */
void clod_crew_end(clod_crew **self);

/** Do what rank 0 orders, until clod_crew_dismiss. Threads: all but rank 0. */
void clod_crew_serve(clod_ranks *ranks);

/** Let the others return from clod_crew_serve. Threads: rank 0. */
void clod_crew_dismiss(clod_ranks *ranks);
