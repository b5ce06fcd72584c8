#pragma once
/**
 * @file kernel_contact.h
 * Grain-grain contacts: rows in, law, rows out. Included by kernel.c only.
 *
 * A contact's way, 8 (or CLOD_WIDTH) contacts a vector, 4 blocks a batch:
 *
 *   view->position, velocity, ...      block: i, j         block->history
 *   (rows of grains i and j)                  |              P  tangent  spring  roll
 *          |                                  |              |     |       |      |
 *   move   +--> kernel_contact_motion <-------+              |     |       |      |
 *          |    overlap, normal, arms, slip, rolling         |     |       |      |
 *          |    -> batch->meeting[k]                         |     |       |      |
 *          v                                                 v     |       |      |
 *   press  clod_law_press: f_n, stiffnesses, dash-pots  <--> P     |       |      |
 *          |    springs turned with the contact   <----------------|-----> s <--> r
 *          |    -> batch->trial[k]                                 v       |      |
 *   carry  clod_law_carry: springs plus slip, held to limits <--> tangent <-> s <-> r
 *          |    trial force and torque -> batch->trial[k]
 *          v
 *   limit  clod_law_limit: spring and dash-pot together held to them -> clod_law_result
 *          |
 *          +--> view->load[j] -= force, then view->load[i] += force    (or i's share apart,
 *               with the torques of force and rolling                  between two parts)
 *
 * Carry and limit begin with the roots and divisions of the next vector before they end this
 * one (docs/adr/0021); why passes at all: docs/adr/step.md.
 */

#include <stddef.h>

#include "step/kernel_batch.h"

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

/** Moment of inertia about the contact point: I + m R^2, I = 1/angular_velocity[3]. */
static inline vreal kernel_contact_inertia(vreal mass, vreal radius, vreal inverse_inertia)
{
    return 1.0 / inverse_inertia + mass * radius * radius;
}

