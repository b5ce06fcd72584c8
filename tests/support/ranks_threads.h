#pragma once
/**
 * @file ranks_threads.h
 * Ranks as threads of one process: a debugger and ThreadSanitizer see them all. Nothing depends
 * on which thread comes first.
 */

#include <limits.h>
#include <pthread.h>
#include <stdatomic.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "parallel/gate.h"
#include "parallel/ranks.h"

#define RANKS_MOST 64
#define RANKS_WORDS 16 ///< from one rank to another that nobody has looked for

/** What one rank has for another, in which of its exchanges it said so, and in which of the
 * other's it was taken. */
typedef struct ranks_box {
    const clod_message *sent;
    uint64_t exchange, taken;
} ranks_box;

/** Messages that a rank repeats. */
typedef struct ranks_kept {
    const clod_message *out, *in;
    int outs, ins;
} ranks_kept;

/** Words of a rank for another, in their order. */
typedef struct ranks_words {
    int word[RANKS_WORDS]; ///< a ring
    int posted, found;
} ranks_words;

/** Ranks wait for those alone that they send to or get from, as MPI's do. */
typedef struct ranks_team {
    clod_gate sent[RANKS_MOST]; ///< opened by a rank in each exchange when all is in the boxes,
    clod_gate taken[RANKS_MOST];           ///< and when it has what others sent
    ranks_box box[RANKS_MOST][RANKS_MOST]; ///< [to][from]
    ranks_kept kept[RANKS_MOST];
    ranks_words words[RANKS_MOST][RANKS_MOST]; ///< [to][from]
    pthread_mutex_t lock;                      ///< of the words
    atomic_int members;                        ///< of a group: those that have not left it
    clod_ranks rank[RANKS_MOST];
    void (*run)(clod_ranks *ranks, void *context);
    void *context;
} ranks_team;

/** Take a message; its sender must have said as many bytes. */
static inline void ranks_take(const clod_ranks *self, uint64_t exchange, const clod_message *in)
{
    ranks_team *team = self->group;
    clod_gate_wait(&team->sent[in->peer], exchange);
    ranks_box *box = &team->box[self->rank][in->peer];
    CLOD_ASSERT(box->exchange == exchange); // cmocka fails in the first thread alone
    CLOD_ASSERT(box->sent->bytes == in->bytes);
    memcpy(in->data, box->sent->data, in->bytes);
    box->taken = exchange;
}

static inline void ranks_exchange(clod_ranks *self, const clod_message *out, int outs,
                                  const clod_message *in, int ins)
{
    ranks_team *team = self->group;
    const uint64_t exchange = clod_gate_opened(&team->sent[self->rank]) + 1;
    for (int k = 0; k < outs; k++) {
        if (out[k].bytes > 0) {
            ranks_box *box = &team->box[out[k].peer][self->rank];
            CLOD_ASSERT(box->exchange < exchange); // at most one message from each to each
            box->sent = &out[k];
            box->exchange = exchange;
        }
    }
    clod_gate_open(&team->sent[self->rank]);
    for (int k = 0; k < ins; k++) {
        if (in[k].bytes > 0) {
            ranks_take(self, exchange, &in[k]);
        }
    }
    clod_gate_open(&team->taken[self->rank]);
    for (int k = 0; k < outs; k++) { // until then the bytes must stay
        if (out[k].bytes > 0) {
            clod_gate_wait(&team->taken[out[k].peer], exchange);
            CLOD_ASSERT(team->box[out[k].peer][self->rank].taken == exchange);
        }
    }
}

static inline bool ranks_keep(clod_ranks *self, const clod_message *out, int outs,
                              const clod_message *in, int ins)
{
    ranks_team *team = self->group;
    team->kept[self->rank] = (ranks_kept){out, in, outs, ins};
    return true;
}

/** Nobody waits yet: what is in their places is taken at the end. */
static inline void ranks_start(clod_ranks *self)
{
    (void)self;
}

static inline void ranks_finish(clod_ranks *self)
{
    const ranks_team *team = self->group;
    const ranks_kept *kept = &team->kept[self->rank];
    ranks_exchange(self, kept->out, kept->outs, kept->in, kept->ins);
}

