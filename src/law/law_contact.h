#pragma once
/**
 * @file law_contact.h
 * One contact, whole: from overlap and relative motion to force and torque. The same text
 * serves grain-grain and grain-wall contacts, the contact bench and every instruction set.
 */

#include "law/law_normal.h"
#include "law/law_tangential.h"
#include "state/contacts.h"

/** A pass of the law, in line wherever it is used: its vectors stay in registers. */
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

/** What a contact remembers (PHYSICS 1, 3, 4). */
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

/** Store the history of closed contacts; open ones forget everything (PHYSICS 1). */
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

/**
 * What is found out about a contact on its way through three passes, each a function: pressed,
 * carried, limited. The contact loop takes several contacts through one pass before the next
 * (docs/adr/0019).
 */
typedef struct clod_law_trial {
    vreal push;                       ///< normal force with its dash-pot [N]
    vreal measure;                    ///< N, which the limits multiply [N]
    vreal dash_pot;                   ///< gamma_t [N s/m]
    vreal stiffness;                  ///< dk [N/m]
    vreal spring_square, roll_square; ///< lengths of the springs before, squared [m2, rad2]
    vreal compliance;                 ///< 1/k_t [m/N]
    vreal3 friction;                  ///< force of tangential spring and dash-pot [N]
} clod_law_trial;

/**
 * First pass: the normal force, and the springs turned into today's tangent plane.
 *
 * @param law     the pair's law
 * @param motion  kinematics, one contact per lane
 * @param dt      time step [s]
 * @param memory  [in,out] history before; its P is that after, its springs are turned and not
 *                of their old length
 * @param trial   [out] push to roll_square
 * Errors  none.   Threads  pure.   Source  PHYSICS 1-4.   Test  tests/law/
 */
CLOD_LAW_PASS void clod_law_press(const clod_law *law, const clod_law_motion *motion, double dt,
                                  clod_law_memory *memory, clod_law_trial *trial)
{
    const vreal3 n = motion->normal;
    const vreal overlap = vreal_max(motion->overlap, vreal_set(0.0));
    const clod_law_stiffness s = clod_law_stiffness_at(law, overlap, motion->r_star);
    const clod_law_normal normal = clod_law_normal_force(law, s, &memory->plastic);
    const vreal damping = clod_law_damping(law, s, motion->m_star);
    trial->push = normal.force - damping * vreal3_dot(motion->velocity, n);
    trial->measure = clod_law_normal_measure(law, normal);
    trial->dash_pot = clod_law_tangential_damping(law, damping, motion->m_star);
    trial->stiffness = s.tangent;

    const vreal3 both = vreal3_add(motion->spin_i, motion->spin_j);
    const clod_law_frame frame = {n, 0.5 * dt * vreal3_dot(both, n)};
    trial->spring_square = vreal3_dot(memory->spring, memory->spring);
    memory->spring = clod_law_spring_turn(&frame, memory->spring);
    if (clod_law_rolling_springs(law)) {
        trial->roll_square = vreal3_dot(memory->roll, memory->roll);
        memory->roll = clod_law_spring_turn(&frame, memory->roll);
    }
}

/**
 * Second pass: the springs get the length that they had, shortened where the stiffness has
 * grown (docs/adr/0004), and the way of this step; and the force of the tangential one. The
 * product of the three numbers inverted together lies far from the ends of the range: both
 * squares are at least CLOD_LAW_NOTHING.
 *
 * @param law     the pair's law
 * @param motion  as for clod_law_press
 * @param dt      time step [s]
 * @param memory  [in,out] turned springs, and the tangent of the step before
 * @param trial   [in,out] from clod_law_press; gets compliance and friction
 * Errors  none.   Threads  pure.   Source  PHYSICS 3, 4.   Test  tests/law/
 */
