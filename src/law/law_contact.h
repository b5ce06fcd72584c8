#pragma once
/**
 * @file law_contact.h
 * One contact, whole: from overlap and relative motion to force and torque. The same text
 * serves grain-grain and grain-wall contacts, the contact bench and every instruction set.
 */

#include "law/law_normal.h"
#include "law/law_tangential.h"
#include "state/contacts.h"

/** In line wherever it is used, however long: its vectors stay in registers. */
#define CLOD_LAW_PASS __attribute__((always_inline)) static inline

/** Kinematics of a contact; j is the later grain or the wall. */
typedef struct clod_law_motion {
    vreal overlap;      ///< d [m]; the contact is open when <= 0
    vreal3 normal;      ///< n_hat from j to i
    vreal3 velocity;    ///< vi - vj [m/s]; a wall counts with its velocity at the contact
    vreal3 spin_i;      ///< rad/s
    vreal3 spin_j;      ///< rad/s
    vreal arm_i, arm_j; ///< distance of the centres from the contact point [m]; wall: 0
    vreal m_star;       ///< reduced mass [kg]
    vreal r_star;       ///< R* [m]
    vreal roll_inertia; ///< reduced moment of inertia about the contact [kg m2]
} clod_law_motion;

/** What the contact does to i; j feels -force and -lever, its torque is -arm_j q - roll. */
typedef struct clod_law_result {
    vreal3 force; ///< on i [N]
    vreal3 lever; ///< q = n x F_t [N]
    vreal3 roll;  ///< rolling torque on i [N m]
    vmask closed; ///< lanes in contact; all else is zero
} clod_law_result;

/** What a contact remembers (docs/theory/mepa.md, tangential.md, rolling.md). */
typedef struct clod_law_memory {
    vreal plastic, tangent;
    vreal3 spring, roll;
} clod_law_memory;

static inline clod_law_memory clod_law_memory_load(clod_history *history, int lane)
{
    return (clod_law_memory){
        vreal_load(&history->plastic[lane]), vreal_load(&history->tangent[lane]),
        vreal3_load(history->spring, lane), vreal3_load(history->roll, lane)};
}

/** Store the history of closed contacts; open ones forget everything (docs/theory/mepa.md). */
static inline void clod_law_memory_store(clod_history *history, int lane, vmask closed,
                                         clod_law_memory memory)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 none = {zero, zero, zero};
    vreal_store(&history->plastic[lane], vreal_select(closed, memory.plastic, zero));
    vreal_store(&history->tangent[lane], vreal_select(closed, memory.tangent, zero));
    vreal3_store(history->spring, lane, vreal3_select(closed, memory.spring, none));
    vreal3_store(history->roll, lane, vreal3_select(closed, memory.roll, none));
}

/** Relative spin without its part along the normal [rad/s]. */
static inline vreal3 clod_law_rolling_of(const clod_law_motion *motion)
{
    const vreal3 spins = vreal3_sub(motion->spin_i, motion->spin_j);
    return vreal3_axpy(spins, -vreal3_dot(spins, motion->normal), motion->normal);
}

/** Tangential velocity of i against j at the contact [m/s]. */
static inline vreal3 clod_law_slip_of(const clod_law_motion *motion)
{
    const vreal3 n = motion->normal;
    const vreal3 arms =
        vreal3_axpy(vreal3_scale(motion->spin_i, motion->arm_i), motion->arm_j, motion->spin_j);
    const vreal3 across = vreal3_axpy(motion->velocity, -vreal3_dot(motion->velocity, n), n);
    return vreal3_sub(across, vreal3_cross(arms, n));
}

/** A contact as the passes of its law see it. */
typedef struct clod_law_touch {
    vreal overlap;         ///< d [m]; the contact is open when <= 0
    vreal3 normal;         ///< n_hat from j to i
    vreal normal_velocity; ///< v_n of i against j [m/s]; below 0 they come closer
    vreal pair_spin;       ///< (w_i + w_j).n [rad/s]; half of it turns the tangent plane
    vreal3 slip;           ///< from clod_law_slip_of [m/s]
    vreal3 rolling;        ///< from clod_law_rolling_of [rad/s]; no value where nothing resists
    vreal m_star, r_star;  ///< kg, m
    vreal roll_inertia;    ///< kg m2, for epsd; no value else
} clod_law_touch;

