#pragma once
/**
 * @file number.h
 * Which results of a test can be targets, and how they are read from the folder of its run.
 */

#include <jansson.h>

#include "analysis/angles.h"
#include "base/unit_endings.h"
#include "calibrate/plan.h"

/** Relative: as clod locus tells consolidation stresses apart. */
#define CLOD_NUMBER_SAME_STRESS 0.02

/** One kind of number; its measure says its unit for people. */
typedef struct clod_number {
    const char *key;
    const char *unit; ///< SI
    clod_plan_measure measure;
    double least, most; ///< SI: what a measured value may be
    bool amount;        ///< no run has it below 0; of a path its name tells
    bool at_stress;     ///< it is that of a normal stress, which the plan must give
    const char *field;  ///< its name in the summary; NULL where it is not read there
    /** Its value in a summary, SI, NAN where the test defines none; NULL where it is not read there or is a
     *  path. */
    double (*of)(const json_t *summary, const struct clod_number *self,
                 const clod_plan_target *target);
} clod_number;

#define CLOD_NUMBER_DEGREE 0.017453292519943295
#define CLOD_NUMBER_ANGLE                                                                      \
    "rad", {"deg", 1.0 / CLOD_NUMBER_DEGREE, 1}, CLOD_ANGLES_LEAST *CLOD_NUMBER_DEGREE,        \
        85.0 * CLOD_NUMBER_DEGREE, false // near the origin cohesion or adhesion make it steep
#define CLOD_NUMBER_SLOPE                                                                      \
    "rad", {"deg", 1.0 / CLOD_NUMBER_DEGREE, 1}, CLOD_ANGLES_LEAST *CLOD_NUMBER_DEGREE,        \
        CLOD_ANGLES_MOST *CLOD_NUMBER_DEGREE,                                                  \
        false // as clod locus refuses others of a laboratory
#define CLOD_NUMBER_STRESS "Pa", {"kPa", 1e-3, 2}, 0.0, 1e8, true
/// On a fitted line, which the points of a run may draw below 0.
#define CLOD_NUMBER_LINE "Pa", {"kPa", 1e-3, 2}, 0.0, 1e8, false
#define CLOD_NUMBER_DENSITY "kg/m3", {"kg/m3", 1.0, 0}, 10.0, 15000.0, true
#define CLOD_NUMBER_RATIO "1", {"", 1.0, 2}, 0.0, 1000.0, true

// Numbers of each kind of test: number_shear.c, number_summary.c, number_path.c.
#define CLOD_NUMBERS_SHEAR_COUNT 12
#define CLOD_NUMBERS_UNIAXIAL_COUNT 4
#define CLOD_NUMBERS_WALL_COUNT 4
#define CLOD_NUMBERS_PATH_ONE(ending, si, shown, factor) +1
#define CLOD_NUMBERS_PATH_COUNT (1 CLOD_UNIT_ENDINGS(CLOD_NUMBERS_PATH_ONE))
extern const clod_number CLOD_NUMBERS_SHEAR[CLOD_NUMBERS_SHEAR_COUNT];
extern const clod_number CLOD_NUMBERS_UNIAXIAL[CLOD_NUMBERS_UNIAXIAL_COUNT];
extern const clod_number CLOD_NUMBERS_WALL[CLOD_NUMBERS_WALL_COUNT];
/** Of paths in the summary of a free run, whose key is how the name of the number ends. */
extern const clod_number CLOD_NUMBERS_PATH[CLOD_NUMBERS_PATH_COUNT];

/** Whether it is one of a path: a value without a unit has that of the name. */
bool clod_number_is_path(const clod_number *self);

/** Whether it is the angle of repose of a heap, at the end of a run or over its steady time (number_path.c). */
bool clod_number_path_is_repose(const clod_number *self);

/** Whether a number of a path is a mass, density, energy, area, volume, time, count or deviation, which are never
 *  negative (number_path.c).   Test  tests/calibrate/test_number_path.c */
bool clod_number_path_is_amount(const clod_number *kind, const char *path);

/** Whether a target is a density, ratio, amount of a path or stress that is never below 0 in any run; no angle is one, nor is
 *  sigma_2 (tension), or what is read on a fitted line (c, tau, tau_ad).
 *  Threads  pure.   Test  tests/calibrate/test_number_path.c, test_result_verdict.c */
bool clod_number_is_amount(const clod_plan *plan, const clod_plan_target *target);

/** The kind of a number of a test; NULL: there is none. Of a free run every path of its summary is one. */
const clod_number *clod_number_find(const clod_plan_test *of, const char *key);

/** The same of a path (number_path.c). */
const clod_number *clod_number_path_find(const clod_free_paths *of, const char *path);

/** "; did you mean phi_e?", "; it has phi_lin, ..." or ", which is one of a wall friction test; it has ...": after an
 *  unknown number. */
const char *clod_number_hint(const clod_plan_test *of, const char *key, char *buffer,
                             size_t size);

/**
 * The numbers of all targets of a test in the results folder of a finished run.
 *
 * @param values    [out] [targets] SI; NAN where the test does not define one; those of other tests stay
 * @param stresses  [out] [targets] sigma_1 of the run, Pa, where the number goes along a table from there to
 *                  the target's stress; others stay; or NULL
 * Errors  CLOD_USAGE: a file that is damaged; CLOD_FAILED: disk, memory.   Threads  safe.   Test  tests/calibrate/test_calibrate.py
 */
bool clod_number_read(const clod_plan *plan, size_t test, const char *folder, double *values,
                      double *stresses, clod_status *status);

/**
 * A number of a run as it would be at the stress of a target: moved along the measured curve by as much
 * as that changes from the run's own sigma_1 to there (docs/theory/calibration.md).
 *
 * @param sigma_1  of the run, Pa; NAN: it has none
 * @return         the number itself where the target has no curve; NAN without sigma_1
 * Errors  none.   Threads  pure.   Test  tests/calibrate/test_plan_curves.c
 */
double clod_number_moved(const clod_plan_target *target, double value, double sigma_1);

/** The same of a path (number_path.c): the names that the summary has. */
const char *clod_number_path_hint(const clod_free_paths *of, const char *path, char *buffer,
                                  size_t size);

/** A number of a path, SI; NAN where the run defines none, as the residence time of grains that never
 *  leave (number_path.c). */
double clod_number_path_read(const json_t *summary, const clod_number *self,
                             const clod_plan_target *target);

/** The same of a shear test, from its points (number_shear.c). */
bool clod_number_read_shear(const clod_plan *plan, size_t test, const char *folder,
                            double *values, double *stresses, clod_status *status);

/** The same of a test whose numbers are in its summary (number_summary.c). */
bool clod_number_read_summary(const clod_plan *plan, size_t test, const char *folder,
                              double *values, double *stresses, clod_status *status);
