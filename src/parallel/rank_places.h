#pragma once
/**
 * @file rank_places.h
 * Where ranks run: hosts, and the processors of them that they may use.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CLOD_PLACE_WORDS 16 ///< of 64 processors each

typedef struct clod_rank_place {
    char host[64];
    uint64_t processor[CLOD_PLACE_WORDS]; ///< bit k of word w: number 64 w + k is allowed
} clod_rank_place;

/** Of this process; a host without a name is "?". */
clod_rank_place clod_rank_place_here(void);

/** How many processors it may use. */
int clod_rank_place_processors(const clod_rank_place *self);

/** Ranks of one host. */
typedef struct clod_rank_host {
    const char *name; ///< borrowed
    int ranks, processors;
} clod_rank_host;

/**
 * The host of a rank, if no rank before it is there.
 *
 * @param place  [ranks]
 * @param host   [out] all ranks on it, and all processors that any of them may use
 * @return       false: an earlier rank is there
 * Errors  none.   Threads  pure.   Test  tests/parallel/test_rank_places.c
 */
bool clod_rank_places_host(const clod_rank_place *place, int ranks, int rank,
                           clod_rank_host *host);