/** What the passes need of a motion. */
static inline void clod_law_touch_of(const clod_law *law, const clod_law_motion *motion,
                                     clod_law_touch *touch)
{
    touch->overlap = motion->overlap;
    touch->normal = motion->normal;
    touch->m_star = motion->m_star;
    touch->r_star = motion->r_star;
    if (law->rolling == CLOD_ROLLING_EPSD) {
        touch->roll_inertia = motion->roll_inertia;
    }
    touch->normal_velocity = vreal3_dot(motion->velocity, motion->normal);
    touch->pair_spin = vreal3_dot(vreal3_add(motion->spin_i, motion->spin_j), motion->normal);
    touch->slip = clod_law_slip_of(motion);
    if (law->rolling != CLOD_ROLLING_NONE) {
        touch->rolling = clod_law_rolling_of(motion);
    }
}

/**
 * What is found out about a contact on its way through three passes: pressed, carried, limited.
 * Each begins with what takes long, roots and a division. The contact loop takes several
 * contacts through one pass before the next (docs/adr/0019), and begins the second and third
 * pass for one contact before it ends it for the one before (docs/adr/0021).
 */
typedef struct clod_law_trial {
    vreal push;                       ///< normal force with its dash-pot [N]
    vreal measure;                    ///< N, which the limits multiply [N]
    vreal dash_pot;                   ///< gamma_t [N s/m]
    vreal stiffness;                  ///< dk [N/m]
    vreal spring_square, roll_square; ///< lengths of the springs before, squared [m2, rad2]
    vreal limit;                      ///< mu N [N]
    vreal cap;                        ///< mu_r N R* [N m]
    vreal3 friction;                  ///< force of tangential spring and dash-pot [N]
    vreal3 roll;                      ///< torque of rolling spring and dash-pot [N m]
} clod_law_trial;

/**
 * First pass: the normal force, and the springs turned into today's tangent plane.
 *
 * @param law     the pair's law
 * @param touch   kinematics, one contact per lane
 * @param dt      time step [s]
 * @param memory  [in,out] history before; its P is that after, its springs are turned and not
 *                of their old length
 * @param trial   [out] push to roll_square
 * Errors  none.   Threads  pure.   Source  docs/theory.   Test  tests/law/
 */
CLOD_LAW_PASS void clod_law_press(const clod_law *law, const clod_law_touch *touch, double dt,
                                  clod_law_memory *memory, clod_law_trial *trial)
{
    const vreal overlap = vreal_max(touch->overlap, vreal_set(0.0));
    const clod_law_stiffness s = clod_law_stiffness_at(law, overlap, touch->r_star);
    const vreal damping = clod_law_damping(law, s, touch->m_star);
    const clod_law_normal normal = clod_law_normal_force(law, s, &memory->plastic);
    trial->push = normal.force - damping * touch->normal_velocity;
    trial->measure = clod_law_normal_measure(law, normal);
    trial->dash_pot = clod_law_tangential_damping(law, damping, touch->m_star);
    trial->stiffness = s.tangent;

    const clod_law_frame frame = {touch->normal, 0.5 * dt * touch->pair_spin};
    trial->spring_square = vreal3_dot(memory->spring, memory->spring);
    memory->spring = clod_law_spring_turn(&frame, memory->spring);
    if (clod_law_rolling_springs(law)) {
        trial->roll_square = vreal3_dot(memory->roll, memory->roll);
        memory->roll = clod_law_spring_turn(&frame, memory->roll);
    }
}

/** Beginning of the second pass: what takes its division. */
typedef struct clod_law_inverses {
    clod_law_tangents tangent;
    vreal per_spring, per_roll; ///< 1/length^2 of the turned springs [1/m2, 1/rad2]
} clod_law_inverses;

/**
 * Inverses of the stiffness and of both squared lengths.
 *
 * @param memory  turned springs, and the tangent of the step before
 *
 * The product of the three numbers inverted together lies far from the ends of the range: both
 * squares are at least CLOD_LAW_NOTHING.
 */
