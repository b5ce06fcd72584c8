#pragma once
/**
 * @file contacts.h
 * Contacts and their history, in blocks of CLOD_LANES contacts that share one law.
 *
 * What a contact remembers is one table, CLOD_HISTORY. The step, the lists, sorting,
 * checkpoints and snapshots move histories as CLOD_HISTORY_NUMBERS numbers and ask this table
 * for the rest.
 */

#include <stdbool.h>
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

/** Numbers that one contact remembers. */
#define CLOD_HISTORY_NUMBERS (sizeof(clod_history) / sizeof(double) / CLOD_LANES)

/** One quantity of a history. */
typedef struct clod_history_field {
    const char *name;
    const char *unit;
    int first;      ///< its first number in clod_contact.history
    int components; ///< numbers
    bool turns;     ///< changes its sign when the pair is met in the other order
} clod_history_field;

enum {
    CLOD_HISTORY_PLASTIC,
    CLOD_HISTORY_TANGENT,
    CLOD_HISTORY_SPRING,
    CLOD_HISTORY_ROLL,
    CLOD_HISTORY_FIELDS
};

/** All there is to know of each quantity; the numbers of a history stand in this order. */
extern const clod_history_field CLOD_HISTORY[CLOD_HISTORY_FIELDS];

/** Grain-grain contacts; i comes before j in the order of the grains. */
typedef struct clod_contact_block {
    int32_t i[CLOD_LANES], j[CLOD_LANES]; ///< rows of the grains
    clod_history history;
} clod_contact_block;

/** Grain-wall contacts; the wall stands for j. */
typedef struct clod_wall_block {
    int32_t i[CLOD_LANES];
    int32_t wall[CLOD_LANES];  ///< its number
    int32_t shape[CLOD_LANES]; ///< first of its rows in clod_wall_rows
    int32_t sum[CLOD_LANES];   ///< to which the force on the wall is added (step/near.h)
    int32_t touch[CLOD_LANES]; ///< of a mesh: row of the closest point (step/touch.h); else 0
    clod_history history;
} clod_wall_block;

/** One contact with its history, as it is stored, moved and written. */
typedef struct clod_contact {
    int32_t i, j;                         ///< rows; for a wall contact j is the wall
    int32_t shape;                        ///< -1 for a grain-grain contact
    double history[CLOD_HISTORY_NUMBERS]; ///< in the order of CLOD_HISTORY
} clod_contact;

/** Put a history into a lane. */
static inline void clod_history_put(clod_history *to, int lane,
                                    const double from[CLOD_HISTORY_NUMBERS])
{
    double *row = (double *)to;
    for (size_t k = 0; k < CLOD_HISTORY_NUMBERS; k++) {
        row[k * CLOD_LANES + (size_t)lane] = from[k];
    }
}

/** Get a history from a lane. */
static inline void clod_history_get(const clod_history *from, int lane,
                                    double to[CLOD_HISTORY_NUMBERS])
{
    const double *row = (const double *)from;
    for (size_t k = 0; k < CLOD_HISTORY_NUMBERS; k++) {
        to[k] = row[k * CLOD_LANES + (size_t)lane];
    }
}

/** Whether there is a contact in a lane: one that does not touch remembers nothing. */
static inline bool clod_history_is_there(const clod_history *self, int lane)
{
    return self->tangent[lane] != 0.0;
}

/** The pair is met in the other order: i and j change places, and some numbers their sign. */
void clod_contact_turn(clod_contact *self);

/** Where a contact stands among others, by (i, j, shape); negative: a comes before b. */
static inline int clod_contact_compare(const clod_contact *a, const clod_contact *b)
{
    if (a->i != b->i) {
        return a->i < b->i ? -1 : 1;
    }
    if (a->j != b->j) {
        return a->j < b->j ? -1 : 1;
    }
    return (a->shape > b->shape) - (a->shape < b->shape);
}

/** The first of contacts [low, high), which ascend, whose i is not before a row; or high. */
size_t clod_contacts_first_from(const clod_contact *contacts, size_t low, size_t high,
                                size_t row);

/** Put contacts [begin, end), which nearly ascend, into ascending order, by insertion. */
void clod_contacts_ascend(clod_contact *contacts, size_t begin, size_t end);
