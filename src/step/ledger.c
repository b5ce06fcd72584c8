// Stage ledger, and the energies of a moment. Sums go in the order of the contacts, which no
// refresh of the near list changes (pairs that do not touch add zero): same bits always.
#include <math.h>
#include <string.h>

#include "step/step.h"

/** Sums of up to four numbers for each grain; the cut into parts changes none. */
typedef double (*grain_sums)[4];

/** Rows to add up in, all zero. */
static grain_sums empty_sums(clod_step *self)
{
    grain_sums sums = clod_neighbour_rows(&self->neighbour);
    memset(sums, 0, self->state->grains.count * sizeof *sums);
    return sums;
}

static void add_up(clod_step *self, double all[4])
{
    grain_sums sums = clod_neighbour_rows(&self->neighbour);
    for (size_t g = 0; g < self->state->grains.count; g++) {
        for (int c = 0; c < 4; c++) {
            all[c] += sums[g][c];
        }
    }
}

/** What one block spent, to the grains that stand first in its contacts. */
static void spend_block(const clod_spent_block *spent, const int32_t *i, int contacts,
                        grain_sums sums)
{
    for (int l = 0; l < contacts; l++) {
        sums[i[l]][0] += spent->plastic[l];
        sums[i[l]][1] += spent->dash_pot[l];
        sums[i[l]][2] += spent->friction[l];
        sums[i[l]][3] += spent->rolling[l];
    }
}

/** Contacts of a block of a group. */
static int contacts_of(const clod_near_blocks *list, size_t group, size_t block)
{
    const size_t before = (block - list->group_start[group]) * CLOD_LANES;
    const size_t left = list->group_count[group] - before;
    return left < CLOD_LANES ? (int)left : CLOD_LANES;
}

/** The same for the lag, which finds no room beside the four losses. */
static void lag_block(const clod_spent_block *spent, const int32_t *i, int contacts,
                      grain_sums sums)
{
    for (int l = 0; l < contacts; l++) {
        sums[i[l]][0] += spent->lag[l];
    }
}

typedef void add_block(const clod_spent_block *spent, const int32_t *i, int contacts,
                       grain_sums sums);

/** Add a number of each contact of a list in this step: by law, by grain, by partner. */
static void add_list(clod_step *self, const clod_near_blocks *list, add_block *add,
                     double all[4])
{
    const clod_near *near = &self->near;
    grain_sums sums = empty_sums(self);
    for (int32_t l = 0; l < near->laws; l++) {
        for (int p = 0; p < 2 * near->parts; p++) { // a grain's own part, then later ones
            const size_t q = clod_near_group(near, p, l);
            for (size_t b = list->group_start[q]; b < list->group_start[q + 1]; b++) {
                const int32_t *i = list == &near->pairs
                                       ? ((const clod_contact_block *)list->block)[b].i
                                       : ((const clod_wall_block *)list->block)[b].i;
                add(&list->spent[b], i, contacts_of(list, q, b), sums);
            }
        }
    }
    add_up(self, all);
}

/** Add what the contacts of a list spent in this step to the ledger. */
static void add_spent(clod_step *self, const clod_near_blocks *list, clod_ledger *ledger)
{
    double lost[4] = {0.0};
    double lag[4] = {0.0};
    add_list(self, list, spend_block, lost);
    add_list(self, list, lag_block, lag);
    ledger->plastic += lost[0];
    ledger->dash_pot += lost[1];
    ledger->friction += lost[2];
    ledger->rolling += lost[3];
    ledger->lag += lag[0];
}

void clod_step_ledger(clod_step *self, int part)
{
    if (part != 0 || !self->near.ledger) {
        return;
    }
    add_spent(self, &self->near.pairs, &self->state->ledger);
    add_spent(self, &self->near.walls, &self->state->ledger);
}

static void add_grains(const clod_state *state, clod_energies *e)
{
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *p = state->grains.place[g];
        const double *v = state->grains.motion[g];
        const double *w = state->grains.turning[g];
        e->translation += 0.5 * v[3] * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        e->rotation += 0.5 / w[3] * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        e->potential -= v[3] * (state->gravity[0] * p[0] + state->gravity[1] * p[1] +
                                state->gravity[2] * p[2]);
    }
}

static void store_block(const clod_stored_block *stored, const int32_t *i, int contacts,
                        grain_sums sums)
{
    for (int l = 0; l < contacts; l++) {
        sums[i[l]][0] += stored->normal[l];
        sums[i[l]][1] += stored->sliding[l];
        sums[i[l]][2] += stored->rolling[l];
    }
}

/** What the pairs of one group store. */
static void store_pairs(clod_step *self, size_t q, const clod_law *law, grain_sums sums)
{
    const clod_near_blocks *pairs = &self->near.pairs;
    clod_contact_block *blocks = pairs->block;
    clod_stored_block stored;
    for (size_t b = pairs->group_start[q]; b < pairs->group_start[q + 1]; b++) {
        self->kernel->contact_stored(&self->view, law, &blocks[b], &stored);
        store_block(&stored, blocks[b].i, contacts_of(pairs, q, b), sums);
    }
}

/** What the wall contacts of one group store. */
static void store_walls(clod_step *self, size_t q, const clod_law *law, grain_sums sums)
{
    const clod_near_blocks *walls = &self->near.walls;
    clod_wall_block *blocks = walls->block;
    clod_stored_block stored;
    for (size_t b = walls->group_start[q]; b < walls->group_start[q + 1]; b++) {
        self->kernel->wall_stored(&self->view, law, &blocks[b], &stored);
        store_block(&stored, blocks[b].i, contacts_of(walls, q, b), sums);
    }
}

static void add_contacts(clod_step *self, clod_energies *e)
{
    grain_sums sums = empty_sums(self);
    for (int32_t l = 0; l < self->laws->count; l++) {
        for (int p = 0; p < 2 * self->near.parts; p++) { // a grain's own part, then later ones
            store_pairs(self, clod_near_group(&self->near, p, l), &self->laws->law[l], sums);
        }
        for (int p = 0; p < self->near.parts; p++) {
            store_walls(self, clod_near_group(&self->near, p, l), &self->laws->law[l], sums);
        }
    }
    double all[4] = {0.0};
    add_up(self, all);
    e->normal += all[0];
    e->sliding += all[1];
    e->rolling += all[2];
}

clod_energies clod_step_energies(clod_step *self)
{
    clod_energies e = {0};
    if (!clod_step_take_back(self)) {
        e.normal = NAN;
        return e;
    }
    clod_wall_rows_update(&self->walls, &self->state->walls); // someone may have moved them
    add_grains(self->state, &e);
    add_contacts(self, &e);
    if (!self->near.ledger) { // else every step needs the scratch
        clod_neighbour_give_back(&self->neighbour);
    }
    return e;
}

bool clod_step_open_ledger(clod_step *self, clod_status *status)
{
    if (!clod_step_take_back(self)) {
        *status = self->status;
        return false;
    }
    if (!clod_grains_keep_before(&self->state->grains, status)) {
        return false;
    }
    self->view.before = (const double(*)[8])self->state->grains.before;
    self->near.ledger = true;
    if (!clod_near_reserve_spent(&self->near)) {
        self->near.ledger = false;
        return clod_status_fail(status, CLOD_FAILED, "no memory for the energy ledger");
    }
    const clod_energies now = clod_step_energies(self);
    self->state->ledger = (clod_ledger){.open = 1, .start = clod_energies_sum(&now)};
    return true;
}
