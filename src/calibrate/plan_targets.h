#pragma once
/**
 * @file plan_targets.h
 * Targets in the making; for plan_targets.c, plan_samples.c, plan_tables.c, plan_shear.c, plan_curves.c, plan_repose.c alone.
 */

#include "calibrate/number.h"
#include "calibrate/plan_check.h"

#define CLOD_PLAN_TARGETS_PATH 64

/** What is being made. */
typedef struct clod_plan_maker {
    clod_loader *loader;
    clod_plan *plan;
    const clod_plan_wish *wish;
    size_t number; ///< of the wish
    char path[CLOD_PLAN_TARGETS_PATH];
} clod_plan_maker;

/** Path of a key of the wish, for a complaint; "": of the wish. */
const char *clod_plan_targets_at(clod_plan_maker *self, const char *key);

/** A standard error or deviation: above 0, or 0 where it may be left out; false after a complaint. */
bool clod_plan_targets_deviation(clod_plan_maker *self, const char *key, const char *text,
                                 const clod_number *kind, bool needed, double *value);

/** A normal stress where one is needed, within what the test has; false after a complaint. */
bool clod_plan_targets_check_stress(clod_plan_maker *self, size_t test, const clod_number *kind,
                                    const char *number, double stress);

/** The number that the wish names, one that its test has; NULL after a complaint. */
const clod_number *clod_plan_targets_number(clod_plan_maker *self, size_t test);

/** Append a target, under the name that its test and number give it. */
void clod_plan_targets_add(clod_plan_maker *self, const clod_plan_target *made,
                           const char *number);

/** What a measured table is, by its header. */
typedef enum clod_plan_is {
    CLOD_PLAN_IS_NONE,
    CLOD_PLAN_IS_SHEAR,
    CLOD_PLAN_IS_WALL,
    CLOD_PLAN_IS_DENSITY, ///< over sigma_1
    CLOD_PLAN_IS_FLOW,    ///< over sigma_1, and no bulk densities
    CLOD_PLAN_IS_REPOSE,  ///< angles of repose
} clod_plan_is;

#define CLOD_PLAN_TABLE_NUMBERS 3 ///< at most

/** A kind of measured table (plan_tables.c, plan_shear.c, plan_curves.c, plan_repose.c). */
typedef struct clod_plan_table {
    clod_plan_is is;
    const char *numbers
        [CLOD_PLAN_TABLE_NUMBERS]; ///< what its points are targets of, and what else the plan may ask for
    bool one_stress;               ///< normal_stress beside it takes the points there
    bool any_angle;                ///< `numbers` is empty: the plan names an angle of repose
    /** Targets of a file's points; false with status. */
    bool (*make)(clod_plan_maker *self, size_t test, const clod_number *kind,
                 clod_status *status);
} clod_plan_table;

extern const clod_plan_table CLOD_PLAN_TABLE_SHEAR, CLOD_PLAN_TABLE_WALL,
    CLOD_PLAN_TABLE_DENSITY, CLOD_PLAN_TABLE_FLOW, CLOD_PLAN_TABLE_REPOSE;

/** Targets of the points of a measured table (plan_tables.c). */
void clod_plan_tables_make(clod_plan_maker *self, size_t test);
