#include "hopper/fields.h"

#define DEGREES 57.295779513082323

const clod_hopper_field CLOD_HOPPER_FIELDS[CLOD_HOPPER_NUMBERS] = {
    [CLOD_HOPPER_LIMIT] = {"limit_deg", "limit of mass flow in a cone", "deg", DEGREES, DEGREES,
                           1, "none"},
    [CLOD_HOPPER_HALF_ANGLE] = {"half_angle_deg", "half angle", "deg", DEGREES, DEGREES, 1,
                                "none"},
    [CLOD_HOPPER_OUTLET] = {"outlet_m", "critical outlet", "mm", 1e3, 1.0, 1, NULL},
    [CLOD_HOPPER_FLOW_FACTOR] = {"flow_factor", "flow factor ff", "", 1.0, 1.0, 3, NULL},
    [CLOD_HOPPER_SIGMA_1] = {"sigma_1_Pa", "critical sigma_1", "kPa", 1e-3, 1.0, 3, NULL},
    [CLOD_HOPPER_STRENGTH] = {"strength_Pa", "critical strength f_c", "kPa", 1e-3, 1.0, 3,
                              NULL},
    [CLOD_HOPPER_PHI_E] = {"phi_e_deg", "phi_e there", "deg", DEGREES, DEGREES, 1, NULL},
    [CLOD_HOPPER_PHI_W] = {"phi_w_deg", "wall friction angle there", "deg", DEGREES, DEGREES, 1,
                           NULL},
    [CLOD_HOPPER_RHO] = {"rho_b_kg_m3", "bulk density there", "kg/m3", 1.0, 1.0, 0, NULL},
    [CLOD_HOPPER_ARCH] = {"arch_thickness", "H(theta)", "", 1.0, 1.0, 3, NULL},
    [CLOD_HOPPER_MARGIN] = {"arching_margin", "stress over strength", "", 1.0, 1.0, 2, NULL},
    [CLOD_HOPPER_DESIGN_PHI_W] = {"design_phi_w_deg", "wall friction angle of the limit", "deg",
                                  DEGREES, DEGREES, 1, NULL},
};

const clod_hopper_field CLOD_HOPPER_FIELD_SLOT = {
    "slot_width_m", "width of a slot in funnel flow", "mm", 1e3, 1.0, 1, NULL};

const clod_hopper_field *clod_hopper_field_of(const clod_hopper_found *found,
                                              clod_hopper_number number)
{
    static const clod_hopper_field GIVEN = {
        "limit_deg", "limit of mass flow, given", "deg", DEGREES, DEGREES, 1, "none"};
    static const clod_hopper_field FUNNEL = {
        "outlet_m", "critical outlet of mass flow", "mm", 1e3, 1.0, 1, "none"};
    if (number == CLOD_HOPPER_OUTLET && found->design.outcome == CLOD_HOPPER_FUNNEL) {
        return &FUNNEL;
    }
    return number == CLOD_HOPPER_LIMIT && found->wish.limit > 0.0 ? &GIVEN
                                                                  : &CLOD_HOPPER_FIELDS[number];
}

const char *const CLOD_HOPPER_SHAPE_NAMES[CLOD_HOPPER_SHAPES] = {
    [CLOD_RADIAL_WEDGE] = "wedge", [CLOD_RADIAL_CONE] = "cone"};

const char *const CLOD_HOPPER_OUTCOME_NAMES[CLOD_HOPPER_OUTCOMES] = {
    [CLOD_HOPPER_FLOWS] = "flows",         [CLOD_HOPPER_NO_ARCH] = "no_arch",
    [CLOD_HOPPER_ARCHES] = "arches",       [CLOD_HOPPER_FUNNEL] = "funnel_flow",
    [CLOD_HOPPER_UNSETTLED] = "unsettled", [CLOD_HOPPER_UNPROVEN] = "mass_flow_unknown"};

const char *const CLOD_HOPPER_CURVE_KEYS[CLOD_SOLID_CURVES] = {[CLOD_SOLID_STRENGTH] =
                                                                   "flow_function",
                                                               [CLOD_SOLID_PHI_E] = "phi_e",
                                                               [CLOD_SOLID_PHI_T] = "phi_t",
                                                               [CLOD_SOLID_RHO] = "rho_b",
                                                               [CLOD_SOLID_WALL] = "wall"};

const char *const CLOD_HOPPER_ARCH_NAMES[] = {
    [CLOD_HOPPER_ARCH_ARNOLD] = "arnold", [CLOD_HOPPER_ARCH_RHODES] = "rhodes"};
