#pragma once
/**
 * @file posterior.h
 * What measured targets tell about parameters: the posterior from surrogates, its samples and what
 * follows from them. docs/theory/calibration.md has the equations.
 */

#include "calibrate/misfit.h"
#include "calibrate/plan.h"
#include "calibrate/stop.h"
#include "calibrate/surrogate.h"

#define CLOD_POSTERIOR_WHY 200      ///< bytes of a reason
#define CLOD_POSTERIOR_DRAWS 64     ///< of the hyperparameters of a surrogate, at most
#define CLOD_POSTERIOR_LEAST_Q2 0.5 ///< of a surrogate that predicts points that are left out

/** Of R-hat: chains with more lie apart, and tell nothing. The variance of all is then above 2.25 times that within a
 *  chain; chains that agree have 1.1 at most (Gelman et al. 2013, 11.5). */
#define CLOD_POSTERIOR_APART 1.5
#define CLOD_POSTERIOR_CHAINS 4

/** Runs so far: [points][seeds] of them, in this order. */
typedef struct clod_posterior_runs {
    const clod_plan *plan;
    size_t points;
    const double *places;  ///< [points][parameters], in [0, 1]
    const double *results; ///< [points][seeds][targets], SI; NAN: failed, or not defined
    const clod_stop *stop; ///< asked while a posterior is made of them; NULL: never
} clod_posterior_runs;

typedef struct clod_posterior_target {
    clod_surrogate *surrogate; ///< likeliest, owned; NULL: held back, and none from the runs
    clod_surrogate *draws[CLOD_POSTERIOR_DRAWS]; ///< owned; NULL without surrogate
    double independent;                          ///< so many of them count as that
    char why[CLOD_POSTERIOR_WHY];                ///< they do not
    size_t runs;                                 ///< that have the number
    clod_surrogate_check check;
    bool checked;
    bool held_back;
    /** Of the model, over the posterior; this and the next: NAN without surrogate. Means, intervals and the card's value of an
     *  amount end at 0. */
    double mean;
    double low, high; ///< interval of what a laboratory would measure
    double off;       ///< (measured - mean) over its standard deviation
    double at_card;   ///< of the model, at the place of the card; NAN as the mean
    double unsure;    ///< standard deviation of what the surrogate does not know of that
} clod_posterior_target;

/** All in [0, 1] of the range. */
typedef struct clod_posterior_parameter {
    double mean, deviation, low, high;
    double
        width; ///< interval over that of the range alone; above 1 where samples are at both ends
    double
        moved; ///< most that a used target's surrogate changes over the range, others at their means, over the
    ///< deviation of that change
    double rhat, effective;
    double below,
        above; ///< share of the samples in the lowest and the highest 5 % of the range
} clod_posterior_parameter;

typedef struct clod_posterior {
    size_t dimensions, target_count;
    size_t draws;                         ///< of each surrogate
    clod_posterior_target *targets;       ///< [target_count] owned
    clod_posterior_parameter *parameters; ///< [dimensions] owned
    double *correlation;                  ///< [dimensions][dimensions] owned
    double *samples;                      ///< [count][dimensions] owned
    double *card;      ///< [dimensions] owned; one place near the means that meets the targets
    bool card_is_mean; ///< it is that of the means
    size_t *chosen;    ///< [count][used] draws of the used targets' surrogates, in order; owned
    size_t count;
    double accepted;
    double missed;              ///< share of the population that lies beyond all samples
    double chi_square, p_value; ///< posterior predictive, of the targets that are used
    size_t used;                ///< targets
    bool
        apart; ///< chains lie apart, or leave out a part of their population: numbers of parameters and targets are NAN, but for R-hat,
    ///< effective and what is known without samples; p and chi-square are the means over all chains
    bool predictive;     ///< the surrogate of one at least predicts points that are left out
    clod_misfit *misfit; ///< owned
} clod_posterior;

/**
 * Fit surrogates, sample, and look at the samples.
 *
 * @return  owned (clod_posterior_destroy), or NULL
 * Errors  CLOD_FAILED: a used target that too few runs define; memory; CLOD_INTERRUPTED.   Threads  safe.
 * Source  Kennedy and O'Hagan, J. R. Stat. Soc. B 63 (2001) 425, with the discrepancy's variance given;
 *         Gelman et al., Bayesian Data Analysis (2013), 6.3 (posterior predictive p value).
 * Test    tests/calibrate/test_posterior.c, test_coverage.c
 */
clod_posterior *clod_posterior_create(const clod_posterior_runs *runs, clod_status *status);

void clod_posterior_destroy(clod_posterior **self);

/** Standard deviation between packings of a target's number, where the parameters have their means; NAN without
 *  a surrogate. */
double clod_posterior_noise(const clod_posterior *self, size_t target);

/** Sample number i of so many that are spread evenly over all samples of all chains: its place. */
const double *clod_posterior_sample(const clod_posterior *self, size_t i, size_t of);

/** What the surrogate of a target says at a place, over all draws of what it does not know.
 *  @param room  clod_posterior_room */
clod_surrogate_value clod_posterior_told(const clod_posterior *self, size_t target,
                                         const double *place, double *room);

/**
 * Where further runs stand for the posterior: of 400 samples the one that leaves the least mean distance of a sample to
 * the nearest point, that of runs that are done or that one; then the next. Places differ as long as samples do.
 *
 * @param places  [done + count][dimensions]: those of the runs that are done; behind them [out] the further ones
 * @param stop    asked on the way; NULL: never
 * Errors  CLOD_INTERRUPTED.   Threads  safe.
 * Source  Flury, Biometrika 77 (1990) 33 (points that stand for a distribution), here one after the other.
 * Test    tests/calibrate/test_posterior.c
 */
bool clod_posterior_refine(const clod_posterior *self, double *places, size_t done,
                           size_t count, const clod_stop *stop, clod_status *status);

/** Variance of a measured value about the mean of packings, without the surrogate's. */
double clod_posterior_variance(const clod_plan_target *target);

/** Room for a prediction of any surrogate; owned (clod_memory_free), NULL without memory. */
double *clod_posterior_room(const clod_posterior *self);
