#include "sim/wall_shear_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "clod/wall_locus.h"
#include "output/folder_files.h"
#include "sim/wall_shear_warnings.h"
#include "sim/warning_box.h"
#include "tester/wall_shear.h"

#define DEGREES (180.0 / M_PI)

typedef clod_wall_shear_point point;

/** Points of the shear parts; owned, NULL without memory. @param count  [out] */
static clod_wall_locus_point *points_of(const clod_part *part, int parts, size_t *count)
{
    const size_t most = (size_t)parts * CLOD_CASE_WALL_STRESSES + 1;
    clod_wall_locus_point *all = clod_memory_alloc(most, sizeof *all);
    *count = 0;
    for (int p = 0; all != NULL && p < parts; p++) {
        const clod_wall_shear *test = part[p].test;
        for (int64_t k = 0; part[p].point >= 0 && k < test->at; k++) {
            const point *from = &test->point[k];
            all[(*count)++] = (clod_wall_locus_point){.seed = part[p].seed,
                                                      .sigma = from->normal,
                                                      .tau = from->shear,
                                                      .sigma_error = from->normal_error,
                                                      .tau_error = from->shear_error,
                                                      .wall_stress = test->stresses[k],
                                                      .unsteady = from->steady == 0};
        }
    }
    return all;
}

/** A row of wall_friction.csv: clod locus and clod hopper read it. */
static void put_row(FILE *out, const clod_part *part, int64_t k)
{
    const clod_wall_shear *test = part->test;
    const point *from = &test->point[k];
    fprintf(out, "%lld,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%d\n", (long long)part->seed,
            test->stresses[k], from->normal, from->normal_error, from->shear, from->shear_error,
            DEGREES * atan2(from->shear, from->normal), from->density, from->displacement,
            from->steady != 0);
}

static bool write_table(const clod_folder *folder, const clod_part *part, int parts,
                        clod_status *status)
{
    clod_text table;
    FILE *out = clod_text_open(&table);
    if (out == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for wall_friction.csv");
    }
    fputs("seed,wall_stress [Pa],sigma_w [Pa],sigma_w_error [Pa],tau_w [Pa],tau_w_error [Pa],"
          "phi_x [deg],rho_b [kg/m3],displacement [m],steady [1]\n",
          out);
    for (int p = 0; p < parts; p++) {
        const clod_wall_shear *test = part[p].test;
        for (int64_t k = 0; part[p].point >= 0 && k < test->at; k++) {
            put_row(out, &part[p], k);
        }
    }
    char *text = clod_text_close(&table);
    const bool ok = clod_folder_write(folder, "wall_friction.csv", text, status);
    clod_memory_free(text);
    return ok;
}

// ---- summary

/** What went not as it should, in words. */
static json_t *flag_words(int64_t flags)
{
    static const clod_parts_flag WORDS[] = {{CLOD_WALL_SHEAR_NOT_SETTLED, "not settled"},
                                            {CLOD_WALL_SHEAR_NOT_STEADY, "not steady"}};
    return clod_parts_flags(flags, WORDS, sizeof WORDS / sizeof *WORDS);
}

static json_t *point_json(const clod_wall_shear *test, int64_t k)
{
    const point *from = &test->point[k];
    const struct {
        const char *key;
        double value;
    } NUMBERS[] = {{"wall_stress_Pa", test->stresses[k]},
                   {"normal_stress_Pa", from->normal},
                   {"normal_stress_error_Pa", from->normal_error},
                   {"shear_stress_Pa", from->shear},
                   {"shear_stress_error_Pa", from->shear_error},
                   {"shear_stress_rate_Pa_per_m", from->rate},
                   {"shear_stress_rate_error_Pa_per_m", from->rate_error},
                   {"displacement_m", from->displacement},
                   {"height_m", from->height},
                   {"bulk_density_kg_m3", from->density}};
    json_t *j = json_object();
    for (size_t n = 0; n < sizeof NUMBERS / sizeof *NUMBERS; n++) {
        clod_parts_set_number(j, NUMBERS[n].key, NUMBERS[n].value);
    }
    json_object_set_new(j, "steady", json_boolean(from->steady != 0));
    return j;
}

