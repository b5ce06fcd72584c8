#pragma once
/**
 * @file vtkhdf.h
 * A snapshot of a run, read: the columns of a VTKHDF file, whichever it has.
 */

#include <stdbool.h>
#include <stddef.h>

#include "output/hdf.h"

/** What the rows of a column belong to. */
typedef enum clod_vtkhdf_place {
    CLOD_VTKHDF_POINTS, ///< grains
    CLOD_VTKHDF_CELLS,  ///< triangles of walls
} clod_vtkhdf_place;

typedef struct clod_vtkhdf_column {
    char name[64];
    char units[32]; ///< udunits text; "": none given
    size_t components;
} clod_vtkhdf_column;

/** An open file; the columns of one kind are listed in the order of their names. It holds HDF5,
 *  as every clod_hdf does. */
typedef struct clod_vtkhdf {
    char *path;          ///< owned
    clod_folder *folder; ///< owned
    int descriptor;      ///< of the file
    clod_hdf *hdf;       ///< owned
    double time;         ///< s
    size_t rows[2];      ///< by clod_vtkhdf_place
    clod_vtkhdf_column *columns[2];
    size_t column_count[2];
} clod_vtkhdf;

/**
 * Open a snapshot and list its columns.
 *
 * @return  owned file (clod_vtkhdf_close), or NULL
 * Errors  CLOD_USAGE: not there, not a snapshot, damaged; CLOD_FAILED: no memory.
 * Threads one at a time, as all of HDF5.   Test  tests/cli/test_picture.py
 */
clod_vtkhdf *clod_vtkhdf_open(const char *path, clod_status *status);

/** Column of this name, or NULL. */
const clod_vtkhdf_column *clod_vtkhdf_find(const clod_vtkhdf *self, clod_vtkhdf_place place,
                                           const char *name);

/** Owned numbers [rows * components] (clod_memory_free) of a listed column, or NULL. */
double *clod_vtkhdf_read(const clod_vtkhdf *self, clod_vtkhdf_place place,
                         const clod_vtkhdf_column *column, clod_status *status);

/** Bytes of the names of parts. */
#define CLOD_VTKHDF_PARTS 65536

/**
 * Names of the parts of walls, "WALL.PART", one a line; the column `part` of cells has their numbers.
 * @param names  [CLOD_VTKHDF_PARTS] [out] "" where there are none
 * @return       whether there are some
 */
bool clod_vtkhdf_parts(const clod_vtkhdf *self, char *names);

/** Owned coordinates [point rows][3] in m, or NULL. */
double (*clod_vtkhdf_points(const clod_vtkhdf *self, clod_status *status))[3];

/**
 * Owned numbers [cell rows][3] of the corners of each triangle, or NULL.
 * Errors  CLOD_USAGE: the cells are no triangles, or damaged; CLOD_FAILED: no memory.
 */
size_t (*clod_vtkhdf_triangles(const clod_vtkhdf *self, clod_status *status))[3];

/** Close, free and null the pointer; NULL is fine. */
void clod_vtkhdf_close(clod_vtkhdf **self);
