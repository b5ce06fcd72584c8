#include "report/compare_seeds.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "sim/case_diff.h"

#define SEED 32 ///< bytes of one

/** How the case of a run differs from that of another. */
typedef struct difference {
    bool other;      ///< in more than the seed
    char seed[SEED]; ///< of the second; "": that of the first
} difference;

static void note(void *context, const char *key, const char *there, const char *here)
{
    difference *self = context;
    (void)there;
    if (strcmp(key, "seed") == 0) {
        const char *text = here != NULL ? here : "-";
        clod_text_fit(self->seed, SEED, SEED, text, strlen(text));
    } else if (strcmp(key, "title") != 0) {
        self->other = true;
    }
}

/** Whether two runs of a test have a packing in common: with several seeds each run has the seeds that follow. */
static bool share_packing(const clod_run_files *a, const clod_run_files *b)
{
    size_t i, k;
    const json_t *one, *other;
    json_array_foreach(json_object_get(a->summary, "parts"), i, one)
    {
        const json_t *seed = json_object_get(one, "seed");
        json_array_foreach(json_object_get(b->summary, "parts"), k, other)
        {
            if (seed != NULL && json_equal(seed, json_object_get(other, "seed"))) {
                return true;
            }
        }
    }
    return false;
}

/** Put run k into the group of `first` if it repeats its case with a seed that is new there. */
static bool try_group(clod_compare_seeds *self, const clod_run_files *runs, char (*seed)[SEED],
                      size_t first, size_t k, bool *done, clod_status *status)
{
    difference one = {.other = false};
    if (!clod_case_differences(runs[first].complete, runs[k].complete, note, &one, status)) {
        return false;
    }
    if (one.other) {
        return true;
    }
    *done = true; // one case: no other group has it
    for (size_t j = first; j < k; j++) {
        if (self->group[j] == first &&
            (strcmp(seed[j], one.seed) == 0 || share_packing(&runs[j], &runs[k]))) {
            self->twin[k] = j;
            return true; // the same packing again
        }
    }
    self->group[k] = first;
    memcpy(seed[k], one.seed, SEED);
    return true;
}

bool clod_compare_seeds_find(clod_compare_seeds *self, const clod_run_files *runs, size_t count,
                             clod_status *status)
{
    *self = (clod_compare_seeds){.count = count,
                                 .group = clod_memory_alloc(count + 1, sizeof *self->group),
                                 .twin = clod_memory_alloc(count + 1, sizeof *self->twin)};
    char(*seed)[SEED] = clod_memory_alloc(count + 1, sizeof *seed);
    bool good = (self->group != NULL && self->twin != NULL && seed != NULL) ||
                clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    for (size_t k = 0; good && k < count; k++) {
        bool done = runs[k].report == NULL;
        self->group[k] = count;
        self->twin[k] = count;
        for (size_t first = 0; good && !done && first < k; first++) {
            if (self->group[first] == first) {
                good = try_group(self, runs, seed, first, k, &done, status);
            }
        }
        if (!done) {
            self->group[k] = k;
            seed[k][0] = '\0';
        }
    }
    clod_memory_free(seed);
    return good;
}

size_t clod_compare_seeds_size(const clod_compare_seeds *self, size_t group)
{
    size_t size = 0;
    for (size_t k = 0; k < self->count; k++) {
        size += self->group[k] == group;
    }
    return size;
}

/** Mean, standard error and deviation of the numbers that there are. */
static json_t *mean_of(const char *key, const json_t *const *of, size_t count)
{
    double sum = 0.0, squares = 0.0;
    size_t n = 0;
    for (size_t k = 0; k < count; k++) {
        const double value = clod_result_table_number(of[k], key);
        if (isfinite(value)) {
            sum += value;
            n++;
        }
    }
    const double mean = sum / (double)n;
    for (size_t k = 0; k < count; k++) {
        const double value = clod_result_table_number(of[k], key);
        squares += isfinite(value) ? (value - mean) * (value - mean) : 0.0;
    }
    if (n < 2) {
        return json_null();
    }
    const double deviation = sqrt(squares / (double)(n - 1));
    return json_pack("{s:f, s:f, s:f, s:I}", "value", mean, "error",
                     deviation / sqrt((double)n), "scatter", deviation, "n", (json_int_t)n);
}

