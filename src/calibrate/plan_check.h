#pragma once
/**
 * @file plan_check.h
 * What a plan must be beyond its keys; for plan.c alone.
 */

#include "calibrate/plan.h"
#include "config/check.h"

/** Numbers of ranges, cases of the tests over all ranges, then the targets; errors in the
 *  report with their places. */
void clod_plan_check(clod_loader *loader, clod_plan *self);

/** The key of a parameter must be one that can take every value between two ends (plan_places.c). */
void clod_plan_check_key(clod_loader *loader, const clod_plan_parameter *self);

/** The case of a test must load with each parameter at either end, at all corners of the ranges and at
 *  every point of the largest design that the plan can lead to; `middle` of the test is set
 *  (plan_places.c). False after a complaint, which names the settings. */
bool clod_plan_check_places(clod_loader *loader, const clod_plan *self, clod_plan_test *test);

/** What a case that is refused says first, in one line: its text is cut before the line of the file that it
 *  shows, which has no place within another complaint. */
const char *clod_plan_check_reason(clod_status *why);

/** Targets from wishes (plan_targets.c). */
void clod_plan_make_targets(clod_loader *loader, clod_plan *self);

/** Standard errors that make a contradiction of two different numbers, and of one that is there twice: more,
 *  since specimens differ. */
#define CLOD_PLAN_FIRM_ERRORS 2.0
#define CLOD_PLAN_SAME_ERRORS 4.0

/** Targets that contradict each other (plan_conflicts.c); warnings in the plan. */
void clod_plan_check_conflicts(clod_loader *loader, clod_plan *self);

/** Standard deviation of a target for its numbers beside others of its test: error and discrepancy (plan_conflicts.c). */
double clod_plan_conflicts_error(const clod_plan_target *self);

/** Numbers of one shear test that no solid has together: one complaint at most, or one warning of those that are held back
 *  (plan_conflicts_shear.c).   Test  tests/calibrate/test_plan_conflicts_shear.c */
void clod_plan_conflicts_shear(clod_loader *loader, clod_plan *self, size_t test);

/** Those of one wall friction test (plan_conflicts_wall.c).   Test  tests/calibrate/test_plan_conflicts_wall.c */
void clod_plan_conflicts_wall(clod_loader *loader, const clod_plan *self);

/** Values of one test far beyond its stresses (plan_conflicts_unit.c).   Test  tests/calibrate/test_plan_conflicts_unit.c */
void clod_plan_conflicts_unit(clod_loader *loader, const clod_plan *self, size_t test);

/** Density of the grains of a test, no free run, where all parameters are at the lower (place 0) or upper (1) ends of their ranges
 *  [kg/m3]; NAN: not known, as without memory (plan_conflicts.c). */
double clod_plan_grain_density(const clod_plan *self, const clod_plan_test *test, double place);

/** Warn of targets that are possible and hardly meant: an error above its value, a solid that gets weaker by
 *  consolidation, or is denser at the walls of a cell; of a plan without complaints (plan_doubts.c). */
void clod_plan_warn_doubts(clod_plan *self);

/** Warn of single values that hardly any solid has at the stress of its test, and of errors that nobody measures: a
 *  wrong unit, mostly (plan_doubts_values.c).   Test  tests/calibrate/test_plan_doubts_values.c */
void clod_plan_warn_values(clod_plan *self);

/** Warn of parameters whose keys are none of a material, nor sizes of its grains: the card sets them in any case that
 *  includes it (plan_doubts_keys.c).   Test  tests/calibrate/test_plan_doubts_keys.c */
void clod_plan_warn_keys(clod_plan *self);

/** Warn of fewer independent used targets than parameters (plan_doubts_count.c).
 *  Test  tests/calibrate/test_plan_doubts_count.c */
void clod_plan_warn_count(clod_plan *self);

/** Warn of specimens of one table that serve used targets of two tests, which count as independent
 *  (plan_specimens.c).   Test  tests/calibrate/test_plan_set.c */
void clod_plan_warn_shared_specimens(clod_plan *self);
