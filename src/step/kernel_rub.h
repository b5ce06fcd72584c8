#pragma once
/**
 * @file kernel_rub.h
 * How grains rub and hit walls: the contact loop of walls once more, before histories move on.
 * Only with the sums of surfaces (output.surfaces). Included by kernel.c only.
 */

#include "step/kernel_wall.h"

static inline void kernel_store_rub(clod_rub_block *rub, int lane,
                                    const clod_law_motion *motion,
                                    const clod_law_result *result, vmask begins)
{
    const vreal zero = vreal_set(0.0);
    const vreal press = vreal3_dot(result->force, motion->normal);
    const vreal3 slip = clod_law_slip_of(motion);
    const vreal3 friction = vreal3_axpy(result->force, -press, motion->normal);
    const vreal power = vreal3_dot(friction, slip);
    const vreal approach = zero - vreal3_dot(motion->velocity, motion->normal);
    vreal3_store(rub->force, lane, vreal3_scale(result->force, vreal_set(-1.0)));
    vreal_store(&rub->press[lane], press);
    vreal_store(&rub->friction[lane], vreal_max(power, zero - power));
    vreal_store(&rub->slip[lane], vreal_sqrt(vreal3_dot(slip, slip)));
    vreal_store(&rub->approach[lane], approach);
    vreal_store(&rub->speed2[lane], vreal3_dot(motion->velocity, motion->velocity));
    vreal_store(&rub->mass[lane], motion->m_star);
    const vreal closed = vreal_select(begins, vreal_set(2.0), vreal_set(1.0));
    vreal_store(&rub->closed[lane], vreal_select(result->closed, closed, zero));
}

/** A block; a contact begins that has no stiffness in its history yet. */
static void kernel_wall_rub(const clod_kernel_view *view, const clod_law *law,
                            clod_wall_form form, clod_wall_block *block, clod_rub_block *rub)
{
    for (int lane = 0; lane < CLOD_LANES; lane += CLOD_WIDTH) {
        const clod_law_motion now = kernel_wall_meet(view, form, block, lane).motion;
        clod_law_memory memory = clod_law_memory_load(&block->history, lane);
        const vmask known = vmask_less(vreal_set(0.0), memory.tangent);
        const clod_law_result result = clod_law_contact(law, &now, view->dt, &memory);
        const vreal new = vreal_select(known, vreal_set(0.0), vreal_set(1.0));
        kernel_store_rub(rub, lane, &now, &result, vmask_less(vreal_set(0.5), new));
    }
}
