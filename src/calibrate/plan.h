#pragma once
/**
 * @file plan.h
 * The plan of a calibration: tests, parameters with ranges, measured targets, budget.
 * docs/howto/calibrate.md explains its keys.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/warning_list.h"
#include "clod/case.h"
#include "clod/status.h"
#include "config/settings.h"
#include "hopper/curve.h"
#include "sim/free_paths.h"

#define CLOD_PLAN_UNIT 32
#define CLOD_PLAN_FIGURES (-1) ///< digits of a number that may be of any size
#define CLOD_PLAN_NAME 144
#define CLOD_PLAN_PARAMETERS 12 ///< at most
#define CLOD_PLAN_POINTS 1000   ///< at most
#define CLOD_PLAN_BUDGET_POINTS                                                                \
    256 ///< that a budget buys at most: with more, surrogates are drawn less often
#define CLOD_PLAN_SPECIMENS 24 ///< of a measured point, whose differences are kept

/** A case that is run for each point; the fields after `path` come from the case. */
typedef struct clod_plan_test {
    char *name;        ///< owned
    char *path;        ///< of the case file, owned
    clod_setting *set; ///< [set_count] owned: keys that this test has otherwise than its case
    size_t set_count;
    clod_case *middle; ///< owned; the case with all parameters in the middle of their ranges
    clod_free_paths paths; ///< owned; numbers of its summary, of a free run
} clod_plan_test;

typedef struct clod_plan_parameter {
    char *name;              ///< owned
    char *key;               ///< as in --set
    clod_setting *multiples; ///< [multiple_count] owned: other keys, with a factor each
    size_t multiple_count;
    char *times; ///< name of the parameter whose value this one multiplies; NULL: none
    const struct clod_plan_parameter *base; ///< that parameter, in the plan; NULL: none
    char *from, *to;                        ///< as written
    int scale;                              ///< clod_plan_scale
    double low, high;                       ///< numbers of from and to
    char unit[CLOD_PLAN_UNIT];              ///< as written behind both; "": none
} clod_plan_parameter;

typedef enum clod_plan_scale { CLOD_PLAN_LINEAR, CLOD_PLAN_LOG } clod_plan_scale;

/** A target as written: of one number, or the points of a measured table. */
typedef struct clod_plan_wish {
    char *test, *number, *value, *error, *discrepancy;
    char *locus;          ///< path, resolved against the plan; NULL: number and value
    double normal_stress; ///< Pa; 0: none
    bool held_back;
} clod_plan_wish;

/** What a number of a test is measured in. */
typedef struct clod_plan_measure {
    const char *unit; ///< for people
    double factor;    ///< SI -> unit
    int digits;       ///< behind the point; CLOD_PLAN_FIGURES: four figures in all
} clod_plan_measure;

/** What a specimen has more than the mean of all specimens of a point; SI. */
typedef struct clod_plan_difference {
    int64_t specimen; ///< its `seed` in the table
    double value;
} clod_plan_difference;

/** The specimens of a measured point. */
typedef struct clod_plan_repeats {
    size_t count; ///< 0: the table does not tell; 1: there are no repeats
    bool
        estimate; ///< the error is estimated from how specimens scatter: it is not known, but in the mean
    bool pooled; ///< from those of all points of the table, not of this point alone
    clod_plan_difference differences[CLOD_PLAN_SPECIMENS]; ///< [count], the first of them
} clod_plan_repeats;

/** The part of an error that all shear points of one seed have in common: that of the mean preshear shear stress, by which
 *  they were prorated. */
typedef struct clod_plan_common {
    double error;   ///< SI; 0: none
    double degrees; ///< of freedom of its estimate
} clod_plan_common;

/** A target with its number; SI. */
typedef struct clod_plan_target {
    char name[CLOD_PLAN_NAME];   ///< for people, each its own: "ring: phi_e"
    char number[CLOD_PLAN_NAME]; ///< of the test
    size_t test;                 ///< index
    size_t entry;                ///< of the plan's `targets`, that it comes from
    size_t table;                ///< that it comes from, with others of its columns; 0: none
    double normal_stress;
    double value, error, discrepancy; ///< standard deviations
    clod_plan_repeats repeats;
    clod_plan_common common; ///< part of `error`
    bool held_back;
    clod_plan_measure measure;
    /** Measured, over sigma_1: a run's number goes along it from the run's own sigma_1 to normal_stress;
     *  NULL: it stays as it is. Borrowed from the plan. */
    const clod_curve *curve;
} clod_plan_target;

