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

/** The grain's share, and the wall's: -F and its moment about the point where the wall turns.
 */
static inline void kernel_wall_store(const clod_kernel_view *view,
                                     const kernel_wall_meeting *meeting, clod_law_result r,
                                     clod_wall_block *block, int lane, int lanes)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 turn = vreal3_axpy(r.roll, -meeting->motion.arm_i, r.lever);
    const vreal on_i[8] = {r.force.x, r.force.y, r.force.z, zero, turn.x, turn.y, turn.z, zero};
    vreal_add_rows(view->load, &block->i[lane], on_i, lanes);

    const vreal3 moment = vreal3_add(vreal3_cross(meeting->lever, r.force), r.roll);
    const vreal3 kept = vreal3_select(r.closed, moment, (vreal3){zero, zero, zero});
    const vreal on_wall[8] = {-r.force.x, -r.force.y, -r.force.z, zero,
                              -kept.x,    -kept.y,    -kept.z,    zero};
    vreal_store_rows(view->wall_slots, &block->slot_wall[lane], on_wall);
}

static bool kernel_wall(const clod_kernel_view *view, const clod_law *law,
                        clod_wall_block *blocks, size_t contacts)
{
    const clod_kernel_view v = *view;
    const clod_law l = *law;
    vreal excess = vreal_set(-1.0);
    for (size_t first = 0; first < contacts; first += CLOD_WIDTH) {
        clod_wall_block *block = &blocks[first / CLOD_LANES];
        const int lane = (int)(first % CLOD_LANES);
        const size_t left = contacts - first;
        const kernel_wall_meeting meeting = kernel_wall_meet(&v, block, lane);
        clod_law_memory memory = clod_law_memory_load(&block->history, lane);
        const clod_law_result result = clod_law_contact(&l, &meeting.motion, v.dt, &memory);
        clod_law_memory_store(&block->history, lane, result.closed, memory);
        kernel_wall_store(&v, &meeting, result, block, lane,
                          left < CLOD_WIDTH ? (int)left : CLOD_WIDTH);
        const vreal beyond =
            meeting.motion.overlap - CLOD_KERNEL_OVERLAP_LIMIT * meeting.motion.r_star;
        excess = vreal_max(vreal_select(result.closed, beyond, excess), excess);
    }
    return vmask_any(vmask_less(vreal_set(0.0), excess));
}
