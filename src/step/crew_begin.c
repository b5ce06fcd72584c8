// How a crew begins: the rows of rank 0, and those that ranks have been dealt before, go to their
// owners; of a bed that nobody has stepped each rank makes its first lists and forces.
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "step/crew_deal.h"
#include "step/crew_part.h"
#include "step/crew_state.h"
#include "step/derived.h"
#include "step/migrate.h"

/** A copy of a state but for its grains and contacts. */
static bool copy_without_rows(clod_state *to, const clod_state *from, clod_status *status)
{
    clod_state rest = *from; // borrowed
    rest.grains = (clod_grains){0};
    rest.build_position = NULL;
    rest.contacts = NULL;
    rest.contact_count = rest.wall_contact_count = 0;
    return clod_state_copy(to, &rest, status);
}

/** The rows of the whole state become those of rank 0's part. */
static bool move_rows(clod_state *to, clod_state *from, clod_status *status)
{
    clod_grains_fini(&to->grains);
    to->grains = from->grains;
    to->build_position = from->build_position;
    to->build_capacity = from->build_capacity;
    from->grains = (clod_grains){0};
    from->build_position = NULL;
    from->build_capacity = 0;
    return clod_grains_reserve(&from->grains, 0, status) && // the padding, and the same columns
           (to->grains.before == NULL || clod_grains_keep_before(&from->grains, status)) &&
           (to->grains.clump == NULL || clod_grains_keep_clumps(&from->grains, status));
}

/** Walls of a bed that nobody has stepped are noted where they are. */
static bool note_walls(clod_state *state, clod_status *status)
{
    const size_t walls = (size_t)state->walls.count;
    clod_memory_free(state->build_walls);
    state->build_walls = clod_memory_alloc(walls + 1, sizeof *state->build_walls);
    if (state->build_walls == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu walls", walls);
    }
    for (size_t w = 0; w < walls; w++) {
        clod_wall_pose_get(&state->walls.wall[w], state->build_walls[w]);
    }
    return true;
}

/** Of rank 0: all of its part but rows, or with those that it was dealt. */
static bool make_first(clod_crew *self, const clod_crew_order *what, clod_status *status)
{
    clod_state *whole = self->whole->state;
    clod_state_fini(&self->state);
    self->laws = *self->whole->laws; // borrowed
    if ((what->fresh && !note_walls(whole, status)) ||
        !copy_without_rows(&self->state, whole, status)) {
        return false;
    }
    clod_crew_state_copy(&self->state, whole); // what a copy of a state does not have
    return !what->dealt || move_rows(&self->state, whole, status);
}

/** All that is this rank's but grains and contacts that come now. */
static bool make_part(clod_crew *self, const clod_crew_order *what, clod_status *status)
{
    if (self->whole == NULL && !what->dealt) {
        clod_crew_deal_drop(&self->state);
        clod_crew_share_fini(&self->share);
    }
    bool good = clod_grains_reserve(&self->state.grains, 0, status) &&
                (self->whole == NULL || make_first(self, what, status));
    if (!clod_ranks_agree(self->ranks, good, status) ||
        !clod_crew_state_begin(self->ranks, &self->state, &self->laws, status)) {
        return false;
    }
    clod_grains *grains = &self->state.grains;
    good = (self->state.ledger.open == 0 || clod_grains_keep_before(grains, status)) &&
           (!what->clumps || clod_grains_keep_clumps(grains, status));
    return clod_ranks_agree(self->ranks, good, status);
}

// ---- rows to their owners

/** What the wide skin follows from. */
typedef struct skin_choice {
    bool fresh;
    const clod_state *state;
    double speed; ///< m/s, fastest grain or point of a wall, of a fresh bed
} skin_choice;

/** That of the last rebuild, or of a first one. */
static double choose_skin(const void *context, const clod_layers_extent *bed)
{
    const skin_choice *self = context;
    if (!self->fresh) {
        return self->state->build_skin;
    }
    clod_neighbour neighbour = {.radius_min = bed->least, .radius_max = bed->largest};
    clod_neighbour_choose_skin(&neighbour, self->state, self->speed);
    return neighbour.skin;
}

/** Rows of a fresh bed as at a rebuild: in the domain, and noted there. False on this rank alone. */
static bool note_rows(clod_state *rows, const clod_domain *domain, clod_status *status)
{
    const clod_neighbour none = {0};
    rows->domain = *domain;
    rows->contact_count = rows->wall_contact_count = 0;
    if (!clod_neighbour_wrap(&none, rows, 0, (clod_chunk){0, rows->grains.count})) {
        return clod_neighbour_inside(&none, rows, 0, status);
    }
    if (!clod_state_reserve_build(rows)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory to sort %zu grains",
                                rows->grains.count);
    }
    memcpy(rows->build_position, rows->grains.position,
           rows->grains.count * sizeof *rows->build_position);
    return true;
}

/** Every grain to its owner. */
static bool deal(clod_crew *self, const clod_crew_order *what, clod_status *status)
{
    clod_spread *spread = &self->spread;
    clod_state *state = &self->state;
    const bool whole = self->whole != NULL && !what->dealt;
    clod_state *from = whole ? self->whole->state : state;
    skin_choice choice = {.fresh = what->fresh, .state = state};
    if (what->fresh) {
        const bool noted = note_rows(from, &state->domain, status);
        if (!clod_ranks_agree(self->ranks, noted, status)) {
            return false;
        }
        const double fastest = fmax(clod_step_fastest(from), clod_step_fastest(state));
        choice.speed = -clod_spread_least(spread, -fastest);
    }
    if (!clod_migrate(spread, from, state, choose_skin, &choice, status) ||
        (what->dealt && !what->fresh && !clod_crew_part_route(self, status))) {
        return false;
    }
    spread->balance.moved = 0; // nobody had them
    if (what->fresh) {
        state->build_skin = choose_skin(&choice, &spread->bed);
        state->build_motion = 0.0;
    }
    if (self->whole != NULL && self->stale) {
        clod_crew_state_forget(self->whole->state);
    }
    const clod_separated *separated = &spread->separated;
    const bool good =
        clod_neighbour_periods_fit(&state->domain, spread->bed.largest, status) &&
        (!separated->any || clod_neighbour_fail_separated(state, separated->id, status));
    return clod_ranks_agree(self->ranks, good, status);
}

bool clod_crew_part_begin(clod_crew *self, const clod_crew_order *what, clod_status *status)
{
    if (!make_part(self, what, status) ||
        !clod_spread_init(&self->spread, self->ranks, self->state.walls.count, status) ||
        !clod_ranks_reserve(self->ranks, sizeof self->state.planes.passed, status)) {
        return false;
    }
    self->spread.balance.options = what->balance;
    if (!deal(self, what, status)) {
        return false;
    }
    const clod_step_options options = {.threads = what->threads,
                                       .simd = what->simd[0] != '\0' ? what->simd : NULL,
                                       .brute_force = what->brute_force,
                                       .overlap_limit = what->overlap_limit,
                                       .spread = &self->spread};
    self->ledger = self->state.ledger.open != 0;
    return clod_step_init(&self->step, &self->state, &self->laws, &options, status) &&
           (!what->fresh || clod_step_first_forces(&self->step, status));
}
