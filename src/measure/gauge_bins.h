#pragma once
/**
 * @file gauge_bins.h
 * The stream in a gauge, bin by bin along a direction: its lower and upper edge, its mass and
 * the mean height of that. Along `across` this is the cross-section of the load, along
 * `direction` the path of the stream.
 */

#include "clod/case.h"
#include "measure/gauge.h"

/** Sums over samples; plain data. Heights are x.up [m]. */
typedef struct clod_gauge_bins {
    double samples;
    double seen[CLOD_CASE_GAUGE_BINS];   ///< samples at which there was something
    double lower[CLOD_CASE_GAUGE_BINS];  ///< m, of the lowest height at each of those
    double upper[CLOD_CASE_GAUGE_BINS];  ///< m, of the largest
    double mass[CLOD_CASE_GAUGE_BINS];   ///< kg
    double moment[CLOD_CASE_GAUGE_BINS]; ///< kg m, of mass and height of the grains' centres
} clod_gauge_bins;

/** A direction cut into bins. */
typedef struct clod_gauge_axis {
    clod_vec3 along; ///< unit
    double low;      ///< m, x.along where the first bin begins
    double width;    ///< m, of a bin
    int count;
} clod_gauge_axis;

/** Cut a gauge into bins along a unit vector. Threads: pure. */
clod_gauge_axis clod_gauge_axis_of(const clod_gauge *gauge, clod_vec3 along, int64_t count);

/** One bin in one sample. */
typedef struct clod_gauge_slice {
    clod_exact mass, moment;
    double lower, upper;
    bool seen;
} clod_gauge_slice;

/**
 * Add a grain to the slices [axis->count] of a sample, which are all zero at first. One that reaches over several bins is in each with what of the sphere is there;
 * what reaches beyond the ends counts in the first and last bin.
 *
 * @param position  x, y, z, radius [m]
 * @param mass      kg
 */
void clod_gauge_bins_add(clod_gauge_slice *slices, const clod_gauge *gauge,
                         const clod_gauge_axis *axis, const double position[4], double mass);

/** Add another slice of the same bin. */
void clod_gauge_bins_merge(clod_gauge_slice *self, const clod_gauge_slice *other);

/** Add a sample to the sums. */
void clod_gauge_bins_take(clod_gauge_bins *self, const clod_gauge_axis *axis,
                          const clod_gauge_slice *slices);

/** Means of one bin. */
typedef struct clod_gauge_bin {
    double at;           ///< m, x.along of its middle
    double share;        ///< of the samples at which there was something
    double lower, upper; ///< m, means over those; NAN when there were none
    double mean;         ///< m, mean height by mass; NAN of nothing
    double mass;         ///< kg, mean over all samples
} clod_gauge_bin;

/** Means of bin k. Threads: pure. */
clod_gauge_bin clod_gauge_bins_of(const clod_gauge_bins *self, const clod_gauge_axis *axis,
                                  int k);

/** Cross-section of a load. */
typedef struct clod_gauge_section {
    double area;      ///< m2, between lower and upper edges, mean over the samples
    double width;     ///< m, of the bins that hold something at half of the samples or more
    double surcharge; ///< rad, slope at the edges of the parabola that fits their upper edges
                      ///< best; NAN with fewer than three such bins
} clod_gauge_section;

/**
 * Cross-section that the bins across a load have.
 *
 * Threads  pure.
 * Source   ISO 5048: the load above the edges is a parabola of area width^2 tan(surcharge)/6
 * Test     tests/measure/test_gauge.c
 */
clod_gauge_section clod_gauge_bins_section(const clod_gauge_bins *self,
                                           const clod_gauge_axis *axis);
