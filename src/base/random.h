#pragma once
/**
 * @file random.h
 * Random numbers as a pure function of (seed, purpose, item, draw): nothing to store in a
 * checkpoint, the same for any number of threads. Random123's Philox4x64-10 underneath.
 */

#include <stdint.h>

/** What the numbers are for; streams of different purposes are independent. */
typedef enum clod_random_purpose {
    CLOD_RANDOM_RADIUS = 1,
    CLOD_RANDOM_POSITION = 2,
    CLOD_RANDOM_VELOCITY = 3,
    CLOD_RANDOM_TEST = 4,
    CLOD_RANDOM_MEASURED = 5,  ///< errors of measured values
    CLOD_RANDOM_CALIBRATE = 6, ///< samples of calibrated parameters
    CLOD_RANDOM_STABILITY = 7, ///< start of the search for the fastest oscillation
} clod_random_purpose;

/**
 * Uniform random number in the open interval (0, 1).
 *
 * @param seed     seed of the case
 * @param purpose  stream
 * @param item     for instance the grain's id
 * @param draw     number of the draw for this item
 * @return         an odd multiple of 2^-53, never 0 or 1
 * Errors  none.   Threads  pure.
 * Source  Salmon et al. 2011 (Philox).   Test  tests/base/test_random.c
 */
double clod_random_uniform(uint64_t seed, clod_random_purpose purpose, uint64_t item,
                           uint64_t draw);

/**
 * Random number of the standard normal distribution.
 *
 * @param draw  first of the two draws that it takes
 * Errors  none.   Threads  pure.   Others as clod_random_uniform.
 * Source  Box and Muller, Ann. Math. Stat. 29 (1958) 610.   Test  tests/base/test_random.c
 */
double clod_random_normal(uint64_t seed, clod_random_purpose purpose, uint64_t item,
                          uint64_t draw);
