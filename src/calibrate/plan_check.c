#include "calibrate/plan_check.h"

#include <stdio.h>
#include <string.h>

#include "calibrate/test_kinds.h"
#include "config/unit.h"
#include "sim/free_summary.h"

#define PATH CLOD_LOAD_PATH

/** A number and the unit behind it. */
static bool read_end(clod_loader *loader, const clod_plan_parameter *self, const char *end,
                     const char *text, double *number, char unit[CLOD_PLAN_UNIT])
{
    char path[PATH];
    snprintf(path, sizeof path, "parameters.%.60s.%s", self->name, end);
    const char *rest = clod_unit_number(text, number);
    if (rest == NULL || strlen(rest) >= CLOD_PLAN_UNIT) {
        clod_check_fail(loader, path, "%s is no number with a unit", text);
        return false;
    }
    if (rest[0] == ',') {
        clod_check_fail(loader, path, "%s: write the decimal point as a point, not a comma",
                        text);
        return false;
    }
    snprintf(unit, CLOD_PLAN_UNIT, "%s", rest);
    return true;
}

static void check_range(clod_loader *loader, clod_plan_parameter *self)
{
    char path[PATH];
    char unit[CLOD_PLAN_UNIT];
    if (!read_end(loader, self, "from", self->from, &self->low, self->unit) ||
        !read_end(loader, self, "to", self->to, &self->high, unit)) {
        return;
    }
    snprintf(path, sizeof path, "parameters.%.60s.to", self->name);
    if (strcmp(self->unit, unit) != 0) {
        clod_check_fail(loader, path,
                        "has the unit \"%s\", but from has \"%s\"; give both in one", unit,
                        self->unit);
    } else if (!(self->high > self->low)) {
        clod_check_fail(loader, path, "%s is not above from, %s", self->to, self->from);
    } else if (self->scale == CLOD_PLAN_LOG && self->low <= 0.0) {
        snprintf(path, sizeof path, "parameters.%.60s.from", self->name);
        clod_check_fail(loader, path,
                        "%s: a log scale begins above 0; give a small value, or scale: "
                        "linear",
                        self->from);
    }
}

/** Factors of the other keys that move with a parameter. */
static void check_multiples(clod_loader *loader, const clod_plan_parameter *self)
{
    for (size_t m = 1; m <= self->multiple_count; m++) {
        double factor;
        const char *text = self->multiples[m - 1].value;
        const char *rest = clod_unit_number(text, &factor);
        if (rest == NULL || rest[0] != '\0' || !(factor > 0.0)) {
            char path[PATH];
            snprintf(path, sizeof path, "parameters.%.60s.multiples.%.200s", self->name,
                     clod_plan_key(self, m));
            clod_check_fail(
                loader, path,
                "%.100s is no factor: write how many times the value of %s this key gets, a "
                "number above 0 without unit",
                text, self->key);
        }
    }
}

/** The parameter that another one multiplies. */
static void check_times(clod_loader *loader, const clod_plan *self, clod_plan_parameter *of)
{
    char path[PATH];
    snprintf(path, sizeof path, "parameters.%.60s.times", of->name);
    for (size_t k = 0; k < self->parameter_count; k++) {
        if (strcmp(self->parameters[k].name, of->times) == 0) {
            of->base = &self->parameters[k];
        }
    }
    if (of->base == NULL) {
        clod_check_fail(
            loader, path,
            "there is no parameter %.60s; name a parameter of this plan, whose value is multiplied",
            of->times);
    } else if (of->base == of || of->base->times != NULL) {
        clod_check_fail(loader, path, "%s %s; name a parameter without times", of->times,
                        of->base == of ? "is this parameter itself" : "has times as well");
    } else if (of->unit[0] != '\0') {
        snprintf(path, sizeof path, "parameters.%.60s.from", of->name);
        clod_check_fail(
            loader, path,
            "has the unit \"%s\", but with times it is by how much %s is multiplied; give pure "
            "numbers",
            of->unit, of->times);
    }
}

/** Settings of a test that are not its own to make. */
static bool check_set(clod_loader *loader, const clod_plan *self, const clod_plan_test *test)
{
    bool good = true;
    for (size_t s = 0; s < test->set_count; s++) {
        char path[PATH];
        const char *key = test->set[s].key;
        snprintf(path, sizeof path, "tests.%.60s.set.%.300s", test->name, key);
        if (strcmp(key, "seed") == 0) {
            clod_check_fail(
                loader, path,
                "every packing gets a seed of its own; leave it out, and give seed in the plan");
            good = false;
        }
        for (size_t k = 0; k < self->parameter_count; k++) {
            const clod_plan_parameter *of = &self->parameters[k];
            for (size_t m = 0; m <= of->multiple_count; m++) {
                if (strcmp(clod_plan_key(of, m), key) == 0) {
                    clod_check_fail(
                        loader, path,
                        "is a key of the parameter %s, which gives it at every point; keep one of "
                        "them",
                        of->name);
                    good = false;
                }
            }
        }
    }
    return good;
}

/** A complaint about a case that is refused with the test's settings: at the setting that it names. */
static void fail_plain(clod_loader *loader, const clod_plan_test *test, const char *why,
                       const clod_plan_settings *settings)
{
    char path[PATH];
    snprintf(path, sizeof path, "tests.%.60s", test->name);
    for (size_t s = 0; s < settings->count; s++) {
        char begin[CLOD_STATUS_TEXT];
        const int length = snprintf(begin, sizeof begin, "--set %s: ", settings->items[s]);
        if (strncmp(why, begin, (size_t)length) == 0) {
            const size_t key = strlen(test->set[s].key);
            why += length;
            why += strncmp(why, test->set[s].key, key) == 0 && strncmp(why + key, ": ", 2) == 0
                       ? key + 2
                       : 0;
            snprintf(path, sizeof path, "tests.%.60s.set.%.300s", test->name, test->set[s].key);
            break;
        }
    }
    clod_check_fail(loader, path, "%.800s", why);
}

