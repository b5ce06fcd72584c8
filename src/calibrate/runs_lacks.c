/**
 * @file runs_lacks.c
 * Numbers that finished runs do not define, and those that count as 0 there.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/input.h"
#include "base/memory.h"
#include "base/plural.h"
#include "calibrate/number.h"
#include "calibrate/runs.h"

#define MOST_BYTES ((size_t)1 << 24) // of a report

/** Numbers of the targets of a row's test, and sigma_1 of its run where they go along a table.
 *  @param numbers  [out] [2][targets]; those of other tests stay  @return false: it has no results */
static bool read(const clod_runs *self, size_t row, double *numbers)
{
    char folder[PATH_MAX];
    clod_status none = {CLOD_OK, ""};
    clod_runs_path(self, row, "", folder);
    return self->rows[row].state == CLOD_RUNS_DONE &&
           clod_number_read(self->plan, clod_runs_test_of(self->plan, row), folder, numbers,
                            numbers + self->plan->target_count, &none);
}

static size_t rows_of(const clod_runs *self)
{
    return clod_runs_row_of(self->plan, self->points, 0, 0);
}

static bool has_amounts(const clod_plan *plan)
{
    bool found = false;
    for (size_t t = 0; t < plan->target_count; t++) {
        found = found || clod_number_is_amount(plan, &plan->targets[t]);
    }
    return found;
}

/** Runs that have the number of a target, and those of them in which it counts as 0. */
typedef struct zeros {
    size_t runs, zeros;
} zeros;

static void count_zeros(const clod_runs *self, size_t row, double *numbers, zeros *all)
{
    const clod_plan *plan = self->plan;
    if (!read(self, row, numbers)) {
        return;
    }
    for (size_t t = 0; t < plan->target_count; t++) {
        const clod_plan_target *target = &plan->targets[t];
        const double stress = numbers[plan->target_count + t];
        if (target->test == clod_runs_test_of(plan, row) && isfinite(numbers[t]) &&
            clod_number_is_amount(plan, target)) {
            all[t].runs++;
            all[t].zeros += numbers[t] == clod_number_moved(target, 0.0, stress) ? 1 : 0;
        }
    }
}

void clod_runs_warn_zeros(const clod_runs *self, clod_warning_list *to)
{
    const clod_plan *plan = self->plan;
    const size_t count = plan->target_count;
    if (!has_amounts(plan)) {
        return;
    }
    zeros *all = clod_memory_alloc(count, sizeof *all);
    double *numbers = clod_memory_alloc(2 * count, sizeof *numbers);
    const bool good = all != NULL && numbers != NULL;
    for (size_t row = 0; row < rows_of(self) && good; row++) {
        count_zeros(self, row, numbers, all);
    }
    for (size_t t = 0; t < count && good; t++) {
        if (all[t].zeros > 0) {
            clod_warning_list_add(
                to,
                "%s counts as 0 in %zu of %zu run%s%s. Such a run tells no more than that nothing was above 0, and not how "
                "far from it the solid is, but its surrogate takes 0 for a measured value and goes on below it: narrow the "
                "ranges to where it is above 0. What is predicted ends at 0.",
                plan->targets[t].name, all[t].zeros, all[t].runs,
                clod_plural((double)all[t].runs),
                strcmp(plan->targets[t].number, "sigma_c") == 0 ? ": specimens did not stand"
                                                                : "");
        }
    }
    if (!good) {
        clod_warning_list_add(to, "No memory to look for runs whose numbers count as 0.");
    }
    clod_memory_free(all);
    clod_memory_free(numbers);
}

/** Length of the word that a text begins with. */
static size_t word(const char *text)
{
    return strcspn(text, " \n");
}

/** What a line of a report says of the thing that a path names: "  repose heap    TEXT" of repose.heap.angle_deg, "  wall base
 *  TEXT" of walls.base.force_N.2; NULL: it is of another one. */
static const char *says(const char *line, const char *path)
{
    line += strspn(line, " ");
    const size_t kind = word(line);
    if (kind == 0 || strncmp(path, line, kind) != 0) {
        return NULL;
    }
    path += kind + (path[kind] == 's' ? 1 : 0);
    line += kind + strspn(line + kind, " ");
    const size_t name = word(line);
    if (name == 0 || path[0] != '.' || strncmp(path + 1, line, name) != 0 ||
        path[1 + name] != '.') {
        return NULL;
    }
    return line + name + strspn(line + name, " ");
}

/** ": TEXT" of the report of a run, or "". */
static void find_reason(const clod_runs *self, size_t row, const char *path, char *text,
                        size_t size)
{
    char file[PATH_MAX], *report;
    size_t length;
    clod_status none = {CLOD_OK, ""};
    clod_runs_path(self, row, "/report.txt", file);
    text[0] = '\0';
    if (!clod_input_read_regular(file, MOST_BYTES, &report, &length, &none)) {
        return;
    }
    for (const char *line = report; text[0] == '\0' && *line != '\0';) {
        const char *found = says(line, path);
        if (found != NULL) {
            snprintf(text, size, ": %.*s", (int)strcspn(found, "\n"), found);
        }
        line += strcspn(line, "\n");
        line += *line == '\n' ? 1 : 0;
    }
    clod_memory_free(report);
}

bool clod_runs_lacks(const clod_runs *self, size_t target, char text[CLOD_RUNS_REASON])
{
    const clod_plan_target *of = &self->plan->targets[target];
    double *numbers = clod_memory_alloc(2 * self->plan->target_count, sizeof *numbers);
    bool found = false;
    text[0] = '\0';
    for (size_t row = 0; row < rows_of(self) && numbers != NULL && !found; row++) {
        found = clod_runs_test_of(self->plan, row) == of->test && read(self, row, numbers) &&
                !isfinite(numbers[target]);
        if (found) {
            clod_runs_name(self->plan, row, "", text);
            const size_t used = strlen(text);
            find_reason(self, row, of->number, text + used, CLOD_RUNS_REASON - used);
        }
    }
    clod_memory_free(numbers);
    return found;
}
