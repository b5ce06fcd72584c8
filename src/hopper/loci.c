#include "hopper/loci.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "analysis/angles.h"
#include "base/memory.h"
#include "clod/locus.h"

/** A value with its standard error; what is not known is 0. */
static void put(clod_curve_point *point, clod_locus_value value)
{
    point->y = isfinite(value.value) ? value.value : 0.0;
    point->y_error = isfinite(value.error) ? value.error : 0.0;
}

/** What clod locus says about a yield locus. */
static void take_notes(const clod_locus *locus, clod_tables_notes *notes)
{
    const char *specimen = clod_locus_specimen_note(locus);
    notes->specimen = specimen != NULL ? specimen : notes->specimen;
    notes->preshear_untold = notes->preshear_untold || locus->preshear_untold;
    for (size_t k = 0; k < locus->warning_count; k++) {
        clod_warning_list_add(notes->warnings,
                              "Yield locus at a preshear stress of %.3f kPa: %s",
                              1e-3 * locus->sigma_p.value, locus->warnings[k]);
    }
}

/** Refuse a yield locus without a strength, and say why it has none. */
static bool has_strength(const clod_locus *locus, clod_status *status)
{
    return !isnan(locus->sigma_c.value) ||
           clod_status_fail(status, CLOD_USAGE,
                            "The yield locus at a preshear stress of %.3f kPa has no "
                            "unconfined yield strength (its cohesion is below 0); "
                            "clod locus says more about its points.",
                            1e-3 * locus->sigma_p.value);
}

/** Refuse loci of which none has phi_e, where nothing else gives it. */
static bool has_phi_e(const clod_locus_study *study, clod_status *status)
{
    const clod_locus *first = &study->groups[0].locus;
    for (size_t g = 0; g < study->count; g++) {
        if (isfinite(study->groups[g].locus.phi_e.value)) {
            return true;
        }
    }
    return clod_status_fail(status, CLOD_USAGE,
                            "phi_e is undefined in every yield locus, since sigma_2 is tension "
                            "(%.3f kPa at a preshear stress of %.3f kPa): their shear stresses "
                            "are too large for their normal stresses. Check the columns and "
                            "units of the points, or give the key effective_friction.",
                            1e-3 * first->sigma_2.value, 1e-3 * first->sigma_p.value);
}

/** What the specimens of each locus share, in all its values at once. */
static bool share(const clod_locus_study *study, clod_loci *self, clod_status *status)
{
    clod_specimens *of = &self->specimens;
    if (!clod_specimens_of(study, of)) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the specimens.");
    }
    for (size_t g = 0; g < study->count && of->spread != NULL; g++) {
        clod_loci_row *to = &self->rows[g];
        if (study->groups[g].seed_count > 1) {
            to->strength.x_spread = clod_specimens_at(of, g, CLOD_SPECIMENS_SIGMA_1);
            to->strength.spread = clod_specimens_at(of, g, CLOD_SPECIMENS_STRENGTH);
            to->phi_e.spread = clod_specimens_at(of, g, CLOD_SPECIMENS_PHI_E);
            to->phi_t.spread = clod_specimens_at(of, g, CLOD_SPECIMENS_PHI_T);
            to->rho.spread = clod_specimens_at(of, g, CLOD_SPECIMENS_RHO);
        }
    }
    return true;
}

bool clod_loci_join(clod_loci_row *row)
{
    clod_curve_point *points[] = {&row->strength, &row->phi_e, &row->phi_t};
    double error[CLOD_CURVE_JOINT] = {row->strength.x_error};
    double part[CLOD_CURVE_JOINT][CLOD_CURVE_JOINT];
    bool known = false;
    for (size_t k = 0; k < CLOD_JOINT_PAIRS; k++) {
        known = known || !isnan(row->correlation[k]);
    }
    for (size_t k = 0; k < sizeof points / sizeof points[0]; k++) {
        error[k + 1] = points[k]->y > 0.0 || k == 0 ? points[k]->y_error : 0.0;
    }
    if (!known) {
        return true;
    }
    if (!clod_joint_factor(error, row->correlation, part)) {
        return false;
    }
    for (size_t k = 0; k < sizeof points / sizeof points[0]; k++) {
        points[k]->joint = true;
        memcpy(points[k]->part, part[k + 1], sizeof points[k]->part);
    }
    return true;
}

/** The errors of a locus of one specimen, which come of the same points. */
static void join(const clod_locus *locus, clod_loci_row *row)
{
    memcpy(row->correlation, locus->correlation, sizeof row->correlation);
    (void)clod_loci_join(row); // clod locus propagates errors: its correlations have some
}

