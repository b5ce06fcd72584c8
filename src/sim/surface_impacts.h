#pragma once
/**
 * @file surface_impacts.h
 * What is reported of the impacts on surfaces: columns of the series, a table of the report, an
 * object of the summary, impacts.csv (docs/surfaces.md).
 */

#include "sim/free_measures.h"
#include "state/impacts.h"

/** Columns of each surface: means over the impacts since the last row. */
enum { CLOD_SURFACE_IMPACTS_COLUMNS = 2 };

/** Header texts of these columns. */
extern const char *const CLOD_SURFACE_IMPACTS_COLUMN[CLOD_SURFACE_IMPACTS_COLUMNS];

/** Values of these columns, NAN without an impact; the row ends here. Returns the place behind. */
double *clod_surface_impacts_row(clod_impacts *self, double *row);

/** A table of all surfaces that were hit. */
void clod_surface_impacts_report(FILE *out, const clod_walls *walls);

/** The same and its classes, for programs. */
json_t *clod_surface_impacts_json(const clod_impacts *self);

/** Paths of the same, of surfaces of the summary: "[0-3]". */
void clod_surface_impacts_paths(clod_free_paths *paths, const char *faces);

/** Write impacts.csv: all classes of angle and energy with impacts, if there are sums. */
bool clod_surface_impacts_write(const clod_folder *folder, const void *memory,
                                const clod_free_moment *now, clod_status *status);
