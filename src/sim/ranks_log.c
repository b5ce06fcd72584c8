#include "sim/ranks_log.h"

#include <stdio.h>

#include "base/plural.h"
#include "clod/ranks.h"
#include "parallel/ranks.h"

/** Host and processors of each rank. */
static json_t *binding(const clod_ranks *ranks)
{
    json_t *all = json_array();
    for (int r = 0; r < ranks->size; r++) {
        char list[CLOD_PLACE_LIST];
        clod_rank_place_list(&ranks->place[r], list);
        json_array_append_new(all, json_pack("{s:i, s:s, s:s}", "rank", r, "host",
                                             ranks->place[r].host, "processors", list));
    }
    return all;
}

void clod_ranks_log_places(const clod_job_shared *sim)
{
    const clod_run_options *options = sim->options;
    const clod_ranks *ranks = options->ranks;
    if (ranks == NULL || ranks->place == NULL) {
        return;
    }
    const int threads = sim->any_threads ? 1 : options->threads;
    json_t *hosts = json_array();
    for (int r = 0; r < ranks->size; r++) {
        clod_rank_host host;
        if (!clod_rank_places_host(ranks->place, ranks->size, r, &host)) {
            continue;
        }
        json_t *processors = host.processors > 0 ? json_integer(host.processors) : json_null();
        json_array_append_new(hosts, json_pack("{s:s, s:i, s:o}", "host", host.name, "ranks",
                                               host.ranks, "processors", processors));
        if (options->notice != NULL &&
            clod_rank_places_crowded(ranks->place, ranks->size, r, threads, &host)) {
            char text[256 + CLOD_PLACE_HOST];
            snprintf(text, sizeof text,
                     "warning: %d rank%s on %s have %d processor%s for %d thread%s each: they "
                     "take turns, and every step waits for the last of them",
                     host.ranks, clod_plural(host.ranks), host.name, host.processors,
                     clod_plural(host.processors), threads, clod_plural(threads));
            options->notice(options->context, text);
        }
    }
    clod_eventlog_write(sim->log, "ranks", "{s:i, s:i, s:o, s:o}", "ranks", ranks->size,
                        "threads_each", threads, "hosts", hosts, "binding", binding(ranks));
}

void clod_ranks_log_work(const clod_job_shared *sim)
{
    const clod_ranks *ranks = sim->options->ranks;
    if (ranks == NULL || ranks->size == 1) {
        return;
    }
    const clod_ranks_count *count = &ranks->count;
    const clod_ranks_evenness *even = &ranks->evenness;
    if (even->looks > 0) {
        clod_eventlog_write(sim->log, "balance of ranks", "{s:I, s:I, s:I, s:f, s:f}",
                            "rebuilds", (json_int_t)even->looks, "cuts", (json_int_t)even->cuts,
                            "grains_moved", (json_int_t)even->moved, "most_over_mean",
                            even->sum / (double)even->looks, "most_over_mean_at_most",
                            even->most);
    }
    clod_eventlog_write(sim->log, "messages of rank 0", "{s:I, s:I, s:I, s:I, s:I, s:I, s:f}",
                        "messages", (json_int_t)count->messages, "bytes",
                        (json_int_t)count->bytes, "exchanges", (json_int_t)count->exchanges,
                        "collectives", (json_int_t)count->merges, "messages_in_collectives",
                        (json_int_t)count->merge_messages, "bytes_in_collectives",
                        (json_int_t)count->merge_bytes, "waited_s", count->waited);
}
