#pragma once
/**
 * @file law_tangential.h
 * Tangential spring and rolling resistance (PHYSICS 3 and 4). Both are springs in the tangent
 * plane with a cap; their bookkeeping is the same.
 */

#include "law/law.h"
#include "simd/simd.h"

/** What the tangent plane did during the last step. */
typedef struct clod_law_frame {
    vreal3 normal; ///< n_hat, from j to i
    vreal turn;    ///< rad, turn of the pair about n_hat in one step
    vreal soften;  ///< min(1, dk before / dk now): no energy from a growing stiffness
    double dt;     ///< s
} clod_law_frame;

/**
 * Carry a spring into today's tangent plane: turn it with the pair about the normal, project
 * it, restore its length. When the stiffness has grown the spring is shortened so that its
 * force stays; when the stiffness has shrunk the spring stays and its force falls: either way
 * the elastic energy never rises by itself.
 */
static inline vreal3 clod_law_spring_carry(const clod_law_frame *frame, vreal3 spring,
                                           vreal soften)
{
    const vreal3 n = frame->normal;
    vreal3 turned = vreal3_axpy(spring, frame->turn, vreal3_cross(n, spring));
    turned = vreal3_axpy(turned, -vreal3_dot(turned, n), n);
    const vreal before = vreal3_dot(spring, spring);
    const vreal after = vreal3_dot(turned, turned);
    const vmask some = vmask_less(vreal_set(0.0), after);
    const vreal ratio = before / vreal_select(some, after, vreal_set(1.0));
    return vreal3_scale(turned, vreal_sqrt(ratio) * soften);
}

/**
 * Cut a force (or torque) to its limit; the spring is reset to what carries the cut force.
 *
 * @param trial      -stiffness spring - dash-pot
 * @param limit      >= 0
 * @param stiffness  > 0
 * @param spring     [in,out]
 * @return           the force
 * Source  PHYSICS 3, eq. (6).   Test  tests/law/test_law_tangential.c
 */
static inline vreal3 clod_law_spring_cut(vreal3 trial, vreal limit, vreal stiffness,
                                         vreal3 *spring)
{
    const vreal length = vreal3_dot(trial, trial);
    const vmask slides = vmask_less(limit * limit, length);
    const vreal safe = vreal_select(slides, length, vreal_set(1.0));
    const vreal3 cut = vreal3_scale(trial, limit / vreal_sqrt(safe));
    const vreal3 reset = vreal3_scale(cut, -1.0 / stiffness);
    *spring = vreal3_select(slides, reset, *spring);
    return vreal3_select(slides, cut, trial);
}

/** Tangential stiffness k_t [N/m] (PHYSICS 3). */
static inline vreal clod_law_tangential_stiffness(const clod_law *law, vreal tangent)
{
    if (law->tangential == CLOD_TANGENTIAL_LITERAL) {
        return vreal_set(law->literal_stiffness);
    }
    return law->tangent_ratio * tangent;
}

/** How much springs on k_t shrink in this step; a literal k_t never changes. */
static inline vreal clod_law_tangential_soften(const clod_law *law, const clod_law_frame *frame)
{
    if (law->tangential == CLOD_TANGENTIAL_LITERAL) {
        return vreal_set(1.0);
    }
    return frame->soften;
}

/**
 * Friction force on i.
 *
 * @param slip     tangential velocity of i against j at the contact [m/s]
 * @param limit    mu N [N]
 * @param tangent  dk [N/m]
 * @param m_star   reduced mass [kg], for the dash-pot
 * @param spring   [in,out] tangential spring [m]
 * @return         F_t [N]
 * Source  PHYSICS 3, eq. (6); gamma_t = damping sqrt(m* k_t).
 * Test    tests/law/test_law_tangential.c
 */
static inline vreal3 clod_law_friction(const clod_law *law, const clod_law_frame *frame,
                                       vreal3 slip, vreal limit, vreal tangent, vreal m_star,
                                       vreal3 *spring)
{
    const vreal stiffness = clod_law_tangential_stiffness(law, tangent);
    const vreal dash_pot = law->damping * vreal_sqrt(m_star * stiffness);
    *spring = clod_law_spring_carry(frame, *spring, clod_law_tangential_soften(law, frame));
    *spring = vreal3_axpy(*spring, vreal_set(frame->dt), slip);
    const vreal3 elastic = vreal3_scale(*spring, -stiffness);
    const vreal3 trial = vreal3_axpy(elastic, -dash_pot, slip);
    return clod_law_spring_cut(trial, limit, stiffness, spring);
}

/** Constant directional torque: -mu_r N R* along the rolling velocity. */
static inline vreal3 clod_law_rolling_cdt(vreal3 rolling, vreal cap)
{
    const vreal speed2 = vreal3_dot(rolling, rolling);
    const vmask rolls = vmask_less(vreal_set(0.0), speed2);
    const vreal speed = vreal_sqrt(vreal_select(rolls, speed2, vreal_set(1.0)));
    return vreal3_scale(rolling, -cap / speed);
}

/**
 * Rolling resistance: the torque on i; j takes the opposite.
 *
 * @param rolling  relative spin of i against j without its part along the normal [rad/s]
 * @param normal_measure  N [N]
 * @param tangent  dk [N/m]
 * @param r_star   R* [m]
 * @param inertia  reduced moment of inertia about the contact [kg m2], for epsd's dash-pot
 * @param roll     [in,out] rolling spring [rad]
 * @return         M [N m]
 * Source  Ai, Chen, Rotter, Ooi 2011; PHYSICS 4.   Test  tests/law/test_law_rolling.c
 */
static inline vreal3 clod_law_rolling(const clod_law *law, const clod_law_frame *frame,
                                      vreal3 rolling, vreal normal_measure, vreal tangent,
                                      vreal r_star, vreal inertia, vreal3 *roll)
{
    const vreal cap = law->rolling_friction * normal_measure * r_star;
    if (law->rolling == CLOD_ROLLING_CDT) {
        return clod_law_rolling_cdt(rolling, cap);
    }
    const vreal area = r_star * r_star;
    vreal stiffness = clod_law_tangential_stiffness(law, tangent) * area;
    vreal soften = clod_law_tangential_soften(law, frame);
    if (law->rolling == CLOD_ROLLING_EPSD) {
        stiffness = law->epsd_ratio * tangent * area;
        soften = frame->soften;
    }
    *roll = clod_law_spring_carry(frame, *roll, soften);
    *roll = vreal3_axpy(*roll, vreal_set(frame->dt), rolling);
    const vreal3 elastic = vreal3_scale(*roll, -stiffness);
    const vreal length = vreal3_dot(elastic, elastic);
    vreal3 torque = clod_law_spring_cut(elastic, cap, stiffness, roll);
    if (law->rolling == CLOD_ROLLING_EPSD) { // the dash-pot acts below the cap only
        const vreal dash_pot = 2.0 * law->rolling_damping * vreal_sqrt(inertia * stiffness);
        const vmask below = vmask_less(length, cap * cap);
        const vreal acting = vreal_select(below, dash_pot, vreal_set(0.0));
        torque = vreal3_axpy(torque, -acting, rolling);
    }
    return torque;
}
