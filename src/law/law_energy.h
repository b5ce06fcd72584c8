#pragma once
/**
 * @file law_energy.h
 * What a contact stores and what it loses (docs/theory/energy.md). Nothing here changes a
 * contact: the force comes from law_contact.h, with the ledger or without.
 */

#include "law/law_contact.h"

/** Energy that a contact can give back [J]. */
typedef struct clod_law_stored {
    vreal normal;  ///< of the unloading branch, from the overlap without force
    vreal sliding; ///< of the tangential spring
    vreal rolling; ///< of the rolling spring
} clod_law_stored;

/** Energy that a contact turned into heat in one step [J]. */
typedef struct clod_law_spent {
    vreal plastic;  ///< plasticity and adhesion: what changing the history costs
    vreal dash_pot; ///< normal and tangential dash-pot
    vreal friction; ///< sliding; and what the spring loses when its stiffness changes
    vreal rolling;  ///< rolling resistance, with epsd's dash-pot
} clod_law_spent;

/** Overlap d0 at which the unloading branch has no force: its n-th power is P [m]. */
static inline vreal clod_law_rest_overlap(const clod_law *law, vreal plastic)
{
    if (law->exponent_kind == CLOD_EXPONENT_ONE) {
        return plastic;
    }
    return clod_law_power(plastic, 1.0 / law->exponent);
}

/** Luding: k2 - k1 of a contact whose largest overlap is `most` [N/m]. */
static inline vreal clod_law_luding_rise(const clod_law *law, clod_law_stiffness s, vreal most)
{
    return law->hardening * most / s.r_star;
}

/**
 * Energy of the unloading branch, the integral of its force from where it is zero [J].
 *
 * @param plastic  history of the contact; 0 where it is open
 * Errors  none.   Threads  pure.
 * Source  docs/theory/energy.md, eq. (3), (4).   Test  tests/law/test_law_energy.c
 */
static inline vreal clod_law_normal_energy(const clod_law *law, clod_law_stiffness s,
                                           vreal plastic)
{
    const vreal d = s.overlap;
    if (law->kind == CLOD_LAW_LUDING) {
        const vreal rise = clod_law_luding_rise(law, s, plastic);
        const vreal stiffness = law->k1 + rise;
        const vreal beyond = d - rise * plastic / stiffness;
        return 0.5 * stiffness * beyond * beyond;
    }
    const double n = law->exponent;
    const vreal loaded = d * s.power * (1.0 / (n + 1.0)) - plastic * d;
    const vreal rest = (n / (n + 1.0)) * plastic * clod_law_rest_overlap(law, plastic);
    return law->k2 * (loaded + rest) - law->touch * d;
}

/**
 * What a contact loses per change of its history P: -dE/dP at constant overlap [m]; not luding.
 * It has the sign in which the law changes P, so the loss is never negative.
 *
 * Source  docs/theory/energy.md, eq. (5).   Test  tests/law/test_law_energy.c
 */
static inline vreal clod_law_history_force(const clod_law *law, clod_law_stiffness s,
                                           vreal plastic)
{
    return law->k2 * (s.overlap - clod_law_rest_overlap(law, plastic));
}

/** Stored energy of a contact from its overlap and its history. */
static inline clod_law_stored clod_law_stored_energy(const clod_law *law, vreal overlap,
                                                     vreal r_star,
                                                     const clod_law_memory *memory)
{
    const vreal zero = vreal_set(0.0);
    const vmask closed = vmask_less(zero, overlap);
    const clod_law_stiffness s = clod_law_stiffness_at(law, vreal_max(overlap, zero), r_star);
    const vreal k_t = clod_law_tangential_stiffness(law, memory->tangent);
    const vreal k_r = clod_law_rolling_springs(law)
                          ? clod_law_rolling_stiffness(law, memory->tangent, r_star)
                          : zero;
    const vreal normal = clod_law_normal_energy(law, s, memory->plastic);
    const vreal sliding = 0.5 * k_t * vreal3_dot(memory->spring, memory->spring);
    const vreal rolling = 0.5 * k_r * vreal3_dot(memory->roll, memory->roll);
    return (clod_law_stored){vreal_select(closed, normal, zero),
                             vreal_select(closed, sliding, zero),
                             vreal_select(closed, rolling, zero)};
}

