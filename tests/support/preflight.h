#pragma once
/**
 * @file preflight.h
 * The preflight of a tester's case with one change, for tests of one thread.
 */

#include <string.h>

#include "clod/check.h"
#include "support/case_of.h"

static clod_case *preflight_case; ///< the report borrows from it
static clod_check_report report;

/** Look at the case of a text, with one change or NULL. */
static inline void preflight(const char *text, const char *change)
{
    clod_status status = {CLOD_OK, ""};
    const clod_check_options options = {.threads = 1, .directory = "."};
    clod_case_destroy(&preflight_case);
    preflight_case = case_of(text, change);
    if (!clod_check_report_make(preflight_case, &options, &report, &status)) {
        fail_msg("%s", status.text);
    }
}

/** Look, and say whether there is a warning with these words. */
static inline bool preflight_warns(const char *text, const char *change, const char *words)
{
    bool found = false;
    preflight(text, change);
    for (size_t w = 0; w < report.warning_count; w++) {
        found = found || strstr(report.warning[w], words) != NULL;
    }
    return found;
}

/** Teardown of the group. */
static inline int preflight_end(void **state)
{
    (void)state;
    clod_case_destroy(&preflight_case);
    return 0;
}
