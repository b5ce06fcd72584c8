#pragma once
/**
 * @file crew_deal.h
 * A bed that is dealt while it is made: rank 0 makes grains piece by piece, and every rank, rank 0
 * too, gets an equal share of each piece, wherever its grains are. So no rank ever has a list of all.
 * clod_step_init with options.dealt begins with what all have.
 *
 * Test  tests/step/test_ranks_deal.c
 */

#include "base/bytes.h"
#include "parallel/ranks.h"
#include "state/domain.h"
#include "state/state.h"

typedef struct clod_crew_share clod_crew_share;

/** What a rank has been dealt beside rows of a state. */
struct clod_crew_share {
    clod_bytes contacts; ///< as records, anybody's; owned
};

void clod_crew_share_fini(clod_crew_share *self);

/**
 * Begin: what was dealt before, and nobody has stepped, is dropped.
 *
 * @param state  of rank 0, with the columns that grains have
 * @param rows   that will be dealt in all: every rank makes room for its share of them
 * @param piece  of them at a time, for which rank 0 has room too
 * @return      false without memory on any rank.   Threads  rank 0; the others serve.
 */
bool clod_crew_deal_begin(clod_ranks *ranks, clod_state *state, size_t rows, size_t piece,
                          clod_status *status);

/**
 * Deal the rows of a state from `kept` on; those that stay here follow the ones before.
 *
 * @param state  [in,out] its grains only, none of which has been stepped
 * @return       false without memory on any rank.   Threads  rank 0; the others serve.
 */
bool clod_crew_deal(clod_ranks *ranks, clod_state *state, size_t kept, clod_status *status);

/**
 * Deal contacts, those of a bed that has been stepped, when all grains have been dealt.
 *
 * @param share     [in,out] those that stay with rank 0
 * @param partners  [count] ids of both grains; id of the grain and number of the wall
 * @return          false without memory on any rank.   Threads  rank 0; the others serve.
 */
bool clod_crew_deal_contacts(clod_ranks *ranks, clod_crew_share *share,
                             const clod_contact *contacts, const uint64_t (*partners)[2],
                             size_t count, clod_status *status);

/**
 * Places of the dealt grains of all other ranks that reach into a box.
 *
 * @param domain  whose periodic images count
 * @param places  [out] x, y, z, radius of each [m]; emptied first, owned
 * @return        false without memory on any rank.   Threads  rank 0; the others serve.
 */
bool clod_crew_deal_near(clod_ranks *ranks, const clod_domain *domain,
                         const clod_domain_box *box, clod_bytes *places, clod_status *status);

// ---- what the others do then

bool clod_crew_part_deal_begin(clod_ranks *ranks, clod_state *state, clod_status *status);
bool clod_crew_part_deal(clod_ranks *ranks, clod_state *state, clod_status *status);
bool clod_crew_part_deal_contacts(clod_ranks *ranks, clod_crew_share *share,
                                  clod_status *status);
bool clod_crew_part_deal_near(clod_ranks *ranks, const clod_state *state, clod_status *status);

/** No row is left. */
void clod_crew_deal_drop(clod_state *state);
