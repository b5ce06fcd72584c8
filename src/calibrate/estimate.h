#pragma once
/**
 * @file estimate.h
 * What a calibration will take, before its first run: each test's case in the middle of all ranges, by the
 * preflight of `clod check`.
 */

#include "base/warning_list.h"
#include "calibrate/plan.h"

typedef struct clod_estimate {
    double each;   ///< s of a point on the clock: all its runs, side by side
    double points; ///< that fit the budget, or that are asked for
    size_t least;  ///< that the parameters need
    double fits;   ///< s of one processor: the fits of all targets, behind the runs
} clod_estimate;

/**
 * Estimate it.
 *
 * @param workers   runs side by side, of one thread each
 * @param self      [out]
 * @param warnings  [out] what the preflight warns of, with the name of the test
 * Errors  as clod_check_report_make; CLOD_FAILED: memory.   Threads  safe.   Test  tests/calibrate/test_calibrate.py
 */
bool clod_estimate_make(const clod_plan *plan, int workers, clod_estimate *self,
                        clod_warning_list *warnings, clod_status *status);

/** Points that fit a budget where each takes so long [s], CLOD_PLAN_BUDGET_POINTS at most. Test  tests/calibrate/test_estimate.c */
double clod_estimate_points(const clod_plan *plan, double each);

/**
 * Time of the fits with so many points, within a factor of 2: of each target behind the design and behind each batch.
 *
 * @return  s of one processor
 * Source   docs/theory/calibration.md, Limits   Test  tests/calibrate/test_estimate.c
 */
double clod_estimate_fits(const clod_plan *plan, double points);

#define CLOD_ESTIMATE_WORDS 32

/** A time on the clock in words: "0.44 s", "152 s", "25 min", "2 h 05 min", "2.0 days". */
const char *clod_estimate_clock(double seconds, char words[CLOD_ESTIMATE_WORDS]);

/** Whether a budget is so small that even an estimate, which may be off, says that the parameters' points do not fit:
 *  they take more than three times as long. Test  tests/calibrate/test_estimate.c */
bool clod_estimate_hopeless(const clod_estimate *self, const clod_plan *plan);

/** It in words; a warning where the budget is too small for the parameters, the text of an error where it is hopeless. */
void clod_estimate_text(const clod_estimate *self, const clod_plan *plan, int workers,
                        char *text, size_t size);
