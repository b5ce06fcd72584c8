#include "law/law_kinds.h"

#include <math.h>

#include "base/assert.h"

/** E* and G* of two materials [Pa] (Hertz, Mindlin). */
static double young_star(const clod_case_material *a, const clod_case_material *b)
{
    return 1.0 / ((1.0 - a->poissons_ratio * a->poissons_ratio) / a->youngs_modulus +
                  (1.0 - b->poissons_ratio * b->poissons_ratio) / b->youngs_modulus);
}

static double shear_star(const clod_case_material *a, const clod_case_material *b)
{
    const double compliance_a =
        2.0 * (2.0 - a->poissons_ratio) * (1.0 + a->poissons_ratio) / a->youngs_modulus;
    const double compliance_b =
        2.0 * (2.0 - b->poissons_ratio) * (1.0 + b->poissons_ratio) / b->youngs_modulus;
    return 1.0 / (compliance_a + compliance_b);
}

static void make_hertz(clod_law *self, const clod_case_contact *contact,
                       const clod_case_material *a, const clod_case_material *b)
{
    (void)contact;
    self->exponent = 1.5;
    self->k1 = 4.0 / 3.0 * young_star(a, b);
    self->k2 = self->k1;
    // Mindlin: k_t = 8 G* sqrt(R* d), and dk = 2 E* sqrt(R* d)
    self->tangent_ratio = 4.0 * shear_star(a, b) / young_star(a, b);
}

static void make_hooke(clod_law *self, const clod_case_contact *contact,
                       const clod_case_material *a, const clod_case_material *b)
{
    (void)contact, (void)a, (void)b;
    self->exponent = 1.0;
    self->k2 = self->k1;
}

static void make_mepa(clod_law *self, const clod_case_contact *contact,
                      const clod_case_material *a, const clod_case_material *b)
{
    (void)a, (void)b;
    self->k_adh_final = contact->k_adh;
}

static void make_eepa(clod_law *self, const clod_case_contact *contact,
                      const clod_case_material *a, const clod_case_material *b)
{
    make_mepa(self, contact, a, b);
    self->touch_final = contact->pull_off_force;
    // f0 - f_min = 3/2 pi gamma a of the patch a^2 = 2 R* dp
    self->patch_final = 1.5 * M_PI * contact->surface_energy * sqrt(2.0);
    self->patch_start = pow(2.0, 0.5 / self->exponent);
}

static void make_luding(clod_law *self, const clod_case_contact *contact,
                        const clod_case_material *a, const clod_case_material *b)
{
    make_mepa(self, contact, a, b);
    self->flow = 2.0 * contact->plasticity_depth / (1.0 - self->k1 / self->k2);
    self->hardening = (self->k2 - self->k1) / self->flow;
}

/** Slope of k2 (d^n - dp^n). */
static double stiffest_k2(const clod_law *self, double overlap, double r_star)
{
    return clod_law_tangent(self, overlap, r_star) * self->k2 / self->k1;
}

static double unloading_k2(const clod_law *self, double overlap, double r_star, double memory)
{
    (void)memory;
    return stiffest_k2(self, overlap, r_star);
}

/** k2 has risen with the largest overlap, which is what the contact remembers. */
static double unloading_luding(const clod_law *self, double overlap, double r_star,
                               double memory)
{
    (void)overlap;
    return self->k1 + self->hardening * memory / r_star;
}

static double flow_luding(const clod_law *self, double r_star)
{
    return self->flow * r_star;
}

static clod_law_pull pull_clamp(const clod_law *self, double r_star, double overlap)
{
    const double n = self->exponent;
    const double plastic = self->virgin * pow(overlap, n);
    double x = plastic / self->pull_off;
    double pull = self->k_adh * x; // hertz has none
    if (self->patch > 0.0) {
        pull =
            fmin(self->patch * sqrt(r_star * pow(plastic, 1.0 / n)), 0.5 * self->k2 * plastic);
        x = plastic - pull / self->k2;
    }
    return (clod_law_pull){pow(x, 1.0 / n), pull + self->touch};
}

