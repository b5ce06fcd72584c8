#include "calibrate/number.h"

#include <jansson.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/fields.h"
#include "base/input.h"
#include "base/memory.h"
#include "clod/locus.h"
#include "config/suggest.h"

#define DEGREE 0.017453292519943295
#define ANGLE "rad", {"deg", 1.0 / DEGREE, 1}, 0.1 * DEGREE, 85.0 * DEGREE
#define STRESS "Pa", {"kPa", 1e-3, 2}, 0.0, 1e8
#define SUMMARY_MOST ((size_t)1 << 26)
#define SAME_STRESS 0.02 // relative: as clod locus tells consolidation stresses apart

static const clod_number NUMBERS[] = {
    {"phi_lin", ANGLE, true, false},
    {"phi_e", ANGLE, true, false},
    {"phi_sf", ANGLE, true, false},
    {"c", STRESS, true, false},
    {"tau_p", STRESS, true, false},
    {"tau", STRESS, true, false},
    {"sigma_1", STRESS, true, false},
    {"sigma_2", STRESS, true, false},
    {"sigma_c", STRESS, true, true},
    {"ffc", "1", {"", 1.0, 2}, 0.0, 1000.0, true, true},
    {"rho_b", "kg/m3", {"kg/m3", 1.0, 0}, 10.0, 15000.0, true, true},
};
#define NUMBER_COUNT (sizeof NUMBERS / sizeof NUMBERS[0])

static const clod_number OF_SUMMARY = {"",       "1",   {"", 1.0, 4}, -HUGE_VAL,
                                       HUGE_VAL, false, false};

static bool has(const clod_number *self, clod_case_kind kind)
{
    return kind == CLOD_CASE_UNIAXIAL ? self->uniaxial : self->shear;
}

const clod_number *clod_number_find(clod_case_kind kind, const char *key)
{
    if (kind == CLOD_CASE_FREE) {
        return &OF_SUMMARY;
    }
    for (size_t k = 0; k < NUMBER_COUNT; k++) {
        if (has(&NUMBERS[k], kind) && strcmp(NUMBERS[k].key, key) == 0) {
            return &NUMBERS[k];
        }
    }
    return NULL;
}

const char *clod_number_hint(clod_case_kind kind, const char *key, char *buffer, size_t size)
{
    clod_suggest near = clod_suggest_start(key);
    for (size_t k = 0; k < NUMBER_COUNT; k++) {
        if (has(&NUMBERS[k], kind)) {
            clod_suggest_offer(&near, NUMBERS[k].key);
        }
    }
    clod_suggest_text(&near, buffer, size);
    if (buffer[0] != '\0') {
        return buffer;
    }
    size_t used = (size_t)snprintf(buffer, size, "; it has");
    for (size_t k = 0; k < NUMBER_COUNT && used < size; k++) {
        if (has(&NUMBERS[k], kind)) {
            used += (size_t)snprintf(buffer + used, size - used, "%s %s",
                                     buffer[used - 1] == 's' ? "" : ",", NUMBERS[k].key);
        }
    }
    return buffer;
}

/** The yield locus of a run: of its points. */
static bool read_locus(const clod_plan_target *target, const char *folder, double *value,
                       clod_status *status)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/points.csv", folder);
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_read(path, NULL, &points, &count, status)) {
        return false;
    }
    clod_locus_study *study = clod_locus_study_create(points, count, status);
    clod_locus_free(points);
    if (study == NULL) {
        return false;
    }
    const clod_locus *locus = &study->groups[0].locus;
    if (strcmp(target->number, "tau") == 0) {
        *value = locus->c.value + target->normal_stress * tan(locus->phi_lin.value);
    }
    for (clod_field_index k = 0; k < CLOD_FIELD_COUNT; k++) {
        if (strcmp(CLOD_FIELDS[k].key, target->number) == 0) {
            *value = clod_field_get(locus, k).value;
        }
    }
    clod_locus_study_destroy(&study);
    return true;
}

