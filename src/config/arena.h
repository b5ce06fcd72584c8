#pragma once
/**
 * @file arena.h
 * Memory that is given out in pieces and freed all at once: the tree of a case file.
 */

#include <stddef.h>

typedef struct clod_arena {
    struct clod_arena_block *last; ///< owned
} clod_arena;

/** Zeroed memory that lives as long as the arena, or NULL when there is none. */
void *clod_arena_alloc(clod_arena *self, size_t size);

/** Copy of the first `length` bytes of a text, ended by a zero byte; or NULL. */
char *clod_arena_text(clod_arena *self, const char *text, size_t length);

/** Free everything that was given out. */
void clod_arena_fini(clod_arena *self);
