#pragma once
/**
 * @file continuum_sums.h
 * The sums of one sample of a field: grains and branches of contacts are spread over its points.
 * They are in fixed point (parallel/fixed.h): the order of grains and contacts does not matter.
 */

#include "measure/continuum.h"

typedef struct clod_continuum_sums clod_continuum_sums;

/** Of nothing yet; NULL without memory. `field` is borrowed. */
clod_continuum_sums *clod_continuum_sums_open(const clod_continuum *field);

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

/** Add what there is to `to` [clod_continuum_points][CLOD_CONTINUUM_SUMS]. */
void clod_continuum_sums_take(const clod_continuum_sums *self,
                              double (*to)[CLOD_CONTINUUM_SUMS]);

/** NULL is fine. */
void clod_continuum_sums_close(clod_continuum_sums **self);
