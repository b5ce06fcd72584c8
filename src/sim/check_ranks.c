#include "sim/check_ranks.h"

#include <math.h>
#include <stddef.h>

#define SKIN 0.3 ///< wide skin, largest radii: bench/scaling/constants.json, ghost_layers

#define GHOST_SHARE                                                                            \
    0.7 ///< of a row's time: 29/42 and 40/51 ns, constants.json, `here` and `lent`
#define PACK_SHARE 0.4   ///< of it is packing, on one thread: constants.json, pack_share
#define NEIGHBOURS 26.0  ///< of a box in the middle
#define GHOST_BYTES 72.0 ///< constants.json, ghost

#define ROUND_INSIDE 1.5e-6  ///< s, a round of a merge in one machine: docs/scaling.md, `lent`
#define ROUND_BETWEEN 1.6e-6 ///< s between machines: assumed, constants.json, epyc-hdr
#define COPIES 6.1e9         ///< B/s of ghosts in one machine, a rank: constants.json, `lent`
#define ADAPTER 24e9         ///< B/s of a machine's network: constants.json, epyc-hdr
#define MESSAGE 0.66e-6      ///< s of a message and side, but the first: constants.json, `lent`
#define LONG_MESSAGE 0.83e-6 ///< s more, of one beyond EAGER bytes: constants.json, `lent`
#define EAGER 4096.0         ///< constants.json, `lent`
#define MEETING 1.2e-6       ///< s of a step: constants.json, `lent`

// docs/scaling.md, Memory: bytes a grain of the bed times ranks are bytes a grain of a share
#define ROW_BYTES 610.0     ///< rank 0 between rebuilds: 305 with 2 ranks
#define REBUILD 2.45        ///< times as much in a rebuild: 751 over 305, 4 ranks 424 over 184
#define DEAL_BYTES_0 720.0  ///< made and dealt, rank 0: mean of 2 to 8 ranks
#define DEAL_BYTES 760.0    ///< the same, another rank
#define WHOLE_BYTES_0 560.0 ///< of the whole bed, dealt by rank 0: 558 and 579
#define WHOLE_BYTES 1500.0  ///< another rank: 656 with 2 ranks and 400 with 4
#define GATHERED_BYTES 1250.0 ///< of the whole bed, gathered on rank 0: 1 229

// docs/scaling.md, Making: us a grain, in layers with packing; at random positions by solid fraction
#define MAKE_LAYERS 1.1e-6
#define LAYERS_FROM 0.33
static const double MAKE_RANDOM[][2] = {{0.06, 2.1e-6}, {0.15, 2.5e-6}, {0.30, 11.6e-6}};

// docs/scaling.md, What breaks first: bench_step --checkpoint, and messages of numbers
#define WRITTEN 0.3e9      ///< B/s through rank 0
#define SLAB 16384.0       ///< grains that are collected at a time
#define SLAB_MESSAGES 10.0 ///< of each rank for it

double clod_check_ranks_layers(double radius_mean, double radius_max, double volume,
                               double fraction)
{
    return (radius_mean + (1.0 + SKIN) * radius_max) * cbrt(fraction / volume);
}

clod_check_ranks_share clod_check_ranks_share_of(const clod_check_ranks_bed *bed)
{
    const double whole = cbrt(bed->grains);
    const double own = bed->grains / bed->ranks;
    double edge[3] = {whole, whole, whole};
    bool cut[3] = {false};
    for (int ranks = bed->ranks; ranks > 1; ranks = (ranks + 1) / 2) {
        int longest = 0;
        for (int a = 1; a < 3; a++) {
            longest = edge[a] > edge[longest] ? a : longest;
        }
        const int upper = (ranks + 1) / 2;
        edge[longest] *= (double)upper / ranks;
        cut[longest] = true;
    }
    double seen = 1.0;
    for (int a = 0; a < 3; a++) {
        seen *= cut[a] ? fmin(edge[a] + 2.0 * bed->layers, whole) : edge[a];
    }
    return (clod_check_ranks_share){own, fmax(seen - own, 0.0),
                                    fmin(NEIGHBOURS, bed->ranks - 1)};
}

