#include "sim/uniaxial_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "clod/locus.h"
#include "output/folder_files.h"
#include "sim/uniaxial_warnings.h"
#include "sim/warning_box.h"
#include "tester/uniaxial.h"

#define ROW_TEXT 256

/** sigma_1/sigma_c; infinite for a solid that does not stand by itself. */
static double flowability(const clod_uniaxial *t)
{
    return t->strength > 0.0 ? t->sigma_1 / t->strength : (double)INFINITY;
}

static double void_ratio(const clod_uniaxial *t)
{
    return 1.0 / t->solid_fraction - 1.0;
}

/** flow_function.csv; ffc is `inf` for a strength of 0. */
static bool write_table(const clod_folder *folder, const clod_part *part, int points,
                        clod_status *status)
{
    const size_t size = ROW_TEXT * (2 + (size_t)points);
    char *text = clod_memory_alloc(size, 1);
    if (text == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for flow_function.csv");
    }
    int used = snprintf(text, size,
                        "consolidation_stress [Pa],sigma_1 [Pa],sigma_1_base [Pa],"
                        "rho_b [kg/m3],solid_fraction [1],void_ratio [1],sigma_c [Pa],"
                        "sigma_c_error [Pa],sigma_c_base [Pa],strain_at_peak [1],ffc [1],"
                        "rho_inside [kg/m3]\n");
    for (int p = 0; p < points; p++) {
        const clod_uniaxial *t = part[p].test;
        char inside[24] = ""; // of a mould that is too narrow
        if (isfinite(t->inside)) {
            snprintf(inside, sizeof inside, "%.9g", t->inside);
        }
        used += snprintf(text + used, size - (size_t)used,
                         "%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%s\n",
                         t->stress, t->sigma_1, t->sigma_base, t->density, t->solid_fraction,
                         void_ratio(t), t->strength, t->strength_error, t->strength_base,
                         t->peak_strain, flowability(t), inside);
    }
    const bool ok = clod_folder_write(folder, "flow_function.csv", text, status);
    clod_memory_free(text);
    return ok;
}

/** What went not as it should, in words. */
static json_t *flag_words(int64_t flags)
{
    static const clod_parts_flag WORDS[] = {
        {CLOD_UNIAXIAL_NOT_SETTLED, "not settled"},
        {CLOD_UNIAXIAL_NOT_FREE, "not at rest without the mould"},
        {CLOD_UNIAXIAL_NO_PEAK, "no peak"},
        {CLOD_UNIAXIAL_COLLAPSED, "collapsed"}};
    return clod_parts_flags(flags, WORDS, sizeof WORDS / sizeof *WORDS);
}

static json_t *point_json(const clod_part *part)
{
    const clod_uniaxial *t = part->test;
    const struct {
        const char *key;
        double value;
    } NUMBERS[] = {{"consolidation_stress_Pa", t->stress},
                   {"sigma_1_Pa", t->sigma_1},
                   {"sigma_1_base_Pa", t->sigma_base},
                   {"bulk_density_kg_m3", t->density},
                   {"inside_density_kg_m3", t->inside},
                   {"solid_fraction", t->solid_fraction},
                   {"void_ratio", void_ratio(t)},
                   {"height_m", t->height},
                   {"unloaded_height_m", t->unloaded_height},
                   {"sigma_c_Pa", t->strength},
                   {"sigma_c_error_Pa", t->strength_error},
                   {"sigma_c_base_Pa", t->strength_base},
                   {"strain_at_peak", t->peak_strain},
                   {"ffc", flowability(t)}};
    json_t *j =
        json_pack("{s:s, s:s}", "part", part->name, "errors_note", CLOD_LOCUS_ONE_SPECIMEN);
    for (size_t k = 0; k < sizeof NUMBERS / sizeof *NUMBERS; k++) {
        clod_parts_set_number(j, NUMBERS[k].key, NUMBERS[k].value);
    }
    return j;
}

