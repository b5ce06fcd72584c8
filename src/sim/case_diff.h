#pragma once
/**
 * @file case_diff.h
 * In which keys two complete cases differ.
 */

#include <stdbool.h>

#include "clod/status.h"

/** A key that differs, "contacts.ore-ore.friction", and its values; NULL where it is not.
 *  Sections have none: what is in them is told. */
typedef void (*clod_case_difference)(void *context, const char *key, const char *there,
                                     const char *here);

/**
 * Compare two texts of clod_case_echo and call `visit` for every key that is not the same.
 *
 * Errors  CLOD_FAILED without memory.   Threads  pure.   Test  tests/sim/test_case_diff.c
 */
bool clod_case_differences(const char *there, const char *here, clod_case_difference visit,
                           void *context, clod_status *status);
