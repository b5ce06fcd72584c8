#include "calibrate/plan_check.h"

#include <stdio.h>
#include <string.h>

#include "calibrate/test_kinds.h"
#include "config/unit.h"
#include "sim/free_summary.h"

#define PATH 200

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
    clod_case *plain = clod_case_load(test->path, NULL, 0, &status);
    if (plain == NULL) {
        clod_check_fail(loader, path, "%.800s", clod_plan_check_reason(&status));
        return;
    }
    clod_case_destroy(&plain);
    if (!clod_plan_check_places(loader, self, test)) {
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
    for (size_t k = 0; k < self->parameter_count; k++) {
        for (size_t m = 0; m < k; m++) {
            if (strcmp(self->parameters[k].key, self->parameters[m].key) == 0) {
                clod_check_fail(loader, "parameters", "%s and %s have the same key, %s",
                                self->parameters[m].name, self->parameters[k].name,
                                self->parameters[k].key);
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
        clod_plan_check_key(loader, &self->parameters[k]);
        check_range(loader, &self->parameters[k]);
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
