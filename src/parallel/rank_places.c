#define _GNU_SOURCE // sched_getaffinity
#include "parallel/rank_places.h"

#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

clod_rank_place clod_rank_place_here(void)
{
    clod_rank_place self = {.host = "?"};
    cpu_set_t allowed;
    if (gethostname(self.host, sizeof self.host) != 0) {
        snprintf(self.host, sizeof self.host, "?");
    }
    self.host[sizeof self.host - 1] = '\0';
    CPU_ZERO(&allowed);
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

bool clod_rank_places_host(const clod_rank_place *place, int ranks, int rank,
                           clod_rank_host *host)
{
    clod_rank_place all = place[rank];
    *host = (clod_rank_host){.name = place[rank].host};
    for (int r = 0; r < ranks; r++) {
        if (strcmp(place[r].host, host->name) != 0) {
            continue;
        }
        if (r < rank) {
            return false;
        }
        host->ranks++;
        for (int w = 0; w < CLOD_PLACE_WORDS; w++) {
            all.processor[w] |= place[r].processor[w];
        }
    }
    host->processors = clod_rank_place_processors(&all);
    return true;
}
