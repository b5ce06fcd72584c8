#include "calibrate/estimate.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/plural.h"
#include "clod/check.h"
#include "sim/check_testers.h"

#define HOPELESS 3.0 ///< times the budget
#define FITS                                                                                   \
    4 ///< behind the design, two thirds of the points, and behind each of three batches
#define SHORT 30.0 ///< s of fits that need no word
#define SMALL 0.1  ///< of the time of the runs: as little
#define WHOLE 10.0 ///< s, from which on whole ones are enough

/** What clod check warns of a test. */
static void add_warnings(const clod_plan_test *test, const clod_check_report *report,
                         clod_warning_list *warnings)
{
    for (size_t w = 0; w < report->warning_count; w++) {
        clod_warning_list_add(warnings, "test %s, in the middle of all ranges: %s", test->name,
                              report->warning[w]);
    }
}

double clod_estimate_points(const clod_plan *plan, double each)
{
    return fmin(floor(plan->budget / each), CLOD_PLAN_BUDGET_POINTS);
}

double clod_estimate_fits(const clod_plan *plan, double points)
{
    // matrices take the third power of the points, and the chain, whose steps fall with their square, the first
    double seconds = 0.0;
    for (int k = 0; k < FITS; k++) {
        const double of = points * (2.0 / 3.0 + k / (3.0 * (FITS - 1)));
        seconds += 0.012 * of + 4.5e-7 * of * of * of;
    }
    return 0.5 * (double)plan->parameter_count * (double)plan->target_count * seconds;
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
    self->points =
        plan->points > 0 ? (double)plan->points : clod_estimate_points(plan, self->each);
    self->fits = clod_estimate_fits(plan, self->points);
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

/** What the points take, or how many fit the budget. */
static void write_points(const clod_estimate *self, const clod_plan *plan, char *text,
                         size_t size)
{
    char words[CLOD_ESTIMATE_WORDS], most[CLOD_ESTIMATE_WORDS];
    const double runs = self->points * self->each;
    if (plan->points > 0) {
        snprintf(text, size, ", and %.0f point%s %s", self->points, clod_plural(self->points),
                 clod_estimate_clock(runs, words));
    } else if (self->points < CLOD_PLAN_BUDGET_POINTS) {
        snprintf(text, size, ": about %.0f points fit the budget of %s", self->points,
                 clod_estimate_clock(plan->budget, words));
    } else {
        snprintf(
            text, size,
            ": a budget buys %d points at most, which take %s of its %s. More seeds use the "
            "rest better than more points do",
            CLOD_PLAN_BUDGET_POINTS, clod_estimate_clock(runs, most),
            clod_estimate_clock(plan->budget, words));
    }
    if (self->fits > SHORT && self->fits > SMALL * runs) {
        const size_t used = strlen(text);
        snprintf(text + used, size - used, "; the fits behind them take some %s more",
                 clod_estimate_clock(self->fits, words));
    }
}

void clod_estimate_text(const clod_estimate *self, const clod_plan *plan, int workers,
                        char *text, size_t size)
{
    char point[128], words[CLOD_ESTIMATE_WORDS], most[CLOD_ESTIMATE_WORDS];
    snprintf(point, sizeof point,
             "by the estimate of clod check a point takes %s with %d run%s side by side",
             clod_estimate_clock(self->each, words), workers, clod_plural(workers));
    if (plan->points == 0 && self->points < (double)self->least) {
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
        char points[256];
        write_points(self, plan, points, sizeof points);
        snprintf(text, size, "%s%s", point, points);
    }
}