static bool write_summary(const clod_job_shared *sim, const clod_part *part, int points,
                          json_t *warnings, const char *why, clod_status *status)
{
    json_t *list = json_array();
    json_t *results = json_array();
    bool ok = true;
    for (int p = 0; ok && p < 1 + points; p++) {
        const clod_uniaxial *t = part[p].test;
        json_t *j = clod_parts_json(&part[p]);
        json_object_set_new(j, "flags", flag_words(t->flags));
        ok = clod_parts_put_measures(j, sim, &part[p], status);
        json_array_append_new(list, j);
        if (p > 0) {
            json_array_append_new(results, point_json(&part[p]));
        }
    }
    if (!ok) {
        json_decref(list);
        json_decref(results);
        return false;
    }
    return clod_parts_write_summary(sim, list, "flow_function", results, warnings, why, status);
}

static int table_row(const clod_uniaxial *t, char *text, size_t size)
{
    char ffc[24] = "-";
    if (isfinite(flowability(t))) {
        snprintf(ffc, sizeof ffc, "%.2f", flowability(t));
    }
    char inside[24] = "-";
    if (isfinite(t->inside)) {
        snprintf(inside, sizeof inside, "%.0f", t->inside);
    }
    return snprintf(text, size, "  %10.3f %10.0f %7s %9.3f %9.3f %10.3f ± %6.3f %9.2f %7s\n",
                    1e-3 * t->sigma_1, t->density, inside, t->solid_fraction, void_ratio(t),
                    1e-3 * t->strength, 1e-3 * t->strength_error, 100.0 * t->peak_strain, ffc);
}

/** Title, flow function, warnings: what the engineer asked for. */
static char *make_text(const clod_job_shared *sim, const clod_part *part, int points,
                       const json_t *warnings)
{
    const char *title = sim->from->title != NULL ? sim->from->title : "uniaxial test";
    const size_t size =
        1024 + strlen(title) + ROW_TEXT * (size_t)points + clod_warning_box_size(warnings);
    char *text = clod_memory_alloc(size, 1);
    if (text == NULL) {
        return NULL;
    }
    int used = clod_parts_headline(part, points + 1, title, "filling", text, size);
    used += snprintf(
        text + used, size - (size_t)used,
        "Flow function of %d consolidation%s, stresses of the lid\n\n"
        "     sigma_1      rho_b  inside  solid fr.   void r.           sigma_c     strain "
        "    ffc\n"
        "       [kPa]    [kg/m3] [kg/m3]       [1]       [1]             [kPa]        [%%] "
        "    [1]\n",
        points, points > 1 ? "s" : "");
    for (int p = 1; p <= points; p++) {
        used += table_row(part[p].test, text + used, size - (size_t)used);
    }
    snprintf(text + used, size - (size_t)used,
             "\n  ± one standard error of the smoothed peak;\n  " CLOD_LOCUS_ONE_SPECIMEN
             ".\n");
    clod_warning_box_append(text, size, warnings);
    return text;
}

bool clod_uniaxial_report(const clod_job_shared *sim, const clod_part *part, int points,
                          char **report, clod_status *status)
{
    json_t *warnings = clod_uniaxial_warnings(sim->from, part, points + 1);
    if (warnings == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the report");
    }
    const bool ok = write_table(sim->folder, part + 1, points, status) &&
                    write_summary(sim, part, points, warnings, NULL, status);
    if (ok) {
        *report = make_text(sim, part, points, warnings);
    }
    json_decref(warnings);
    return ok;
}

void clod_uniaxial_report_finished(const clod_job_shared *sim, const clod_part *part,
                                   int points, const char *why)
{
    clod_part *done = clod_memory_alloc((size_t)points + 1, sizeof *done);
    const int found = done != NULL ? clod_parts_finished(part, points + 1, done) : 0;
    if (found > 0) { // the filling, from which all others begin, is the first
        json_t *warnings = clod_uniaxial_warnings(sim->from, done, found);
        clod_status second; // of a test that failed already: the first failure is told
        if (warnings != NULL && write_table(sim->folder, done + 1, found - 1, &second) &&
            write_summary(sim, done, found - 1, warnings, why, &second)) {
            clod_parts_tell_finished(sim, found, "flow_function.csv");
        }
        json_decref(warnings);
    }
    clod_memory_free(done);
}
