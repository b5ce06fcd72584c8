/**
 * @file bench_ranks.c
 * What ranks say to each other: messages and bytes of a step and of a rebuild, ghosts and imbalance,
 * and the processor time of all ranks together, as JSON. Ranks are threads of this process, so the
 * counts are those of MPI, and the time has no network in it.
 *
 *   bench_ranks RANKS EDGE
 *
 * The bed is a periodic cube of EDGE^3 grains of 2 mm of the 5 % copper ore, which all but touch on a
 * cubic lattice and fly about at up to 10 m/s. Ranks are balanced by counts, so all but the time is the
 * same on any machine.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bed.h"
#include "step/crew_part.h"
#include "support/dice.h"
#include "support/ranks_threads.h"

#define RADIUS 2e-3
#define PITCH (2.000001 * RADIUS) // of the lattice: no contacts by rounding
#define WINDOW 20                 // steps
#define GHOST_BYTES 72.0          // of a ghost in a step, without the ledger

/** Counts of all ranks at a moment. */
typedef struct counted {
    clod_ranks_count of[RANKS_MOST];
} counted;

typedef struct bench {
    int edge, ranks;
    counted begin, stepped, rebuilt; ///< before and after WINDOW steps, and after a rebuild
    int64_t steps;                   ///< of the last span
    double processor;                ///< s, of all ranks in it
    double ghosts;                   ///< of all ranks, in a step before the rebuild
    size_t own[RANKS_MOST];          ///< grains of each rank
} bench;

static void fail(const char *text)
{
    fprintf(stderr, "bench_ranks: %s\n", text);
    exit(1);
}

static void make_bed(clod_state *state, int edge)
{
    dice roll = {1};
    clod_status status = {0};
    const double none[3] = {0.0, 0.0, 0.0};
    *state = (clod_state){.dt = 1e-7, .build_motion = -1.0, .adhesion = 1.0};
    for (int a = 0; a < 3; a++) {
        state->domain.periodic[a] = true;
        state->domain.max[a] = PITCH * edge;
    }
    for (int k = 0; k < edge * edge * edge; k++) {
        const int at[3] = {k % edge, k / edge % edge, k / edge / edge};
        const double place[4] = {(at[0] + 0.5) * PITCH, (at[1] + 0.5) * PITCH,
                                 (at[2] + 0.5) * PITCH, RADIUS};
        const double velocity[3] = {dice_real(&roll, -5.0, 5.0), dice_real(&roll, -5.0, 5.0),
                                    dice_real(&roll, -5.0, 5.0)};
        if (!clod_grains_add(&state->grains, place, velocity, none, 2481.3, 0, (uint64_t)k,
                             &status)) {
            fail(status.text);
        }
    }
}

static void advance(clod_step *step, int64_t steps)
{
    clod_status status = {0};
    if (!clod_step_advance(step, steps, &status)) {
        fail(status.text);
    }
}

/** Counts of all ranks: threads of this process, which wait for an order now. */
static void look(const clod_ranks *ranks, counted *all)
{
    const ranks_team *team = ranks->group;
    for (int r = 0; r < ranks->size; r++) {
        all->of[r] = team->rank[r].count;
    }
}

/** What all ranks send in each step until the next rebuild. */
static double count_ghosts(const clod_ranks *ranks)
{
    const ranks_team *team = ranks->group;
    int64_t bytes = 0;
    for (int r = 0; r < ranks->size; r++) {
        bytes += team->rank[r].kept_bytes;
    }
    return (double)bytes / GHOST_BYTES;
}

