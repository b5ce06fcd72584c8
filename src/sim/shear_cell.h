#pragma once
/**
 * @file shear_cell.h
 * What preflight, run and report of a shear test ask of its cell, whichever tester it is.
 */

#include "clod/case.h"

typedef struct clod_shear_cell {
    const char *key; ///< of the tester in the case file
    const clod_case_programme *programme;
    const char *grain_material;
    double radius_mean;          ///< m, of the grains
    double area;                 ///< m2
    double width, height;        ///< m, of the specimen; height as filling aims at
    int64_t bar_count;           ///< on the lid and on the base each; 0: none
    double bar_height;           ///< m
    double twisting;             ///< s in which the lid is twisted before preshear
    double lid_mass;             ///< kg
    double fill_max, settle_max; ///< s at most until the grains, and the lid, rest
} clod_shear_cell;

/** The cell of a case that has a shear test; borrowed from the case. */
clod_shear_cell clod_shear_cell_of(const clod_case *from);

/** The cell of each tester without key, programme and material; rows in sim/testers.c. */
clod_shear_cell clod_shear_cell_ring(const clod_case *from);
clod_shear_cell clod_shear_cell_jenike(const clod_case *from);
