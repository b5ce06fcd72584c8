/**
 * @file plan_tables.c
 * Targets of a plan from measured tables: which table it is, yield loci of shear tests, wall yield loci.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/measured_header.h"
#include "analysis/study_file.h"
#include "base/input.h"
#include "base/memory.h"
#include "calibrate/plan_loci.h"
#include "calibrate/plan_samples.h"
#include "calibrate/test_kinds.h"
#include "clod/measured.h"

#define SAME 1.000001 ///< of an error over another

typedef clod_plan_maker maker;
typedef clod_plan_sample sample;

// ---- shear tests

/** What `clod locus` says of a table beside its numbers. */
static void warn(maker *self, const char *warning)
{
    clod_warning_list_add(&self->plan->warnings, "%s: %s", self->wish->locus, warning);
}

/** The prorated points of a yield locus. */
static void make_locus_points(maker *self, const clod_number *kind,
                              const clod_plan_target *common, const clod_locus *locus,
                              const clod_locus_point *points)
{
    clod_plan_samples list;
    if (clod_plan_samples_init(&list, self, locus->point_count)) {
        list.slope = tan(locus->phi_lin.value);
        list.error_column = "tau_sh_error";
        for (size_t k = 0; k < locus->point_count; k++) {
            const clod_locus_mark *mark = &locus->marks[k];
            list.items[list.count++] = (sample){.stress = mark->sigma,
                                                .value = mark->prorated,
                                                .error = points[mark->index].tau_s_error,
                                                .specimen = mark->seed};
        }
        clod_plan_samples_merge(&list, common->error);
        clod_plan_samples_warn_alike(self, &list);
        clod_plan_samples_make(self, kind, common, &list, 0.0);
    }
    clod_plan_samples_fini(&list);
}

/** Standard error of the mean density: from scatter and the table's errors, or else from the plan's of each
 *  preshear, whichever is larger (as clod_mean_of has it). */
static double density_error(const clod_locus *locus, const clod_locus_point *points,
                            double given)
{
    const double told = isfinite(locus->rho_b.error) ? locus->rho_b.error : 0.0;
    bool stated = true;
    for (size_t k = 0; k < locus->point_count; k++) {
        stated = stated && points[locus->marks[k].index].rho_b_error > 0.0;
    }
    return stated ? told : fmax(told, given / sqrt((double)locus->preshear_count));
}

/** Mean density of a specimen over the points that tell it, one at least. */
static double density_of(const clod_locus *locus, const clod_locus_point *points, int64_t seed)
{
    double sum = 0.0, count = 0.0;
    for (size_t k = 0; k < locus->point_count; k++) {
        const double density = points[locus->marks[k].index].rho_b;
        const bool counts = locus->marks[k].seed == seed && density > 0.0;
        sum += counts ? density : 0.0;
        count += counts ? 1.0 : 0.0;
    }
    return sum / count;
}

/** By how much specimens are denser than their mean: so a dense one can be seen to be a strong one. */
static void take_densities(const clod_locus *locus, const clod_locus_point *points,
                           clod_plan_repeats *to)
{
    to->count = 0;
    for (size_t k = 0; k < locus->point_count; k++) {
        const int64_t seed = locus->marks[k].seed;
        bool first = true;
        for (size_t m = 0; m < k; m++) {
            first = first && locus->marks[m].seed != seed;
        }
        if (first && to->count < CLOD_PLAN_SPECIMENS) {
            to->differences[to->count] = (clod_plan_difference){
                seed, density_of(locus, points, seed) - locus->rho_b.value};
        }
        to->count += first ? 1 : 0;
    }
}

/** The bulk density of a yield locus: the mean of its specimens. */
static void make_density(maker *self, const clod_number *kind, const clod_plan_target *common,
                         const clod_locus *locus, const clod_locus_point *points)
{
    if (isnan(locus->rho_b.value)) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                        "has no rho_b at the preshear stress of test %s; add the column, or "
                        "give number and value",
                        self->wish->test);
        return;
    }
    sample one = {.value = locus->rho_b.value,
                  .error = density_error(locus, points, common->error)};
    const double scatter = locus->rho_b.scatter / sqrt((double)locus->seed_count);
    take_densities(locus, points, &one.repeats);
    one.repeats.estimate = isfinite(scatter) && one.error <= SAME * scatter;
    const clod_plan_samples list = {.items = &one, .count = 1, .error_column = "rho_b_error"};
    clod_plan_samples_make(self, kind, common, &list, 0.0);
}

/** "0.6, 1.2": preshear stresses of a table. */
static const char *list_preshears(const clod_locus_study *study, char *buffer, size_t size)
{
    size_t used = 0;
    buffer[0] = '\0';
    for (size_t g = 0; g < study->count && used < size; g++) {
        used += (size_t)snprintf(buffer + used, size - used, "%s%.6g", g == 0 ? "" : ", ",
                                 1e-3 * study->groups[g].locus.sigma_p.value);
    }
    return buffer;
}

