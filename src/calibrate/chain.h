#pragma once
/**
 * @file chain.h
 * Samples of a probability density in the unit cube: adaptive Metropolis with steps along the differences of a
 * population, several chains, and how well they agree.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "calibrate/stop.h"

#define CLOD_CHAIN_MOST 32 ///< dimensions

/** Logarithm of the density at a point inside the cube and at whole numbers beside it, up to a constant;
 *  -INFINITY: none. */
typedef double (*clod_chain_density)(void *context, const double *point, const size_t *choices);

typedef struct clod_chain_setup {
    size_t dimensions;
    size_t chains;
    size_t warm_up; ///< steps in which the proposals adapt; not kept
    size_t kept;    ///< samples of each chain
    size_t choices; ///< whole numbers that are sampled beside the point; mostly 0
    size_t options; ///< each of them is below this, and all are as likely before the density
    const double *start; ///< where all chains begin; NULL: at members of the population
    const struct clod_population
        *population; ///< of this density; NULL: no steps but the normal ones
    uint64_t seed;
    uint64_t stream; ///< of the first chain's random numbers; the next chain has the next one
    clod_chain_density density;
    void *context;
    const clod_stop *stop; ///< asked before every density; NULL: never
} clod_chain_setup;

/**
 * Sample. Proposals are normal with the chain's own covariance, times a scale that brings the accepted
 * share near 0.3; both are found in the warm-up and fixed afterwards. With a population each chain starts at a member of
 * it, and each normal step is followed by four along differences of two members: to another summit, or along a ridge;
 * in every second one a whole number is drawn anew, too. Then one of the whole numbers is drawn anew and accepted by the
 * ratio of the densities, each in its turn.
 *
 * @param samples   [out] [chains][kept][dimensions]
 * @param chosen    [out] [chains][kept][choices]; NULL without choices
 * @param accepted  [out] share of accepted normal steps after the warm-up, of all chains
 * @return  false when `stop` was asked for; the samples are then of no use
 * Errors  none.   Threads  safe.
 * Source  Haario, Saksman and Tamminen, Bernoulli 7 (2001) 223; Andrieu and Thoms, Stat. Comput. 18 (2008)
 *         343, algorithm 4; along differences: ter Braak and Vrugt, Stat. Comput. 18 (2008) 435.
 * Test    tests/calibrate/test_chain.c
 */
bool clod_chain_run(const clod_chain_setup *setup, double *samples, size_t *chosen,
                    double *accepted);

/** Samples of one coordinate: chain k has [kept] of them at `values + k * kept * stride`, `stride` apart.
 */
typedef struct clod_chain_series {
    const double *values;
    size_t chains, kept, stride;
} clod_chain_series;

/** Split R-hat: spread of all half chains over that within them; 1 when they agree,
 *  INFINITY when none has moved.
 *  Source  Gelman et al., Bayesian Data Analysis, 3rd edition (2013), 11.4. */
double clod_chain_rhat(const clod_chain_series *series);

/** Number of independent samples that would tell the mean as well.
 *  Source  the same, 11.5, with Geyer's sequence of falling pairs (Stat. Sci. 7 (1992) 473).
 *  @return  0 when no chain has moved; NAN without memory */
double clod_chain_effective(const clod_chain_series *series);
