#pragma once
/**
 * @file spread_wear.h
 * Sums of surfaces where grains are spread over ranks: doubles have an order, that of one process.
 * So each rank notes what its contacts did to the walls in a step, and rank 0 adds it up in that
 * order.
 *
 * Threads  thread 0 of each rank.   Test  tests/step/test_ranks.c
 */

#include "state/impacts.h"
#include "state/wear.h"
#include "step/spread.h"

/** What one contact did in a step. */
struct clod_wear_record {
    uint64_t key, id; ///< of its grain: order of grains
    int64_t group;    ///< law and form: of contacts
    int64_t number;   ///< of those of a rank
    int32_t wall, place, face;
    int32_t begins; ///< with `impact`
    clod_impact impact;
    double sum[CLOD_WEAR_SUMS];
};

/**
 * Note a contact.
 *
 * @param group  of the near list
 * @param row    of its grain
 * @return       for wall, place and sums, which are zero; until the next call; NULL without memory,
 *               which clod_spread_wear_add finds
 */
clod_wear_record *clod_spread_wear_note(clod_step *step, size_t group, int32_t row);

/** Add what all ranks have noted in this step; rank 0 has the sums. Without memory
 *  spread->wear_lost on all. Threads: all ranks at the same time. */
void clod_spread_wear_add(clod_step *step);
