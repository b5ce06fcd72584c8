#pragma once
/**
 * @file steady.h
 * Is preshear steady? Decided on block averages of shear stress and specimen height.
 *
 * Samples are averaged in blocks. After every block, windows of the last w blocks are looked
 * at, from as many as are kept down to `blocks_needed`; the signal is steady when one of them
 * satisfies, for shear stress and height, each with its tolerance t, with m the mean over the
 * window, D the change across it by a straight line fitted to the block averages, and e_D the
 * standard error of D:
 *
 *     |D| <= t |m|       what is left of a trend is small,
 *     |D| <= t |m| / 2   when it is a trend for sure (|D| > 2 e_D), for it will go on,
 *     e_D <= 1.5 t |m|   and the blocks are able to tell; a noisy signal needs more of them.
 *
 * Without the last condition noise hides a trend by luck: an approach that decays over 4 blocks
 * ends 3.5 % too early at a noise of 3 % per block and a tolerance of 2 %, instead of 2 %. An
 * approach that decays over more blocks than the window has is always cut off early, by a few
 * times t: make blocks as long as the material needs.
 *
 * The height has a tolerance of its own, INFINITY when it is not to decide. A fifth of that of
 * the shear stress asks for the critical state: 0.4 % of 40 mm over 10 mm of shear is a rate of
 * dilation of 1.6 %, whose share of tau/sigma is of the order of 2 %.
 * The largest such window gives mean and standard error. Blocks must be longer than the
 * signal's correlation; then their averages count as independent, and the scatter of the
 * averages has the correlation of the samples in it.
 */

#include <stdbool.h>
#include <stdint.h>

#define CLOD_STEADY_MAX 64 ///< blocks kept
#define CLOD_STEADY_MIN 3  ///< fewest blocks that have a trend with an error

/** Detector; plain bytes without pointers or gaps, as a checkpoint wants it. */
typedef struct clod_steady {
    int64_t blocks_needed;
    int64_t samples_per_block;
    double tolerance;                 ///< relative, of the shear stress
    double height_tolerance;          ///< relative; INFINITY: the height does not decide
    int64_t samples;                  ///< in the block that is being filled
    double sum[3];                    ///< of them: tau, height, sigma
    int64_t block_count;              ///< full blocks so far
    int64_t window;                   ///< blocks of the steady window, 0 when not steady
    double block[3][CLOD_STEADY_MAX]; ///< averages; block b is kept at b % CLOD_STEADY_MAX
} clod_steady;

/** Mean over a window of blocks. */
typedef struct clod_steady_mean {
    double value;
    double error; ///< standard error of the mean
    double trend; ///< change across the window by the fitted line, from first to last block
    double trend_error; ///< its standard error
    double end;         ///< of the fitted line, where the last block ends
    double end_error;   ///< its standard error
} clod_steady_mean;

/** What the detector found. */
typedef struct clod_steady_result {
    bool steady;
    int64_t blocks; ///< averaged: the steady window, else the last blocks_needed (or fewer)
    clod_steady_mean tau, height, sigma; ///< NAN without blocks; errors with fewer than three
} clod_steady_result;

/**
 * Start a detector.
 *
 * @param blocks_needed      fewest blocks that must agree, CLOD_STEADY_MIN to CLOD_STEADY_MAX
 * @param samples_per_block  >= 1
 * @param tolerance          t of the shear stress, > 0, relative
 * @param height_tolerance   t of the height, > 0, relative; may be INFINITY
 * Errors  none.   Threads  pure.   Test  tests/measure/test_steady.c
 */
void clod_steady_init(clod_steady *self, int64_t blocks_needed, int64_t samples_per_block,
                      double tolerance, double height_tolerance);

/**
 * Take one sample.
 *
 * @param tau     shear stress, any unit
 * @param height  of the specimen, any unit
 * @param sigma   normal stress; decides nothing
 * @return        whether the signal was steady at the last full block
 */
bool clod_steady_add(clod_steady *self, double tau, double height, double sigma);

/** Means and errors as of the last full block. */
clod_steady_result clod_steady_summary(const clod_steady *self);
