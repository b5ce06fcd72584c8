#pragma once
/**
 * @file law_contact.h
 * One contact, whole: from overlap and relative motion to force and torque. The same text
 * serves grain-grain and grain-wall contacts, the contact bench and every instruction set.
 */

#include "law/law_normal.h"
#include "law/law_tangential.h"
#include "state/contacts.h"

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

/**
 * Carry both springs into today's tangent plane, with the length that they had, shortened where
 * the stiffness has grown (docs/adr/0004).
 *
 * @param stiffness  dk now [N/m]
 * @param memory     [in,out] its springs; its tangent is the one before
 * @return           what friction and rolling need of dk
 * The product of the three numbers inverted together lies far from the ends of the range: both
 * squares are at least CLOD_LAW_NOTHING.
 */
static inline clod_law_tangents clod_law_springs_carry(const clod_law *law,
                                                       const clod_law_frame *frame,
                                                       vreal stiffness, clod_law_memory *memory)
{
    clod_law_tangents tangent = {.stiffness = stiffness, .inverse = stiffness};
    const clod_law_turned spring = clod_law_spring_turn(frame, memory->spring);
    vreal spring_after = spring.after;
    if (clod_law_rolling_springs(law)) {
        const clod_law_turned roll = clod_law_spring_turn(frame, memory->roll);
        vreal roll_after = roll.after;
        vreal_invert3(&tangent.inverse, &spring_after, &roll_after);
        tangent.soften = vreal_min(memory->tangent * tangent.inverse, vreal_set(1.0));
        const vreal soften = clod_law_rolling_soften(law, &tangent);
        memory->roll = clod_law_spring_restore(roll, roll_after, soften);
    } else {
        vreal_invert2(&tangent.inverse, &spring_after);
        tangent.soften = vreal_min(memory->tangent * tangent.inverse, vreal_set(1.0));
    }
    const vreal soften = clod_law_tangential_soften(law, &tangent);
    memory->spring = clod_law_spring_restore(spring, spring_after, soften);
    memory->tangent = stiffness;
    return tangent;
}

/** A contact before its limits: what is left to do is to cut two vectors. */
typedef struct clod_law_trial {
    vreal push;           ///< normal force with its dash-pot [N]
    vreal3 friction;      ///< force of tangential spring and dash-pot [N]
    vreal3 pull;          ///< from clod_law_rolling_pull
    vreal3 rolling;       ///< relative spin without its part along the normal [rad/s]
    vreal limit;          ///< mu N [N]
    vreal cap;            ///< mu_r N R* [N m]
    vreal compliance;     ///< 1/k_t [m/N]
    vreal roll_stiffness; ///< k_r [N m/rad]
    clod_law_memory memory;
} clod_law_trial;

/** What rolling resistance would be without its cap, into the trial. */
static inline void clod_law_try_rolling(const clod_law *law, const clod_law_motion *motion,
                                        double dt, vreal measure, vreal tangent,
                                        clod_law_trial *t)
{
    const vreal3 n = motion->normal;
    const vreal3 spins = vreal3_sub(motion->spin_i, motion->spin_j);
    t->rolling = vreal3_axpy(spins, -vreal3_dot(spins, n), n);
    t->cap = law->rolling_friction * measure * motion->r_star;
    t->roll_stiffness = clod_law_rolling_stiffness(law, tangent, motion->r_star);
    t->pull = clod_law_rolling_pull(law, dt, t->rolling, t->roll_stiffness, &t->memory.roll);
}

/**
 * First half of a contact: normal force, springs in today's plane with the way of this step,
 * and the limits.
 *
 * @param law     the pair's law
 * @param motion  kinematics, one contact per lane
 * @param dt      time step [s]
 * @param memory  history before
 * Errors  none.   Threads  pure.
 * Source  PHYSICS 1-4.   Test  tests/law/
 */
