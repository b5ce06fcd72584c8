#pragma once
/**
 * @file dealt_graph.h
 * A graph of contacts whose grains are dealt to ranks: each has its own, their partners as ghosts, and
 * all contacts of own ones.
 */

#include <string.h>

#include "base/assert.h"
#include "measure/survey.h"
#include "support/contact_graph.h"
#include "support/dice.h"
#include "support/ranks_threads.h"

#define DEALT_GRAINS 300
#define DEALT_RANKS 7
#define DEALT_BYTES 72 // of a row that is shared

/** How grains are dealt. */
typedef enum dealing {
    DEALT_ANYHOW,    ///< most contacts are across ranks
    DEALT_IN_TURN,   ///< one row to each rank: a chain crosses at every contact
    DEALT_IN_SLICES, ///< runs of rows: a chain crosses where a run ends
    DEALT_TO_TWO,    ///< other ranks have none
    DEALINGS
} dealing;

typedef struct dealt_graph {
    contact_graph whole;
    int32_t owner[DEALT_GRAINS];
    int ranks;
    // of each rank
    contact_graph part[DEALT_RANKS];
    int32_t row[DEALT_RANKS][DEALT_GRAINS];        ///< of the whole graph
    int32_t owner_here[DEALT_RANKS][DEALT_GRAINS]; ///< of each row
    char board[DEALT_GRAINS][DEALT_BYTES];         ///< rows that are shared
} dealt_graph;

/** A rank that looks at its part. */
typedef struct dealt_rank {
    dealt_graph *graph;
    clod_ranks *ranks;
} dealt_rank;

/** Own rows, their partners, and their contacts. */
static inline void dealt_part(dealt_graph *self, int rank)
{
    contact_graph *part = &self->part[rank];
    const clod_state *whole = &self->whole.state;
    int32_t to[DEALT_GRAINS];
    bool here[DEALT_GRAINS];
    for (int g = 0; g < DEALT_GRAINS; g++) {
        here[g] = self->owner[g] == rank;
    }
    for (size_t k = 0; k < whole->contact_count; k++) {
        const clod_contact *c = &whole->contacts[k];
        if (c->shape < 0 && (self->owner[c->i] == rank || self->owner[c->j] == rank)) {
            here[c->i] = here[c->j] = true;
        }
    }
    graph_init(part, whole->contact_capacity);
    part->contacts.laws = self->whole.contacts.laws;
    part->contacts.carrier = self->whole.contacts.carrier;
    part->state.domain = whole->domain;
    for (int g = 0; g < DEALT_GRAINS; g++) {
        if (here[g]) {
            const double *p = whole->grains.position[g];
            to[g] = graph_grain(part, whole->grains.id[g], p[0], p[2], p[3]);
            if (self->owner[g] == rank) { // that of a ghost is of another moment
                memcpy(part->state.grains.velocity[to[g]], whole->grains.velocity[g],
                       sizeof *whole->grains.velocity);
            }
            self->row[rank][to[g]] = g;
            self->owner_here[rank][to[g]] = self->owner[g];
        }
    }
    for (size_t k = 0; k < whole->contact_count; k++) {
        clod_contact c = whole->contacts[k];
        if (self->owner[c.i] == rank || (c.shape < 0 && self->owner[c.j] == rank)) {
            c.i = to[c.i];
            c.j = c.shape < 0 ? to[c.j] : c.j;
            part->state.contacts[part->state.contact_count++] = c;
            part->state.wall_contact_count += c.shape >= 0;
        }
    }
}

/** Deal the whole graph to so many ranks. */
static inline void dealt_begin(dealt_graph *self, dealing how, int ranks, uint64_t seed)
{
    dice roll = {seed};
    self->ranks = ranks;
    for (int g = 0; g < DEALT_GRAINS; g++) {
        self->owner[g] = how == DEALT_ANYHOW      ? dice_pick(&roll, ranks)
                         : how == DEALT_IN_TURN   ? g % ranks
                         : how == DEALT_IN_SLICES ? g * ranks / DEALT_GRAINS
                                                  : (ranks - 1) * (g / 5 % 2);
    }
    for (int r = 0; r < ranks; r++) {
        dealt_part(self, r);
    }
}

static inline void dealt_end(dealt_graph *self)
{
    for (int r = 0; r < self->ranks; r++) {
        graph_fini(&self->part[r]);
    }
}

/** As of clod_survey_part: by a board that all ranks see. */
static inline void dealt_share(const void *context, void *column, size_t size)
{
    const dealt_rank *self = context;
    dealt_graph *graph = self->graph;
    const int rank = self->ranks->rank;
    const size_t count = graph->part[rank].state.grains.count;
    char *rows = column;
    clod_status status;
    CLOD_ASSERT(size <= DEALT_BYTES);
    for (int turn = 0; turn < 2; turn++) {
        for (size_t g = 0; g < count; g++) {
            char *there = graph->board[graph->row[rank][g]];
            const bool own = graph->owner_here[rank][g] == rank;
            if (own && turn == 0) {
                memcpy(there, rows + g * size, size);
            } else if (!own && turn == 1) {
                memcpy(rows + g * size, there, size);
            }
        }
        CLOD_ASSERT(clod_ranks_agree(self->ranks, true, &status)); // all have been there
    }
}

/** What a rank has of it. */
static inline clod_survey_part dealt_here(const dealt_rank *self)
{
    const int rank = self->ranks->rank;
    contact_graph *part = &self->graph->part[rank];
    return (clod_survey_part){.state = &part->state,
                              .contacts = &part->contacts,
                              .owner = self->graph->owner_here[rank],
                              .ranks = self->ranks,
                              .share = dealt_share,
                              .context = self};
}
