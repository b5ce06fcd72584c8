/**
 * @file number_path.c
 * Numbers of a free run: any of its summary, by the names on the way to it.
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "calibrate/number.h"
#include "clod/repose_angles.h"
#include "config/suggest.h"

#define MOST_NAMES 256 ///< that a message tells, as many as find room in it

#define ROW(ending, si, shown, factor)                                                         \
    {ending, si,  {shown, factor, CLOD_PLAN_FIGURES}, -HUGE_VAL, HUGE_VAL, false, false,       \
     NULL,   NULL},

// By the end of the name; the last fits any.
const clod_number CLOD_NUMBERS_PATH[CLOD_NUMBERS_PATH_COUNT] = {CLOD_UNIT_ENDINGS(ROW)
                                                                    ROW("", "1", "", 1.0)};

// Angles with bounds, which no solid is beyond. A surcharge angle is that of a slope, which may fall to its edges.
#define ANGLE(least, most)                                                                     \
    {                                                                                          \
        "_deg", "rad", {"deg", 1.0 / CLOD_NUMBER_DEGREE, CLOD_PLAN_FIGURES},                   \
            (least)*CLOD_NUMBER_DEGREE, (most)*CLOD_NUMBER_DEGREE, false, false, NULL, NULL    \
    }

static const clod_number REPOSE = ANGLE(CLOD_REPOSE_ANGLES_LEAST, CLOD_REPOSE_ANGLES_MOST);
static const clod_number SURCHARGE = ANGLE(-90.0, 90.0);

bool clod_number_path_is_repose(const clod_number *self)
{
    return self == &REPOSE;
}

bool clod_number_is_path(const clod_number *self)
{
    if (self == &REPOSE || self == &SURCHARGE) {
        return true;
    }
    for (size_t k = 0; k < CLOD_NUMBERS_PATH_COUNT; k++) {
        if (self == &CLOD_NUMBERS_PATH[k]) {
            return true;
        }
    }
    return false;
}

bool clod_number_path_is_amount(const clod_number *kind, const char *path)
{
    static const char *const ENDINGS[] = {"_kg", "_kg_m3", "_kg_per_m3", "_J",
                                          "_m2", "_m3",    "_s"};
    static const char *const NAMES[] = {"grains",      "contacts",  "coordination",
                                        "max_overlap", "deviation", "steps"};
    const char *last = strrchr(path, '.');
    bool found = false;
    for (size_t k = 0; k < sizeof ENDINGS / sizeof ENDINGS[0]; k++) {
        found = found || strcmp(kind->key, ENDINGS[k]) == 0;
    }
    for (size_t k = 0; k < sizeof NAMES / sizeof NAMES[0]; k++) {
        found = found || strcmp(last != NULL ? last + 1 : path, NAMES[k]) == 0;
    }
    return found;
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

/** Of the last of clod's names that has a unit: power_W.mean, force_N.2. */
static const clod_number *unit_of(const clod_free_path *path)
{
    const clod_number *found = &CLOD_NUMBERS_PATH[CLOD_NUMBERS_PATH_COUNT - 1];
    for (const char *step = path->words; *step != '\0';) {
        const size_t length = strcspn(step, ".");
        const clod_number *row = row_of(step, length);
        found = row->key[0] != '\0' ? row : found;
        step += length + (step[length] == '.' ? 1 : 0);
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
    if (pattern[0] != '[') {
        return length == size && strncmp(step, pattern, size) == 0;
    }
    char *end;
    const unsigned long first = strtoul(pattern + 1, &end, 10);
    const unsigned long last = strtoul(end + 1, NULL, 10);
    const unsigned long place = strtoul(step, NULL, 10); // its largest where it is too long
    return length > 0 && strspn(step, "0123456789") >= length && place >= first &&
           place <= last;
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
        const size_t length = step_of(&path);
        const size_t size = step_of(&pattern);
        if (!step_fits(step, length, *next, size)) {
            return false;
        }
        *next = pattern;
    }
    return *path == '\0' && *pattern == '\0';
}

