#pragma once
/**
 * @file film.h
 * The snapshots of a run in their order, as its `.hdf.series` files list them, and what its case
 * says of them: the title and the names of its walls.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/case.h"
#include "clod/status.h"

/** One moment of a run. */
typedef struct clod_film_frame {
    double time;  ///< s
    char *grains; ///< owned path of the file
    char *walls;  ///< the same; NULL when the run has none of that moment
} clod_film_frame;

typedef struct clod_film {
    char *folder;            ///< owned
    char *title;             ///< owned: of the case, or the name of the folder
    clod_case *of;           ///< owned; NULL when there is none that can be read
    clod_film_frame *frames; ///< [count] owned, in the order of time
    size_t count;
} clod_film;

/**
 * Look for the snapshots of a part of a run.
 *
 * @param folder  results folder of `clod run`
 * @param part    name of the series; NULL: the only one there is, or "run"
 * @param self    [out] owned content (clod_film_fini), also after a failure
 * Errors  CLOD_USAGE: no results folder, no snapshots (those of other parts are named), a
 *         damaged list; CLOD_FAILED: no memory.   Threads  safe.
 * Test    tests/cli/test_picture.py
 */
bool clod_film_open(clod_film *self, const char *folder, const char *part, clod_status *status);

/**
 * Number of the frame nearest to a time.
 *
 * @param time  s; half an interval of snapshots before the first and after the last at most
 * Errors  CLOD_USAGE: outside of the run.
 */
bool clod_film_nearest(const clod_film *self, double time, size_t *frame, clod_status *status);

/** Number of a wall that goes by this name or number, or -1. */
int clod_film_wall(const clod_film *self, const char *name);

/** Name of material or wall number k in the case; NULL when that is not known. */
const char *clod_film_material_name(const clod_film *self, size_t k);
const char *clod_film_wall_name(const clod_film *self, size_t k);

/** Free the content; an empty film is fine. */
void clod_film_fini(clod_film *self);
