#pragma once
/**
 * @file repeats.h
 * Rows of a flow function at one stress: repeats of a test, not more of the curve.
 */

#include "base/warning_list.h"
#include "hopper/curve.h"

#define CLOD_REPEATS_APART 0.02 ///< relative: no further apart, two stresses are one

/** The first point of the next stress: those no further apart than CLOD_REPEATS_APART have one. @param curve  sorted */
size_t clod_repeats_end(const clod_curve *curve, size_t first);

/**
 * The mean of points `first` to before `end`. Its error is that of their errors, with the smallest `freedom` of them, or of their
 * scatter, with `freedom` of it, if that is larger and no error comes of a line; of a single point its own.
 */
clod_curve_point clod_repeats_mean(const clod_curve *curve, size_t first, size_t end);

/**
 * Warn of repeats that differ by more than their errors tell; of those without, by more than a standard deviation of
 * 10 % of their mean tells. By chi-square (of specimens, Fisher's F), with a chance below 5 %.
 *
 * @param what  whose repeats: "Flow function"
 * Errors, threads  as clod_warning_list_add.   Test  tests/hopper/test_strength.py
 */
void clod_repeats_warn(const clod_curve *curve, const char *what, clod_warning_list *warnings);

/** Put the mean of repeats in their place; those that specimens move stay apart. @param curve  [in, out] sorted */
void clod_repeats_pool(clod_curve *curve);
