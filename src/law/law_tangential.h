#pragma once
/**
 * @file law_tangential.h
 * Tangential spring and rolling resistance (docs/theory/tangential.md, rolling.md). Both are
 * springs in the tangent plane with a cap; their bookkeeping is the same.
 */

#include "law/law.h"
#include "simd/simd.h"

/** What the tangent plane did during the last step. */
typedef struct clod_law_frame {
    vreal3 normal; ///< n_hat, from j to i
    vreal turn;    ///< rad, turn of the pair about n_hat in one step
} clod_law_frame;

/** What the springs of a contact share in this step. */
typedef struct clod_law_tangents {
    vreal inverse; ///< 1/dk [m/N]
    vreal soften;  ///< min(1, dk before / dk now): no energy from a growing stiffness
} clod_law_tangents;

/** Springs shorter than the root of this [m or rad] are nothing: no length to restore. */
#define CLOD_LAW_NOTHING 1e-80

/**
 * Turn a spring with the pair about the normal, and project it on the tangent plane. It is not
 * of its old length then.
 */
static inline vreal3 clod_law_spring_turn(const clod_law_frame *frame, vreal3 spring)
{
    const vreal3 n = frame->normal;
    const vreal3 turned = vreal3_axpy(spring, frame->turn, vreal3_cross(n, spring));
    return vreal3_axpy(turned, -vreal3_dot(turned, n), n);
}

/** Square of a spring's length, at least the least that counts: it can be inverted. */
static inline vreal clod_law_spring_square(vreal3 spring)
{
    return vreal_max(vreal3_dot(spring, spring), vreal_set(CLOD_LAW_NOTHING));
}

/**
 * Restore the length of a turned spring. When the stiffness has grown the spring is shortened
 * so that its force stays; when the stiffness has shrunk the spring stays and its force falls:
 * either way the elastic energy never rises by itself.
 *
 * The root of before/after = 1 + e is its series: exact to rounding while the tangent plane
 * turns by less than 2 degrees in a step (e < 1.3e-3), within 1e-9 up to 10 degrees. A spring
 * that a step tilts by more than 45 degrees (e > 1) stays shortened; one that it turns about
 * the normal by much more than 10 degrees comes out longer (1e-5 at half a radian).
 *
 * @param before     square of its length before it was turned
 * @param per_after  1/clod_law_spring_square of it now
 * Source  docs/theory/tangential.md, docs/adr/0010.   Test  tests/law/test_law_spring.c
 */
static inline vreal3 clod_law_spring_restore(vreal3 turned, vreal before, vreal per_after,
                                             vreal soften)
{
    const vreal e = vreal_min(before * per_after - 1.0, vreal_set(1.0));
    const vreal e2 = e * e;
    const vreal root = (1.0 + 0.5 * e) - e2 * (0.125 - (0.0625 * e - 0.0390625 * e2));
    return vreal3_scale(turned, root * soften);
}

/** A force (or torque) and its limit: where it is beyond, and its length there; elsewhere 1. */
typedef struct clod_law_cut {
    vmask beyond;
    vreal limit, square, length;
} clod_law_cut;

/** @param limit  >= 0 */
static inline clod_law_cut clod_law_cut_of(vreal3 force, vreal limit)
{
    const vreal square = vreal3_dot(force, force);
    const vreal least = vreal_max(limit * limit, vreal_set(CLOD_LAW_NOTHING));
    const vmask beyond = vmask_less(least, square);
    const vreal safe = vreal_select(beyond, square, vreal_set(1.0));
    return (clod_law_cut){beyond, limit, safe, vreal_sqrt(safe)};
}

/**
 * What shortens a force to its limit: limit/length where it is beyond, 1 elsewhere.
 *
 * @param per_square  1/cut.square
 */
static inline vreal clod_law_cut_factor(clod_law_cut cut, vreal per_square)
{
    return vreal_select(cut.beyond, cut.limit * (cut.length * per_square), vreal_set(1.0));
}

/** Tangential stiffness k_t [N/m] (docs/theory/tangential.md). */
static inline vreal clod_law_tangential_stiffness(const clod_law *law, vreal tangent)
{
    if (law->tangential == CLOD_TANGENTIAL_LITERAL) {
        return vreal_set(law->literal_stiffness);
    }
    return law->tangent_ratio * tangent;
}

