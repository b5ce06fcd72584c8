/**
 * @file bench_fit.c
 * Seconds of one processor that `clod calibrate` computes with one target: the surrogate, its points left out,
 * its draws, and four chains of 2000 samples. Results are of a formula with the noise of packings.
 *
 *   bench_fit PARAMETERS POINTS PACKINGS [...]
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/clock.h"
#include "base/random.h"
#include "calibrate/plan_made.h"
#include "calibrate/posterior.h"
#include "calibrate/sobol.h"

#define NOISE 0.3 // of a packing; the formula goes from 0 to 6

static void give_up(const char *text)
{
    fprintf(stderr, "bench_fit: %s\n", text);
    exit(2);
}

static size_t number(const char *text, size_t most)
{
    char *end;
    const unsigned long value = strtoul(text, &end, 10);
    if (*end != '\0' || value < 1 || value > most) {
        give_up("usage: bench_fit PARAMETERS POINTS PACKINGS [...]");
    }
    return value;
}

static double formula(size_t dimensions, const double *u)
{
    double sum = 0.0;
    for (size_t k = 0; k < dimensions; k++) {
        sum +=
            (4.0 * sqrt(0.05 + u[k]) + sin(3.0 * u[(k + 1) % dimensions])) / (double)dimensions;
    }
    return sum;
}

/** One row of the table. */
static void measure(size_t dimensions, size_t points, size_t packings)
{
    plan_made made;
    plan_make(&made, dimensions, 1);
    made.plan.seeds = (int64_t)packings;
    made.targets[0].value = 3.0;
    made.targets[0].error = NOISE;
    double *places = calloc(points * dimensions, sizeof *places);
    double *results = calloc(points * packings, sizeof *results);
    if (places == NULL || results == NULL || !clod_sobol_fill(dimensions, points, places)) {
        give_up("no memory");
    }
    for (size_t i = 0; i < points * packings; i++) {
        results[i] = formula(dimensions, places + i / packings * dimensions) +
                     NOISE * clod_random_normal(1, CLOD_RANDOM_TEST, i, 0);
    }
    const clod_posterior_runs runs = {
        .plan = &made.plan, .points = points, .places = places, .results = results};
    clod_status status = {CLOD_OK, ""};
    const double before = clod_clock_read(CLOCK_PROCESS_CPUTIME_ID);
    clod_posterior *posterior = clod_posterior_create(&runs, &status);
    const double took = clod_clock_read(CLOCK_PROCESS_CPUTIME_ID) - before;
    if (posterior == NULL) {
        give_up(status.text);
    }
    printf("| %zu | %zu | %zu | %zu | %.2g | %zu | %.0f |\n", dimensions, points, packings,
           points * packings, took, posterior->draws, posterior->targets[0].independent);
    clod_posterior_destroy(&posterior);
    free(places);
    free(results);
}

int main(int argc, char **argv)
{
    if (argc < 4 || argc % 3 != 1) {
        give_up("usage: bench_fit PARAMETERS POINTS PACKINGS [...]");
    }
    printf("| parameters | points | packings | runs | s | draws | independent |\n"
           "|---|---|---|---|---|---|---|\n");
    for (int i = 1; i < argc; i += 3) {
        measure(number(argv[i], MADE_MOST), number(argv[i + 1], 4096),
                number(argv[i + 2], 100));
        fflush(stdout);
    }
    return 0;
}
