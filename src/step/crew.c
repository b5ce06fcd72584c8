#include "step/crew.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "step/crew_clumps.h"
#include "step/crew_state.h"
#include "step/derived.h"
#include "step/migrate.h"
#include "step/trouble.h"

struct clod_crew {
    clod_ranks *ranks;           ///< borrowed
    clod_step *whole;            ///< of rank 0; NULL on the others
    bool stale;                  ///< the whole state's grains are those of an earlier step
    clod_step_options options;   ///< that it began with
    int64_t rebuilds, refreshes; ///< of the whole step before it began
    clod_state state;            ///< of this rank
    clod_laws laws;
    clod_spread spread;
    clod_step step;
};

typedef enum order_kind {
    ORDER_BEGIN,
    ORDER_ADVANCE,
    ORDER_SEE,
    ORDER_STORE,
    ORDER_END,
    ORDER_DISMISS
} order_kind;

/** What rank 0 wants the others to do with it. */
typedef struct order {
    order_kind what;
    int64_t steps; ///< of an advance
    bool clumps;   ///< somebody may have found other clumps, or any at a beginning
    // of a beginning
    int threads;
    bool brute_force;
    double overlap_limit;
    char simd[16];
} order;

// ---- what all ranks do together

/** All that is this rank's; rank 0 begins with a copy of everything. */
static bool make_part(clod_crew *self, bool clumps, clod_status *status)
{
    bool good = clod_grains_reserve(&self->state.grains, 0, status);
    if (self->whole != NULL) {
        clod_state_fini(&self->state);
        good = clod_state_copy(&self->state, self->whole->state, status);
        self->laws = *self->whole->laws; // borrowed
    }
    if (!clod_ranks_agree(self->ranks, good, status) ||
        !clod_crew_state_begin(self->ranks, &self->state, &self->laws, status)) {
        return false;
    }
    clod_grains *grains = &self->state.grains;
    good = (self->state.ledger.open == 0 || clod_grains_keep_before(grains, status)) &&
           (!clumps || clod_grains_keep_clumps(grains, status));
    return clod_ranks_agree(self->ranks, good, status);
}

/** The skin of the last rebuild, whatever the bed. */
static double same_skin(const void *context, const clod_layers_extent *bed)
{
    (void)bed;
    const clod_state *state = context;
    return state->build_skin;
}

static bool begin(clod_crew *self, const order *what, clod_status *status)
{
    if (!make_part(self, what->clumps, status) ||
        !clod_spread_init(&self->spread, self->ranks, self->state.walls.count, status) ||
        !clod_migrate(&self->spread, &self->state, same_skin, &self->state, status)) {
        return false;
    }
    const clod_step_options options = {.threads = what->threads,
                                       .simd = what->simd[0] != '\0' ? what->simd : NULL,
                                       .brute_force = what->brute_force,
                                       .overlap_limit = what->overlap_limit,
                                       .spread = &self->spread};
    return clod_step_init(&self->step, &self->state, &self->laws, &options, status);
}

/** Walls and numbers of rank 0, and what follows from them. */
static bool update(clod_crew *self, clod_status *status)
{
    clod_crew_state_tell(self->ranks, &self->state);
    if (self->whole == NULL) {
        clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    }
    if (self->state.ledger.open == 0 || self->step.near.ledger) {
        return true;
    }
    const bool kept = clod_step_keep_ledger(&self->step, status);
    return clod_ranks_agree(self->ranks, kept, status) &&
           clod_spread_list(&self->spread, &self->state, self->step.neighbour.skin, status);
}

static bool advance(clod_crew *self, const order *what, clod_status *status)
{
    const clod_state *whole = self->whole != NULL ? self->whole->state : NULL;
    const bool good =
        update(self, status) &&
        (!what->clumps || clod_crew_clumps_tell(self->ranks, whole, &self->state, status)) &&
        clod_step_advance(&self->step, what->steps, status);
    return clod_ranks_agree(self->ranks, good, status);
}

static bool see(clod_crew *self, clod_status *status)
{
    const bool listed = clod_step_export(&self->step, status);
    return clod_ranks_agree(self->ranks, listed, status) &&
           clod_migrate_gather(&self->spread, &self->state,
                               self->whole != NULL ? self->whole->state : NULL, status);
}

static void store(clod_crew *self, clod_step_stored *sums)
{
    clod_status status = {0};
    update(self, &status); // what it cannot keep now the next advance tells
    clod_step_store(&self->step, sums);
    clod_spread_merge_stored(&self->spread, sums);
}

static void end(clod_crew *self)
{
    clod_step_fini(&self->step);
    clod_state_fini(&self->state);
    clod_spread_fini(&self->spread);
    if (self->whole == NULL) {
        clod_laws_fini(&self->laws);
    }
    *self = (clod_crew){0};
}

// ---- rank 0

static void give_order(const clod_crew *self, order what)
{
    clod_ranks_tell(self->ranks, &what, sizeof what);
}

/** What works on one rank only so far. */
static bool check(const clod_state *state, clod_status *status)
{
    static const char ALONE[] = "on more than one rank %s cannot be computed yet: run it "
                                "without mpirun, or with mpirun -n 1";
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        if (wall->wear != NULL) {
            return clod_status_fail(status, CLOD_USAGE, ALONE, "wear (output.surfaces)");
        }
    }
    return true;
}

