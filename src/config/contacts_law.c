#include "config/contacts_law.h"

#include <stdio.h>

#include "config/check.h"
#include "config/law_keys.h"
#include "law/law_springs.h"

void clod_contacts_fail(clod_loader *loader, const clod_contacts_pair *self, const char *key,
                        const char *message)
{
    char path[CLOD_CONTACTS_PATH + 24];
    snprintf(path, sizeof path, "%s.%s", self->path, key);
    clod_check_fail(loader, path, "%s", message);
}

void clod_contacts_fail_unused(clod_loader *loader, const clod_contacts_pair *self,
                               const clod_param *row)
{
    char laws[CLOD_LAW_KEYS_TEXT];
    char message[CLOD_LAW_KEYS_TEXT + 192];
    if (row->law_has == NULL) {
        clod_contacts_fail(loader, self, row->key, row->unused);
        return;
    }
    const bool one = clod_law_keys_list(row->law_has, laws) == 1;
    snprintf(message, sizeof message, "only %s %s this key%s; remove it, or choose %s", laws,
             one ? "has" : "have", row->unused, one ? laws : "one of them");
    clod_contacts_fail(loader, self, row->key, message);
}

/** Exponent and tangential stiffness of a law that does not leave them open. */
static void check_fixed(clod_loader *loader, const clod_contacts_pair *self,
                        const clod_case_contact *contact)
{
    const clod_law_keys *keys = clod_law_keys_of(contact->law);
    const char *law = CLOD_LAW_NAMES[contact->law];
    const bool linear = keys->exponent == 1.0;
    char message[128];
    if (keys->exponent != 0.0 && contact->exponent != keys->exponent) {
        snprintf(message, sizeof message,
                 linear ? "law %s is linear, its exponent is %.10g"
                        : "law %s has the exponent %.10g",
                 law, keys->exponent);
        clod_contacts_fail(loader, self, "exponent", message);
    }
    if (clod_law_springs_tangential_row_of(contact->tangential)->takes_k1 &&
        (keys->k1 == NULL || linear)) {
        snprintf(message, sizeof message,
                 keys->k1 == NULL
                     ? "literal takes k1, which law %s does not have; write tangent"
                     : "literal takes the number k1 in N/m, which k1 of law %s is already; "
                       "write tangent",
                 law);
        clod_contacts_fail(loader, self, "tangential", message);
    }
}

/** k2 is k1 or more; a law that divides by k2 - k1 is hooke without it. */
static void check_k2(clod_loader *loader, const clod_contacts_pair *self,
                     const clod_case_contact *contact)
{
    const bool above = clod_law_keys_of(contact->law)->k2_above;
    if (contact->k1 > 0.0 && contact->k2 > 0.0 &&
        (contact->k2 < contact->k1 || (above && contact->k2 == contact->k1))) {
        char unit[32] = "";
        if (contact->exponent != 1.0) {
            snprintf(unit, sizeof unit, "^%.10g", contact->exponent);
        }
        char message[160];
        snprintf(message, sizeof message, "%.10g N/m%s is %s k1 = %.10g N/m%s; k2 is %s",
                 contact->k2, unit, above ? "not more than" : "less than", contact->k1, unit,
                 above ? "more than k1 (law hooke has k1 alone)" : "k1 or more");
        clod_contacts_fail(loader, self, "k2", message);
    }
}

void clod_contacts_check_law(clod_loader *loader, const clod_contacts_pair *self,
                             const clod_case_contact *contact)
{
    const clod_law_keys *keys = clod_law_keys_of(contact->law);
    check_fixed(loader, self, contact);
    if (keys->k2 != NULL) {
        check_k2(loader, self, contact);
    }
    if (keys->surface_energy && contact->surface_energy > 0.0 && contact->k_adh > 0.0) {
        clod_contacts_fail(loader, self, "surface_energy",
                           "takes the place of k_adh: the pull follows from one of the two; "
                           "give the other as 0, or remove it");
    }
}