/** Rounds of recursive doubling: log2 of the largest power of two among so many ranks. */
static int rounds_of(int ranks)
{
    int rounds = 0;
    while (ranks > 1) {
        ranks /= 2;
        rounds++;
    }
    return rounds;
}

double clod_check_ranks_merge(int ranks, int node)
{
    if (ranks < 2) {
        return 0.0;
    }
    const int rounds = rounds_of(ranks);
    const int near = rounds_of(ranks < node ? ranks : node);
    const int spare = (ranks & (ranks - 1)) == 0 ? 0 : 2;
    return (near + spare) * ROUND_INSIDE + (rounds - near) * ROUND_BETWEEN;
}

/** Processor time of the calls for messages. */
static double calls(const clod_check_ranks_share *share)
{
    const bool far = share->ghosts * GHOST_BYTES > EAGER * share->neighbours;
    return 2.0 * ((share->neighbours - 1.0) * MESSAGE +
                  (far ? share->neighbours * LONG_MESSAGE : 0.0)) +
           MEETING;
}

/** Until ghosts are there: copies in one machine, or all that comes to it, ranks being cubes. */
static double flight(const clod_check_ranks_bed *bed, const clod_check_ranks_share *share,
                     int node)
{
    if (bed->ranks <= node) {
        return ROUND_INSIDE + share->ghosts * GHOST_BYTES / COPIES;
    }
    const double edge = cbrt(share->own);
    const double across = cbrt(node);
    const double within = across * edge + 2.0 * bed->layers * (across - 1.0);
    const double come = node * pow(edge + 2.0 * bed->layers, 3.0) - pow(within, 3.0);
    return ROUND_BETWEEN + come * GHOST_BYTES / ADAPTER;
}

double clod_check_ranks_step(const clod_check_ranks_bed *bed,
                             const clod_check_ranks_machine *machine)
{
    const clod_check_ranks_share share = clod_check_ranks_share_of(bed);
    if (bed->ranks < 2) {
        return share.own * machine->row;
    }
    const double ghost =
        GHOST_SHARE * (PACK_SHARE * machine->row_one + (1.0 - PACK_SHARE) * machine->row);
    const double merge = clod_check_ranks_merge(bed->ranks, machine->node);
    return share.own * machine->row + share.ghosts * ghost + calls(&share) +
           fmax(merge, flight(bed, &share, machine->node));
}

double clod_check_ranks_making(const clod_check_ranks_start *start)
{
    if (start->solid > LAYERS_FROM) {
        return start->made * MAKE_LAYERS;
    }
    const size_t last = sizeof MAKE_RANDOM / sizeof *MAKE_RANDOM - 1;
    size_t k = 1;
    while (k < last && start->solid > MAKE_RANDOM[k][0]) {
        k++;
    }
    const double *a = MAKE_RANDOM[k - 1], *b = MAKE_RANDOM[k]; // beyond the ends straight on
    const double each = a[1] + (b[1] - a[1]) * (start->solid - a[0]) / (b[0] - a[0]);
    return start->made * each;
}

double clod_check_ranks_writing(const clod_check_ranks_bed *bed, double bytes)
{
    const double slabs = ceil(bed->grains / SLAB);
    return bytes / WRITTEN + slabs * SLAB_MESSAGES * (bed->ranks - 1) * MESSAGE;
}

clod_check_ranks_memory clod_check_ranks_memory_of(const clod_check_ranks_bed *bed,
                                                   const clod_check_ranks_start *start)
{
    const clod_check_ranks_share share = clod_check_ranks_share_of(bed);
    const double steps = ROW_BYTES * REBUILD * (share.own + share.ghosts);
    const double gathered = start->gathered ? GATHERED_BYTES * bed->grains : 0.0;
    if (start->whole) {
        return (clod_check_ranks_memory){WHOLE_BYTES_0 * bed->grains, WHOLE_BYTES * share.own,
                                         fmax(steps, gathered), steps};
    }
    return (clod_check_ranks_memory){DEAL_BYTES_0 * share.own, DEAL_BYTES * share.own,
                                     fmax(steps, gathered), steps};
}
