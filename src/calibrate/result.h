#pragma once
/**
 * @file result.h
 * A finished calibration, and what is said beside it.
 */

#include "base/warning_list.h"
#include "calibrate/plan.h"
#include "calibrate/runs.h"
#include "calibrate/study.h"

typedef struct clod_result {
    const clod_plan *plan;
    const clod_study *study;
    const clod_runs *runs; ///< for how many failed, and the folder's path
    clod_warning_list warnings;
} clod_result;

/** What a posterior width says: 0.25 and 0.6 of the range's interval are the borders. */
typedef enum clod_result_identified {
    CLOD_RESULT_IDENTIFIED,     ///< the targets tell the parameter
    CLOD_RESULT_WEAKLY,         ///< they narrow its range a little
    CLOD_RESULT_NOT_IDENTIFIED, ///< they hardly do
    CLOD_RESULT_MISSED,         ///< the model does not give the targets, which so tell nothing
    CLOD_RESULT_APART,          ///< the Markov chains lie apart: there is no result
} clod_result_identified;
/** Of parameter k; weakly at best where no used target has a surrogate that predicts, and not at all where none changes
 *  by more than two deviations over the parameter's range. */
clod_result_identified clod_result_identified_of(const clod_posterior *self, size_t k);
/** Whether the targets are missed: the posterior predictive p is below 0.05. */
bool clod_result_missed(const clod_posterior *self);
/** Whether a target lies outside of the interval that is predicted for it; one that cannot be predicted does not. */
bool clod_result_misses(const clod_result *self, size_t target);
extern const char *const CLOD_RESULT_IDENTIFIED_NAMES[];

/** What is known of a card and its targets. */
typedef enum clod_result_verdict {
    CLOD_RESULT_MET,
    CLOD_RESULT_MISSES,
    CLOD_RESULT_UNTOLD, ///< surrogates know too little: p rises with what they do not know
} clod_result_verdict;
extern const char *const CLOD_RESULT_VERDICT_NAMES[];

/** Whether the surrogate of a target is sure enough at the card's values to tell whether that is met: to within the
 *  laboratory's error and discrepancy; or to within three of these, if it predicts points that are left out and explains as
 *  much of the runs' variance there (both: Q2 of 0.5).   Source  docs/theory/calibration.md, "Posterior".   Test  tests/calibrate/test_result_verdict.c */
bool clod_result_tells(const clod_plan_target *target, const clod_posterior_target *self);

/** Of the used targets: missed where p is below 0.05; of those held back: where one lies outside its interval. Else untold
 *  where a surrogate does not tell.
 *  @return whether there is such a target with a surrogate */
bool clod_result_verdict_of(const clod_result *self, bool held_back,
                            clod_result_verdict *verdict);

/** Warn of what is untold. */
void clod_result_verdict_warn(const clod_result *self, clod_warning_list *to);

/** Look for what is to be said: contradictions, ends of ranges, chains, surrogates, failed runs. */
void clod_result_warn(clod_result *self);

/** A quantile or mean in [0, 1] as text in the parameter's unit: "3.56e+08 N/m^1.5". */
const char *clod_result_number(const clod_plan_parameter *self, double place, char *buffer,
                               size_t size);

/** A number of a target as text in the unit of its measure, without it; "-" for one that is not there. */
const char *clod_result_measured(const clod_plan_measure *measure, double value, char *buffer,
                                 size_t size);

/** Tables for people; owned (clod_memory_free), NULL without memory; as the others. */
char *clod_result_table(const clod_result *self);

/** Everything, units in the names. */
char *clod_result_json(const clod_result *self);

/** The calibrated keys as a part of a case, with their intervals as comments. */
char *clod_result_card(const clod_result *self);

/** Samples of the posterior, for propagation: one row each. */
char *clod_result_samples(const clod_result *self);
