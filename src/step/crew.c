#include "step/crew.h"

#include <stdio.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "step/crew_deal.h"
#include "step/crew_part.h"
#include "step/crew_state.h"
#include "step/crew_survey.h"
#include "step/derived.h"
#include "step/trouble.h"

// ---- rank 0

static void give_order(const clod_crew *self, clod_crew_order what)
{
    clod_ranks_tell(self->ranks, &what, sizeof what);
}

void clod_crew_give(const clod_crew *self, clod_crew_order_kind what)
{
    give_order(self, (clod_crew_order){.what = what});
}

/** It steps no more; false. */
static bool fail(clod_step *whole, const clod_status *status)
{
    whole->failed = true;
    whole->status = *status;
    return false;
}

/** The lists of the whole bed are on the ranks from now on. */
static void drop_lists(clod_step *whole, const clod_step_options *options)
{
    clod_near_fini(&whole->near);
    clod_neighbour_fini(&whole->neighbour);
    clod_neighbour_init(&whole->neighbour, whole->state, options->brute_force);
    whole->neighbour.kernel = whole->kernel;
}

/** Whether nobody has stepped the bed: each rank makes its first lists and forces. */
static bool is_fresh(const clod_state *state)
{
    return state->build_motion < 0.0 || state->build_position == NULL;
}

/** As an order to the others: the bed of a step, as its options want it. */
static clod_crew_order order_to_begin(const clod_step *whole, const clod_step_options *options,
                                      bool first)
{
    clod_crew_order what = {.what = CLOD_CREW_BEGIN,
                            .dealt = first && options->dealt != NULL,
                            .fresh = first && is_fresh(whole->state),
                            .clumps = whole->state->grains.clump != NULL,
                            .threads = whole->threads,
                            .brute_force = options->brute_force,
                            .overlap_limit = options->overlap_limit,
                            .balance = options->balance};
    snprintf(what.simd, sizeof what.simd, "%s", options->simd != NULL ? options->simd : "");
    return what;
}

bool clod_crew_begin(clod_step *whole, const clod_step_options *options, bool first,
                     clod_status *status)
{
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
    self->stale = first; // it has not been in the order of one process
    const clod_crew_order what = order_to_begin(whole, options, first);
    if (what.dealt) {
        self->share = *options->dealt;
        *options->dealt = (clod_crew_share){0};
    }
    drop_lists(whole, options);
    give_order(self, what);
    if (!clod_crew_part_begin(self, &what, status)) {
        clod_crew_part_end(self);
        clod_memory_free(self);
        return false;
    }
    if (first) {
        clod_crew_state_copy(whole->state, &self->state);
    }
    whole->crew = self;
    return true;
}

/** Before an order that looks at the bed or changes it: what of the whole state ranks are to know. */
static clod_crew_order prepare(clod_crew *self, clod_crew_order_kind what, int64_t steps)
{
    const clod_state *state = self->whole->state;
    const bool lack_clumps = self->state.grains.clump == NULL;
    clod_crew_state_copy(&self->state, state);
    return (clod_crew_order){.what = what,
                             .steps = steps,
                             .clumps =
                                 state->grains.clump != NULL && (!self->stale || lack_clumps)};
}

bool clod_crew_see(clod_crew *self, clod_status *status)
{
    if (!self->stale) {
        return true;
    }
    clod_step *whole = self->whole;
    const clod_crew_order what = prepare(self, CLOD_CREW_SEE, 0);
    give_order(self, what);
    if (!clod_crew_part_see(self, &what, status) ||
        !clod_neighbour_sort_as_built(&whole->neighbour, whole->state, status)) {
        return false;
    }
    clod_grains_pad(&whole->state->grains);
    self->stale = false;
    return true;
}

bool clod_crew_see_near(clod_crew *self, const clod_domain_box *box, int count,
                        clod_status *status)
{
    if (!self->stale) {
        return true;
    }
    clod_domain_box copy[CLOD_STEP_BOXES];
    CLOD_ASSERT(count <= CLOD_STEP_BOXES);
    memcpy(copy, box, (size_t)count * sizeof *copy);
    clod_crew_order what = prepare(self, CLOD_CREW_SEE_NEAR, 0);
    what.boxes = count;
    give_order(self, what);
    return clod_crew_part_see_near(self, &what, copy, status);
}

