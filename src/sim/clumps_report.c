#include "sim/clumps_report.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/json.h"
#include "base/memory.h"
#include "base/plural.h"
#include "base/text.h"
#include "output/folder_files.h"
#include "sim/clumps.h"

/** Columns of each count, in the order of clod_clump_stats. */
static const char *const COLUMNS[] = {"number [1]",    "grains [1]",
                                      "mass [kg]",     "mass_share [1]",
                                      "mean_size [1]", "mass_mean_size [1]",
                                      "largest [1]",   "largest_mass [kg]",
                                      "d10 [m]",       "d50 [m]",
                                      "d90 [m]"};
enum { PER_COUNT = sizeof COLUMNS / sizeof *COLUMNS };
_Static_assert(sizeof(clod_clump_stats) == PER_COUNT * sizeof(double), "one column each");

/** Number of counts; all clumps are the first. */
static size_t counts_of(const clod_case *from)
{
    return from->clumps.present ? 1 + from->clumps.count_count : 0;
}

/** Name of a count, "" of all clumps. */
static const char *name_of(const clod_case *from, size_t count)
{
    return count == 0 ? "" : from->clumps.counts[count - 1].name;
}

size_t clod_clumps_report_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    return PER_COUNT * counts_of(from);
}

void clod_clumps_report_column(const clod_case *from, const clod_state *state, size_t k,
                               char *text, size_t size)
{
    (void)state;
    const char *name = name_of(from, k / PER_COUNT);
    snprintf(text, size, "clumps%s%s.%s", name[0] == '\0' ? "" : "_", name,
             COLUMNS[k % PER_COUNT]);
}

void clod_clumps_report_row(void *memory, const clod_free_moment *now, double *row)
{
    const clod_clump_memory *self = memory;
    for (size_t c = 0; c < counts_of(now->from); c++) {
        memcpy(row + c * PER_COUNT, &self->count[c].now, sizeof self->count[c].now);
    }
}

/** Over the steady time; NAN before there was any. */
static double mean_of(const clod_clump_memory *self, double times)
{
    return self->time > 0.0 ? times / self->time : (double)NAN;
}

static double ratio(double a, double b)
{
    return b > 0.0 ? a / b : 0.0;
}

// ---- times in clumps

/** Time that a fraction of the grains were not in a clump for longer [s]. */
static double time_quantile(const clod_clump_memory *self, double fraction)
{
    const clod_clump_lives *lives = &self->lives;
    const double range[2] = {lives->least, lives->most};
    return clod_time_class_quantile(lives->count, lives->grains, fraction, range);
}

static double mean_time(const clod_clump_memory *self)
{
    return ratio(clod_exact_value(&self->lives.sum), (double)self->lives.grains);
}

// ---- report

static void report_count(FILE *out, const clod_clump_memory *self, const clod_case *from,
                         size_t c)
{
    const clod_clump_count *count = &self->count[c];
    const clod_clump_stats *mean = &count->mean, *end = &count->now;
    const char *name = name_of(from, c);
    fprintf(out,
            "  clumps %-14s mean %.4g clump%s of %.3g grains, %.4g kg, %.3g %% of the mass; "
            "largest %.0f grains, %.3g kg\n",
            name, mean_of(self, mean->number), clod_plural(mean_of(self, mean->number)),
            ratio(mean->grains, mean->number), mean_of(self, mean->mass),
            100.0 * mean_of(self, mean->share), count->most.largest, count->most.largest_mass);
    if (end->number > 0.0) {
        fprintf(out,
                "                        at the end %.0f clump%s, %.0f grains, %.4g kg; d10, "
                "d50, d90 by mass %.3g, %.3g, %.3g mm\n",
                end->number, clod_plural(end->number), end->grains, end->mass, 1e3 * end->d10,
                1e3 * end->d50, 1e3 * end->d90);
    }
}

/** Grains that left the space through sides and outlets. */
static int64_t left_in_all(const clod_exchange *gone, bool alone)
{
    int64_t sum = 0;
    for (int k = alone ? 0 : 1; k <= CLOD_CLUMP_CLASSES; k++) {
        sum += gone->left_clumps[k];
    }
    return sum;
}

