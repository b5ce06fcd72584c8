/**
 * @file shear_lab.c
 * Points of a laboratory, evaluated as those of a simulation are.
 */

#include <math.h>

#include "analysis/study_file.h"
#include "clod/locus.h"
#include "report/shear.h"
#include "report/shear_rows.h"

#define SAME 0.05 ///< share by which preshear stresses that are meant to be the same may differ

json_t *clod_shear_lab(const char *path, clod_status *status)
{
    clod_locus_study *study = clod_study_of_file(path, status);
    char *text = study != NULL ? clod_locus_json(study) : NULL;
    json_t *all = text != NULL ? json_loads(text, 0, NULL) : NULL;
    if (study != NULL && all == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the laboratory's points.");
    }
    clod_locus_free(text);
    clod_locus_study_destroy(&study);
    return all;
}

/** The preshear stress of a study that is nearest to another one, in ratio; NaN: it has none. */
static double nearest_of(const json_t *study, double wanted)
{
    double nearest = (double)NAN;
    const json_t *locus;
    for (size_t g = 0; (locus = clod_shear_locus(study, g)) != NULL; g++) {
        const double stress = clod_shear_number(locus, "sigma_p_Pa");
        if (!(fabs(log(stress / wanted)) >= fabs(log(nearest / wanted)))) {
            nearest = stress;
        }
    }
    return nearest;
}

/** Whether there are loci of the same preshear stress on both sides. */
static bool have_one_in_common(const json_t *study, const json_t *lab)
{
    bool found = false;
    const json_t *locus;
    for (size_t g = 0; (locus = clod_shear_locus(lab, g)) != NULL && !found; g++) {
        const double stress = clod_shear_number(locus, "sigma_p_Pa");
        found = fabs(nearest_of(study, stress) / stress - 1.0) <= SAME;
    }
    return found;
}

size_t clod_shear_lab_warnings(FILE *out, const clod_run_files *run, const json_t *lab)
{
    const json_t *study = json_object_get(run->summary, "locus");
    size_t count = 0;
    const json_t *locus;
    if (have_one_in_common(study, lab)) { // tables name the preshear stress of each
        return 0;
    }
    for (size_t g = 0; (locus = clod_shear_locus(lab, g)) != NULL; g++) {
        const double stress = clod_shear_number(locus, "sigma_p_Pa");
        const double own = nearest_of(study, stress);
        char text[320];
        if (isnan(own)) {
            continue;
        }
        snprintf(
            text, sizeof text,
            "The laboratory's points are at a preshear stress of %.3f kPa, the run's at "
            "%.3f kPa: strength, cohesion, angles and density belong to the preshear stress "
            "and cannot be compared across it.",
            1e-3 * stress, 1e-3 * own);
        fprintf(out, "%s%c", text, '\0');
        count++;
    }
    return count;
}

/** Whether a locus of a study tells a number. */
static bool tells(const json_t *study, const char *key)
{
    bool found = false;
    const json_t *locus;
    for (size_t g = 0; (locus = clod_shear_locus(study, g)) != NULL && !found; g++) {
        found = isfinite(clod_shear_number(locus, key));
    }
    return found;
}

static bool one_tells_inside(const clod_run_files *runs, size_t count)
{
    bool found = false;
    for (size_t k = 0; k < count && !found; k++) {
        found = tells(json_object_get(runs[k].summary, "locus"), "rho_inside_kg_m3");
    }
    return found;
}

/** Tell how far the density of a run is off that of a laboratory, which is a JSON object of its own. */
static void set_off(json_t *locus, const json_t *own, const char *key)
{
    json_t *measured = json_object_get(locus, key);
    const double value = clod_shear_number(locus, key), theirs = clod_shear_number(own, key);
    const double ratio = theirs / value;
    const double error = clod_shear_number(measured, "error");
    const double their_error = clod_shear_number(json_object_get(own, key), "error");
    if (isfinite(ratio)) {
        json_object_set_new(measured, "off", json_real(ratio - 1.0));
    }
    if (isfinite(ratio * error) && isfinite(their_error)) {
        json_object_set_new(measured, "off_error",
                            json_real(hypot(their_error, ratio * error) / value));
    }
}

/** The locus of a study at a preshear stress; NULL: it has none there. */
static const json_t *locus_at(const json_t *study, double stress)
{
    const json_t *locus;
    for (size_t g = 0; (locus = clod_shear_locus(study, g)) != NULL; g++) {
        if (fabs(clod_shear_number(locus, "sigma_p_Pa") / stress - 1.0) <= SAME) {
            return locus;
        }
    }
    return NULL;
}

json_t *clod_shear_lab_beside(const json_t *lab, const clod_run_files *runs, size_t count)
{
    const bool inside = one_tells_inside(runs, count);
    json_t *self = json_deep_copy(lab);
    json_t *locus;
    size_t g;
    json_array_foreach(json_object_get(self, "loci"), g, locus)
    {
        const json_t *own = count == 1 ? locus_at(json_object_get(runs->summary, "locus"),
                                                  clod_shear_number(locus, "sigma_p_Pa"))
                                       : NULL;
        if (inside && !isfinite(clod_shear_number(locus, "rho_inside_kg_m3"))) {
            json_t *copy = json_deep_copy(json_object_get(locus, "rho_b_kg_m3"));
            json_object_set_new(locus, "rho_inside_kg_m3", copy);
        }
        set_off(locus, own, "rho_b_kg_m3");
        set_off(locus, own, "rho_inside_kg_m3");
    }
    return self;
}

void clod_shear_lab_density(clod_writer out, const json_t *lab, const clod_run_files *runs,
                            size_t count)
{
    if (lab == NULL || !tells(lab, "rho_b_kg_m3")) {
        return;
    }
    clod_writer_mark(out, "<p class=\"note\">", "");
    if (!one_tells_inside(runs, count)) {
        clod_writer_words(
            out,
            "$rho_b$ of the simulation is of its whole cell, and grains at walls are packed more "
            "loosely: compare it with the laboratory's only if that is of a cell with as few "
            "grains across. The simulated cell has too few to tell $rho_inside$, the density "
            "away from its walls.");
    } else if (tells(lab, "rho_inside_kg_m3")) {
        clod_writer_text(out,
                         "The laboratory's table has both densities: each stands beside the "
                         "simulation's of the same name.");
    } else {
        clod_writer_text(out, "The laboratory's bulk density stands beside both of the "
                              "simulation, of which one is to be compared with it. ");
        clod_writer_mark(out, "<strong>", "");
        clod_writer_text(out, "If its grains are far smaller than its cell");
        clod_writer_mark(out, "</strong>", "");
        clod_writer_words(out,
                          ", as those of a powder, that is $rho_inside$: $rho_b$ is of the "
                          "whole simulated cell, and grains at walls are packed more "
                          "loosely. ");
        clod_writer_mark(out, "<strong>", "");
        clod_writer_text(out, "If its cell has as few grains across as the simulated one");
        clod_writer_mark(out, "</strong>", "");
        clod_writer_words(out, ", it is $rho_b$.");
    }
    clod_writer_mark(out, "</p>\n", "\n");
}
