#include "step/change.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "state/alter.h"
#include "state/ids.h"
#include "step/equip.h"
#include "step/trouble.h"

#define GOES (-1) ///< rank of a grain that goes

double clod_change_balance(clod_step *self)
{
    if (self->state->ledger.open == 0) {
        return 0.0;
    }
    const clod_energies now = clod_step_energies(self);
    return clod_energies_sum(&now);
}

// ---- grains that cross an open side

/** The open side that a position is beyond, or -1. */
static int face_beyond(const clod_domain *domain, const double *position)
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

/**
 * Count one grain that leaves in the middle of a step: half a kick before the end, of which the
 * weight is known. The ledger is told what that half kick would have brought.
 */
static void count_leaver(clod_state *state, size_t row, int face)
{
    const double *v = state->grains.velocity[row];
    const double *w = state->grains.angular_velocity[row];
    double whole[3];
    for (int a = 0; a < 3; a++) {
        whole[a] = v[a] + 0.5 * state->dt * state->gravity[a];
    }
    const double energy = kinetic(whole, v[3], w);
    state->exchange.left[face]++;
    state->exchange.left_mass[face] += v[3];
    state->exchange.left_energy[face] += energy;
    if (state->ledger.open != 0) {
        state->ledger.exchanged -= energy - kinetic(v, v[3], w);
    }
}

size_t clod_change_find_leavers(clod_step *self)
{
    clod_state *state = self->state;
    int32_t *rank = self->neighbour.rank;
    size_t leavers = 0;
    int32_t next = 0;
    for (size_t g = 0; state->domain.removes && g < state->grains.count; g++) {
        const int face = face_beyond(&state->domain, state->grains.position[g]);
        rank[g] = face < 0 ? next++ : GOES;
        if (face >= 0) {
            count_leaver(state, g, face);
            leavers++;
        }
    }
    return leavers;
}

// ---- the queue

static int32_t wall_of(const clod_state *state, const char *name)
{
    for (int32_t w = 0; w < state->walls.count; w++) {
        if (strcmp(state->walls.wall[w].name, name) == 0) {
            return w;
        }
    }
    return -1;
}

static int by_id(const void *a, const void *b)
{
    const uint64_t x = ((const clod_new_grain *)a)->id, y = ((const clod_new_grain *)b)->id;
    return (x > y) - (x < y);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const clod_wall *)a)->name, ((const clod_wall *)b)->name);
}

/** What comes, by id and by name: the order of requests changes no bit. */
static void sort_requests(clod_changes *changes)
{
    if (changes->new_grains > 1) {
        qsort(changes->new_grain, changes->new_grains, sizeof *changes->new_grain, by_id);
    }
    if (changes->new_walls > 1) {
        qsort(changes->new_wall, changes->new_walls, sizeof *changes->new_wall, by_name);
    }
}

/** Mark the grains that go, each once. */
static bool mark_lost(clod_step *self, const clod_ids *index, clod_status *status)
{
    const clod_changes *changes = &self->state->changes;
    int32_t *rank = self->neighbour.rank;
    memset(rank, 0, self->state->grains.count * sizeof *rank);
    for (size_t k = 0; k < changes->lost_grains; k++) {
        const int64_t row = clod_ids_row(index, changes->lost_grain[k]);
        if (row < 0 || rank[row] == GOES) {
            return clod_status_fail(status, CLOD_USAGE, "grain %llu cannot be removed: %s",
                                    (unsigned long long)changes->lost_grain[k],
                                    row < 0 ? "there is none with this id"
                                            : "it is to be removed twice");
        }
        rank[row] = GOES;
    }
    int32_t next = 0;
    for (size_t g = 0; g < self->state->grains.count; g++) {
        rank[g] = rank[g] == GOES ? GOES : next++;
    }
    return true;
}

