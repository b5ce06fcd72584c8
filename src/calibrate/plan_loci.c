/**
 * @file plan_loci.c
 * Yield loci of the measured tables of a plan, and numbers of the plan that contradict them.
 */

#include "calibrate/plan_loci.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"

/** The locus of a group, but with the plan's error for points that state none or a smaller one; false: it has none, or no memory. */
static bool with_error(const clod_locus_study *study, size_t group,
                       const clod_locus_point *points, size_t count, double error,
                       clod_plan_locus *to)
{
    clod_locus_point *copy = clod_memory_alloc(count, sizeof *copy);
    if (copy == NULL) {
        return false;
    }
    for (size_t k = 0; k < count; k++) {
        copy[k] = points[k];
        copy[k].tau_s_error = fmax(copy[k].tau_s_error, error);
    }
    clod_status status = {CLOD_OK, ""};
    clod_locus_study *made = clod_locus_study_create(copy, count, &status);
    const bool good = made != NULL && made->count == study->count;
    for (clod_field_index k = 0; good && k < CLOD_FIELD_COUNT; k++) {
        to->values[k] = clod_field_get(&made->groups[group].locus, k);
    }
    to->preshear_untold = good && made->groups[group].locus.preshear_untold;
    clod_locus_study_destroy(&made);
    clod_memory_free(copy);
    return good;
}

void clod_plan_loci_keep(clod_plan_maker *self, size_t test, const clod_locus_study *study,
                         size_t group, const clod_locus_point *points, size_t count,
                         double error)
{
    clod_plan_locus *made = clod_memory_alloc(1, sizeof *made);
    if (made == NULL) {
        self->loader->report->lost = true;
        return;
    }
    *made = (clod_plan_locus){.test = test, .entry = self->number, .next = self->plan->loci};
    self->plan->loci = made;
    if (!with_error(study, group, points, count, error, made)) {
        self->loader->report->lost = true;
    }
}

void clod_plan_loci_free(clod_plan *self)
{
    while (self->loci != NULL) {
        clod_plan_locus *first = self->loci;
        self->loci = first->next;
        clod_memory_free(first);
    }
}

// ---- conflicts

/**
 * sigma_c of a line with a negative intercept: such a locus has none, but a strength of the plan far above
 * 0 contradicts it all the same, so it is compared with 2 c cos(phi_lin)/(1 - sin(phi_lin)).
 */
static clod_locus_value strength_of(const clod_plan_locus *locus)
{
    const clod_locus_value *c = &locus->values[CLOD_FIELD_C];
    const double phi = locus->values[CLOD_FIELD_PHI_LIN].value;
    const double factor = 2.0 * cos(phi) / (1.0 - sin(phi));
    return (clod_locus_value){factor * c->value, factor * c->error, (double)NAN};
}

/** What a locus tells of a number; false: nothing. */
static bool told_by(const clod_plan_locus *locus, const char *number, clod_locus_value *value)
{
    for (size_t k = 0; k < CLOD_FIELD_COUNT; k++) {
        if (strcmp(CLOD_FIELDS[k].key, number) == 0) {
            *value = locus->values[k];
            if (k == CLOD_FIELD_SIGMA_C && isnan(value->value)) {
                *value = strength_of(locus);
            }
            return isfinite(value->value);
        }
    }
    return false;
}

static const char *name_of_file(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

/** Whether a number depends on tau_p. */
static bool is_of_preshear(const char *number)
{
    static const char *const KEYS[] = {"sigma_1", "sigma_2", "phi_e", "ffc"};
    bool found = false;
    for (size_t k = 0; k < sizeof KEYS / sizeof KEYS[0]; k++) {
        found = found || strcmp(KEYS[k], number) == 0;
    }
    return found;
}

/** A number of a test beside the locus of a table of the same test. */
static void compare(clod_loader *loader, const clod_plan *self, const clod_plan_locus *locus,
                    const clod_plan_target *number)
{
    clod_locus_value told;
    if (number->curve != NULL || !told_by(locus, number->number, &told)) {
        return;
    }
    // where the table tells no error, as of one preshear, it counts as no better known than the number
    double error = told.error > 0.0 ? told.error : number->error;
    if (locus->preshear_untold && is_of_preshear(number->number)) {
        error = fmax(error, number->error); // its own lacks the error of tau_p
    }
    const double apart = fabs(told.value - number->value) / hypot(error, number->error);
    if (apart <= CLOD_PLAN_SAME_ERRORS) {
        return;
    }
    const clod_plan_measure *unit = &number->measure;
    clod_check_fail(
        loader, "targets",
        "test %s: %s %.*f +- %.*f %s in targets.%zu is not that of the yield locus of %s in targets.%zu at the "
        "preshear stress of the case, %.*f +- %.*f %s (clod locus), by %.1f standard errors: they "
        "contradict each other; correct or leave out one of them, or give the errors that specimens "
        "differ by",
        self->tests[number->test].name, number->number, unit->digits,
        unit->factor * number->value, unit->digits, unit->factor * number->error, unit->unit,
        number->entry, name_of_file(self->wishes[locus->entry].locus), locus->entry,
        unit->digits, unit->factor * told.value, unit->digits, unit->factor * error, unit->unit,
        apart);
}

void clod_plan_loci_check(clod_loader *loader, const clod_plan *self)
{
    for (const clod_plan_locus *locus = self->loci; locus != NULL; locus = locus->next) {
        for (size_t k = 0; k < self->target_count; k++) {
            const clod_plan_target *number = &self->targets[k];
            if (number->test == locus->test && self->wishes[number->entry].locus == NULL) {
                compare(loader, self, locus, number);
            }
        }
    }
}
