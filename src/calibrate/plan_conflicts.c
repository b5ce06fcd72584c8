/**
 * @file plan_conflicts.c
 * Targets that cannot be true together.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "calibrate/number.h"
#include "calibrate/plan_loci.h"
#include "calibrate/test_kinds.h"
#include "config/testers.h"

#define FIRM CLOD_PLAN_FIRM_ERRORS

double clod_plan_conflicts_error(const clod_plan_target *self)
{
    return hypot(self->error, self->discrepancy);
}

/** The same number twice: once is enough, or the values are two specimens'. */
static void check_twice(clod_loader *loader, const clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        for (size_t m = 0; m < k; m++) {
            const clod_plan_target *a = &self->targets[m];
            const clod_plan_target *b = &self->targets[k];
            const double apart = fabs(a->value - b->value) / hypot(a->error, b->error);
            if (strcmp(a->name, b->name) == 0 && apart > CLOD_PLAN_SAME_ERRORS) {
                clod_check_fail(
                    loader, "targets",
                    "%s is there as %.6g %s in targets.%zu and as %.6g %s in targets.%zu, %.1f standard errors "
                    "apart: they contradict each other; leave one of them out, or give the errors that "
                    "specimens differ by",
                    a->name, a->measure.factor * a->value, a->measure.unit, a->entry,
                    b->measure.factor * b->value, b->measure.unit, b->entry, apart);
            }
        }
    }
}

/** Whether two paths lead to one file. */
static bool is_one_file(const char *one, const char *other)
{
    struct stat a, b;
    return strcmp(one, other) == 0 || (stat(one, &a) == 0 && stat(other, &b) == 0 &&
                                       a.st_dev == b.st_dev && a.st_ino == b.st_ino);
}

/** A target that two entries make of the same row of a table; NULL: there is none. */
static const clod_plan_target *shared(const clod_plan *self, size_t entry, size_t other)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *a = &self->targets[k];
        for (size_t m = 0; m < self->target_count && a->entry == entry; m++) {
            const clod_plan_target *b = &self->targets[m];
            if (b->entry == other && a->test == b->test && strcmp(a->name, b->name) == 0) {
                return a;
            }
        }
    }
    return NULL;
}

/** The same rows of a table in two entries. */
static void check_tables(clod_loader *loader, const clod_plan *self)
{
    for (size_t k = 0; k < self->wish_count; k++) {
        for (size_t m = 0; m < k; m++) {
            const char *one = self->wishes[m].locus, *other = self->wishes[k].locus;
            const clod_plan_target *twice =
                one != NULL && other != NULL && is_one_file(one, other) ? shared(self, m, k)
                                                                        : NULL;
            if (twice == NULL) {
                continue;
            }
            char path[48];
            snprintf(path, sizeof path, "targets.%zu.locus", k);
            clod_check_fail(
                loader, path,
                "is the table of targets.%zu, and %s is in both: one measurement would count as two. Leave "
                "one of them out; other specimens are further rows of the table, with a column seed",
                m, twice->name);
            break;
        }
    }
}

// ---- ffc

static bool is(const clod_plan_target *self, size_t test, const char *number)
{
    return self->test == test && strcmp(self->number, number) == 0;
}

/** ffc = sigma_1/sigma_c of a lid, whose stress is sigma_1, as sigma_c ffc = sigma_1, which holds for sigma_c = 0, too. */
static void compare_ffc(clod_loader *loader, const clod_plan *self, const clod_plan_target *ffc,
                        const clod_plan_target *strength)
{
    const double stress = ffc->normal_stress;
    const double error = hypot(hypot(clod_plan_conflicts_error(ffc) * strength->value,
                                     ffc->value * clod_plan_conflicts_error(strength)),
                               CLOD_NUMBER_SAME_STRESS * stress);
    const double apart = fabs(ffc->value * strength->value - stress) / error;
    if (fabs(stress / strength->normal_stress - 1.0) >= CLOD_NUMBER_SAME_STRESS ||
        apart <= FIRM) {
        return;
    }
    clod_check_fail(
        loader, "targets",
        "test %s: ffc %.4g in targets.%zu is not sigma_1/sigma_c = %.4g kPa/%.4g kPa, of the consolidation stress "
        "and sigma_c in targets.%zu, by %.1f standard errors: they contradict each other; "
        "correct or leave out one of them",
        self->tests[ffc->test].name, ffc->value, ffc->entry, 1e-3 * stress,
        1e-3 * strength->value, strength->entry, apart);
}

static void check_ffc(clod_loader *loader, const clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *ffc = &self->targets[k];
        for (size_t m = 0; m < self->target_count && strcmp(ffc->number, "ffc") == 0; m++) {
            if (ffc->normal_stress > 0.0 && is(&self->targets[m], ffc->test, "sigma_c")) {
                compare_ffc(loader, self, ffc, &self->targets[m]);
            }
        }
    }
}

// ---- density

double clod_plan_grain_density(const clod_plan *self, const clod_plan_test *test, double place)
{
    double places[CLOD_PLAN_PARAMETERS]; // a density among the parameters has its ends there
    for (size_t k = 0; k < CLOD_PLAN_PARAMETERS; k++) {
        places[k] = place;
    }
    clod_status status = {CLOD_OK, ""};
    clod_case *from = clod_plan_case(self, test, places, &status); // a corner, which did load
    double density = (double)NAN;
    if (from != NULL) {
        const char *grain = clod_config_tester_of(from)->materials(from).grain;
        density = from->materials[clod_case_material_index(from, grain)].density;
    }
    clod_case_destroy(&from);
    return density;
}

static bool is_density(const clod_plan_target *self, size_t test)
{
    return is(self, test, "rho_b") || is(self, test, "rho_inside");
}

static void check_density(clod_loader *loader, const clod_plan *self)
{
    for (size_t t = 0; t < self->test_count; t++) {
        double solid = (double)NAN;
        for (size_t k = 0; k < self->target_count; k++) {
            const clod_plan_target *one = &self->targets[k];
            if (!is_density(one, t) || clod_test_kinds_of(self->tests[t].middle)->paths) {
                continue;
            }
            solid = isnan(solid) ? clod_plan_grain_density(self, &self->tests[t], 1.0) : solid;
            if (one->value > solid) {
                clod_check_fail(
                    loader, "targets",
                    "test %s: %s %.0f kg/m3 in targets.%zu is above the density of its grains, %.0f "
                    "kg/m3, which no packing of them reaches; the case needs the density of the solid, and "
                    "the target that of the bulk",
                    self->tests[t].name, one->number, one->value, one->entry, solid);
            }
        }
    }
}

void clod_plan_check_conflicts(clod_loader *loader, clod_plan *self)
{
    for (size_t t = 0; t < self->test_count; t++) {
        const size_t before = loader->report->count;
        clod_plan_conflicts_unit(loader, self, t);
        if (loader->report->count == before && // else it would say the same again
            clod_test_kinds_of(self->tests[t].middle)->numbers == CLOD_NUMBERS_SHEAR) {
            clod_plan_conflicts_shear(loader, self, t);
        }
    }
    clod_plan_conflicts_wall(loader, self);
    check_twice(loader, self);
    check_tables(loader, self);
    clod_plan_loci_check(loader, self);
    check_ffc(loader, self);
    check_density(loader, self);
}
