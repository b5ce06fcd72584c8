#pragma once
/**
 * @file ring_warnings.h
 * The warning box: what is not right with a ring shear test, and what to do.
 */

#include <jansson.h>

#include "sim/ring_run.h"

/** Texts for the warning box, empty when all is well; NULL without memory. */
json_t *clod_ring_warnings(const clod_case *from, const clod_part *part, int parts);
