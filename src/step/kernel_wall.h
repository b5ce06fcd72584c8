#pragma once
/**
 * @file kernel_wall.h
 * Grain-wall contacts: the wall is a partner without mass or arm. Included by kernel.c only.
 */

#include "geometry/wall_closest.h"
#include "state/walls.h"
#include "step/kernel_contact.h"
#include "step/kernel_rub.h"

/** How grains meet shapes of walls. */
typedef struct kernel_wall_meeting {
    clod_law_motion motion;
    vreal3 velocity;  ///< m/s, of the wall's material at the contact
    vreal3 lever;     ///< m, from the point about which the wall turns to the contact
    vreal3 belt;      ///< m/s, the part of the velocity that is the belt's
    vreal3 belt_spin; ///< rad/s
} kernel_wall_meeting;

/** A vector without what of it is along the normal. */
static inline vreal3 kernel_wall_flat(vreal3 v, vreal3 normal)
{
    return vreal3_axpy(v, -vreal3_dot(v, normal), normal);
}

/** Velocity and spin of belts (geometry/wall_rows.h); nothing where no lane has one. */
static inline void kernel_wall_belt(const clod_kernel_view *view, const int32_t *shape,
                                    vreal any, vreal3 normal, kernel_wall_meeting *meeting)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 none = {zero, zero, zero};
    meeting->belt = meeting->belt_spin = none;
    const vmask moves = vmask_less(zero, any);
    if (!vmask_any(moves)) {
        return;
    }
    vreal b[4], w[4], d[4];
    vreal_load_rows(b, view->shape + CLOD_SHAPE_BELT, shape);
    vreal_load_rows(w, view->shape + CLOD_SHAPE_BELT_SPIN, shape);
    vreal_load_rows(d, view->shape + CLOD_SHAPE_DIRECTION, shape);
    const vreal3 spin = {w[0], w[1], w[2]};
    const vreal3 turns =
        vreal3_add((vreal3){b[0], b[1], b[2]}, vreal3_cross(spin, meeting->lever));
    const vreal3 along = kernel_wall_flat((vreal3){d[0], d[1], d[2]}, normal);
    const vreal least = vreal_set(CLOD_BELT_ACROSS);
    const vreal square = vreal3_dot(along, along);
    const vreal speed = vreal_select(vmask_less(least, square),
                                     b[3] / vreal_sqrt(vreal_max(square, least)), zero);
    const vreal3 belt = vreal3_axpy(turns, speed, along);
    meeting->belt = vreal3_select(moves, kernel_wall_flat(belt, normal), none);
    meeting->belt_spin = vreal3_select(moves, spin, none);
}

/** Closest points of CLOD_WIDTH contacts: computed, or of a mesh as they were found. */
static inline clod_wall_closest kernel_wall_closest(const clod_kernel_view *view,
                                                    clod_wall_form form,
                                                    const clod_wall_block *block, int lane,
                                                    vreal3 centre)
{
    vreal s[4][4];
    if (form == CLOD_FORM_MESH) {
        vreal_load_rows(s[0], view->touch, &block->touch[lane]);
        return (clod_wall_closest){s[0][3], {s[0][0], s[0][1], s[0][2]}};
    }
    for (int k = 0; k < 4; k++) {
        vreal_load_rows(s[k], view->shape + k, &block->shape[lane]);
    }
    return clod_wall_closest_point(form, s, centre);
}