/** A stiffness that the law has (then there is an example) must have been given. */
static void require_stiffness(clod_loader *loader, const clod_contacts_pair *self,
                              const clod_case_contact *contact, const char *key,
                              const char *example, double value)
{
    const double fixed = clod_law_keys_of(contact->law)->exponent;
    const double exponent = fixed != 0.0 ? fixed : contact->exponent;
    if (example != NULL && value == 0.0) {
        char unit[32] = "";
        if (exponent != 1.0) {
            snprintf(unit, sizeof unit, "^%.10g", exponent);
        }
        clod_report_add(loader->report, self->place, self->path,
                        "law %s needs the key %s, for instance %s: %s N/m%s",
                        CLOD_LAW_NAMES[contact->law], key, key, example, unit);
    }
}

static void require_elastic(clod_loader *loader, const clod_case *whole,
                            const clod_contacts_pair *self, const char *law, int index)
{
    const clod_case_material *material = &whole->materials[index];
    const char *missing = material->youngs_modulus == 0.0   ? "youngs_modulus"
                          : material->poissons_ratio == 0.0 ? "poissons_ratio"
                                                            : NULL;
    if (missing == NULL) {
        return;
    }
    char path[CLOD_CONTACTS_PATH];
    snprintf(path, sizeof path, "materials.%s", material->name);
    if (clod_report_clean(loader->report, path)) {
        clod_check_fail(loader, path, "law %s of contact %s-%s needs the key %s here", law,
                        whole->materials[self->a].name, whole->materials[self->b].name,
                        missing);
    }
}

static void require_rolling_friction(clod_loader *loader, const clod_contacts_pair *self,
                                     const clod_case_contact *contact)
{
    if (clod_law_springs_rolling_row_of(contact->rolling)->resists &&
        clod_tree_find(self->own, "rolling_friction") == NULL &&
        clod_tree_find(self->common, "rolling_friction") == NULL) {
        const bool own = clod_tree_find(self->own, "rolling") != NULL;
        const clod_contacts_pair common = {.path = "contacts.default"};
        clod_contacts_fail(
            loader, own ? self : &common, "rolling",
            "needs the key rolling_friction beside it, for instance rolling_friction: 0.3; "
            "without it nothing resists");
    }
}

void clod_contacts_check_needs(clod_loader *loader, const clod_case *whole,
                               const clod_contacts_pair *self, const clod_case_contact *contact)
{
    require_rolling_friction(loader, self, contact);
    const clod_law_keys *keys = clod_law_keys_of(contact->law);
    const char *law = CLOD_LAW_NAMES[contact->law];
    if (keys->elastic_moduli) {
        require_elastic(loader, whole, self, law, self->a);
        require_elastic(loader, whole, self, law, self->b);
    }
    require_stiffness(loader, self, contact, "k1", keys->k1, contact->k1);
    require_stiffness(loader, self, contact, "k2", keys->k2, contact->k2);
    if (keys->plasticity_depth != NULL && contact->plasticity_depth == 0.0) {
        clod_report_add(loader->report, self->place, self->path,
                        "law %s needs the key plasticity_depth, for instance "
                        "plasticity_depth: %s",
                        law, keys->plasticity_depth);
    }
}

void clod_contacts_complete(clod_case_contact *contact)
{
    const clod_law_keys *keys = clod_law_keys_of(contact->law);
    const clod_law_springs_rolling_row *rolling =
        clod_law_springs_rolling_row_of(contact->rolling);
    contact->k1 = keys->k1 != NULL ? contact->k1 : 0.0;
    contact->k2 = keys->k2 != NULL ? contact->k2 : contact->k1;
    contact->k_adh = keys->k_adh ? contact->k_adh : 0.0;
    if (keys->plasticity_depth == NULL) {
        contact->plasticity_depth = 0.0;
    }
    if (!keys->pull_off_force) {
        contact->pull_off_force = 0.0;
    }
    if (!keys->surface_energy) {
        contact->surface_energy = 0.0;
    }
    if (!rolling->resists) {
        contact->rolling_friction = 0.0;
    }
    if (!rolling->dash_pot) {
        contact->rolling_damping = 0.0;
    }
    if (keys->elastic_moduli ||
        clod_law_springs_tangential_row_of(contact->tangential)->takes_k1) {
        contact->tangential_ratio = 1.0;
    }
}