/** Rows of the loci of a study. */
static bool rows_of(const clod_locus_study *study, bool brings_phi_e, clod_loci *self,
                    clod_tables_notes *notes, clod_status *status)
{
    clod_loci_row *rows = self->rows = clod_memory_alloc(study->count, sizeof *rows);
    if (rows == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the loci.");
    }
    bool good = true;
    for (size_t g = 0; g < study->count && good; g++) {
        const clod_locus *locus = &study->groups[g].locus;
        good = has_strength(locus, status);
        put(&rows[g].strength, locus->sigma_c);
        put(&rows[g].phi_e, locus->phi_e);
        put(&rows[g].phi_t, locus->phi_lin);
        put(&rows[g].rho, locus->rho_b);
        rows[g].rho.inside = isfinite(locus->rho_inside.value) ? locus->rho_inside.value : 0.0;
        rows[g].strength.x = locus->sigma_1.value;
        rows[g].strength.x_error = isfinite(locus->sigma_1.error) ? locus->sigma_1.error : 0.0;
        rows[g].strength.unsure = true;
        join(locus, &rows[g]);
        take_notes(locus, notes);
    }
    if (study->warning[0] != '\0') {
        clod_warning_list_add(notes->warnings, "Flow function: %s", study->warning);
    }
    self->count = study->count;
    return good && (!brings_phi_e || has_phi_e(study, status)) && share(study, self, status);
}

bool clod_loci_find(const char *path, const char *table, char inside[PATH_MAX],
                    clod_status *status)
{
    struct stat kind;
    const bool folder = stat(path, &kind) == 0 && S_ISDIR(kind.st_mode);
    snprintf(inside, PATH_MAX, "%s%s%s", path, folder ? "/" : "", folder ? table : "");
    return !folder || stat(inside, &kind) == 0 ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: the folder has no %s: its run is not finished, or is no test "
               "that writes one. clod run goes on with a run that is not finished.",
               path, table);
}

/** Points of all tests, and the files that they come from. */
typedef struct tests {
    char (*paths)[PATH_MAX];     ///< [count] owned
    clod_angles_source *sources; ///< [count] owned
    size_t count;
    clod_locus_point *points; ///< [point_count] owned
    size_t point_count;
} tests;

static void tests_fini(tests *self)
{
    clod_memory_free(self->paths);
    clod_memory_free(self->sources);
    clod_memory_free(self->points);
}

/** Append the points of a test: of the file, or of points.csv in a results folder. */
static bool add_test(tests *self, const char *path, clod_status *status)
{
    char *inside = self->paths[self->count];
    clod_locus_point *points;
    size_t more;
    if (!clod_loci_find(path, "points.csv", inside, status) ||
        !clod_locus_read(inside, NULL, &points, &more, status)) {
        return false;
    }
    const size_t count = self->point_count;
    clod_locus_point *grown =
        clod_memory_grow(self->points, count, count + more, sizeof *grown);
    if (grown == NULL) {
        clod_locus_free(points);
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", more);
    }
    for (size_t i = 0; i < more; i++) {
        grown[count + i] = points[i];
    }
    clod_locus_free(points);
    self->points = grown;
    self->point_count += more;
    self->sources[self->count++] = (clod_angles_source){inside, self->point_count};
    return true;
}

static bool read_tests(tests *self, const clod_hopper_strength *from, clod_status *status)
{
    self->paths = clod_memory_alloc(from->test_count, sizeof *self->paths);
    self->sources = clod_memory_alloc(from->test_count, sizeof *self->sources);
    if (self->paths == NULL || self->sources == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu tests.",
                                from->test_count);
    }
    for (size_t t = 0; t < from->test_count; t++) {
        if (!add_test(self, from->tests[t].points, status)) {
            return false;
        }
    }
    return true;
}

/** The loci of all points together. */
static bool evaluate(const tests *self, const clod_hopper_case *of, clod_loci *loci,
                     clod_tables_notes *notes, clod_status *status)
{
    clod_status why = {0};
    bool good = false;
    clod_locus_study *study = clod_locus_study_create(self->points, self->point_count, &why);
    if (study == NULL ||
        clod_angles_check(study, self->points, self->sources, self->count, status)) {
        good = study != NULL && rows_of(study, !of->phi_e.present, loci, notes, &why);
        if (!good) { // of several files: the preshear stress says which
            clod_status_fail(status, why.code, "%s%s: %s", of->strength.tests[0].points,
                             self->count > 1 ? " and those after it" : "", why.text);
        }
    }
    clod_locus_study_destroy(&study);
    return good;
}

bool clod_loci_read(const clod_hopper_case *of, clod_loci *loci, clod_tables_notes *notes,
                    clod_status *status)
{
    tests all = {0};
    *loci = (clod_loci){0};
    const bool good =
        read_tests(&all, &of->strength, status) && evaluate(&all, of, loci, notes, status);
    tests_fini(&all);
    return good;
}

void clod_loci_fini(clod_loci *self)
{
    clod_memory_free(self->rows);
    clod_specimens_fini(&self->specimens);
    *self = (clod_loci){0};
}
