#pragma once
/**
 * @file law_normal.h
 * Normal force: MEPA's three branches as one clamp (Del Cid & Mustoe, eq. 1-4; PHYSICS 1).
 * hertz and hooke are the same code with k1 = k2 and k_adh = 0.
 */

#include <math.h>

#include "law/law.h"
#include "simd/simd.h"

/** Overlap raised to the law's exponent, and the loading tangent, of each lane. */
typedef struct clod_law_stiffness {
    vreal scale;   ///< sqrt(R*) for hertz, else 1: multiplies k1, k2, k_adh
    vreal power;   ///< x = d^n [m^n]
    vreal tangent; ///< dk = n k1 d^(n-1) [N/m]
} clod_law_stiffness;

/** d^n lane by lane, for an exponent without a short form. */
static inline vreal clod_law_power(vreal overlap, double exponent)
{
    double lanes[CLOD_WIDTH];
    vreal_store(lanes, overlap);
    for (int l = 0; l < CLOD_WIDTH; l++) {
        lanes[l] = pow(lanes[l], exponent);
    }
    return vreal_load(lanes);
}

/**
 * Powers of the overlap that all parts of the law need.
 *
 * @param law      the pair's law; a uniform branch on its exponent
 * @param overlap  d >= 0 [m]
 * @param r_star   R* [m], for hertz
 * Errors  none.   Threads  pure.
 * Source  PHYSICS 1, 2.   Test  tests/law/test_law_mepa.c
 */
static inline clod_law_stiffness clod_law_stiffness_at(const clod_law *law, vreal overlap,
                                                       vreal r_star)
{
    clod_law_stiffness s;
    s.scale = law->kind == CLOD_LAW_HERTZ ? vreal_sqrt(r_star) : vreal_set(1.0);
    if (law->exponent_kind == CLOD_EXPONENT_ONE) {
        s.power = overlap;
        s.tangent = vreal_set(law->k1);
    } else if (law->exponent_kind == CLOD_EXPONENT_THREE_HALVES) {
        const vreal root = vreal_sqrt(overlap);
        s.power = overlap * root;
        s.tangent = 1.5 * law->k1 * s.scale * root;
    } else {
        s.power = clod_law_power(overlap, law->exponent);
        s.tangent = clod_law_power(overlap, law->exponent - 1.0) * (law->exponent * law->k1);
    }
    return s;
}

/**
 * Normal force of one contact, without damping; repulsion is positive.
 *
 * @param law      stiffnesses of the pair
 * @param s        from clod_law_stiffness_at
 * @param plastic  [in,out] plastic overlap^n of the contact [m^n]; 0 for a new contact
 * @return         f_hys [N]
 * Errors  none.   Threads  pure.
 * Source  Del Cid & Mustoe, eq. (1)-(4), written as a clamp; docs/theory/mepa.md.
 * Test    tests/law/test_law_mepa.c
 */
static inline vreal clod_law_normal_force(const clod_law *law, clod_law_stiffness s,
                                          vreal *plastic)
{
    const vreal loading = law->virgin * s.power;    // on k1: plastic overlap grows with d
    const vreal adhesive = law->pull_off * s.power; // on k_adh: part of the past is forgotten
    *plastic = vreal_min(vreal_max(*plastic, loading), adhesive);
    return law->k2 * s.scale * (s.power - *plastic);
}

/**
 * Coefficient of the normal dash-pot, gamma_n [N s/m]; from the elastic part, never from the
 * total force. Returns the restitution asked for at any speed when k1 = k2 (PHYSICS 2).
 */
static inline vreal clod_law_damping(const clod_law *law, clod_law_stiffness s, vreal m_star)
{
    return law->damping * vreal_sqrt(m_star * s.tangent);
}

/**
 * Normal measure N [N] that the Coulomb limit and rolling resistance multiply (PHYSICS 3):
 * paper max(f, 0), force |f|, adhesive f + k_adh d^n, the distance from the pull-off line.
 */
static inline vreal clod_law_normal_measure(const clod_law *law, clod_law_stiffness s,
                                            vreal force)
{
    switch (law->coulomb) {
    case CLOD_COULOMB_PAPER:
        return vreal_max(force, vreal_set(0.0));
    case CLOD_COULOMB_FORCE:
        return vreal_abs(force);
    default: // adhesive; rounding may leave a hair below zero on the pull-off line
        return vreal_max(force + law->k_adh * s.scale * s.power, vreal_set(0.0));
    }
}
