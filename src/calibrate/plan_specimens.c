/**
 * @file plan_specimens.c
 * Specimens of a measured table that serve targets of two tests.
 */

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "calibrate/plan_check.h"

static bool has(const clod_plan_repeats *of, int64_t specimen)
{
    for (size_t k = 0; k < of->count && k < CLOD_PLAN_SPECIMENS; k++) {
        if (of->differences[k].specimen == specimen) {
            return true;
        }
    }
    return false;
}

/** Whether a target is a used one of a test, with rows of the table at a path. */
static bool is_of(const clod_plan *self, const clod_plan_target *one, size_t test,
                  const char *table)
{
    const char *locus = self->wishes[one->entry].locus;
    return one->test == test && !one->held_back && locus != NULL && strcmp(locus, table) == 0;
}

/** Whether a specimen stands behind a used target of a test. */
static bool serves(const clod_plan *self, size_t test, const char *table, int64_t specimen)
{
    for (size_t t = 0; t < self->target_count; t++) {
        const clod_plan_target *one = &self->targets[t];
        if (is_of(self, one, test, table) && has(&one->repeats, specimen)) {
            return true;
        }
    }
    return false;
}

/** Specimens of a target that serve the other test too, as "101, 102"; "": none. */
static const char *list_shared(const clod_plan *self, const clod_plan_target *one, size_t other,
                               char *text, size_t size)
{
    const char *table = self->wishes[one->entry].locus;
    clod_text_names names = clod_text_names_begin(text, size);
    for (size_t k = 0; k < one->repeats.count && k < CLOD_PLAN_SPECIMENS; k++) {
        const int64_t specimen = one->repeats.differences[k].specimen;
        char name[24];
        snprintf(name, sizeof name, "%" PRId64, specimen);
        if (specimen > 0 && serves(self, other, table, specimen)) { // 0: the table has no seeds
            clod_text_names_add(&names, name);
        }
    }
    clod_text_names_end(&names);
    return text;
}

/** Warn of two tests, by the first target of one of them; whether there was a reason. */
static bool warn_of_tests(clod_plan *self, const clod_plan_target *one, size_t other)
{
    char text[160];
    if (list_shared(self, one, other, text, sizeof text)[0] == '\0') {
        return false;
    }
    clod_warning_list_add(
        &self->warnings,
        "%s: specimens %s of this table serve targets of the tests %.40s and %.40s. Targets of different "
        "tests count as independent, which numbers of one specimen are not: intervals are too narrow, the more so "
        "the more specimens differ. Give each test specimens of its own, or hold back the targets of one of them.",
        self->wishes[one->entry].locus, text, self->tests[one->test].name,
        self->tests[other].name);
    return true;
}

void clod_plan_warn_shared_specimens(clod_plan *self)
{
    for (size_t test = 0; test < self->test_count; test++) {
        for (size_t other = test + 1; other < self->test_count; other++) {
            bool told = false;
            for (size_t t = 0; t < self->target_count && !told; t++) {
                const clod_plan_target *one = &self->targets[t];
                told = one->test == test && self->wishes[one->entry].locus != NULL &&
                       !one->held_back && warn_of_tests(self, one, other);
            }
        }
    }
}
