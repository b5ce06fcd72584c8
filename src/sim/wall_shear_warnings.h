#pragma once
/**
 * @file wall_shear_warnings.h
 * What the result of a wall friction test warns of.
 */

#include <jansson.h>

#include "sim/parts.h"

/**
 * Whether tau_w has an error of the lever that no error bar shows: a ring, a plate smoother than
 * the grains, one specimen. Then `text` says so and what to do.
 * Source  docs/theory/wall-friction.md.
 */
bool clod_wall_shear_lever(const clod_case *from, char *text, size_t size);

/**
 * Whether the plate of a straight cell can bear more than the solid's own strength, where a ring's does not:
 * grains sink deep between its ridges, or its friction is not below that of the grains. Then `text` says so
 * and what to do.
 * Source  docs/results/wall-roughness.md.
 */
bool clod_wall_shear_rough(const clod_case *from, char *text, size_t size);

/**
 * Warnings of finished parts.
 *
 * @param part  [parts] finished
 * @return      new list of texts, or NULL without memory
 * Test    tests/sim/test_wall_shear_warnings.c
 */
json_t *clod_wall_shear_warnings(const clod_case *from, const clod_part *part, int parts);