static json_t *read_summary(const char *folder, clod_status *status)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/summary.json", folder);
    char *text;
    size_t length;
    if (!clod_input_read_regular(path, SUMMARY_MOST, &text, &length, status)) {
        return NULL;
    }
    json_error_t error;
    json_t *summary = json_loadb(text, length, 0, &error);
    clod_memory_free(text);
    if (summary == NULL) {
        clod_status_fail(status, CLOD_USAGE, "%s:%d: damaged: %s", path, error.line,
                         error.text);
    }
    return summary;
}

/** A row of a uniaxial test's flow function. */
static void of_row(const json_t *row, const clod_plan_target *target, double *value)
{
    static const char *const KEYS[][2] = {
        {"sigma_c", "sigma_c_Pa"}, {"rho_b", "bulk_density_kg_m3"}, {"ffc", "ffc"}};
    const double stress = json_number_value(json_object_get(row, "consolidation_stress_Pa"));
    for (size_t k = 0; k < sizeof KEYS / sizeof KEYS[0]; k++) {
        const json_t *found = json_object_get(row, KEYS[k][1]);
        if (fabs(stress / target->normal_stress - 1.0) < SAME_STRESS && json_is_number(found) &&
            strcmp(KEYS[k][0], target->number) == 0) {
            *value = json_number_value(found);
        }
    }
}

/** The item of a list or object by the first `length` bytes of a key. */
static json_t *step_into(const json_t *from, const char *key, size_t length)
{
    char word[CLOD_PLAN_NAME];
    snprintf(word, sizeof word, "%.*s", (int)length, key);
    if (json_is_array(from)) {
        char *end;
        const size_t index = strtoul(word, &end, 10);
        return *end == '\0' && end != word ? json_array_get(from, index) : NULL;
    }
    return json_object_get(from, word);
}

/** Say that a summary has no such number, with the key nearest to the step that is missing. */
static bool unknown(const clod_plan_target *target, const json_t *from, const char *step,
                    const char *folder, clod_status *status)
{
    char word[CLOD_PLAN_NAME];
    char hint[160];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(step, "."), step);
    clod_suggest near = clod_suggest_start(word);
    const char *key;
    json_t *item;
    json_object_foreach((json_t *)from, key, item)
    {
        clod_suggest_offer(&near, key);
    }
    return clod_status_fail(
        status, CLOD_USAGE,
        "%s/summary.json has no number %s: nothing is called \"%s\" there%s", folder,
        target->number, word, clod_suggest_text(&near, hint, sizeof hint));
}

/** A number by its path. */
static bool of_path(const json_t *summary, const clod_plan_target *target, const char *folder,
                    double *value, clod_status *status)
{
    const json_t *at = summary;
    for (const char *step = target->number; *step != '\0';) {
        const size_t length = strcspn(step, ".");
        const json_t *next = step_into(at, step, length);
        if (next == NULL) {
            return unknown(target, at, step, folder, status);
        }
        at = next;
        step += length + (step[length] == '.' ? 1 : 0);
    }
    if (!json_is_number(at) && !json_is_null(at)) {
        return clod_status_fail(status, CLOD_USAGE, "%s/summary.json: %s is no number", folder,
                                target->number);
    }
    *value = json_is_number(at) ? json_number_value(at) : (double)NAN;
    return true;
}

bool clod_number_read(const clod_plan *plan, const clod_plan_target *target, const char *folder,
                      double *value, clod_status *status)
{
    *value = (double)NAN;
    const clod_case_kind kind = clod_case_kind_of(plan->tests[target->test].middle);
    if (kind != CLOD_CASE_FREE && kind != CLOD_CASE_UNIAXIAL) {
        return read_locus(target, folder, value, status);
    }
    json_t *summary = read_summary(folder, status);
    if (summary == NULL) {
        return false;
    }
    bool good = true;
    if (kind == CLOD_CASE_FREE) {
        good = of_path(summary, target, folder, value, status);
    } else {
        size_t index;
        json_t *row;
        json_array_foreach(json_object_get(summary, "flow_function"), index, row)
        {
            of_row(row, target, value);
        }
    }
    json_decref(summary);
    return good;
}
