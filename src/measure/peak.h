#pragma once
/**
 * @file peak.h
 * Peak of a noisy shear curve, found while it is being sheared.
 *
 * The curve is averaged in CLOD_PEAK_BINS bins of equal displacement per window, and smoothed
 * by the mean of the last CLOD_PEAK_BINS bins: a moving average over `window` metres, centred.
 * A sample is the mean over the way since the sample before it, and counts by that way, in
 * every bin that it covers a part of: the average is over displacement, however many samples
 * fall into it and however they are spaced.
 * The peak is the largest value of the smoothed curve. It is passed when the curve was sheared
 * `beyond` metres further without a larger one. Curves that rise to a plateau and never fall
 * are not passed for as long as they rise: the caller stops at its own limit and takes the
 * largest smoothed value.
 *
 * A moving average lowers a sharp peak: a round one by window^2/24 times its curvature, one
 * with slopes a before and b behind it by window a b/(2 (a + b)). The largest value of a noisy
 * curve is too large, by one or two standard deviations of the smoothed curve. Choose the
 * window so that both are small.
 *
 * The standard error comes from the noise in the window of the peak: scatter of the bins about
 * a straight line, divided by the number of bins. Neighbouring bins are correlated, so this is
 * done with bins, pairs and fours of bins, and the largest counts (blocking; Flyvbjerg and
 * Petersen, J. Chem. Phys. 91 (1989) 461). It knows nothing of noise that is correlated over
 * more than the window, as of slip and stick: there the scatter of the points about the yield
 * locus, and of seeds, tells.
 */

#include <stdbool.h>
#include <stdint.h>

#define CLOD_PEAK_BINS 16

/** Detector; plain bytes without pointers or gaps, as a checkpoint wants it. */
typedef struct clod_peak {
    double window, beyond;         ///< m
    double at;                     ///< m, of the last sample; NAN before the first
    double way;                    ///< m, how much of the bin that is being filled is full
    double mean[3];                ///< over that way: displacement, tau, sigma
    int64_t bin_count;             ///< full bins so far
    double bin[3][CLOD_PEAK_BINS]; ///< averages; bin b is kept at b % CLOD_PEAK_BINS
    double smooth;                 ///< last value of the smoothed curve
    double place;                  ///< m, where that is
    double peak, peak_place, peak_error, peak_sigma;
} clod_peak;

/** What the detector found. */
typedef struct clod_peak_result {
    double tau;       ///< largest smoothed value; mean so far before a window is full, else NAN
    double tau_error; ///< standard error; NAN before a window is full
    double displacement; ///< m, where it is
    double sigma;        ///< mean normal stress over the window of the peak
    bool passed;
} clod_peak_result;

/**
 * Start a detector.
 *
 * @param window  displacement over which the curve is smoothed [m], > 0
 * @param beyond  displacement after which a peak that was not surpassed is the peak [m], > 0
 * Errors  none.   Threads  pure.   Test  tests/measure/test_peak.c
 */
void clod_peak_init(clod_peak *self, double window, double beyond);

/**
 * Take one sample; the first one says where the curve begins.
 *
 * @param displacement  m, never falling
 * @param tau           shear stress, any unit, its mean since the sample before
 * @param sigma         normal stress, alike; decides nothing
 * @return              whether the peak is passed
 */
bool clod_peak_add(clod_peak *self, double displacement, double tau, double sigma);

/** Peak so far. */
clod_peak_result clod_peak_summary(const clod_peak *self);
