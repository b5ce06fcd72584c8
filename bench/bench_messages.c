/**
 * @file bench_messages.c
 * How long messages between ranks take by the calls that clod makes, as lines of JSON.
 *
 *   mpirun -n RANKS bench_messages
 *
 * All ranks take part in every test, or wait for its end. A test is BLOCKS blocks of so many calls as
 * last BLOCK_TIME; its line has the time of a call: the median over blocks (and ranks), quartiles,
 * the least and the most, in us. Tests:
 *
 *   pingpong   a message there, then one back, by two exchanges: half of it, so one way
 *   exchange   two ranks get a message from each other in one exchange
 *   kept       the same with kept messages: start and finish
 *   halo       kept messages to and from `peers` others at once
 *   meeting    what a step does: start a halo, merge 24 bytes, finish; `start` is what start takes
 *   merge, tell, gather, swap    calls of ranks.h; of swap with `peers` others that get something
 *   work       fixed arithmetic without messages on all ranks at once: how much its time varies
 *
 * `pairs` of the first three: near (ranks 0 and 1), far (0 and the last), or all (0 and 1, 2 and 3, ...
 * at the same time).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "parallel/rank_places.h"
#include "parallel/ranks_mpi.h"

#define BLOCKS 21
#define TRIALS 5          ///< blocks of one call before them
#define BLOCK_TIME 1.5e-3 ///< s
#define CALLS_MOST 500    ///< in a block
#define PEERS_MOST 26     ///< neighbours of a cube in a lattice of cubes
#define BYTES_MOST ((size_t)4 << 20)
#define WORK_ROUNDS 100000 ///< of arithmetic: some 0.1 ms
#define MICRO 1e6

typedef struct bench {
    clod_ranks ranks;
    char *sent, *got; ///< [BYTES_MOST]
    double *all;      ///< [ranks][BLOCKS] us
    clod_bytes *out;  ///< [ranks] of a swap
    clod_bytes in;
    size_t *begin; ///< [ranks + 1]
    clod_message message[2 * PEERS_MOST];
    int peers;      ///< of this rank in this test
    bool takes;     ///< this rank takes part
    size_t bytes;   ///< of a message
    double started; ///< s that start took, of a meeting
    double sink;    ///< keeps arithmetic from being left out
} bench;

typedef void test_call(bench *self);

static void fail(const char *text)
{
    fprintf(stderr, "bench_messages: %s\n", text);
    exit(2);
}

// ---- calls

static void merge_numbers(const void *context, void *into, const void *from)
{
    const size_t count = *(const size_t *)context / sizeof(int64_t);
    int64_t *mine = into;
    const int64_t *other = from;
    for (size_t k = 0; k < count; k++) {
        mine[k] = mine[k] > other[k] ? mine[k] : other[k];
    }
}

static void merge_bytes(bench *self, size_t bytes)
{
    clod_ranks_merge(&self->ranks, self->sent, bytes, merge_numbers, &bytes);
}

static void call_pingpong(bench *self)
{
    const bool first = self->ranks.rank < self->message->peer;
    for (int turn = 0; turn < 2; turn++) {
        const bool sends = first == (turn == 0);
        clod_ranks_exchange(&self->ranks, self->message, sends ? 1 : 0, self->message + 1,
                            sends ? 0 : 1);
    }
}

static void call_exchange(bench *self)
{
    clod_ranks_exchange(&self->ranks, self->message, 1, self->message + 1, 1);
}

static void call_kept(bench *self)
{
    clod_ranks_start(&self->ranks);
    clod_ranks_finish(&self->ranks);
}

static void call_meeting(bench *self)
{
    const double began = clod_clock_now();
    clod_ranks_start(&self->ranks);
    self->started += clod_clock_now() - began;
    merge_bytes(self, 24);
    clod_ranks_finish(&self->ranks);
}

static void call_merge(bench *self)
{
    merge_bytes(self, self->bytes);
}

static void call_tell(bench *self)
{
    clod_ranks_tell(&self->ranks, self->sent, self->bytes);
}

static void call_gather(bench *self)
{
    clod_ranks_gather(&self->ranks, self->sent, self->bytes, self->got);
}

static void call_swap(bench *self)
{
    clod_status status = {0};
    if (!clod_ranks_swap(&self->ranks, self->out, &self->in, self->begin, &status)) {
        fail(status.text);
    }
}

static void call_work(bench *self)
{
    double a = self->sink, b = 1.0;
    for (int k = 0; k < WORK_ROUNDS; k++) {
        a = 0.5 * a + b;
        b = 0.999 * b + 1e-3;
    }
    self->sink = a + b;
}

// ---- a test

/** Seconds of a call, in a block of so many. */
static double time_calls(bench *self, test_call *call, int calls)
{
    merge_bytes(self, sizeof(int64_t)); // all begin together
    const double began = clod_clock_now();
    for (int k = 0; k < calls && self->takes; k++) {
        call(self);
    }
    return (clod_clock_now() - began) / calls;
}

