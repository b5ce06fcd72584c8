#pragma once
/**
 * @file paraview.h
 * A state file of ParaView, which opens the films of a folder at once: grains as spheres, walls,
 * colours with their bars, and a camera that sees all of it.
 */

#include <stddef.h>

#include "output/folder.h"

/** What a state file shows, and what it must know of it. */
typedef struct clod_paraview {
    double low[3], high[3]; ///< m, box about all that is shown
    double speed;           ///< m/s, of the fastest grain
    double pressure;        ///< Pa, the largest on a wall
    bool wears;             ///< walls have pressures
    bool contacts;          ///< there is a film of contacts
    double time;            ///< s, that is shown first
} clod_paraview;

/** Nothing is shown so far. */
clod_paraview clod_paraview_begin(double time);

/** Something at p reaches as far as `radius` [m]. */
void clod_paraview_add(clod_paraview *self, const double p[3], double radius);

/**
 * Replace the state file of a stem, STEM.pvsm.
 *
 * It names the films STEM.hdf.series, STEM_walls.hdf.series and STEM_contacts.hdf.series by their
 * absolute paths: ParaView looks for others where it was started.
 *
 * Errors  CLOD_FAILED: memory, disk, folder.   Threads  one per stem.
 * Source  files that ParaView 5.11 saves; docs/howto/paraview.md.
 * Test    tests/cli/test_paraview.py
 */
bool clod_paraview_write(const clod_paraview *self, const clod_folder *folder, const char *stem,
                         clod_status *status);