__attribute__((always_inline)) static inline clod_law_trial // its vectors stay in registers
clod_law_try(const clod_law *law, const clod_law_motion *motion, double dt,
             clod_law_memory memory)
{
    clod_law_trial t = {.memory = memory};
    const vreal3 n = motion->normal;
    const vreal overlap = vreal_max(motion->overlap, vreal_set(0.0));
    const clod_law_stiffness s = clod_law_stiffness_at(law, overlap, motion->r_star);
    const clod_law_normal normal = clod_law_normal_force(law, s, &t.memory.plastic);
    const vreal measure = clod_law_normal_measure(law, normal);
    const vreal damping = clod_law_damping(law, s, motion->m_star);
    const vreal v_n = vreal3_dot(motion->velocity, n);
    t.push = normal.force - damping * v_n;
    t.limit = law->friction * measure;

    const vreal3 both = vreal3_add(motion->spin_i, motion->spin_j);
    const clod_law_frame frame = {n, 0.5 * dt * vreal3_dot(both, n)};
    const clod_law_tangents tangent = clod_law_springs_carry(law, &frame, s.tangent, &t.memory);
    t.compliance = clod_law_tangential_compliance(law, &tangent);

    const vreal3 arms =
        vreal3_axpy(vreal3_scale(motion->spin_i, motion->arm_i), motion->arm_j, motion->spin_j);
    const vreal3 across = vreal3_axpy(motion->velocity, -v_n, n);
    const vreal3 slip = vreal3_sub(across, vreal3_cross(arms, n));
    const vreal dash_pot = clod_law_tangential_damping(law, damping, motion->m_star);
    t.friction = clod_law_friction(law, s.tangent, dt, slip, dash_pot, &t.memory.spring);
    if (law->rolling != CLOD_ROLLING_NONE) {
        clod_law_try_rolling(law, motion, dt, measure, s.tangent, &t);
    }
    return t;
}

/**
 * Second half of a contact: friction and rolling resistance cut to their limits.
 *
 * @param trial  [in,out] its memory becomes the history after; meaningful in closed lanes only
 * @return       force and torques, zero where the contact is open
 * Errors  none.   Threads  pure.
 * Source  PHYSICS 3, 4.   Test  tests/law/
 */
__attribute__((always_inline)) static inline clod_law_result
clod_law_limit(const clod_law *law, const clod_law_motion *motion, clod_law_trial *trial)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 none = {zero, zero, zero};
    const vreal3 n = motion->normal;
    const clod_law_cut slides = clod_law_cut_of(trial->friction, trial->limit);
    clod_law_cut rolls = slides;
    vreal per_slip = slides.square, per_roll = vreal_set(1.0);
    if (law->rolling != CLOD_ROLLING_NONE) {
        rolls = clod_law_cut_of(trial->pull, clod_law_rolling_limit(law, trial->cap));
        per_roll = rolls.square;
    }
    vreal_invert2(&per_slip, &per_roll); // each 1 or above CLOD_LAW_NOTHING
    const vreal factor = trial->limit * (slides.length * per_slip);
    const vreal3 f_t = clod_law_friction_cut(trial->friction, slides, factor, trial->compliance,
                                             &trial->memory.spring);
    vreal3 roll = none;
    if (law->rolling != CLOD_ROLLING_NONE) {
        const vreal share = trial->cap * (rolls.length * per_roll);
        roll = clod_law_rolling_cut(law, trial->pull, rolls, share, trial->roll_stiffness,
                                    trial->rolling, motion->roll_inertia, &trial->memory.roll);
    }
    const vmask closed = vmask_less(zero, motion->overlap);
    return (clod_law_result){vreal3_select(closed, vreal3_axpy(f_t, trial->push, n), none),
                             vreal3_select(closed, vreal3_cross(n, f_t), none),
                             vreal3_select(closed, roll, none), closed};
}

/** Force and torque of one contact, and its new history: both halves. */
__attribute__((always_inline)) static inline clod_law_result
clod_law_contact(const clod_law *law, const clod_law_motion *motion, double dt,
                 clod_law_memory *memory)
{
    clod_law_trial trial = clod_law_try(law, motion, dt, *memory);
    const clod_law_result result = clod_law_limit(law, motion, &trial);
    *memory = trial.memory;
    return result;
}
