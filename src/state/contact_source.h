#pragma once
/**
 * @file contact_source.h
 * All contacts of a state, one after the other, wherever they are kept: in the state's list, or
 * in the blocks of a step. Who writes or measures them needs no list of all.
 */

#include "state/state.h"

/** What a contact remembers of its past, as forces. */
typedef struct clod_contact_strength {
    double pull_off; ///< N, largest pull that it can carry from now on; 0: none
    double pressed;  ///< N, largest past force that it remembers; 0: none
} clod_contact_strength;

/** How fast a contact of two grains gains strength. */
typedef struct clod_contact_gain {
    double pull_off; ///< N/s, of its largest pull
    double pressed;  ///< N/s, of the largest past force; 0: it is not pressed harder than ever
} clod_contact_gain;

/** What a contact does now, as its law tells from the state of the moment. */
typedef struct clod_contact_force {
    double force[3]; ///< N, on the grain i
    double from
        [3]; ///< m, beginning of the branch vector, which ends at the centre of i: centre of
             ///< the image of j next to i; of a wall the point of contact
} clod_contact_force;

typedef struct clod_contact_source {
    void *context; ///< of the first two functions, borrowed

    /** Go before the first contact; how many there are of two grains and with walls. */
    void (*begin)(void *context, size_t *pairs, size_t *walls);

    /**
     * Copy the next contacts, ascending: pairs by (i, j), then walls by (i, wall, shape).
     *
     * @param to    [out] [room]
     * @return      how many there were, fewer than `room` only at the end
     */
    size_t (*next)(void *context, clod_contact *to, size_t room);

    const void *laws; ///< of the next functions, borrowed
    /** Strength of a contact; NULL: nobody knows the laws. Threads: pure. */
    clod_contact_strength (*strength)(const void *laws, const clod_contact *contact);
    /** What a contact of two grains gains, likewise. */
    clod_contact_gain (*gain)(const void *laws, const clod_contact *contact);
    /** Force of a contact, likewise; i and j may have been turned (clod_contact_turn). */
    clod_contact_force (*force)(const void *laws, const clod_contact *contact);
    /** Velocity of the wall's material at a contact with it [m/s], likewise. */
    void (*carrier)(const void *laws, const clod_contact *contact, double velocity[3]);
} clod_contact_source;

/** A place in a state's own list of contacts. */
typedef struct clod_contact_list {
    const clod_state *state; ///< borrowed
    size_t at;
} clod_contact_list;

/**
 * The contacts of a state that no step has.
 *
 * @param self  [out] borrowed as long as the source is used
 * Test  tests/step/test_contact_reader.c
 */
clod_contact_source clod_contact_source_of(clod_contact_list *self, const clod_state *state);
