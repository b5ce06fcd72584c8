/**
 * @file bench_machine.c
 * What this machine can do at most, as one line of JSON: additions and multiplications, divides
 * and square roots of one core per instruction set, and bytes per second that cross to and from
 * caches and memory for one thread and for all.
 *
 *   bench_machine
 *
 * Rates are the best of several trials. An update a = a + s b counts 24 bytes per element, and
 * as many cross: what is written has been read, as in the step itself.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "clod/version.h"
#include "machine_set.h"
#include "parallel/threads.h"
#include "stages.h"
#include "step/kernel.h"

#define TRIALS 7
#define TRIAL_SECONDS 0.05
#define MEMORY_BYTES (768.0 * 1048576.0) // of all threads: many times any cache of a core

extern const bench_machine_set bench_machine_scalar;
#if defined(__x86_64__)
extern const bench_machine_set bench_machine_avx2, bench_machine_avx2_fused;
extern const bench_machine_set bench_machine_avx512, bench_machine_avx512_fused;
#endif

typedef struct machine_row {
    const char *kernel; ///< name for clod_kernel_choose
    const bench_machine_set *set, *fused;
} machine_row;

static const machine_row ROWS[] = {
#if defined(__x86_64__)
    {"avx512", &bench_machine_avx512, &bench_machine_avx512_fused},
    {"avx2", &bench_machine_avx2, &bench_machine_avx2_fused},
#endif
    {"scalar", &bench_machine_scalar, &bench_machine_scalar},
};
#define ROW_COUNT (sizeof ROWS / sizeof *ROWS)

static volatile double sink;

static void give_up(const char *text)
{
    fprintf(stderr, "bench_machine: %s\n", text);
    exit(2);
}

/** Rounds per second of a loop of one core. */
static double rounds_per_second(double (*loop)(int64_t rounds))
{
    double best = 0.0;
    int64_t rounds = 1000;
    for (int trial = 0; trial < TRIALS;) {
        const double begin = bench_now();
        sink = loop(rounds);
        const double seconds = bench_now() - begin;
        if (seconds < TRIAL_SECONDS) {
            rounds *= 2;
            continue;
        }
        const double rate = (double)rounds / seconds;
        best = rate > best ? rate : best;
        trial++;
    }
    return best;
}

/** Elements between the arrays: begun at like places of pages and sets they would be in each
 * other's way. */
#define GAP 1096

typedef struct update_job {
    const bench_machine_set *set;
    size_t count; ///< elements of one array, of one thread
    double *rate; ///< [threads] bytes/s
} update_job;

static void run_update(void *context, int number)
{
    const update_job *job = context;
    double *a = clod_memory_alloc(2 * job->count + GAP, sizeof(double));
    if (a == NULL) {
        give_up("no memory for the update");
    }
    double *b = a + job->count + GAP;
    for (size_t k = 0; k < job->count; k++) {
        a[k] = 2.0;
        b[k] = 1.0 / (1.0 + (double)k);
    }
    double best = 0.0;
    int64_t rounds = 1;
    for (int trial = 0; trial < TRIALS;) {
        const double begin = bench_now();
        for (int64_t r = 0; r < rounds; r++) {
            job->set->update(a, b, job->count);
        }
        const double seconds = bench_now() - begin;
        if (seconds < TRIAL_SECONDS) {
            rounds *= 2;
            continue;
        }
        const double rate = 24.0 * (double)job->count * (double)rounds / seconds;
        best = rate > best ? rate : best;
        trial++;
    }
    job->rate[number] = best;
    clod_memory_free(a);
}

/** What the system says of a cache of the first processor; false at the end of its list. */
static bool cache_word(int index, const char *name, char word[32])
{
    char path[96];
    snprintf(path, sizeof path, "/sys/devices/system/cpu/cpu0/cache/index%d/%s", index, name);
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        return false;
    }
    const bool ok = fgets(word, 32, file) != NULL;
    fclose(file);
    return ok;
}

/** Size of the data cache of a level, or 0 where the system does not say [bytes]. */
static double cache_bytes(int wanted)
{
    char level[32], type[32], size[32];
    for (int index = 0; cache_word(index, "level", level); index++) {
        if (cache_word(index, "type", type) && cache_word(index, "size", size) &&
            strtol(level, NULL, 10) == wanted && type[0] != 'I') {
            return 1024.0 * strtod(size, NULL); // in K, always
        }
    }
    return 0.0;
}

static void print_update(const char *level, double bytes, int threads,
                         const bench_machine_set *set, bool first)
{
    double *rate = clod_memory_alloc((size_t)threads, sizeof(double));
    if (rate == NULL) {
        give_up("no memory");
    }
    update_job job = {set, (size_t)(bytes / threads / 16.0) / 8 * 8, rate};
    clod_threads_run(threads, threads, run_update, &job);
    double sum = 0.0;
    for (int t = 0; t < threads; t++) {
        sum += rate[t];
    }
    printf("%s{\"level\": \"%s\", \"bytes\": %.0f, \"threads\": %d, \"bytes_per_s\": %.4g}",
           first ? "" : ", ", level, bytes, threads, sum);
    clod_memory_free(rate);
}

/** Rates of all sets of this machine; returns the best set. */
static const bench_machine_set *print_sets(void)
{
    const bench_machine_set *best = NULL;
    for (size_t k = 0; k < ROW_COUNT; k++) {
        const machine_row *row = &ROWS[k];
        if (clod_kernel_choose(row->kernel) == NULL) {
            continue;
        }
        const double per_round = (double)row->set->operations;
        printf("%s{\"set\": \"%s\", \"multiply_add\": %.4g, \"fused\": %.4g, \"divide\": %.4g, "
               "\"root\": %.4g}",
               best == NULL ? "" : ", ", row->kernel,
               2.0 * per_round * rounds_per_second(row->set->multiply_add),
               2.0 * per_round * rounds_per_second(row->fused->multiply_add),
               per_round * rounds_per_second(row->set->divide),
               per_round * rounds_per_second(row->set->root));
        best = best == NULL ? row->set : best;
    }
    return best;
}

int main(void)
{
    const int all = clod_threads_available();
    const double l2 = cache_bytes(2);
    const double l3 = cache_bytes(3);
    printf("{\"version\": \"%s\", \"l2_bytes\": %.0f, \"l3_bytes\": %.0f, \"sets\": [",
           clod_version_text(), l2, l3);
    const bench_machine_set *best = print_sets();
    printf("], \"bandwidth\": [");
    for (int k = 0; k < (all > 1 ? 2 : 1); k++) {
        const int threads = k == 0 ? 1 : all;
        print_update("memory", MEMORY_BYTES, threads, best, k == 0);
        if (l2 > 0.0) { // every core has its own
            print_update("L2", 0.5 * l2 * threads, threads, best, false);
        }
        if (l3 > 0.0) {
            print_update("L3", 0.5 * l3, threads, best, false);
        }
    }
    printf("]}\n");
    return 0;
}
