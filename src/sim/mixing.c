#include "sim/mixing.h"

#include <math.h>

#include "analysis/prose.h"
#include "base/cell_count.h"
#include "base/json.h"
#include "base/memory.h"
#include "measure/mixing_grid.h"
#include "setup/domain.h"

/** Columns of each index. */
static const char *const COLUMN[CLOD_MIXING_COLUMNS] = {
    "lacey [1]", "variance [1]", "random_variance [1]", "share [1]", "grains_per_cell [1]"};

#define SOLID 1000.0 ///< kg/m3, of the unit of masses: any density does

/** What one remembers. */
typedef struct mixing_memory {
    clod_mixing now; ///< of the last look
    clod_mixing_mean mean;
} mixing_memory;

void clod_mixing_mean_note(clod_mixing_mean *self, const clod_free_moment *now, double value)
{
    const int block = clod_steady_time_block(&now->steady, now->state->time);
    if (block >= 0 && !isnan(value)) {
        self->samples[block]++;
        self->sum[block] += value;
    }
}

void clod_mixing_mean_of(const clod_mixing_mean *self, double *mean, double *deviation)
{
    double each[CLOD_STEADY_BLOCKS], sum = 0.0;
    int64_t samples = 0;
    for (int b = 0; b < CLOD_STEADY_BLOCKS; b++) {
        each[b] = self->sum[b] / (double)self->samples[b]; // NAN without samples
        sum += self->sum[b];
        samples += self->samples[b];
    }
    *mean = sum / (double)samples;
    *deviation = clod_steady_time_deviation(each, CLOD_STEADY_BLOCKS);
}

void clod_mixing_mean_write(FILE *out, const clod_mixing_mean *self, double scale,
                            const char *unit)
{
    double mean, deviation;
    clod_mixing_mean_of(self, &mean, &deviation);
    if (isnan(mean)) {
        fputs("none in the steady time", out);
    } else {
        char text[32];
        const char *spread = clod_prose_deviation(text, mean * scale, deviation * scale);
        fprintf(out, "%.4g%s%s in the steady time%s", mean * scale, spread, unit,
                spread[0] != '\0' ? " (+- standard deviation of ten blocks)" : "");
    }
}

static size_t mixing_size(const clod_case *from)
{
    return from->mixing_count * sizeof(mixing_memory);
}

/** Samples of the case's region. */
static clod_mixing_grid grid_of(const clod_case *from, const clod_case_mixing *asked)
{
    clod_mixing_grid self = {.region = clod_setup_domain_region(&asked->region),
                             .cell = asked->cell,
                             .material = -1,
                             .above = asked->above,
                             .unit = SOLID * asked->cell * asked->cell * asked->cell};
    for (int a = 0; a < 3; a++) {
        const double length = self.region.high[a] - self.region.low[a];
        self.cells[a] = (int64_t)clod_cell_count(length, self.cell);
    }
    if (asked->material != NULL) {
        self.material = clod_case_material_index(from, asked->material);
    }
    return self;
}

/** The index of the moment, of samples that are counted or weighed. */
static bool find_index(const clod_mixing_grid *grid, const clod_case_mixing *asked,
                       const clod_survey *survey, clod_mixing *to, clod_status *status)
{
    const bool weighs = asked->by == CLOD_MIXING_BY_MASS;
    const size_t cells = clod_mixing_grid_samples(grid);
    void *samples = clod_memory_alloc(cells, weighs ? sizeof(clod_mixing_weighed)
                                                    : sizeof(clod_mixing_sample));
    if (samples == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the samples of mixing.%s",
                                asked->name);
    }
    const bool good = weighs ? clod_mixing_grid_weigh(grid, survey, samples, status)
                             : clod_mixing_grid_count(grid, survey, samples, status);
    if (good) {
        *to = weighs ? clod_mixing_of_mass(samples, cells) : clod_mixing_of(samples, cells);
    }
    clod_memory_free(samples);
    return good;
}

static bool look_at(mixing_memory *self, const clod_case_mixing *asked,
                    const clod_free_moment *now, clod_status *status)
{
    const clod_mixing_grid grid = grid_of(now->from, asked);
    const bool good = find_index(&grid, asked, now->survey, &self->now, status);
    if (good) {
        clod_mixing_mean_note(&self->mean, now, self->now.index);
    }
    return good;
}

