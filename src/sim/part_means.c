#include "sim/part_means.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "output/folder_files.h"

#define THIRD (1.0 / 3.0)
#define MOST_PHASES 1000.0 ///< so that a number is one of int

/** Sums of the rows of each block. */
typedef struct sums {
    double *sum, *number; ///< [CLOD_STEADY_BLOCKS][count], of values that are numbers
    size_t first, count;
} sums;

/** The beginning of cell k of a line; NULL: it has fewer. */
static const char *cell_of(const char *line, size_t k)
{
    for (; k > 0 && line != NULL; k--) {
        const size_t length = strcspn(line, ",\n");
        line = line[length] == ',' ? line + length + 1 : NULL;
    }
    return line;
}

static const char *next_line(const char *line)
{
    const char *end = strchr(line, '\n');
    return end != NULL ? end + 1 : line + strlen(line);
}

/** The number of a cell, which may be NULL; false: it has none, or its line has no end. */
static bool number_of(const char *cell, double *number)
{
    if (cell == NULL || *cell == '\n') { // strtod would go on to the next line
        return false;
    }
    char *end;
    *number = strtod(cell, &end);
    return end != cell && (*end == ',' || *end == '\n');
}

/** Find the last phase and the last third of it; false: the rows are no series of a part. */
static bool find_steady(clod_part_means *self, const char *rows)
{
    double began = 0.0, before = 0.0, time = 0.0, phase = 0.0;
    bool any = false;
    for (const char *line = rows; *line != '\0'; line = next_line(line)) {
        double now;
        if (!number_of(line, &time) || !number_of(cell_of(line, 1), &now)) {
            return false;
        }
        began = !any ? time : now != phase ? before : began;
        phase = now;
        before = time;
        any = true;
    }
    self->phase = (int)phase;
    self->steady.since = time - THIRD * (time - began);
    self->steady.block = fmax(THIRD * (time - began) / CLOD_STEADY_BLOCKS, DBL_MIN);
    return any && phase >= 0.0 && phase <= MOST_PHASES;
}

/** Add a row to its block. */
static bool add_row(sums *to, const char *line, size_t block)
{
    const char *cell = cell_of(line, to->first);
    for (size_t k = 0; k < to->count; k++, cell = cell_of(cell, 1)) {
        double value;
        if (!number_of(cell, &value)) {
            return false;
        }
        if (!isnan(value)) {
            to->sum[block * to->count + k] += value;
            to->number[block * to->count + k] += 1.0;
        }
    }
    return true;
}

/** Add up the rows of the steady time, which are those of the last phase. */
static bool add_rows(clod_part_means *self, const char *rows, sums *to)
{
    double time;
    for (const char *line = rows; *line != '\0'; line = next_line(line)) {
        const int block =
            number_of(line, &time) ? clod_steady_time_block(&self->steady, time) : -1;
        if (block >= 0) {
            if (!add_row(to, line, (size_t)block)) {
                return false;
            }
            self->rows++;
        }
    }
    return true;
}

static void divide(clod_part_means *self, const sums *of)
{
    for (size_t k = 0; k < of->count; k++) {
        double each[CLOD_STEADY_BLOCKS], sum = 0.0, number = 0.0;
        for (size_t b = 0; b < CLOD_STEADY_BLOCKS; b++) {
            const double in = of->number[b * of->count + k];
            each[b] = in > 0.0 ? of->sum[b * of->count + k] / in : (double)NAN;
            sum += of->sum[b * of->count + k];
            number += in;
        }
        self->mean[k] = number > 0.0 ? sum / number : (double)NAN;
        self->deviation[k] = clod_steady_time_deviation(each, CLOD_STEADY_BLOCKS);
    }
}

/** Means of a text that is a whole file. */
static bool take(clod_part_means *self, const char *text, size_t first, size_t count,
                 clod_status *status)
{
    const size_t sizes = CLOD_STEADY_BLOCKS * count;
    double *sum = clod_memory_alloc(2 * sizes + 1, sizeof *sum);
    self->mean = clod_memory_alloc(2 * count + 1, sizeof *self->mean);
    if (sum == NULL || self->mean == NULL) {
        clod_memory_free(sum);
        return clod_status_fail(status, CLOD_FAILED, "no memory for the means of a part");
    }
    self->deviation = self->mean + count;
    sums of = {.sum = sum, .number = sum + sizes, .first = first, .count = count};
    const char *rows = next_line(text);
    const bool good = find_steady(self, rows) && add_rows(self, rows, &of);
    if (good) {
        divide(self, &of);
    }
    clod_memory_free(sum);
    return good || clod_status_fail(status, CLOD_FAILED, "it is not the series of a part");
}

bool clod_part_means_read(clod_part_means *self, const clod_folder *folder, const char *part,
                          size_t first, size_t count, clod_status *status)
{
    char name[128];
    void *text = NULL;
    size_t size;
    clod_status why = {CLOD_OK, "it is gone; put it back, and run the same command again"};
    *self = (clod_part_means){.phase = -1};
    snprintf(name, sizeof name, "%s.csv", part);
    bool good = clod_folder_read(folder, name, &text, &size, status);
    if (good && (text == NULL || !take(self, text, first, count, &why))) {
        good = clod_status_fail(status, CLOD_FAILED, "%s/%s: %s", folder->path, name, why.text);
    }
    clod_memory_free(text);
    return good;
}

void clod_part_means_fini(clod_part_means *self)
{
    clod_memory_free(self->mean);
    *self = (clod_part_means){0};
}
