#include "config/contacts_law.h"

#include <stdio.h>

#include "config/check.h"

void clod_contacts_fail(clod_loader *loader, const clod_contacts_pair *self, const char *key,
                        const char *message)
{
    char path[CLOD_CONTACTS_PATH + 24];
    snprintf(path, sizeof path, "%s.%s", self->path, key);
    clod_check_fail(loader, path, "%s", message);
}

static void check_linear(clod_loader *loader, const clod_contacts_pair *self,
                         const clod_case_contact *contact, const char *law)
{
    char message[128];
    if (contact->exponent != 1.0) {
        snprintf(message, sizeof message, "law %s is linear, its exponent is 1", law);
        clod_contacts_fail(loader, self, "exponent", message);
    }
    if (contact->tangential == CLOD_TANGENTIAL_LITERAL) {
        snprintf(message, sizeof message,
                 "literal takes the number k1 in N/m, which k1 of law %s is already; write "
                 "tangent",
                 law);
        clod_contacts_fail(loader, self, "tangential", message);
    }
}

static void check_hertz(clod_loader *loader, const clod_contacts_pair *self,
                        const clod_case_contact *contact)
{
    if (contact->exponent != 1.5) {
        clod_contacts_fail(loader, self, "exponent", "law hertz has the exponent 1.5");
    }
    if (contact->tangential == CLOD_TANGENTIAL_LITERAL) {
        clod_contacts_fail(loader, self, "tangential",
                           "literal takes k1, which law hertz does not have; write tangent");
    }
}

/** k2 is k1 or more; luding divides by k2 - k1, and is hooke without it. */
static void check_k2(clod_loader *loader, const clod_contacts_pair *self,
                     const clod_case_contact *contact)
{
    const bool luding = contact->law == CLOD_LAW_LUDING;
    if (contact->k1 > 0.0 && contact->k2 > 0.0 &&
        (contact->k2 < contact->k1 || (luding && contact->k2 == contact->k1))) {
        char unit[32] = "";
        if (contact->exponent != 1.0) {
            snprintf(unit, sizeof unit, "^%.10g", contact->exponent);
        }
        char message[160];
        snprintf(message, sizeof message, "%.10g N/m%s is %s k1 = %.10g N/m%s; k2 is %s",
                 contact->k2, unit, luding ? "not more than" : "less than", contact->k1, unit,
                 luding ? "more than k1 (law hooke has k1 alone)" : "k1 or more");
        clod_contacts_fail(loader, self, "k2", message);
    }
}

void clod_contacts_check_law(clod_loader *loader, const clod_contacts_pair *self,
                             const clod_case_contact *contact)
{
    switch (contact->law) {
    case CLOD_LAW_HERTZ:
        check_hertz(loader, self, contact);
        break;
    case CLOD_LAW_HOOKE:
        check_linear(loader, self, contact, "hooke");
        break;
    case CLOD_LAW_LUDING:
        check_linear(loader, self, contact, "luding");
        check_k2(loader, self, contact);
        break;
    default:
        check_k2(loader, self, contact);
        break;
    }
    if (contact->law == CLOD_LAW_EEPA && contact->surface_energy > 0.0 &&
        contact->k_adh > 0.0) {
        clod_contacts_fail(loader, self, "surface_energy",
                           "takes the place of k_adh: the pull follows from one of the two; "
                           "give the other as 0, or remove it");
    }
}

static void require_stiffness(clod_loader *loader, const clod_contacts_pair *self,
                              const char *law, const char *key, const char *example,
                              double value, double exponent)
{
    if (value == 0.0) {
        char unit[32] = "";
        if (exponent != 1.0) {
            snprintf(unit, sizeof unit, "^%.10g", exponent);
        }
        clod_report_add(loader->report, self->place, self->path,
                        "law %s needs the key %s, for instance %s: %s N/m%s", law, key, key,
                        example, unit);
    }
}

static void require_elastic(clod_loader *loader, const clod_case *whole,
                            const clod_contacts_pair *self, int index)
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
        clod_check_fail(loader, path, "law hertz of contact %s-%s needs the key %s here",
                        whole->materials[self->a].name, whole->materials[self->b].name,
                        missing);
    }
}

static void require_rolling_friction(clod_loader *loader, const clod_contacts_pair *self,
                                     const clod_case_contact *contact)
{
    if (contact->rolling != CLOD_ROLLING_NONE &&
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
    switch (contact->law) {
    case CLOD_LAW_HERTZ:
        require_elastic(loader, whole, self, self->a);
        require_elastic(loader, whole, self, self->b);
        break;
    case CLOD_LAW_HOOKE:
        require_stiffness(loader, self, "hooke", "k1", "4.75e8", contact->k1, 1.0);
        break;
    case CLOD_LAW_LUDING:
        require_stiffness(loader, self, "luding", "k1", "4.75e5", contact->k1, 1.0);
        require_stiffness(loader, self, "luding", "k2", "2.37e6", contact->k2, 1.0);
        if (contact->plasticity_depth == 0.0) {
            clod_report_add(loader->report, self->place, self->path,
                            "law luding needs the key plasticity_depth, for instance "
                            "plasticity_depth: 0.05");
        }
        break;
    default: {
        const char *law = contact->law == CLOD_LAW_EEPA ? "eepa" : "mepa";
        require_stiffness(loader, self, law, "k1", "4.75e8", contact->k1, contact->exponent);
        require_stiffness(loader, self, law, "k2", "2.37e9", contact->k2, contact->exponent);
        break;
    }
    }
}

void clod_contacts_complete(clod_case_contact *contact)
{
    if (contact->law == CLOD_LAW_HOOKE) {
        contact->k2 = contact->k1;
        contact->k_adh = 0.0;
    } else if (contact->law == CLOD_LAW_HERTZ) {
        contact->k1 = 0.0;
        contact->k2 = 0.0;
        contact->k_adh = 0.0;
    }
    if (contact->law != CLOD_LAW_LUDING) {
        contact->plasticity_depth = 0.0;
    }
    if (contact->law != CLOD_LAW_EEPA) {
        contact->pull_off_force = 0.0;
        contact->surface_energy = 0.0;
    }
    if (contact->rolling == CLOD_ROLLING_NONE) {
        contact->rolling_friction = 0.0;
    }
    if (contact->rolling != CLOD_ROLLING_EPSD) {
        contact->rolling_damping = 0.0;
    }
    if (contact->law == CLOD_LAW_HERTZ || contact->tangential == CLOD_TANGENTIAL_LITERAL) {
        contact->tangential_ratio = 1.0;
    }
}
