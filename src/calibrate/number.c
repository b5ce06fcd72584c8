#include "calibrate/number.h"

#include <jansson.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/fields.h"
#include "base/json.h"
#include "clod/locus.h"
#include "config/suggest.h"

#define DEGREE 0.017453292519943295
#define ANGLE "rad", {"deg", 1.0 / DEGREE, 1}, 0.1 * DEGREE, 85.0 * DEGREE
#define STRESS "Pa", {"kPa", 1e-3, 2}, 0.0, 1e8

#define UNIAXIAL CLOD_NUMBER_OF(CLOD_CASE_UNIAXIAL)
#define WALL CLOD_NUMBER_OF(CLOD_CASE_WALL_FRICTION)
#define SHEAR (CLOD_NUMBER_OF(CLOD_CASE_RING_SHEAR) | CLOD_NUMBER_OF(CLOD_CASE_JENIKE))

static const clod_number NUMBERS[] = {
    {"phi_lin", ANGLE, SHEAR, 0},
    {"phi_e", ANGLE, SHEAR, 0},
    {"phi_sf", ANGLE, SHEAR, 0},
    {"c", STRESS, SHEAR, 0},
    {"tau_p", STRESS, SHEAR, 0},
    {"tau", STRESS, SHEAR, SHEAR},
    {"sigma_1", STRESS, SHEAR, 0},
    {"sigma_2", STRESS, SHEAR, 0},
    {"sigma_c", STRESS, SHEAR | UNIAXIAL, UNIAXIAL},
    {"ffc", "1", {"", 1.0, 2}, 0.0, 1000.0, SHEAR | UNIAXIAL, UNIAXIAL},
    {"phi_x", ANGLE, WALL, WALL},
    {"phi_w", ANGLE, WALL, 0},
    {"tau_ad", STRESS, WALL, 0},
    {"rho_b",
     "kg/m3",
     {"kg/m3", 1.0, 0},
     10.0,
     15000.0,
     SHEAR | UNIAXIAL | WALL,
     UNIAXIAL | WALL},
};
#define NUMBER_COUNT (sizeof NUMBERS / sizeof NUMBERS[0])

static const clod_number OF_SUMMARY = {"",        "1",      {"", 1.0, CLOD_PLAN_FIGURES},
                                       -HUGE_VAL, HUGE_VAL, CLOD_NUMBER_OF(CLOD_CASE_FREE),
                                       0};

static bool has(const clod_number *self, clod_case_kind kind)
{
    return (self->kinds & CLOD_NUMBER_OF(kind)) != 0;
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

/** A number of a yield locus. */
static double of_locus(const clod_locus *locus, const clod_plan_target *target)
{
    if (strcmp(target->number, "tau") == 0) {
        return locus->c.value + target->normal_stress * tan(locus->phi_lin.value);
    }
    double value = (double)NAN;
    for (clod_field_index k = 0; k < CLOD_FIELD_COUNT; k++) {
        if (strcmp(CLOD_FIELDS[k].key, target->number) == 0) {
            value = clod_field_get(locus, k).value;
        }
    }
    return value;
}

/** The yield locus of a run: of its points. */
static clod_locus_study *read_locus(const char *folder, clod_status *status)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/points.csv", folder);
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_read(path, NULL, &points, &count, status)) {
        return NULL;
    }
    clod_locus_study *study = clod_locus_study_create(points, count, status);
    clod_locus_free(points);
    return study;
}

/** A number of the row with the target's stress, in a list of rows. The stress is the one that was asked
 *  for, as in the plan: what reaches the grains depends on the packing. */
static double of_rows(const json_t *rows, const char *stress_key, const char *key,
                      const clod_plan_target *target)
{
    size_t index;
    const json_t *row;
    json_array_foreach(rows, index, row)
    {
        const double stress = json_number_value(json_object_get(row, stress_key));
        const json_t *found = json_object_get(row, key);
        if (fabs(stress / target->normal_stress - 1.0) < CLOD_NUMBER_SAME_STRESS &&
            json_is_number(found)) {
            return json_number_value(found);
        }
    }
    return (double)NAN;
}

