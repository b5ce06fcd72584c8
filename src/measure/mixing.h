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
 * By mass p and p_k are shares of mass, M and M_k the masses, m that of a grain:
 *
 *     S^2  = sum M_k (p_k - p)^2/M
 *     S0^2 = p (1 - p)
 *     Sr^2 = (N/(N - 1)) (K - 1) ((1 - p)^2 A + p^2 B)/M^2
 *
 * with A = sum m^2 of the grains of the first kind, B that of the others. With equal masses it is the
 * Sr^2 above.
 *
 * Source  P. M. C. Lacey, J. Appl. Chem. 4 (1954) 257, doi:10.1002/jctb.5010040504; K. Stange,
 *         Chem. Ing. Tech. 26 (1954) 331, for Sr^2 by mass; docs/mixing.md derives it.
 * Test    tests/measure/test_mixing.c
 */

#include <stddef.h>
#include <stdint.h>

/** Grains of a sample. */
typedef struct clod_mixing_sample {
    int64_t grains, first; ///< all; of the first kind
} clod_mixing_sample;

/** Grains of a sample, weighed; in any unit of mass. */
typedef struct clod_mixing_weighed {
    int64_t grains;
    double mass[2];   ///< of the first kind, of the others
    double square[2]; ///< sums of the squares of the masses of their grains
} clod_mixing_weighed;

typedef struct clod_mixing {
    double index;      ///< NAN of one kind, of one sample, or of too few grains in each
    double variance;   ///< S^2; NAN of no grain
    double segregated; ///< S0^2
    double random;     ///< Sr^2; NAN of one sample
    double share;      ///< p; NAN of no grain
    double grains;     ///< mean of a sample that has some
} clod_mixing;

/** The index of samples, of which some may be empty. Threads: pure. */
clod_mixing clod_mixing_of(const clod_mixing_sample *samples, size_t count);

/** The index by mass, likewise. */
clod_mixing clod_mixing_of_mass(const clod_mixing_weighed *samples, size_t count);
