#include "sim/ring_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "clod/locus.h"
#include "output/folder_files.h"
#include "sim/ring_warnings.h"
#include "sim/warning_box.h"

#define PART_TEXT 256

static clod_locus_point point_of(const clod_part *part)
{
    const clod_ring_shear *t = part->test;
    return (clod_locus_point){
        .seed = part->seed,
        .sigma_p = t->preshear_stress,
        .tau_p = t->preshear_shear,
        .sigma_s = t->shear_stress,
        .tau_s = t->point_shear,
        .rho_b = t->preshear_density,
        .rho_inside = isfinite(t->preshear_inside) ? t->preshear_inside : 0.0,
        .tau_p_error = isfinite(t->preshear_error) ? t->preshear_error : 0.0,
        .tau_s_error = isfinite(t->point_error) ? t->point_error : 0.0,
    };
}

/** A number in its cell; one that is not known, 0, leaves it empty. */
static const char *cell_of(double value, char cell[32])
{
    cell[0] = '\0';
    if (value > 0.0) {
        snprintf(cell, 32, "%.9g", value);
    }
    return cell;
}

static bool write_points(const clod_folder *folder, const clod_locus_point *points, int count,
                         clod_status *status)
{
    const size_t size = 256 + 256 * (size_t)count;
    char *text = clod_memory_alloc(size, 1);
    if (text == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for points.csv");
    }
    int used = snprintf(text, size,
                        "seed,sigma_pre [Pa],tau_pre [Pa],sigma_sh [Pa],tau_sh [Pa],"
                        "rho_b [kg/m3],tau_pre_error [Pa],tau_sh_error [Pa],"
                        "rho_inside [kg/m3]\n");
    for (int p = 0; p < count; p++) {
        char of_p[32];
        char of_s[32];
        char inside[32];
        used += snprintf(
            text + used, size - (size_t)used, "%lld,%.9g,%.9g,%.9g,%.9g,%.9g,%s,%s,%s\n",
            (long long)points[p].seed, points[p].sigma_p, points[p].tau_p, points[p].sigma_s,
            points[p].tau_s, points[p].rho_b, cell_of(points[p].tau_p_error, of_p),
            cell_of(points[p].tau_s_error, of_s), cell_of(points[p].rho_inside, inside));
    }
    const bool ok = clod_folder_write(folder, "points.csv", text, status);
    clod_memory_free(text);
    return ok;
}

/** What went not as it should, in words. */
static json_t *flag_words(int64_t flags)
{
    static const clod_parts_flag WORDS[] = {{CLOD_RING_SHEAR_NOT_SETTLED, "not settled"},
                                            {CLOD_RING_SHEAR_NOT_STEADY, "not steady"},
                                            {CLOD_RING_SHEAR_NO_REVERSAL, "no reversal"},
                                            {CLOD_RING_SHEAR_NO_PEAK, "no peak"}};
    return clod_parts_flags(flags, WORDS, sizeof WORDS / sizeof *WORDS);
}

/** Whether preshear was steady, and how fast its shear stress changed where it ended. */
static void set_preshear(json_t *j, const clod_ring_shear *t)
{
    const bool steady = (t->flags & CLOD_RING_SHEAR_NOT_STEADY) == 0;
    json_object_set_new(j, "steady", json_boolean(steady));
    clod_parts_set_number(j, "shear_stress_rate_Pa_per_m", t->preshear_rate);
    clod_parts_set_number(j, "shear_stress_rate_error_Pa_per_m", t->preshear_rate_error);
}

static json_t *part_json(const clod_part *part)
{
    const clod_ring_shear *t = part->test;
    json_t *j = clod_parts_json(part);
    json_object_set_new(j, "flags", flag_words(t->flags));
    const bool point = part->point >= 0;
    clod_parts_set_number(j, "normal_stress_Pa", point ? t->shear_stress : t->preshear_stress);
    if (part->point == CLOD_RING_REVERSE) {
        return j; // no result of its own
    }
    clod_parts_set_number(j, "measured_normal_stress_Pa",
                          point ? t->point_normal : t->preshear_normal);
    clod_parts_set_number(j, "shear_stress_Pa", point ? t->point_shear : t->preshear_shear);
    if (!point) {
        set_preshear(j, t);
        clod_parts_set_number(j, "inside_density_kg_m3", t->preshear_inside);
    }
    clod_parts_set_number(j, "displacement_m",
                          point ? t->point_displacement : t->preshear_displacement);
    clod_parts_set_number(j, "bulk_density_kg_m3",
                          point ? t->point_density : t->preshear_density);
    clod_parts_set_number(j, "height_m", t->preshear_height);
    clod_parts_set_number(j, "hanger_force_N", t->hanger_force);
    return j;
}

