#pragma once
/**
 * @file chung_ooi.h
 * What the impact tests of Chung & Ooi (2011), Granular Matter 13:643-656, share: materials as
 * published, decks with one impact per point of a curve, and what sliding throughout gives.
 *
 * The planes are rigid: 1/E* = (1 - nu^2)/E. clod has no rigid material, but the law sees
 * moduli only in E* and G*, and two materials of modulus 2 E and the same nu have the E* and
 * the G* of a sphere of modulus E on a rigid plane, exactly. So the decks with a plane give 2 E
 * to both.
 */

#include "verify/hertz.h"
#include "verify/impact.h"

#define CLOD_VERIFY_CHUNG "Chung & Ooi 2011"
/** Source of the closed form of clod_verify_chung_levered. */
#define CLOD_VERIFY_CHUNG_LEVER                                                                \
    "rigid body sliding with the lever R - <d> of docs/theory/walls.md, src/verify/hertz.h"

typedef struct clod_verify_chung_material {
    const char *name;
    double density, youngs_modulus, poissons_ratio; ///< kg/m3, Pa, -
} clod_verify_chung_material;

/** The partners of all impacts of a deck. */
typedef struct clod_verify_chung {
    const clod_verify_chung_material *a, *b; ///< b NULL: a rigid plane
    double radius_a, radius_b;               ///< m
    double share;                            ///< of the speed of approach that a has, rest: b
    double restitution, friction;
} clod_verify_chung;

/** Motion before one impact. Velocity along t, spin about b: +spin moves a's contact to -t. */
typedef struct clod_verify_chung_point {
    double normal;         ///< speed of approach [m/s]
    double slip;           ///< velocity of a along t [m/s]
    double spin_a, spin_b; ///< rad/s
} clod_verify_chung_point;

/** Motion of the partners along t and about b, after it. */
typedef struct clod_verify_chung_after {
    double v_a, v_b; ///< m/s
    double w_a, w_b; ///< rad/s
} clod_verify_chung_after;

/** For the closed forms of hertz.h; `speed` is that of approach. */
clod_verify_pair clod_verify_chung_pair(const clod_verify_chung *self, double speed);

/** Slip of a's surface on b's at the contact [m/s]. */
double clod_verify_chung_slip(const clod_verify_chung *self, double v_a, double w_a, double v_b,
                              double w_b);

/** Does rigid-body theory say that the impact slides from beginning to end? */
bool clod_verify_chung_slides(const clod_verify_chung *self,
                              const clod_verify_chung_point *point);

/** What is left of the motion after sliding throughout. Source: hertz.h. */
clod_verify_chung_after clod_verify_chung_sliding(const clod_verify_chung *self,
                                                  const clod_verify_chung_point *point);

/**
 * The same for a on a plane, with the friction at the lever R - <d> instead of R: the contact
 * of clod is on the plane (docs/theory/walls.md), and <d> is the mean overlap of the elastic
 * impact, weighted with the force. Source: hertz.h.
 */
clod_verify_chung_after clod_verify_chung_levered(const clod_verify_chung *self,
                                                  const clod_verify_chung_point *point);

/**
 * Lay out one impact per point in a row along b, all touching at about the same time, with time
 * step and stage to fit: 4 000 steps in the shortest elastic contact.
 *
 * @param deck     name and title given
 * @param impacts  [count, out] to be run
 */
void clod_verify_chung_deck(const clod_verify_chung *self,
                            const clod_verify_chung_point *points, int count,
                            clod_verify_deck *deck, clod_verify_impact *impacts);
