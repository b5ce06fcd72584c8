#pragma once
/**
 * @file pieces.h
 * Grains that are made piece by piece, and given away before the next piece is made: then nobody
 * ever has a list of all. What setup asks of all of them is added up on the way (tally.h), in the
 * order of ids.
 *
 * Test  tests/sim/test_deal.c
 */

#include "base/sort.h"
#include "geometry/sphere_grid.h"
#include "setup/tally.h"

/** Places of some grains: x, y, z, radius [m]. */
typedef struct clod_setup_places {
    const double (*place)[4]; ///< [count] borrowed
    size_t count;
} clod_setup_places;

/** Who keeps the places of a group's grains while they are looked for at random, the largest first. */
typedef struct clod_setup_keeper {
    void *context; ///< of the functions; borrowed

    /** Begin: grains that were taken, and those in the state, are in the way; the box has the centres.
     *  Then `end`, in any case. Errors: CLOD_FAILED, as of all below. */
    bool (*begin)(void *context, const clod_state *state, const clod_domain_box *box,
                  double largest, size_t grains, clod_status *status);

    /** The radii of the next grains [m], until it has all. */
    bool (*sizes)(void *context, const double *radius, size_t count, clod_status *status);

    /** The numbers of the next grains, as `index`, the largest first and equal ones by number; valid until the
     *  next call. None: that was all. */
    bool (*next)(void *context, const clod_sort_item **grain, size_t *count,
                 clod_status *status);

    /** Which places, [count], are free of grains. */
    bool (*ask)(void *context, const double (*place)[4], size_t count, bool *clear,
                clod_status *status);

    /** Put grains, which are clear of each other. */
    bool (*put)(void *context, const clod_placed_sphere *grain, size_t count,
                clod_status *status);

    /** Places of the grains with the numbers [first, first + count), which were put. */
    bool (*fetch)(void *context, size_t first, size_t count, double (*place)[4],
                  clod_status *status);

    void (*end)(void *context);
} clod_setup_keeper;

/** Who takes grains. */
typedef struct clod_setup_taker {
    void *context;                   ///< of the functions; borrowed
    size_t piece;                    ///< grains at a time
    double share;                    ///< of all grains, that this machine has to hold
    const clod_setup_keeper *keeper; ///< borrowed

    /** So many will come in all. Errors: CLOD_FAILED, as of the next two. */
    bool (*begin)(void *context, clod_state *state, size_t grains, clod_status *status);

    /** Take the rows of a state from `kept` on; some of them may stay, behind the ones before. */
    bool (*take)(void *context, clod_state *state, size_t kept, clod_status *status);

    /** Those taken that reach into a box, but for the ones in the state; valid until the next
     *  call. */
    bool (*near)(void *context, const clod_domain *domain, const clod_domain_box *box,
                 clod_setup_places *found, clod_status *status);
} clod_setup_taker;

/** Grains of a case on their way to a taker. */
typedef struct clod_setup_pieces {
    const clod_setup_taker *taker; ///< borrowed, as the next three
    const clod_case *from;
    clod_state *state;
    clod_setup_tally *tally;
    bool some;           ///< others were given away before the group that is being made
    size_t kept;         ///< rows of the state that have been counted and taken
    double diameter;     ///< m, of the largest of all
    clod_status outside; ///< of the first grain outside of the domain; CLOD_OK: none is
} clod_setup_pieces;

/** Give away what the state has of a piece, if that is whole, or `all` of it. */
bool clod_setup_pieces_give(clod_setup_pieces *self, bool all, clod_status *status);

/** Grains given away that reach into a box; none when there is only what is being made. */
bool clod_setup_pieces_near(clod_setup_pieces *self, const clod_domain_box *box,
                            clod_setup_places *found, clod_status *status);

/**
 * Whether the grains of a state from `first` on lie in the domain. In a periodic direction one may be
 * beyond it by a diameter of the largest, as in the files of a code that wraps grains only now and
 * then.
 *
 * Errors  CLOD_USAGE with the first that does not.   Threads  pure.
 */
bool clod_setup_pieces_inside(const clod_case *from, const clod_state *state, size_t first,
                              double diameter, clod_status *status);