static inline void ranks_post(clod_ranks *self, int to, int word)
{
    ranks_team *team = self->group;
    ranks_words *words = &team->words[to][self->rank];
    CLOD_ASSERT(word >= 0 && word <= 7);
    pthread_mutex_lock(&team->lock);
    CLOD_ASSERT(words->posted - words->found < RANKS_WORDS);
    words->word[words->posted++ % RANKS_WORDS] = word;
    pthread_mutex_unlock(&team->lock);
}

static inline bool ranks_look(clod_ranks *self, int from, int *word)
{
    ranks_team *team = self->group;
    ranks_words *words = &team->words[self->rank][from];
    pthread_mutex_lock(&team->lock);
    const bool there = words->found < words->posted;
    if (there) {
        *word = words->word[words->found++ % RANKS_WORDS];
    }
    pthread_mutex_unlock(&team->lock);
    return there;
}

/** Gates that yield: a test shares the machine with others, and spinning costs two ranks five times the
 *  processor time of their work. */
static inline void ranks_team_init(ranks_team *team, int size)
{
    memset(team->box, 0, sizeof team->box);
    memset(team->words, 0, sizeof team->words);
    for (int r = 0; r < size; r++) {
        clod_gate_init(&team->sent[r], INT_MAX);
        clod_gate_init(&team->taken[r], INT_MAX);
    }
    team->lock = (pthread_mutex_t)PTHREAD_MUTEX_INITIALIZER;
    atomic_init(&team->members, size);
}

static inline bool ranks_split(clod_ranks *self, int colour, clod_ranks *part,
                               clod_status *status);

/** The last of a group removes what its ranks have in common. */
static inline void ranks_part(clod_ranks *part)
{
    ranks_team *team = part->group;
    clod_ranks_fini(part);
    if (atomic_fetch_sub(&team->members, 1) == 1) {
        clod_memory_free(team);
    }
}

static inline clod_ranks ranks_of(ranks_team *team, int rank, int size)
{
    return (clod_ranks){.rank = rank,
                        .size = size,
                        .exchange = ranks_exchange,
                        .keep = ranks_keep,
                        .start = ranks_start,
                        .finish = ranks_finish,
                        .split = ranks_split,
                        .part = ranks_part,
                        .post = ranks_post,
                        .look = ranks_look,
                        .group = team};
}

/** The first rank of each colour makes what its group needs, and all learn where it is. */
static inline bool ranks_split(clod_ranks *self, int colour, clod_ranks *part,
                               clod_status *status)
{
    int colours[RANKS_MOST], first = -1, before = 0, size = 0;
    ranks_team *made = NULL, *teams[RANKS_MOST];
    clod_ranks_gather(self, &colour, sizeof colour, colours);
    for (int r = 0; r < self->size; r++) {
        if (colours[r] == colour) {
            first = first < 0 ? r : first;
            before += r < self->rank;
            size++;
        }
    }
    if (self->rank == first) {
        made = clod_memory_alloc(1, sizeof *made);
        CLOD_ASSERT(made != NULL);
        ranks_team_init(made, size);
    }
    clod_ranks_gather(self, &made, sizeof made, teams);
    *part = ranks_of(teams[first], before, size);
    CLOD_ASSERT(clod_ranks_init(part, status));
    return true;
}

static inline void *ranks_thread(void *argument)
{
    clod_ranks *ranks = argument;
    ranks_team *team = ranks->group;
    team->run(ranks, team->context);
    return NULL;
}

/** Run a function as so many ranks; all have returned when this does. */
static inline void ranks_run(int size, void (*run)(clod_ranks *ranks, void *context),
                             void *context)
{
    static ranks_team team;
    clod_status status = {0};
    pthread_t thread[RANKS_MOST];
    CLOD_ASSERT(size <= RANKS_MOST);
    team.run = run;
    team.context = context;
    ranks_team_init(&team, size);
    for (int r = 0; r < size; r++) {
        team.rank[r] = ranks_of(&team, r, size);
        CLOD_ASSERT(clod_ranks_init(&team.rank[r], &status));
    }
    for (int r = 1; r < size; r++) {
        CLOD_ASSERT(pthread_create(&thread[r], NULL, ranks_thread, &team.rank[r]) == 0);
    }
    run(&team.rank[0], context);
    for (int r = 1; r < size; r++) {
        pthread_join(thread[r], NULL);
    }
    for (int r = 0; r < size; r++) {
        clod_ranks_fini(&team.rank[r]);
    }
}