CLOD_LAW_PASS void clod_law_carry(const clod_law *law, const clod_law_motion *motion, double dt,
                                  clod_law_memory *memory, clod_law_trial *trial)
{
    const vreal step = vreal_set(dt);
    clod_law_tangents tangent = {.inverse = trial->stiffness};
    vreal per_spring = clod_law_spring_square(memory->spring);
    if (clod_law_rolling_springs(law)) {
        vreal per_roll = clod_law_spring_square(memory->roll);
        vreal_invert3(&tangent.inverse, &per_spring, &per_roll);
        tangent.soften = vreal_min(memory->tangent * tangent.inverse, vreal_set(1.0));
        memory->roll = clod_law_spring_restore(memory->roll, trial->roll_square, per_roll,
                                               clod_law_rolling_soften(law, &tangent));
        memory->roll = vreal3_axpy(memory->roll, step, clod_law_rolling_of(motion));
    } else {
        vreal_invert2(&tangent.inverse, &per_spring);
        tangent.soften = vreal_min(memory->tangent * tangent.inverse, vreal_set(1.0));
    }
    memory->spring = clod_law_spring_restore(memory->spring, trial->spring_square, per_spring,
                                             clod_law_tangential_soften(law, &tangent));
    const vreal3 slip = clod_law_slip_of(motion);
    memory->spring = vreal3_axpy(memory->spring, step, slip);
    memory->tangent = trial->stiffness;
    trial->compliance = clod_law_tangential_compliance(law, &tangent);
    trial->friction =
        clod_law_friction(law, trial->stiffness, slip, trial->dash_pot, memory->spring);
}

/** Rolling resistance before its cap. */
typedef struct clod_law_resistance {
    vreal3 rolling;  ///< rad/s; epsd2 has no need of it and no value
    vreal3 pull;     ///< from clod_law_rolling_pull
    vreal stiffness; ///< k_r [N m/rad]
    vreal cap;       ///< mu_r N R* [N m]
} clod_law_resistance;

/** Rolling resistance before its cap, from the rolling spring with the way of this step. */
static inline clod_law_resistance clod_law_resist(const clod_law *law,
                                                  const clod_law_motion *motion,
                                                  const clod_law_trial *trial, vreal3 roll)
{
    clod_law_resistance r = {.cap = law->rolling_friction * trial->measure * motion->r_star};
    if (law->rolling != CLOD_ROLLING_EPSD2) {
        r.rolling = clod_law_rolling_of(motion);
    }
    r.stiffness = clod_law_rolling_stiffness(law, trial->stiffness, motion->r_star);
    r.pull = clod_law_rolling_pull(law, r.rolling, r.stiffness, roll);
    return r;
}

/**
 * Last pass: friction and rolling resistance cut to their limits.
 *
 * @param law     the pair's law
 * @param motion  as for clod_law_press
 * @param trial   from clod_law_carry
 * @param memory  [in,out] becomes the history after; meaningful in closed lanes only
 * @return        force and torques, zero where the contact is open
 * Errors  none.   Threads  pure.   Source  PHYSICS 3, 4.   Test  tests/law/
 */
CLOD_LAW_PASS clod_law_result clod_law_limit(const clod_law *law, const clod_law_motion *motion,
                                             const clod_law_trial *trial,
                                             clod_law_memory *memory)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 none = {zero, zero, zero};
    const vreal3 n = motion->normal;
    const vreal limit = law->friction * trial->measure;
    const clod_law_cut slides = clod_law_cut_of(trial->friction, limit);
    clod_law_resistance resistance = {none, none, zero, zero};
    clod_law_cut rolls = slides;
    vreal per_slip = slides.square, per_roll = vreal_set(1.0);
    if (law->rolling != CLOD_ROLLING_NONE) {
        resistance = clod_law_resist(law, motion, trial, memory->roll);
        rolls = clod_law_cut_of(resistance.pull, clod_law_rolling_limit(law, resistance.cap));
        per_roll = rolls.square;
    }
    vreal_invert2(&per_slip, &per_roll); // each 1 or above CLOD_LAW_NOTHING
    const vreal factor = limit * (slides.length * per_slip);
    const vreal3 f_t = clod_law_friction_cut(trial->friction, slides, factor, trial->compliance,
                                             &memory->spring);
    vreal3 roll = none;
    if (law->rolling != CLOD_ROLLING_NONE) {
        const vreal share = resistance.cap * (rolls.length * per_roll);
        roll = clod_law_rolling_cut(law, resistance.pull, rolls, share, resistance.stiffness,
                                    resistance.rolling, motion->roll_inertia, &memory->roll);
    }
    const vmask closed = vmask_less(zero, motion->overlap);
    return (clod_law_result){vreal3_select(closed, vreal3_axpy(f_t, trial->push, n), none),
                             vreal3_select(closed, vreal3_cross(n, f_t), none),
                             vreal3_select(closed, roll, none), closed};
}

/** Force and torque of one contact, and its new history: all three passes. */
CLOD_LAW_PASS clod_law_result clod_law_contact(const clod_law *law,
                                               const clod_law_motion *motion, double dt,
                                               clod_law_memory *memory)
{
    clod_law_trial trial;
    clod_law_press(law, motion, dt, memory, &trial);
    clod_law_carry(law, motion, dt, memory, &trial);
    return clod_law_limit(law, motion, &trial, memory);
}
