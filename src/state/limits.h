#pragma once
/**
 * @file limits.h
 * How much a state may hold: rows and contacts are counted with 32 bits in the hot loop and in
 * the lists, which keeps them small. What is beyond is refused by name before it is asked for.
 * Test  tests/state/test_limits.c
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

/** Grains: the energy ledger looks at half rows, 2 i + 1, and two rows of padding follow. */
#define CLOD_LIMITS_GRAINS (((size_t)1 << 30) - 2)
/** Pairs of grains that may touch before the next rebuild. */
#define CLOD_LIMITS_PAIRS ((size_t)UINT32_MAX)
/** Pairs of a grain and a shape of a wall that may touch: so many lanes, and those of padding.
 */
#define CLOD_LIMITS_WALL_PAIRS ((size_t)1 << 30)
/** Contacts with a history. */
#define CLOD_LIMITS_CONTACTS ((size_t)INT32_MAX)

/** True up to the limit; beyond it false, with a text that names number and limit (CLOD_USAGE).
 */
bool clod_limits_grains(size_t count, clod_status *status);
bool clod_limits_pairs(size_t count, clod_status *status);
bool clod_limits_wall_pairs(size_t count, clod_status *status);
bool clod_limits_contacts(size_t count, clod_status *status);
