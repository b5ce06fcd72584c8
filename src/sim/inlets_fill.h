#pragma once
/**
 * @file inlets_fill.h
 * One insertion of all inlets: which grains are due, in which order, and where they are put.
 */

#include "sim/inlets.h"

/** Boxes about the regions of all inlets: what reaches into none is in no grain's way. False: that
 *  is not known, without memory. */
bool clod_inlets_sight(const clod_case *from, clod_sight *sees);

/**
 * Ask for the grains that are due at the state's time: they are in state->changes then. A grain
 * for which no place is found waits, and so do all that are due after it and come through an
 * inlet whose region has space in common with that of its own.
 *
 * Errors  CLOD_FAILED: memory.
 * Threads one per state; the same grains for the same seed and step.
 * Test    tests/sim/test_inlets.c, tests/cli/test_inlets_mix.py
 */
bool clod_inlets_fill(clod_inlets *self, const clod_case *from, clod_state *state,
                      clod_status *status);
