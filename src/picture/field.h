#pragma once
/**
 * @file field.h
 * What grains and walls are coloured by: any column of a snapshot by its name, a component or
 * the magnitude of one that is a vector, and quantities that follow from columns.
 */

#include "picture/vtkhdf.h"

typedef struct clod_field {
    double *value; ///< [count] owned; NaN where there is none
    size_t count;
    char title[96]; ///< what it is, without unit
    char units[32]; ///< udunits text; "": a plain number
} clod_field;

/**
 * Read a field of grains or walls.
 *
 * @param name  a column, NAME_x, NAME_y, NAME_z of a vector (NAME alone is its magnitude, NAME_1
 *              ... of other columns with several numbers), or speed, kinetic_energy, age
 * @param self  [out] owned content (clod_field_fini), also after a failure
 * Errors  CLOD_USAGE: no such field, those that exist are named; damaged. CLOD_FAILED: no
 *         memory.   Threads  one at a time.   Test  tests/cli/test_picture.py
 */
bool clod_field_read(clod_field *self, const clod_vtkhdf *file, clod_vtkhdf_place place,
                     const char *name, clod_status *status);

/** Free the content; an empty field is fine. */
void clod_field_fini(clod_field *self);
