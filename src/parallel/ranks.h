#pragma once
/**
 * @file ranks.h
 * Ranks that compute one bed together: what they say to each other. One call does everything, and
 * three more do again and again what is the same each time; they are MPI's (ranks_mpi.c) or those of
 * threads in one process (tests/support/ranks_threads.h).
 *
 * All ranks make the same calls in the same order. What a rank gets does not depend on who comes
 * first, so neither does any result.
 *
 * Threads  one of each rank.   Test  tests/parallel/test_rank_messages.c
 */

#include <stdbool.h>
#include <stddef.h>

#include "base/bytes.h"
#include "clod/status.h"
#include "parallel/rank_places.h"

/** Bytes to or from another rank. */
typedef struct clod_message {
    int peer;
    void *data; ///< borrowed
    size_t bytes;
} clod_message;

/** What a rank has said and how long it waited for others, since it began. */
typedef struct clod_ranks_count {
    int64_t merges, exchanges;           ///< calls
    int64_t messages, bytes;             ///< to other ranks, in exchanges
    int64_t merge_messages, merge_bytes; ///< the same in merges
    double waited;                       ///< s in both
    double spun;                         ///< s, of processor time in both
} clod_ranks_count;

/** How even the work of all ranks was, as seen at rebuilds; the same on all. */
typedef struct clod_ranks_evenness {
    int64_t looks, cuts; ///< how often it was looked at, and the bed was cut anew for it
    int64_t moved;       ///< grains that got another owner
    double sum, most;    ///< of the most work of a rank over the mean, at each look
} clod_ranks_evenness;

typedef struct clod_ranks clod_ranks;
struct clod_ranks {
    int rank, size;
    /** Messages between pairs of ranks: at most one from each to each, which both name with the
     *  same number of bytes; empty ones may be named by one of them alone. */
    void (*exchange)(clod_ranks *self, const clod_message *out, int outs,
                     const clod_message *in, int ins);
    /** Messages as of exchange, which start sends each time with what is in their places then; they have
     *  arrived after finish. Other calls may come between; the places are not to be touched there.
     *  They replace those before them; false without memory, on this rank alone. */
    bool (*keep)(clod_ranks *self, const clod_message *out, int outs, const clod_message *in,
                 int ins);
    void (*start)(clod_ranks *self);
    void (*finish)(clod_ranks *self);
    /** Groups of ranks: those with the same colour, in their order. NULL: these ranks are not
     *  split. */
    bool (*split)(clod_ranks *self, int colour, clod_ranks *part, clod_status *status);
    void (*part)(clod_ranks *part); ///< close a group
    /** A word to another rank, which finds it when it looks; 0 to 7. Words from one rank to
     *  another come in their order. */
    void (*post)(clod_ranks *self, int to, int word);
    bool (*look)(clod_ranks *self, int from, int *word); ///< whether one is there; it is taken
    clod_rank_place *place; ///< [size] where they run; NULL: not known; owned
    clod_ranks_count count;
    clod_ranks_evenness evenness;
    int64_t kept_messages, kept_bytes; ///< of a start
    void *group;                       ///< what these need
    void *user;            ///< of rank 0: the simulation that they step; NULL: they are free
    bool dismissed;        ///< rank 0 has no more orders
    char *room;            ///< scratch of the functions below; owned
    size_t room_bytes;     ///< of it
    clod_message *message; ///< [2 * size] scratch; owned
    size_t *number;        ///< [3 * size] scratch; owned
};

/** As the call of the same name, and counted. */
void clod_ranks_exchange(clod_ranks *self, const clod_message *out, int outs,
                         const clod_message *in, int ins);

/** The same of the others: the messages are borrowed until others are kept. */
bool clod_ranks_keep(clod_ranks *self, const clod_message *out, int outs,
                     const clod_message *in, int ins, clod_status *status);
void clod_ranks_start(clod_ranks *self);
void clod_ranks_finish(clod_ranks *self);

/** Ranks whose processors are all among those of this one, itself counted; all, where places are not
 *  known. */
int clod_ranks_beside(const clod_ranks *self);

/** Scratch of the functions below; false without memory. Then clod_ranks_fini. */
bool clod_ranks_init(clod_ranks *self, clod_status *status);
void clod_ranks_fini(clod_ranks *self);

/**
 * Have room for sums of so many bytes, for clod_ranks_merge.
 *
 * @return  false without memory on any rank, on all alike
 */
bool clod_ranks_reserve(clod_ranks *self, size_t bytes, clod_status *status);

/**
 * Merge what every rank has: all get the same. Pairs of ranks merge, then pairs of pairs
 * (recursive doubling; Thakur, Rabenseifner, Gropp 2005): log2(size) rounds, and two more where
 * size is no power of two. What comes from lower ranks is always `into`: with a merge that is
 * associative the result is that in the order of ranks. With one that is not, such as a sum that
 * rounds, all ranks have the same bits, but others than another number of ranks has. Allocates
 * nothing.
 *
 * @param data   [in,out] of this rank, then of all; all bytes count, so none may be undefined
 * @param bytes  at most those reserved
 * @param merge  adds `from` to `into`
 */
void clod_ranks_merge(clod_ranks *self, void *data, size_t bytes,
                      void (*merge)(const void *context, void *into, const void *from),
                      const void *context);

/** Bytes of rank 0 to all, handed on by those that have them. */
void clod_ranks_tell(clod_ranks *self, void *data, size_t bytes);

/** The bytes of every rank, the same number of each, to all, by way of rank 0: [size][bytes]. */
void clod_ranks_gather(clod_ranks *self, const void *mine, size_t bytes, void *all);

/**
 * Whether it went well on all ranks; else the status of the first on which it did not, on all.
 *
 * @param status  of this rank if it did not; of all in the end
 */
bool clod_ranks_agree(clod_ranks *self, bool good, clod_status *status);

/**
 * Bytes from each rank to each; ranks that have none for each other exchange no message for them.
 * How many come from whom all ranks learn in log2(size) rounds of size / 2 numbers, rounded up
 * (Bruck, Ho, Kipnis, Upfal, Weathersby 1997, doi:10.1109/71.642949).
 *
 * @param out    [size] for each rank, this one too
 * @param in     [out] one behind the other, in the order of ranks
 * @param begin  [size + 1] [out] where those of each rank begin in it
 * @return       false without memory on any rank, on all alike
 */
bool clod_ranks_swap(clod_ranks *self, const clod_bytes *out, clod_bytes *in, size_t *begin,
                     clod_status *status);