/** Geometry and kinematics of CLOD_WIDTH contacts from the rows of grains and shapes. */
static inline kernel_wall_meeting kernel_wall_meet(const clod_kernel_view *view,
                                                   clod_wall_form form,
                                                   const clod_wall_block *block, int lane)
{
    vreal p[4], v[4], w[4], moves[4], turns[4], origin[4];
    vreal_load_rows(p, view->position, &block->i[lane]);
    vreal_load_rows(v, view->velocity, &block->i[lane]);
    vreal_load_rows(w, view->angular_velocity, &block->i[lane]);
    vreal_load_rows(moves, view->shape + CLOD_SHAPE_VELOCITY, &block->shape[lane]);
    vreal_load_rows(turns, view->shape + CLOD_SHAPE_SPIN, &block->shape[lane]);
    vreal_load_rows(origin, view->shape + CLOD_SHAPE_ORIGIN, &block->shape[lane]);
    const vreal3 centre = {p[0], p[1], p[2]};
    const clod_wall_closest closest = kernel_wall_closest(view, form, block, lane, centre);
    const vreal3 spin = {turns[0], turns[1], turns[2]};
    const vreal3 to_centre = vreal3_sub(centre, (vreal3){origin[0], origin[1], origin[2]});
    kernel_wall_meeting meeting = {
        .lever = vreal3_axpy(to_centre, -closest.distance, closest.normal)};
    kernel_wall_belt(view, &block->shape[lane], moves[3], closest.normal, &meeting);
    const vreal3 wall =
        vreal3_add((vreal3){moves[0], moves[1], moves[2]}, vreal3_cross(spin, meeting.lever));
    meeting.velocity = vreal3_add(wall, meeting.belt);
    meeting.motion =
        (clod_law_motion){.overlap = p[3] - closest.distance,
                          .normal = closest.normal,
                          .velocity = vreal3_sub((vreal3){v[0], v[1], v[2]}, meeting.velocity),
                          .spin_i = {w[0], w[1], w[2]},
                          .spin_j = vreal3_add(spin, meeting.belt_spin),
                          .arm_i = closest.distance,
                          .arm_j = vreal_set(0.0),
                          .m_star = v[3],
                          .r_star = p[3],
                          .roll_inertia = kernel_contact_inertia(v[3], p[3], w[3])};
    return meeting;
}

#define KERNEL_WALLS                                                                           \
    ((kernel_layout){sizeof(clod_wall_block), offsetof(clod_wall_block, history)})

/** What the wall's shares need of the geometry. */
typedef struct kernel_wall_side {
    vreal3 lever, belt, belt_spin; ///< as in kernel_wall_meeting
    kernel_rub_side rub;           ///< only where it is asked for
} kernel_wall_side;

/** First pass: geometry and kinematics. */
CLOD_LAW_PASS void kernel_wall_move(const clod_kernel_view *view, const clod_law *law,
                                    clod_wall_form form, bool rubs, kernel_batch *batch,
                                    kernel_wall_side *side)
{
    for (int k = 0; k < batch->vectors; k++) {
        const clod_wall_block *block = kernel_block(batch, KERNEL_WALLS, k);
        const kernel_wall_meeting meeting = kernel_wall_meet(view, form, block, kernel_lane(k));
        batch->meeting[k].arm_i = meeting.motion.arm_i;
        clod_law_touch_of(law, &meeting.motion, &batch->meeting[k].touch);
        side[k].lever = meeting.lever;
        side[k].belt = meeting.belt;
        side[k].belt_spin = meeting.belt_spin;
        if (rubs) {
            const vreal3 velocity = meeting.motion.velocity;
            side[k].rub =
                (kernel_rub_side){vreal3_dot(velocity, velocity),
                                  vreal_load(&block->history.tangent[kernel_lane(k)])};
        }
    }
}