CLOD_LAW_PASS clod_law_inverses clod_law_carry_begin(const clod_law *law,
                                                     const clod_law_trial *trial,
                                                     const clod_law_memory *memory)
{
    clod_law_inverses l = {.tangent.inverse = trial->stiffness,
                           .per_spring = clod_law_spring_square(memory->spring)};
    if (clod_law_rolling_springs(law)) {
        l.per_roll = clod_law_spring_square(memory->roll);
        vreal_invert3(&l.tangent.inverse, &l.per_spring, &l.per_roll);
    } else {
        vreal_invert2(&l.tangent.inverse, &l.per_spring);
    }
    l.tangent.soften = vreal_min(memory->tangent * l.tangent.inverse, vreal_set(1.0));
    return l;
}

/** Springs with today's length: that of before, shortened where the stiffness has grown
 * (docs/adr/0004), and the slip of this step. */
CLOD_LAW_PASS void clod_law_carry_springs(const clod_law *law, const clod_law_touch *touch,
                                          double dt, const clod_law_inverses *inverses,
                                          const clod_law_trial *trial, clod_law_memory *memory)
{
    const vreal step = vreal_set(dt);
    const clod_law_tangents *tangent = &inverses->tangent;
    if (clod_law_rolling_springs(law)) {
        memory->roll =
            clod_law_spring_restore(memory->roll, trial->roll_square, inverses->per_roll,
                                    clod_law_rolling_soften(law, tangent));
        memory->roll = vreal3_axpy(memory->roll, step, touch->rolling);
    }
    memory->spring =
        clod_law_spring_restore(memory->spring, trial->spring_square, inverses->per_spring,
                                clod_law_tangential_soften(law, tangent));
    memory->spring = vreal3_axpy(memory->spring, step, touch->slip);
    memory->tangent = trial->stiffness;
}

/**
 * Springs shortened to what their limits carry: |k_t spring| <= mu N, |k_r roll| <= mu_r N R*.
 * The dash-pots have no part in it: with a spring that they could load, friction would make
 * energy (docs/adr/0025).
 */
CLOD_LAW_PASS void clod_law_return_springs(const clod_law *law, vreal k_t, vreal k_r,
                                           const clod_law_trial *trial, clod_law_memory *memory)
{
    const clod_law_cut slides =
        clod_law_cut_of(vreal3_scale(memory->spring, k_t), trial->limit);
    vreal per_slides = slides.square; // 1 or above CLOD_LAW_NOTHING
    if (clod_law_rolling_springs(law)) {
        const clod_law_cut rolls = clod_law_cut_of(vreal3_scale(memory->roll, k_r), trial->cap);
        vreal per_rolls = rolls.square;
        vreal_invert2(&per_slides, &per_rolls);
        memory->roll = vreal3_scale(memory->roll, clod_law_cut_factor(rolls, per_rolls));
    } else {
        per_slides = 1.0 / per_slides;
    }
    memory->spring = vreal3_scale(memory->spring, clod_law_cut_factor(slides, per_slides));
}

/**
 * Second pass: the springs as they stay, carried on by this step and within their limits; and
 * what they pull with, dash-pots included.
 *
 * @param law      the pair's law
 * @param touch    as for clod_law_press
 * @param dt       time step [s]
 * @param inverses from clod_law_carry_begin
 * @param memory   [in,out] turned springs, and the tangent of the step before; becomes the
 *                 history after, meaningful in closed lanes only
 * @param trial    [in,out] from clod_law_press; gets limit, cap, friction and roll
 * Errors  none.   Threads  pure.   Source  docs/theory/tangential.md, rolling.md.
 * Test    tests/law/
 */
