#pragma once
/**
 * @file kernel_wall.h
 * Grain-wall contacts: the wall is a partner without mass or arm. Included by kernel.c only.
 */

#include "step/kernel_contact.h"

static inline clod_law_motion kernel_wall_motion(const clod_kernel_view *view,
                                                 const clod_kernel_wall_stage *stage,
                                                 const int32_t *i, int lane)
{
    vreal p[4], v[4], w[4];
    vreal_load_rows(p, view->place, i);
    vreal_load_rows(v, view->motion, i);
    vreal_load_rows(w, view->turning, i);
    const vreal distance = vreal_load(&stage->distance[lane]);
    return (clod_law_motion){
        .overlap = p[3] - distance,
        .normal = {vreal_load(&stage->normal[0][lane]), vreal_load(&stage->normal[1][lane]),
                   vreal_load(&stage->normal[2][lane])},
        .velocity = {v[0] - vreal_load(&stage->velocity[0][lane]),
                     v[1] - vreal_load(&stage->velocity[1][lane]),
                     v[2] - vreal_load(&stage->velocity[2][lane])},
        .spin_i = {w[0], w[1], w[2]},
        .spin_j = {vreal_load(&stage->spin[0][lane]), vreal_load(&stage->spin[1][lane]),
                   vreal_load(&stage->spin[2][lane])},
        .arm_i = distance,
        .arm_j = vreal_set(0.0),
        .m_star = v[3],
        .r_star = p[3],
        .roll_inertia = kernel_contact_inertia(v[3], p[3], w[3]),
    };
}

/** The grain's share, and the wall's: -F and its moment about the wall's reference point. */
static inline void kernel_wall_store(const clod_kernel_view *view,
                                     const clod_kernel_wall_stage *stage,
                                     const clod_law_motion *motion, clod_law_result r,
                                     clod_wall_block *block, int lane, int lanes)
{
    const vreal zero = vreal_set(0.0);
    const vreal3 turn = vreal3_axpy(r.roll, -motion->arm_i, r.lever);
    const vreal on_i[8] = {r.force.x, r.force.y, r.force.z, zero, turn.x, turn.y, turn.z, zero};
    vreal_add_rows(view->load, &block->i[lane], on_i, lanes);

    const vreal3 to_centre = {vreal_load(&stage->lever[0][lane]),
                              vreal_load(&stage->lever[1][lane]),
                              vreal_load(&stage->lever[2][lane])};
    const vreal3 to_contact = vreal3_axpy(to_centre, -motion->arm_i, motion->normal);
    const vreal3 moment = vreal3_add(vreal3_cross(to_contact, r.force), r.roll);
    const vreal3 kept = vreal3_select(r.closed, moment, (vreal3){zero, zero, zero});
    const vreal on_wall[8] = {-r.force.x, -r.force.y, -r.force.z, zero,
                              -kept.x,    -kept.y,    -kept.z,    zero};
    vreal_store_rows(view->wall_slots, &block->slot_wall[lane], on_wall);
}

static bool kernel_wall(const clod_kernel_view *view, const clod_law *law,
                        const clod_kernel_wall_stage *stage, clod_wall_block *block,
                        int contacts)
{
    vreal excess = vreal_set(-1.0);
    for (int lane = 0; lane < contacts; lane += CLOD_WIDTH) {
        const int left = contacts - lane;
        const clod_law_motion motion = kernel_wall_motion(view, stage, &block->i[lane], lane);
        clod_law_memory memory = clod_law_memory_load(&block->history, lane);
        const clod_law_result result = clod_law_contact(law, &motion, view->dt, &memory);
        clod_law_memory_store(&block->history, lane, result.closed, memory);
        kernel_wall_store(view, stage, &motion, result, block, lane,
                          left < CLOD_WIDTH ? left : CLOD_WIDTH);
        const vreal beyond = motion.overlap - CLOD_KERNEL_OVERLAP_LIMIT * motion.r_star;
        excess = vreal_max(vreal_select(result.closed, beyond, excess), excess);
    }
    return vmask_any(vmask_less(vreal_set(0.0), excess));
}
