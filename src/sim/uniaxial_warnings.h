#pragma once
/**
 * @file uniaxial_warnings.h
 * The warning box: what is not right with a uniaxial test, and what to do.
 */

#include "sim/parts.h"

/** Texts for the warning box, empty when all is well; NULL without memory. */
json_t *clod_uniaxial_warnings(const clod_case *from, const clod_part *part, int parts);
