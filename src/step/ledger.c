// Stages dissipate and ledger, and the energies of a moment. Sums are exact: they do not depend on the order
// of grains and contacts, nor on how these are cut into parts.
#include <math.h>

#include "parallel/threads.h"
#include "step/crew.h"
#include "step/spread.h"

/** Contacts of a block of a group. */
static int contacts_of(const clod_near_blocks *list, size_t group, size_t block)
{
    const size_t before = (block - list->group_start[group]) * CLOD_LANES;
    const size_t left = list->group_count[group] - before;
    return left < CLOD_LANES ? (int)left : CLOD_LANES;
}

/** Lanes of a block that count here, as bits: where grains are spread over ranks, a contact counts
 *  where its first grain is owned. */
static unsigned lanes_of(const clod_step *self, const int32_t *i, int contacts)
{
    unsigned lanes = 0;
    for (int l = 0; l < contacts; l++) {
        lanes |= (self->spread == NULL || clod_spread_owns(self->spread, i[l]) ? 1U : 0U) << l;
    }
    return lanes;
}

static void add_lanes(clod_exact *sum, const double *lane, unsigned lanes)
{
    for (int l = 0; l < CLOD_LANES; l++) {
        if ((lanes >> l & 1U) != 0) {
            clod_exact_add(sum, lane[l]);
        }
    }
}

/** Rows of the first grains of a block of either list. */
static const int32_t *first_grains(const clod_near *near, const clod_near_blocks *list,
                                   size_t block)
{
    return list == &near->pairs ? ((const clod_contact_block *)list->block)[block].i
                                : ((const clod_wall_block *)list->block)[block].i;
}

/** Add what each contact of a group dissipated in this step. */
static void add_dissipated(const clod_step *self, const clod_near_blocks *list, size_t q,
                           clod_step_heat *sums)
{
    for (size_t b = list->group_start[q]; b < list->group_start[q + 1]; b++) {
        const clod_dissipation_block *dissipated = &list->dissipated[b];
        const unsigned lanes =
            lanes_of(self, first_grains(&self->near, list, b), contacts_of(list, q, b));
        add_lanes(&sums->plastic, dissipated->plastic, lanes);
        add_lanes(&sums->dash_pot, dissipated->dash_pot, lanes);
        add_lanes(&sums->friction, dissipated->friction, lanes);
        add_lanes(&sums->rolling, dissipated->rolling, lanes);
        add_lanes(&sums->lag, dissipated->lag, lanes);
    }
}

/** What the contacts dissipated that a thread has computed. */
void clod_step_dissipate(clod_step *self, int part)
{
    const clod_near *near = &self->near;
    if (!near->ledger) {
        return;
    }
    clod_step_heat *sums = &self->thread[part].dissipated;
    *sums = (clod_step_heat){0};
    const clod_chunk mine = clod_threads_chunk((size_t)near->parts, part, self->threads);
    for (int p = (int)mine.begin; p < (int)mine.end; p++) {
        for (int32_t l = 0; l < near->laws; l++) {
            add_dissipated(self, &near->pairs, clod_near_group(near, p, l), sums);
            add_dissipated(self, &near->pairs, clod_near_group_between(near, p, l), sums);
            for (int form = 0; form < CLOD_FORMS; form++) {
                add_dissipated(self, &near->walls,
                               clod_near_wall_group(near, p, l, (clod_wall_form)form), sums);
            }
        }
    }
}

void clod_step_add_ledger(clod_step *self)
{
    if (!self->near.ledger) {
        return;
    }
    clod_step_heat all = {0};
    for (int t = 0; t < self->threads; t++) {
        const clod_step_heat *some = &self->thread[t].dissipated;
        clod_exact_merge(&all.plastic, &some->plastic);
        clod_exact_merge(&all.dash_pot, &some->dash_pot);
        clod_exact_merge(&all.friction, &some->friction);
        clod_exact_merge(&all.rolling, &some->rolling);
        clod_exact_merge(&all.lag, &some->lag);
    }
    clod_ledger *ledger = &self->state->ledger;
    ledger->plastic += clod_exact_value(&all.plastic);
    ledger->dash_pot += clod_exact_value(&all.dash_pot);
    ledger->friction += clod_exact_value(&all.friction);
    ledger->rolling += clod_exact_value(&all.rolling);
    ledger->lag += clod_exact_value(&all.lag);
}

void clod_step_ledger(clod_step *self, int part)
{
    if (part == 0 && self->spread == NULL) { // else stage ghosts does, in the next step
        clod_step_add_ledger(self);
    }
}

static void add_grain(clod_step_stored *sums, const clod_state *state, size_t g)
{
    const double *p = state->grains.position[g];
    const double *v = state->grains.velocity[g];
    const double *w = state->grains.angular_velocity[g];
    clod_exact_add(&sums->translation, 0.5 * v[3] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
    clod_exact_add(&sums->rotation, 0.5 / w[3] * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]));
    clod_exact_add(&sums->potential,
                   -v[3] * (state->gravity[0] * p[0] + state->gravity[1] * p[1] +
                            state->gravity[2] * p[2]));
}