CLOD_LAW_PASS void clod_law_carry(const clod_law *law, const clod_law_touch *touch, double dt,
                                  const clod_law_inverses *inverses, clod_law_memory *memory,
                                  clod_law_trial *trial)
{
    const vreal k_t = clod_law_tangential_stiffness(law, trial->stiffness);
    const vreal k_r = clod_law_rolling_stiffness(law, trial->stiffness, touch->r_star);
    trial->limit = law->friction * trial->measure;
    if (law->rolling != CLOD_ROLLING_NONE) {
        trial->cap = law->rolling_friction * trial->measure * touch->r_star;
    }
    clod_law_carry_springs(law, touch, dt, inverses, trial, memory);
    clod_law_return_springs(law, k_t, k_r, trial, memory);
    trial->friction = clod_law_friction(k_t, touch->slip, trial->dash_pot, memory->spring);
    if (law->rolling != CLOD_ROLLING_NONE) {
        trial->roll = clod_law_rolling_torque(law, touch->rolling, k_r, touch->roll_inertia,
                                              memory->roll);
    }
}

/** Beginning of the last pass: limits, what is beyond them, and what takes roots and a
 * division. */
typedef struct clod_law_cuts {
    clod_law_cut slides, rolls;  ///< of friction [N] and rolling resistance [N m]
    vreal per_slides, per_rolls; ///< 1 over their squares
} clod_law_cuts;

/** Where spring and dash-pot together are beyond the limits (docs/theory/tangential.md,
 * rolling.md). */
CLOD_LAW_PASS clod_law_cuts clod_law_limit_begin(const clod_law *law,
                                                 const clod_law_trial *trial)
{
    clod_law_cuts c = {.slides = clod_law_cut_of(trial->friction, trial->limit)};
    c.per_slides = c.slides.square; // 1 or above CLOD_LAW_NOTHING
    if (clod_law_rolling_capped(law)) {
        const bool spring = clod_law_rolling_springs(law); // cdt has its cap at any spin
        c.rolls = clod_law_cut_of(trial->roll, spring ? trial->cap : vreal_set(0.0));
        c.rolls.limit = trial->cap;
        c.per_rolls = c.rolls.square;
        vreal_invert2(&c.per_slides, &c.per_rolls);
    } else {
        c.per_slides = 1.0 / c.per_slides;
    }
    return c;
}

/**
 * Last pass: friction and rolling resistance shortened to their limits. The springs stay as
 * they are.
 *
 * @param law     the pair's law
 * @param touch   as for clod_law_press
 * @param trial   from clod_law_carry
 * @param cuts    from clod_law_limit_begin
 * @return        force and torques, zero where the contact is open
 * Errors  none.   Threads  pure.   Source  docs/theory/tangential.md, rolling.md.
 * Test    tests/law/
 */
CLOD_LAW_PASS clod_law_result clod_law_limit(const clod_law *law, const clod_law_touch *touch,
                                             const clod_law_trial *trial,
                                             const clod_law_cuts *cuts)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 none = {zero, zero, zero};
    const vreal3 n = touch->normal;
    const vreal3 f_t =
        vreal3_scale(trial->friction, clod_law_cut_factor(cuts->slides, cuts->per_slides));
    vreal3 roll = none;
    if (clod_law_rolling_capped(law)) {
        roll = vreal3_scale(trial->roll, clod_law_cut_factor(cuts->rolls, cuts->per_rolls));
    } else if (law->rolling != CLOD_ROLLING_NONE) {
        roll = trial->roll; // a spring within its cap
    }
    const vmask closed = vmask_less(zero, touch->overlap);
    return (clod_law_result){vreal3_select(closed, vreal3_axpy(f_t, trial->push, n), none),
                             vreal3_select(closed, vreal3_cross(n, f_t), none),
                             vreal3_select(closed, roll, none), closed};
}

/** Force and torque of one contact, and its new history: all three passes. */
CLOD_LAW_PASS clod_law_result clod_law_contact(const clod_law *law,
                                               const clod_law_motion *motion, double dt,
                                               clod_law_memory *memory)
{
    clod_law_touch touch = {.rolling = motion->spin_i}; // zeros: no field is without a value
    clod_law_trial trial = {.push = motion->overlap};
    clod_law_touch_of(law, motion, &touch);
    clod_law_press(law, &touch, dt, memory, &trial);
    const clod_law_inverses inverses = clod_law_carry_begin(law, &trial, memory);
    clod_law_carry(law, &touch, dt, &inverses, memory, &trial);
    const clod_law_cuts cuts = clod_law_limit_begin(law, &trial);
    return clod_law_limit(law, &touch, &trial, &cuts);
}
