#pragma once
/**
 * @file suggest.h
 * "Did you mean": the known word nearest to what the user wrote.
 */

#include <stdbool.h>
#include <stddef.h>

typedef struct clod_suggest {
    const char *word; ///< as the user wrote it
    const char *best; ///< nearest so far, or NULL
    size_t distance;  ///< of the nearest so far
} clod_suggest;

/** Start looking for words near `word`. */
clod_suggest clod_suggest_start(const char *word);

/** Offer a known word; it is taken when it is nearer than those before. */
void clod_suggest_offer(clod_suggest *self, const char *known);

/** Whether one of the words is near enough. */
bool clod_suggest_found(const clod_suggest *self);

/**
 * "; did you mean k_adh?", or "" when nothing is near enough.
 *
 * @param self    after the offers
 * @param buffer  [size] where the text is written
 * @return        buffer
 */
const char *clod_suggest_text(const clod_suggest *self, char *buffer, size_t size);
