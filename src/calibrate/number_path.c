/**
 * @file number_path.c
 * Numbers of a free run: any of its summary, by the names on the way to it.
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "calibrate/number.h"
#include "config/suggest.h"
#include "sim/free_summary.h"

#define ROW(suffix, si, shown, factor)                                                         \
    {                                                                                          \
        suffix, si, {shown, factor, CLOD_PLAN_FIGURES}, -HUGE_VAL, HUGE_VAL, false, NULL, NULL \
    }

// By the end of the name, the longer before those that it ends with; the last fits any.
const clod_number CLOD_NUMBERS_PATH[CLOD_NUMBERS_PATH_COUNT] = {
    ROW("_deg", "rad", "deg", 1.0 / CLOD_NUMBER_DEGREE),
    ROW("_rad", "rad", "rad", 1.0),
    ROW("_kg_per_m3", "kg/m3", "kg/m3", 1.0),
    ROW("_kg_m3", "kg/m3", "kg/m3", 1.0),
    ROW("_kg_per_s", "kg/s", "kg/s", 1.0),
    ROW("_kg_s", "kg/s", "kg/s", 1.0),
    ROW("_m_per_s", "m/s", "m/s", 1.0),
    ROW("_per_s", "1", "", 1.0),
    ROW("_per_m", "1", "", 1.0),
    ROW("_N_m", "1", "", 1.0),
    ROW("_Pa", "Pa", "Pa", 1.0),
    ROW("_kg", "kg", "kg", 1.0),
    ROW("_N", "N", "N", 1.0),
    ROW("_m", "m", "m", 1.0),
    ROW("_s", "s", "s", 1.0),
    ROW("", "1", "", 1.0),
};

bool clod_number_is_path(const clod_number *self)
{
    for (size_t k = 0; k < CLOD_NUMBERS_PATH_COUNT; k++) {
        if (self == &CLOD_NUMBERS_PATH[k]) {
            return true;
        }
    }
    return false;
}

// ---- in a plan

/** The row whose ending a name of `length` bytes has. */
static const clod_number *row_of(const char *name, size_t length)
{
    const clod_number *row = CLOD_NUMBERS_PATH;
    for (;; row++) {
        const size_t end = strlen(row->key);
        if (end <= length && strncmp(name + length - end, row->key, end) == 0) {
            return row;
        }
    }
}

/** Of the last name that has a unit: power_W.mean, force_N.2. The second is one of the case's own. */
static const clod_number *unit_of(const char *path)
{
    const clod_number *found = &CLOD_NUMBERS_PATH[CLOD_NUMBERS_PATH_COUNT - 1];
    int place = 0;
    for (const char *step = path; *step != '\0'; place++) {
        const size_t length = strcspn(step, ".");
        const bool last = step[length] == '\0';
        const clod_number *row = row_of(step, length);
        if (row->key[0] != '\0' && (place != 1 || last)) {
            found = row;
        }
        step += length + (last ? 0 : 1);
    }
    return found;
}

const clod_number *clod_number_path_find(const clod_case *from, const char *path)
{
    const char *names[CLOD_FREE_SUMMARY_MOST];
    const size_t count = clod_free_summary_names(from, names);
    const size_t length = strcspn(path, ".");
    for (size_t k = 0; k < count; k++) {
        if (strlen(names[k]) == length && strncmp(names[k], path, length) == 0) {
            return unit_of(path);
        }
    }
    return NULL;
}

const char *clod_number_path_hint(const clod_case *from, const char *path, char *buffer,
                                  size_t size)
{
    const char *names[CLOD_FREE_SUMMARY_MOST];
    const size_t count = clod_free_summary_names(from, names);
    char word[CLOD_PLAN_NAME];
    snprintf(word, sizeof word, "%.*s", (int)strcspn(path, "."), path);
    clod_suggest near = clod_suggest_start(word);
    for (size_t k = 0; k < count; k++) {
        clod_suggest_offer(&near, names[k]);
    }
    clod_suggest_text(&near, buffer, size);
    size_t used = strlen(buffer);
    used += (size_t)snprintf(buffer + used, size - used,
                             "; summary.json of this case begins its paths with");
    for (size_t k = 0; k < count && used < size; k++) {
        used +=
            (size_t)snprintf(buffer + used, size - used, "%s %s", k == 0 ? "" : ",", names[k]);
    }
    return buffer;
}

// ---- in a summary

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

bool clod_number_path_read(const json_t *summary, const clod_number *self,
                           const clod_plan_target *target, const char *folder, double *value,
                           clod_status *status)
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
    *value = json_is_number(at) ? json_number_value(at) / self->measure.factor : (double)NAN;
    return true;
}