json_t *clod_compare_seeds_mean(const clod_result_row *rows, size_t row_count,
                                const json_t *const *of, size_t count)
{
    json_t *all = json_object();
    bool good =
        all != NULL && json_object_set_new(all, "n", json_integer((json_int_t)count)) == 0;
    for (size_t k = 0; good && k < row_count; k++) {
        if (!rows[k].words) {
            good = json_object_set_new(all, rows[k].key, mean_of(rows[k].key, of, count)) == 0;
        }
    }
    if (!good) {
        json_decref(all);
        return NULL;
    }
    return all;
}

/** Number of groups of two and more runs, up to this one. */
static size_t number_of(const clod_compare_seeds *self, size_t group)
{
    size_t number = 0;
    for (size_t k = 0; k <= group && k < self->count; k++) {
        number += clod_compare_seeds_size(self, k) > 1;
    }
    return number;
}

void clod_compare_seeds_name(const clod_compare_seeds *self, size_t group, char name[64])
{
    const size_t size = clod_compare_seeds_size(self, group);
    if (number_of(self, self->count) == 1) {
        snprintf(name, 64, "mean, n = %zu", size);
    } else {
        snprintf(name, 64, "mean %zu, n = %zu", number_of(self, group), size);
    }
}

void clod_compare_seeds_note(clod_writer out, const clod_compare_seeds *self,
                             const clod_run_files *runs)
{
    for (size_t first = 0; first < self->count; first++) {
        const size_t size = clod_compare_seeds_size(self, first);
        char name[64], words[256];
        if (size < 2) {
            continue;
        }
        clod_compare_seeds_name(self, first, name);
        snprintf(
            words, sizeof words,
            ": mean \u00b1 standard error of the mean, and scatter s (standard deviation), "
            "of %zu runs whose cases differ in nothing but seed and title: ",
            size);
        clod_writer_mark(out, "<p class=\"note\"><strong>", "");
        clod_writer_text(out, name);
        clod_writer_mark(out, "</strong>", "");
        clod_writer_text(out, words);
        const char *between = "";
        for (size_t k = first; k < self->count; k++) {
            if (self->group[k] == first) {
                clod_writer_text(out, between);
                clod_writer_text(out, runs[k].name);
                between = ", ";
            }
        }
        clod_writer_text(out, ". Errors of the single runs have no part in it.");
        clod_writer_mark(out, "</p>\n", "\n");
    }
}

bool clod_compare_seeds_origin(const clod_run_files *a, const clod_run_files *b)
{
    const json_t *one = json_object_get(a->summary, "from");
    const json_t *other = json_object_get(b->summary, "from");
    return (one == NULL && other == NULL) || json_equal(one, other);
}

void clod_compare_seeds_twins(clod_writer out, const clod_compare_seeds *self,
                              const clod_run_files *runs)
{
    for (size_t k = 0; k < self->count; k++) {
        if (self->twin[k] == self->count) {
            continue;
        }
        const clod_run_files *twin = &runs[self->twin[k]];
        clod_writer_mark(out, "<p class=\"note\"><strong>", "");
        clod_writer_text(out, runs[k].name);
        clod_writer_mark(out, "</strong>", "");
        clod_writer_text(out, " has the case of ");
        clod_writer_text(out, twin->name);
        clod_writer_text(
            out,
            clod_compare_seeds_origin(&runs[k], twin)
                ? " and a seed of it: they have a packing in common, of which the same version "
                  "of clod computes the same bits every time. It is no repeat, and has"
                : " and a seed of it, but began from other grains (clod run --from). It has");
        clod_writer_text(out, " no part in means.");
        clod_writer_mark(out, "</p>\n", "\n");
    }
}

void clod_compare_seeds_fini(clod_compare_seeds *self)
{
    clod_memory_free(self->group);
    clod_memory_free(self->twin);
    *self = (clod_compare_seeds){0};
}