/** The grain's share, and the wall's (CLOD_WALL_SUM_FORCE and so on). */
static inline void kernel_wall_store(const clod_kernel_view *view, vreal arm,
                                     const kernel_wall_side *side, clod_law_result r,
                                     const clod_wall_block *block, int lane, int lanes)
{
    static const int32_t FOLLOWING[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const vreal zero = vreal_set(0.0);
    const vreal3 turn = vreal3_axpy(r.roll, -arm, r.lever);
    const vreal on_i[8] = {r.force.x, r.force.y, r.force.z, zero, turn.x, turn.y, turn.z, zero};
    vreal_add_rows(view->load, &block->i[lane], on_i, lanes);

    const vreal3 moment = vreal3_add(vreal3_cross(side->lever, r.force), r.roll);
    const vreal3 kept = vreal3_select(r.closed, moment, (vreal3){zero, zero, zero});
    const vreal power = vreal3_dot(side->belt, r.force) + vreal3_dot(side->belt_spin, r.roll);
    const vreal on_wall[8] = {
        -r.force.x, -r.force.y, -r.force.z, vreal_select(r.closed, power, zero),
        -kept.x,    -kept.y,    -kept.z,    zero};
    _Alignas(64) double wall_sum[CLOD_WIDTH][CLOD_FIXED_COLUMNS];
    vreal_store_rows(wall_sum, FOLLOWING, on_wall);
    for (int l = 0; l < lanes; l++) {
        clod_fixed_add(&view->wall_sum[block->sum[lane + l]], wall_sum[l]);
    }
}

/** Last pass: limits and shares; the largest excess of an overlap so far. */
CLOD_LAW_PASS vreal kernel_wall_limit(const clod_kernel_view *view, const clod_law *law,
                                      kernel_batch *batch, const kernel_wall_side *side,
                                      clod_rub_block *rub, vreal excess)
{
    clod_law_cuts cuts = clod_law_limit_begin(law, &batch->trial[0]);
    for (int k = 0; k < batch->vectors; k++) {
        const clod_law_result result = kernel_batch_limit(law, batch, k, &cuts);
        const clod_law_touch *touch = &batch->meeting[k].touch;
        kernel_wall_store(view, batch->meeting[k].arm_i, &side[k], result,
                          kernel_block(batch, KERNEL_WALLS, k), kernel_lane(k),
                          kernel_lanes(batch, k));
        if (rub != NULL) {
            kernel_rub_store(&rub[k * CLOD_WIDTH / CLOD_LANES], kernel_lane(k), view->dt, touch,
                             &side[k].rub, &result);
        }
        const vreal beyond = touch->overlap - view->overlap_limit * touch->r_star;
        excess = vreal_max(vreal_select(result.closed, beyond, excess), excess);
    }
    return excess;
}

/** All contacts, batch by batch through the passes. */
CLOD_LAW_PASS bool kernel_wall_loop(const clod_kernel_view *view, const clod_law law,
                                    clod_wall_form form, clod_wall_block *blocks,
                                    clod_rub_block *rub, size_t contacts)
{
    const clod_kernel_view v = *view;
    vreal excess = vreal_set(-1.0);
    kernel_batch batch;
    kernel_wall_side side[KERNEL_BATCH * CLOD_LANES / CLOD_WIDTH];
    for (size_t first = 0; first < contacts; first += (size_t)KERNEL_BATCH * CLOD_LANES) {
        kernel_batch_begin(&batch, KERNEL_WALLS, blocks, first, contacts);
        kernel_wall_move(&v, &law, form, rub != NULL, &batch, side);
        kernel_batch_press(&law, v.dt, KERNEL_WALLS, &batch);
        kernel_batch_carry(&law, v.dt, KERNEL_WALLS, &batch);
        excess = kernel_wall_limit(&v, &law, &batch, side,
                                   rub != NULL ? &rub[first / CLOD_LANES] : NULL, excess);
    }
    return vmask_any(vmask_less(vreal_set(0.0), excess));
}

/** As for grains: once more for the law that most walls of testers have. */
CLOD_LAW_PASS bool kernel_wall_of(const clod_kernel_view *view, const clod_law *law,
                                  clod_wall_form form, clod_wall_block *blocks,
                                  clod_rub_block *rub, size_t contacts)
{
    if (kernel_law_is(law, CLOD_LAW_MEPA, CLOD_ROLLING_EPSD2)) {
        return kernel_wall_loop(view, kernel_law_known(*law, CLOD_LAW_MEPA, CLOD_ROLLING_EPSD2),
                                form, blocks, rub, contacts);
    }
    return kernel_wall_loop(view, *law, form, blocks, rub, contacts);
}

/** A loop for each form, so that none computes the closest points of the others. */
__attribute__((flatten)) static bool kernel_wall(const clod_kernel_view *view,
                                                 const clod_law *law, clod_wall_form form,
                                                 clod_wall_block *blocks, clod_rub_block *rub,
                                                 size_t contacts)
{
    switch (form) {
    case CLOD_FORM_PLANE:
        return kernel_wall_of(view, law, CLOD_FORM_PLANE, blocks, rub, contacts);
    case CLOD_FORM_BOX:
        return kernel_wall_of(view, law, CLOD_FORM_BOX, blocks, rub, contacts);
    case CLOD_FORM_MESH:
        return kernel_wall_of(view, law, CLOD_FORM_MESH, blocks, rub, contacts);
    default:
        return kernel_wall_of(view, law, CLOD_FORM_SHELL, blocks, rub, contacts);
    }
}
