#pragma once
/**
 * @file near_known.h
 * Contacts of the state's list beside a list that ascends as they do: one merge gives each pair
 * its history.
 */

#include "state/contacts.h"

/** History of a pair that does not touch. */
static const double CLOD_NEAR_NO_HISTORY[CLOD_HISTORY_NUMBERS] = {0.0};

/** Contacts of the state's list as a list that ascends as they do goes along beside them. */
typedef struct clod_near_known {
    const clod_contact *item;
    size_t next, end;
} clod_near_known;

/** Those of contacts [begin, end) whose i is from rows[0] on and before rows[1]. */
static inline clod_near_known clod_near_known_of(const clod_contact *contacts, size_t begin,
                                                 size_t end, const size_t rows[2])
{
    return (clod_near_known){contacts, clod_contacts_first_from(contacts, begin, end, rows[0]),
                             clod_contacts_first_from(contacts, begin, end, rows[1])};
}

/** History of the contact (i, j, shape), or none; contacts before it are not asked for again.
 */
static inline const double *clod_near_history(clod_near_known *known, int32_t i, int32_t j,
                                              int32_t shape)
{
    const clod_contact wanted = {.i = i, .j = j, .shape = shape};
    for (; known->next < known->end; known->next++) {
        const int order = clod_contact_compare(&known->item[known->next], &wanted);
        if (order >= 0) {
            return order == 0 ? known->item[known->next].history : CLOD_NEAR_NO_HISTORY;
        }
    }
    return CLOD_NEAR_NO_HISTORY;
}
