/**
 * @file params_material.c
 * Tables of materials and of the contact law of a pair of materials.
 */

#include "config/law_keys.h"
#include "config/param.h"
#include "law/law_springs.h"

#define M clod_case_material
#define C clod_case_contact

static const clod_param MATERIAL[] = {
    {.key = "density",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "kg/m3",
     CLOD_ABOVE(0, 1e7),
     .example = "2481.3 kg/m3",
     CLOD_AT(M, density),
     .help = "Density of the solid; needed for materials of grains.",
     .source = "docs/theory/copper-ore.md"},
    {.key = "youngs_modulus",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "Pa",
     CLOD_FROM(1e3, 1e14),
     .example = "119 GPa",
     CLOD_AT(M, youngs_modulus),
     .help = "Young's modulus; needed by the law hertz and for the Rayleigh time.",
     .source = "docs/theory/time-step.md, copper-ore.md"},
    {.key = "poissons_ratio",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_ABOVE(0, 0.5),
     .example = "0.34",
     CLOD_AT(M, poissons_ratio),
     .help = "Poisson's ratio; needed by the law hertz and for the Rayleigh time.",
     .source = "docs/theory/time-step.md, copper-ore.md"},
    {.key = "hardness",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "Pa",
     CLOD_FROM(1e3, 1e12),
     .example = "2 GPa",
     CLOD_AT(M, hardness),
     .help = "Indentation hardness of a wall's material, for its wear (output.surfaces).",
     .source = "docs/theory/wear.md"},
    {.key = "archard",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 1),
     .example = "1e-4",
     CLOD_AT(M, archard),
     .help =
         "Wear coefficient of sliding: worn volume = archard x pressing force x sliding distance/hardness.",
     .source = "docs/theory/wear.md"},
    {.key = "finnie",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 10),
     .example = "1e-4",
     CLOD_AT(M, finnie),
     .help = "Wear coefficient of cutting by impacts: worn volume = finnie x 2 force x speed x "
             "f(angle of impact) x time/hardness.",
     .source = "docs/theory/wear.md"},
};

const clod_table CLOD_TABLE_MATERIAL = {
    .title = "Materials of grains and walls, by name.", CLOD_ROWS(MATERIAL), .size = sizeof(M)};

static const char *const COULOMB[] = {[CLOD_COULOMB_ADHESIVE] = "adhesive",
                                      [CLOD_COULOMB_FORCE] = "force",
                                      [CLOD_COULOMB_PAPER] = "paper",
                                      NULL};

static const clod_law_keys *keys_of(const void *self)
{
    return clod_law_keys_of(((const C *)self)->law);
}

static bool k1_in(const clod_law_keys *law)
{
    return law->k1 != NULL;
}

static bool has_k1(const clod_case *whole, const void *self)
{
    (void)whole;
    return k1_in(keys_of(self)) && ((const C *)self)->k1 > 0.0;
}

static bool k2_in(const clod_law_keys *law)
{
    return law->k2 != NULL;
}

static bool has_k2(const clod_case *whole, const void *self)
{
    (void)whole;
    return k2_in(keys_of(self)) && ((const C *)self)->k2 > 0.0;
}

static bool k_adh_in(const clod_law_keys *law)
{
    return law->k_adh;
}

static bool has_k_adh(const clod_case *whole, const void *self)
{
    (void)whole;
    return k_adh_in(keys_of(self));
}

static bool depth_in(const clod_law_keys *law)
{
    return law->plasticity_depth != NULL;
}

static bool has_depth(const clod_case *whole, const void *self)
{
    (void)whole;
    return depth_in(keys_of(self)) && ((const C *)self)->plasticity_depth > 0.0;
}

static bool pull_in(const clod_law_keys *law)
{
    return law->pull_off_force;
}

static bool has_pull(const clod_case *whole, const void *self)
{
    (void)whole;
    return pull_in(keys_of(self));
}

static bool surface_energy_in(const clod_law_keys *law)
{
    return law->surface_energy;
}

