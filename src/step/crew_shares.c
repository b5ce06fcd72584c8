#include "step/crew_shares.h"

#include "base/memory.h"
#include "parallel/ranks_collect.h"

bool clod_crew_shares_init(clod_crew_shares *self, clod_ranks *ranks, clod_status *status)
{
    const size_t size = (size_t)ranks->size;
    *self = (clod_crew_shares){.out = clod_memory_alloc(size, sizeof *self->out),
                               .begin = clod_memory_alloc(size + 1, sizeof *self->begin)};
    const bool good =
        (self->out != NULL && self->begin != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for %d ranks", ranks->size);
    return clod_ranks_agree(ranks, good, status);
}

bool clod_crew_shares_swap(clod_crew_shares *self, clod_ranks *ranks, clod_status *status)
{
    return clod_ranks_swap(ranks, self->out, &self->in, self->begin, status);
}

bool clod_crew_shares_collect(clod_crew_shares *self, clod_ranks *ranks, clod_status *status)
{
    return clod_ranks_collect(ranks, &self->out[0], &self->in, self->begin, status);
}

void clod_crew_shares_fini(clod_crew_shares *self, const clod_ranks *ranks)
{
    for (int r = 0; self->out != NULL && r < ranks->size; r++) {
        clod_bytes_fini(&self->out[r]);
    }
    clod_bytes_fini(&self->in);
    clod_memory_free(self->out);
    clod_memory_free(self->begin);
}
