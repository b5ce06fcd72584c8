#pragma once
/**
 * @file grains_file.h
 * Grains one by one from a CSV file.
 */

#include "clod/case.h"
#include "state/grains.h"

/**
 * Read grains from a CSV file and append them.
 *
 * The first line names the columns, in any order: x, y, z, radius (or r); optional id, vx, vy,
 * vz, wx, wy, wz, material. All but id and material need their unit in brackets, `x [mm]`.
 * Blank lines and lines that begin with # are skipped.
 *
 * @param from    materials by name
 * @param group   its file and its material, for rows without one; its velocity, when the file
 *                has none
 * @param next_id [in,out] id of the first grain when the file has no ids; then one beyond the
 *                largest id
 * @param grains  [in,out]
 * Errors  CLOD_USAGE with file:line:column; CLOD_FAILED when it cannot be read.
 * Threads pure.   Test  tests/setup/test_setup_grains_file.c
 */
bool clod_grains_file_read(const clod_case *from, const clod_case_grains *group,
                           uint64_t *next_id, clod_grains *grains, clod_status *status);