static void add_stored(clod_step_stored *sums, const clod_stored_block *stored, unsigned lanes)
{
    add_lanes(&sums->normal, stored->normal, lanes);
    add_lanes(&sums->sliding, stored->sliding, lanes);
    add_lanes(&sums->turning, stored->rolling, lanes);
}

/** What the pairs of one group store. */
static void store_pairs(clod_step *self, size_t q, const clod_law *law, clod_step_stored *sums)
{
    const clod_near_blocks *pairs = &self->near.pairs;
    clod_contact_block *blocks = pairs->block;
    clod_stored_block stored;
    for (size_t b = pairs->group_start[q]; b < pairs->group_start[q + 1]; b++) {
        self->kernel->contact_stored(&self->view, law, &blocks[b], &stored);
        add_stored(sums, &stored, lanes_of(self, blocks[b].i, contacts_of(pairs, q, b)));
    }
}

/** What the wall contacts of one group store. */
static void store_walls(clod_step *self, int part, int32_t l, clod_wall_form form,
                        clod_step_stored *sums)
{
    const clod_law *law = &self->laws->law[l];
    const size_t q = clod_near_wall_group(&self->near, part, l, form);
    const clod_near_blocks *walls = &self->near.walls;
    clod_wall_block *blocks = walls->block;
    clod_stored_block stored;
    for (size_t b = walls->group_start[q]; b < walls->group_start[q + 1]; b++) {
        self->kernel->wall_stored(&self->view, law, form, &blocks[b], &stored);
        add_stored(sums, &stored, lanes_of(self, blocks[b].i, contacts_of(walls, q, b)));
    }
}

static void add_contacts(clod_step *self, clod_step_stored *sums)
{
    const clod_near *near = &self->near;
    for (int32_t l = 0; l < near->laws; l++) {
        const clod_law *law = &self->laws->law[l];
        for (int p = 0; p < 2 * near->parts; p++) { // within a part, then with later ones
            store_pairs(self, clod_near_group(near, p, l), law, sums);
        }
        for (int k = 0; k < near->parts * CLOD_FORMS; k++) {
            store_walls(self, k / CLOD_FORMS, l, (clod_wall_form)(k % CLOD_FORMS), sums);
        }
    }
}

void clod_step_store(clod_step *self, clod_step_stored *sums)
{
    *sums = (clod_step_stored){0};
    clod_wall_rows_update(&self->walls, &self->state->walls); // someone may have moved them
    for (size_t g = 0; g < self->state->grains.count; g++) {
        if (self->spread == NULL || clod_spread_owns(self->spread, (int32_t)g)) {
            add_grain(sums, self->state, g);
        }
    }
    add_contacts(self, sums);
}

clod_energies clod_step_energies(clod_step *self)
{
    if (self->failed) {
        return (clod_energies){.normal = NAN};
    }
    clod_step_stored sums;
    if (self->crew != NULL) {
        clod_crew_store(self->crew, &sums);
    } else {
        clod_step_store(self, &sums);
        clod_spread_merge_stored(self->spread, &sums);
    }
    return (clod_energies){.translation = clod_exact_value(&sums.translation),
                           .rotation = clod_exact_value(&sums.rotation),
                           .potential = clod_exact_value(&sums.potential),
                           .normal = clod_exact_value(&sums.normal),
                           .sliding = clod_exact_value(&sums.sliding),
                           .rolling = clod_exact_value(&sums.turning)};
}

double clod_step_balance(clod_step *self)
{
    if (self->state->ledger.open == 0) {
        return 0.0;
    }
    const clod_energies now = clod_step_energies(self);
    return clod_energies_sum(&now);
}

void clod_step_book(clod_step *self, double before)
{
    if (self->state->ledger.open != 0) {
        self->state->ledger.exchanged += clod_step_balance(self) - before;
    }
}

bool clod_step_keep_ledger(clod_step *self, clod_status *status)
{
    if (!clod_grains_keep_before(&self->state->grains, status)) {
        return false;
    }
    self->view.before = (const double(*)[8])self->state->grains.before;
    self->near.ledger = true;
    if (!clod_near_reserve_dissipated(&self->near)) {
        self->near.ledger = false;
        return clod_status_fail(status, CLOD_FAILED, "no memory for the energy ledger");
    }
    return true;
}

bool clod_step_open_ledger(clod_step *self, clod_status *status)
{
    if (self->failed) {
        *status = self->status;
        return false;
    }
    if (!clod_step_keep_ledger(self, status)) {
        return false;
    }
    const clod_energies now = clod_step_energies(self);
    self->state->ledger = (clod_ledger){.open = 1, .start = clod_energies_sum(&now)};
    return true;
}
