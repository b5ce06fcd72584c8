#pragma once
/**
 * @file deal.h
 * The grains of a free run on their way to several ranks while they are made.
 *
 * Threads  rank 0; the others serve.   Test  tests/sim/test_deal.c
 */

#include "base/bytes.h"
#include "parallel/ranks.h"
#include "setup/pieces.h"

typedef struct clod_deal {
    clod_ranks *ranks;
    clod_bytes places; ///< that were asked for last; owned
    clod_setup_taker taker;
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

void clod_deal_fini(clod_deal *self);
