#pragma once
/**
 * @file law_normal.h
 * Normal force: MEPA's three branches as one clamp (Del Cid & Mustoe, eq. 1-4;
 * docs/theory/mepa.md). hertz and hooke are the same code with k1 = k2 and k_adh = 0, eepa the
 * same with its pulls; luding, whose k2 changes, has the same three branches with another
 * history.
 */

#include <math.h>

#include "law/law_forms.h"
#include "simd/simd.h"

/** Overlap raised to the law's exponent, and the loading tangent, of each lane. */
typedef struct clod_law_stiffness {
    vreal power;   ///< x = d^n [m^n]; hertz: sqrt(R*) d^n [m^2]
    vreal tangent; ///< dk = n k1 d^(n-1) [N/m]
    vreal overlap; ///< d [m]
    vreal r_star;  ///< R* [m]
} clod_law_stiffness;

/** Normal force of a contact, without dash-pot; repulsion is positive. */
typedef struct clod_law_normal {
    vreal force; ///< f_hys [N]
    vreal pull;  ///< the largest pull at this overlap, >= 0 [N]: the pull-off line
} clod_law_normal;

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
 * @param r_star   R* [m], for hertz, eepa and luding
 * Errors  none.   Threads  pure.
 * Source  docs/theory/mepa.md, damping.md.   Test  tests/law/test_law_mepa.c
 */
static inline clod_law_stiffness clod_law_stiffness_at(const clod_law *law, vreal overlap,
                                                       vreal r_star)
{
    clod_law_stiffness s = {.overlap = overlap, .r_star = r_star};
    if (law->exponent_kind == CLOD_EXPONENT_ONE) {
        s.power = overlap;
        s.tangent = vreal_set(law->k1);
    } else if (law->exponent_kind == CLOD_EXPONENT_THREE_HALVES) {
        vreal square = overlap;
        if (clod_law_root_radius(law)) {
            square = overlap * r_star;
        }
        const vreal root = vreal_sqrt(square);
        s.power = overlap * root;
        s.tangent = 1.5 * law->k1 * root;
    } else {
        s.power = clod_law_power(overlap, law->exponent);
        s.tangent = clod_law_power(overlap, law->exponent - 1.0) * (law->exponent * law->k1);
    }
    return s;
}

/** w^(2 n): the power of an overlap from its root. */
static inline vreal clod_law_root_power(const clod_law *law, vreal root)
{
    if (law->exponent_kind == CLOD_EXPONENT_ONE) {
        return root * root;
    }
    if (law->exponent_kind == CLOD_EXPONENT_THREE_HALVES) {
        return root * root * root;
    }
    return clod_law_power(root, 2.0 * law->exponent);
}

/**
 * Plastic overlap^n on the pull-off line of eepa with surface energy: the P whose own largest
 * pull F lies at this overlap, P = x + F(P)/k2.
 *
 * F = patch sqrt(R* dp), at most k2 P/2. With w = sqrt(dp) that is w^(2 n) = x + b w; Newton
 * from the end of the interval, where the limit begins (w^(2 n) = 2 x), comes down to the root
 * and doubles its digits each time: six times are enough for every n >= 1.
 *
 * @param law  patch > 0
 * @param s    from clod_law_stiffness_at
 * @return     upper bound of P [m^n]
 * Errors  none.   Threads  pure.
 * Source  docs/theory/eepa.md.   Test  tests/law/test_law_eepa.c
 */
static inline vreal clod_law_patch_bound(const clod_law *law, clod_law_stiffness s)
{
    const double twice = 2.0 * law->exponent;
    const vreal b = law->patch / law->k2 * vreal_sqrt(s.r_star);
    vreal w = law->patch_start * vreal_sqrt(s.overlap);
    const vmask free = vmask_less(b * w, s.power); // the limit of F is not reached
    for (int k = 0; k < 6; k++) {
        const vreal power = clod_law_root_power(law, w);
        w = ((twice - 1.0) * power + s.power) / (twice * power / w - b);
    }
    return s.power + vreal_select(free, b * w, s.power);
}

/**
 * Luding's law: k1, a k2 that rises with the largest overlap up to d*, and the adhesive branch.
 *
 * @param most  [in,out] largest overlap d_max <= d* of the contact [m]; 0 for a new contact.
 *              On the adhesive branch it falls to what leads there with the k2 it had before.
 * Errors  none.   Threads  pure.
 * Source  Luding 2008; docs/theory/luding.md.   Test  tests/law/test_law_luding.c
 */
