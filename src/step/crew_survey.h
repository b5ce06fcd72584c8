#pragma once
/**
 * @file crew_survey.h
 * Sums over a bed that ranks step, made where its grains are (measure/survey.h).
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/step/test_ranks_survey.c
 */

#include "measure/survey.h"
#include "step/crew_part.h"

/**
 * What rank 0 asks, of all ranks.
 *
 * @param question  of rank 0; NULL on the others, which learn it
 * @return          false on all alike: no memory, or a crew that is broken
 */
bool clod_crew_part_survey(clod_crew *self, const clod_crew_order *what,
                           const clod_survey_question *question, clod_status *status);
