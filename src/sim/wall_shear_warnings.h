#pragma once
/**
 * @file wall_shear_warnings.h
 * What the result of a wall friction test warns of.
 */

#include <jansson.h>

#include "sim/parts.h"

/**
 * Warnings of finished parts.
 *
 * @param part  [parts] finished
 * @return      new list of texts, or NULL without memory
 * Test    tests/sim/test_wall_shear_warnings.c
 */
json_t *clod_wall_shear_warnings(const clod_case *from, const clod_part *part, int parts);
