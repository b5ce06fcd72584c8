// Stage ghosts: what ranks tell each other in a step. A rank alone has nothing to tell.
#include <math.h>
#include <string.h>

#include "step/spread.h"
#include "step/trouble.h"

#define VECTOR CLOD_SPREAD_VECTOR

/** Rows of other ranks' ghosts into the messages, without radius, mass and inertia, which a ghost has. */
static void pack(const clod_spread *self, const clod_grains *grains, size_t numbers)
{
    const clod_ghosts *ghosts = &self->ghosts;
    const size_t bytes = VECTOR * sizeof(double);
    for (size_t k = 0; k < ghosts->out_start[self->ranks->size]; k++) {
        const size_t g = (size_t)ghosts->out[k];
        double *to = ghosts->sent + k * numbers;
        memcpy(to, grains->position[g], bytes);
        memcpy(to + VECTOR, grains->velocity[g], bytes);
        memcpy(to + 2 * VECTOR, grains->angular_velocity[g], bytes);
        if (grains->before != NULL) {
            memcpy(to + 3 * VECTOR, grains->before[g], sizeof *grains->before);
        }
    }
}

/** Own ghosts from the messages; what steps add to their loads nobody reads. */
static void unpack(const clod_spread *self, clod_grains *grains, size_t numbers)
{
    const clod_ghosts *ghosts = &self->ghosts;
    const size_t bytes = VECTOR * sizeof(double);
    for (size_t k = 0; k < ghosts->in_start[self->ranks->size]; k++) {
        const size_t g = (size_t)ghosts->in[k];
        const double *from = ghosts->got + k * numbers;
        memcpy(grains->position[g], from, bytes);
        memcpy(grains->velocity[g], from + VECTOR, bytes);
        memcpy(grains->angular_velocity[g], from + 2 * VECTOR, bytes);
        if (grains->before != NULL) {
            memcpy(grains->before[g], from + 3 * VECTOR, sizeof *grains->before);
        }
    }
}

void clod_spread_refresh(const clod_spread *self, clod_state *state)
{
    const size_t numbers = clod_spread_numbers(state);
    pack(self, &state->grains, numbers);
    clod_ranks_start(self->ranks);
    clod_ranks_finish(self->ranks);
    unpack(self, &state->grains, numbers);
}

/** What the contacts of a thread dissipated, onto those of another. */
static void merge_dissipated(clod_step_heat *into, const clod_step_heat *from)
{
    clod_exact_merge(&into->plastic, &from->plastic);
    clod_exact_merge(&into->dash_pot, &from->dash_pot);
    clod_exact_merge(&into->friction, &from->friction);
    clod_exact_merge(&into->rolling, &from->rolling);
    clod_exact_merge(&into->lag, &from->lag);
}

/** Forces of all parts on a wall, whose sums begin anew. */
static void sum_wall(clod_step *self, clod_fixed *wall_sum, int32_t w)
{
    *wall_sum = (clod_fixed){0};
    for (int32_t s = self->near.sum_start[w]; s < self->near.sum_start[w + 1]; s++) {
        clod_fixed_merge(wall_sum, &self->near.wall_sum[s]);
        self->near.wall_sum[s] = (clod_fixed){0};
    }
}

static void merge_sums(const void *context, void *into, const void *from)
{
    const clod_step *self = context;
    clod_fixed *wall_sum = into;
    const clod_fixed *other = from;
    for (int32_t w = 0; w < self->spread->walls; w++) {
        clod_fixed_merge(&wall_sum[w], &other[w]);
    }
    clod_spread_sums *sums = (clod_spread_sums *)(wall_sum + self->spread->walls);
    const clod_spread_sums *others = (const clod_spread_sums *)(other + self->spread->walls);
    sums->max_speed2 = fmax(sums->max_speed2, others->max_speed2);
    sums->finite &= others->finite;
    sums->excess |= others->excess;
    sums->used_up |= others->used_up;
    if (self->near.ledger) {
        merge_dissipated(&sums->dissipated, &others->dissipated);
    }
}

/** What all ranks have to say: of the drift of this step, and of the end of the one before. No other
 *  thread is in a stage. */
static void merge(clod_step *self)
{
    const clod_spread *spread = self->spread;
    clod_spread_sums *sums = (clod_spread_sums *)(spread->wall_sum + spread->walls);
    for (int32_t w = 0; w < spread->walls; w++) {
        sum_wall(self, &spread->wall_sum[w], w);
    }
    *sums = (clod_spread_sums){.finite = 1};
    for (int t = 0; t < self->threads; t++) {
        clod_step_thread *thread = &self->thread[t];
        sums->max_speed2 = fmax(sums->max_speed2, thread->max_speed2);
        sums->finite &= thread->finite;
        sums->excess |= thread->excess && spread->sums_due;
        sums->used_up |= thread->used_up;
        if (self->near.ledger) {
            merge_dissipated(&sums->dissipated, &thread->dissipated);
            thread->dissipated = (clod_step_heat){0};
        }
    }
    const size_t wall_sum = (size_t)spread->walls * sizeof *spread->wall_sum;
    const size_t bytes =
        wall_sum + (self->near.ledger ? sizeof *sums : offsetof(clod_spread_sums, dissipated));
    clod_ranks_merge(spread->ranks, spread->wall_sum, bytes, merge_sums, self);
    self->thread[0].max_speed2 = sums->max_speed2;
    self->thread[0].finite = sums->finite != 0;
    self->thread[0].used_up = sums->used_up != 0;
    self->thread[0].dissipated = sums->dissipated;
    for (int t = 0; t < self->threads && sums->excess != 0; t++) {
        self->thread[t].late = true;
    }
}

/** The end of the step before: every rank by itself, from the same numbers. */
static void end_walls(clod_step *self)
{
    if (self->spread->sums_due) {
        clod_step_push_walls(self);
        clod_step_add_ledger(self);
        self->spread->sums_due = false;
    }
}

/** The one meeting of a step: while rows of ghosts are on their way, what all must know. */
void clod_step_ghosts(clod_step *self, int part)
{
    const clod_spread *spread = self->spread;
    if (spread == NULL || part != 0) {
        return;
    }
    const size_t numbers = clod_spread_numbers(self->state);
    pack(spread, &self->state->grains, numbers);
    clod_ranks_start(spread->ranks);
    merge(self);
    clod_ranks_finish(spread->ranks);
    unpack(spread, &self->state->grains, numbers);
    end_walls(self);
    clod_step_move_walls(self);
}

void clod_spread_settle(clod_step *self)
{
    if (self->spread->sums_due) {
        merge(self);
        end_walls(self);
    }
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

static void merge_trouble(const void *context, void *into, const void *from)
{
    (void)context;
    clod_step_trouble *mine = into;
    const clod_step_trouble *other = from;
    if (clod_trouble_comes_first(other, mine)) {
        *mine = *other;
    }
}

void clod_spread_merge_trouble(clod_step *self)
{
    clod_ranks_merge(self->spread->ranks, &self->trouble, sizeof self->trouble, merge_trouble,
                     NULL);
}