static bool number_is_good(const clod_new_grain *g)
{
    bool good = g->position[3] > 0.0 && isfinite(g->position[3]) && g->density > 0.0 &&
                isfinite(g->density);
    for (int a = 0; a < 3; a++) {
        good = good && isfinite(g->position[a]) && isfinite(g->velocity[a]) &&
               isfinite(g->angular[a]);
    }
    return good;
}

/** One grain that is to come: its numbers, its material, its position and its id. */
static bool check_new(const clod_step *self, const clod_ids *index, size_t k,
                      clod_status *status)
{
    const clod_state *state = self->state;
    const clod_new_grain *grain = &state->changes.new_grain[k];
    const unsigned long long id = grain->id;
    if (!number_is_good(grain)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "grain %llu cannot be added: position and velocities must be "
                                "finite, radius (%g m) and density (%g kg/m3) positive",
                                id, grain->position[3], grain->density);
    }
    if (grain->material >= self->laws->materials) {
        return clod_status_fail(status, CLOD_USAGE,
                                "grain %llu cannot be added: material %d is unknown, there are "
                                "%d",
                                id, grain->material, self->laws->materials);
    }
    if (face_beyond(&state->domain, grain->position) >= 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "grain %llu cannot be added: (%g, %g, %g) m is outside of the "
                                "domain",
                                id, grain->position[0], grain->position[1], grain->position[2]);
    }
    const bool twice = k > 0 && state->changes.new_grain[k - 1].id == grain->id; // they ascend
    return (!twice && clod_ids_row(index, grain->id) < 0) ||
           clod_status_fail(status, CLOD_USAGE,
                            "grain %llu cannot be added: another one has this id", id);
}

/** Whether a wall has the name of the queue's new wall `k`, and stays; or one before it. */
static bool name_is_taken(const clod_state *state, size_t k)
{
    const clod_changes *changes = &state->changes;
    const char *name = changes->new_wall[k].name;
    bool taken = wall_of(state, name) >= 0;
    for (size_t w = 0; w < changes->lost_walls; w++) {
        taken = taken && strcmp(changes->lost_wall[w], name) != 0;
    }
    const bool twice = k > 0 && strcmp(changes->new_wall[k - 1].name, name) == 0; // they ascend
    return taken || twice;
}

/** Walls of the queue: what goes is there, what comes is not. */
static bool check_walls(const clod_state *state, clod_status *status)
{
    const clod_changes *changes = &state->changes;
    for (size_t w = 0; w < changes->lost_walls; w++) {
        if (wall_of(state, changes->lost_wall[w]) < 0) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "wall '%s' cannot be removed: there is none of this name",
                                    changes->lost_wall[w]);
        }
    }
    for (size_t w = 0; w < changes->new_walls; w++) {
        if (name_is_taken(state, w)) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "wall '%s' cannot be added: another one has this name",
                                    changes->new_wall[w].name);
        }
    }
    return true;
}

/** Everything that is wrong with the queue is found before anything is changed. */
static bool check(clod_step *self, clod_status *status)
{
    clod_ids index = {0};
    if (self->state->changes.lacks_memory) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a list of changes");
    }
    bool good =
        check_walls(self->state, status) &&
        clod_neighbour_reserve(&self->neighbour, self->state, status) &&
        clod_ids_init(&index, self->state->grains.id, self->state->grains.count, status) &&
        mark_lost(self, &index, status);
    for (size_t k = 0; good && k < self->state->changes.new_grains; k++) {
        good = check_new(self, &index, k, status);
    }
    clod_ids_fini(&index);
    return good;
}

/** Whether a contact of the state touches where its grains and walls are now. */
static bool touches(const clod_step *self, const clod_contact *contact)
{
    const clod_state *state = self->state;
    const double *a = state->grains.position[contact->i];
    if (contact->shape >= 0) {
        return clod_wall_rows_gap(&self->walls, contact->j, contact->shape, a).distance < a[3];
    }
    const double *b = state->grains.position[contact->j];
    double square = 0.0;
    for (int c = 0; c < 3; c++) {
        const double s = clod_domain_separation(&state->domain, c, a[c], b[c]);
        square += s * s;
    }
    return square < (a[3] + b[3]) * (a[3] + b[3]);
}

