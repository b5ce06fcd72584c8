#pragma once
/**
 * @file index.h
 * A set of texts, each with a number: found in one look, however many there are.
 */

#include <stdbool.h>
#include <stddef.h>

#include "config/arena.h"

typedef struct clod_index_slot {
    const char *text; ///< borrowed; NULL: free
    size_t length, value;
} clod_index_slot;

/** All zero is an empty set; its memory is that of an arena. */
typedef struct clod_index {
    clod_index_slot *slots;
    size_t count, capacity; ///< capacity is a power of two, or 0
} clod_index;

/**
 * Add the first `length` bytes of a text, which must live as long as the set; one that is in it
 * keeps its number.
 *
 * @return  false without memory
 */
bool clod_index_add(clod_index *self, clod_arena *arena, const char *text, size_t length,
                    size_t value);

/** Whether a text is in the set; its number goes to *value, which may be NULL. */
bool clod_index_find(const clod_index *self, const char *text, size_t length, size_t *value);
