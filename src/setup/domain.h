#pragma once
/**
 * @file domain.h
 * The part of space that a case simulates, and the space that grains and walls take up.
 */

#include "clod/case.h"
#include "state/state.h"

/**
 * Add a wall's bounded shapes to a box, as they are before it has moved.
 * @param low, high  [3] m, of the box so far; +-HUGE_VAL: nothing yet
 * @return           false when a shape of it is endless
 */
bool clod_setup_domain_add_wall(const clod_wall *wall, double low[3], double high[3]);

/** A box around grains, as above, with all bounded shapes; false when there is nothing. */
bool clod_setup_bounds_around(const clod_walls *walls, double low[3], double high[3]);

/**
 * Box around all grains and all bounded shapes; planes do not count.
 * @return  false when there is nothing
 */
bool clod_setup_bounds(const clod_state *state, double low[3], double high[3]);

/**
 * The case's domain, or one around grains and walls with their largest extent added on every
 * side; with its outlets and planes.
 */
void clod_setup_domain(const clod_case *from, clod_state *state);

/** The same with the box [3] around all grains [m]; +-HUGE_VAL: there are none. */
void clod_setup_domain_around(const clod_case *from, const double low[3], const double high[3],
                              clod_state *state);

/** A region of the case as the state has those of outlets. Threads: pure. */
clod_outlet clod_setup_domain_region(const clod_case_region *from);