void clod_clumps_report_lines(FILE *out, const void *memory, const clod_free_moment *now)
{
    const clod_clump_memory *self = memory;
    if (counts_of(now->from) == 0) {
        return;
    }
    if (self->time > 0.0) {
        for (size_t c = 0; c < counts_of(now->from); c++) {
            report_count(out, self, now->from, c);
        }
    } else {
        fprintf(out, "  clumps                no means: the run ended before %.6g s\n",
                now->steady.since);
    }
    if (self->lives.grains > 0) {
        fprintf(out,
                "  time in clumps        %.4g s (10, 50, 90 %%: %.3g, %.3g, %.3g s) of the "
                "%" PRId64 " time%s that a grain left its clump\n",
                mean_time(self), time_quantile(self, 0.1), time_quantile(self, 0.5),
                time_quantile(self, 0.9), self->lives.grains,
                clod_plural((double)self->lives.grains));
    }
    const int64_t gone = left_in_all(&now->state->exchange, true);
    if (gone > 0) {
        const int64_t clumped = left_in_all(&now->state->exchange, false);
        fprintf(out, "  left in clumps        %" PRId64 " of %" PRId64 " grain%s, %.3g %%\n",
                clumped, gone, clod_plural((double)gone),
                100.0 * (double)clumped / (double)gone);
    }
}

// ---- summary

static json_t *stats_json(const clod_clump_stats *stats)
{
    return json_pack("{s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:f}", "number",
                     stats->number, "grains", stats->grains, "mass_kg", stats->mass,
                     "mass_share", stats->share, "mean_size", stats->mean, "mass_mean_size",
                     stats->mean_by_mass, "largest", stats->largest, "largest_mass_kg",
                     stats->largest_mass, "d10_m", stats->d10, "d50_m", stats->d50, "d90_m",
                     stats->d90);
}

/** Largest class that ever had a clump; -1: none. */
static int last_class(const clod_clump_sizes *sizes)
{
    int last = CLOD_CLUMP_CLASSES - 1;
    while (last >= 0 && sizes->number[last] == 0.0) {
        last--;
    }
    return last;
}

static json_t *sizes_json(const clod_clump_memory *self, const clod_clump_sizes *sizes)
{
    json_t *list = json_array();
    for (int k = 0; k <= last_class(sizes); k++) {
        json_array_append_new(list, json_pack("{s:i, s:i, s:f, s:f}", "from",
                                              (int)clod_clump_class_least(k), "to",
                                              (int)CLOD_CLUMP_CLASS_MOST[k], "number",
                                              mean_of(self, sizes->number[k]), "mass_kg",
                                              mean_of(self, sizes->mass[k])));
    }
    return list;
}

static json_t *count_json(const clod_clump_memory *self, const clod_clump_count *count)
{
    const clod_clump_stats *mean = &count->mean;
    return json_pack("{s:{s:o, s:o, s:o, s:o, s:f}, s:o, s:f, s:f, s:o}", "mean", "number",
                     clod_json_number(mean_of(self, mean->number)), "grains",
                     clod_json_number(mean_of(self, mean->grains)), "mass_kg",
                     clod_json_number(mean_of(self, mean->mass)), "mass_share",
                     clod_json_number(mean_of(self, mean->share)), "mean_size",
                     ratio(mean->grains, mean->number), "end", stats_json(&count->now),
                     "largest", count->most.largest, "largest_mass_kg",
                     count->most.largest_mass, "sizes", sizes_json(self, &count->sizes));
}

/** Grains that left the space, by the size of the clump they were in. */
static json_t *left_json(const clod_exchange *gone)
{
    json_t *sizes = json_array();
    for (int k = 0; k < CLOD_CLUMP_CLASSES; k++) {
        if (gone->left_clumps[1 + k] > 0) {
            json_array_append_new(sizes, json_pack("{s:i, s:i, s:I}", "from",
                                                   (int)clod_clump_class_least(k), "to",
                                                   (int)CLOD_CLUMP_CLASS_MOST[k], "grains",
                                                   (json_int_t)gone->left_clumps[1 + k]));
        }
    }
    return json_pack("{s:I, s:I, s:o}", "alone", (json_int_t)gone->left_clumps[0], "in_clumps",
                     (json_int_t)left_in_all(gone, false), "sizes", sizes);
}

