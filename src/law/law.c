#include "law/law.h"

#include <math.h>

#include "base/memory.h"
#include "law/law_forms.h"
#include "law/law_kinds.h"

/** z of docs/theory/damping.md: the damping ratio that gives restitution e. */
static double damping_ratio(double restitution)
{
    const double l = log(restitution);
    return -l / sqrt(l * l + M_PI * M_PI);
}

static clod_law_exponent exponent_kind(double exponent)
{
    return exponent == 1.0   ? CLOD_EXPONENT_ONE
           : exponent == 1.5 ? CLOD_EXPONENT_THREE_HALVES
                             : CLOD_EXPONENT_ANY;
}

clod_case_material clod_law_soften_material(const clod_case_material *from, double soften)
{
    clod_case_material made = *from;
    made.youngs_modulus /= fmax(soften, 1.0); // 0: the case does not say
    return made;
}

/** The same of a pair; what is no stiffness stays (docs/theory/softening.md). */
static clod_case_contact soften_contact(const clod_case_contact *from)
{
    clod_case_contact made = *from;
    const double soften = fmax(from->soften, 1.0);
    made.k1 /= soften;
    made.k2 /= soften;
    made.k_adh /= soften;
    return made;
}

static clod_law make_law(const clod_case_contact *contact, const clod_case_material *a,
                         const clod_case_material *b)
{
    clod_law self = {.kind = (clod_law_kind)contact->law,
                     .exponent = contact->exponent,
                     .k1 = contact->k1,
                     .k2 = contact->k2,
                     .tangent_ratio = contact->tangential_ratio};
    const clod_law_kind_row *row = clod_law_kinds_row(self.kind);
    row->make(&self, contact, a, b);
    self.exponent_kind = exponent_kind(self.exponent);
    self.virgin = 1.0 - self.k1 / self.k2;
    clod_law_set_adhesion(&self, 1.0);
    const double n = self.exponent;
    self.damping = 2.0 * damping_ratio(contact->restitution) * sqrt((n + 1.0) / (2.0 * n));
    self.friction = contact->friction;
    self.coulomb = (clod_coulomb)contact->coulomb;
    self.tangential =
        row->elastic ? CLOD_TANGENTIAL_TANGENT : (clod_tangential)contact->tangential;
    self.root_ratio = sqrt(self.tangent_ratio);
    self.literal_stiffness = contact->k1;
    self.rolling = (clod_rolling)contact->rolling;
    self.rolling_friction = contact->rolling_friction;
    self.rolling_damping = contact->rolling_damping;
    self.epsd_ratio = 2.25 * contact->rolling_friction * contact->rolling_friction;
    return self;
}

clod_law clod_law_make(const clod_case_contact *contact, const clod_case_material *a,
                       const clod_case_material *b)
{
    const clod_case_contact soft = soften_contact(contact);
    const clod_case_material soft_a = clod_law_soften_material(a, contact->soften);
    const clod_case_material soft_b = clod_law_soften_material(b, contact->soften);
    return make_law(&soft, &soft_a, &soft_b);
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
    const double scale = clod_law_root_radius(self) ? sqrt(r_star) : 1.0;
    return self->exponent * self->k1 * scale * pow(overlap, self->exponent - 1.0);
}

double clod_law_stiffest(const clod_law *self, double overlap, double r_star)
{
    return clod_law_kinds_row(self->kind)->stiffest(self, overlap, r_star);
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
