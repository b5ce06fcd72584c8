#pragma once
/**
 * @file kernel_wall.h
 * Grain-wall contacts: the wall is a partner without mass or arm. Included by kernel.c only.
 */

#include "geometry/wall_closest.h"
#include "step/kernel_contact.h"

/** How grains meet shapes of walls. */
typedef struct kernel_wall_meeting {
    clod_law_motion motion;
    vreal3 velocity; ///< m/s, of the wall's material at the contact
    vreal3 lever;    ///< m, from the point about which the wall turns to the contact
} kernel_wall_meeting;

/** Geometry and kinematics of CLOD_WIDTH contacts from the rows of grains, shapes and walls. */
static inline kernel_wall_meeting kernel_wall_meet(const clod_kernel_view *view,
                                                   const clod_wall_block *block, int lane)
{
    vreal p[4], v[4], w[4], s[4][4], wall[3][4];
    vreal_load_rows(p, view->place, &block->i[lane]);
    vreal_load_rows(v, view->motion, &block->i[lane]);
    vreal_load_rows(w, view->turning, &block->i[lane]);
    for (int k = 0; k < 4; k++) {
        vreal_load_rows(s[k], view->shape + k, &block->shape[lane]);
    }
    for (int k = 0; k < 3; k++) {
        vreal_load_rows(wall[k], view->wall + k, &block->wall[lane]);
    }
    const vreal3 centre = {p[0], p[1], p[2]};
    const clod_wall_closest closest = clod_wall_closest_point(s, centre);
    const vreal3 spin = {wall[1][0], wall[1][1], wall[1][2]};
    const vreal3 to_centre = vreal3_sub(centre, (vreal3){wall[2][0], wall[2][1], wall[2][2]});
    const vreal3 lever = vreal3_axpy(to_centre, -closest.distance, closest.normal);
    const vreal3 velocity =
        vreal3_add((vreal3){wall[0][0], wall[0][1], wall[0][2]}, vreal3_cross(spin, lever));
    return (kernel_wall_meeting){
        .motion = {.overlap = p[3] - closest.distance,
                   .normal = closest.normal,
                   .velocity = vreal3_sub((vreal3){v[0], v[1], v[2]}, velocity),
                   .spin_i = {w[0], w[1], w[2]},
                   .spin_j = spin,
                   .arm_i = closest.distance,
                   .arm_j = vreal_set(0.0),
                   .m_star = v[3],
                   .r_star = p[3],
                   .roll_inertia = kernel_contact_inertia(v[3], p[3], w[3])},
        .velocity = velocity,
        .lever = lever,
    };
}

#define KERNEL_WALLS                                                                           \
    ((kernel_layout){sizeof(clod_wall_block), offsetof(clod_wall_block, history)})

/** First pass: geometry and kinematics; the levers of the wall's moments. */
CLOD_LAW_PASS void kernel_wall_move(const clod_kernel_view *view, const clod_law *law,
                                    kernel_batch *batch, vreal3 *lever)
{
    for (int k = 0; k < batch->vectors; k++) {
        const clod_wall_block *block = kernel_block(batch, KERNEL_WALLS, k);
        const kernel_wall_meeting meeting = kernel_wall_meet(view, block, kernel_lane(k));
        batch->meeting[k].arm_i = meeting.motion.arm_i;
        clod_law_touch_of(law, &meeting.motion, &batch->meeting[k].touch);
        lever[k] = meeting.lever;
    }
}

/** The grain's share, and the wall's: -F and its moment about the point where the wall turns.
 */
static inline void kernel_wall_store(const clod_kernel_view *view, vreal arm, vreal3 lever,
                                     clod_law_result r, const clod_wall_block *block, int lane,
                                     int lanes)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 turn = vreal3_axpy(r.roll, -arm, r.lever);
    const vreal on_i[8] = {r.force.x, r.force.y, r.force.z, zero, turn.x, turn.y, turn.z, zero};
    vreal_add_rows(view->load, &block->i[lane], on_i, lanes);

    const vreal3 moment = vreal3_add(vreal3_cross(lever, r.force), r.roll);
    const vreal3 kept = vreal3_select(r.closed, moment, (vreal3){zero, zero, zero});
    const vreal on_wall[8] = {-r.force.x, -r.force.y, -r.force.z, zero,
                              -kept.x,    -kept.y,    -kept.z,    zero};
    vreal_store_rows(view->wall_slots, &block->slot_wall[lane], on_wall);
}

/** Last pass: limits and shares; the largest excess of an overlap so far. */
CLOD_LAW_PASS vreal kernel_wall_limit(const clod_kernel_view *view, const clod_law *law,
                                      kernel_batch *batch, const vreal3 *lever, vreal excess)
{
    clod_law_cuts cuts = clod_law_limit_begin(law, &batch->trial[0]);
    for (int k = 0; k < batch->vectors; k++) {
        const clod_law_result result = kernel_batch_limit(law, batch, k, &cuts);
        const clod_law_touch *touch = &batch->meeting[k].touch;
        kernel_wall_store(view, batch->meeting[k].arm_i, lever[k], result,
                          kernel_block(batch, KERNEL_WALLS, k), kernel_lane(k),
                          kernel_lanes(batch, k));
        const vreal beyond = touch->overlap - view->overlap_limit * touch->r_star;
        excess = vreal_max(vreal_select(result.closed, beyond, excess), excess);
    }
    return excess;
}

/** All contacts, batch by batch through the passes. */
CLOD_LAW_PASS bool kernel_wall_loop(const clod_kernel_view *view, const clod_law law,
                                    clod_wall_block *blocks, size_t contacts)
{
    const clod_kernel_view v = *view;
    vreal excess = vreal_set(-1.0);
    kernel_batch batch;
    vreal3 lever[KERNEL_BATCH * CLOD_LANES / CLOD_WIDTH];
    for (size_t first = 0; first < contacts; first += (size_t)KERNEL_BATCH * CLOD_LANES) {
        kernel_batch_begin(&batch, KERNEL_WALLS, blocks, first, contacts);
        kernel_wall_move(&v, &law, &batch, lever);
        kernel_batch_press(&law, v.dt, KERNEL_WALLS, &batch);
        kernel_batch_carry(&law, v.dt, KERNEL_WALLS, &batch);
        excess = kernel_wall_limit(&v, &law, &batch, lever, excess);
    }
    return vmask_any(vmask_less(vreal_set(0.0), excess));
}

/** As for grains: once more for the law that most walls of testers have. */
__attribute__((flatten)) static bool kernel_wall(const clod_kernel_view *view,
                                                 const clod_law *law, clod_wall_block *blocks,
                                                 size_t contacts)
{
    if (kernel_law_is(law, CLOD_LAW_MEPA, CLOD_ROLLING_EPSD2)) {
        return kernel_wall_loop(view, kernel_law_known(*law, CLOD_LAW_MEPA, CLOD_ROLLING_EPSD2),
                                blocks, contacts);
    }
    return kernel_wall_loop(view, *law, blocks, contacts);
}
