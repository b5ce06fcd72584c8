#pragma once
/**
 * @file ring_warnings.h
 * The warning box: what is not right with a ring shear test, and what to do.
 */

#include <jansson.h>

#include "sim/ring_run.h"

#define CLOD_RING_WORDS_SIZE 128

/**
 * Whether a preshear was steady, or how fast its shear stress still changed, in `text`.
 *
 * @return  text
 */
const char *clod_ring_preshear_words(const clod_ring_shear *test,
                                     char text[CLOD_RING_WORDS_SIZE]);

/** Texts for the warning box, empty when all is well; NULL without memory. */
json_t *clod_ring_warnings(const clod_case *from, const clod_part *part, int parts);