/** Points, or the density, of the locus with the preshear stress of the test. */
static void make_marks(maker *self, size_t test, const clod_number *kind,
                       const clod_locus_study *study, const clod_locus_point *points,
                       size_t count)
{
    const double preshear = clod_case_shear(self->plan->tests[test].middle)->preshear_stress;
    clod_plan_target common;
    if (!clod_plan_samples_common(self, test, kind, &common)) {
        return;
    }
    for (size_t g = 0; g < study->count; g++) {
        const clod_locus *locus = &study->groups[g].locus;
        if (!clod_plan_samples_same(locus->sigma_p.value, preshear)) {
            continue;
        }
        if (kind->at_stress) {
            make_locus_points(self, kind, &common, locus, points);
            clod_plan_loci_keep(self, test, study, g, points, count, common.error);
        } else {
            make_density(self, kind, &common, locus, points);
        }
        for (size_t k = 0; k < locus->warning_count; k++) {
            warn(self, locus->warnings[k]);
        }
        return;
    }
    char list[160];
    clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                    "has no points with the preshear stress of test %s, %.6g kPa; it has %s "
                    "kPa: give the case one of these",
                    self->wish->test, 1e-3 * preshear,
                    list_preshears(study, list, sizeof list));
}

/** The points of a measured yield locus; false with status. */
static bool make_locus(maker *self, size_t test, const clod_number *kind, clod_status *status)
{
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_read(self->wish->locus, NULL, &points, &count, status)) {
        return false;
    }
    clod_locus_study *study = clod_study_of_points(self->wish->locus, points, count, status);
    const bool good = study != NULL;
    if (good) {
        make_marks(self, test, kind, study, points, count);
    }
    clod_locus_study_destroy(&study);
    clod_locus_free(points);
    return good;
}

const clod_plan_table CLOD_PLAN_TABLE_SHEAR = {
    .is = CLOD_PLAN_IS_SHEAR, .numbers = {"tau", "rho_b"}, .make = make_locus};

// ---- wall friction tests

/** phi_x of a point at a normal stress. */
static sample angle_of(const clod_wall_locus_mark *mark, double stress)
{
    const clod_locus_value *phi_x = &mark->phi_x;
    return (sample){.stress = stress,
                    .value = phi_x->value,
                    .error = isfinite(phi_x->error) ? phi_x->error : 0.0,
                    .specimen = mark->point.seed};
}

/** phi_x of the points of a wall yield locus, or of those at the wish's normal stress. */
static void take_angles(maker *self, const clod_wall_locus *locus, clod_plan_samples *to)
{
    const double wanted = self->wish->normal_stress;
    size_t found = 0;
    for (size_t k = 0; k < locus->point_count; k++) {
        const clod_wall_locus_point *of = &locus->marks[k].point;
        const double stress = of->wall_stress > 0.0 ? of->wall_stress : of->sigma;
        if (wanted > 0.0 && !clod_plan_samples_same(stress, wanted)) {
            continue;
        }
        found++;
        if (of->unsteady) {
            clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                            "was not steady at %.6g kPa, and phi_x there is none of steady "
                            "shear; leave that point out",
                            1e-3 * stress);
            continue;
        }
        to->items[to->count++] = angle_of(&locus->marks[k], stress);
    }
    if (found == 0) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "normal_stress"),
                        "%.6g kPa: the table has no point there", 1e-3 * wanted);
    }
}

static void make_angles(maker *self, size_t test, const clod_number *kind,
                        const clod_wall_locus *locus)
{
    clod_plan_samples list;
    clod_plan_target common;
    if (!clod_plan_samples_common(self, test, kind, &common)) {
        return;
    }
    if (clod_plan_samples_init(&list, self, locus->point_count)) {
        list.error_column = "tau_w_error";
        take_angles(self, locus, &list);
        clod_plan_samples_merge(&list, common.error);
        clod_plan_samples_warn_alike(self, &list);
        clod_plan_samples_make(self, kind, &common, &list, 0.0);
    }
    clod_plan_samples_fini(&list);
}

/** The points of a measured wall yield locus; false with status. */
static bool make_wall(maker *self, size_t test, const clod_number *kind, clod_status *status)
{
    clod_wall_locus_point *points;
    size_t count;
    if (!clod_wall_locus_read(self->wish->locus, &points, &count, status)) {
        return false;
    }
    clod_wall_locus locus;
    const bool good = clod_wall_locus_evaluate(points, count, &locus, status);
    clod_locus_free(points);
    if (good) {
        make_angles(self, test, kind, &locus);
        for (size_t k = 0; k < locus.warning_count; k++) {
            warn(self, locus.warnings[k]);
        }
        clod_wall_locus_fini(&locus);
    }
    return good;
}

