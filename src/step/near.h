#pragma once
/**
 * @file near.h
 * The pairs the force loop looks at: candidates within a thin skin, as blocks of one law each,
 * with a slot for every grain's share of every force. Made anew when motion has used the skin
 * up. Pairs that do not touch add exactly zero, so the list itself never changes a bit.
 */

#include "step/kernel.h"
#include "step/neighbour.h"

typedef struct clod_near_blocks {
    void *block, *old; ///< clod_contact_block or clod_wall_block; `old` is scratch
    size_t count, capacity, old_capacity;
    size_t *law_start;       ///< [laws + 1] first block of each law
    clod_spent_block *spent; ///< [count] with the ledger, else NULL
    size_t spent_capacity;
} clod_near_blocks;

typedef struct clod_near {
    double skin; ///< m, of the list as it is
    clod_near_blocks pairs, walls;
    int32_t *slot_start; ///< [grains + 1]; a grain's slots ascend by partner, walls last
    int32_t *slot_fill;  ///< scratch [grains]
    double (*slots)[8];
    size_t slot_capacity, slot_start_capacity;
    int32_t *wall_slot_start; ///< [walls + 1]; a wall's slots ascend by grain
    int32_t *wall_slot_fill;  ///< scratch
    double (*wall_slots)[8];
    size_t wall_slot_capacity;
    bool ledger; ///< keep room for what the contacts spend
} clod_near;

/**
 * Make the near list.
 *
 * @param neighbour      candidates; their lanes are set to the new blocks
 * @param pose           [walls] poses now
 * @param skin           thin skin [m]
 * @param from_contacts  history comes from state->contacts, else from the old blocks
 * @return               false without memory
 */
bool clod_near_make(clod_near *self, clod_neighbour *neighbour, const clod_state *state,
                    const clod_laws *laws, const clod_wall_pose *pose, double skin,
                    bool from_contacts, clod_status *status);

/** Room for what each contact of the list spends, when `ledger` is set. */
bool clod_near_reserve_spent(clod_near *self);

/** Append the history of every closed contact to state->contacts (emptied first), sorted. */
bool clod_near_export(const clod_near *self, clod_neighbour *neighbour, clod_state *state,
                      clod_status *status);

void clod_near_fini(clod_near *self);
