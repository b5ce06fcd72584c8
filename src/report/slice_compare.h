#pragma once
/**
 * @file slice_compare.h
 * Slices of the same grid of several runs side by side, on one scale of colours and of arrows.
 */

#include "report/run_files.h"
#include "report/sheet.h"

/**
 * Put a section with the slices of every field that two runs or more have a grid of; nothing when there is
 * none. Runs without it, or whose cells, place or plane are others than those of the first run that has
 * it, are left out, and the section says so.
 *
 * What is shown is the same moment of all: the means at the end when all ended at one time, to a time step;
 * or else the last moment of which all have a frame; or else each run's mean at its own end, which the
 * section says. Of tests it is the mean over the phase with which the part ends whose slices their
 * pages show, the first that shears or crushes.
 *
 * Errors  CLOD_USAGE: a damaged file; CLOD_FAILED: memory.   
 * Test    tests/python/test_slices.py
 */
bool clod_slice_compare_put(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                            clod_status *status);
