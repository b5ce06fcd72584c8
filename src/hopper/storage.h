#pragma once
/**
 * @file storage.h
 * The strength of a solid that was stored at rest, in place of that in continuous flow.
 */

#include <stdbool.h>

#include "clod/status.h"
#include "hopper/solid.h"
#include "hopper/tables.h"

/**
 * Read the time flow function: f_c over sigma_1, and phi_t where the table has it, of time yield loci.
 * Stress in flow, phi_e, density and the wall stay those of the solid that flows: storage changes what holds an
 * arch, not what presses on it.
 *
 * @param solid     [in, out] complete; its strength, and phi_t if the table has it and `phi_t` is true, are replaced
 * @param notes     [in, out]; of a strength that is smaller after storage, too
 * Errors  CLOD_USAGE with file, line, column, value and what to do; CLOD_FAILED: memory.
 * Threads safe.   Source  Jenike, Bulletin 123 (1964); Schulze, Powders and Bulk Solids (2008), 3.1.5, 10.
 * Test    tests/hopper/test_storage.py
 */
bool clod_storage_read(const char *path, bool phi_t, clod_solid *solid,
                       clod_tables_notes *notes, clod_status *status);