/** Kinematics of CLOD_WIDTH contacts from the rows of their grains. */
CLOD_LAW_PASS clod_law_motion kernel_contact_motion(const clod_kernel_view *view,
                                                    const clod_law *law, const int32_t *i,
                                                    const int32_t *j)
{
    vreal pi[4], pj[4], vi[4], vj[4], wi[4], wj[4];
    vreal_load_rows(pi, view->position, i);
    vreal_load_rows(pj, view->position, j);
    const vreal3 apart = kernel_separation(view, pi, pj);
    const vreal square = vreal3_dot(apart, apart);
    const vreal distance = vreal_sqrt(square);
    const vreal radii = pi[3] + pj[3];
    const vreal overlap = radii - distance;
    vreal_load_rows(vi, view->velocity, i); // only now: more rows than registers
    vreal_load_rows(vj, view->velocity, j);
    const vreal masses = vi[3] + vj[3];
    vreal per_square = vreal_max(square, vreal_set(CLOD_LAW_NOTHING)); // one place for both
    vreal per_radii = radii, per_masses = masses;
    vreal_invert3(&per_square, &per_radii, &per_masses); // grains: far from over- or underflow
    vreal_load_rows(wi, view->angular_velocity, i);
    vreal_load_rows(wj, view->angular_velocity, j);
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

#define KERNEL_PAIRS                                                                           \
    ((kernel_layout){sizeof(clod_contact_block), offsetof(clod_contact_block, history)})

/** First pass: kinematics. */
CLOD_LAW_PASS void kernel_contact_move(const clod_kernel_view *view, const clod_law *law,
                                       kernel_batch *batch)
{
    for (int k = 0; k < batch->vectors; k++) {
        const clod_contact_block *block = kernel_block(batch, KERNEL_PAIRS, k);
        const clod_law_motion motion = kernel_contact_motion(
            view, law, &block->i[kernel_lane(k)], &block->j[kernel_lane(k)]);
        batch->meeting[k].arm_i = motion.arm_i;
        batch->meeting[k].arm_j = motion.arm_j;
        clod_law_touch_of(law, &motion, &batch->meeting[k].touch);
    }
}

/** Each grain's share: added to its load in the order of contacts; or i's kept apart. */
CLOD_LAW_PASS void kernel_contact_store(const clod_kernel_view *view,
                                        const kernel_meeting *meeting, clod_law_result r,
                                        const int32_t *i, const int32_t *j, int lanes,
                                        double (*apart)[8])
{
    const vreal zero = vreal_set(0.0);
    const vreal3 turn_i = vreal3_axpy(r.roll, -meeting->arm_i, r.lever);
    const vreal3 turn_j =
        vreal3_scale(vreal3_axpy(r.roll, meeting->arm_j, r.lever), vreal_set(-1.0));
    const vreal on_i[8] = {r.force.x, r.force.y, r.force.z, zero,
                           turn_i.x,  turn_i.y,  turn_i.z,  zero};
    const vreal on_j[8] = {-r.force.x, -r.force.y, -r.force.z, zero,
                           turn_j.x,   turn_j.y,   turn_j.z,   zero};
    if (apart != NULL) {
        static const int32_t FOLLOWING[8] = {0, 1, 2, 3, 4, 5, 6, 7};
        vreal_add_rows(view->load, j, on_j, lanes);
        vreal_store_rows(apart, FOLLOWING, on_i);
        return;
    }
    // contacts ascend by (i, j): whatever a grain gets as j comes before what it gets as i
    vreal_add_rows(view->load, j, on_j, lanes);
    vreal_add_rows(view->load, i, on_i, lanes);
}

/** Last pass: limits and shares; the largest excess of an overlap so far. */
CLOD_LAW_PASS vreal kernel_contact_limit(const clod_kernel_view *view, const clod_law *law,
                                         kernel_batch *batch, double (*apart)[8], vreal excess)
{
    clod_law_cuts cuts = clod_law_limit_begin(law, &batch->trial[0]);
    for (int k = 0; k < batch->vectors; k++) {
        const clod_law_result result = kernel_batch_limit(law, batch, k, &cuts);
        const clod_contact_block *block = kernel_block(batch, KERNEL_PAIRS, k);
        const int lane = kernel_lane(k);
        kernel_contact_store(view, &batch->meeting[k], result, &block->i[lane], &block->j[lane],
                             kernel_lanes(batch, k),
                             apart != NULL ? apart + k * CLOD_WIDTH : NULL);
        const kernel_meeting *meeting = &batch->meeting[k];
        const vreal overlap = meeting->touch.overlap; // an arm is the radius less half of it
        const vreal radius = vreal_min(meeting->arm_i, meeting->arm_j) + 0.5 * overlap;
        const vreal beyond = overlap - view->overlap_limit * radius;
        excess = vreal_max(vreal_select(result.closed, beyond, excess), excess);
    }
    return excess;
}

/**
 * Prefetch the rows up to view->lead behind a grain, in their order, beginning with row `from`:
 * partners come from several lines at once, in no order that a processor could foresee. Rows
 * from `end` on may be another thread's and are left alone, but for at most the first.
 */
static inline size_t kernel_prefetch_rows(const clod_kernel_view *view, size_t from,
                                          int32_t grain, size_t end)
{
    const size_t wanted = (size_t)grain + view->lead;
    const size_t to = wanted < end ? wanted : end;
    for (; from < to; from += 2) { // two rows of four in a line
        __builtin_prefetch(view->position[from], 0, 2);
        __builtin_prefetch(view->velocity[from], 0, 2);
        __builtin_prefetch(view->angular_velocity[from], 0, 2);
        __builtin_prefetch(view->load[from], 1, 2);
        __builtin_prefetch(view->load[from + 1], 1, 2); // at the end of a part one row too far
    }
    return from;
}

/** All contacts, batch by batch through the passes. */
CLOD_LAW_PASS bool kernel_contact_loop(const clod_kernel_view *view, const clod_law law,
                                       clod_contact_block *blocks, size_t contacts, size_t end,
                                       double (*apart)[8])
{
    const clod_kernel_view v = *view;
    vreal excess = vreal_set(-1.0);
    kernel_batch batch;
    size_t ahead = contacts > 0 ? (size_t)blocks->i[0] : 0;
    for (size_t first = 0; first < contacts; first += (size_t)KERNEL_BATCH * CLOD_LANES) {
        kernel_batch_begin(&batch, KERNEL_PAIRS, blocks, first, contacts);
        ahead = kernel_prefetch_rows(&v, ahead, blocks[first / CLOD_LANES].i[0], end);
        kernel_contact_move(&v, &law, &batch);
        kernel_batch_press(&law, v.dt, KERNEL_PAIRS, &batch);
        kernel_batch_carry(&law, v.dt, KERNEL_PAIRS, &batch);
        excess = kernel_contact_limit(&v, &law, &batch, apart != NULL ? apart + first : NULL,
                                      excess);
    }
    return vmask_any(vmask_less(vreal_set(0.0), excess));
}

/** The loop once more for laws that most beds have: it asks for no choice of the law, and all
 * that it calls is in line (docs/adr/0021). */
__attribute__((flatten)) static bool kernel_contact(const clod_kernel_view *view,
                                                    const clod_law *law,
                                                    clod_contact_block *blocks, size_t contacts,
                                                    size_t end, double (*apart)[8])
{
    const clod_law l = *law;
    if (kernel_law_is(law, CLOD_LAW_MEPA, CLOD_ROLLING_EPSD2)) {
        return kernel_contact_loop(view, kernel_law_known(l, CLOD_LAW_MEPA, CLOD_ROLLING_EPSD2),
                                   blocks, contacts, end, apart);
    }
    if (kernel_law_is(law, CLOD_LAW_HERTZ, CLOD_ROLLING_EPSD2)) {
        return kernel_contact_loop(view,
                                   kernel_law_known(l, CLOD_LAW_HERTZ, CLOD_ROLLING_EPSD2),
                                   blocks, contacts, end, apart);
    }
    if (kernel_law_is(law, CLOD_LAW_HERTZ, CLOD_ROLLING_NONE)) {
        return kernel_contact_loop(view, kernel_law_known(l, CLOD_LAW_HERTZ, CLOD_ROLLING_NONE),
                                   blocks, contacts, end, apart);
    }
    return kernel_contact_loop(view, l, blocks, contacts, end, apart);
}