static inline clod_law_normal clod_law_luding(const clod_law *law, clod_law_stiffness s,
                                              vreal *most)
{
    const vreal d = s.overlap;
    *most = vreal_max(*most, vreal_min(d, law->flow * s.r_star));
    const vreal rise = law->hardening * *most / s.r_star;   // k2 - k1 of this contact
    const vreal elastic = law->k1 * d - rise * (*most - d); // k2 (d - d0)
    const vreal pull = law->k_adh * d;
    const vreal fallen = (law->k1 + rise + law->k_adh) / rise * d;
    *most = vreal_select(vmask_less(elastic, -pull), fallen, *most);
    return (clod_law_normal){vreal_max(elastic, -pull), pull};
}

/**
 * The three branches k1, k2 and pull-off line as one clamp.
 *
 * @param plastic  [in,out] plastic overlap^n of the contact, P [m^n]; 0 for a new contact
 * @param bound    P on the pull-off line [m^n]
 * @return         k2 (x - P) [N]
 * Source  Del Cid & Mustoe, eq. (1)-(4); docs/theory/mepa.md.  Test  tests/law/test_law_mepa.c
 */
static inline vreal clod_law_clamp(const clod_law *law, clod_law_stiffness s, vreal bound,
                                   vreal *plastic)
{
    const vreal loading = law->virgin * s.power; // on k1: plastic overlap grows with d
    *plastic = vreal_min(vreal_max(*plastic, loading), bound);
    return law->k2 * (s.power - *plastic);
}

/**
 * EEPA: the clamp with a constant pull, and a pull-off line from k_adh or from surface energy.
 *
 * Errors  none.   Threads  pure.
 * Source  Thakur et al. 2014, eq. (5); Morrissey 2013; docs/theory/eepa.md.
 * Test    tests/law/test_law_eepa.c
 */
static inline clod_law_normal clod_law_eepa(const clod_law *law, clod_law_stiffness s,
                                            vreal *plastic)
{
    vreal bound = law->pull_off * s.power;
    vreal pull = law->k_adh * s.power;
    if (law->patch > 0.0) {
        bound = clod_law_patch_bound(law, s);
        pull = law->k2 * (bound - s.power);
    }
    const vreal force = clod_law_clamp(law, s, bound, plastic);
    return (clod_law_normal){force - law->touch, pull + law->touch};
}

/**
 * Normal force of one contact, without damping.
 *
 * @param law      stiffnesses of the pair; uniform branches on what law_forms.h says of it
 * @param s        from clod_law_stiffness_at
 * @param plastic  [in,out] plastic overlap^n of the contact [m^n], luding: d_max [m]; 0 for a
 *                 new contact
 * Errors  none.   Threads  pure.   Source  docs/theory/mepa.md.   Test  tests/law/
 */
static inline clod_law_normal clod_law_normal_force(const clod_law *law, clod_law_stiffness s,
                                                    vreal *plastic)
{
    if (clod_law_rises(law)) {
        return clod_law_luding(law, s, plastic);
    }
    if (clod_law_pulls(law)) {
        return clod_law_eepa(law, s, plastic);
    }
    const vreal bound = law->pull_off * s.power; // on k_adh: part of the past is forgotten
    const vreal force = clod_law_clamp(law, s, bound, plastic);
    return (clod_law_normal){force, law->k_adh * s.power};
}

/**
 * Coefficient of the normal dash-pot, gamma_n [N s/m]; from the elastic part, never from the
 * total force. Returns the restitution asked for at any speed when k1 = k2
 * (docs/theory/damping.md).
 */
static inline vreal clod_law_damping(const clod_law *law, clod_law_stiffness s, vreal m_star)
{
    return law->damping * vreal_sqrt(m_star * s.tangent);
}

/**
 * Normal measure N [N] that the Coulomb limit and rolling resistance multiply
 * (docs/theory/tangential.md): paper max(f, 0), force |f|, adhesive f + k_adh d^n, the distance
 * from the pull-off line.
 */
static inline vreal clod_law_normal_measure(const clod_law *law, clod_law_normal normal)
{
    switch (law->coulomb) {
    case CLOD_COULOMB_PAPER:
        return vreal_max(normal.force, vreal_set(0.0));
    case CLOD_COULOMB_FORCE:
        return vreal_abs(normal.force);
    default: // adhesive; rounding may leave a hair below zero on the pull-off line
        return vreal_max(normal.force + normal.pull, vreal_set(0.0));
    }
}