const clod_plan_table CLOD_PLAN_TABLE_WALL = {
    .is = CLOD_PLAN_IS_WALL, .numbers = {"phi_x"}, .one_stress = true, .make = make_wall};

// ---- all of them

typedef struct words {
    const char *columns, *what;
} words;

/** Columns by which a table is known, and what it then is. */
static const words WORDS[] = {
    [CLOD_PLAN_IS_NONE] = {"none of the columns sigma_sh, sigma_w and sigma_1", ""},
    [CLOD_PLAN_IS_SHEAR] = {"sigma_sh or tau_sh", "shear points (sigma_sh, tau_sh)"},
    [CLOD_PLAN_IS_WALL] = {"sigma_w or tau_w", "a wall yield locus (sigma_w, tau_w)"},
    [CLOD_PLAN_IS_DENSITY] = {"sigma_1", "bulk densities (sigma_1, rho_b)"},
    [CLOD_PLAN_IS_FLOW] = {"sigma_1", "a flow function (sigma_1, sigma_c)"},
};

/** What a table is, by its header; false with status. */
static bool look(const char *path, clod_plan_is *is, clod_status *status)
{
    char *text;
    size_t length;
    if (!clod_input_read(path, SIZE_MAX, &text, &length, status)) {
        return false;
    }
    static const clod_plan_is BY_STRESS[] = {
        [CLOD_MEASURED_OF_NONE] = CLOD_PLAN_IS_NONE,
        [CLOD_MEASURED_OF_SHEAR] = CLOD_PLAN_IS_SHEAR,
        [CLOD_MEASURED_OF_WALL] = CLOD_PLAN_IS_WALL,
        [CLOD_MEASURED_OF_SIGMA_1] = CLOD_PLAN_IS_FLOW,
    };
    *is = clod_measured_kind_of(text, length) == CLOD_MEASURED_DENSITY
              ? CLOD_PLAN_IS_DENSITY
              : BY_STRESS[clod_measured_stress_of(text, length)];
    clod_memory_free(text);
    return true;
}

/** The kind of table that a file is, among those of its test; NULL after a complaint. */
static const clod_plan_table *find_table(maker *self, size_t test, clod_plan_is is)
{
    const clod_test_kind *kind = clod_test_kinds_of(self->plan->tests[test].middle);
    char list[300] = "none; give number and value";
    size_t used = 0;
    for (size_t k = 0; k < CLOD_PLAN_TABLES && kind->tables[k] != NULL; k++) {
        const clod_plan_table *table = kind->tables[k];
        if (table->is == is) {
            return table;
        }
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", used > 0 ? ", " : "",
                                 WORDS[table->is].what);
    }
    clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                    "has %s in its header%s%s, and of tables test %s takes %s",
                    WORDS[is].columns, WORDS[is].what[0] != '\0' ? ", as " : "", WORDS[is].what,
                    self->wish->test, list);
    return NULL;
}

/** The number that the points of a table are targets of; NULL after a complaint. */
static const clod_number *number_of(maker *self, size_t test, const clod_plan_table *table)
{
    const clod_plan_wish *wish = self->wish;
    const char *const *numbers = table->numbers;
    if (wish->value != NULL || (!table->one_stress && wish->normal_stress > 0.0)) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                        "has value%s beside it; the table has them all",
                        table->one_stress ? "" : " or normal_stress");
        return NULL;
    }
    const char *number = wish->number != NULL ? wish->number : numbers[0];
    // rho_b of a laboratory, whose cell is wide, is that away from the walls of a simulated one
    const char *column = strcmp(number, "rho_inside") == 0 ? "rho_b" : number;
    for (size_t k = 0; k < 2 && numbers[k] != NULL; k++) {
        if (strcmp(column, numbers[k]) == 0) {
            return clod_number_find(&self->plan->tests[test], number);
        }
    }
    clod_check_fail(self->loader, clod_plan_targets_at(self, "number"),
                    "%s is none of %s; of such a table it is %s%s%s", wish->number,
                    WORDS[table->is].what, numbers[0], numbers[1] != NULL ? " or " : "",
                    numbers[1] != NULL ? numbers[1] : "");
    return NULL;
}

void clod_plan_tables_make(clod_plan_maker *self, size_t test)
{
    clod_status status = {CLOD_OK, ""};
    clod_plan_is is;
    if (!look(self->wish->locus, &is, &status)) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"), "%.800s",
                        status.text);
        return;
    }
    const clod_plan_table *table = find_table(self, test, is);
    const clod_number *kind = table != NULL ? number_of(self, test, table) : NULL;
    if (kind != NULL && !table->make(self, test, kind, &status)) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"), "%.800s",
                        status.text);
    }
}