json_t *clod_clumps_report_json(const void *memory, const clod_free_moment *now)
{
    const clod_clump_memory *self = memory;
    json_t *all = count_json(self, &self->count[0]);
    json_object_set_new(all, "since_s", json_real(now->steady.since));
    json_t *counts = json_object();
    for (size_t c = 1; c < counts_of(now->from); c++) {
        json_object_set_new(counts, name_of(now->from, c), count_json(self, &self->count[c]));
    }
    json_object_set_new(all, "counts", counts);
    json_object_set_new(
        all, "time_in_clumps",
        self->lives.grains == 0
            ? json_pack("{s:i}", "grains", 0)
            : json_pack("{s:I, s:f, s:f, s:f, s:f}", "grains", (json_int_t)self->lives.grains,
                        "mean_s", mean_time(self), "p10_s", time_quantile(self, 0.1), "p50_s",
                        time_quantile(self, 0.5), "p90_s", time_quantile(self, 0.9)));
    json_object_set_new(all, "left", left_json(&now->state->exchange));
    return all;
}

/** Of a count. */
static void count_paths(clod_free_paths *paths, const char *before)
{
    const int last = CLOD_CLUMP_CLASSES - 1;
    clod_free_paths_add(paths, before,
                        "mean.number mean.grains mean.mass_kg mean.mass_share mean.mean_size "
                        "end.number end.grains end.mass_kg end.mass_share end.mean_size "
                        "end.mass_mean_size end.largest end.largest_mass_kg end.d10_m "
                        "end.d50_m end.d90_m largest largest_mass_kg sizes.[0-%d].from "
                        "sizes.[0-%d].to sizes.[0-%d].number sizes.[0-%d].mass_kg",
                        last, last, last, last);
}

void clod_clumps_report_paths(const clod_case *from, const clod_state *state,
                              clod_free_paths *paths)
{
    (void)state;
    const int last = CLOD_CLUMP_CLASSES - 1;
    count_paths(paths, NULL);
    clod_free_paths_add(paths, NULL,
                        "since_s time_in_clumps.grains time_in_clumps.mean_s "
                        "time_in_clumps.p10_s time_in_clumps.p50_s time_in_clumps.p90_s "
                        "left.alone left.in_clumps left.sizes.[0-%d].from "
                        "left.sizes.[0-%d].to left.sizes.[0-%d].grains",
                        last, last, last);
    for (size_t c = 1; c < counts_of(from); c++) {
        char before[160];
        snprintf(before, sizeof before, "counts.%s", name_of(from, c));
        count_paths(paths, before);
    }
}

// ---- clumps.csv

static void print_sizes(FILE *out, const clod_clump_memory *self, const char *name,
                        const clod_clump_count *count)
{
    for (int k = 0; k <= last_class(&count->sizes); k++) {
        fprintf(out, "%s,%d,%d,%.17g,%.17g,%.17g\n", name[0] == '\0' ? "all" : name,
                (int)clod_clump_class_least(k), (int)CLOD_CLUMP_CLASS_MOST[k],
                mean_of(self, count->sizes.number[k]), mean_of(self, count->sizes.mass[k]),
                ratio(count->sizes.mass[k], count->mean.mass));
    }
}

bool clod_clumps_report_files(const clod_folder *folder, const void *memory,
                              const clod_free_moment *now, clod_status *status)
{
    const clod_clump_memory *self = memory;
    if (counts_of(now->from) == 0) {
        return true;
    }
    clod_text text;
    FILE *out = clod_text_open(&text);
    char *made = NULL;
    if (out != NULL) {
        fputs("count,from [1],to [1],clumps [1],mass [kg],share [1]\n", out);
        for (size_t c = 0; c < counts_of(now->from); c++) {
            print_sizes(out, self, name_of(now->from, c), &self->count[c]);
        }
        made = clod_text_close(&text);
    }
    const bool good = clod_folder_write(folder, "clumps.csv", made, status);
    clod_memory_free(made);
    return good;
}
