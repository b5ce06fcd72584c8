/**
 * @file plan_places.c
 * Whether the cases of a plan load wherever its parameters may lie, before the first run.
 */

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "calibrate/plan_check.h"
#include "calibrate/sobol.h"
#include "config/param.h"

#define PATH 200
#define SETTINGS 1200 ///< bytes of a text with all settings

static const char *const ENDS[] = {"from", "to"};

_Static_assert(CLOD_PLAN_PARAMETERS <= CLOD_SOBOL_MOST,
               "a design takes all parameters of a plan");

static const clod_param *find_row(const clod_table *table, const char *key);

/** Row of a key behind a name that may have points in it; the map's own where nothing is behind it. */
static const clod_param *find_behind_name(const clod_param *map, const char *key)
{
    const char *point = strchr(key, '.');
    const clod_param *row = point == NULL ? map : NULL;
    for (; point != NULL && row == NULL; point = strchr(point + 1, '.')) {
        row = find_row(map->table, point + 1);
    }
    return row;
}

/** Row of a key below a table; NULL: there is none, or it is an element of a vector. */
static const clod_param *find_row(const clod_table *table, const char *key)
{
    const clod_param *row = NULL;
    bool named = false; // the step is an element of a list or a name
    for (const char *step = key; *step != '\0';) {
        if (named && row->any_name) {
            return find_behind_name(row, step);
        }
        char word[64];
        const size_t length = strcspn(step, ".");
        snprintf(word, sizeof word, "%.*s", (int)length, step);
        step += length + (step[length] == '.' ? 1 : 0);
        const clod_param *beside =
            named && row->beside != NULL ? clod_param_find(row->beside, word) : NULL;
        if (named && beside == NULL) {
            named = false;
            continue;
        }
        row = beside != NULL ? beside : table == NULL ? NULL : clod_param_find(table, word);
        if (row == NULL) {
            return NULL;
        }
        named = row->kind == CLOD_PARAM_LIST || row->kind == CLOD_PARAM_MAP ||
                row->kind == CLOD_PARAM_PAIRS;
        table = row->table;
    }
    return row;
}

/** Why a key is no parameter of a solid or a wall, whatever value it takes; NULL: it may be one. */
static const char *no_parameter(const char *key)
{
    if (strcmp(key, "seed") == 0) {
        return "seed is no parameter: every packing gets a seed of its own; leave it "
               "out, and give seeds in the plan for more packings of each point";
    }
    if (strcmp(key, "title") == 0) {
        return "title is no parameter: it is the name of a run and changes nothing of it; leave it out";
    }
    if (strncmp(key, "output.", strlen("output.")) == 0) {
        return "keys below output are no parameters: they say what is written and when, not how the solid "
               "behaves; give them in the case";
    }
    return NULL;
}

/** Where the plan has a key of a parameter. */
static void path_of(const clod_plan_parameter *self, size_t m, char path[PATH])
{
    snprintf(path, PATH, "parameters.%.60s.%s%.100s", self->name, m == 0 ? "key" : "multiples.",
             m == 0 ? "" : clod_plan_key(self, m));
}

void clod_plan_check_key(clod_loader *loader, const clod_plan_parameter *self)
{
    for (size_t m = 0; m <= self->multiple_count; m++) {
        char path[PATH];
        const char *key = clod_plan_key(self, m);
        const clod_param *row = find_row(&CLOD_TABLE_CASE, key);
        const char *why = no_parameter(key);
        path_of(self, m, path);
        if (why != NULL) {
            clod_check_fail(loader, path, "%s", why);
        } else if (row != NULL && row->kind == CLOD_PARAM_INTEGER) {
            clod_check_fail(loader, path,
                            "%s takes whole numbers only, and a parameter takes every value "
                            "between from and to; give it in the case",
                            key);
        }
    }
}

clod_case *clod_plan_case(const clod_plan *self, const clod_plan_test *test,
                          const double *place, clod_status *status)
{
    clod_plan_settings settings;
    clod_case *found = NULL;
    if (clod_plan_settings_at(self, test, place, &settings)) {
        found = clod_case_load(test->path, (const char *const *)settings.items, settings.count,
                               status);
    } else {
        clod_status_fail(status, CLOD_FAILED, "No memory for the case.");
    }
    clod_plan_settings_fini(&settings);
    return found;
}

/** All settings of a place in one line. */
static void write_settings(const clod_plan *self, const double *place, char text[SETTINGS])
{
    size_t used = 0;
    text[0] = '\0';
    for (size_t k = 0; k < self->parameter_count && used < SETTINGS; k++) {
        const clod_plan_parameter *one = &self->parameters[k];
        used += (size_t)snprintf(text + used, SETTINGS - used, "%s%s = %.4g%s%s",
                                 k == 0 ? "" : ", ", one->name, clod_plan_number(one, place[k]),
                                 one->unit[0] == '\0' ? "" : " ", one->unit);
    }
}

/** Whether the case loads at a place; if not, a complaint that tells all settings. */
static bool accepts(clod_loader *loader, const clod_plan *self, const clod_plan_test *test,
                    const double *place)
{
    clod_status status = {CLOD_OK, ""};
    clod_case *found = clod_plan_case(self, test, place, &status);
    const bool good = found != NULL;
    if (!good) {
        char settings[SETTINGS];
        write_settings(self, place, settings);
        clod_check_fail(loader, "parameters",
                        "test %s refuses %s together, and every combination within the "
                        "ranges may be run: %.800s",
                        test->name, settings, clod_plan_check_reason(&status));
    }
    clod_case_destroy(&found);
    return good;
}

