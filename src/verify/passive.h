#pragma once
/**
 * @file passive.h
 * Oblique impacts of equal grains on a plane and on each other, watched step by step: does a
 * contact ever make energy?
 *
 * Seen of each contact in each step are the four losses of the ledger, and beside it, from
 * forces, springs and velocities of the state alone, what the force at the end of the step
 * does: on a passive contact -F.s - (change of the spring's energy) >= 0, with s the slip of
 * the step, and the same for the rolling torque. Proof for |k xi| <= L and F cut to L: with P
 * the point of the ball |x| <= L/k nearest to xi + s, k P.s >= k (P^2 - xi^2)/2, and cutting to
 * the ball turns -gamma v into a force that works against v.
 */

#include "verify/play.h"

#define CLOD_VERIFY_PASSIVE_ANGLES 12
#define CLOD_VERIFY_PASSIVE_RADIUS 2.5e-3  ///< m
#define CLOD_VERIFY_PASSIVE_DENSITY 4000.0 ///< kg/m3, aluminium oxide (chung_ooi_oblique.c)
#define CLOD_VERIFY_PASSIVE_POISSON 0.23   ///< of aluminium oxide

/** What could be made from nothing in a step. */
typedef enum clod_verify_made {
    CLOD_VERIFY_MADE_PLASTIC, ///< the first four are the losses of the ledger, below zero
    CLOD_VERIFY_MADE_DASH_POT,
    CLOD_VERIFY_MADE_FRICTION,
    CLOD_VERIFY_MADE_ROLLING,
    CLOD_VERIFY_MADE_BY_FORCE,  ///< end force and tangential spring
    CLOD_VERIFY_MADE_BY_TORQUE, ///< end torque and rolling spring
    CLOD_VERIFY_MADE_IN_ALL,    ///< kinetic energy after the impact, beyond that before
    CLOD_VERIFY_MADE_COUNT,
} clod_verify_made;

/** A deck of impacts. */
typedef struct clod_verify_passive {
    const char *name;     ///< folder of its case
    const char *keys;     ///< of the contact, YAML
    double young;         ///< Pa, of the grains; 0: the law needs none
    double plane_young;   ///< Pa, of the plane
    double plane_poisson; ///< of the plane; that of grains is CLOD_VERIFY_PASSIVE_POISSON
    double speed;         ///< m/s, of approach and slip together
    double duration;      ///< s, about that of an impact
    double parts;         ///< parts of the automatic step; 0: `step`
    double step;          ///< s
    const double *angles; ///< [angle_count] from the normal [deg]
    int angle_count;      ///< at most CLOD_VERIFY_PASSIVE_ANGLES
    bool pairs;           ///< pairs of spinning grains beside the plane
} clod_verify_passive;

typedef struct clod_verify_passive_found {
    double step;  ///< s
    int impacts;  ///< of the deck
    int touching; ///< impacts that were seen in contact
    double lag;   ///< largest of an impact on the plane, over its kinetic energy
    /** Largest in any contact and step, over the kinetic energy of its impact; 0: none. */
    double made[CLOD_VERIFY_MADE_COUNT];
    /** Energy along the tangent after the impact on the plane over that before; NAN at 0 deg.
     */
    double rebound[CLOD_VERIFY_PASSIVE_ANGLES];
} clod_verify_passive_found;

/** Errors  as clod_verify_play_run.   Threads  one per folder. */
bool clod_verify_passive_run(const clod_verify_bench *bench, const clod_verify_passive *self,
                             clod_verify_passive_found *found, clod_status *status);
