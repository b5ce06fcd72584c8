#pragma once
/**
 * @file field_slice.h
 * The plane of a grid of a field that is shown: which one, and the numbers of its cells, as
 * field_NAME.hdf has them.
 */

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

#define CLOD_FIELD_SLICE_MOST 20000 ///< cells of a slice that are shown

/** What is read of each cell. */
typedef enum clod_field_slice_value {
    CLOD_FIELD_SLICE_DENSITY,
    CLOD_FIELD_SLICE_PRESSURE,
    CLOD_FIELD_SLICE_SPEED,
    CLOD_FIELD_SLICE_COORDINATION,
    CLOD_FIELD_SLICE_RIGHT, ///< velocity along `right`
    CLOD_FIELD_SLICE_UP,    ///< velocity along `up`
    CLOD_FIELD_SLICE_VALUES,
} clod_field_slice_value;

typedef struct clod_field_slice {
    long cells[3];
    double corner[3], cell; ///< m: least corner of the grid, edge of a cell
    int across, right, up;  ///< axes: across the plane, to the right and upwards in it
    bool gravity;           ///< gravity lies in the plane
    long layer;             ///< number of its cells along `across`
    long stride;            ///< every stride-th cell is shown along both directions
    size_t columns, rows;   ///< of cells shown
    double *
        value[CLOD_FIELD_SLICE_VALUES]; ///< [rows * columns] owned, SI; NaN: nothing reached it
} clod_field_slice;

/**
 * Choose the plane: the middle layer of cells across an axis. A plane that is three cells high and wide
 * comes before one that is not, then one in which gravity lies, then the one across which there are
 * fewest cells, then those across y, x and z. The axis along which gravity is stronger points upwards;
 * without gravity the later one.
 *
 * @param self     [out] all but the values
 * @param cells    [3] of the grid, >= 1
 * @param gravity  [3] m/s2
 * Threads  pure.   Test  tests/report/test_field_slice.c
 */
void clod_field_slice_choose(clod_field_slice *self, const long cells[3],
                             const double gravity[3]);

/** Centre of the layer along `across` [m]. */
double clod_field_slice_place(const clod_field_slice *self);

/**
 * Read the slice of a grid.
 *
 * @param self     [out] owned content (clod_field_slice_fini), also after a failure
 * @param grid     object of the field in summary.json, with cells, corner_m and cell_m
 * @param gravity  [3] m/s2
 * @param path     of field_NAME.hdf
 * Errors  CLOD_USAGE: the file is damaged or not of this run; CLOD_FAILED: memory.
 * Threads one at a time.   Test  tests/python/test_slices.py
 */
bool clod_field_slice_read(clod_field_slice *self, const json_t *grid, const double gravity[3],
                           const char *path, clod_status *status);

/** Whether any cell of the slice has something. */
bool clod_field_slice_shows(const clod_field_slice *self);

/** Free the content; an empty one is fine. */
void clod_field_slice_fini(clod_field_slice *self);
