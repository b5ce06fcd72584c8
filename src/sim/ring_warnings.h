#pragma once
/**
 * @file ring_warnings.h
 * The warning box: what is not right with a ring shear test, and what to do.
 */

#include <jansson.h>

#include "sim/ring_run.h"

#define CLOD_RING_WORDS_SIZE 128

/**
 * Whether a preshear was steady, and how fast its shear stress changed at its end with the standard error of
 * that, in `text`.
 *
 * @return  text
 * Errors  none.   Test  tests/sim/test_ring_warnings.c
 */
const char *clod_ring_preshear_words(const clod_ring_shear *test,
                                     char text[CLOD_RING_WORDS_SIZE]);

/** Texts for the warning box, empty when all is well; NULL without memory. */
json_t *clod_ring_warnings(const clod_case *from, const clod_part *part, int parts);