static void merge_most(const void *context, void *into, const void *from)
{
    (void)context;
    double *mine = into;
    const double other = *(const double *)from;
    *mine = *mine > other ? *mine : other;
}

/** How many calls last as long as a block, from those that were tried; the same on all ranks. */
static int choose_calls(bench *self, test_call *call)
{
    double least = BLOCK_TIME;
    for (int k = 0; k < TRIALS; k++) {
        const double time = time_calls(self, call, 1);
        least = time < least ? time : least;
    }
    least = self->takes ? least : 0.0;
    clod_ranks_merge(&self->ranks, &least, sizeof least, merge_most, NULL);
    const double calls = BLOCK_TIME / (least > 0.0 ? least : BLOCK_TIME);
    return calls > CALLS_MOST ? CALLS_MOST : calls > 1.0 ? (int)calls : 1;
}

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** Times of ranks that took part, which are not negative, in order; how many. */
static size_t order(bench *self)
{
    size_t count = 0;
    for (size_t k = 0; k < (size_t)self->ranks.size * BLOCKS; k++) {
        if (self->all[k] >= 0.0) {
            self->all[count++] = self->all[k];
        }
    }
    qsort(self->all, count, sizeof *self->all, compare_numbers);
    return count;
}

/** Run a test, and on rank 0 tell its line; `share` of a call is what counts. */
static void run(bench *self, const char *name, const char *pairs, test_call *call, double share)
{
    double mine[BLOCKS];
    const int calls = choose_calls(self, call);
    self->started = 0.0;
    for (int b = 0; b < BLOCKS; b++) {
        const double time = time_calls(self, call, calls);
        mine[b] = self->takes ? MICRO * share * time : -1.0;
    }
    const double started = MICRO * self->started / (BLOCKS * calls);
    clod_ranks_gather(&self->ranks, mine, sizeof mine, self->all);
    if (self->ranks.rank == 0) {
        const size_t n = order(self);
        const double *t = self->all;
        printf(
            "{\"test\": \"%s\", \"ranks\": %d, \"pairs\": \"%s\", \"peers\": %d, "
            "\"bytes\": %zu, \"calls\": %d, \"blocks\": %zu, \"least\": %.3f, \"lower\": %.3f, "
            "\"median\": %.3f, \"upper\": %.3f, \"p99\": %.3f, \"most\": %.3f",
            name, self->ranks.size, pairs, self->peers, self->bytes, calls, n, t[0], t[n / 4],
            t[n / 2], t[3 * n / 4], t[(99 * n) / 100], t[n - 1]);
        if (call == call_meeting) {
            printf(", \"start\": %.3f", started);
        }
        printf("}\n");
        fflush(stdout);
    }
}

// ---- who talks to whom

static void keep(bench *self)
{
    clod_status status = {0};
    const int count = self->takes ? self->peers : 0;
    if (!clod_ranks_keep(&self->ranks, self->message, count, self->message + self->peers, count,
                         &status)) {
        fail(status.text);
    }
}

/** Messages with one other rank; of -1: this one waits. */
static void pair_with(bench *self, int other, size_t bytes)
{
    self->peers = 1;
    self->bytes = bytes;
    self->takes = other >= 0;
    self->message[0] = (clod_message){other, self->sent, bytes};
    self->message[1] = (clod_message){other, self->got, bytes};
}

/** Messages with those nearest in number. */
static void surround(bench *self, size_t bytes)
{
    const int size = self->ranks.size, rank = self->ranks.rank;
    self->peers = size - 1 < PEERS_MOST ? size - 1 : PEERS_MOST;
    const int half = self->peers / 2;
    self->bytes = bytes;
    self->takes = true;
    for (int k = 0; k < self->peers; k++) {
        const int step = k - half < 0 ? k - half : k - half + 1;
        const int other = (rank + size + step) % size;
        const size_t at = (size_t)k * bytes;
        self->message[k] = (clod_message){other, self->sent + at, bytes};
        self->message[self->peers + k] = (clod_message){other, self->got + at, bytes};
    }
}