static clod_law_pull pull_luding(const clod_law *self, double r_star, double overlap)
{
    const double most = fmin(overlap, self->flow * r_star);
    const double rise = self->hardening * most / r_star;
    const double least = rise * most / (self->k1 + rise + self->k_adh);
    return (clod_law_pull){least, self->k_adh * least};
}

static double plastic_power(const clod_law *self, double r_star, double memory)
{
    (void)r_star;
    return pow(memory, 1.0 / self->exponent);
}

static double plastic_luding(const clod_law *self, double r_star, double memory)
{
    const double rise = self->hardening * memory / r_star;
    return rise / (self->k1 + rise) * memory; // d0 = (1 - k1/k2) d_max
}

static double pressed_power(const clod_law *self, double memory)
{
    return memory > 0.0 ? pow(memory / self->virgin, 1.0 / self->exponent) : 0.0;
}

static double pressed_luding(const clod_law *self, double memory)
{
    (void)self;
    return memory; // d_max, up to d*
}

const char *const CLOD_LAW_NAMES[CLOD_LAW_KINDS + 1] = {
    [CLOD_LAW_MEPA] = "mepa",     [CLOD_LAW_HERTZ] = "hertz", [CLOD_LAW_HOOKE] = "hooke",
    [CLOD_LAW_LUDING] = "luding", [CLOD_LAW_EEPA] = "eepa",
};

static const clod_law_kind_row LAWS[CLOD_LAW_KINDS] = {
    [CLOD_LAW_MEPA] = {.keys = {.k1 = "4.75e8", .k2 = "2.37e9", .k_adh = true},
                       .about = "elasto-plastic with adhesion",
                       .make = make_mepa,
                       .speed_free = true,
                       .stiffest = stiffest_k2,
                       .unloading = unloading_k2,
                       .pull = pull_clamp,
                       .plastic = plastic_power,
                       .pressed = pressed_power,
                       .stiffness_keys = "its k1 (and k2)"},
    [CLOD_LAW_HERTZ] = {.keys = {.exponent = 1.5, .elastic_moduli = true},
                        .about = "elastic, from Young's modulus",
                        .make = make_hertz,
                        .elastic = true,
                        .rayleigh = true,
                        .speed_free = true,
                        .stiffest = stiffest_k2,
                        .unloading = unloading_k2,
                        .pull = pull_clamp,
                        .plastic = plastic_power,
                        .pressed = pressed_power,
                        .stiffness_keys = "youngs_modulus"},
    [CLOD_LAW_HOOKE] = {.keys = {.exponent = 1.0, .k1 = "4.75e8"},
                        .about = "linear elastic, k1",
                        .make = make_hooke,
                        .elastic = true,
                        .speed_free = true,
                        .stiffest = stiffest_k2,
                        .unloading = unloading_k2,
                        .pull = pull_clamp,
                        .plastic = plastic_power,
                        .pressed = pressed_power,
                        .stiffness_keys = "its k1 (and k2)"},
    [CLOD_LAW_LUDING] = {.keys = {.exponent = 1.0,
                                  .k1 = "4.75e5",
                                  .k2 = "2.37e6",
                                  .plasticity_depth = "0.05",
                                  .k_adh = true,
                                  .k2_above = true},
                         .about = "linear, k2 rises with the largest overlap",
                         .make = make_luding,
                         .stiffest = stiffest_k2,
                         .unloading = unloading_luding,
                         .flow = flow_luding,
                         .pull = pull_luding,
                         .plastic = plastic_luding,
                         .pressed = pressed_luding,
                         .stiffness_keys = "its k1 (and k2)"},
    [CLOD_LAW_EEPA] = {.keys = {.k1 = "4.75e8",
                                .k2 = "2.37e9",
                                .k_adh = true,
                                .pull_off_force = true,
                                .surface_energy = true},
                       .about = "mepa with a constant pull or a pull from surface energy",
                       .make = make_eepa,
                       .stiffest = stiffest_k2,
                       .unloading = unloading_k2,
                       .pull = pull_clamp,
                       .plastic = plastic_power,
                       .pressed = pressed_power,
                       .stiffness_keys = "its k1 (and k2)"},
};

const clod_law_kind_row *clod_law_kinds_row(clod_law_kind kind)
{
    CLOD_ASSERT((unsigned)kind < CLOD_LAW_KINDS);
    return &LAWS[kind];
}
