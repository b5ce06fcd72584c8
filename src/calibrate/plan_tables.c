/**
 * @file plan_tables.c
 * Targets of a plan from measured tables: which table it is, wall yield loci.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/measured_header.h"
#include "base/input.h"
#include "base/memory.h"
#include "calibrate/plan_samples.h"
#include "calibrate/test_kinds.h"
#include "clod/measured.h"

typedef clod_plan_maker maker;
typedef clod_plan_sample sample;

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
        const double stated = clod_plan_samples_largest(&list);
        clod_plan_samples_merge(&list, common.error);
        clod_plan_samples_warn_alike(self, &list);
        if (clod_wall_locus_one_specimen(locus)) {
            clod_plan_samples_warn_one(self, &common, stated, CLOD_LOCUS_ONE_SPECIMEN);
        }
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
    const bool good = clod_wall_locus_of_table(points, count, &locus, status);
    clod_locus_free(points);
    if (good) {
        make_angles(self, test, kind, &locus);
        for (size_t k = 0; k < locus.warning_count; k++) {
            clod_plan_samples_warn(self, locus.warnings[k]);
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
    [CLOD_PLAN_IS_NONE] = {"none of the columns sigma_sh, sigma_w, sigma_1 and angle_of_repose",
                           ""},
    [CLOD_PLAN_IS_SHEAR] = {"sigma_sh or tau_sh", "shear points (sigma_sh, tau_sh)"},
    [CLOD_PLAN_IS_WALL] = {"sigma_w or tau_w", "a wall yield locus (sigma_w, tau_w)"},
    [CLOD_PLAN_IS_DENSITY] = {"sigma_1", "bulk densities (sigma_1, rho_b)"},
    [CLOD_PLAN_IS_FLOW] = {"sigma_1", "a flow function (sigma_1, sigma_c)"},
    [CLOD_PLAN_IS_REPOSE] = {"angle_of_repose", "angles of repose (angle_of_repose)"},
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
        [CLOD_MEASURED_OF_REPOSE] = CLOD_PLAN_IS_REPOSE,
    };
    const clod_measured_kind kind = clod_measured_kind_of(text, length);
    const clod_measured_stress stress = clod_measured_stress_of(text, length);
    clod_memory_free(text);
    if (!clod_measured_header_check(path, stress, status)) {
        return false;
    }
    *is = kind == CLOD_MEASURED_DENSITY  ? CLOD_PLAN_IS_DENSITY
          : kind == CLOD_MEASURED_REPOSE ? CLOD_PLAN_IS_REPOSE
                                         : BY_STRESS[stress];
    return true;
}

/** The kind of table that a file is, among those of its test; NULL after a complaint. */
static const clod_plan_table *find_table(maker *self, size_t test, clod_plan_is is)
{
    const clod_test_kind *kind = clod_test_kinds_of(self->plan->tests[test].middle);
    char list[300] = "";
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

/** What stands before a number in a list of them. */
static const char *separator(const char *const *numbers, size_t k)
{
    const bool last = k + 1 == CLOD_PLAN_TABLE_NUMBERS || numbers[k + 1] == NULL;
    return k == 0 ? "" : last ? " or " : ", ";
}

/** The angle of repose that the plan names; NULL after a complaint. */
static const clod_number *angle_named(maker *self, size_t test)
{
    if (self->wish->number == NULL) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, ""),
                        "needs the key number: which angle of test %s it is, "
                        "repose.NAME.angle_deg where its case has repose: {NAME: ...}",
                        self->wish->test);
        return NULL;
    }
    const clod_number *kind = clod_plan_targets_number(self, test);
    if (kind != NULL && !clod_number_path_is_repose(kind)) {
        clod_check_fail(
            self->loader, clod_plan_targets_at(self, "number"),
            "%s is no angle of repose, which the table has; it is repose.NAME.angle_deg, of a heap at the end "
            "of a run, or repose.NAME.mean_deg, over its steady time",
            self->wish->number);
        return NULL;
    }
    return kind;
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
    if (table->any_angle) {
        return angle_named(self, test);
    }
    const char *number = wish->number != NULL ? wish->number : numbers[0];
    // rho_b of a laboratory, whose cell is wide, is that away from the walls of a simulated one
    const char *column = strcmp(number, "rho_inside") == 0 ? "rho_b" : number;
    char list[80] = "";
    size_t used = 0;
    for (size_t k = 0; k < CLOD_PLAN_TABLE_NUMBERS && numbers[k] != NULL; k++) {
        if (strcmp(column, numbers[k]) == 0) {
            return clod_number_find(&self->plan->tests[test], number);
        }
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", separator(numbers, k),
                                 numbers[k]);
    }
    clod_check_fail(self->loader, clod_plan_targets_at(self, "number"),
                    "%s is none of %s; of such a table it is %s", wish->number,
                    WORDS[table->is].what, list);
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
