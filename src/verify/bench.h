#pragma once
/**
 * @file bench.h
 * What a test of the suite gets: a folder for its cases and curves, and the report it fills.
 */

#include "verify/report.h"

typedef struct clod_verify_bench {
    const char *directory;
    const char *test; ///< name of the test that runs
    clod_verify_report *report;
    struct clod_ranks *ranks; ///< for whole tests; or NULL
} clod_verify_bench;

/** How an expected value is compared. */
typedef struct clod_verify_expect {
    double value;
    double tolerance;
    bool relative;
    const char *source;
} clod_verify_expect;

/** Compare one quantity; the format names it, with its unit. */
bool clod_verify_bench_check(const clod_verify_bench *self, const clod_verify_expect *expect,
                             double got, clod_status *status, const char *format, ...)
    __attribute__((format(printf, 5, 6)));

/**
 * The quantity that was compared last is known to miss: a recorded miss, which is none in the
 * count of misses until it passes.
 *
 * @param reason  why; it stands beside the row
 */
void clod_verify_bench_record_miss(const clod_verify_bench *self, const char *reason);

/** The point of a curve that is furthest from what is expected there. */
typedef struct clod_verify_worst {
    double at, expected, got;
    double off; ///< |got - expected|/|expected|; -1: no point yet
} clod_verify_worst;

#define CLOD_VERIFY_WORST                                                                      \
    {                                                                                          \
        0.0, 0.0, 0.0, -1.0                                                                    \
    }

/**
 * The larger of the largest so far and a value; what is no number is the worst of all, and
 * stays. Threads  pure.   Test  tests/verify/test_bench.c
 */
double clod_verify_larger(double most, double value);

/** Offer a point of a curve: no number is off by most of all, and stays. */
void clod_verify_worst_offer(clod_verify_worst *self, double at, double expected, double got);

/** A curve in DIR/NAME.csv: the first column is x, the others are drawn over it. */
typedef struct clod_verify_curve clod_verify_curve;

/**
 * @param name    file name without .csv
 * @param header  column names with units, separated by commas
 * @return        owned curve (clod_verify_curve_close), or NULL
 */
clod_verify_curve *clod_verify_curve_open(const clod_verify_bench *bench, const char *name,
                                          const char *header, clod_status *status);

/** Add a row; NAN is written as an empty field. */
void clod_verify_curve_add(clod_verify_curve *self, const double *values, size_t count);

/** Close and null; false when anything could not be written. NULL inside is fine. */
bool clod_verify_curve_close(clod_verify_curve **self, clod_status *status);