static const clod_parts_locus SUMMARY = {"locus", part_json};

/** A line for every preshear; the length of the text. */
static int append_preshears(const clod_part *part, int parts, char *text, size_t size)
{
    int used = 0;
    for (int p = 0; p < parts; p++) {
        if (part[p].point == CLOD_RING_PRESHEAR) {
            char words[CLOD_RING_WORDS_SIZE];
            used += snprintf(text + used, size - (size_t)used, "%s: shear stress %s\n",
                             part[p].name, clod_ring_preshear_words(part[p].test, words));
        }
    }
    return used + snprintf(text + used, size - (size_t)used, "\n");
}

/** Title, how preshear ended, yield locus, warnings, cost: what the engineer asked for; owned,
 *  NULL without memory. */
static char *make_text(const clod_job_shared *sim, const clod_part *part, int parts,
                       const clod_locus_study *study, const json_t *warnings)
{
    char *table = clod_locus_table(study);
    const char *title = sim->from->title != NULL ? sim->from->title : "shear test";
    if (table == NULL) {
        return NULL;
    }
    const size_t size = 1024 + strlen(title) + strlen(table) + (size_t)parts * PART_TEXT +
                        clod_warning_box_size(warnings);
    char *text = clod_memory_alloc(size, 1);
    if (text != NULL) {
        int used = clod_parts_headline(part, parts, title, "preshear", text, size);
        used += append_preshears(part, parts, text + used, size - (size_t)used);
        snprintf(text + used, size - (size_t)used, "%s", table);
        clod_warning_box_append(text, size, warnings);
    }
    clod_locus_free(table);
    return text;
}

/** The shear points of finished parts; owned, NULL without memory. */
static clod_locus_point *points_of(const clod_part *part, int points)
{
    clod_locus_point *point = clod_memory_alloc((size_t)points + 1, sizeof *point);
    for (int p = 0; point != NULL && p < points; p++) {
        point[p] = point_of(&part[p]);
    }
    return point;
}

/** The evaluated points; NULL with a status that says what they lack. */
static clod_locus_study *evaluate(const clod_locus_point *point, int points,
                                  clod_status *status)
{
    clod_status why = {CLOD_OK, ""};
    clod_locus_study *study = clod_locus_study_create(point, (size_t)points, &why);
    if (study == NULL) {
        clod_status_fail(status, CLOD_FAILED,
                         "the test ran to its end, but its points give no yield locus: %s",
                         why.text);
    }
    return study;
}

bool clod_ring_report(const clod_job_shared *sim, const clod_part *part, int preparations,
                      int points, char **report, clod_status *status)
{
    clod_locus_point *point = points_of(part + preparations, points);
    json_t *warnings = clod_ring_warnings(sim->from, part, preparations + points);
    if (point == NULL || warnings == NULL) {
        clod_memory_free(point);
        json_decref(warnings);
        return clod_status_fail(status, CLOD_FAILED, "no memory for the report");
    }
    bool ok = write_points(sim->folder, point, points, status);
    clod_locus_study *study = ok ? evaluate(point, points, status) : NULL;
    ok =
        study != NULL && clod_parts_write_locus(sim, &SUMMARY, part, preparations + points,
                                                clod_locus_json(study), warnings, NULL, status);
    if (ok) {
        *report = make_text(sim, part, preparations + points, study, warnings);
    }
    clod_locus_study_destroy(&study);
    clod_memory_free(point);
    json_decref(warnings);
    return ok;
}

void clod_ring_report_finished(const clod_job_shared *sim, const clod_part *part,
                               int preparations, int points, const char *why)
{
    clod_part *done = clod_memory_alloc((size_t)preparations + (size_t)points, sizeof *done);
    const int before = done != NULL ? clod_parts_finished(part, preparations, done) : 0;
    if (before > 0) { // else nothing is known
        const int found = clod_parts_finished(part + preparations, points, done + before);
        clod_locus_point *point = points_of(done + before, found);
        json_t *warnings = clod_ring_warnings(sim->from, done, before + found);
        clod_status second; // of a test that failed already: the first failure is told
        if (point != NULL && write_points(sim->folder, point, found, &second) &&
            clod_parts_write_locus(sim, &SUMMARY, done, before + found, NULL, warnings, why,
                                   &second)) {
            clod_parts_tell_finished(sim, before + found, "points.csv");
        }
        json_decref(warnings);
        clod_memory_free(point);
    }
    clod_memory_free(done);
}
