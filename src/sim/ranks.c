// Ranks as a program sees them: clod/ranks.h.
#include "clod/ranks.h"

#include "base/given.h"
#include "base/memory.h"
#include "parallel/ranks_mpi.h"
#include "step/crew.h"

/** Where all of them run: known to all. */
static bool find_places(clod_ranks *self, clod_status *status)
{
    const clod_rank_place here = clod_rank_place_here();
    self->place = clod_memory_alloc((size_t)self->size, sizeof *self->place);
    const bool good =
        self->place != NULL ||
        clod_status_fail(status, CLOD_FAILED, "no memory for %d ranks", self->size);
    if (!clod_ranks_agree(self, good, status)) {
        return false;
    }
    clod_ranks_gather(self, &here, sizeof here, self->place);
    return true;
}

clod_ranks *clod_ranks_open(clod_status *status)
{
    CLOD_NEED(status);
    clod_ranks *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for ranks");
        return NULL;
    }
    self->size = 1;
    if (!clod_ranks_mpi_started()) {
        return self;
    }
    if (!clod_ranks_mpi_open(self, status)) {
        clod_memory_free(self);
        return NULL;
    }
    if (self->size > 1 && !find_places(self, status)) {
        clod_ranks_mpi_close(self);
        clod_memory_free(self);
        return NULL;
    }
    return self;
}

int clod_ranks_number(const clod_ranks *self)
{
    CLOD_NEED(self);
    return self->rank;
}

int clod_ranks_size(const clod_ranks *self)
{
    CLOD_NEED(self);
    return self->size;
}

void clod_ranks_serve(clod_ranks *self)
{
    CLOD_NEED(self);
    clod_crew_serve(self);
}

void clod_ranks_close(clod_ranks **self)
{
    CLOD_NEED(self);
    if (*self == NULL) {
        return;
    }
    if ((*self)->size > 1 && (*self)->rank == 0) {
        clod_crew_dismiss(*self);
    }
    if (clod_ranks_mpi_started()) {
        clod_ranks_mpi_close(*self);
    }
    clod_memory_free(*self);
    *self = NULL;
}
