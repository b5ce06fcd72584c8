#pragma once
/**
 * @file ranks_threads.h
 * Ranks as threads of one process: a debugger and ThreadSanitizer see them all. Nothing depends
 * on which thread comes first.
 */

#include <pthread.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "parallel/barrier.h"
#include "parallel/ranks.h"

#define RANKS_MOST 64

/** What a rank shows the others until the next barrier. */
typedef struct ranks_post {
    const clod_message *out;
    int outs;
} ranks_post;

/** Messages that a rank repeats. */
typedef struct ranks_kept {
    const clod_message *out, *in;
    int outs, ins;
} ranks_kept;

typedef struct ranks_team {
    clod_barrier barrier;
    ranks_kept kept[RANKS_MOST];
    ranks_post post[RANKS_MOST];
    clod_ranks rank[RANKS_MOST];
    void (*run)(clod_ranks *ranks, void *context);
    void *context;
} ranks_team;

/** What rank `from` has for this one; both must have said how much. */
static inline const clod_message *ranks_find(const clod_ranks *self, int from)
{
    const ranks_team *team = self->group;
    for (int k = 0; k < team->post[from].outs; k++) {
        if (team->post[from].out[k].peer == self->rank) {
            return &team->post[from].out[k];
        }
    }
    return NULL;
}

static inline void ranks_exchange(clod_ranks *self, const clod_message *out, int outs,
                                  const clod_message *in, int ins)
{
    ranks_team *team = self->group;
    team->post[self->rank].out = out;
    team->post[self->rank].outs = outs;
    clod_barrier_wait(&team->barrier);
    for (int k = 0; k < ins; k++) {
        const clod_message *sent = ranks_find(self, in[k].peer);
        const size_t bytes = sent != NULL ? sent->bytes : 0;
        CLOD_ASSERT(bytes == in[k].bytes); // cmocka fails in the first thread alone
        if (bytes > 0) {
            memcpy(in[k].data, sent->data, bytes);
        }
    }
    clod_barrier_wait(&team->barrier);
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
    clod_barrier_init(&team.barrier, size);
    for (int r = 0; r < size; r++) {
        team.rank[r] = (clod_ranks){.rank = r,
                                    .size = size,
                                    .exchange = ranks_exchange,
                                    .keep = ranks_keep,
                                    .start = ranks_start,
                                    .finish = ranks_finish,
                                    .group = &team};
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