/** Load the case with parameter k at an end of its range, 0 or 1, and the others in the middle. */
static bool loads_end(const clod_plan *self, const clod_plan_test *test, size_t k, int end,
                      clod_status *status)
{
    double place[CLOD_PLAN_PARAMETERS];
    for (size_t m = 0; m < self->parameter_count; m++) {
        place[m] = m == k ? (double)end : 0.5;
    }
    clod_case *found = clod_plan_case(self, test, place, status);
    const bool good = found != NULL;
    clod_case_destroy(&found);
    return good;
}

/** Whether a refusal begins with the setting of a key of parameter k, its m-th. */
static bool names_key(const clod_plan *self, size_t k, const clod_status *why, size_t *m)
{
    for (*m = 0; *m <= self->parameters[k].multiple_count; (*m)++) {
        char begin[CLOD_STATUS_TEXT];
        const int length =
            snprintf(begin, sizeof begin, "--set %s=", clod_plan_key(&self->parameters[k], *m));
        if (strncmp(why->text, begin, (size_t)length) == 0) {
            return true;
        }
    }
    return false;
}

static void fail_end(clod_loader *loader, const clod_plan_test *test, const char *path,
                     clod_status *why)
{
    clod_check_fail(loader, path, "test %s refuses it: %.800s", test->name,
                    clod_plan_check_reason(why));
}

/** Whether a parameter is refused by its name: a complaint at the end of its range, or at its key where both are. */
static bool is_refused(clod_loader *loader, const clod_plan *self, const clod_plan_test *test,
                       size_t k)
{
    clod_status why[2] = {{CLOD_OK, ""}, {CLOD_OK, ""}};
    bool refused[2];
    size_t m = 0;
    for (int end = 1; end >= 0; end--) { // m is of the lower one, which is told
        refused[end] =
            !loads_end(self, test, k, end, &why[end]) && names_key(self, k, &why[end], &m);
    }
    char path[PATH];
    if (refused[0] && refused[1]) {
        path_of(&self->parameters[k], m, path);
    } else {
        snprintf(path, sizeof path, "parameters.%.60s.%s", self->parameters[k].name,
                 ENDS[refused[0] ? 0 : 1]);
    }
    if (refused[0] || refused[1]) {
        fail_end(loader, test, path, &why[refused[0] ? 0 : 1]);
    }
    return refused[0] || refused[1];
}

/** Each parameter at either end, the others in the middle: one of those may be the reason of a refusal. */
static bool accepts_ends(clod_loader *loader, const clod_plan *self, const clod_plan_test *test)
{
    for (size_t k = 0; k < 2 * self->parameter_count; k++) {
        clod_status why = {CLOD_OK, ""};
        if (loads_end(self, test, k / 2, (int)(k % 2), &why)) {
            continue;
        }
        bool told = false;
        for (size_t i = 0; i < self->parameter_count && !told; i++) {
            told = is_refused(loader, self, test, i);
        }
        if (!told) {
            char path[PATH];
            snprintf(path, sizeof path, "parameters.%.60s.%s", self->parameters[k / 2].name,
                     ENDS[k % 2]);
            fail_end(loader, test, path, &why);
        }
        return false;
    }
    return true;
}

/** All corners of the ranges. */
static bool accepts_corners(clod_loader *loader, const clod_plan *self,
                            const clod_plan_test *test)
{
    for (size_t corner = 0; corner < (size_t)1 << self->parameter_count; corner++) {
        double place[CLOD_PLAN_PARAMETERS];
        for (size_t k = 0; k < self->parameter_count; k++) {
            place[k] = (double)(corner >> k & 1);
        }
        if (!accepts(loader, self, test, place)) {
            return false;
        }
    }
    return true;
}

/** Every point of the largest design: a smaller one has the first of them. */
static bool accepts_design(clod_loader *loader, const clod_plan *self,
                           const clod_plan_test *test)
{
    const size_t most = self->points > 0 ? (size_t)self->points : CLOD_PLAN_BUDGET_POINTS;
    const size_t count = clod_plan_design_points(self->parameter_count, most);
    double *places = clod_memory_alloc(count * self->parameter_count, sizeof *places);
    bool good = places != NULL && clod_sobol_fill(self->parameter_count, count, places);
    loader->report->lost = loader->report->lost || !good;
    for (size_t i = 0; i < count && good; i++) {
        good = accepts(loader, self, test, places + i * self->parameter_count);
    }
    clod_memory_free(places);
    return good;
}

bool clod_plan_check_places(clod_loader *loader, const clod_plan *self, clod_plan_test *test)
{
    if (!accepts_ends(loader, self, test) || !accepts_corners(loader, self, test) ||
        !accepts_design(loader, self, test)) {
        return false;
    }
    clod_status status = {CLOD_OK, ""};
    test->middle = clod_plan_case(self, test, NULL, &status);
    loader->report->lost = loader->report->lost || test->middle == NULL; // it did load
    return test->middle != NULL;
}
