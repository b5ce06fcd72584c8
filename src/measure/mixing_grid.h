#pragma once
/**
 * @file mixing_grid.h
 * Samples of two kinds of grains: those in each cell of a region.
 */

#include "measure/mixing.h"
#include "measure/survey.h"

/** A region cut into cells, and the first kind of grains; plain data. */
typedef struct clod_mixing_grid {
    clod_outlet region;
    double cell;      ///< m
    int64_t cells[3]; ///< along each axis
    int64_t material; ///< of the first kind; -1: those with a radius above
    double above;     ///< m
    double unit;      ///< kg, of masses: about that of a cell's grains
} clod_mixing_grid;

/**
 * Count the grains of each cell.
 *
 * @param samples  [cells of all axes] [out] zero before
 * Errors  CLOD_FAILED: memory on another rank.   Threads  one per bed.   Test  tests/cli/test_mixing.py
 */
bool clod_mixing_grid_count(const clod_mixing_grid *self, const clod_survey *survey,
                            clod_mixing_sample *samples, clod_status *status);

/**
 * Weigh the grains of each cell, by its unit.
 *
 * @param samples  [cells of all axes] [out]
 * Errors  CLOD_FAILED: memory, here or on another rank.   Threads  one per bed.
 * Test    tests/cli/test_mixing.py, tests/step/test_ranks_survey.c
 */
bool clod_mixing_grid_weigh(const clod_mixing_grid *self, const clod_survey *survey,
                            clod_mixing_weighed *samples, clod_status *status);

/** Number of samples. Threads: pure. */
size_t clod_mixing_grid_samples(const clod_mixing_grid *self);

extern const clod_survey_way CLOD_MIXING_GRID_WAY;
extern const clod_survey_way CLOD_MIXING_GRID_MASS_WAY;
