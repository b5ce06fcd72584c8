#pragma once
/**
 * @file planes.h
 * The counting planes of a case: those of its gauges that have one.
 */

#include "clod/case.h"
#include "state/state.h"

/** Number of a gauge's plane among those of the state; -1: it has none. Threads: pure. */
int clod_setup_planes_number(const clod_case *from, const clod_case_gauge *gauge);

/** The planes of the case, which nothing has passed yet. Test: tests/cli/test_planes.py */
void clod_setup_planes(const clod_case *from, clod_state *state);
