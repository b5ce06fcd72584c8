// Grains and walls that are asked to come and go, between two steps.
#include <string.h>

#include "parallel/exact.h"
#include "state/alter.h"
#include "step/crew.h"
#include "step/derived.h"
#include "step/remake.h"
#include "step/requests.h"
#include "step/spread.h"
#include "step/team.h"

/** Room for the grains and walls that come; without it all is as before. */
static bool make_room(clod_step *self, clod_status *status)
{
    clod_state *state = self->state;
    const size_t count = state->grains.count + state->changes.new_grains;
    const bool room = self->spread != NULL
                          ? clod_spread_make_room(self->spread, state, count, status)
                          : clod_grains_reserve(&state->grains, count, status);
    clod_step_set_view(self); // the rows may lie elsewhere
    return room && clod_state_reserve_walls(state, state->changes.new_walls, status);
}

/** What comes, behind the other rows: a new grain carries its weight for the first half kick. */
static bool add_grains(clod_state *state, clod_status *status)
{
    clod_exact added = {0};
    for (size_t k = 0; k < state->changes.new_grains; k++) {
        const clod_new_grain *grain = &state->changes.new_grain[k];
        if (!clod_new_grain_join(grain, &state->grains, status)) {
            return false;
        }
        const size_t row = state->grains.count - 1;
        const double mass = state->grains.velocity[row][3];
        state->grains.birth[row] = (double)state->step * state->dt;
        for (int a = 0; a < 3; a++) {
            state->grains.load[row][a] = mass * state->gravity[a];
        }
        state->exchange.added++;
        clod_exact_add(&added, mass);
    }
    state->exchange.added_mass += clod_exact_value(&added);
    return true;
}

/** Mark the rows that go. */
static void mark_lost(clod_step *self, const clod_requests *found)
{
    clod_state *state = self->state;
    clod_exact removed = {0};
    memset(self->neighbour.rank, 0, state->grains.count * sizeof *self->neighbour.rank);
    for (size_t k = 0; k < state->changes.lost_grains; k++) {
        const size_t row = (size_t)found->lost_row[k];
        self->neighbour.rank[row] = CLOD_NEIGHBOUR_GOES;
        clod_exact_add(&removed, state->grains.velocity[row][3]);
    }
    self->remake.going = state->changes.lost_grains;
    state->exchange.removed += (int64_t)state->changes.lost_grains;
    state->exchange.removed_mass += clod_exact_value(&removed);
    for (int32_t w = 0; found->wall_rank != NULL && w < state->walls.count; w++) {
        state->exchange.walls_removed += found->wall_rank[w] < 0;
    }
}

/** A rebuild in which the requests are done. */
static bool rebuild(clod_step *self, const clod_requests *found, clod_status *status)
{
    clod_state *state = self->state;
    clod_remake_begin(self, true, 0.0); // the speed is known when all are there
    self->remake.changes = true;
    self->remake.wall_rank = found->wall_rank;
    self->remake.before =
        state->changes.booked ? state->changes.energy : clod_step_balance(self);
    if (state->changes.moved) {
        clod_wall_rows_update(&self->walls, &state->walls);
    }
    const bool good = add_grains(state, &self->status) &&
                      clod_neighbour_reserve(&self->neighbour, state, &self->status);
    self->failed = !clod_spread_agree(self->spread, good, &self->status);
    if (!self->failed) {
        mark_lost(self, found);
        clod_team_run(self, clod_remake_lists);
        clod_step_begin_motion(self);
    }
    if (self->failed) { // the lists are gone
        *status = self->status;
    }
    return !self->failed;
}

/** Laws and time step suit what comes: whoever asked has looked, or `accepts` is asked. */
static bool is_accepted(const clod_step *self, clod_status *status)
{
    const clod_changes *queue = &self->state->changes;
    const bool known = queue->new_walls == 0 && queue->checked == queue->new_grains;
    return known || self->accepts == NULL || self->accepts(self->context, self->state, status);
}

bool clod_step_take(clod_step *self, clod_status *status)
{
    clod_state *state = self->state;
    clod_requests found = {0};
    bool good = clod_requests_check(&found, state, self->laws, status);
    good = clod_spread_agree(self->spread, good, status) &&
           clod_spread_check_ids(self->spread, state, status) &&
           clod_spread_agree(self->spread, make_room(self, status), status) &&
           rebuild(self, &found, status);
    clod_requests_fini(&found);
    clod_changes_fini(&state->changes);
    return good;
}

bool clod_step_change(clod_step *self, clod_status *status)
{
    clod_state *state = self->state;
    if (self->failed) {
        *status = self->status;
        return false;
    }
    if (!clod_changes_any(&state->changes)) {
        return true;
    }
    if (self->crew != NULL) {
        return clod_crew_change(self, status);
    }
    clod_requests found;
    const bool good = clod_requests_check(&found, state, self->laws, status) &&
                      is_accepted(self, status) && make_room(self, status) &&
                      rebuild(self, &found, status);
    clod_requests_fini(&found);
    const clod_changes moved = {.moved = state->changes.moved,
                                .booked = state->changes.booked,
                                .energy = state->changes.energy};
    clod_changes_fini(&state->changes);
    if (!good) { // that stays when the requests are dropped
        state->changes = moved;
    }
    return good;
}