static json_t *part_json(const clod_part *part)
{
    const clod_wall_shear *test = part->test;
    json_t *j = clod_parts_json(part);
    json_object_set_new(j, "flags", flag_words(test->flags));
    if (part->point >= 0) {
        json_t *list = json_array();
        for (int64_t k = 0; k < test->at; k++) {
            json_array_append_new(list, point_json(test, k));
        }
        json_object_set_new(j, "stresses", list);
    }
    return j;
}

static const clod_parts_locus SUMMARY = {"wall_locus", part_json};

// ---- text

/** Title, wall yield locus, warnings: what the engineer asked for; owned, NULL without memory. */
static char *make_text(const clod_job_shared *sim, const clod_part *part, int parts,
                       const clod_wall_locus *locus, const json_t *warnings)
{
    char *table = clod_wall_locus_table(locus);
    const char *title = sim->from->title != NULL ? sim->from->title : "wall friction test";
    if (table == NULL) {
        return NULL;
    }
    const size_t size = 1024 + strlen(title) + strlen(table) + clod_warning_box_size(warnings);
    char *text = clod_memory_alloc(size, 1);
    if (text != NULL) {
        const int used = clod_parts_headline(part, parts, title, "filling", text, size);
        snprintf(text + used, size - (size_t)used, "%s", table);
        clod_warning_box_append(text, size, warnings);
    }
    clod_locus_free(table);
    return text;
}

static bool evaluate(const clod_part *part, int parts, clod_wall_locus *locus,
                     clod_status *status)
{
    size_t count;
    clod_status why = {CLOD_OK, ""};
    clod_wall_locus_point *all = points_of(part, parts, &count);
    const bool ok = all != NULL && clod_wall_locus_evaluate(all, count, locus, &why);
    clod_memory_free(all);
    return ok || clod_status_fail(status, CLOD_FAILED,
                                  "the test ran to its end, but its points give no wall yield "
                                  "locus: %s",
                                  all == NULL ? "no memory" : why.text);
}

bool clod_wall_shear_report(const clod_job_shared *sim, const clod_part *part, int seeds,
                            char **report, clod_status *status)
{
    const int parts = 2 * seeds;
    clod_wall_locus locus = {0};
    json_t *warnings = clod_wall_shear_warnings(sim->from, part, parts);
    if (warnings == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the report");
    }
    const bool ok =
        write_table(sim->folder, part, parts, status) &&
        evaluate(part, parts, &locus, status) &&
        clod_parts_write_locus(sim, &SUMMARY, part, parts, clod_wall_locus_json(&locus),
                               warnings, NULL, status);
    if (ok) {
        *report = make_text(sim, part, parts, &locus, warnings);
    }
    clod_wall_locus_fini(&locus);
    json_decref(warnings);
    return ok;
}

void clod_wall_shear_report_finished(const clod_job_shared *sim, const clod_part *part,
                                     int seeds, const char *why)
{
    clod_part *done = clod_memory_alloc(2 * (size_t)seeds, sizeof *done);
    const int found = done != NULL ? clod_parts_finished(part, 2 * seeds, done) : 0;
    if (found > 0) {
        json_t *warnings = clod_wall_shear_warnings(sim->from, done, found);
        clod_status second; // of a test that failed already: the first failure is told
        if (warnings != NULL && write_table(sim->folder, done, found, &second) &&
            clod_parts_write_locus(sim, &SUMMARY, done, found, NULL, warnings, why, &second)) {
            clod_parts_tell_finished(sim, found, "wall_friction.csv");
        }
        json_decref(warnings);
    }
    clod_memory_free(done);
}
