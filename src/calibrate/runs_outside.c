/**
 * @file runs_outside.c
 * Runs whose consolidation lies outside the measured table that they are compared with.
 */

#include <math.h>
#include <stdio.h>

#include "base/memory.h"
#include "base/plural.h"
#include "calibrate/number.h"
#include "calibrate/runs.h"

#define FAR 0.1 ///< of the outermost stress: nearer ones scatter about it

/** Runs outside the table of a target, and how far their sigma_1 go, Pa. */
typedef struct outside {
    size_t runs;
    double least, most;
} outside;

static void look(outside *self, const clod_curve *curve, double stress)
{
    const double first = curve->points[0].x, last = curve->points[curve->count - 1].x;
    if (stress < (1.0 - FAR) * first || stress > (1.0 + FAR) * last) {
        self->least = self->runs == 0 ? stress : fmin(self->least, stress);
        self->most = self->runs == 0 ? stress : fmax(self->most, stress);
        self->runs++;
    }
}

/** Add the runs of one row to those of each target. */
static void look_at_run(const clod_runs *self, size_t row, double *values, double *stresses,
                        outside *all)
{
    const clod_plan *plan = self->plan;
    char folder[PATH_MAX];
    clod_status none = {CLOD_OK, ""};
    for (size_t t = 0; t < plan->target_count; t++) {
        stresses[t] = (double)NAN;
    }
    clod_runs_path(self, row, "", folder);
    if (!clod_number_read(plan, clod_runs_test_of(plan, row), folder, values, stresses,
                          &none)) {
        return;
    }
    for (size_t t = 0; t < plan->target_count; t++) {
        if (isfinite(stresses[t])) {
            look(&all[t], plan->targets[t].curve, stresses[t]);
        }
    }
}

/** "15 kPa", or "15 to 20 kPa". */
static const char *name_range(double least, double most, char text[64])
{
    const int used = snprintf(text, 64, "%.4g", 1e-3 * least);
    if (most > least) {
        snprintf(text + used, 64 - (size_t)used, " to %.4g kPa", 1e-3 * most);
    } else {
        snprintf(text + used, 64 - (size_t)used, " kPa");
    }
    return text;
}

static void warn(const clod_plan *plan, const clod_plan_target *target, const outside *found,
                 clod_warning_list *to)
{
    const clod_curve *curve = target->curve;
    char runs[64], table[64];
    clod_warning_list_add(
        to,
        "%zu run%s of test %s had sigma_1 of %s, and the table of target %s has %s: %s. Add "
        "measured rows at such stresses, or consolidate the test at another one.",
        found->runs, clod_plural((double)found->runs), plan->tests[target->test].name,
        name_range(found->least, found->most, runs), target->name,
        name_range(curve->points[0].x, curve->points[curve->count - 1].x, table),
        curve->count > 1 ? "they are compared by an extrapolation"
                         : "they are compared with its one row as if they were there");
}

/** Whether any of the plan's targets goes along a table. */
static bool has_curves(const clod_plan *plan)
{
    bool found = false;
    for (size_t t = 0; t < plan->target_count; t++) {
        found = found || plan->targets[t].curve != NULL;
    }
    return found;
}

void clod_runs_warn_outside(const clod_runs *self, clod_warning_list *to)
{
    const clod_plan *plan = self->plan;
    if (!has_curves(plan)) {
        return;
    }
    outside *all = clod_memory_alloc(plan->target_count, sizeof *all);
    double *numbers = clod_memory_alloc(2 * plan->target_count, sizeof *numbers);
    const bool good = all != NULL && numbers != NULL;
    for (size_t row = 0; good && row < clod_runs_row_of(plan, self->points, 0, 0); row++) {
        if (self->rows[row].state == CLOD_RUNS_DONE) {
            look_at_run(self, row, numbers, numbers + plan->target_count, all);
        }
    }
    for (size_t t = 0; good && t < plan->target_count; t++) {
        if (all[t].runs > 0) {
            warn(plan, &plan->targets[t], &all[t], to);
        }
    }
    if (!good) {
        clod_warning_list_add(to, "No memory to look for runs outside measured tables.");
    }
    clod_memory_free(all);
    clod_memory_free(numbers);
}
