/**
 * @file bench_making.c
 * What making the grains of a case costs rank 0, without stepping or files: processor time and the most
 * memory.
 *
 *   bench_making CASE [KEY=VALUE]...
 *
 * Grains are given away in pieces, as to ranks, to one who counts and forgets them: cases of one
 * group. The check sum tells whether two programs make the same bits (FNV-1a over ids and places).
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "clod/case.h"
#include "resident.h"
#include "setup/state.h"

/** Grains at a time, as src/sim/deal.c. */
#define PIECE 65536
/** Of all grains, that this machine has to hold: none, in truth. */
#define SHARE 1e-3

typedef struct sink {
    uint64_t sum;
    size_t grains;
} sink;

static void give_up(const char *text)
{
    fprintf(stderr, "bench_making: %s\n", text);
    exit(2);
}

static double processor_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static void add(uint64_t *sum, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    for (size_t b = 0; b < count; b++) {
        *sum = (*sum ^ byte[b]) * UINT64_C(1099511628211);
    }
}

static bool begin(void *context, clod_state *state, size_t grains, clod_status *status)
{
    (void)context;
    (void)grains;
    return clod_grains_reserve(&state->grains, PIECE, status);
}

static bool take(void *context, clod_state *state, size_t kept, clod_status *status)
{
    sink *self = context;
    (void)status;
    for (size_t g = kept; g < state->grains.count; g++) {
        add(&self->sum, &state->grains.id[g], sizeof *state->grains.id);
        add(&self->sum, state->grains.position[g], sizeof *state->grains.position);
    }
    self->grains += state->grains.count - kept;
    state->grains.count = kept;
    clod_grains_pad(&state->grains);
    return true;
}

static bool near(void *context, const clod_domain *domain, const clod_domain_box *box,
                 clod_setup_places *found, clod_status *status)
{
    (void)context;
    (void)domain;
    (void)box;
    (void)found;
    return clod_status_fail(status, CLOD_USAGE, "the case has several groups of grains");
}

int main(int argc, char **argv)
{
    clod_status status = {0};
    if (argc < 2) {
        give_up("usage: bench_making CASE [KEY=VALUE]...");
    }
    clod_case *from =
        clod_case_load(argv[1], (const char *const *)argv + 2, (size_t)argc - 2, &status);
    if (from == NULL) {
        give_up(status.text);
    }
    const double empty = (double)bench_resident_most();
    const double start = processor_seconds();
    sink all = {.sum = UINT64_C(14695981039346656037)};
    const clod_setup_taker taker = {.context = &all,
                                    .piece = PIECE,
                                    .share = SHARE,
                                    .begin = begin,
                                    .take = take,
                                    .near = near};
    clod_state state;
    clod_setup_bed bed;
    if (!clod_setup_state_give(from, from->seed, &taker, &state, &bed, &status)) {
        give_up(status.text);
    }
    const double seconds = processor_seconds() - start;
    printf(
        "%zu grains: %.2f s of the processor, %.2f us a grain; %.1f bytes a grain; sum %016llx\n",
        all.grains, seconds, seconds / (double)all.grains * 1e6,
        ((double)bench_resident_most() - empty) * 1024.0 / (double)all.grains,
        (unsigned long long)all.sum);
    clod_state_fini(&state);
    clod_case_destroy(&from);
    return 0;
}
