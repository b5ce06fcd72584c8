#pragma once
/**
 * @file crew_part.h
 * One rank's part of a bed that a crew steps, and what all ranks do with theirs when rank 0 orders
 * it.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/step/test_ranks.c
 */

#include "step/crew.h"
#include "step/crew_deal.h"
#include "step/crew_places.h"
#include "step/crew_slabs.h"

struct clod_crew {
    clod_ranks *ranks;           ///< borrowed
    clod_step *whole;            ///< of rank 0; NULL on the others
    bool stale;                  ///< the whole state's grains are those of an earlier step
    clod_step_options options;   ///< that it began with
    int64_t rebuilds, refreshes; ///< of the whole step before it began
    clod_state state;            ///< of this rank
    clod_crew_share share;       ///< that it was dealt before it began
    clod_crew_places places;     ///< of grains that are being put, before it began
    clod_laws laws;
    clod_spread spread;
    clod_step step;
    clod_crew_slabs slabs; ///< while the bed is written
    bool ledger;           ///< on all ranks: steps keep it, and messages have what it needs
    // on all ranks: what comes before steps has failed, for good; columns of grains may differ
    bool broken;
    clod_status status; ///< then
};

/** What rank 0 can order. */
typedef enum clod_crew_order_kind {
    CLOD_CREW_DEAL_BEGIN,
    CLOD_CREW_DEAL,
    CLOD_CREW_DEAL_NEAR,
    CLOD_CREW_DEAL_CONTACTS,
    CLOD_CREW_PLACES,
    CLOD_CREW_BEGIN,
    CLOD_CREW_ADVANCE,
    CLOD_CREW_SEE,
    CLOD_CREW_SEE_NEAR,
    CLOD_CREW_TAKE,
    CLOD_CREW_STORE,
    CLOD_CREW_SURVEY,
    CLOD_CREW_GONE,
    CLOD_CREW_SLABS_BEGIN,
    CLOD_CREW_SLABS_BRING,
    CLOD_CREW_SLABS_WRITE,
    CLOD_CREW_SLABS_END,
    CLOD_CREW_HASH,
    CLOD_CREW_END,
    CLOD_CREW_DISMISS
} clod_crew_order_kind;

/** What rank 0 wants the others to do with it. */
typedef struct clod_crew_order {
    clod_crew_order_kind what;
    int64_t steps; ///< of an advance
    int boxes;     ///< of a look at some places; they follow
    bool clumps;   ///< somebody may have found other clumps, or any at a beginning
    // of a beginning
    bool dealt; ///< every rank has its share of the rows (crew_deal.h); else rank 0 has all
    bool fresh; ///< nobody has stepped them
    int threads;
    bool brute_force;
    double overlap_limit;
    clod_balance_options balance;
    char simd[16];
} clod_crew_order;

/** Make the part of this rank, of a bed that rank 0 has or ranks were dealt (crew_begin.c). False on
 *  all alike. */
bool clod_crew_part_begin(clod_crew *self, const clod_crew_order *what, clod_status *status);

/** Contacts that ranks were dealt go to the owners of their grains, whose rows are there (crew_route.c).
 *  False on all alike: no memory, or contacts of grains that nobody has. */
bool clod_crew_part_route(clod_crew *self, clod_status *status);

/** As clod_step_advance. */
bool clod_crew_part_advance(clod_crew *self, const clod_crew_order *what, clod_status *status);

/** Gather the whole state on rank 0. */
bool clod_crew_part_see(clod_crew *self, const clod_crew_order *what, clod_status *status);

/** Gather the grains that reach into the boxes, which rank 0 tells. */
bool clod_crew_part_see_near(clod_crew *self, const clod_crew_order *what, clod_domain_box *box,
                             clod_status *status);

/** Grains that are in the queue of rank 0 come. */
bool clod_crew_part_take(clod_crew *self, const clod_crew_order *what, clod_status *status);

/** An order to the others. Threads: rank 0. */
void clod_crew_give(const clod_crew *self, clod_crew_order_kind what);

/** Whether nothing before steps has failed yet; else what it was. */
bool clod_crew_part_is_whole(const clod_crew *self, clod_status *status);

/** Walls and numbers of rank 0, and what follows from them; false on all ranks alike: something
 *  has failed for good. */
bool clod_crew_part_update(clod_crew *self, clod_status *status);

/** The same with what else an order brings: before looks, sums, steps and changes. */
bool clod_crew_part_prepare(clod_crew *self, const clod_crew_order *what, clod_status *status);

/** Bring rank 0 the grains that have left one by one. */
bool clod_crew_part_see_gone(clod_crew *self, clod_status *status);

/** As clod_step_store, of all ranks. */
void clod_crew_part_store(clod_crew *self, clod_step_stored *sums);

/** Nothing is left of the part. */
void clod_crew_part_end(clod_crew *self);