/** The pattern that a path fits; NULL: none. The most steps that fit any. */
static const clod_free_path *furthest(const clod_free_paths *of, const char *path, size_t *most)
{
    *most = 0;
    for (size_t k = 0; k < of->count; k++) {
        const char *next;
        size_t steps;
        if (follow(path, of->path[k].text, &steps, &next)) {
            return &of->path[k];
        }
        *most = steps > *most ? steps : *most;
    }
    return NULL;
}

static bool ends(const char *path, const char *ending)
{
    const size_t length = strlen(path), end = strlen(ending);
    return end <= length && strcmp(path + length - end, ending) == 0;
}

const clod_number *clod_number_path_find(const clod_free_paths *of, const char *path)
{
    size_t steps;
    const clod_free_path *found = furthest(of, path, &steps);
    if (found == NULL) {
        return NULL;
    }
    const bool repose = strncmp(path, "repose.", strlen("repose.")) == 0;
    if (repose && (ends(path, ".angle_deg") || ends(path, ".mean_deg"))) {
        return &REPOSE;
    }
    return ends(path, ".profile.surcharge_deg") ? &SURCHARGE : unit_of(found);
}

/** A name as people have it: "0 to 2" for [0-2]. */
static void write_name(const char *pattern, char name[CLOD_PLAN_NAME])
{
    const int size = (int)strcspn(pattern, ".");
    if (pattern[0] != '[') {
        snprintf(name, CLOD_PLAN_NAME, "%.*s", size, pattern);
        return;
    }
    char *end;
    const unsigned long first = strtoul(pattern + 1, &end, 10);
    const unsigned long last = strtoul(end + 1, NULL, 10);
    if (first == last) {
        snprintf(name, CLOD_PLAN_NAME, "%lu", first);
    } else {
        snprintf(name, CLOD_PLAN_NAME, "%lu to %lu", first, last);
    }
}

/** Names that may follow the first `steps` of a path, each once. */
static size_t names_behind(const clod_free_paths *of, const char *path, size_t steps,
                           char names[MOST_NAMES][CLOD_PLAN_NAME])
{
    size_t count = 0;
    for (size_t k = 0; k < of->count && count < MOST_NAMES; k++) {
        const char *next;
        size_t fit;
        follow(path, of->path[k].text, &fit, &next);
        if (fit != steps || *next == '\0') {
            continue;
        }
        write_name(next, names[count]);
        bool new = true;
        for (size_t n = 0; n < count; n++) {
            new = new &&strcmp(names[n], names[count]) != 0;
        }
        count += new ? 1 : 0;
    }
    return count;
}

const char *clod_number_path_hint(const clod_free_paths *of, const char *path, char *buffer,
                                  size_t size)
{
    char names[MOST_NAMES][CLOD_PLAN_NAME], word[CLOD_PLAN_NAME];
    size_t steps;
    furthest(of, path, &steps);
    const char *wrong = path;
    for (size_t k = 0; k < steps; k++) {
        step_of(&wrong);
    }
    snprintf(word, sizeof word, "%.*s", (int)strcspn(wrong, "."), wrong);
    const size_t count = names_behind(of, path, steps, names);
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

/** The number or null to which a path leads in a list or object; NULL: there is none. */
static const json_t *find_in(const json_t *from, const char *path);

/** Below an object, whose keys may have points: part of a mesh, "chute.lip". */
static const json_t *find_in_object(const json_t *from, const char *path)
{
    const char *key;
    json_t *item;
    const json_t *found = NULL;
    json_object_foreach((json_t *)from, key, item)
    {
        const size_t length = strlen(key);
        if (found == NULL && strncmp(path, key, length) == 0 &&
            (path[length] == '.' || path[length] == '\0')) {
            found = find_in(item, path + length + (path[length] == '.' ? 1 : 0));
        }
    }
    return found;
}

static const json_t *find_in(const json_t *from, const char *path)
{
    if (*path == '\0') {
        return json_is_number(from) || json_is_null(from) ? from : NULL;
    }
    if (json_is_array(from)) {
        const size_t index = strtoul(path, NULL, 10);
        step_of(&path);
        return find_in(json_array_get(from, index), path);
    }
    return find_in_object(from, path);
}

double clod_number_path_read(const json_t *summary, const clod_number *self,
                             const clod_plan_target *target)
{
    const json_t *found = find_in(summary, target->number);
    return json_is_number(found) ? json_number_value(found) / self->measure.factor
                                 : (double)NAN;
}
