#pragma once
/**
 * @file field_figure.h
 * A slice of a field as figures: density, pressure, speed with arrows, coordination.
 */

#include <jansson.h>
#include <stddef.h>

#include "report/field_slice.h"
#include "report/figure.h"

#define CLOD_FIELD_FIGURES 4 ///< of a slice

/** What the figures are of. */
typedef struct clod_field_figure {
    const char *field;  ///< its name
    const char *run;    ///< beside others: what it is called; NULL: the page is of one run
    const json_t *grid; ///< the field's object in summary.json
    const clod_field_slice *slice; ///< of the mean over the samples, or of a moment
    const double *moment;          ///< s; NULL: the mean
    double fastest; ///< m/s of the arrow that is nearly as long as its cells are apart
} clod_field_figure;

/** Speed in the plane of the fastest cell that has an arrow [m/s]; 0: none moves. Threads  pure. */
double clod_field_figure_fastest(const clod_field_slice *slice);

/** Where the plane is, without a full stop. */
void clod_field_figure_plane(const clod_field_slice *slice, char *text, size_t size);

/**
 * Make a figure, which clod_field_figure_finish finishes.
 *
 * @param figure  [out] owned content (clod_figure_fini)
 * @param number  which of the CLOD_FIELD_FIGURES
 * Errors  `lost` of the figure is set.   Test  tests/python/test_slices.py
 */
void clod_field_figure_make(clod_figure *figure, const clod_field_figure *self, size_t number);

/** Give figures of the same `number` one scale of colours and one unit. @param figures  [count] */
void clod_field_figure_finish(clod_figure *figures, size_t count, size_t number);
