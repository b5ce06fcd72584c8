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

#define MOST_NAMES 64 ///< that are told in a message

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

/** The step of a path or a pattern that begins here, and where the next one does. */
static size_t step_of(const char **at)
{
    const size_t length = strcspn(*at, ".");
    *at += length + ((*at)[length] == '.' ? 1 : 0);
    return length;
}

/** Whether a step of a path is one that a pattern allows. */
static bool step_fits(const char *step, size_t length, const char *pattern, size_t size)
{
    if (size == 1 && pattern[0] == '*') {
        return length > 0 && strspn(step, "0123456789") >= length;
    }
    return length == size && strncmp(step, pattern, size) == 0;
}

/**
 * How far a path goes along a pattern.
 *
 * @param steps  [out] steps that fit
 * @param next   [out] the step of the pattern behind them, with what follows
 * @return       whether all of the path fits all of the pattern
 */
static bool follow(const char *path, const char *pattern, size_t *steps, const char **next)
{
    *next = pattern;
    for (*steps = 0; *path != '\0' && *pattern != '\0'; (*steps)++) {
        const char *step = path;
        *next = pattern;
        if (strcmp(pattern, "**") == 0) {
            return true;
        }
        const size_t length = step_of(&path);
        const size_t size = step_of(&pattern);
        if (!step_fits(step, length, *next, size)) {
            return false;
        }
        *next = pattern;
    }
    return *path == '\0' && *pattern == '\0';
}

/** The most steps of a path that any pattern of the case's summary has; `whole`: all of them. */
static size_t furthest(const clod_case *from, const char *path, bool *whole)
{
    clod_free_path pattern;
    size_t most = 0;
    *whole = false;
    for (size_t k = 0; !*whole && clod_free_summary_path(from, k, &pattern); k++) {
        const char *next;
        size_t steps;
        *whole = follow(path, pattern.text, &steps, &next);
        most = steps > most ? steps : most;
    }
    return most;
}

const clod_number *clod_number_path_find(const clod_case *from, const char *path)
{
    bool whole;
    furthest(from, path, &whole);
    return whole ? unit_of(path) : NULL;
}

/** Names that may follow the first `steps` of a path, each once. */
static size_t names_behind(const clod_case *from, const char *path, size_t steps,
                           char names[MOST_NAMES][CLOD_PLAN_NAME])
{
    clod_free_path pattern;
    size_t count = 0;
    for (size_t k = 0; count < MOST_NAMES && clod_free_summary_path(from, k, &pattern); k++) {
        const char *next;
        size_t fit;
        follow(path, pattern.text, &fit, &next);
        if (fit != steps || *next == '\0') {
            continue;
        }
        snprintf(names[count], CLOD_PLAN_NAME, "%.*s", (int)strcspn(next, "."), next);
        if (names[count][0] == '*') {
            snprintf(names[count], CLOD_PLAN_NAME, "a number from 0 on");
        }
        bool new = true;
        for (size_t n = 0; n < count; n++) {
            new = new &&strcmp(names[n], names[count]) != 0;
        }
        count += new ? 1 : 0;
    }
    return count;
}

const char *clod_number_path_hint(const clod_case *from, const char *path, char *buffer,
                                  size_t size)
{
    char names[MOST_NAMES][CLOD_PLAN_NAME], word[CLOD_PLAN_NAME];
    bool whole;
    const size_t steps = furthest(from, path, &whole);
    const size_t count = names_behind(from, path, steps, names);
    const char *wrong = path;
    for (size_t k = 0; k < steps; k++) {
        step_of(&wrong);
    }
    snprintf(word, sizeof word, "%.*s", (int)strcspn(wrong, "."), wrong);
    clod_suggest near = clod_suggest_start(word);
    for (size_t k = 0; k < count && word[0] != '\0'; k++) {
        clod_suggest_offer(&near, names[k]);
    }
    clod_suggest_text(&near, buffer, size);
    size_t used = strlen(buffer);
    const int before = (int)(wrong - path) - (steps > 0 && wrong[0] != '\0' ? 1 : 0);
    if (steps == 0) {
        used += (size_t)snprintf(buffer + used, size - used,
                                 "; summary.json of this case begins its paths with");
    } else if (count == 0) {
        used +=
            (size_t)snprintf(buffer + used, size - used, "; %.*s is a number", before, path);
    } else {
        used +=
            (size_t)snprintf(buffer + used, size - used, "; behind %.*s it has", before, path);
    }
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
