#include "clod/repose_angles.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/cells.h"
#include "analysis/csv.h"
#include "analysis/mean.h"
#include "analysis/prose.h"
#include "base/given.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"

#define DEGREES (180.0 / M_PI)
#define ROUNDING 1e-9 ///< of the mean: a smaller error is that of one and the same number

typedef clod_repose_heap heap;

// ---- reading

enum { ANGLE, ANGLE_ERROR, COLUMN_COUNT };

static const clod_csv_column COLUMNS[COLUMN_COUNT] = {
    [ANGLE] = {.names = {"angle_of_repose"},
               .unit = "rad",
               .positive = true,
               .required = true,
               .below = CLOD_REPOSE_ANGLES_MOST / DEGREES,
               .offset = offsetof(heap, angle)},
    [ANGLE_ERROR] = {.names = {"angle_of_repose_error"},
                     .unit = "rad",
                     .below = M_PI_2,
                     .offset = offsetof(heap, error)},
};

/** Numbers of the heaps: each row is one of its own, whatever they are. */
static const char *const SKIPPED[] = {"seed", "heap", NULL};

static bool check_row(const clod_csv *self, const void *row)
{
    const double angle = DEGREES * ((const heap *)row)->angle;
    return angle >= CLOD_REPOSE_ANGLES_LEAST ||
           clod_status_fail(self->status, CLOD_USAGE,
                            "%s:%zu: column angle_of_repose: %.6g deg is below %g deg, and no "
                            "solid lies so flat; is its unit another one, [rad]?",
                            self->path, self->line, angle, CLOD_REPOSE_ANGLES_LEAST);
}

static const clod_csv_kind HEAPS = {
    .columns = COLUMNS,
    .count = COLUMN_COUNT,
    .row = sizeof(heap),
    .known = "angle_of_repose, angle_of_repose_error, seed or heap, its number",
    .example = "heap,angle_of_repose [deg]",
    .item = "angle of repose",
    .skipped = SKIPPED,
    .check_row = check_row,
};

bool clod_repose_angles_parse(const char *path, const char *text, size_t length,
                              clod_repose_heap **heaps, size_t *count, clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(text, status) || !CLOD_GIVEN(heaps, status) ||
        !CLOD_GIVEN(count, status)) {
        return false;
    }
    clod_csv self = {.kind = &HEAPS, .path = path, .status = status};
    const bool good = clod_csv_parse(&self, text, length);
    *heaps = good ? self.rows : NULL;
    *count = good ? self.count : 0;
    return good;
}

// ---- the mean

/** @param work  [count] */
static clod_locus_value mean_of(const heap *heaps, size_t count, double *work)
{
    double stated = 0.0;
    bool known = true;
    for (size_t k = 0; k < count; k++) {
        work[k] = heaps[k].angle;
        stated += heaps[k].error * heaps[k].error;
        known = known && heaps[k].error > 0.0;
    }
    clod_locus_value mean = clod_mean_of(work, count, known ? stated : 0.0);
    if (count > 1) {
        mean.scatter = clod_mean_of(work, count, 0.0).error * sqrt((double)count);
    }
    if (!(mean.error > ROUNDING * mean.value)) {
        mean.error =
            (double)NAN; // one angle, set or rounded: nothing tells how well it is known
    }
    return mean;
}

/** A stated error as large as its angle: most likely the wrong column or unit. */
static void look(clod_repose_angles *self)
{
    for (size_t k = 0; k < self->heap_count; k++) {
        const heap *one = &self->heaps[k];
        if (one->error >= one->angle) {
            snprintf(
                self->warning, sizeof self->warning,
                "angle_of_repose is %.2f deg with a stated standard error of %.2f deg: nothing "
                "was measured then; check the column of errors and its unit.",
                DEGREES * one->angle, DEGREES * one->error);
            return;
        }
    }
}

bool clod_repose_angles_evaluate(const clod_repose_heap *heaps, size_t count,
                                 clod_repose_angles *self, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || (count > 0 && !CLOD_GIVEN(heaps, status))) {
        return false;
    }
    memset(self, 0, sizeof *self);
    if (count == 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "A mean angle of repose needs one heap at least.");
    }
    double *work = clod_memory_alloc(count, sizeof *work);
    self->heaps = clod_memory_alloc(count, sizeof *self->heaps);
    const bool good = work != NULL && self->heaps != NULL;
    if (good) {
        self->heap_count = count;
        memcpy(self->heaps, heaps, count * sizeof *heaps);
        self->mean = mean_of(heaps, count, work);
        look(self);
    } else {
        clod_repose_angles_fini(self);
        clod_status_fail(status, CLOD_FAILED, "No memory for %zu heaps.", count);
    }
    clod_memory_free(work);
    return good;
}

void clod_repose_angles_fini(clod_repose_angles *self)
{
    CLOD_NEED(self);
    clod_memory_free(self->heaps);
    self->heaps = NULL;
    self->heap_count = 0;
}

// ---- writing

char *clod_repose_angles_table(const clod_repose_angles *self)
{
    CLOD_NEED(self);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    const clod_locus_value *mean = &self->mean;
    fprintf(out, "Angle of repose: %zu heap%s\n\n", self->heap_count,
            self->heap_count == 1 ? "" : "s");
    fprintf(out, "  %-32s %-8s%10.2f ± ", "angle of repose", "", DEGREES * mean->value);
    clod_prose_error(out, 8, 2, DEGREES * mean->error);
    clod_prose_number(out, 10, 2, DEGREES * mean->scatter);
    fputs("  deg\n\n", out);
    fputs(
        isfinite(mean->error)
            ? "  ± one standard error of the mean, from the scatter of the heaps or their stated errors,\n"
              "  whichever is larger; then the standard deviation of one heap.\n"
            : "  No error bar: it needs two heaps of different angles, or the error of each.\n",
        out);
    if (self->warning[0] != '\0') {
        fputs("\n  Warnings\n", out);
        clod_prose_warning(out, self->warning);
    }
    return clod_text_close(&text);
}

char *clod_repose_angles_json(const clod_repose_angles *self)
{
    CLOD_NEED(self);
    json_t *heaps = json_array();
    for (size_t k = 0; k < self->heap_count; k++) {
        const heap *one = &self->heaps[k];
        json_array_append_new(
            heaps, json_pack("{s:f, s:o}", "angle_of_repose_deg", DEGREES * one->angle,
                             "angle_of_repose_error_deg",
                             clod_json_number(DEGREES * clod_cells_error(one->error))));
    }
    json_t *warnings = json_array();
    if (self->warning[0] != '\0') {
        json_array_append_new(warnings, json_string(self->warning));
    }
    json_t *all = json_pack("{s:{s:f, s:o, s:o}, s:o, s:o}", "angle_of_repose_deg", "value",
                            DEGREES * self->mean.value, "error",
                            clod_json_number(DEGREES * self->mean.error), "scatter",
                            clod_json_number(DEGREES * self->mean.scatter), "heaps", heaps,
                            "warnings", warnings);
    char *text = clod_json_text(all, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    json_decref(all);
    return text;
}

char *clod_repose_angles_csv(const clod_repose_angles *self)
{
    CLOD_NEED(self);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fputs("angle_of_repose [deg],angle_of_repose_error [deg]\n", out);
    for (size_t k = 0; k < self->heap_count; k++) {
        fprintf(out, "%.10g", DEGREES * self->heaps[k].angle);
        clod_cells_put(out, DEGREES * clod_cells_error(self->heaps[k].error));
        fputs("\n", out);
    }
    return clod_text_close(&text);
}
