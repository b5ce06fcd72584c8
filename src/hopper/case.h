#pragma once
/**
 * @file case.h
 * The case file of a hopper: what was measured, and what is wanted. SI units, angles in rad.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

/** Results folder of a ring shear or Jenike test, or a file of shear points. */
typedef struct clod_hopper_test {
    char *points; ///< path, resolved against the case
} clod_hopper_test;

/** How a flow function goes through its points, in the order of the key's choices. */
typedef enum clod_hopper_strength_curve {
    CLOD_HOPPER_STRENGTH_LINE,  ///< least squares
    CLOD_HOPPER_STRENGTH_POINTS ///< straight from point to point
} clod_hopper_strength_curve;

/** Flow function: from a table, or from shear tests. */
typedef struct clod_hopper_strength {
    char *file;              ///< path, resolved against the case; NULL: from tests
    clod_hopper_test *tests; ///< [test_count] owned
    size_t test_count;
    int curve;           ///< clod_hopper_strength_curve
    char *after_storage; ///< path, owned; NULL: in continuous flow
} clod_hopper_strength;

/** A property: a table over stress, or one value with its standard error. */
typedef struct clod_hopper_property {
    bool present;
    char *file; ///< NULL: value
    bool has_value;
    double value, error;
} clod_hopper_property;

/** One shape of hopper. */
typedef struct clod_hopper_shape {
    double half_angle; ///< 0: the limit less the margin
    double outlet;     ///< m: of a hopper that exists or is planned; 0: none
    double limit;      ///< rad: of mass flow in a wedge, from a chart; 0: not given
    double limit_error;
} clod_hopper_shape;

typedef struct clod_hopper_silo {
    bool present;
    double diameter, height, stress_ratio;
} clod_hopper_silo;

typedef struct clod_hopper_interval {
    double level; ///< 0.9: between the 5 % and 95 % quantiles
    int64_t samples, seed;
} clod_hopper_interval;

typedef struct clod_hopper_case {
    char *title; ///< NULL: none
    clod_hopper_strength strength;
    clod_hopper_property phi_e, phi_t, rho, wall;
    clod_hopper_shape cone, wedge;
    double margin;
    int arch; ///< clod_hopper_arch
    clod_hopper_silo silo;
    double largest_particle; ///< m; 0: not given
    clod_hopper_interval interval;
} clod_hopper_case;

/**
 * Read a case.
 *
 * @param overrides  [override_count] texts key.path=value
 * @param self       [out] owned content (clod_hopper_case_fini), also after an error
 * Errors  CLOD_USAGE with file, line, caret, value, allowed range and what to do; CLOD_FAILED:
 *         memory.   Threads  safe.   Test  tests/hopper/test_hopper.py, test_refusals.py
 */
bool clod_hopper_case_load(const char *path, const char *const *overrides,
                           size_t override_count, clod_hopper_case *self, clod_status *status);

void clod_hopper_case_fini(clod_hopper_case *self);
