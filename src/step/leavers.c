#include "step/leavers.h"

#include <math.h>

#include "step/neighbour.h"

int clod_leavers_face(const clod_domain *domain, const double *position)
{
    for (int a = 0; a < 3; a++) {
        if (!domain->periodic[a] && position[a] < domain->min[a]) {
            return 2 * a;
        }
        if (!domain->periodic[a] && position[a] > domain->max[a]) {
            return 2 * a + 1;
        }
    }
    return -1;
}

static double kinetic(const double *velocity, double mass, const double *angular_velocity)
{
    const double v2 =
        velocity[0] * velocity[0] + velocity[1] * velocity[1] + velocity[2] * velocity[2];
    const double w2 = angular_velocity[0] * angular_velocity[0] +
                      angular_velocity[1] * angular_velocity[1] +
                      angular_velocity[2] * angular_velocity[2];
    return 0.5 * mass * v2 + 0.5 / angular_velocity[3] * w2;
}

/** How long it was in: a grain that was there at the start came at no time. */
static void add_residence(clod_leavers *sums, const clod_state *state, size_t row)
{
    const clod_exchange *exchange = &state->exchange;
    const double now = (double)state->step * state->dt;
    const double time = now - state->grains.birth[row];
    if (state->grains.birth[row] == 0.0 || now < exchange->residence_since) {
        return;
    }
    clod_exact_add(&sums->time, time);
    clod_exact_add(&sums->time_squared, time * time);
    sums->residence_least = sums->timed > 0 ? fmin(time, sums->residence_least) : time;
    sums->residence_most = fmax(time, sums->residence_most);
    sums->residence_count[clod_time_class(time)]++;
    sums->timed++;
}

/** For whoever wants grains that left one by one. */
static void note_grain(clod_state *state, size_t row, int exit)
{
    const clod_grains *grains = &state->grains;
    const clod_gone_grain gone = {.id = grains->id[row],
                                  .radius = grains->position[row][3],
                                  .mass = grains->velocity[row][3],
                                  .birth = grains->birth[row],
                                  .left = (double)state->step * state->dt,
                                  .material = grains->material[row],
                                  .exit = exit};
    clod_gone_add(&state->gone, &gone);
}

/** In what clump it was when somebody last looked. */
static void add_clump(clod_leavers *sums, const clod_state *state, size_t row)
{
    if (state->grains.clump != NULL) {
        const clod_grain_clump *clump = &state->grains.clump[row];
        sums->left_clumps[clump->since >= 0.0 ? 1 + clod_clump_class(clump->seen) : 0]++;
    }
}

static void add_leaver(clod_leavers *sums, const clod_state *state, size_t row, int face,
                       double half_kick)
{
    const double *v = state->grains.velocity[row];
    const double *w = state->grains.angular_velocity[row];
    double whole[3];
    for (int a = 0; a < 3; a++) {
        whole[a] = v[a] + half_kick * state->gravity[a];
    }
    const double energy = kinetic(whole, v[3], w);
    clod_exact_add(&sums->mass[face], v[3]);
    clod_exact_add(&sums->energy[face], energy);
    clod_exact_add(&sums->kick, energy - kinetic(v, v[3], w));
}

int clod_leavers_exit(const clod_leavers_outlets *outlets, const clod_domain *domain,
                      const double *position)
{
    const int face = domain->removes ? clod_leavers_face(domain, position) : -1;
    if (face >= 0) {
        return face;
    }
    const int region = clod_domain_outlet(domain, position);
    const int outlet =
        region >= 0 ? region
                    : clod_outlet_shapes_touched(outlets->shapes, outlets->rows, position);
    return outlet >= 0 ? CLOD_FACES + outlet : -1;
}

size_t clod_leavers_mark(clod_leavers *sums, clod_state *state,
                         const clod_leavers_outlets *outlets, double half_kick, int32_t *rank)
{
    size_t leavers = 0;
    for (size_t g = 0; g < state->grains.count; g++) {
        const int face = clod_leavers_exit(outlets, &state->domain, state->grains.position[g]);
        if (face >= 0 && rank[g] != CLOD_NEIGHBOUR_GOES) {
            rank[g] = CLOD_NEIGHBOUR_GOES;
            sums->left[face]++;
            add_leaver(sums, state, g, face, half_kick);
            add_residence(sums, state, g);
            add_clump(sums, state, g);
            note_grain(state, g, face);
            leavers++;
        }
    }
    sums->grains += (int64_t)leavers;
    return leavers;
}

void clod_leavers_merge(clod_leavers *self, const clod_leavers *other)
{
    self->grains += other->grains;
    for (int f = 0; f < CLOD_EXITS; f++) {
        self->left[f] += other->left[f];
        clod_exact_merge(&self->mass[f], &other->mass[f]);
        clod_exact_merge(&self->energy[f], &other->energy[f]);
    }
    clod_exact_merge(&self->kick, &other->kick);
    clod_exact_merge(&self->time, &other->time);
    clod_exact_merge(&self->time_squared, &other->time_squared);
    if (other->timed > 0) {
        const double least = other->residence_least;
        self->residence_least = self->timed > 0 ? fmin(self->residence_least, least) : least;
        self->residence_most = fmax(self->residence_most, other->residence_most);
    }
    self->timed += other->timed;
    for (int k = 0; k < CLOD_TIME_CLASSES; k++) {
        self->residence_count[k] += other->residence_count[k];
    }
    for (int k = 0; k < 1 + CLOD_CLUMP_CLASSES; k++) {
        self->left_clumps[k] += other->left_clumps[k];
    }
}

void clod_leavers_book(const clod_leavers *self, clod_state *state)
{
    clod_exchange *exchange = &state->exchange;
    for (int f = 0; f < CLOD_EXITS; f++) {
        exchange->left[f] += self->left[f];
        exchange->left_mass[f] += clod_exact_value(&self->mass[f]);
        exchange->left_energy[f] += clod_exact_value(&self->energy[f]);
    }
    exchange->residence += clod_exact_value(&self->time);
    exchange->residence_squared += clod_exact_value(&self->time_squared);
    if (self->timed > 0) {
        const bool first = exchange->residence_most == 0.0;
        const double least = self->residence_least;
        exchange->residence_least = first ? least : fmin(least, exchange->residence_least);
        exchange->residence_most = fmax(self->residence_most, exchange->residence_most);
    }
    for (int k = 0; k < CLOD_TIME_CLASSES; k++) {
        exchange->residence_count[k] += self->residence_count[k];
    }
    for (int k = 0; k < 1 + CLOD_CLUMP_CLASSES; k++) {
        exchange->left_clumps[k] += self->left_clumps[k];
    }
    if (state->ledger.open != 0) {
        state->ledger.exchanged -= clod_exact_value(&self->kick);
    }
}
