#include "step/crew_part.h"

#include "step/crew_clumps.h"
#include "step/crew_state.h"
#include "step/migrate.h"

/** For good; on all ranks alike. */
static bool fail(clod_crew *self, const clod_status *status)
{
    self->broken = true;
    self->status = *status;
    return false;
}

bool clod_crew_part_is_whole(const clod_crew *self, clod_status *status)
{
    if (self->broken) {
        *status = self->status;
    }
    return !self->broken;
}

bool clod_crew_part_update(clod_crew *self, clod_status *status)
{
    clod_crew_state_tell(self->ranks, &self->state);
    if (self->whole == NULL) {
        clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    }
    if (!clod_crew_part_is_whole(self, status)) {
        return false;
    }
    if (self->state.ledger.open != 0 && !self->ledger) {
        const bool kept = clod_step_keep_ledger(&self->step, status);
        self->ledger =
            clod_ranks_agree(self->ranks, kept, status) &&
            clod_spread_list(&self->spread, &self->state, self->step.neighbour.skin, status);
        return self->ledger || fail(self, status);
    }
    return true;
}

bool clod_crew_part_prepare(clod_crew *self, const clod_crew_order *what, clod_status *status)
{
    const clod_state *whole = self->whole != NULL ? self->whole->state : NULL;
    return clod_crew_part_update(self, status) &&
           (!what->clumps || clod_crew_clumps_tell(self->ranks, whole, &self->state, status) ||
            fail(self, status));
}

/** Whether all sums of surfaces have been added up. */
static bool has_all_wear(const clod_crew *self, clod_status *status)
{
    return !self->spread.wear_lost ||
           clod_status_fail(status, CLOD_FAILED, "no memory for the sums of surfaces");
}

/** As clod_ranks_agree; rows of which nobody knows whose they are can be neither stepped nor seen. */
static bool agree_on_rows(clod_crew *self, bool good, clod_status *status)
{
    good = clod_ranks_agree(self->ranks, good, status);
    return good || (self->spread.adrift && fail(self, status));
}

bool clod_crew_part_advance(clod_crew *self, const clod_crew_order *what, clod_status *status)
{
    bool good = clod_crew_part_prepare(self, what, status);
    clod_balance_go_on(&self->spread.balance, self->ranks);
    good = good && clod_step_advance(&self->step, what->steps, status) &&
           has_all_wear(self, status);
    clod_balance_pause(&self->spread.balance, self->ranks);
    return agree_on_rows(self, good, status);
}

bool clod_crew_part_see(clod_crew *self, const clod_crew_order *what, clod_status *status)
{
    if (!clod_crew_part_prepare(self, what, status)) {
        return false;
    }
    const bool listed = clod_step_export(&self->step, status);
    return clod_ranks_agree(self->ranks, listed, status) &&
           clod_migrate_gather(&self->spread, &self->state,
                               self->whole != NULL ? self->whole->state : NULL, status);
}

bool clod_crew_part_see_near(clod_crew *self, const clod_crew_order *what, clod_domain_box *box,
                             clod_status *status)
{
    clod_ranks_tell(self->ranks, box, (size_t)what->boxes * sizeof *box);
    return clod_crew_part_prepare(self, what, status) &&
           clod_migrate_near(&self->spread, &self->state, box, what->boxes,
                             self->whole != NULL ? self->whole->state : NULL, status);
}

bool clod_crew_part_see_gone(clod_crew *self, clod_status *status)
{
    clod_state *whole = self->whole != NULL ? self->whole->state : NULL;
    return clod_crew_part_is_whole(self, status) &&
           clod_migrate_gone(&self->spread, &self->state, whole, status);
}

/** Grains that are in the queue of rank 0 come. */
bool clod_crew_part_take(clod_crew *self, const clod_crew_order *what, clod_status *status)
{
    const bool good =
        clod_crew_part_prepare(self, what, status) && clod_step_take(&self->step, status);
    return agree_on_rows(self, good, status);
}

void clod_crew_part_store(clod_crew *self, clod_step_stored *sums)
{
    clod_status status = {0};
    clod_crew_part_update(self, &status); // a failure stays: the next advance tells it
    clod_step_store(&self->step, sums);
    clod_spread_merge_stored(&self->spread, sums);
}

void clod_crew_part_end(clod_crew *self)
{
    clod_crew_slabs_end(self);
    clod_crew_share_fini(&self->share);
    clod_crew_places_fini(&self->places);
    clod_step_fini(&self->step);
    clod_state_fini(&self->state);
    clod_spread_fini(&self->spread);
    if (self->whole == NULL) {
        clod_laws_fini(&self->laws);
    }
    *self = (clod_crew){0};
}
