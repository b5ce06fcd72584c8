// Stages ghosts and merge: what ranks tell each other in a step. A rank alone has nothing to tell.
#include <math.h>
#include <string.h>

#include "step/spread.h"

#define ROW 4  ///< numbers of a row
#define ROWS 3 ///< of a grain: position, velocity, angular velocity

/** Rows of other ranks' ghosts into the messages. */
static void pack(const clod_spread *self, const clod_grains *grains, size_t numbers)
{
    const clod_ghosts *ghosts = &self->ghosts;
    for (size_t k = 0; k < ghosts->out_start[self->ranks->size]; k++) {
        const size_t g = (size_t)ghosts->out[k];
        double *to = ghosts->sent + k * numbers;
        memcpy(to, grains->position[g], sizeof *grains->position);
        memcpy(to + ROW, grains->velocity[g], sizeof *grains->velocity);
        memcpy(to + 2 * ROW, grains->angular_velocity[g], sizeof *grains->angular_velocity);
        if (grains->before != NULL) {
            memcpy(to + ROWS * ROW, grains->before[g], sizeof *grains->before);
        }
    }
}

/** Own ghosts from the messages; what a step adds to their loads begins anew, unread. */
static void unpack(const clod_spread *self, clod_grains *grains, size_t numbers)
{
    const clod_ghosts *ghosts = &self->ghosts;
    for (size_t k = 0; k < ghosts->in_start[self->ranks->size]; k++) {
        const size_t g = (size_t)ghosts->in[k];
        const double *from = ghosts->got + k * numbers;
        memcpy(grains->position[g], from, sizeof *grains->position);
        memcpy(grains->velocity[g], from + ROW, sizeof *grains->velocity);
        memcpy(grains->angular_velocity[g], from + 2 * ROW, sizeof *grains->angular_velocity);
        memset(grains->load[g], 0, sizeof *grains->load);
        if (grains->before != NULL) {
            memcpy(grains->before[g], from + ROWS * ROW, sizeof *grains->before);
        }
    }
}

static void exchange(const clod_spread *self, clod_grains *grains, size_t numbers)
{
    pack(self, grains, numbers);
    clod_ranks_repeat(self->ranks);
    unpack(self, grains, numbers);
}

void clod_spread_refresh(const clod_spread *self, clod_state *state)
{
    exchange(self, &state->grains, clod_spread_numbers(state));
}

/** What drift saw on a rank. */
typedef struct seen {
    double max_speed2;
    int64_t finite;
} seen;

static void merge_seen(const void *context, void *into, const void *from)
{
    (void)context;
    seen *mine = into;
    const seen *other = from;
    mine->max_speed2 = fmax(mine->max_speed2, other->max_speed2);
    mine->finite &= other->finite;
}

void clod_step_ghosts(clod_step *self, int part)
{
    clod_spread *spread = self->spread;
    if (spread == NULL || part != 0) {
        return;
    }
    seen all = {0.0, 1};
    for (int t = 0; t < self->threads; t++) {
        all.max_speed2 = fmax(all.max_speed2, self->thread[t].max_speed2);
        all.finite &= self->thread[t].finite;
    }
    exchange(spread, &self->state->grains, clod_spread_numbers(self->state));
    clod_ranks_merge(spread->ranks, &all, sizeof all, merge_seen, NULL);
    self->thread[0].max_speed2 = all.max_speed2;
    self->thread[0].finite = all.finite != 0;
}

/** What the contacts of a thread spent, onto those of another. */
static void merge_spent(clod_step_heat *into, const clod_step_heat *from)
{
    clod_exact_merge(&into->plastic, &from->plastic);
    clod_exact_merge(&into->dash_pot, &from->dash_pot);
    clod_exact_merge(&into->friction, &from->friction);
    clod_exact_merge(&into->rolling, &from->rolling);
    clod_exact_merge(&into->lag, &from->lag);
}

/** What the parts of a wall felt, which begin anew. */
static void sum_felt(clod_step *self, clod_fixed *felt, int32_t w)
{
    *felt = (clod_fixed){0};
    for (int32_t s = self->near.sum_start[w]; s < self->near.sum_start[w + 1]; s++) {
        clod_fixed_merge(felt, &self->near.wall_sum[s]);
        self->near.wall_sum[s] = (clod_fixed){0};
    }
}

static void merge_sums(const void *context, void *into, const void *from)
{
    const clod_step *self = context;
    clod_fixed *felt = into;
    const clod_fixed *other = from;
    for (int32_t w = 0; w < self->spread->walls; w++) {
        clod_fixed_merge(&felt[w], &other[w]);
    }
    clod_spread_sums *sums = (clod_spread_sums *)(felt + self->spread->walls);
    const clod_spread_sums *others = (const clod_spread_sums *)(other + self->spread->walls);
    sums->excess |= others->excess;
    if (self->near.ledger) {
        merge_spent(&sums->spent, &others->spent);
    }
}

void clod_step_merge(clod_step *self, int part)
{
    const clod_spread *spread = self->spread;
    if (spread == NULL || part != 0) {
        return;
    }
    clod_spread_sums *sums = (clod_spread_sums *)(spread->felt + spread->walls);
    for (int32_t w = 0; w < spread->walls; w++) {
        sum_felt(self, &spread->felt[w], w);
    }
    *sums = (clod_spread_sums){0};
    for (int t = 0; t < self->threads; t++) {
        sums->excess |= self->thread[t].excess;
        if (self->near.ledger) {
            merge_spent(&sums->spent, &self->thread[t].spent);
            self->thread[t].spent = (clod_step_heat){0};
        }
    }
    const size_t felt = (size_t)spread->walls * sizeof *spread->felt;
    const size_t bytes =
        felt + (self->near.ledger ? sizeof *sums : offsetof(clod_spread_sums, spent));
    clod_ranks_merge(spread->ranks, spread->felt, bytes, merge_sums, self);
    self->thread[0].excess = sums->excess != 0;
    self->thread[0].spent = sums->spent;
}

static void merge_stored(const void *context, void *into, const void *from)
{
    (void)context;
    clod_step_stored *mine = into;
    const clod_step_stored *other = from;
    clod_exact_merge(&mine->translation, &other->translation);
    clod_exact_merge(&mine->rotation, &other->rotation);
    clod_exact_merge(&mine->potential, &other->potential);
    clod_exact_merge(&mine->normal, &other->normal);
    clod_exact_merge(&mine->sliding, &other->sliding);
    clod_exact_merge(&mine->turning, &other->turning);
}

void clod_spread_merge_stored(const clod_spread *self, clod_step_stored *sums)
{
    if (self != NULL) {
        clod_ranks_merge(self->ranks, sums, sizeof *sums, merge_stored, NULL);
    }
}
