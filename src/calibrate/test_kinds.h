#pragma once
/**
 * @file test_kinds.h
 * What differs between kinds of case as tests of a calibration: one row each.
 */

#include "calibrate/number.h"

#define CLOD_PLAN_TABLES 3 ///< kinds of measured table that a test takes, at most

struct clod_plan_table;

typedef struct clod_test_kind {
    const char *name;           ///< for people, "wall friction test"; NULL: it is no test
    const clod_number *numbers; ///< [number_count]; NULL: it is no test
    size_t number_count;
    bool paths; ///< a number may be any path of the summary; `numbers` has rows by how it ends

    /** Packings that a case asks for by itself. */
    int64_t (*seeds)(const clod_case *from);

    /** Whether a case has a normal stress; NULL: none of its numbers has one. */
    bool (*has_stress)(const clod_case *from, double stress);
    const char *without_stress; ///< what a stress is that it has not

    /** Values of all targets of a test; as clod_number_read. */
    bool (*read)(const clod_plan *plan, size_t test, const char *folder, double *values,
                 double *stresses, clod_status *status);

    /** Of measured points, ended by NULL where there are fewer. */
    const struct clod_plan_table *tables[CLOD_PLAN_TABLES];
} clod_test_kind;

/** Row of a kind of case; borrowed. Threads  pure.   Test  tests/calibrate/test_calibrate.py */
const clod_test_kind *clod_test_kinds_row(clod_case_kind kind);

/** Row of a case; borrowed. Threads  pure.   Test  tests/calibrate/test_test_kinds.c */
const clod_test_kind *clod_test_kinds_of(const clod_case *from);