static double processor_time(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void note_sizes(bench *self, clod_step *step)
{
    clod_status status = {0};
    if (!clod_step_see(step, &status)) {
        fail(status.text);
    }
    for (size_t g = 0; g < step->state->grains.count; g++) {
        const double *place = step->state->build_position[g];
        const int r =
            step->crew != NULL ? clod_partition_owner(&step->crew->spread.partition, place) : 0;
        self->own[r]++;
    }
}

static void run_first(bench *self, clod_ranks *ranks)
{
    clod_state state;
    clod_step step;
    clod_law law;
    clod_status status = {0};
    make_bed(&state, self->edge);
    if (!bench_bed_law("mepa", &law, &status)) {
        fail(status.text);
    }
    const clod_laws laws = {.materials = 1, .count = 1, .law = &law};
    const clod_step_options options = {.threads = 1, .balance.by_counts = true, .ranks = ranks};
    if (!clod_step_init(&step, &state, &laws, &options, &status)) {
        fail(status.text);
    }
    int64_t rebuilds;
    do { // a window without a rebuild
        rebuilds = step.rebuilds;
        look(ranks, &self->begin);
        advance(&step, WINDOW);
        look(ranks, &self->stepped);
    } while (step.rebuilds != rebuilds);
    self->ghosts = count_ghosts(ranks);
    self->processor = -processor_time();
    for (; step.rebuilds == rebuilds; self->steps += WINDOW) {
        advance(&step, WINDOW);
    }
    self->processor += processor_time();
    look(ranks, &self->rebuilt);
    note_sizes(self, &step);
    clod_step_fini(&step);
    clod_state_fini(&state);
    clod_crew_dismiss(ranks);
}

static void run_rank(clod_ranks *ranks, void *context)
{
    bench *self = context;
    if (ranks->rank == 0) {
        run_first(self, ranks);
    } else {
        clod_crew_serve(ranks);
    }
}

/** What was said between two moments: of all ranks, and the most of one. */
typedef struct said {
    double messages, bytes, most_bytes;
    double merges, merge_messages, merge_bytes; // of a rank
} said;

static said said_between(const bench *self, const counted *from, const counted *to)
{
    said all = {0};
    for (int r = 0; r < self->ranks; r++) {
        const clod_ranks_count *a = &from->of[r], *b = &to->of[r];
        const double bytes = (double)(b->bytes - a->bytes);
        all.messages += (double)(b->messages - a->messages);
        all.bytes += bytes;
        all.most_bytes = bytes > all.most_bytes ? bytes : all.most_bytes;
        all.merges += (double)(b->merges - a->merges) / self->ranks;
        all.merge_messages += (double)(b->merge_messages - a->merge_messages) / self->ranks;
        all.merge_bytes += (double)(b->merge_bytes - a->merge_bytes) / self->ranks;
    }
    return all;
}

static void write(const bench *self)
{
    const said step = said_between(self, &self->begin, &self->stepped);
    const said rebuild = said_between(self, &self->stepped, &self->rebuilt);
    const double windows = (double)self->steps / WINDOW, ranks = self->ranks;
    const double grains = (double)self->edge * self->edge * self->edge;
    double most = 0.0;
    for (int r = 0; r < self->ranks; r++) {
        most = (double)self->own[r] > most ? (double)self->own[r] : most;
    }
    printf(
        "{\"ranks\": %d, \"grains\": %.0f, \"imbalance\": %.3f, \"ghosts_a_grain\": %.3f,\n"
        " \"step\": {\"messages_a_rank\": %.1f, \"bytes_a_rank\": %.0f, \"most_bytes\": %.0f},\n"
        " \"rebuild\": {\"messages_a_rank\": %.0f, \"bytes_a_rank\": %.0f},\n"
        " \"steps_to_rebuild\": %lld, \"collectives_a_step\": %.2f, "
        "\"messages_of_collectives_a_step\": %.2f, \"bytes_of_collectives_a_step\": %.0f, "
        "\"processor_s_a_step\": %.4g}\n",
        self->ranks, grains, most * ranks / grains, self->ghosts / grains,
        step.messages / ranks / WINDOW, step.bytes / ranks / WINDOW, step.most_bytes / WINDOW,
        (rebuild.messages - windows * step.messages) / ranks,
        (rebuild.bytes - windows * step.bytes) / ranks, (long long)self->steps,
        rebuild.merges / (double)self->steps, rebuild.merge_messages / (double)self->steps,
        rebuild.merge_bytes / (double)self->steps, self->processor / (double)self->steps);
}

int main(int argc, char **argv)
{
    static bench self;
    self.ranks = argc == 3 ? (int)strtol(argv[1], NULL, 10) : 0;
    self.edge = argc == 3 ? (int)strtol(argv[2], NULL, 10) : 0;
    if (self.ranks < 1 || self.ranks > RANKS_MOST || self.edge < 4 || self.edge > 400) {
        fail("bench_ranks RANKS EDGE: 1 to 64 ranks, 4 to 400 grains along an edge");
    }
    ranks_run(self.ranks, run_rank, &self);
    write(&self);
    return 0;
}
