#pragma once
/**
 * @file verify.h
 * The verification suite: small cases whose result is known from a closed form or from the
 * literature, run with the engine of the simulations.
 *
 * Every case is written as a case file that `clod run` takes as well, then loaded and stepped.
 * docs/verification.md is the report of the last run.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A quantity that was compared. */
typedef struct clod_verify_row {
    char test[32];
    char quantity[128]; ///< what, with its unit
    char source[192];   ///< where the expected value comes from
    char known[256];    ///< why this row is known to miss: a recorded miss; "": it must not
    double expected, got;
    double tolerance; ///< largest |got - expected|, or that over |expected| when `relative`
    bool relative;
    bool passed; ///< set by the suite; a result that is no number never passes
} clod_verify_row;

typedef struct clod_verify_report {
    clod_verify_row *rows; ///< [count] owned
    size_t count, capacity;
    size_t misses; ///< rows that did not pass, or passed although a miss is recorded
    size_t known;  ///< recorded misses, which did not pass
    bool slow;     ///< of the slow tests: the report is validation.md
} clod_verify_report;

typedef struct clod_verify_options {
    const char *directory; ///< gets the report, curves as CSV, and the cases; made if need be
    const char *const *names; ///< [name_count] tests to run, all slow or none
    size_t name_count;        ///< 0 = all that are slow, or all that are not
    bool slow;                ///< the slow tests, of bulk solids; their report is validation.md
    struct clod_ranks *ranks; ///< that share the runs of whole tests (clod/ranks.h); or NULL
    void (*progress)(void *context, const char *name); ///< before each test; or NULL
    void *context;
} clod_verify_options;

/** Number of tests in the suite. */
size_t clod_verify_count(void);

/** Name of a test, k < clod_verify_count(); static text. */
const char *clod_verify_name(size_t k);

/** Whether a test takes minutes or more: a bulk solid, not a contact. */
bool clod_verify_is_slow(size_t k);

/** Name of the report's file: verification.md, or validation.md of the slow tests. */
const char *clod_verify_report_name(bool slow);

/** What a test looks at, in one line; static text. */
const char *clod_verify_help(size_t k);

/**
 * Run tests and write DIR/verification.md (or validation.md), a CSV per curve and the cases.
 *
 * @param options  which tests, and where to
 * @param report   [out] owned content (clod_verify_fini), also after a failure
 * @return         true when all tests ran; whether they passed is in report->misses
 * Errors  CLOD_USAGE: no test has this name (with a suggestion), or the one that has it is slow
 *         and `slow` is not set, or the other way round; CLOD_FAILED: disk, memory, or a case
 *         that the engine cannot run.   Threads  one per folder.
 * Test    tests/verify/, tests/cli/test_verify.py
 */
bool clod_verify_run(const clod_verify_options *options, clod_verify_report *report,
                     clod_status *status);

/** Free the content; an empty report is fine. */
void clod_verify_fini(clod_verify_report *self);

#ifdef __cplusplus
}
#endif
