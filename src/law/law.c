#include "law/law.h"

#include <math.h>

#include "base/memory.h"

/** z of docs/theory/damping.md: the damping ratio that gives restitution e. */
static double damping_ratio(double restitution)
{
    const double l = log(restitution);
    return -l / sqrt(l * l + M_PI * M_PI);
}

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

static void set_stiffness(clod_law *self, const clod_case_contact *contact,
                          const clod_case_material *a, const clod_case_material *b)
{
    self->exponent = contact->exponent;
    self->k1 = contact->k1;
    self->k2 = contact->k2;
    self->tangent_ratio = contact->tangential_ratio;
    if (contact->law == CLOD_LAW_HERTZ) {
        self->exponent = 1.5;
        self->k1 = 4.0 / 3.0 * young_star(a, b);
        self->k2 = self->k1;
        // Mindlin: k_t = 8 G* sqrt(R* d), and dk = 2 E* sqrt(R* d)
        self->tangent_ratio = 4.0 * shear_star(a, b) / young_star(a, b);
    } else if (contact->law == CLOD_LAW_HOOKE) {
        self->exponent = 1.0;
        self->k2 = self->k1;
    } else {
        self->k_adh_final = contact->k_adh;
    }
    self->exponent_kind = self->exponent == 1.0   ? CLOD_EXPONENT_ONE
                          : self->exponent == 1.5 ? CLOD_EXPONENT_THREE_HALVES
                                                  : CLOD_EXPONENT_ANY;
}

/** What only eepa and luding have (docs/theory/eepa.md, luding.md). */
static void set_plastic(clod_law *self, const clod_case_contact *contact)
{
    if (contact->law == CLOD_LAW_EEPA) {
        self->touch_final = contact->pull_off_force;
        // f0 - f_min = 3/2 pi gamma a of the patch a^2 = 2 R* dp
        self->patch_final = 1.5 * M_PI * contact->surface_energy * sqrt(2.0);
        self->patch_start = pow(2.0, 0.5 / self->exponent);
    } else if (contact->law == CLOD_LAW_LUDING) {
        self->flow = 2.0 * contact->plasticity_depth / self->virgin;
        self->hardening = (self->k2 - self->k1) / self->flow;
    }
}

clod_law clod_law_make(const clod_case_contact *contact, const clod_case_material *a,
                       const clod_case_material *b)
{
    clod_law self = {.kind = (clod_law_kind)contact->law};
    set_stiffness(&self, contact, a, b);
    self.virgin = 1.0 - self.k1 / self.k2;
    set_plastic(&self, contact);
    clod_law_set_adhesion(&self, 1.0);
    const double n = self.exponent;
    self.damping = 2.0 * damping_ratio(contact->restitution) * sqrt((n + 1.0) / (2.0 * n));
    self.friction = contact->friction;
    self.coulomb = (clod_coulomb)contact->coulomb;
    const bool elastic = contact->law == CLOD_LAW_HERTZ || contact->law == CLOD_LAW_HOOKE;
    self.tangential = elastic ? CLOD_TANGENTIAL_TANGENT : (clod_tangential)contact->tangential;
    self.root_ratio = sqrt(self.tangent_ratio);
    self.literal_stiffness = contact->k1;
    self.rolling = (clod_rolling)contact->rolling;
    self.rolling_friction = contact->rolling_friction;
    self.rolling_damping = contact->rolling_damping;
    self.epsd_ratio = 2.25 * contact->rolling_friction * contact->rolling_friction;
    return self;
}

void clod_law_set_adhesion(clod_law *self, double fraction)
{
    self->k_adh = fraction * self->k_adh_final;
    self->pull_off = 1.0 + self->k_adh / self->k2;
    self->touch = fraction * self->touch_final;
    self->patch = fraction * self->patch_final;
}

double clod_law_tangent(const clod_law *self, double overlap, double r_star)
{
    const double scale = self->kind == CLOD_LAW_HERTZ ? sqrt(r_star) : 1.0;
    return self->exponent * self->k1 * scale * pow(overlap, self->exponent - 1.0);
}

bool clod_laws_init(clod_laws *self, const clod_case *from, clod_status *status)
{
    const int32_t m = (int32_t)from->material_count;
    *self = (clod_laws){.materials = m, .count = m * (m + 1) / 2};
    self->law = clod_memory_alloc((size_t)self->count, sizeof *self->law);
    if (self->law == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %d contact laws",
                                self->count);
    }
    for (int32_t a = 0; a < m; a++) {
        for (int32_t b = a; b < m; b++) {
            self->law[clod_laws_index(self, a, b)] = clod_law_make(
                clod_case_pair(from, a, b), &from->materials[a], &from->materials[b]);
        }
    }
    return true;
}

void clod_laws_set_adhesion(clod_laws *self, double fraction)
{
    for (int32_t l = 0; l < self->count; l++) {
        clod_law_set_adhesion(&self->law[l], fraction);
    }
}

void clod_laws_fini(clod_laws *self)
{
    clod_memory_free(self->law);
    *self = (clod_laws){0};
}
