#pragma once
/**
 * @file inlets.h
 * Grains that come during a free run (docs/inlets.md): groups of the case that have an inlet.
 *
 * Every INTERVAL of simulated time the grains that are due by then are put at random places of
 * their region, clear of grains and walls. What finds no place stays due.
 */

#include <jansson.h>
#include <stdint.h>
#include <stdio.h>

#include "clod/case.h"
#include "state/state.h"

/** Simulated time from one insertion to the next [s]. */
#define CLOD_INLETS_INTERVAL 1e-3

/** What an inlet remembers; plain data. */
typedef struct clod_inlet {
    int64_t count;   ///< grains that have come
    double mass;     ///< kg, their mass
    double owed;     ///< kg (mass_flow) or grains (number_flow) that are due and had no place
    double most;     ///< the largest of it
    int64_t blocked; ///< insertions at which not everything that was due found a place
    int64_t since;   ///< step of the first of those in a row; -1: not blocked
} clod_inlet;

/** All inlets of a case. */
typedef struct clod_inlets {
    clod_inlet inlet[CLOD_CASE_INLETS]; ///< in the order of the groups that have one
    int64_t next;                       ///< step of the next insertion
    uint64_t next_id;
    double begin; ///< s, time at which the run began: nothing was due before
} clod_inlets;

/** Begin with a state that no grain has come into. */
void clod_inlets_begin(clod_inlets *self, const clod_case *from, const clod_state *state);

/** Steps until the next insertion; a large number without inlets. Threads: pure. */
int64_t clod_inlets_plan(const clod_inlets *self, const clod_case *from,
                         const clod_state *state);

/**
 * Ask for the grains that are due, if this is a step of an insertion: they are in
 * state->changes then. Once for a step, however often it is called.
 *
 * Errors  CLOD_FAILED: memory.   Threads  one per state; the same grains for the same seed.
 * Test    tests/sim/test_inlets.c, tests/cli/test_inlets.py
 */
bool clod_inlets_act(clod_inlets *self, const clod_case *from, clod_state *state,
                     clod_status *status);

/** Columns of the series, three for each inlet. */
#define CLOD_INLETS_COLUMNS 3

/** Name of a column of inlet k, from 0, into `text`. */
void clod_inlets_column(const clod_case *from, size_t k, int column, char *text, size_t size);

/** Values of the columns of all inlets; their number. */
size_t clod_inlets_row(const clod_inlets *self, const clod_case *from, double *row);

/** Lines for people: what came, and what found no place. */
void clod_inlets_report(FILE *out, const clod_inlets *self, const clod_case *from, double dt);

/** The same for programs; NULL without inlets. */
json_t *clod_inlets_json(const clod_inlets *self, const clod_case *from, double dt);
