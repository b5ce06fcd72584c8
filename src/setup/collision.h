#pragma once
/**
 * @file collision.h
 * A collision cut into steps: how many there are, and what restitution the dash-pot returns.
 */

#include "law/law.h"

/** Restitutions of collisions, by where in a step the first touch falls. */
typedef struct clod_collision_range {
    double least, most;
} clod_collision_range;

/**
 * Duration of a collision that presses a contact to an overlap, without dash-pot and eepa's
 * pull: on k1 there, on k2 back.
 *
 * @param m_star   reduced mass [kg]
 * @param overlap  largest [m]
 * @return         s
 * Errors  none.   Threads  pure.
 * Source  quarter of a swing on k d^n: d/v sqrt(pi) G(1 + 1/(n+1))/G(1/2 + 1/(n+1)); Landau &
 *         Lifshitz, Mechanics, section 12.   Test  tests/setup/test_setup_collision.c
 */
double clod_collision_time(const clod_law *law, double r_star, double m_star, double overlap);

/**
 * What a collision of so many steps returns with the law's dash-pot alone, on k1 there and
 * back, where 10 000 steps return what is asked for (docs/theory/damping.md).
 *
 * @param steps  of a collision without dash-pot, > 0
 * @return       over all places of the first touch between two steps, and half a step less or
 *               more of the collision: where it ends between two steps counts as well
 * Errors  none.   Threads  pure.
 * Source  the scheme of docs/theory/integration.md.   Test  tests/setup/test_setup_collision.c
 */
clod_collision_range clod_collision_restitution(const clod_law *law, double steps);
