#include "verify/twin.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "verify/case_file.h"

#define SEEDS CLOD_VERIFY_TWIN_SEEDS
/** Two-sided 99 % of Student's t with 2 (SEEDS - 1) degrees of freedom. */
#define STUDENT 4.604

void clod_verify_twin_add(clod_verify_twin_run *self, int quantity, double value)
{
    self->sum[quantity] += value;
    self->weight[quantity] += 1.0;
}

/** Means of one run of one kind. */
typedef struct results {
    double of[2][SEEDS][CLOD_VERIFY_TWIN_QUANTITIES]; ///< by kind of wall
    clod_verify_twin_run run[2][SEEDS];
} results;

/** Its folder, with the meshes in it, then the run. */
static bool run_text(const clod_verify_twin *self, const clod_verify_bench *bench,
                     const char *name, bool mesh, const char *text, clod_verify_twin_run *run,
                     clod_status *status)
{
    char path[4096];
    if (!clod_verify_case_file(bench->directory, name, text, path, status)) {
        return false;
    }
    *strrchr(path, '/') = '\0';
    return (!mesh || self->put_meshes(path, status)) &&
           clod_verify_bed_run(bench, name, text, self->look, run, status);
}

static bool run_one(const clod_verify_twin *self, const clod_verify_bench *bench, bool mesh,
                    int seed, clod_verify_twin_run *run, clod_status *status)
{
    char name[64];
    clod_text whole;
    FILE *out = clod_text_open(&whole);
    if (out == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a case");
    }
    self->put_case(out, mesh, seed);
    char *text = clod_text_close(&whole);
    if (text == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a case");
    }
    *run = (clod_verify_twin_run){.begin = 0.0};
    snprintf(name, sizeof name, "%s-%s-%d", self->name, mesh ? "mesh" : "shapes", seed);
    const bool ok = run_text(self, bench, name, mesh, text, run, status);
    clod_memory_free(text);
    clod_memory_free(run->last);
    run->last = NULL;
    return ok;
}

/** Mean and sum of squares about it, over the seeds. */
static double mean_of(const results *all, int kind, int quantity, double *squares)
{
    double mean = 0.0;
    for (int s = 0; s < SEEDS; s++) {
        mean += all->of[kind][s][quantity] / SEEDS;
    }
    for (int s = 0; s < SEEDS; s++) {
        const double off = all->of[kind][s][quantity] - mean;
        *squares += off * off;
    }
    return mean;
}

static bool check_all(const clod_verify_twin *self, const clod_verify_bench *bench,
                      const results *all, clod_status *status)
{
    for (int q = 0; q < self->count; q++) {
        double squares = 0.0;
        const double shapes = mean_of(all, 0, q, &squares);
        const double mesh = mean_of(all, 1, q, &squares);
        const double error = sqrt(squares / (2.0 * (SEEDS - 1)) * 2.0 / SEEDS);
        const clod_verify_expect same = {shapes, STUDENT * error, false,
                                         "three seeds beside analytic walls; 99 % interval"};
        if (!clod_verify_bench_check(
                bench, &same, mesh, status, "walls as meshes: %s; scatter of a seed %.2g %%",
                self->quantities[q], 100.0 * error / sqrt(2.0 / SEEDS) / fabs(shapes))) {
            return false;
        }
    }
    return true;
}

/** What each seed gave, over the mean beside analytic walls. */
static bool write_seeds(const clod_verify_twin *self, const clod_verify_bench *bench,
                        const results *all, clod_status *status)
{
    char header[1024] = "seed";
    double ignored = 0.0;
    for (int q = 0; q < self->count; q++) {
        const size_t used = strlen(header);
        snprintf(header + used, sizeof header - used, ",clod: %s: shapes,clod: the same: mesh",
                 self->quantities[q]);
    }
    clod_verify_curve *curve = clod_verify_curve_open(bench, self->name, header, status);
    for (int s = 0; curve != NULL && s < SEEDS; s++) {
        double row[1 + 2 * CLOD_VERIFY_TWIN_QUANTITIES] = {s + 1.0};
        for (int q = 0; q < self->count; q++) {
            const double mean = mean_of(all, 0, q, &ignored);
            row[1 + 2 * q] = all->of[0][s][q] / mean;
            row[2 + 2 * q] = all->of[1][s][q] / mean;
        }
        clod_verify_curve_add(curve, row, 1 + 2 * (size_t)self->count);
    }
    return curve != NULL && clod_verify_curve_close(&curve, status);
}

bool clod_verify_twin_compare(const clod_verify_twin *self, const clod_verify_bench *bench,
                              clod_status *status)
{
    results all;
    for (int seed = 0; seed < SEEDS; seed++) {
        for (int kind = 0; kind < 2; kind++) {
            clod_verify_twin_run *run = &all.run[kind][seed];
            if (!run_one(self, bench, kind == 1, seed + 1, run, status)) {
                return false;
            }
            for (int q = 0; q < self->count; q++) {
                all.of[kind][seed][q] = run->sum[q] / run->weight[q];
            }
        }
    }
    return check_all(self, bench, &all, status) &&
           (self->check == NULL || (self->check(bench, false, all.run[0], status) &&
                                    self->check(bench, true, all.run[1], status))) &&
           write_seeds(self, bench, &all, status);
}