static void run_pairs(bench *self, const char *pairs, int other)
{
    for (size_t bytes = 8; bytes <= BYTES_MOST; bytes *= bytes < 4096 ? 8 : 4) {
        pair_with(self, other, bytes);
        run(self, "pingpong", pairs, call_pingpong, 0.5);
        run(self, "exchange", pairs, call_exchange, 1.0);
        keep(self);
        run(self, "kept", pairs, call_kept, 1.0);
    }
}

static void run_all_pairs(bench *self)
{
    const int rank = self->ranks.rank, last = self->ranks.size - 1;
    run_pairs(self, "near", rank < 2 ? 1 - rank : -1);
    if (last > 1) {
        run_pairs(self, "far", rank == 0 ? last : rank == last ? 0 : -1);
        run_pairs(self, "all", (rank ^ 1) <= last ? rank ^ 1 : -1);
    }
}

static void run_halos(bench *self)
{
    for (size_t bytes = 1 << 10; bytes <= 1 << 16; bytes *= 8) {
        surround(self, bytes);
        keep(self);
        run(self, "halo", "all", call_kept, 1.0);
        run(self, "meeting", "all", call_meeting, 1.0);
    }
}

static void run_collectives(bench *self)
{
    static const size_t MERGED[] = {8, 24, 216, 3000, 65536}, TOLD[] = {64, 3000};
    self->takes = true;
    self->peers = 0;
    for (size_t k = 0; k < sizeof MERGED / sizeof *MERGED; k++) {
        self->bytes = MERGED[k];
        run(self, "merge", "all", call_merge, 1.0);
    }
    for (size_t k = 0; k < sizeof TOLD / sizeof *TOLD; k++) {
        self->bytes = TOLD[k];
        run(self, "tell", "all", call_tell, 1.0);
    }
    self->bytes = 64;
    run(self, "gather", "all", call_gather, 1.0);
    for (size_t bytes = 0; bytes <= 1 << 14; bytes += 1 << 14) {
        surround(self, bytes);
        for (int k = 0; k < self->peers; k++) {
            clod_bytes *out = &self->out[self->message[k].peer];
            clod_bytes_clear(out);
            clod_bytes_put(out, self->sent, bytes);
        }
        run(self, "swap", "all", call_swap, 1.0);
    }
}

/** Hosts, and the processors of the first. */
static void tell_places(clod_ranks *ranks, clod_rank_place *place)
{
    const clod_rank_place mine = clod_rank_place_here();
    clod_ranks_gather(ranks, &mine, sizeof mine, place);
    clod_rank_host host, first = {0};
    int hosts = 0;
    for (int r = 0; r < ranks->size; r++) {
        if (clod_rank_places_host(place, ranks->size, r, &host)) {
            first = hosts++ == 0 ? host : first;
        }
    }
    if (ranks->rank == 0) {
        printf("{\"test\": \"places\", \"ranks\": %d, \"hosts\": %d, \"processors\": %d}\n",
               ranks->size, hosts, first.processors);
    }
}

static void *room(size_t count, size_t size)
{
    void *made = clod_memory_alloc(count, size);
    if (made == NULL) {
        fail("no memory");
    }
    return made;
}

static void begin(bench *self)
{
    clod_status status = {0};
    if (!clod_ranks_mpi_open(&self->ranks, NULL, &status)) {
        fail(status.text);
    }
    if (self->ranks.size < 2) {
        fail("start it with others: mpirun -n RANKS bench_messages, 2 or more");
    }
    const size_t size = (size_t)self->ranks.size;
    self->sent = room(BYTES_MOST, 1);
    self->got = room(BYTES_MOST, 1);
    self->all = room(size * BLOCKS, sizeof *self->all);
    self->out = room(size, sizeof *self->out);
    self->begin = room(size + 1, sizeof *self->begin);
    if (!clod_ranks_reserve(&self->ranks, 65536, &status)) {
        fail(status.text);
    }
}

static void end(bench *self)
{
    for (int r = 0; r < self->ranks.size; r++) {
        clod_bytes_fini(&self->out[r]);
    }
    clod_bytes_fini(&self->in);
    clod_memory_free(self->begin);
    clod_memory_free(self->out);
    clod_memory_free(self->all);
    clod_memory_free(self->got);
    clod_memory_free(self->sent);
    clod_ranks_mpi_close(&self->ranks);
}

int main(void)
{
    static bench self;
    begin(&self);
    clod_rank_place *place = room((size_t)self.ranks.size, sizeof *place);
    tell_places(&self.ranks, place);
    clod_memory_free(place);
    self.takes = true;
    run(&self, "work", "all", call_work, 1.0);
    run_all_pairs(&self);
    run_collectives(&self);
    run_halos(&self);
    end(&self);
    return 0;
}
