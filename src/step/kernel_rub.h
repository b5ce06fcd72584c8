#pragma once
/**
 * @file kernel_rub.h
 * How grains rub and hit walls, stored by the contact loop of walls on its way. Only with the
 * sums of surfaces (output.surfaces). Included by kernel.c only.
 */

#include "law/law_contact.h"
#include "step/kernel.h"

/** What is known before histories move on. */
typedef struct kernel_rub_side {
    vreal speed2; ///< squared velocity of the centre against the material [m2/s2]
    vreal known;  ///< dk of the step before; 0: the contact begins
} kernel_rub_side;

/** What a vector of contacts did to the wall. */
static inline void kernel_rub_store(clod_rub_block *rub, int lane, const clod_law_touch *touch,
                                    const kernel_rub_side *side, const clod_law_result *result)
{
    const vreal zero = vreal_set(0.0);
    const vreal press = vreal3_dot(result->force, touch->normal);
    const vreal3 friction = vreal3_axpy(result->force, -press, touch->normal);
    const vreal power = vreal3_dot(friction, touch->slip);
    vreal3_store(rub->force, lane, vreal3_scale(result->force, vreal_set(-1.0)));
    vreal3_store(rub->normal, lane, touch->normal);
    vreal_store(&rub->press[lane], press);
    vreal_store(&rub->friction[lane], vreal_max(power, zero - power));
    vreal_store(&rub->slip[lane], vreal_sqrt(vreal3_dot(touch->slip, touch->slip)));
    vreal_store(&rub->approach[lane], zero - touch->normal_velocity);
    vreal_store(&rub->speed2[lane], side->speed2);
    vreal_store(&rub->mass[lane], touch->m_star);
    const vreal closed =
        vreal_select(vmask_less(zero, side->known), vreal_set(1.0), vreal_set(2.0));
    vreal_store(&rub->closed[lane], vreal_select(result->closed, closed, zero));
}