/** A measured curve that targets are on. */
typedef struct clod_plan_curve {
    clod_curve curve; ///< owned
    struct clod_plan_curve *next;
} clod_plan_curve;

typedef struct clod_plan_sampling {
    int64_t samples; ///< of each chain
    double level;    ///< of intervals
} clod_plan_sampling;

typedef struct clod_plan {
    char *title;
    double budget; ///< s on the clock, for CLOD_PLAN_BUDGET_POINTS at most; 0: points are given
    int64_t points; ///< 0: as many as the budget allows
    int64_t seeds, seed;
    clod_plan_test *tests;
    clod_plan_parameter *parameters;
    clod_plan_wish *wishes;
    size_t test_count, parameter_count, wish_count;
    clod_plan_sampling sampling;
    clod_plan_target *targets; ///< [target_count] owned
    size_t target_count;
    clod_plan_curve *curves;      ///< owned list; NULL: none
    struct clod_plan_locus *loci; ///< owned list, of measured yield loci (plan_loci.h)
    char *path, *text;            ///< owned: of its file
    clod_warning_list warnings;   ///< of its measured tables: wrong units or columns, as a rule
} clod_plan;

/**
 * Read a plan, the cases it names and the measured tables.
 *
 * @param overrides  [override_count] texts key.path=value in place of what the file says
 * @param self  [out] owned content (clod_plan_fini), also after an error
 * Errors  CLOD_USAGE with file, line, caret, value, allowed range and what to do: plan, cases with the
 *         ends of the ranges, tables; CLOD_FAILED: memory.
 * Threads safe.   Test  tests/calibrate/test_plan.c, test_calibrate_plan.py
 */
bool clod_plan_load(const char *path, const char *const *overrides, size_t override_count,
                    clod_plan *self, clod_status *status);

void clod_plan_fini(clod_plan *self);

/** A parameter's number at a place in [0, 1] of its range, in its own unit. */
double clod_plan_number(const clod_plan_parameter *self, double place);

/** Different points that this many parameters need at least: two a coefficient of a line, and one. */
size_t clod_plan_least_points(size_t parameters);

/** Points of the design among so many points: two thirds, and as many as the parameters need at least. */
size_t clod_plan_design_points(size_t parameters, size_t points);

/** A key of a parameter: its own, with m = 0, or that of its m-th multiple. */
const char *clod_plan_key(const clod_plan_parameter *self, size_t m);

/** Factor of a parameter's key: 1 of its own.   Test  tests/calibrate/test_plan_set.c */
double clod_plan_factor(const clod_plan_parameter *self, size_t m);

/**
 * What a key of a parameter gets where all parameters have a place in [0, 1]: number, times factor, times the
 * value of its base.
 *
 * @param k      parameter
 * @param m      which of its keys, as of clod_plan_key
 * @param place  [parameters]; NULL: the middle of all
 * @return       in clod_plan_key_unit
 * Test  tests/calibrate/test_plan_set.c
 */
double clod_plan_key_value(const clod_plan *self, size_t k, size_t m, const double *place);

/** Unit of the keys of a parameter: that of its base, where it has one; "": none. */
const char *clod_plan_key_unit(const clod_plan_parameter *self);

/** Texts as --set takes them. */
typedef struct clod_plan_settings {
    char **items; ///< [count] owned; "key=value unit"
    size_t count;
} clod_plan_settings;

/** Those of a test alone, without parameters; false without memory. Owned in any case (_fini). */
bool clod_plan_settings_of_test(const clod_plan_test *test, clod_plan_settings *self);

/** Those of a test, and behind them those of all parameters at a place, NULL: the middle; as above. */
bool clod_plan_settings_at(const clod_plan *plan, const clod_plan_test *test,
                           const double *place, clod_plan_settings *self);

void clod_plan_settings_fini(clod_plan_settings *self);

/**
 * The case of a test with all parameters at a place of their ranges.
 *
 * @param place  [parameters], in [0, 1]; NULL: the middle
 * @return       owned (clod_case_destroy), or NULL
 * Errors  as clod_case_load.   Threads  safe.
 */
clod_case *clod_plan_case(const clod_plan *self, const clod_plan_test *test,
                          const double *place, clod_status *status);
