// Stage ledger, and the energies of a moment. Sums go in the order of the contacts, which no
// refresh of the near list changes (pairs that do not touch add zero): same bits always.
#include <math.h>

#include "step/step.h"

/** Add what each contact of a list spent in this step. */
static void add_spent(const clod_near_blocks *list, clod_ledger *ledger)
{
    clod_ledger step = {0};
    for (size_t b = 0; b < list->count; b++) {
        for (int l = 0; l < CLOD_LANES; l++) {
            step.plastic += list->spent[b].plastic[l];
            step.dash_pot += list->spent[b].dash_pot[l];
            step.friction += list->spent[b].friction[l];
            step.rolling += list->spent[b].rolling[l];
        }
    }
    ledger->plastic += step.plastic;
    ledger->dash_pot += step.dash_pot;
    ledger->friction += step.friction;
    ledger->rolling += step.rolling;
}

void clod_step_ledger(clod_step *self, int part)
{
    if (part != 0 || !self->near.ledger) {
        return;
    }
    add_spent(&self->near.pairs, &self->state->ledger);
    add_spent(&self->near.walls, &self->state->ledger);
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

static void add_stored(const clod_stored_block *stored, clod_energies *e)
{
    for (int l = 0; l < CLOD_LANES; l++) {
        e->normal += stored->normal[l];
        e->sliding += stored->sliding[l];
        e->rolling += stored->rolling[l];
    }
}

static void add_contacts(const clod_step *self, clod_energies *e)
{
    const clod_near_blocks *pairs = &self->near.pairs;
    const clod_near_blocks *walls = &self->near.walls;
    clod_contact_block *pair_blocks = pairs->block;
    clod_wall_block *wall_blocks = walls->block;
    clod_stored_block stored;
    for (int32_t l = 0; l < self->laws->count; l++) {
        const clod_law *law = &self->laws->law[l];
        for (size_t b = pairs->law_start[l]; b < pairs->law_start[l + 1]; b++) {
            self->kernel->contact_stored(&self->view, law, &pair_blocks[b], &stored);
            add_stored(&stored, e);
        }
        for (size_t b = walls->law_start[l]; b < walls->law_start[l + 1]; b++) {
            clod_kernel_wall_stage stage;
            clod_step_stage_walls(self, &wall_blocks[b], &stage);
            self->kernel->wall_stored(&self->view, law, &stage, &wall_blocks[b], &stored);
            add_stored(&stored, e);
        }
    }
}

clod_energies clod_step_energies(clod_step *self)
{
    clod_energies e = {0};
    for (int32_t w = 0; w < self->state->walls.count; w++) { // someone may have moved them
        self->pose[w] = clod_wall_pose_now(&self->state->walls.wall[w]);
    }
    add_grains(self->state, &e);
    add_contacts(self, &e);
    return e;
}

bool clod_step_open_ledger(clod_step *self, clod_status *status)
{
    self->near.ledger = true;
    if (!clod_near_reserve_spent(&self->near)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the energy ledger");
    }
    const clod_energies now = clod_step_energies(self);
    self->state->ledger = (clod_ledger){.open = 1, .start = clod_energies_sum(&now)};
    return true;
}
