#pragma once
/**
 * @file law_cycle.h
 * Closed forms of one cycle of a law, without dash-pot: pressed from the first touch to an
 * overlap, and pulled apart. For estimates and for what is told to the user; kernels step.
 */

#include "law/law.h"

/** Where a contact pulls most, and how much. */
typedef struct clod_law_pull {
    double overlap; ///< m; 0: at the last touch
    double force;   ///< N, >= 0
} clod_law_pull;

/** What a contact gains in a second [N/s]. */
typedef struct clod_law_gain {
    double pressed; ///< of the largest force that it remembers
    double pull;    ///< of its largest pull
} clod_law_gain;

/** k1 [N/m^n] at R* [m]; hertz: times sqrt(R*). */
double clod_law_cycle_virgin(const clod_law *law, double r_star);

/** Force [N] of virgin loading at an overlap [m]; below 0 where eepa's first pull is stronger.
 */
double clod_law_cycle_force(const clod_law *law, double r_star, double overlap);

/** Overlap [m] at which virgin loading carries a force [N]; the inverse of the above. */
double clod_law_cycle_overlap(const clod_law *law, double r_star, double force);

/** Work [J] of virgin loading up to an overlap [m]. */
double clod_law_cycle_energy(const clod_law *law, double r_star, double overlap);

/** Overlap [m] at which virgin loading has taken up an energy [J] >= 0. */
double clod_law_cycle_impact(const clod_law *law, double r_star, double energy);

/**
 * Largest pull of a contact that was pressed to an overlap [m].
 *
 * Errors  none.   Threads  pure.   Source  docs/theory/mepa.md, luding.md, eepa.md.
 * Test    tests/law/test_law_cycle.c
 */
clod_law_pull clod_law_cycle_pull(const clod_law *law, double r_star, double overlap);

/**
 * Overlap [m] to which a contact would have to be pressed for the first time to remember this:
 * with it the functions above tell what the contact has carried, and with what it will pull.
 *
 * @param memory  P = plastic overlap^n [m^n], of luding d_max [m]: clod_history.plastic
 * @return        0 for a law that remembers nothing; of luding at most d*
 * Errors  none.   Threads  pure.   Source  docs/theory/mepa.md, luding.md, eepa.md.
 * Test    tests/law/test_law_pressed.c
 */
double clod_law_cycle_pressed(const clod_law *law, double memory);

/**
 * How fast a contact gains strength: only while it is pressed deeper than ever, of luding up to d*.
 *
 * @param overlap   m, of the moment that the memory is of
 * @param memory    as above
 * @param approach  m/s, by which the overlap grows
 * Errors  none.   Threads  pure.   Test  tests/law/test_law_gain.c
 */
clod_law_gain clod_law_cycle_gain(const clod_law *law, double r_star, double overlap,
                                  double memory, double approach);
