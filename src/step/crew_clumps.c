#include "step/crew_clumps.h"

#include <string.h>

#include "base/memory.h"
#include "state/ids.h"

/** A grain's clump on its way. */
typedef struct clump_record {
    uint64_t id;
    clod_grain_clump clump;
} clump_record;

static void pack(const clod_grains *grains, clump_record *to)
{
    for (size_t g = 0; g < grains->count; g++) {
        to[g] = (clump_record){grains->id[g], grains->clump[g]};
    }
}

/** Clumps of the rows of this rank, of which the others are a part. */
static bool unpack(const clump_record *from, size_t count, clod_grains *grains,
                   clod_status *status)
{
    clod_ids rows = {0};
    if (!clod_ids_init(&rows, grains->id, grains->count, status)) {
        return false;
    }
    for (size_t k = 0; k < count; k++) {
        const int64_t row = clod_ids_row(&rows, from[k].id);
        if (row >= 0) {
            grains->clump[row] = from[k].clump;
        }
    }
    clod_ids_fini(&rows);
    return true;
}

bool clod_crew_clumps_tell(clod_ranks *ranks, const clod_state *whole, clod_state *part,
                           clod_status *status)
{
    size_t count = whole != NULL ? whole->grains.count : 0;
    clod_ranks_tell(ranks, &count, sizeof count);
    clump_record *all = clod_memory_alloc(count + 1, sizeof *all);
    bool good =
        (all != NULL || clod_status_fail(status, CLOD_FAILED,
                                         "no memory for the clumps of %zu grains", count)) &&
        clod_grains_keep_clumps(&part->grains, status);
    if (all != NULL && whole != NULL) {
        pack(&whole->grains, all);
    }
    if (clod_ranks_agree(ranks, good, status)) {
        clod_ranks_tell(ranks, all, count * sizeof *all);
        good = unpack(all, count, &part->grains, status);
        good = clod_ranks_agree(ranks, good, status);
    } else {
        good = false;
    }
    clod_memory_free(all);
    return good;
}