/** A number of a uniaxial test's flow function. */
static double of_flow_function(const json_t *summary, const clod_plan_target *target)
{
    static const char *const KEYS[][2] = {
        {"sigma_c", "sigma_c_Pa"}, {"rho_b", "bulk_density_kg_m3"}, {"ffc", "ffc"}};
    double value = (double)NAN;
    for (size_t k = 0; k < sizeof KEYS / sizeof KEYS[0]; k++) {
        if (strcmp(KEYS[k][0], target->number) == 0) {
            value = of_rows(json_object_get(summary, "flow_function"),
                            "consolidation_stress_Pa", KEYS[k][1], target);
        }
    }
    return value;
}

/** A number of a wall friction test: of its line, or at one of its stresses. */
static double of_wall(const json_t *summary, const clod_plan_target *target)
{
    const json_t *locus = json_object_get(summary, "wall_locus");
    const char *const line = strcmp(target->number, "phi_w") == 0    ? "phi_w_deg"
                             : strcmp(target->number, "tau_ad") == 0 ? "tau_ad_Pa"
                                                                     : NULL;
    if (line != NULL) {
        const json_t *found = json_object_get(json_object_get(locus, line), "value");
        const double unit = line[0] == 'p' ? DEGREE : 1.0;
        return json_is_number(found) ? unit * json_number_value(found) : (double)NAN;
    }
    if (strcmp(target->number, "phi_x") == 0) {
        return DEGREE *
               of_rows(json_object_get(locus, "points"), "wall_stress_Pa", "phi_x_deg", target);
    }
    double density = (double)NAN;
    size_t index;
    const json_t *part; // the filling has no stresses
    json_array_foreach(json_object_get(summary, "parts"), index, part)
    {
        density = fmax(density, of_rows(json_object_get(part, "stresses"), "wall_stress_Pa",
                                        "bulk_density_kg_m3", target));
    }
    return density;
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

/** Numbers of a shear test. */
static bool read_shear(const clod_plan *plan, size_t test, const char *folder, double *values,
                       clod_status *status)
{
    clod_locus_study *study = read_locus(folder, status);
    if (study == NULL) {
        return false;
    }
    for (size_t t = 0; t < plan->target_count; t++) {
        if (plan->targets[t].test == test) {
            values[t] = of_locus(&study->groups[0].locus, &plan->targets[t]);
        }
    }
    clod_locus_study_destroy(&study);
    return true;
}

/** A number of a test that is no shear test. */
static bool of_summary(clod_case_kind kind, const json_t *summary,
                       const clod_plan_target *target, const char *folder, double *value,
                       clod_status *status)
{
    switch (kind) {
    case CLOD_CASE_UNIAXIAL:
        *value = of_flow_function(summary, target);
        return true;
    case CLOD_CASE_WALL_FRICTION:
        *value = of_wall(summary, target);
        return true;
    default:
        return of_path(summary, target, folder, value, status);
    }
}

bool clod_number_read(const clod_plan *plan, size_t test, const char *folder, double *values,
                      clod_status *status)
{
    const clod_case_kind kind = clod_case_kind_of(plan->tests[test].middle);
    if ((SHEAR & CLOD_NUMBER_OF(kind)) != 0) {
        return read_shear(plan, test, folder, values, status);
    }
    json_t *summary = clod_json_read(folder, "summary.json", status);
    bool good = summary != NULL;
    for (size_t t = 0; t < plan->target_count && good; t++) {
        const clod_plan_target *target = &plan->targets[t];
        good = target->test != test ||
               of_summary(kind, summary, target, folder, &values[t], status);
    }
    json_decref(summary);
    return good;
}