/** One moment of a contact, seen by the ledger. */
typedef struct clod_law_moment {
    clod_law_stiffness s;
    vreal plastic;  ///< history, 0 where open
    vreal force;    ///< normal, without dash-pot [N]
    vreal dash_pot; ///< force of the normal dash-pot along v_n [N]
    vreal3 friction, roll;
    vreal3 viscous; ///< part of friction that is no spring [N]
    clod_law_stored stored;
} clod_law_moment;

static inline clod_law_moment clod_law_moment_of(const clod_law *law,
                                                 const clod_law_motion *motion,
                                                 const clod_law_result *result,
                                                 const clod_law_memory *memory)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 none = {zero, zero, zero};
    const vreal3 n = motion->normal;
    const clod_law_memory kept = {vreal_select(result->closed, memory->plastic, zero),
                                  vreal_select(result->closed, memory->tangent, zero),
                                  vreal3_select(result->closed, memory->spring, none),
                                  vreal3_select(result->closed, memory->roll, none)};
    const vreal inside = vreal_max(motion->overlap, zero);
    clod_law_moment m = {.s = clod_law_stiffness_at(law, inside, motion->r_star),
                         .plastic = kept.plastic,
                         .roll = result->roll};
    const vreal gamma = clod_law_damping(law, m.s, motion->m_star);
    const vreal normal = vreal3_dot(result->force, n);
    m.dash_pot = vreal_select(result->closed, gamma * vreal3_dot(motion->velocity, n), zero);
    m.force = normal + m.dash_pot;
    m.friction = vreal3_axpy(result->force, -normal, n);
    const vreal k_t = clod_law_tangential_stiffness(law, kept.tangent);
    m.viscous = vreal3_axpy(m.friction, k_t, kept.spring);
    m.stored = clod_law_stored_energy(law, motion->overlap, motion->r_star, &kept);
    return m;
}

/**
 * What the change of the histories cost; most steps change none, and the roots are dear.
 *
 * The law of luding moves its history one step after the force (docs/theory/luding.md), so
 * there the loss is what the work of the force has not stored; of first order in the step.
 */
static inline vreal clod_law_history_cost(const clod_law *law, const clod_law_moment *a,
                                          const clod_law_moment *b)
{
    const vreal zero = vreal_set(0.0);
    const vreal change = b->plastic - a->plastic;
    const vmask changed = vmask_less(zero, vreal_abs(change));
    if (!vmask_any(changed)) {
        return zero;
    }
    if (law->kind == CLOD_LAW_LUDING) {
        const vreal work = 0.5 * (a->force + b->force) * (b->s.overlap - a->s.overlap);
        return vreal_select(changed, work - (b->stored.normal - a->stored.normal), zero);
    }
    const vreal force = clod_law_history_force(law, a->s, a->plastic) +
                        clod_law_history_force(law, b->s, b->plastic);
    return 0.5 * force * change;
}

/** Where the contact was closed at one of two moments. */
static inline vmask clod_law_either(vmask a, vmask b)
{
    const vreal zero = vreal_set(0.0);
    const vreal one = vreal_set(1.0);
    return vmask_less(zero, vreal_select(a, one, vreal_select(b, one, zero)));
}

/**
 * A rolling spring that was cut lies on its cap, and whether epsd's dash-pot acts there must
 * not be left to rounding: so much longer it is cut again. One below its cap hardly notices.
 */
#define ON_ITS_CAP (1.0 + 1e-9)

