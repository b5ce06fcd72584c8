#pragma once
/**
 * @file posterior_card.h
 * One place for the card, and answers that lie apart.
 */

#include "calibrate/posterior.h"

/** What surrogates tell at some samples. */
typedef struct clod_posterior_sight {
    size_t looked;                    ///< samples, spread evenly over all
    const clod_surrogate_value *told; ///< [looked][targets]
    double *room;                     ///< clod_posterior_room
} clod_posterior_sight;

/**
 * Choose the card's place: the means, as long as they do not miss the used targets by more than nine of ten samples do;
 * else the sample nearest to them, in deviations, of the tenth that misses the targets least. On a bent ridge, or between
 * two answers, the means together are a place that no target allows. Fills `card`, `card_is_mean`, and of each target
 * `at_card` and `unsure`.
 *
 * Errors  CLOD_FAILED: memory.   Threads  safe.   Test  tests/calibrate/test_posterior_card.c
 */
bool clod_posterior_card_choose(const clod_plan *plan, const clod_posterior_sight *at,
                                clod_posterior *self, clod_status *status);

/** Two groups of samples with next to none between them. */
typedef struct clod_posterior_split {
    double share;        ///< of the samples below the gap
    double below, above; ///< their means
} clod_posterior_split;

/** Whether the samples of a parameter fall into two groups, of a twentieth of them at least: somewhere between two
 *  places there is a twentieth of the range with less than a tenth of the samples that either place has.
 *  Test  tests/calibrate/test_posterior_card.c */
bool clod_posterior_is_split(const clod_posterior *self, size_t k, clod_posterior_split *found);