bool clod_crew_see_gone(clod_crew *self, clod_status *status)
{
    if (!self->stale || !self->state.gone.kept) {
        return true;
    }
    give_order(self, (clod_crew_order){.what = CLOD_CREW_GONE});
    return clod_crew_part_see_gone(self, status);
}

bool clod_crew_survey(clod_crew *self, const clod_survey_question *question,
                      clod_status *status)
{
    const clod_crew_order what = prepare(self, CLOD_CREW_SURVEY, 0);
    give_order(self, what);
    return clod_crew_part_survey(self, &what, question, status) || fail(self->whole, status);
}

size_t clod_crew_grains(const clod_crew *self)
{
    return self->spread.bed.count;
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

/** After it: what the whole state is to know of the ranks. */
static void conclude(clod_crew *self, bool good, const clod_status *status)
{
    clod_step *whole = self->whole;
    clod_crew_state_copy(whole->state, &self->state);
    if (!self->stale && (!self->broken || self->spread.adrift)) { // else no step was made
        clod_crew_state_forget(whole->state);
        self->stale = true;
    }
    whole->rebuilds = self->rebuilds + self->step.rebuilds;
    whole->refreshes = self->refreshes + self->step.refreshes;
    if (!good && (self->step.failed || self->broken || self->spread.wear_lost)) {
        fail(whole, status);
    }
}

bool clod_crew_advance(clod_crew *self, int64_t steps, clod_status *status)
{
    const clod_crew_order what = prepare(self, CLOD_CREW_ADVANCE, steps);
    give_order(self, what);
    const bool good = clod_crew_part_advance(self, &what, status);
    conclude(self, good, status);
    return good ||
           (!self->whole->failed && !self->step.trouble.any && report_trouble(self, status));
}

/** Whether only grains are to come that need no look at the whole bed. */
static bool can_take(const clod_step *whole)
{
    const clod_changes *queue = &whole->state->changes;
    return queue->new_grains > 0 && queue->lost_grains == 0 && queue->new_walls == 0 &&
           queue->lost_walls == 0 && !queue->moved && !queue->lacks_memory &&
           (queue->checked == queue->new_grains || whole->accepts == NULL);
}

static bool order_take(clod_crew *self, clod_status *status)
{
    clod_changes *queue = &self->whole->state->changes;
    const clod_crew_order what = prepare(self, CLOD_CREW_TAKE, 0);
    self->state.changes = *queue; // clod_step_take frees it, or clod_crew_part_end
    *queue = (clod_changes){0};
    give_order(self, what);
    const bool good = clod_crew_part_take(self, &what, status);
    conclude(self, good, status);
    return good;
}

/** The bed is in this process alone, with its lists; the whole state is seen. */
static bool take_back(clod_step *whole, clod_status *status)
{
    clod_crew_end(&whole->crew);
    whole->near.parts = whole->threads;
    whole->near.ledger = whole->state->ledger.open != 0;
    clod_wall_rows_update(&whole->walls, &whole->state->walls);
    return clod_step_build_lists(whole, false, status) || fail(whole, status);
}

/** Ranks step it again. */
static bool deal_anew(clod_step *whole, const clod_step_options *options, clod_status *status)
{
    return (clod_step_export(whole, status) &&
            clod_crew_begin(whole, options, false, status)) ||
           fail(whole, status);
}

bool clod_crew_change(clod_step *whole, clod_status *status)
{
    if (can_take(whole)) {
        return order_take(whole->crew, status);
    }
    const clod_step_options options = whole->crew->options;
    clod_status of_ranks;
    if (!clod_crew_see(whole->crew, status) || !take_back(whole, status)) {
        return false;
    }
    const bool changed = clod_step_change(whole, status); // what is refused changes nothing
    if (whole->failed || deal_anew(whole, &options, &of_ranks)) {
        return changed;
    }
    *status = of_ranks;
    return false;
}

bool clod_crew_renew(clod_step *whole, clod_status *status)
{
    const clod_step_options options = whole->crew->options;
    return clod_crew_see(whole->crew, status) && take_back(whole, status) &&
           deal_anew(whole, &options, status);
}

void clod_crew_store(clod_crew *self, clod_step_stored *sums)
{
    clod_crew_state_copy(&self->state, self->whole->state);
    give_order(self, (clod_crew_order){.what = CLOD_CREW_STORE});
    clod_crew_part_store(self, sums);
}

void clod_crew_end(clod_crew **self)
{
    if (*self != NULL) {
        give_order(*self, (clod_crew_order){.what = CLOD_CREW_END});
        clod_crew_part_end(*self);
        clod_memory_free(*self);
        *self = NULL;
    }
}

void clod_crew_dismiss(clod_ranks *ranks)
{
    clod_crew_order what = {.what = CLOD_CREW_DISMISS};
    clod_ranks_tell(ranks, &what, sizeof what);
}

// ---- the others

/** One order; the status of a failure is told to rank 0. */
static void obey(clod_crew *self, clod_ranks *ranks, const clod_crew_order *what)
{
    clod_status status = {0};
    clod_step_stored sums;
    clod_bed_counts all;
    clod_domain_box box[CLOD_STEP_BOXES];
    clod_bed_layout layout;
    bool done;
    switch (what->what) {
    case CLOD_CREW_DEAL_BEGIN:
        clod_crew_share_fini(&self->share);
        clod_crew_places_fini(&self->places);
        clod_crew_part_deal_begin(ranks, &self->state, &status);
        break;
    case CLOD_CREW_DEAL:
        clod_crew_part_deal(ranks, &self->state, &status);
        break;
    case CLOD_CREW_DEAL_NEAR:
        clod_crew_part_deal_near(ranks, &self->state, &status);
        break;
    case CLOD_CREW_DEAL_CONTACTS:
        clod_crew_part_deal_contacts(ranks, &self->share, &status);
        break;
    case CLOD_CREW_PLACES:
        clod_crew_part_places(&self->places, ranks, &self->state, &status);
        break;
    case CLOD_CREW_BEGIN:
        self->ranks = ranks;
        if (!clod_crew_part_begin(self, what, &status)) {
            clod_crew_part_end(self);
        }
        break;
    case CLOD_CREW_ADVANCE:
        clod_crew_part_advance(self, what, &status);
        break;
    case CLOD_CREW_SEE:
        clod_crew_part_see(self, what, &status);
        break;
    case CLOD_CREW_SEE_NEAR:
        clod_crew_part_see_near(self, what, box, &status);
        break;
    case CLOD_CREW_TAKE:
        clod_crew_part_take(self, what, &status);
        break;
    case CLOD_CREW_STORE:
        clod_crew_part_store(self, &sums);
        break;
    case CLOD_CREW_SURVEY:
        clod_crew_part_survey(self, what, NULL, &status);
        break;
    case CLOD_CREW_GONE:
        clod_crew_part_see_gone(self, &status);
        break;
    case CLOD_CREW_SLABS_BEGIN:
        clod_crew_slabs_begin(self, (clod_bed_wants){0}, &all, &status);
        break;
    case CLOD_CREW_SLABS_BRING:
        clod_crew_slabs_bring(self, NULL, &status);
        break;
    case CLOD_CREW_SLABS_WRITE:
        clod_crew_write(self, &layout, &done, &status);
        break;
    case CLOD_CREW_HASH:
        clod_crew_hash(self, &layout.file, NULL);
        break;
    case CLOD_CREW_SLABS_END:
        clod_crew_slabs_end(self);
        break;
    case CLOD_CREW_END:
        clod_crew_part_end(self);
        break;
    case CLOD_CREW_DISMISS:
        break;
    }
}

void clod_crew_serve(clod_ranks *ranks)
{
    clod_crew self = {0};
    clod_crew_order what;
    do {
        clod_ranks_tell(ranks, &what, sizeof what);
        obey(&self, ranks, &what);
    } while (what.what != CLOD_CREW_DISMISS);
    clod_crew_part_end(&self); // a bed that was dealt and never stepped
}