static bool has_surface_energy(const clod_case *whole, const void *self)
{
    (void)whole;
    return surface_energy_in(keys_of(self));
}

static bool has_ratio(const clod_case *whole, const void *self)
{
    (void)whole;
    return !keys_of(self)->elastic_moduli &&
           !clod_law_springs_tangential_row_of(((const C *)self)->tangential)->takes_k1;
}

static bool has_rolling(const clod_case *whole, const void *self)
{
    (void)whole;
    return clod_law_springs_rolling_row_of(((const C *)self)->rolling)->resists;
}

static bool has_rolling_damping(const clod_case *whole, const void *self)
{
    (void)whole;
    return clod_law_springs_rolling_row_of(((const C *)self)->rolling)->dash_pot;
}

static const clod_param CONTACT[] = {
    {.key = "law",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = CLOD_LAW_NAMES,
     .fallback = "mepa",
     CLOD_AT(C, law),
     .help = "Law of the normal force.", // then what each is
     .source = "docs/theory/mepa.md"},
    {.key = "exponent",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(1, 4),
     .fallback = "1.5",
     CLOD_AT(C, exponent),
     .help =
         "Exponent n of the overlap in the force; linear laws are always 1, hertz always 1.5.",
     .source = "eq. (1)-(3)"},
    {.key = "k1",
     .kind = CLOD_PARAM_STIFFNESS,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "N/m^n",
     CLOD_ABOVE(0, 1e18),
     .example = "4.75e8 N/m^1.5",
     CLOD_AT(C, k1),
     .exponent = offsetof(C, exponent),
     .used = has_k1,
     .law_has = k1_in,
     .unused = ": the others take their stiffness from youngs_modulus of the materials",
     .help = "Stiffness of virgin loading.",
     .source = "eq. (1)"},
    {.key = "k2",
     .kind = CLOD_PARAM_STIFFNESS,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "N/m^n",
     CLOD_ABOVE(0, 1e18),
     .example = "2.37e9 N/m^1.5",
     CLOD_AT(C, k2),
     .exponent = offsetof(C, exponent),
     .used = has_k2,
     .law_has = k2_in,
     .unused = ": the others are elastic",
     .help = "Stiffness of unloading and reloading, k1 or more; with luding its largest value, "
             "more than k1.",
     .source = "eq. (2)"},
    {.key = "k_adh",
     .kind = CLOD_PARAM_STIFFNESS,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "N/m^n",
     CLOD_FROM(0, 1e18),
     .fallback = "0",
     .example = "3.56e8 N/m^1.5",
     CLOD_AT(C, k_adh),
     .exponent = offsetof(C, exponent),
     .used = has_k_adh,
     .law_has = k_adh_in,
     .unused = ": the others are elastic",
     .help = "Stiffness of the adhesive branch; 0 is dry.",
     .source = "eq. (3)"},
    {.key = "plasticity_depth",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_ABOVE(0, 1),
     .example = "0.05",
     CLOD_AT(C, plasticity_depth),
     .used = has_depth,
     .law_has = depth_in,
     .unused = "",
     .help = "phi_f of luding: the plastic overlap at which k2 is reached, over the reduced "
             "diameter 2 Ri Rj/(Ri + Rj).",
     .source = "Luding 2008; docs/theory/luding.md"},
    {.key = "pull_off_force",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "N",
     CLOD_FROM(0, 1e9),
     .fallback = "0 N",
     .example = "2 mN",
     CLOD_AT(C, pull_off_force),
     .used = has_pull,
     .law_has = pull_in,
     .unused = "",
     .help = "Force -f0 with which grains pull at each other as soon as they touch, whatever "
             "their past.",
     .source = "Thakur et al. 2014, eq. (5); docs/theory/eepa.md"},
    {.key = "surface_energy",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "J/m2",
     CLOD_FROM(0, 1e9),
     .fallback = "0 J/m2",
     .example = "0.5 J/m2",
     CLOD_AT(C, surface_energy),
     .used = has_surface_energy,
     .law_has = surface_energy_in,
     .unused = "",
     .help =
         "Surface energy gamma: the largest pull beyond pull_off_force is 3/2 pi gamma times "
         "the radius of the plastic contact patch. Takes the place of k_adh.",
     .source = "Morrissey 2013; docs/theory/eepa.md"},
    {.key = "restitution",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_ABOVE(0, 1),
     .fallback = "0.5",
     CLOD_AT(C, restitution),
     .help = "Restitution that the dash-pot is made for; the plastic loss of mepa, eepa and "
             "luding comes on "
             "top. "
             "1 means no dash-pot.",
     .source = "docs/theory/damping.md"},
    {.key = "friction",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 10),
     .fallback = "0.5",
     CLOD_AT(C, friction),
     .help = "Coefficient mu of sliding friction.",
     .source = "eq. (6)"},
    {.key = "coulomb",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = COULOMB,
     .fallback = "adhesive",
     CLOD_AT(C, coulomb),
     .help = "What friction multiplies: the distance from the pull-off line (adhesive), the "
             "size of the normal force (force), or its repulsive part (paper).",
     .source = "docs/theory/tangential.md"},
    {.key = "tangential",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = CLOD_LAW_SPRINGS_TANGENTIAL,
     .fallback = "tangent",
     CLOD_AT(C, tangential),
     .help = "Tangential stiffness: from the tangent of the loading branch (tangent), or the "
             "number k1 taken in N/m (literal; needs much smaller steps).",
     .source = "docs/theory/tangential.md"},
    {.key = "tangential_ratio",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_ABOVE(0, 10),
     .fallback = "1",
     CLOD_AT(C, tangential_ratio),
     .used = has_ratio,
     .unused = "only tangential: tangent has a ratio, and with hertz Mindlin's stiffness; "
               "literal takes "
               "the number k1; remove this key",
     .help = "Tangential over normal stiffness, zeta; hertz uses Mindlin's instead.",
     .source = "docs/theory/tangential.md"},
    {.key = "rolling",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = CLOD_LAW_SPRINGS_ROLLING,
     .fallback = "none",
     CLOD_AT(C, rolling),
     .help = "Rolling resistance: none, constant torque (cdt), spring and dash-pot (epsd), or "
             "spring alone (epsd2).",
     .source = "docs/theory/rolling.md; Ai, Chen, Rotter, Ooi 2011"},
    {.key = "rolling_friction",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 10),
     .fallback = "0",
     .example = "0.3",
     CLOD_AT(C, rolling_friction),
     .used = has_rolling,
     .unused = "rolling is none, so nothing resists; remove this key, or choose rolling: cdt, "
               "epsd or epsd2 (rolling_friction: 0 with one of these is the same as none)",
     .help = "Coefficient mu_r of rolling friction; times the effective radius it is the lever "
             "arm of the largest torque.",
     .source = "docs/theory/rolling.md"},
    {.key = "rolling_damping",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 2),
     .fallback = "0.3",
     CLOD_AT(C, rolling_damping),
     .used = has_rolling_damping,
     .unused = "only rolling: epsd has a dash-pot; remove this key, or choose epsd",
     .help = "Dash-pot of the rolling spring as a fraction of the critical one; epsd only.",
     .source = "docs/theory/rolling.md"},
};

const clod_table CLOD_TABLE_CONTACT = {
    .title = "Contact laws by pair of materials, a-b; every pair inherits from default.",
    CLOD_ROWS(CONTACT),
    .size = sizeof(C)};

static const clod_param CONTACTS[] = {
    {.key = "soften",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(1, 1e6),
     .fallback = "1",
     .example = "100",
     CLOD_AT(clod_case, soften),
     .help =
         "Every stiffness of a contact is divided by it: k1, k2 and k_adh of all pairs, and "
         "youngs_modulus where the law is hertz. Steps become longer and overlaps deeper; "
         "clod check says by how much, and what stays.",
     .source = "docs/theory/softening.md"},
};

const clod_table CLOD_TABLE_CONTACTS = {
    .title = "Beside the pairs: what holds for all of them.", CLOD_ROWS(CONTACTS)};
