#pragma once
/**
 * @file kernel_contact.h
 * Grain-grain contacts: rows in, law, rows out. Included by kernel.c only.
 */

#include "law/law_contact.h"
#include "step/kernel.h"

/** Shortest image of a separation in a periodic direction. */
static inline vreal kernel_image(vreal separation, double period, double inverse_period)
{
    return separation - period * vreal_round(separation * inverse_period);
}

static inline vreal3 kernel_separation(const clod_kernel_view *view, const vreal a[4],
                                       const vreal b[4])
{
    vreal3 s = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    if (view->period[0] > 0.0) {
        s.x = kernel_image(s.x, view->period[0], view->inverse_period[0]);
    }
    if (view->period[1] > 0.0) {
        s.y = kernel_image(s.y, view->period[1], view->inverse_period[1]);
    }
    if (view->period[2] > 0.0) {
        s.z = kernel_image(s.z, view->period[2], view->inverse_period[2]);
    }
    return s;
}

/** Moment of inertia about the contact point: I + m R^2, I = 1/turning[3]. */
static inline vreal kernel_contact_inertia(vreal mass, vreal radius, vreal inverse_inertia)
{
    return 1.0 / inverse_inertia + mass * radius * radius;
}

/** Kinematics of CLOD_WIDTH contacts from the rows of their grains. */
static inline clod_law_motion kernel_contact_motion(const clod_kernel_view *view,
                                                    const clod_law *law, const int32_t *i,
                                                    const int32_t *j)
{
    vreal pi[4], pj[4], vi[4], vj[4], wi[4], wj[4];
    vreal_load_rows(pi, view->place, i);
    vreal_load_rows(pj, view->place, j);
    vreal_load_rows(vi, view->motion, i);
    vreal_load_rows(vj, view->motion, j);
    vreal_load_rows(wi, view->turning, i);
    vreal_load_rows(wj, view->turning, j);
    const vreal3 apart = kernel_separation(view, pi, pj);
    const vreal square = vreal3_dot(apart, apart);
    const vreal distance = vreal_sqrt(square);
    const vreal radii = pi[3] + pj[3];
    const vreal masses = vi[3] + vj[3];
    const vreal overlap = radii - distance;
    vreal per_square = square, per_radii = radii, per_masses = masses;
    vreal_invert3(&per_square, &per_radii, &per_masses); // grains: far from over- or underflow
    clod_law_motion motion = {
        .overlap = overlap,
        .normal = vreal3_scale(apart, distance * per_square),
        .velocity = {vi[0] - vj[0], vi[1] - vj[1], vi[2] - vj[2]},
        .spin_i = {wi[0], wi[1], wi[2]},
        .spin_j = {wj[0], wj[1], wj[2]},
        .arm_i = pi[3] - 0.5 * overlap,
        .arm_j = pj[3] - 0.5 * overlap,
        .m_star = vi[3] * vj[3] * per_masses,
        .r_star = pi[3] * pj[3] * per_radii,
        .roll_inertia = vreal_set(0.0),
    };
    if (law->rolling == CLOD_ROLLING_EPSD) {
        const vreal a = kernel_contact_inertia(vi[3], pi[3], wi[3]);
        const vreal b = kernel_contact_inertia(vj[3], pj[3], wj[3]);
        motion.roll_inertia = a * b / (a + b);
    }
    return motion;
}

/** Each grain's share: force and torque in its own slot. */
static inline void kernel_contact_store(const clod_kernel_view *view,
                                        const clod_law_motion *motion, clod_law_result r,
                                        const int32_t *slot_i, const int32_t *slot_j)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 turn_i = vreal3_axpy(r.roll, -motion->arm_i, r.lever);
    const vreal3 turn_j =
        vreal3_scale(vreal3_axpy(r.roll, motion->arm_j, r.lever), vreal_set(-1.0));
    const vreal on_i[8] = {r.force.x, r.force.y, r.force.z, zero,
                           turn_i.x,  turn_i.y,  turn_i.z,  zero};
    const vreal on_j[8] = {-r.force.x, -r.force.y, -r.force.z, zero,
                           turn_j.x,   turn_j.y,   turn_j.z,   zero};
    vreal_store_rows(view->slots, slot_i, on_i);
    vreal_store_rows(view->slots, slot_j, on_j);
}

__attribute__((always_inline)) static inline bool
kernel_contact_loop(const clod_kernel_view v, const clod_law l, clod_contact_block *blocks, size_t count)
{
    vreal excess = vreal_set(-1.0);
    enum { BATCH = 4 };
    clod_law_motion motion[BATCH * CLOD_LANES / CLOD_WIDTH];
    clod_law_trial trial[BATCH * CLOD_LANES / CLOD_WIDTH];
    for (size_t first = 0; first < count; first += BATCH) {
        const size_t last = first + BATCH < count ? first + BATCH : count;
        int m = 0;
        for (size_t b = first; b < last; b++) {
            for (int lane = 0; lane < CLOD_LANES; lane += CLOD_WIDTH) {
                motion[m++] =
                    kernel_contact_motion(&v, &l, &blocks[b].i[lane], &blocks[b].j[lane]);
            }
        }
        m = 0;
        for (size_t b = first; b < last; b++) {
            for (int lane = 0; lane < CLOD_LANES; lane += CLOD_WIDTH) {
                trial[m] = clod_law_try(&l, &motion[m], v.dt,
                                        clod_law_memory_load(&blocks[b].history, lane));
                m++;
            }
        }
        m = 0;
        for (size_t b = first; b < last; b++) {
            clod_contact_block *block = &blocks[b];
            for (int lane = 0; lane < CLOD_LANES; lane += CLOD_WIDTH) {
                const clod_law_result result = clod_law_limit(&l, &motion[m], &trial[m]);
                clod_law_memory_store(&block->history, lane, result.closed, trial[m].memory);
                kernel_contact_store(&v, &motion[m], result, &block->slot_i[lane],
                                     &block->slot_j[lane]);
                // R* is at most the smaller radius and at least half of it
                const vreal beyond =
                    motion[m].overlap - CLOD_KERNEL_OVERLAP_LIMIT * 2.0 * motion[m].r_star;
                excess = vreal_max(vreal_select(result.closed, beyond, excess), excess);
                m++;
            }
        }
    }
    return vmask_any(vmask_less(vreal_set(0.0), excess));
}

static bool kernel_contact(const clod_kernel_view *view, const clod_law *law,
                           clod_contact_block *blocks, size_t count)
{
    clod_law l = *law;
    if (l.kind == CLOD_LAW_MEPA && l.exponent_kind == CLOD_EXPONENT_THREE_HALVES && l.coulomb == CLOD_COULOMB_ADHESIVE && l.tangential == CLOD_TANGENTIAL_TANGENT && l.rolling == CLOD_ROLLING_EPSD2) {
        l.kind = CLOD_LAW_MEPA; l.exponent_kind = CLOD_EXPONENT_THREE_HALVES; l.coulomb = CLOD_COULOMB_ADHESIVE; l.tangential = CLOD_TANGENTIAL_TANGENT; l.rolling = CLOD_ROLLING_EPSD2;
        return kernel_contact_loop(*view, l, blocks, count);
    }
    return kernel_contact_loop(*view, l, blocks, count);
}
