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

/** Fraction to which springs shrink because the tangent grew since the last step. */
static inline vreal clod_law_soften(vreal before, vreal now)
{
    return vreal_min(before / now, vreal_set(1.0));
}

/**
 * Force and torque of one contact, and its new history.
 *
 * @param law     the pair's law
 * @param motion  kinematics, one contact per lane
 * @param dt      time step [s]
 * @param memory  [in,out] history; meaningful in closed lanes only
 * @return        force and torques, zero where the contact is open
 * Errors  none.   Threads  pure.
 * Source  PHYSICS 1-4.   Test  tests/law/
 */
__attribute__((always_inline)) static inline clod_law_result // its vectors stay in registers
clod_law_contact(const clod_law *law, const clod_law_motion *motion, double dt,
                 clod_law_memory *memory)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 n = motion->normal;
    const vreal overlap = vreal_max(motion->overlap, zero);
    const clod_law_stiffness s = clod_law_stiffness_at(law, overlap, motion->r_star);
    const clod_law_normal normal = clod_law_normal_force(law, s, &memory->plastic);
    const vreal measure = clod_law_normal_measure(law, normal);
    const vreal v_n = vreal3_dot(motion->velocity, n);
    const vreal f_n = normal.force - clod_law_damping(law, s, motion->m_star) * v_n;

    const vreal3 arms =
        vreal3_axpy(vreal3_scale(motion->spin_i, motion->arm_i), motion->arm_j, motion->spin_j);
    const vreal3 across = vreal3_axpy(motion->velocity, -v_n, n);
    const vreal3 slip = vreal3_sub(across, vreal3_cross(arms, n));
    const vreal3 both = vreal3_add(motion->spin_i, motion->spin_j);
    const vreal turn = 0.5 * dt * vreal3_dot(both, n);
    const clod_law_frame frame = {n, turn, clod_law_soften(memory->tangent, s.tangent), dt};
    const vreal3 f_t = clod_law_friction(law, &frame, slip, law->friction * measure, s.tangent,
                                         motion->m_star, &memory->spring);

    vreal3 roll = {zero, zero, zero};
    if (law->rolling != CLOD_ROLLING_NONE) {
        const vreal3 spins = vreal3_sub(motion->spin_i, motion->spin_j);
        const vreal3 rolling = vreal3_axpy(spins, -vreal3_dot(spins, n), n);
        roll = clod_law_rolling(law, &frame, rolling, measure, s.tangent, motion->r_star,
                                motion->roll_inertia, &memory->roll);
    }
    memory->tangent = s.tangent;
    const vmask closed = vmask_less(zero, motion->overlap);
    const vreal3 none = {zero, zero, zero};
    return (clod_law_result){vreal3_select(closed, vreal3_axpy(f_t, f_n, n), none),
                             vreal3_select(closed, vreal3_cross(n, f_t), none),
                             vreal3_select(closed, roll, none), closed};
}
