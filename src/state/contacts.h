#pragma once
/**
 * @file contacts.h
 * Contacts and their history, in blocks of CLOD_LANES contacts that share one law.
 */

#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

#define CLOD_LANES 8

/** History of CLOD_LANES contacts; all zero for pairs that do not touch. */
typedef struct clod_history {
    double plastic[CLOD_LANES];   ///< P = plastic overlap^n [m^n]; luding: d_max [m]
    double tangent[CLOD_LANES];   ///< loading tangent dk of the last step [N/m]
    double spring[3][CLOD_LANES]; ///< tangential spring [m], of i against j
    double roll[3][CLOD_LANES];   ///< rolling spring [rad], of i against j
} clod_history;

/** Grain-grain contacts; i comes before j in the order of the grains. */
typedef struct clod_contact_block {
    int32_t i[CLOD_LANES], j[CLOD_LANES]; ///< rows of the grains
    clod_history history;
} clod_contact_block;

/** Grain-wall contacts; the wall stands for j. */
typedef struct clod_wall_block {
    int32_t i[CLOD_LANES];
    int32_t wall[CLOD_LANES], shape[CLOD_LANES]; ///< first of their rows in clod_wall_rows
    int32_t slot_wall[CLOD_LANES];               ///< where the wall's share of force goes
    clod_history history;
} clod_wall_block;

/** One contact with its history, as it is stored, moved and written. */
typedef struct clod_contact {
    int32_t i, j;      ///< rows; for a wall contact j is the wall
    int32_t shape;     ///< -1 for a grain-grain contact
    double history[8]; ///< plastic, tangent, spring x y z, roll x y z
} clod_contact;
