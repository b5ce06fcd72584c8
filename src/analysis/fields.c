#include "analysis/fields.h"

#include <string.h>

#define FIELD(name, what, words)                                                               \
    {                                                                                          \
        .key = #name, .text = (words), .kind = (what), .offset = offsetof(clod_locus, name)    \
    }

const clod_field CLOD_FIELDS[CLOD_FIELD_COUNT] = {
    FIELD(sigma_p, CLOD_FIELD_STRESS, "preshear normal stress"),
    FIELD(tau_p, CLOD_FIELD_STRESS, "preshear shear stress"),
    FIELD(c, CLOD_FIELD_STRESS, "cohesion"),
    FIELD(phi_lin, CLOD_FIELD_ANGLE, "angle of the yield locus"),
    FIELD(phi_e, CLOD_FIELD_ANGLE, "effective angle of friction"),
    FIELD(phi_sf, CLOD_FIELD_ANGLE, "angle of friction at steady flow"),
    FIELD(sigma_1, CLOD_FIELD_STRESS, "major principal stress"),
    FIELD(sigma_2, CLOD_FIELD_STRESS, "minor principal stress"),
    FIELD(sigma_c, CLOD_FIELD_STRESS, "unconfined yield strength"),
    FIELD(ffc, CLOD_FIELD_NUMBER, "flowability sigma_1/sigma_c"),
    FIELD(rho_b, CLOD_FIELD_DENSITY, "bulk density"),
    FIELD(rho_inside, CLOD_FIELD_DENSITY, "bulk density away from walls"),
};

const clod_field_pair CLOD_FIELD_PAIRS[CLOD_LOCUS_PAIRS] = {
    {CLOD_FIELD_SIGMA_1, CLOD_FIELD_SIGMA_C}, {CLOD_FIELD_SIGMA_1, CLOD_FIELD_PHI_E},
    {CLOD_FIELD_SIGMA_1, CLOD_FIELD_PHI_LIN}, {CLOD_FIELD_SIGMA_C, CLOD_FIELD_PHI_E},
    {CLOD_FIELD_SIGMA_C, CLOD_FIELD_PHI_LIN}, {CLOD_FIELD_PHI_E, CLOD_FIELD_PHI_LIN},
};

clod_locus_value *clod_field_of(clod_locus *locus, clod_field_index index)
{
    return (clod_locus_value *)(void *)((char *)locus + CLOD_FIELDS[index].offset);
}

clod_locus_value clod_field_get(const clod_locus *locus, clod_field_index index)
{
    clod_locus_value value;
    memcpy(&value, (const char *)locus + CLOD_FIELDS[index].offset, sizeof value);
    return value;
}
