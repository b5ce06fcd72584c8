#pragma once
/**
 * @file migrate.h
 * Grains and contacts on their way between ranks: rows with everything that belongs to them, and
 * contacts by the ids of their grains. The same records deal a bed to the ranks, move what has
 * crossed a cut at a rebuild, and gather the bed.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/step/test_ranks.c
 */

#include "step/spread.h"

/**
 * Cut the bed anew by from->build_position and move every grain to its owner, with its contacts;
 * then ghosts go to whom they matter. Rows and contacts are in any order then: the next is
 * clod_neighbour_sort_as_built, with self->layers, and clod_spread_list.
 *
 * @param from  own rows by self->owner (NULL: all), ghosts, and contacts; those of a ghost with
 *              an own grain too, which come from the other's owner
 * @param to    [out] rows and contacts of this rank, in place of those it has; may be `from`, and has
 *              the same columns
 * @param skin  wide skin of the rebuild, a function of radius and speed [m]
 * @return      false without memory, on all ranks alike
 */
bool clod_migrate(clod_spread *self, const clod_state *from, clod_state *to,
                  double (*skin)(const void *context, const clod_layers_extent *bed),
                  const void *context, clod_status *status);

/** Whether a grain reaches into one of some boxes; periodic images count. Threads: any. */
bool clod_migrate_reaches(const clod_domain *domain, const double place[4],
                          const clod_domain_box *box, int count);

/**
 * Own grains of all ranks that reach into some boxes into a state of rank 0: in any order, without
 * contacts.
 *
 * @param box    [count] m; periodic images count
 * @param whole  its rows and contacts are replaced; NULL on other ranks
 * @return       false without memory, on all ranks alike
 */
bool clod_migrate_near(clod_spread *self, const clod_state *state, const clod_domain_box *box,
                       int count, clod_state *whole, clod_status *status);

/** Grains that left this rank, one by one, into the list of a state of rank 0 (NULL on others).
 *  @return  false without memory, on all ranks alike */
bool clod_migrate_gone(clod_spread *self, clod_state *state, clod_state *whole,
                       clod_status *status);

/**
 * Own grains of all ranks, with their contacts and places at the last rebuild, and those that left,
 * into a state of rank 0: in any order, next is clod_neighbour_sort_as_built.
 *
 * @param whole  its rows and contacts are replaced; NULL on other ranks
 * @return       false without memory, on all ranks alike
 */
bool clod_migrate_gather(clod_spread *self, clod_state *state, clod_state *whole,
                         clod_status *status);
