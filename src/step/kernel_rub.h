#pragma once
/**
 * @file kernel_rub.h
 * How grains rub and hit walls, stored by the contact loop of walls on its way. Only with the
 * sums of surfaces (output.surfaces).
 */

#include "law/law_contact.h"
#include "state/wear.h"
#include "step/kernel.h"

/** What is known before histories move on. */
typedef struct kernel_rub_side {
    vreal speed2; ///< squared velocity of the centre against the material [m2/s2]
    vreal known;  ///< dk of the step before; 0: the contact begins
} kernel_rub_side;

/**
 * Finnie's function of the angle between velocity and surface: sin 2g - 3 sin2 g where tan g <
 * 1/3, else cos2 g/3.
 *
 * @param normal, along  speeds into and along the surface [m/s], >= 0, not both 0
 * Source  Finnie 1960, doi:10.1016/0043-1648(60)90055-7.   Test  tests/step/test_wear.c
 */
static inline vreal kernel_rub_finnie(vreal normal, vreal along)
{
    const vreal square = normal * normal + along * along;
    const vreal flat = (2.0 * normal * along - 3.0 * normal * normal) / square;
    const vreal steep = along * along / (3.0 * square);
    return vreal_select(vmask_less(3.0 * normal, along), flat, steep);
}

_Static_assert(CLOD_WEAR_STEP_SUMS == 8, "a row of addends has room for eight");

/** What contacts did to their places in a step: addends of the first sums of wear. */
static inline void kernel_rub_did(vreal did[8], double dt, const clod_law_touch *touch,
                                  vreal3 force)
{
    const vreal zero = vreal_set(0.0), step = vreal_set(dt);
    const vreal press = vreal3_dot(force, touch->normal);
    const vreal3 friction = vreal3_axpy(force, -press, touch->normal);
    const vreal power = vreal3_dot(friction, touch->slip);
    const vreal pushed = step * vreal_max(press, zero);
    const vreal slip = vreal_sqrt(vreal3_dot(touch->slip, touch->slip));
    const vreal approach = zero - touch->normal_velocity;
    const vmask comes = vmask_less(zero, approach);
    const vreal cutting = 2.0 * step * vreal_sqrt(vreal3_dot(force, force)) *
                          vreal_sqrt(approach * approach + slip * slip) *
                          kernel_rub_finnie(approach, slip);
    did[CLOD_WEAR_IMPULSE] = step * -force.x;
    did[CLOD_WEAR_IMPULSE + 1] = step * -force.y;
    did[CLOD_WEAR_IMPULSE + 2] = step * -force.z;
    did[CLOD_WEAR_PRESS] = step * press;
    did[CLOD_WEAR_SHEAR] = step * vreal_abs(power);
    did[CLOD_WEAR_SQUEEZE] = vreal_select(comes, pushed * approach, zero);
    did[CLOD_WEAR_SLIDING] = pushed * slip;
    did[CLOD_WEAR_CUTTING] = vreal_select(comes, cutting, zero);
}

/** Store how a vector of contacts rubs and hits. */
static inline void kernel_rub_store(clod_rub_block *rub, int lane, double dt,
                                    const clod_law_touch *touch, const kernel_rub_side *side,
                                    const clod_law_result *result)
{
    static const int32_t FOLLOWING[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const vreal zero = vreal_set(0.0);
    vreal did[8];
    kernel_rub_did(did, dt, touch, result->force);
    vreal_store_rows(&rub->did[lane], FOLLOWING, did);
    vreal3_store(rub->normal, lane, touch->normal);
    vreal_store(&rub->approach[lane], zero - touch->normal_velocity);
    vreal_store(&rub->speed2[lane], side->speed2);
    vreal_store(&rub->mass[lane], touch->m_star);
    const vreal closed =
        vreal_select(vmask_less(zero, side->known), vreal_set(1.0), vreal_set(2.0));
    vreal_store(&rub->closed[lane], vreal_select(result->closed, closed, zero));
}