/** How much springs on k_t shrink in this step; a literal k_t never changes. */
static inline vreal clod_law_tangential_soften(const clod_law *law,
                                               const clod_law_tangents *tangent)
{
    if (law->tangential == CLOD_TANGENTIAL_LITERAL) {
        return vreal_set(1.0);
    }
    return tangent->soften;
}

/** Coefficient of the tangential dash-pot, gamma_t = damping sqrt(m* k_t) [N s/m]. */
static inline vreal clod_law_tangential_damping(const clod_law *law, vreal normal_damping,
                                                vreal m_star)
{
    if (law->tangential == CLOD_TANGENTIAL_LITERAL) {
        return law->damping * vreal_sqrt(m_star * law->literal_stiffness);
    }
    return law->root_ratio * normal_damping;
}

/**
 * Friction force on i before its limit: -k_t spring - gamma_t slip.
 *
 * @param stiffness  k_t [N/m]
 * @param slip       tangential velocity of i against j at the contact [m/s]
 * @param dash_pot   gamma_t [N s/m]
 * @param spring     tangential spring in today's plane, with the slip of the step, within its
 *                   limit [m]
 * Source  docs/theory/tangential.md, eq. (6).   Test  tests/law/test_law_tangential.c
 */
static inline vreal3 clod_law_friction(vreal stiffness, vreal3 slip, vreal dash_pot,
                                       vreal3 spring)
{
    return vreal3_axpy(vreal3_scale(spring, -stiffness), -dash_pot, slip);
}

/** Whether the rolling model has a spring. */
static inline bool clod_law_rolling_springs(const clod_law *law)
{
    return law->rolling == CLOD_ROLLING_EPSD || law->rolling == CLOD_ROLLING_EPSD2;
}

/** Stiffness k_r of the rolling spring [N m/rad]. */
static inline vreal clod_law_rolling_stiffness(const clod_law *law, vreal tangent, vreal r_star)
{
    const vreal area = r_star * r_star;
    if (law->rolling == CLOD_ROLLING_EPSD) {
        return law->epsd_ratio * tangent * area;
    }
    return clod_law_tangential_stiffness(law, tangent) * area;
}

/** How much the rolling spring shrinks in this step. */
static inline vreal clod_law_rolling_soften(const clod_law *law,
                                            const clod_law_tangents *tangent)
{
    if (law->rolling == CLOD_ROLLING_EPSD) {
        return tangent->soften;
    }
    return clod_law_tangential_soften(law, tangent);
}

/**
 * Torque on i before its cap: -k_r roll, with epsd's dash-pot [N m]; cdt: minus the rolling,
 * whose direction alone counts.
 *
 * @param rolling    relative spin of i against j without its part along the normal [rad/s]
 * @param stiffness  k_r [N m/rad]
 * @param inertia    reduced moment of inertia about the contact [kg m2], for epsd
 * @param roll       rolling spring, shortened to its cap [rad]
 * Source  Ai, Chen, Rotter, Ooi 2011; docs/theory/rolling.md.
 * Test    tests/law/test_law_rolling.c
 */
static inline vreal3 clod_law_rolling_torque(const clod_law *law, vreal3 rolling,
                                             vreal stiffness, vreal inertia, vreal3 roll)
{
    if (law->rolling == CLOD_ROLLING_CDT) {
        return vreal3_scale(rolling, vreal_set(-1.0));
    }
    const vreal3 torque = vreal3_scale(roll, -stiffness);
    if (law->rolling != CLOD_ROLLING_EPSD) {
        return torque;
    }
    const vreal dash_pot = 2.0 * law->rolling_damping * vreal_sqrt(inertia * stiffness);
    return vreal3_axpy(torque, -dash_pot, rolling);
}

/** Whether a torque beyond its cap is to be shortened: a spring without dash-pot is there. */
static inline bool clod_law_rolling_capped(const clod_law *law)
{
    return law->rolling == CLOD_ROLLING_EPSD || law->rolling == CLOD_ROLLING_CDT;
}
