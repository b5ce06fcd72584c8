#pragma once
/**
 * @file rank_places.h
 * Where ranks run: hosts, and the processors of them that they may use.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CLOD_PLACE_WORDS 16 ///< of 64 processors each
#define CLOD_PLACE_HOST 256 ///< bytes of the longest name of a host, and its end

typedef struct clod_rank_place {
    char host[CLOD_PLACE_HOST];
    uint64_t processor[CLOD_PLACE_WORDS]; ///< bit k of word w: number 64 w + k is allowed
} clod_rank_place;

/** Of this process. A host whose name the system does not say is "?"; then, and where the system
 *  does not say which processors are allowed, none is set. */
clod_rank_place clod_rank_place_here(void);

/** How many processors it may use; 0: not known. */
int clod_rank_place_processors(const clod_rank_place *self);

#define CLOD_PLACE_LIST 4096 ///< bytes of the longest list of processors, and its end

/** Their numbers, as the system writes them: "0-3,8"; "": not known. */
void clod_rank_place_list(const clod_rank_place *self, char list[CLOD_PLACE_LIST]);

/** Ranks of one host. */
typedef struct clod_rank_host {
    const char *name; ///< borrowed
    int ranks;
    int processors; ///< 0: not known of one of its ranks
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

/**
 * The ranks of a host that have to share processors: of those that may use no others than some rank of the host
 * may, the first group that has more than that.
 *
 * @param threads  of each rank
 * @param host     [in,out] of `rank`, the first of its host; its ranks and processors become those of the group
 * @return         false: each thread can have a processor of its own, as far as this tells
 * Errors  none.   Threads  pure.   Test  tests/parallel/test_rank_places.c
 */
bool clod_rank_places_crowded(const clod_rank_place *place, int ranks, int rank, int threads,
                              clod_rank_host *host);

/**
 * Ranks whose processors are all among those of one of them, itself counted. Processors that only overlap do not count.
 *
 * @param place  [ranks]
 * Errors  none.   Threads  pure.   Test  tests/parallel/test_rank_places.c
 */
int clod_rank_places_beside(const clod_rank_place *place, int ranks, int rank);
