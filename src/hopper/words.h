#pragma once
/**
 * @file words.h
 * What comes of a design, in sentences, for the writers.
 */

#include "hopper/result.h"

#define CLOD_WORDS_MOST 256 ///< bytes of a text, its end among them

/** What comes of a shape. */
void clod_words_verdict(const clod_hopper_found *found, char text[CLOD_WORDS_MOST]);

/** What the samples of a shape came to, with their shares. */
void clod_words_shares(const clod_hopper_found *found, char text[CLOD_WORDS_MOST]);
