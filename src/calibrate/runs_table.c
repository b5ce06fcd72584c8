/**
 * @file runs_table.c
 * All runs of a calibration as one table.
 */

#include <math.h>
#include <stdio.h>

#include "base/text.h"
#include "calibrate/runs.h"

/** A text inside a quoted cell: quotes doubled. */
static void put_quoted(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        fputs(*text == '"' ? "\"\"" : (char[]){*text, '\0'}, out);
    }
}

static void put_head(FILE *out, const clod_plan *plan)
{
    fputs("point,packing", out);
    for (size_t t = 0; t < plan->test_count; t++) {
        if (plan->test_count == 1) {
            fputs(",seed", out);
        } else {
            fprintf(out, ",%s: seed", plan->tests[t].name);
        }
    }
    for (size_t k = 0; k < plan->parameter_count; k++) {
        const clod_plan_parameter *one = &plan->parameters[k];
        fprintf(out, ",%s [%s]", one->name, one->unit[0] == '\0' ? "1" : one->unit);
    }
    for (size_t t = 0; t < plan->target_count; t++) {
        const clod_plan_target *one = &plan->targets[t];
        fputc(',', out);
        fprintf(out, "%s [%s]", one->name,
                one->measure.unit[0] == '\0' ? "1" : one->measure.unit);
    }
    fputs(",failed\n", out);
}

/** Why tests of a packing failed, all in one cell. */
static void put_failed(FILE *out, const clod_runs *self, size_t point, size_t packing)
{
    size_t failed = 0;
    fputc(',', out);
    for (size_t t = 0; t < self->plan->test_count; t++) {
        const clod_runs_row *row = &self->rows[clod_runs_row_of(self->plan, point, packing, t)];
        if (row->state == CLOD_RUNS_FAILED) {
            fputs(failed++ == 0 ? "\"" : "; ", out);
            put_quoted(out, self->plan->tests[t].name);
            fputs(": ", out);
            put_quoted(out, row->why != NULL ? row->why : "it said nothing");
        }
    }
    fputs(failed > 0 ? "\"" : "", out);
}

static void put_row(FILE *out, const clod_runs *self, size_t point, size_t packing,
                    const double *places, const double *results)
{
    const clod_plan *plan = self->plan;
    const size_t d = plan->parameter_count;
    fprintf(out, "%zu,%zu", point, packing + 1);
    for (size_t t = 0; t < plan->test_count; t++) {
        const size_t row = clod_runs_row_of(plan, point, packing, t);
        fprintf(out, ",%lld", (long long)clod_runs_seed(plan, row));
    }
    for (size_t k = 0; k < d; k++) {
        fprintf(out, ",%.9g", clod_plan_number(&plan->parameters[k], places[point * d + k]));
    }
    const double *numbers =
        results + (point * (size_t)plan->seeds + packing) * plan->target_count;
    for (size_t t = 0; t < plan->target_count; t++) {
        if (isfinite(numbers[t])) {
            fprintf(out, ",%.9g", plan->targets[t].measure.factor * numbers[t]);
        } else {
            fputc(',', out);
        }
    }
    put_failed(out, self, point, packing);
    fputc('\n', out);
}

char *clod_runs_csv(const clod_runs *self, size_t points, const double *places,
                    const double *results)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    put_head(out, self->plan);
    for (size_t p = 0; p < points; p++) {
        for (size_t s = 0; s < (size_t)self->plan->seeds; s++) {
            put_row(out, self, p, s, places, results);
        }
    }
    return clod_text_close(&text);
}
