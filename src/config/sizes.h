#pragma once
/**
 * @file sizes.h
 * Radii of grains by inverse distribution: the radius of a grain follows from seed and id.
 */

#include <stdint.h>

#include "clod/case.h"

/** One class of a sieve table: its share of all grains by number. */
typedef struct clod_sizes_class {
    double before; ///< fraction of all grains that are in finer classes
    double share;  ///< fraction of all grains in this class
    double small;  ///< 1/D^3 at the fine end [1/m3]
    double large;  ///< 1/D^3 at the coarse end [1/m3]
} clod_sizes_class;

typedef struct clod_sizes {
    clod_size_kind kind;
    double min, max;           ///< m, of the radius
    double mean, sd;           ///< m, normal: before it is cut
    bool mirrored;             ///< normal: worked out on the side where probabilities are small
    double from, to;           ///< normal: probability below the two ends (of the mirrored one)
    clod_sizes_class *classes; ///< owned
    size_t class_count;
} clod_sizes;

/**
 * Get a distribution ready.
 *
 * normal: cut to [radius_min, radius_max], by number. uniform: between them, by number.
 * sieve: by mass; within a class the mass passing is linear in log D (as gradation curves are
 * drawn), so a class with the fraction q of the mass between D1 and D2 has by number a share in
 * proportion to q (D1^-3 - D2^-3)/ln(D2/D1), and 1/D^3 is uniform in it.
 *
 * @param self  [out] release with clod_sizes_fini, also after a failure
 * Errors  CLOD_USAGE: the interval holds nothing of the normal distribution; CLOD_FAILED.
 * Threads pure.   Test  tests/config/test_sizes.c
 */
bool clod_sizes_init(clod_sizes *self, const clod_case_grains *from, clod_status *status);

/** The truncated normal distribution alone. */
bool clod_sizes_init_normal(clod_sizes *self, double mean, double sd, double min, double max,
                            clod_status *status);

/** Radius [m] below which the fraction u of all grains is; 0 < u < 1. Threads: pure. */
double clod_sizes_quantile(const clod_sizes *self, double u);

/** Radius of a grain [m], from seed and id alone. Threads: pure. */
double clod_sizes_radius(const clod_sizes *self, uint64_t seed, uint64_t id);

/**
 * Mean volume of a grain [m3], the mean taken by number: exact for a sieve table and a uniform
 * distribution, to 1e-4 for a normal one.
 */
double clod_sizes_mean_volume(const clod_sizes *self);

/** Volume of the largest grain that there may be [m3]. */
double clod_sizes_largest_volume(const clod_sizes *self);

/**
 * Number of grains whose solid volume comes nearest to the one wanted, at least 1.
 *
 * @param first_id  the grains' ids are first_id, first_id + 1, ...
 * @param volume    m3
 * @param put       [out] volume of these grains [m3]
 */
size_t clod_sizes_count(const clod_sizes *self, uint64_t seed, uint64_t first_id, double volume,
                        double *put);

void clod_sizes_fini(clod_sizes *self);
