#pragma once
/**
 * @file strength_grid.h
 * What the contacts in each cell of a grid remember of their past: how many they are, their pull-off and
 * the largest force that has pressed them; and how fast those that are pressed harder than ever gain both.
 */

#include "measure/survey.h"

/** A grid of cubes; plain data. */
typedef struct clod_strength_grid {
    double low[3], edge; ///< m
    int64_t cells[3];    ///< along each axis
} clod_strength_grid;

/** A sum of forces (or of what is gained in a second) in whole and small parts of a newton: in any
 *  order the same. */
typedef struct clod_strength_force {
    int64_t whole; ///< N
    int64_t small; ///< 2^-40 N, less than 1 N
} clod_strength_force;

/** Sums of a cell. */
typedef struct clod_strength_cell {
    int64_t contacts, gaining;
    clod_strength_force pull_off, pressed;
    clod_strength_force pull_off_gain, pressed_gain; ///< N/s
    double most_pull_off, most_pressed;              ///< N
} clod_strength_cell;

/** Number of cells. Threads: pure. */
int64_t clod_strength_grid_cells(const clod_strength_grid *self);

/**
 * Add the contacts of two grains to their cells; a contact is where its two surfaces meet.
 *
 * @param survey  of contacts whose laws are known
 * @param cell    [cells] [in,out]; x fastest
 * Errors  CLOD_FAILED: memory, on any rank; then nothing is added.   Threads  one per bed.
 * Test    tests/step/test_ranks_survey.c, tests/cli/test_clumps.py
 */
bool clod_strength_grid_add(const clod_strength_grid *self, const clod_survey *survey,
                            clod_strength_cell *cell, clod_status *status);

/** A sum [N]. Threads: pure. */
double clod_strength_force_value(const clod_strength_force *sum);

extern const clod_survey_way CLOD_STRENGTH_GRID_WAY;
