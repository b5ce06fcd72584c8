#pragma once
/**
 * @file measured.h
 * A table of a laboratory, or of a simulation, whichever its header says it is: shear points, a
 * wall yield locus, bulk densities, or angles of repose; read and evaluated.
 */

#include "clod/bulk_density.h"
#include "clod/locus.h"
#include "clod/repose_angles.h"
#include "clod/wall_locus.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum clod_measured_kind {
    CLOD_MEASURED_SHEAR,   ///< anything that is none of the others
    CLOD_MEASURED_WALL,    ///< has a column sigma_w or tau_w
    CLOD_MEASURED_DENSITY, ///< has columns sigma_1 and rho_b, and no f_c
    CLOD_MEASURED_REPOSE,  ///< has a column angle_of_repose
} clod_measured_kind;

typedef struct clod_measured {
    clod_measured_kind kind;
    clod_locus_study *study; ///< owned; of shear points, else NULL
    clod_wall_locus wall;
    clod_bulk_density density;
    clod_repose_angles repose;
} clod_measured;

/** What a table is, by the first line that is no comment. Threads: pure. */
clod_measured_kind clod_measured_kind_of(const char *text, size_t length);

/**
 * Read a table and evaluate it.
 *
 * @param path      the file, "-" for standard input
 * @param defaults  preshear of shear points; NULL = none
 * @param self      [out] owned content (clod_measured_fini), also after an error
 * Errors  CLOD_USAGE: as the reader and the evaluation of its kind; defaults for a table without
 *         preshear.   Threads  safe.   Test  tests/cli/test_locus.py
 */
bool clod_measured_read(const char *path, const clod_locus_defaults *defaults,
                        clod_measured *self, clod_status *status);

/** Free the content; an empty one is fine. */
void clod_measured_fini(clod_measured *self);

/** Results for people, as JSON, as CSV; owned (clod_locus_free), or NULL. */
char *clod_measured_table(const clod_measured *self);
char *clod_measured_json(const clod_measured *self);
char *clod_measured_csv(const clod_measured *self);

/** Takes a warning; the text is the library's, until the call returns. */
typedef void (*clod_measured_sink)(void *context, const char *text);

/** Say every warning of the evaluation. @param context  of the sink; may be NULL */
void clod_measured_warnings(const clod_measured *self, clod_measured_sink sink, void *context);

#ifdef __cplusplus
}
#endif
