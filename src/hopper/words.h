#pragma once
/**
 * @file words.h
 * What comes of a design, in sentences, for the writers.
 */

#include "hopper/result.h"

#define CLOD_WORDS_MOST 256 ///< bytes of a text, its end among them

/** What comes of a shape. */
void clod_words_verdict(const clod_hopper_found *found, char text[CLOD_WORDS_MOST]);

/** When a rathole is asked for: "emptying", "after filling". */
extern const char *const CLOD_WORDS_HOLES[CLOD_HOPPER_HOLES];

/** Why a rathole has no diameter; false: it has one. */
bool clod_words_no_rathole(const clod_hopper *self, int hole, char text[CLOD_WORDS_MOST]);

/** The design state, that of limit and half angle, with its outlet, and in funnel flow at which stress the solid does not slide;
 *  false: at the critical one, or none is built. */
bool clod_words_design_state(const clod_hopper_found *found, char text[CLOD_WORDS_MOST]);

/** How the values of one yield locus are drawn; false: there are none with several errors, or specimens move them. */
bool clod_words_drawn(const clod_hopper *self, char text[CLOD_WORDS_MOST]);

/** What the samples of a shape came to, with their shares. */
void clod_words_shares(const clod_hopper_found *found, char text[CLOD_WORDS_MOST]);