/**
 * Overlap after the step before: the history's tangent remembers it to rounding where it
 * depends on it (n > 1), and whether the contact was closed; else the way back along the normal
 * tells.
 */
static inline vreal clod_law_overlap_before(const clod_law *law, const clod_law_motion *before,
                                            const clod_law_memory *memory)
{
    const vreal open = vreal_set(-1.0);
    const vmask closed = vmask_less(vreal_set(0.0), memory->tangent);
    vreal overlap = before->overlap;
    if (law->exponent_kind == CLOD_EXPONENT_THREE_HALVES) {
        vreal root = memory->tangent / vreal_set(1.5 * law->k1);
        if (law->kind == CLOD_LAW_HERTZ) {
            root = root / vreal_sqrt(before->r_star);
        }
        overlap = root * root;
    } else if (law->exponent_kind == CLOD_EXPONENT_ANY) {
        const vreal power = memory->tangent / vreal_set(law->exponent * law->k1);
        overlap = clod_law_power(power, 1.0 / (law->exponent - 1.0));
    }
    const vmask near = vmask_less(vreal_set(0.0), before->overlap); // no wall was taken away
    return vreal_select(near, vreal_select(closed, overlap, open), open);
}

/** -(a + b)/2 . way: the work that two forces on i, before and after, take from a motion. */
static inline vreal clod_law_work(vreal3 a, vreal3 b, vreal3 way)
{
    return -0.5 * vreal3_dot(vreal3_add(a, b), way);
}

/**
 * What a contact turned into heat during one step.
 *
 * Work is force times way with the mean of the forces at both ends, as velocity Verlet does it
 * on the grains; heat is work that is not stored.
 *
 * @param now     kinematics of this step, with its result and the history after it
 * @param before  the same of the step before: its force is a function of the state, so it is
 *                computed again rather than remembered
 * @param dt      time step [s]
 * @return        J; zero for contacts that were open all along
 * Errors  none.   Threads  pure.
 * Source  docs/theory/energy.md, eq. (7)-(10).   Test  tests/law/test_law_energy.c
 */
static inline clod_law_spent clod_law_spend(const clod_law *law, const clod_law_motion *now,
                                            const clod_law_result *result,
                                            const clod_law_memory *after,
                                            const clod_law_motion *before,
                                            const clod_law_memory *memory, double dt)
{
    const vreal step = vreal_set(dt);
    clod_law_memory copy = *memory;
    copy.roll = vreal3_scale(copy.roll, vreal_set(ON_ITS_CAP));
    clod_law_motion past = *before;
    past.overlap = clod_law_overlap_before(law, before, memory);
    const clod_law_result then = clod_law_contact(law, &past, 0.0, &copy);
    const clod_law_moment a = clod_law_moment_of(law, &past, &then, memory);
    const clod_law_moment b = clod_law_moment_of(law, now, result, after);

    const vreal v_n = vreal3_dot(now->velocity, now->normal);
    const vreal3 slip = vreal3_scale(clod_law_slip_of(now), step);
    const vreal3 turn = vreal3_scale(clod_law_rolling_of(now), step);

    const vreal plastic = clod_law_history_cost(law, &a, &b);
    const vreal viscous = clod_law_work(a.viscous, b.viscous, slip);
    const vreal dash_pot = 0.5 * (a.dash_pot + b.dash_pot) * v_n * step + viscous;
    const vreal friction = clod_law_work(a.friction, b.friction, slip) -
                           (b.stored.sliding - a.stored.sliding) - viscous;
    const vreal rolling =
        clod_law_work(a.roll, b.roll, turn) - (b.stored.rolling - a.stored.rolling);
    const vmask closed = clod_law_either(then.closed, result->closed);
    const vreal zero = vreal_set(0.0);
    return (clod_law_spent){
        vreal_select(closed, plastic, zero), vreal_select(closed, dash_pot, zero),
        vreal_select(closed, friction, zero), vreal_select(closed, rolling, zero)};
}
