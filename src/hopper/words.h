#pragma once
/**
 * @file words.h
 * What comes of a design, in sentences, for the writers.
 */

#include "hopper/result.h"

#define CLOD_WORDS_MOST 256 ///< bytes of a text, its end among them

#define CLOD_WORDS_SOME 0.05 ///< share of the samples above which they contradict the means

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

/** How the line of the flow function weighs its points, and how well it fits; false: there is no line. */
bool clod_words_line(const clod_hopper *self, char text[CLOD_WORDS_MOST]);

/** Share of the samples in which a cohesive arch is possible, at some outlet or at any.   Threads  pure. */
double clod_words_arched(const clod_hopper_found *found);

/** What the samples of a shape came to, with their shares. */
void clod_words_shares(const clod_hopper_found *found, char text[CLOD_WORDS_MOST]);
