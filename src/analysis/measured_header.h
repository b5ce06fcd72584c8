#pragma once
/**
 * @file measured_header.h
 * What the header of a measured table says beyond the kinds that `clod locus` evaluates.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

/** Which stresses a table has. */
typedef enum clod_measured_stress {
    CLOD_MEASURED_OF_NONE,    ///< no column of a stress that is known
    CLOD_MEASURED_OF_SHEAR,   ///< normal and shear stress of shear points
    CLOD_MEASURED_OF_WALL,    ///< those at a wall
    CLOD_MEASURED_OF_SIGMA_1, ///< the major principal one, as a flow function and bulk densities
    CLOD_MEASURED_OF_REPOSE,  ///< none, but angles of repose
    CLOD_MEASURED_OF_PRESHEAR, ///< the normal one of preshear with bulk densities, and no shear stress: nothing reads it
} clod_measured_stress;

#define CLOD_MEASURED_HEADER 1024 ///< bytes of a header that are looked at

/** The first line that is no comment, cut to so many bytes, in small letters. @param header [out] Threads  pure. */
void clod_measured_header_of(const char *text, size_t length,
                             char header[CLOD_MEASURED_HEADER]);

/** Whether such a header has a column of this name; whether it is one of a wall yield locus. Threads  pure. */
bool clod_measured_header_has(const char *header, const char *name);
bool clod_measured_header_is_wall(const char *header);

/** Of the first line that is no comment. Threads  pure.   Test  tests/calibrate/test_plan_curves.c */
clod_measured_stress clod_measured_stress_of(const char *text, size_t length);

/** What the tables of each are, for messages: "wall friction (sigma_w, tau_w)"; NULL of none. */
extern const char *const CLOD_MEASURED_STRESS_NAMES[];

/** Refuse a table of CLOD_MEASURED_OF_PRESHEAR: bulk densities are over sigma_1. Errors  CLOD_USAGE with what to do.
 *  Threads  pure.   Test  tests/cli/test_locus.py, tests/hopper/test_refusals.py, tests/calibrate/test_plan.c */
bool clod_measured_header_check(const char *path, clod_measured_stress found,
                                clod_status *status);

/** Of a regular file; CLOD_MEASURED_OF_NONE for any other, a pipe can be read once only. Threads  pure. */
clod_measured_stress clod_measured_stress_in(const char *path);

/** Whether that line has a column of this name, in small letters. Threads  pure.   Test  tests/analysis/test_wall_points.c */
bool clod_measured_has(const char *text, size_t length, const char *name);
