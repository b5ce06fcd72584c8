#pragma once
/**
 * @file crew_places.h
 * Grains on the way to random places, which ranks keep until all are found: each those of a brick of
 * space, and what reaches into it. Rank 0 draws places and asks which are free; who asks for one grain
 * after the other has no list of all.
 *
 * Threads  clod_crew_places_*: rank 0, the others serve.   Test  tests/step/test_crew_places.c
 */

#include "geometry/sphere_grid.h"
#include "state/state.h"
#include "step/crew_sizes.h"

/** Which grains, and where. */
typedef struct clod_crew_places_what {
    clod_domain domain;  ///< whose periodic images count
    clod_domain_box box; ///< m, where their centres will be
    double largest;      ///< m, radius of the largest, with its clearance
    uint64_t grains;
} clod_crew_places_what;

/** What a rank keeps. All zero: nothing. */
typedef struct clod_crew_places {
    clod_crew_places_what what;
    int32_t bricks[3];     ///< along each axis; as many as ranks
    clod_domain_box reach; ///< own brick, and beyond it as far as a grain in it touches others
    clod_sphere_grid grid;
    clod_crew_sizes sizes;
    clod_sort_item *
        home; ///< [homes] numbers (key) of grains in the brick, and where the grid has them; owned
    size_t homes, home_room;
    bool in_order;              ///< homes are
    clod_placed_sphere *placed; ///< scratch; owned
    size_t placed_room;
} clod_crew_places;

/**
 * Begin: grains that have been dealt already are in the way.
 *
 * @param self   [out] of rank 0; what was kept before is dropped
 * @param state  rows of rank 0; others have theirs
 * Errors  CLOD_FAILED without memory on any rank, as of all below; then clod_crew_places_end.
 */
bool clod_crew_places_begin(clod_crew_places *self, clod_ranks *ranks, const clod_state *state,
                            const clod_crew_places_what *what, clod_status *status);

/** Give the radii of the next grains, in order of their numbers, from 0 on. */
bool clod_crew_places_sizes(clod_crew_places *self, clod_ranks *ranks, const double *radius,
                            size_t count, clod_status *status);

/** Have the next grains, the largest first, in self->sizes.pool[0 to ready) as `index`; none: that was all. */
bool clod_crew_places_next(clod_crew_places *self, clod_ranks *ranks, size_t chunk,
                           clod_status *status);

/**
 * Ask which places are free of grains that are there, and of those that were put.
 *
 * @param place  [count] m, with the radius
 * @param clear  [count] [out]
 */
bool clod_crew_places_ask(clod_crew_places *self, clod_ranks *ranks, const double (*place)[4],
                          size_t count, bool *clear, clod_status *status);

/** Put grains, which are clear of each other. */
bool clod_crew_places_put(clod_crew_places *self, clod_ranks *ranks,
                          const clod_placed_sphere *placed, size_t count, clod_status *status);

/** Where the grains with the numbers [first, first + count) are, [count]: all were put. */
bool clod_crew_places_fetch(clod_crew_places *self, clod_ranks *ranks, size_t first,
                            size_t count, double (*place)[4], clod_status *status);

/** Nothing is kept any more. */
void clod_crew_places_end(clod_crew_places *self, clod_ranks *ranks);

/** What another rank does then, with its rows. */
bool clod_crew_part_places(clod_crew_places *self, clod_ranks *ranks, const clod_state *state,
                           clod_status *status);

void clod_crew_places_fini(clod_crew_places *self);
