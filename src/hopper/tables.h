#pragma once
/**
 * @file tables.h
 * The tables that a hopper's case names, as curves of the solid.
 */

#include "hopper/case.h"
#include "hopper/solid.h"

/**
 * Read everything measured.
 *
 * @param solid        [out] owned points (clod_tables_fini), also after an error
 * @param one_specimen [out] whether a strength comes from a single specimen
 * Errors  CLOD_USAGE with file, line, column, value and what to do; CLOD_FAILED: memory.
 * Threads safe.   Test  tests/hopper/test_hopper.py
 */
bool clod_tables_read(const clod_hopper_case *from, clod_solid *solid, bool *one_specimen,
                      clod_status *status);

/** Free the points; a solid of zeros is fine. */
void clod_tables_fini(clod_solid *solid);
