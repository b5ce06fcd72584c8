#pragma once
/**
 * @file grains.h
 * All groups of grains of a case: inserted at random, or read one by one from a file.
 */

#include "clod/case.h"
#include "state/state.h"

/**
 * Append the grains of a case to a state whose walls and domain are there.
 *
 * Ids go from 1 upwards, group after group; a file may bring its own.
 *
 * @param seed   of sizes and places
 * Errors  CLOD_USAGE: grains that do not fit, a wrong file, an id twice; CLOD_FAILED.
 * Threads pure.   Test  tests/setup/test_setup_state.c
 */
bool clod_setup_grains(const clod_case *from, int64_t seed, clod_state *state,
                       clod_status *status);

/** The pair of grains with the largest overlap. */
typedef struct clod_setup_overlap {
    uint64_t id_a, id_b; ///< 0, 0 when no grains overlap
    double overlap;      ///< m
    double ratio;        ///< overlap / smaller radius
} clod_setup_overlap;

/**
 * Look for the worst overlap of any two grains; packings from files have many.
 * Errors  CLOD_FAILED without memory.   Threads  pure.
 */
bool clod_setup_worst_overlap(const clod_state *state, clod_setup_overlap *worst,
                              clod_status *status);