/** After somebody has moved things: what does not touch any more is forgotten. */
static bool forget_open(clod_step *self, clod_status *status)
{
    clod_state *state = self->state;
    uint8_t *keep = clod_memory_alloc(state->contact_count + 1, sizeof *keep);
    if (keep == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu contacts",
                                state->contact_count);
    }
    clod_wall_rows_update(&self->walls, &state->walls);
    for (size_t k = 0; k < state->contact_count; k++) {
        keep[k] = touches(self, &state->contacts[k]);
    }
    clod_state_drop_contacts(state, keep);
    clod_memory_free(keep);
    return true;
}

/** What goes. */
static void drop(clod_step *self)
{
    clod_state *state = self->state;
    const clod_changes *changes = &state->changes;
    for (size_t g = 0; g < state->grains.count; g++) {
        if (self->neighbour.rank[g] == GOES) {
            state->exchange.removed++;
            state->exchange.removed_mass += state->grains.velocity[g][3];
        }
    }
    if (changes->lost_grains > 0) {
        clod_state_drop_grains(state, self->neighbour.rank);
    }
    for (size_t w = 0; w < changes->lost_walls; w++) {
        const int32_t wall = wall_of(state, changes->lost_wall[w]);
        if (wall >= 0) { // not asked for twice
            clod_state_drop_wall(state, wall);
            state->exchange.walls_removed++;
        }
    }
}

/** What comes: a new grain carries its weight for the first half kick. */
static bool add(clod_step *self, clod_status *status)
{
    clod_state *state = self->state;
    clod_changes *changes = &state->changes;
    for (size_t k = 0; k < changes->new_grains; k++) {
        const clod_new_grain *grain = &changes->new_grain[k];
        if (!clod_grains_add(&state->grains, grain->position, grain->velocity, grain->angular,
                             grain->density, grain->material, grain->id, status)) {
            return false;
        }
        const size_t row = state->grains.count - 1;
        const double mass = state->grains.velocity[row][3];
        for (int a = 0; a < 3; a++) {
            state->grains.load[row][a] = mass * state->gravity[a];
        }
        state->exchange.added++;
        state->exchange.added_mass += mass;
    }
    return changes->new_walls == 0 ||
           clod_state_add_walls(state, changes->new_wall, changes->new_walls, status);
}

/** Lists of what is there now. */
static bool rebuild(clod_step *self, clod_status *status)
{
    clod_state *state = self->state;
    clod_memory_free(state->build_position); // for other numbers of grains and walls
    clod_memory_free(state->build_walls);
    state->build_position = NULL;
    state->build_walls = NULL;
    self->rebuilds++;
    self->thread[0].near_motion = 0.0;
    return clod_step_equip(self, status) && clod_step_build_lists(self, true, status);
}

bool clod_step_change(clod_step *self, clod_status *status)
{
    clod_state *state = self->state;
    if (!clod_changes_any(&state->changes)) {
        return true;
    }
    if (self->failed) {
        *status = self->status;
        return false;
    }
    sort_requests(&state->changes);
    bool good = check(self, status);
    if (good) {
        const double before = clod_change_balance(self);
        good = clod_near_gather(&self->near, state, &self->walls, true, status);
        if (good) {
            good = !state->changes.moved || forget_open(self, status);
        }
        if (good) {
            drop(self);
            good = add(self, status) && rebuild(self, status);
        }
        if (good) {
            state->ledger.exchanged += clod_change_balance(self) - before;
        } else { // the lists are gone
            self->failed = true;
            self->status = *status;
        }
    }
    const bool moved =
        !good && state->changes.moved; // still true when the requests are dropped
    clod_changes_fini(&state->changes);
    state->changes.moved = moved;
    return good;
}
