#pragma once
/**
 * @file materials.h
 * Materials and contact laws as a checked case would hold them.
 */

#include "clod/case.h"

/** Copper ore (docs/theory/copper-ore.md). */
static const clod_case_material ORE = {
    .density = 2481.3, .youngs_modulus = 119e9, .poissons_ratio = 0.34};

/** Copper ore, 5 % moisture (docs/theory/copper-ore.md, Table 1), without dash-pot. */
static inline clod_case_contact contact_ore(void)
{
    return (clod_case_contact){.law = CLOD_LAW_MEPA,
                               .exponent = 1.5,
                               .k1 = 4.75e8,
                               .k2 = 2.37e9,
                               .k_adh = 3.56e8,
                               .restitution = 1.0,
                               .friction = 0.35,
                               .coulomb = CLOD_COULOMB_ADHESIVE,
                               .tangential = CLOD_TANGENTIAL_TANGENT,
                               .tangential_ratio = 1.0,
                               .rolling = CLOD_ROLLING_EPSD2,
                               .rolling_friction = 0.3,
                               .rolling_damping = 0.0};
}

/** An elastic law without friction: hooke for n = 1, else mepa with k1 = k2. */
static inline clod_case_contact contact_elastic(double exponent, double k)
{
    return (clod_case_contact){.law = exponent == 1.0 ? CLOD_LAW_HOOKE : CLOD_LAW_MEPA,
                               .exponent = exponent,
                               .k1 = k,
                               .k2 = k,
                               .restitution = 1.0,
                               .tangential_ratio = 1.0,
                               .rolling = CLOD_ROLLING_NONE};
}
