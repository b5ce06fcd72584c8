#pragma once
/**
 * @file inlets.h
 * Grains that come during a free run (docs/inlets.md): groups of the case that have an inlet.
 *
 * Every CLOD_CASE_INLET_INTERVAL of simulated time the grains that are due by then are put at random places of
 * their region, clear of grains and walls. What finds no place stays due.
 * Inlets whose regions have space in common are one stream: their grains come in the order in
 * which they are due, so that their mix stays as asked for, also while they wait for room.
 */

#include "sim/free_measures.h"

/** What an inlet remembers; plain data. */
typedef struct clod_inlet {
    int64_t count;   ///< grains that have come
    double mass;     ///< kg, their mass
    double backlog;  ///< kg (mass_flow) or grains (number_flow) that are due and had no place
    double most;     ///< the largest of it
    int64_t blocked; ///< insertions at which not everything that was due found a place
    int64_t since;   ///< step of the first of those in a row; -1: not blocked
    int64_t said;    ///< that it is blocked was said, and not yet that it is no more
} clod_inlet;

/** All inlets of a case. */
typedef struct clod_inlets {
    clod_inlet inlet[CLOD_CASE_INLETS]; ///< in the order of the groups that have one
    int64_t next;                       ///< step of the next insertion
    uint64_t next_id, first_id;
    double begin; ///< s, time at which the run began: nothing was due before
} clod_inlets;

/**
 * Asks for the grains that are due, if this is a step of an insertion (`act`): they are in
 * state->changes then. Its memory is a clod_inlets.
 *
 * Errors  CLOD_FAILED: memory.   Threads  one per state; the same grains for the same seed.
 * Test    tests/sim/test_inlets.c, tests/cli/test_inlets.py
 */
extern const clod_free_measure CLOD_MEASURE_INLETS;
