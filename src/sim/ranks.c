// Ranks as a program sees them: clod/ranks.h.
#include "sim/ranks.h"

#include "base/given.h"
#include "base/memory.h"
#include "parallel/ranks_mpi.h"
#include "sim/group.h"
#include "sim/sim.h"
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

/** Ranks of a communicator, or those that were started together (NULL). */
static clod_ranks *open(const int *communicator, clod_status *status)
{
    clod_ranks *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for ranks");
        return NULL;
    }
    self->size = 1;
    if (communicator == NULL && !clod_ranks_mpi_started()) {
        return self;
    }
    if (!clod_ranks_mpi_open(self, communicator, status)) {
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

clod_ranks *clod_ranks_open(clod_status *status)
{
    CLOD_NEED(status);
    return open(NULL, status);
}

clod_ranks *clod_ranks_open_group(int communicator, clod_status *status)
{
    CLOD_NEED(status);
    return open(&communicator, status);
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

void clod_ranks_word(clod_ranks *self, clod_ranks_next next)
{
    clod_ranks_tell(self, &next, sizeof next);
}

void clod_ranks_serve(clod_ranks *self)
{
    CLOD_NEED(self);
    while (self->rank > 0 && !self->dismissed) {
        clod_ranks_next next;
        clod_crew_serve(self);
        clod_ranks_tell(self, &next, sizeof next);
        if (next == CLOD_RANKS_PARTS) {
            clod_group_serve(self);
        }
        self->dismissed = next == CLOD_RANKS_LEAVE;
    }
}

void clod_ranks_close(clod_ranks **self)
{
    CLOD_NEED(self);
    clod_ranks *ranks = *self;
    if (ranks == NULL) {
        return;
    }
    clod_sim_lose_ranks(ranks->user);
    clod_ranks_serve(ranks);
    if (ranks->size > 1 && ranks->rank == 0) {
        clod_crew_dismiss(ranks);
        clod_ranks_word(ranks, CLOD_RANKS_LEAVE);
    }
    if (ranks->group != NULL) {
        clod_ranks_mpi_close(ranks);
    }
    clod_memory_free(ranks);
    *self = NULL;
}

bool clod_sim_ranks_are_free(const clod_ranks *ranks, const char *function, clod_status *status)
{
    if (ranks->rank > 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: this is rank %d of %d, and rank 0 alone drives; the "
                                "others call clod_ranks_serve, or close the ranks",
                                function, ranks->rank, ranks->size);
    }
    return ranks->user == NULL ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: these ranks have a simulation, and step one at a time; "
                            "destroy it before",
                            function);
}

void clod_sim_lose_ranks(clod_sim *self)
{
    if (self == NULL) {
        return;
    }
    clod_status ignored;
    clod_step_see(&self->step, &ignored); // all that can be read is of now
    clod_crew_end(&self->step.crew);
    if (!self->step.failed) {
        self->step.failed = true;
        clod_status_fail(&self->step.status, CLOD_USAGE,
                         "the ranks of this simulation were closed: it can only be read and "
                         "destroyed, or go on in this process from a checkpoint");
    }
    self->options.ranks->user = NULL;
    self->options.ranks = NULL;
}
