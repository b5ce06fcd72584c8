/**
 * @file export.c
 * Results of shear tests for programs: JSON with everything, CSV with one row per
 * consolidation.
 */

#include <jansson.h>
#include <math.h>
#include <stdio.h>

#include "analysis/cells.h"
#include "analysis/fields.h"
#include "base/given.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"

#define DEGREES (180.0 / 3.14159265358979323846)

static const struct {
    double scale;
    const char *suffix; ///< of names in JSON
    const char *unit;   ///< in the header of a CSV
} UNITS[] = {
    [CLOD_FIELD_STRESS] = {1.0, "_Pa", " [Pa]"},
    [CLOD_FIELD_ANGLE] = {DEGREES, "_deg", " [deg]"},
    [CLOD_FIELD_NUMBER] = {1.0, "", " [1]"},
    [CLOD_FIELD_DENSITY] = {1.0, "_kg_m3", " [kg/m3]"},
};

/** A number; null when it is none, for JSON has no NAN and no INFINITY. */
static json_t *number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

static json_t *circle(clod_locus_circle from)
{
    return json_pack("{s:o, s:o}", "centre_Pa", number(from.centre), "radius_Pa",
                     number(from.radius));
}

static json_t *marks_of(const clod_locus *locus)
{
    json_t *list = json_array();
    for (size_t i = 0; i < locus->point_count; i++) {
        const clod_locus_mark *mark = &locus->marks[i];
        json_array_append_new(
            list, json_pack("{s:I, s:f, s:f, s:o, s:f, s:f}", "seed", (json_int_t)mark->seed,
                            "sigma_s_Pa", mark->sigma, "tau_s_Pa", mark->measured,
                            "tau_s_error_Pa", number(clod_cells_error(mark->error)),
                            "prorated_Pa", mark->prorated, "line_Pa", mark->line));
    }
    return list;
}

static json_t *warnings_of(const clod_locus *locus)
{
    json_t *list = json_array();
    for (size_t i = 0; i < locus->warning_count; i++) {
        json_array_append_new(list, json_string(locus->warnings[i]));
    }
    return list;
}

/** Correlations of the errors: {"sigma_1_sigma_c": 0.9, ...}. */
static json_t *correlations_of(const clod_locus *locus)
{
    json_t *self = json_object();
    for (size_t k = 0; k < CLOD_LOCUS_PAIRS; k++) {
        char name[32];
        snprintf(name, sizeof name, "%s_%s", CLOD_FIELDS[CLOD_FIELD_PAIRS[k].a].key,
                 CLOD_FIELDS[CLOD_FIELD_PAIRS[k].b].key);
        json_object_set_new(self, name, number(locus->correlation[k]));
    }
    return self;
}

static json_t *locus_of(const clod_locus *locus)
{
    static const char *const ERRORS[] = {"none", "fit", "seeds"};
    json_t *self = json_object();
    for (clod_field_index k = 0; k < CLOD_FIELD_COUNT; k++) {
        const clod_field *field = &CLOD_FIELDS[k];
        const clod_locus_value value = clod_field_get(locus, k);
        const double scale = UNITS[field->kind].scale;
        char name[32];
        snprintf(name, sizeof name, "%s%s", field->key, UNITS[field->kind].suffix);
        json_object_set_new(self, name,
                            json_pack("{s:o, s:o, s:o}", "value", number(scale * value.value),
                                      "error", number(scale * value.error), "scatter",
                                      number(scale * value.scatter)));
    }
    json_object_set_new(self, "flow", json_string(locus->flow));
    json_object_set_new(self, "errors_from", json_string(ERRORS[locus->errors]));
    const char *note = clod_locus_errors_note(locus);
    json_object_set_new(self, "errors_note", note != NULL ? json_string(note) : json_null());
    json_object_set_new(self, "error_correlations", correlations_of(locus));
    json_object_set_new(self, "r_squared", number(locus->r_squared));
    json_object_set_new(self, "parallel", json_boolean(locus->parallel));
    json_object_set_new(self, "seed_count", json_integer((json_int_t)locus->seed_count));
    json_object_set_new(self, "steady_circle", circle(locus->steady));
    json_object_set_new(self, "unconfined_circle", circle(locus->unconfined));
    json_object_set_new(self, "points", marks_of(locus));
    json_object_set_new(self, "warnings", warnings_of(locus));
    return self;
}

char *clod_locus_json(const clod_locus_study *study)
{
    CLOD_NEED(study);
    json_t *loci = json_array();
    for (size_t g = 0; g < study->count; g++) {
        const clod_locus_group *group = &study->groups[g];
        json_t *locus = locus_of(&group->locus);
        json_t *seeds = json_array();
        for (size_t s = 0; s < group->seed_count && group->seed_count > 1; s++) {
            json_array_append_new(seeds, locus_of(&group->seeds[s]));
        }
        json_object_set_new(locus, "seeds", seeds);
        json_array_append_new(loci, locus);
    }
    json_t *remarks = json_array();
    if (study->warning[0] != '\0') {
        json_array_append_new(remarks, json_string(study->warning));
    }
    json_t *all = json_pack("{s:o, s:o}", "loci", loci, "warnings", remarks);
    char *text = clod_json_text(all, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    json_decref(all);
    return text;
}

char *clod_locus_csv(const clod_locus_study *study)
{
    CLOD_NEED(study);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fputs("seeds,points,r_squared,flow", out);
    for (clod_field_index k = 0; k < CLOD_FIELD_COUNT; k++) {
        const clod_field *field = &CLOD_FIELDS[k];
        const char *unit = UNITS[field->kind].unit;
        fprintf(out, ",%s%s,%s_error%s", field->key, unit, field->key, unit);
    }
    for (size_t k = 0; k < CLOD_LOCUS_PAIRS; k++) {
        fprintf(out, ",correlation_%s_%s [1]", CLOD_FIELDS[CLOD_FIELD_PAIRS[k].a].key,
                CLOD_FIELDS[CLOD_FIELD_PAIRS[k].b].key);
    }
    fputs("\n", out);
    for (size_t g = 0; g < study->count; g++) {
        const clod_locus *locus = &study->groups[g].locus;
        fprintf(out, "%zu,%zu,%.10g,%s", locus->seed_count, locus->point_count,
                locus->r_squared, locus->flow);
        for (clod_field_index k = 0; k < CLOD_FIELD_COUNT; k++) {
            const clod_locus_value value = clod_field_get(locus, k);
            clod_cells_put(out, UNITS[CLOD_FIELDS[k].kind].scale * value.value);
            clod_cells_put(out, UNITS[CLOD_FIELDS[k].kind].scale * value.error);
        }
        for (size_t k = 0; k < CLOD_LOCUS_PAIRS; k++) {
            clod_cells_put(out, locus->correlation[k]);
        }
        fputs("\n", out);
    }
    return clod_text_close(&text);
}
