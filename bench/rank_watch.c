#include "rank_watch.h"

#include <stdio.h>

#include "base/clock.h"

/** A moment. */
typedef struct moment {
    double now, worked; ///< s
    clod_ranks_count count;
} moment;

static struct {
    int64_t starts, first, steps;
    moment begin;
    bench_rank_watched seen, kept; ///< of kept: what goes to and comes from others
    void (*start)(clod_ranks *self);
    bool (*keep)(clod_ranks *self, const clod_message *out, int outs, const clod_message *in,
                 int ins);
} watch;

static moment look(const clod_ranks *ranks)
{
    return (moment){clod_clock_now(), clod_clock_worked() - ranks->count.spun, ranks->count};
}

static clod_ranks_count between(const clod_ranks_count *a, const clod_ranks_count *b)
{
    return (clod_ranks_count){b->merges - a->merges,
                              b->exchanges - a->exchanges,
                              b->messages - a->messages,
                              b->bytes - a->bytes,
                              b->merge_messages - a->merge_messages,
                              b->merge_bytes - a->merge_bytes,
                              b->waited - a->waited,
                              b->spun - a->spun};
}

static void note(const clod_ranks *ranks)
{
    const moment end = look(ranks);
    watch.seen = watch.kept;
    watch.seen.steps = watch.steps;
    watch.seen.wall = end.now - watch.begin.now;
    watch.seen.worked = end.worked - watch.begin.worked;
    watch.seen.count = between(&watch.begin.count, &end.count);
}

static void start(clod_ranks *self)
{
    if (watch.starts == watch.first) {
        watch.begin = look(self);
    } else if (watch.starts == watch.first + watch.steps) {
        note(self);
    }
    watch.starts++;
    watch.start(self);
}

static bool keep(clod_ranks *self, const clod_message *out, int outs, const clod_message *in,
                 int ins)
{
    watch.kept = (bench_rank_watched){.neighbours = outs};
    for (int k = 0; k < outs; k++) {
        watch.kept.ghosts_out += (int64_t)out[k].bytes;
    }
    for (int k = 0; k < ins; k++) {
        watch.kept.ghosts_in += (int64_t)in[k].bytes;
    }
    return watch.keep(self, out, outs, in, ins);
}

void bench_rank_watch(clod_ranks *ranks, int64_t first, int64_t steps)
{
    watch.first = first;
    watch.steps = steps;
    watch.start = ranks->start;
    watch.keep = ranks->keep;
    ranks->start = start;
    ranks->keep = keep;
}

bench_rank_watched bench_rank_seen(void)
{
    return watch.seen;
}

void bench_rank_print(const bench_rank_watched *seen)
{
    const clod_ranks_count *count = &seen->count;
    printf(
        "\"watched\": {\"steps\": %lld, \"wall_s\": %.6g, \"worked_s\": %.6g, \"waited_s\": %.6g, "
        "\"spun_s\": %.6g, \"merges\": %lld, \"messages\": %lld, \"bytes\": %lld, "
        "\"merge_messages\": %lld, \"merge_bytes\": %lld, \"ghost_bytes_in\": %lld, "
        "\"ghost_bytes_out\": %lld, \"neighbours\": %d}",
        (long long)seen->steps, seen->wall, seen->worked, count->waited, count->spun,
        (long long)count->merges, (long long)count->messages, (long long)count->bytes,
        (long long)count->merge_messages, (long long)count->merge_bytes,
        (long long)seen->ghosts_in, (long long)seen->ghosts_out, seen->neighbours);
}
