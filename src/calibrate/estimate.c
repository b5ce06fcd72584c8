#include "calibrate/estimate.h"

#include <math.h>
#include <stdio.h>

#include "base/memory.h"
#include "base/plural.h"
#include "clod/check.h"
#include "sim/check_testers.h"

#define HOPELESS 3.0 ///< times the budget
#define WHOLE 10.0   ///< s, from which on whole ones are enough

/** What clod check warns of a test. */
static void add_warnings(const clod_plan_test *test, const clod_check_report *report,
                         clod_warning_list *warnings)
{
    for (size_t w = 0; w < report->warning_count; w++) {
        clod_warning_list_add(warnings, "test %s, in the middle of all ranges: %s", test->name,
                              report->warning[w]);
    }
}

bool clod_estimate_make(const clod_plan *plan, int workers, clod_estimate *self,
                        clod_warning_list *warnings, clod_status *status)
{
    const clod_check_options alone = {.threads = 1};
    clod_check_report *report = clod_memory_alloc(1, sizeof *report);
    *self = (clod_estimate){.least = clod_plan_least_points(plan->parameter_count)};
    bool good = report != NULL || clod_status_fail(status, CLOD_FAILED, "No memory to check.");
    for (size_t t = 0; good && t < plan->test_count; t++) {
        good = clod_check_report_make(plan->tests[t].middle, &alone, report, status);
        if (good) {
            self->each += report->clock_likely;
            add_warnings(&plan->tests[t], report, warnings);
        }
    }
    self->each *= (double)plan->seeds / workers;
    self->points = plan->points > 0 ? (double)plan->points
                                    : fmin(floor(plan->budget / self->each), CLOD_PLAN_POINTS);
    clod_memory_free(report);
    return good;
}

const char *clod_estimate_clock(double seconds, char words[CLOD_ESTIMATE_WORDS])
{
    if (seconds >= WHOLE) {
        return clod_check_clock_words(seconds, words);
    }
    snprintf(words, CLOD_ESTIMATE_WORDS, "%.2g s", seconds);
    return words;
}

bool clod_estimate_hopeless(const clod_estimate *self, const clod_plan *plan)
{
    return plan->points == 0 && (double)self->least * self->each > HOPELESS * plan->budget;
}

void clod_estimate_text(const clod_estimate *self, const clod_plan *plan, int workers,
                        char *text, size_t size)
{
    char point[128], words[CLOD_ESTIMATE_WORDS], most[CLOD_ESTIMATE_WORDS];
    snprintf(point, sizeof point,
             "by the estimate of clod check a point takes %s with %d run%s side by side",
             clod_estimate_clock(self->each, words), workers, clod_plural(workers));
    if (plan->points > 0) {
        snprintf(text, size, "%s, and %.0f point%s %s", point, self->points,
                 clod_plural(self->points),
                 clod_estimate_clock(self->points * self->each, words));
    } else if (self->points < (double)self->least) {
        snprintf(text, size,
                 "%sthe budget of %s looks too small: %s, so %.0f fit%s, and %zu "
                 "parameter%s need%s at least %zu: %s. Smaller cells, softer contacts or "
                 "fewer seeds make runs shorter.",
                 clod_estimate_hopeless(self, plan) ? "" : "WARNING: ",
                 clod_estimate_clock(plan->budget, words), point, self->points,
                 self->points == 1.0 ? "s" : "", plan->parameter_count,
                 clod_plural((double)plan->parameter_count),
                 plan->parameter_count == 1 ? "s" : "", self->least,
                 clod_estimate_clock((double)self->least * self->each, most));
    } else {
        snprintf(text, size, "%s: about %.0f points fit the budget of %s", point, self->points,
                 clod_estimate_clock(plan->budget, words));
    }
}
