#pragma once
/**
 * @file mixing.h
 * Lacey's mixing index of two kinds of grains. The grains of each cell are a sample.
 *
 *     index = (S0^2 - S^2)/(S0^2 - Sr^2)
 *
 * with p the share of the first kind among all N grains, p_k and n_k those of sample k of K:
 *
 *     S^2  = sum n_k (p_k - p)^2/N        variance between the samples, weighted by their size
 *     S0^2 = p (1 - p)                    that of a mixture in which each sample is of one kind
 *     Sr^2 = p (1 - p)/n                  that of a random mixture; n = (N - 1)/(K - 1) grains a
 *                                         sample, so that its mean is exactly this
 *
 * 0: segregated; 1: as well as by chance, within the scatter of that.
 *
 * Source  P. M. C. Lacey, J. Appl. Chem. 4 (1954) 257, doi:10.1002/jctb.5010040504; docs/mixing.md.
 * Test    tests/measure/test_mixing.c
 */

#include <stddef.h>
#include <stdint.h>

/** Grains of a sample. */
typedef struct clod_mixing_sample {
    int64_t grains, first; ///< all; of the first kind
} clod_mixing_sample;

typedef struct clod_mixing {
    double index;      ///< NAN of one kind, of one sample, or of one grain in each
    double variance;   ///< S^2; NAN of no grain
    double segregated; ///< S0^2
    double random;     ///< Sr^2; NAN of one sample
    double share;      ///< p
    double grains;     ///< mean of a sample that has some
} clod_mixing;

/** The index of samples, of which some may be empty. Threads: pure. */
clod_mixing clod_mixing_of(const clod_mixing_sample *samples, size_t count);
