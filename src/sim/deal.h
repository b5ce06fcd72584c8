#pragma once
/**
 * @file deal.h
 * The bed of a free run on its way to several ranks, while its grains are made or its checkpoint is
 * read: no rank has a list of all.
 *
 * Threads  rank 0; the others serve.   Test  tests/sim/test_deal.c, test_deal_again.c
 */

#include "base/bytes.h"
#include "parallel/ranks.h"
#include "setup/pieces.h"
#include "state/bed_taker.h"
#include "step/crew_deal.h"
#include "step/crew_places.h"

typedef struct clod_deal {
    clod_ranks *ranks;
    clod_bytes places; ///< that were asked for last; owned
    clod_setup_taker taker;
    clod_setup_keeper keeper;
    clod_crew_places kept;  ///< of rank 0, of grains that are being put; owned
    clod_crew_share *share; ///< borrowed, as the next
    const int64_t *finished;
    clod_bed_taker again;
} clod_deal;

/**
 * Who takes the grains of a case.
 *
 * @param self   [out] clod_deal_fini, in any case
 * @param ranks  borrowed; NULL: this process alone
 * @return       NULL: rank 0 keeps them all
 */
const clod_setup_taker *clod_deal_begin(clod_deal *self, clod_ranks *ranks,
                                        const clod_case *from);

/**
 * Who takes the bed of a checkpoint.
 *
 * @param share     [out] that of rank 0 beside rows; until clod_step_init takes it
 * @param finished  read with the checkpoint: not 0: the run is, and nobody takes it
 * @return          NULL: rank 0 keeps it all
 */
const clod_bed_taker *clod_deal_again(clod_deal *self, clod_ranks *ranks,
                                      clod_crew_share *share, const int64_t *finished);

void clod_deal_fini(clod_deal *self);
