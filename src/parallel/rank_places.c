#define _GNU_SOURCE // sched_getaffinity
#include "parallel/rank_places.h"

#include <limits.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

_Static_assert(CLOD_PLACE_HOST > HOST_NAME_MAX, "a name of a host and its end");

clod_rank_place clod_rank_place_here(void)
{
    clod_rank_place self = {.host = ""};
    cpu_set_t allowed;
    if (gethostname(self.host, sizeof self.host - 1) != 0 || self.host[0] == '\0') {
        return (clod_rank_place){.host = "?"};
    }
    CPU_ZERO(&allowed); // of more than CPU_SETSIZE processors the system says nothing
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
        for (unsigned k = 0; k < 64 * CLOD_PLACE_WORDS; k++) {
            self.processor[k / 64] |= (uint64_t)(CPU_ISSET(k, &allowed) != 0) << (k % 64);
        }
    }
    return self;
}

int clod_rank_place_processors(const clod_rank_place *self)
{
    int count = 0;
    for (int w = 0; w < CLOD_PLACE_WORDS; w++) {
        for (uint64_t bits = self->processor[w]; bits != 0; bits &= bits - 1) {
            count++;
        }
    }
    return count;
}

static bool has(const clod_rank_place *self, int k)
{
    return k < 64 * CLOD_PLACE_WORDS && (self->processor[k / 64] >> (k % 64) & 1) != 0;
}

void clod_rank_place_list(const clod_rank_place *self, char list[CLOD_PLACE_LIST])
{
    size_t at = 0;
    list[0] = '\0';
    for (int k = 0; k < 64 * CLOD_PLACE_WORDS; k++) {
        if (has(self, k) && !(k > 0 && has(self, k - 1))) {
            at += (size_t)snprintf(list + at, CLOD_PLACE_LIST - at, at > 0 ? ",%d" : "%d", k);
            if (has(self, k + 1)) {
                for (; has(self, k + 1); k++) {
                }
                at += (size_t)snprintf(list + at, CLOD_PLACE_LIST - at, "-%d", k);
            }
        }
    }
}

bool clod_rank_places_host(const clod_rank_place *place, int ranks, int rank,
                           clod_rank_host *host)
{
    clod_rank_place all = place[rank];
    bool known = true;
    *host = (clod_rank_host){.name = place[rank].host};
    for (int r = 0; r < ranks; r++) {
        if (strcmp(place[r].host, host->name) != 0) {
            continue;
        }
        if (r < rank) {
            return false;
        }
        host->ranks++;
        known = known && clod_rank_place_processors(&place[r]) > 0;
        for (int w = 0; w < CLOD_PLACE_WORDS; w++) {
            all.processor[w] |= place[r].processor[w];
        }
    }
    host->processors = known ? clod_rank_place_processors(&all) : 0;
    return true;
}

/** Whether a rank is on the host of another one and may use no other processors. */
static bool is_within(const clod_rank_place *self, const clod_rank_place *other)
{
    bool within = strcmp(self->host, other->host) == 0;
    for (int w = 0; within && w < CLOD_PLACE_WORDS; w++) {
        within = (self->processor[w] & ~other->processor[w]) == 0;
    }
    return within;
}

int clod_rank_places_beside(const clod_rank_place *place, int ranks, int rank)
{
    int beside = 0;
    for (int r = 0; r < ranks; r++) {
        beside += is_within(&place[r], &place[rank]);
    }
    return beside;
}

bool clod_rank_places_crowded(const clod_rank_place *place, int ranks, int rank, int threads,
                              clod_rank_host *host)
{
    if (host->processors == 0 || host->ranks * threads > host->processors) {
        return host->processors > 0;
    }
    for (int r = rank; r < ranks; r++) {
        const int processors = clod_rank_place_processors(&place[r]);
        int within = 0;
        for (int q = rank; q < ranks && strcmp(place[r].host, host->name) == 0; q++) {
            within += is_within(&place[q], &place[r]);
        }
        if (within * threads > processors) {
            host->ranks = within;
            host->processors = processors;
            return true;
        }
    }
    return false;
}