/** The lists of the whole bed are on the ranks from now on. */
static void drop_lists(clod_step *whole, const clod_step_options *options)
{
    clod_near_fini(&whole->near);
    clod_neighbour_fini(&whole->neighbour);
    clod_neighbour_init(&whole->neighbour, whole->state, options->brute_force);
    whole->neighbour.kernel = whole->kernel;
}

bool clod_crew_begin(clod_step *whole, const clod_step_options *options, clod_status *status)
{
    if (!check(whole->state, status) || !clod_step_export(whole, status)) {
        return false;
    }
    clod_crew *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %d ranks",
                                options->ranks->size);
    }
    self->ranks = options->ranks;
    self->whole = whole;
    self->options = *options;
    self->rebuilds = whole->rebuilds;
    self->refreshes = whole->refreshes;
    order what = {.what = ORDER_BEGIN,
                  .clumps = whole->state->grains.clump != NULL,
                  .threads = whole->threads,
                  .brute_force = options->brute_force,
                  .overlap_limit = options->overlap_limit};
    snprintf(what.simd, sizeof what.simd, "%s", options->simd != NULL ? options->simd : "");
    give_order(self, what);
    if (!begin(self, &what, status)) {
        end(self);
        clod_memory_free(self);
        return false;
    }
    drop_lists(whole, options);
    whole->crew = self;
    return true;
}

bool clod_crew_see(clod_crew *self, clod_status *status)
{
    if (!self->stale) {
        return true;
    }
    clod_step *whole = self->whole;
    give_order(self, (order){.what = ORDER_SEE});
    if (!see(self, status) ||
        !clod_neighbour_sort_as_built(&whole->neighbour, whole->state, status)) {
        return false;
    }
    clod_grains_pad(&whole->state->grains);
    self->stale = false;
    return true;
}

/** What one process would say when physics has gone wrong. */
static bool report_trouble(clod_crew *self, clod_status *status)
{
    clod_step *whole = self->whole;
    if (!clod_crew_see(self, status)) {
        return false;
    }
    whole->thread[0].finite = self->step.thread[0].finite;
    clod_neighbour *neighbour = &whole->neighbour;
    neighbour->skin = whole->state->build_skin;
    clod_neighbour_size(neighbour, whole->state);
    clod_wall_rows_update(&whole->walls, &whole->state->walls);
    return clod_neighbour_build(neighbour, whole->state, whole->laws, status) &&
           clod_trouble_report(whole, status);
}

bool clod_crew_advance(clod_crew *self, int64_t steps, clod_status *status)
{
    clod_step *whole = self->whole;
    clod_crew_state_copy(&self->state, whole->state);
    const order what = {.what = ORDER_ADVANCE,
                        .steps = steps,
                        .clumps = !self->stale && whole->state->grains.clump != NULL};
    give_order(self, what);
    const bool good = advance(self, &what, status);
    clod_crew_state_copy(whole->state, &self->state);
    self->stale = true;
    whole->rebuilds = self->rebuilds + self->step.rebuilds;
    whole->refreshes = self->refreshes + self->step.refreshes;
    if (!good && !self->step.failed) {
        return report_trouble(self, status);
    }
    if (!good) {
        whole->failed = true;
        whole->status = *status;
    }
    return good;
}

bool clod_crew_change(clod_step *whole, clod_status *status)
{
    if (!clod_crew_see(whole->crew, status)) {
        return false;
    }
    const clod_step_options options = whole->crew->options;
    clod_crew_end(&whole->crew);
    whole->near.parts = whole->threads;
    whole->near.ledger = whole->state->ledger.open != 0;
    clod_wall_rows_update(&whole->walls, &whole->state->walls);
    return clod_step_build_lists(whole, false, status) && clod_step_change(whole, status) &&
           clod_crew_begin(whole, &options, status);
}

void clod_crew_store(clod_crew *self, clod_step_stored *sums)
{
    clod_crew_state_copy(&self->state, self->whole->state);
    give_order(self, (order){.what = ORDER_STORE});
    store(self, sums);
}

void clod_crew_end(clod_crew **self)
{
    if (*self != NULL) {
        give_order(*self, (order){.what = ORDER_END});
        end(*self);
        clod_memory_free(*self);
        *self = NULL;
    }
}

void clod_crew_dismiss(clod_ranks *ranks)
{
    order what = {.what = ORDER_DISMISS};
    clod_ranks_tell(ranks, &what, sizeof what);
}

// ---- the others

/** One order; the status of a failure is told to rank 0. */
static void obey(clod_crew *self, clod_ranks *ranks, const order *what)
{
    clod_status status = {0};
    clod_step_stored sums;
    switch (what->what) {
    case ORDER_BEGIN:
        self->ranks = ranks;
        if (!begin(self, what, &status)) {
            end(self);
        }
        break;
    case ORDER_ADVANCE:
        advance(self, what, &status);
        break;
    case ORDER_SEE:
        see(self, &status);
        break;
    case ORDER_STORE:
        store(self, &sums);
        break;
    case ORDER_END:
        end(self);
        break;
    case ORDER_DISMISS:
        break;
    }
}

void clod_crew_serve(clod_ranks *ranks)
{
    clod_crew self = {0};
    order what;
    do {
        clod_ranks_tell(ranks, &what, sizeof what);
        obey(&self, ranks, &what);
    } while (what.what != ORDER_DISMISS);
}