/** Whether the case of a test loads with its settings, whatever the parameters. */
static bool loads(clod_loader *loader, const clod_plan_test *test)
{
    clod_plan_settings settings;
    clod_status status = {CLOD_OK, ""};
    if (!clod_plan_settings_of_test(test, &settings)) {
        clod_plan_settings_fini(&settings);
        loader->report->lost = true;
        return false;
    }
    clod_case *plain = clod_case_load(test->path, (const char *const *)settings.items,
                                      settings.count, &status);
    const bool good = plain != NULL;
    if (!good) {
        fail_plain(loader, test, clod_plan_check_reason(&status), &settings);
    }
    clod_case_destroy(&plain);
    clod_plan_settings_fini(&settings);
    return good;
}

static void check_test(clod_loader *loader, const clod_plan *self, clod_plan_test *test)
{
    char path[PATH];
    snprintf(path, sizeof path, "tests.%.60s", test->name);
    if (strspn(test->name,
               "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") !=
        strlen(test->name)) {
        clod_check_fail(loader, path, "is no name for folders; use letters, digits, - and _");
        return;
    }
    clod_status status = {CLOD_OK, ""};
    if (!check_set(loader, self, test) || !loads(loader, test) ||
        !clod_plan_check_places(loader, self, test)) {
        return;
    }
    const clod_test_kind *kind = clod_test_kinds_of(test->middle);
    const int64_t seeds = kind->seeds(test->middle);
    if (kind->numbers == NULL) {
        clod_check_fail(loader, path, "is a contact bench; only tests and free runs are run");
    } else if (seeds > 1) {
        clod_check_fail(loader, path,
                        "the case has seeds: %lld; leave it out there, and give seeds here",
                        (long long)seeds);
    } else if (kind->paths && !clod_free_summary_paths(test->middle, &test->paths, &status)) {
        clod_check_fail(loader, path, "%.800s", status.text);
    }
}

const char *clod_plan_check_reason(clod_status *why)
{
    why->text[strcspn(why->text, "\n")] = '\0';
    return why->text;
}

static void check_numbers(clod_loader *loader, const clod_plan *self)
{
    const size_t least = clod_plan_least_points(self->parameter_count);
    if (self->budget > 0.0 && self->points > 0) {
        clod_check_fail(loader, "points", "has a budget beside it; keep one of them");
    } else if (self->budget <= 0.0 && self->points == 0) {
        clod_check_fail(loader, "",
                        "needs the key budget, for instance budget: 2 h, or points");
    } else if (self->points > 0 && (size_t)self->points < least) {
        clod_check_fail(loader, "points",
                        "%lld is out of range; %zu parameters need at least %zu",
                        (long long)self->points, self->parameter_count, least);
    }
    if (self->parameter_count > CLOD_PLAN_PARAMETERS) {
        clod_check_fail(loader, "parameters", "are %zu; at most %d can be calibrated together",
                        self->parameter_count, CLOD_PLAN_PARAMETERS);
    }
}

/** Each key once, whichever parameter has it. */
static void check_once(clod_loader *loader, const clod_plan *self, size_t k, size_t m)
{
    const char *key = clod_plan_key(&self->parameters[k], m);
    for (size_t i = 0; i <= k; i++) {
        const clod_plan_parameter *other = &self->parameters[i];
        const size_t end = i == k ? m : other->multiple_count + 1;
        for (size_t j = 0; j < end; j++) {
            if (strcmp(clod_plan_key(other, j), key) == 0) {
                clod_check_fail(loader, "parameters", "%s and %s have the same key, %s",
                                other->name, self->parameters[k].name, key);
            }
        }
    }
}

/** A test that no target names would be run at every point for nothing. */
static void check_named(clod_loader *loader, const clod_plan *self)
{
    for (size_t k = 0; k < self->test_count; k++) {
        bool named = false;
        for (size_t m = 0; m < self->wish_count; m++) {
            named = named || strcmp(self->wishes[m].test, self->tests[k].name) == 0;
        }
        if (!named) {
            char path[PATH];
            snprintf(path, sizeof path, "tests.%.60s", self->tests[k].name);
            clod_check_fail(
                loader, path,
                "no target names this test, so its run at every point would tell nothing; give it "
                "one, with held_back: true if it is only to be predicted, or remove the test");
        }
    }
}

void clod_plan_check(clod_loader *loader, clod_plan *self)
{
    check_numbers(loader, self);
    for (size_t k = 0; k < self->parameter_count; k++) {
        clod_plan_parameter *of = &self->parameters[k];
        clod_plan_check_key(loader, of);
        check_range(loader, of);
        check_multiples(loader, of);
        for (size_t m = 0; m <= of->multiple_count; m++) {
            check_once(loader, self, k, m);
        }
    }
    for (size_t k = 0; k < self->parameter_count && loader->report->count == 0; k++) {
        if (self->parameters[k].times != NULL) {
            check_times(loader, self, &self->parameters[k]);
        }
    }
    for (size_t k = 0; k < self->test_count && loader->report->count == 0; k++) {
        check_test(loader, self, &self->tests[k]);
    }
    if (loader->report->count == 0 && !loader->report->lost) {
        clod_plan_make_targets(loader, self);
    }
    if (loader->report->count == 0) { // or a target may have its name wrong
        check_named(loader, self);
    }
}