static bool mixing_look(void *memory, const clod_free_moment *now, clod_status *status)
{
    mixing_memory *self = memory;
    bool good = true;
    for (size_t k = 0; good && k < now->from->mixing_count; k++) {
        good = look_at(&self[k], &now->from->mixings[k], now, status);
    }
    return good;
}

static size_t mixing_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    return from->mixing_count * CLOD_MIXING_COLUMNS;
}

static void mixing_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                          size_t size)
{
    (void)state;
    snprintf(text, size, "mixing_%s.%s", from->mixings[k / CLOD_MIXING_COLUMNS].name,
             COLUMN[k % CLOD_MIXING_COLUMNS]);
}

static void mixing_row(void *memory, const clod_free_moment *now, double *row)
{
    const mixing_memory *self = memory;
    for (size_t k = 0; k < now->from->mixing_count; k++) {
        const clod_mixing *of = &self[k].now;
        *row++ = of->index;
        *row++ = of->variance;
        *row++ = of->random;
        *row++ = of->share;
        *row++ = of->grains;
    }
}

/** Why there is no index. */
static const char *lack_of(const clod_mixing *of)
{
    if (isnan(of->share)) {
        return "no grain in the region";
    }
    if (!(of->segregated > 0.0)) {
        return "one kind of grains in the region";
    }
    return isnan(of->random) ? "all grains in one cell" : "too few grains in a cell";
}

static void mixing_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    const mixing_memory *self = memory;
    for (size_t k = 0; k < now->from->mixing_count; k++) {
        const clod_mixing *of = &self[k].now;
        fprintf(out, "  mixing %-14s Lacey's index %s", now->from->mixings[k].name,
                now->from->mixings[k].by == CLOD_MIXING_BY_MASS ? "by mass " : "");
        if (isnan(of->index)) {
            fprintf(out, "none at the end (%s), ", lack_of(of));
        } else {
            fprintf(out, "%.4g at the end, ", of->index);
        }
        clod_mixing_mean_write(out, &self[k].mean, 1.0, "");
        if (!isnan(of->share)) {
            fprintf(out, "; share %.4g, %.3g grains a cell", of->share, of->grains);
        }
        fputc('\n', out);
    }
}

static bool mixing_told(const clod_case *from)
{
    return from->mixing_count > 0;
}

static void mixing_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)state;
    for (size_t m = 0; m < from->mixing_count; m++) {
        clod_free_paths_add(paths, from->mixings[m].name,
                            "since_s lacey mean deviation variance segregated_variance "
                            "random_variance share grains_per_cell");
    }
}

static json_t *mixing_json(const void *memory, const clod_free_moment *now)
{
    const mixing_memory *self = memory;
    json_t *all = json_object();
    for (size_t k = 0; k < now->from->mixing_count; k++) {
        const clod_mixing *of = &self[k].now;
        double mean, deviation;
        clod_mixing_mean_of(&self[k].mean, &mean, &deviation);
        json_object_set_new(
            all, now->from->mixings[k].name,
            json_pack("{s:s, s:f, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "by",
                      now->from->mixings[k].by == CLOD_MIXING_BY_MASS ? "mass" : "number",
                      "since_s", now->steady.since, "lacey", clod_json_number(of->index),
                      "mean", clod_json_number(mean), "deviation", clod_json_number(deviation),
                      "variance", clod_json_number(of->variance), "segregated_variance",
                      clod_json_number(of->segregated), "random_variance",
                      clod_json_number(of->random), "share", clod_json_number(of->share),
                      "grains_per_cell", clod_json_number(of->grains)));
    }
    return all;
}

const clod_free_measure CLOD_MEASURE_MIXING = {.key = "mixing",
                                               .paths = mixing_paths,
                                               .size = mixing_size,
                                               .look = mixing_look,
                                               .columns = mixing_columns,
                                               .column = mixing_column,
                                               .row = mixing_row,
                                               .report = mixing_report,
                                               .told = mixing_told,
                                               .json = mixing_json};
