#pragma once
/**
 * @file continuum_sums.h
 * The sums of one sample of a field: grains and branches of contacts are spread over its points.
 * They are in fixed point (parallel/fixed.h): the order of grains and contacts does not matter.
 */

#include "measure/continuum.h"
#include "parallel/fixed.h"

/** Sums in fixed point of one point, eight columns each. */
#define CLOD_CONTINUUM_BLOCKS                                                                  \
    ((CLOD_CONTINUUM_SUMS + CLOD_FIXED_COLUMNS - 1) / CLOD_FIXED_COLUMNS)

/** The sums of one point; all zero: of nothing. */
typedef struct clod_continuum_point {
    clod_fixed sum[CLOD_CONTINUUM_BLOCKS];
    _Alignas(64) int64_t addends; ///< since the last carry
} clod_continuum_point;

typedef struct clod_continuum_sums {
    const clod_continuum *field; ///< borrowed
    double weight;               ///< 1/m3, of a region
    clod_continuum_point *point; ///< [clod_continuum_points] borrowed
} clod_continuum_sums;

/** Sums of a field in these points. */
clod_continuum_sums clod_continuum_sums_of(const clod_continuum *field,
                                           clod_continuum_point *points);

/**
 * Add a grain.
 *
 * @param at   centre or an image of it [m]
 * @param sum  [CLOD_CONTINUUM_GRAIN_SUMS] for a kernel of 1/m3
 * Threads  one per sums.
 */
void clod_continuum_sums_grain(clod_continuum_sums *self, const double at[3],
                               const double *sum);

/**
 * Add the stress of a contact.
 *
 * @param from, to  ends of the branch, or of an image of it [m]
 * @param force     N, on what is at `to`
 */
void clod_continuum_sums_branch(clod_continuum_sums *self, const double from[3],
                                const double to[3], const double force[3]);

/** Add the force of a wall [N] at a point of contact, or an image of it [m]. */
void clod_continuum_sums_push(clod_continuum_sums *self, const double at[3],
                              const double force[3]);

/** Whether anything within a box reaches a point of the field: to leave out what does not. */
bool clod_continuum_sums_reached(const clod_continuum_sums *self, const double low[3],
                                 const double high[3]);

/** After the last addend: points can be merged and taken. */
void clod_continuum_sums_end(clod_continuum_sums *self);

/** Add a point of other sums; both have ended. */
void clod_continuum_sums_merge(clod_continuum_point *into, const clod_continuum_point *from);

/** Add what there is in points to `to` [points]. */
void clod_continuum_sums_take(const clod_continuum_point *point, int64_t points,
                              double (*to)[CLOD_CONTINUUM_SUMS]);
