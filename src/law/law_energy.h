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

/** What a contact lost in one step [J]: each loss >= 0 where the law makes no energy. */
typedef struct clod_law_dissipation {
    vreal plastic;  ///< plasticity and adhesion: what changing the history costs
    vreal dash_pot; ///< normal and tangential dash-pot
    vreal friction; ///< sliding; and what the spring loses when its stiffness changes
    vreal rolling;  ///< rolling resistance, with epsd's dash-pot
    vreal lag;      ///< work beyond that, of forces with an earlier velocity; either sign
} clod_law_dissipation;

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
    if (clod_law_rises(law)) {
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
 * What a contact loses per change of its history: -dE/dP at constant overlap [m], luding:
 * -dE/dd_max [N]. It has the sign in which the law changes the history, so the loss is never
 * negative.
 *
 * Source  docs/theory/energy.md, eq. (5), (6).   Test  tests/law/test_law_energy.c
 */
static inline vreal clod_law_history_force(const clod_law *law, clod_law_stiffness s,
                                           vreal plastic)
{
    if (clod_law_rises(law)) {
        const vreal rise = clod_law_luding_rise(law, s, plastic);
        const vreal stiffness = law->k1 + rise;
        const vreal beyond = s.overlap - rise * plastic / stiffness;
        const vreal slope = law->hardening / s.r_star; // of the stiffness by d_max
        const vreal shift = plastic * (stiffness + law->k1) / (stiffness * stiffness);
        return slope * beyond * (stiffness * shift - 0.5 * beyond);
    }
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

/** What resists slip, or rolling, at one moment: a spring, with a dash-pot and a limit. */
typedef struct clod_law_hold {
    vreal stiffness; ///< k_t [N/m], or k_r [N m/rad]; 0 without a spring
    vreal3 spring;   ///< m, or rad
    vreal3 force;    ///< on i: friction [N], or rolling torque [N m]
} clod_law_hold;

/** One moment of a contact, seen by the ledger; all zero where it is open. */
typedef struct clod_law_moment {
    clod_law_stiffness s;
    vreal plastic;  ///< history
    vreal dash_pot; ///< gamma_n [N s/m]
    clod_law_hold sliding, rolling;
} clod_law_moment;

/** @param memory  history that goes with the forces */
static inline clod_law_moment clod_law_moment_of(const clod_law *law,
                                                 const clod_law_motion *motion,
                                                 const clod_law_result *result,
                                                 const clod_law_memory *memory)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 none = {zero, zero, zero};
    const vreal3 n = motion->normal;
    const vreal inside = vreal_max(motion->overlap, zero);
    const vreal tangent = vreal_select(result->closed, memory->tangent, zero);
    clod_law_moment m = {.s = clod_law_stiffness_at(law, inside, motion->r_star),
                         .plastic = vreal_select(result->closed, memory->plastic, zero)};
    const vreal gamma = clod_law_damping(law, m.s, motion->m_star);
    m.dash_pot = vreal_select(result->closed, gamma, zero);
    m.sliding.stiffness = clod_law_tangential_stiffness(law, tangent);
    m.sliding.spring = vreal3_select(result->closed, memory->spring, none);
    m.sliding.force = vreal3_axpy(result->force, -vreal3_dot(result->force, n), n);
    if (clod_law_rolling_springs(law)) {
        m.rolling.stiffness = clod_law_rolling_stiffness(law, tangent, motion->r_star);
    }
    m.rolling.spring = vreal3_select(result->closed, memory->roll, none);
    m.rolling.force = result->roll;
    return m;
}

/** Luding's loss: on the branch k1 d = d_max; on the adhesive one the history is lowered at
 * the overlap of now. */
static inline vreal clod_law_luding_loss(const clod_law *law, const clod_law_moment *a,
                                         const clod_law_moment *b)
{
    clod_law_stiffness from = b->s;
    clod_law_stiffness to = b->s;
    from.overlap = a->plastic;
    to.overlap = b->plastic;
    const vreal change = b->plastic - a->plastic;
    const vreal up = 0.5 * change *
                     (clod_law_history_force(law, from, a->plastic) +
                      clod_law_history_force(law, to, b->plastic));
    const vreal down = clod_law_normal_energy(law, b->s, a->plastic) -
                       clod_law_normal_energy(law, b->s, b->plastic);
    return vreal_select(vmask_less(vreal_set(0.0), change), up, down);
}

/**
 * Overlap d* at which the branch that moves the history meets what it was before [m]: P lies on
 * k1 when it rises, on the pull-off line when it falls.
 */
static inline vreal clod_law_branch_overlap(const clod_law *law, const clod_law_moment *a,
                                            vreal r_star, vmask rises)
{
    const double root = 1.0 / law->exponent;
    const vreal rest = clod_law_rest_overlap(law, a->plastic);
    vreal pulled = rest * pow(law->pull_off, -root);
    if (law->patch > 0.0) {
        const vreal pull = law->patch * vreal_sqrt(r_star * rest);
        const vreal most = 0.5 * law->k2 * a->plastic;
        const vreal power = a->plastic - vreal_min(pull, most) / vreal_set(law->k2);
        pulled = clod_law_power(power, root);
    }
    return vreal_select(rises, rest * pow(law->virgin, -root), pulled);
}

/**
 * What the change of the history cost, along the branch that moved it: the mean of -dE/dP where
 * it began to move and where it is now. Most steps change none, and the roots are dear.
 */
static inline vreal clod_law_history_loss(const clod_law *law, const clod_law_moment *a,
                                          const clod_law_moment *b)
{
    const vreal zero = vreal_set(0.0);
    const vreal change = b->plastic - a->plastic;
    const vmask changed = vmask_less(zero, vreal_abs(change));
    if (!vmask_any(changed)) {
        return zero;
    }
    if (clod_law_rises(law)) {
        return vreal_select(changed, clod_law_luding_loss(law, a, b), zero);
    }
    clod_law_stiffness start = b->s;
    start.overlap = clod_law_branch_overlap(law, a, b->s.r_star, vmask_less(zero, change));
    const vreal force = clod_law_history_force(law, start, a->plastic) +
                        clod_law_history_force(law, b->s, b->plastic);
    return vreal_select(changed, 0.5 * force * change, zero);
}

/** Energy of the spring of a hold [J]. */
static inline vreal clod_law_hold_energy(const clod_law_hold *hold)
{
    return 0.5 * hold->stiffness * vreal3_dot(hold->spring, hold->spring);
}

/** What the dash-pot of a hold takes on a way [J]: work of all that is no spring. */
static inline vreal clod_law_hold_viscous(const clod_law_hold *hold, vreal3 way)
{
    return -vreal3_dot(vreal3_axpy(hold->force, hold->stiffness, hold->spring), way);
}

/**
 * What a spring loses in a step: by its changed stiffness, and by the way by which it slides,
 * what it was shortened. A law that lengthens a spring makes energy: the loss is below zero.
 *
 * @param a, b     before and after
 * @param carried  the spring in today's plane with the way of the step, before it is cut
 * @param way      slip or turn of the step [m or rad]
 * @param closed   where the contact is not open after it; an opened one loses all
 * Source  docs/theory/energy.md, eq. (9), (10).   Test  tests/law/test_law_energy.c
 */
static inline vreal clod_law_spring_loss(const clod_law_hold *a, const clod_law_hold *b,
                                         vreal3 carried, vreal3 way, vmask closed)
{
    const vreal3 kept = vreal3_sub(carried, way);
    const vreal before = vreal3_dot(a->spring, a->spring);
    const vreal turned = vreal3_dot(kept, kept);
    const vreal after = vreal3_dot(b->spring, b->spring);
    const vreal stored = 0.5 * a->stiffness * before;
    const vreal stiffer = stored - 0.5 * b->stiffness * turned;
    const vreal softer = 0.25 * (a->stiffness - b->stiffness) * (turned + after);
    const vmask grows = vmask_less(a->stiffness, b->stiffness);

    // what a limit takes is taken along the spring
    const vreal length = vreal_sqrt(clod_law_spring_square(carried));
    const vreal slid = vreal3_dot(vreal3_sub(carried, b->spring), carried) / length;
    const vreal pull =
        0.5 * (a->stiffness * vreal_sqrt(before) + b->stiffness * vreal_sqrt(after));
    return vreal_select(closed, vreal_select(grows, stiffer, softer) + pull * slid, stored);
}

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
        if (clod_law_root_radius(law)) {
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

/** Where the contact was closed at one of two moments. */
static inline vmask clod_law_either(vmask a, vmask b)
{
    const vreal zero = vreal_set(0.0);
    const vreal one = vreal_set(1.0);
    return vmask_less(zero, vreal_select(a, one, vreal_select(b, one, zero)));
}

/** The springs with the way of this step, before they are cut to their limits. */
static inline clod_law_memory clod_law_carried(const clod_law *law, const clod_law_motion *now,
                                               const clod_law_memory *memory, double dt)
{
    clod_law_touch touch = {.rolling = now->spin_i}; // zeros: no field is without a value
    clod_law_trial trial = {.push = now->overlap};
    clod_law_memory carried = *memory;
    clod_law_touch_of(law, now, &touch);
    clod_law_press(law, &touch, dt, &carried, &trial);
    const clod_law_inverses inverses = clod_law_carry_begin(law, &trial, &carried);
    clod_law_carry_springs(law, &touch, dt, &inverses, &trial, &carried);
    return carried;
}

/** The two ways to look at the moment before a step, and what came of it. */
typedef struct clod_law_step {
    clod_law_moment before; ///< forces as they acted, with the velocity of then
    clod_law_moment began;  ///< forces of the same state with the velocity of the step
    clod_law_moment after;
    clod_law_memory carried; ///< springs before they are cut
    vmask closed, met;       ///< closed after it; closed at one end at least
} clod_law_step;

/** The moments of a step: forces are functions of the state, so those before it are computed
 * again rather than remembered. */
static inline clod_law_step clod_law_step_of(const clod_law *law, const clod_law_motion *now,
                                             const clod_law_result *result,
                                             const clod_law_memory *after,
                                             const clod_law_motion *before,
                                             const clod_law_memory *memory, double dt)
{
    clod_law_motion past = *before;
    past.overlap = clod_law_overlap_before(law, before, memory);
    clod_law_memory then = *memory;
    const clod_law_result acted = clod_law_contact(law, &past, 0.0, &then);
    clod_law_step step = {.before = clod_law_moment_of(law, &past, &acted, memory),
                          .after = clod_law_moment_of(law, now, result, after),
                          .carried = clod_law_carried(law, now, memory, dt)};
    past.velocity = now->velocity;
    past.spin_i = now->spin_i;
    past.spin_j = now->spin_j;
    then = *memory;
    const clod_law_result again = clod_law_contact(law, &past, 0.0, &then);
    step.began = clod_law_moment_of(law, &past, &again, &then);
    step.closed = result->closed;
    step.met = clod_law_either(acted.closed, result->closed);
    return step;
}

/** What a hold took, and of that what it lost. */
typedef struct clod_law_taken {
    vreal viscous; ///< lost in its dash-pot, eq. (8)
    vreal spring;  ///< lost by its spring, eq. (9), (10)
    vreal lag;     ///< work of the forces that acted, not stored and not lost, eq. (11)
} clod_law_taken;

static inline clod_law_taken clod_law_take(const clod_law_hold *before,
                                           const clod_law_hold *began,
                                           const clod_law_hold *after, vreal3 carried,
                                           vreal3 way, vmask closed)
{
    const vreal work = -0.5 * vreal3_dot(vreal3_add(before->force, after->force), way);
    const vreal gain = clod_law_hold_energy(after) - clod_law_hold_energy(before);
    const vreal viscous =
        0.5 * (clod_law_hold_viscous(began, way) + clod_law_hold_viscous(after, way));
    const vreal spring = clod_law_spring_loss(before, after, carried, way, closed);
    return (clod_law_taken){viscous, spring, work - gain - viscous - spring};
}

/**
 * What a contact lost during one step.
 *
 * Each loss is the law's own, with the velocity of the step: at both ends, and along the way
 * that springs slide and histories move. Velocity Verlet does work with the mean of the forces
 * at both ends, the first of which knew only the velocity half a step earlier: the difference
 * is the lag.
 *
 * @param now     kinematics of this step, with its result and the history after it
 * @param before  the same of the step before
 * @param memory  history before it
 * @param dt      time step [s]
 * @return        J; zero for contacts that were open all along
 * Errors  none.   Threads  pure.
 * Source  docs/theory/energy.md, eq. (5)-(11).   Test  tests/law/test_law_energy.c
 */
static inline clod_law_dissipation
clod_law_dissipate(const clod_law *law, const clod_law_motion *now,
                   const clod_law_result *result, const clod_law_memory *after,
                   const clod_law_motion *before, const clod_law_memory *memory, double dt)
{
    const clod_law_step step = clod_law_step_of(law, now, result, after, before, memory, dt);
    const clod_law_moment *a = &step.before, *b = &step.after;
    const vreal length = vreal_set(dt);
    const vreal3 slip = vreal3_scale(clod_law_slip_of(now), length);
    const vreal3 turn = vreal3_scale(clod_law_rolling_of(now), length);
    const clod_law_taken sliding = clod_law_take(&a->sliding, &step.began.sliding, &b->sliding,
                                                 step.carried.spring, slip, step.closed);
    const clod_law_taken rolling = clod_law_take(&a->rolling, &step.began.rolling, &b->rolling,
                                                 step.carried.roll, turn, step.closed);
    const vreal v_n = vreal3_dot(now->velocity, now->normal);
    const vreal v_before = vreal3_dot(before->velocity, now->normal);
    const vreal dash_pot = 0.5 * (a->dash_pot + b->dash_pot) * v_n * v_n * dt;
    const vreal late = 0.5 * a->dash_pot * (v_before - v_n) * v_n * dt;
    const clod_law_dissipation dissipated = {
        clod_law_history_loss(law, a, b), dash_pot + sliding.viscous, sliding.spring,
        rolling.viscous + rolling.spring, late + sliding.lag + rolling.lag};
    const vreal zero = vreal_set(0.0);
    return (clod_law_dissipation){vreal_select(step.met, dissipated.plastic, zero),
                                  vreal_select(step.met, dissipated.dash_pot, zero),
                                  vreal_select(step.met, dissipated.friction, zero),
                                  vreal_select(step.met, dissipated.rolling, zero),
                                  vreal_select(step.met, dissipated.lag, zero)};
}
