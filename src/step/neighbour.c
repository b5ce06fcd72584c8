#include "step/neighbour.h"

#include <math.h>

#include "base/memory.h"
#include "step/cells.h"

/** Wide skin as a fraction of the largest radius: few candidates against rare rebuilds. */
#define SKIN_FRACTION 0.3
/** Room to begin with for candidates, per grain: twice what a dense bed of one size has. */
#define LIKELY_PAIRS 10

void clod_neighbour_init(clod_neighbour *self, const clod_state *state, bool brute_force)
{
    *self = (clod_neighbour){.brute_force = brute_force, .radius_min = INFINITY};
    for (size_t g = 0; g < state->grains.count; g++) {
        const double radius = state->grains.place[g][3];
        self->radius_min = fmin(self->radius_min, radius);
        self->radius_max = fmax(self->radius_max, radius);
    }
    self->skin = SKIN_FRACTION * self->radius_max;
}

/** Room for a number of candidates, or none: then they are asked for as they come. */
static void reserve_pairs(clod_candidates *self, size_t count)
{
    self->item = clod_memory_alloc(count, sizeof *self->item);
    self->capacity = self->item != NULL ? count : 0;
}

clod_candidate *clod_neighbour_add(clod_candidates *self)
{
    if (self->count == self->capacity) {
        const size_t capacity = self->capacity + self->capacity / 2 + 1024;
        void *item = clod_memory_grow(self->item, self->capacity, capacity, sizeof *self->item);
        if (item == NULL) {
            return NULL;
        }
        self->item = item;
        self->capacity = capacity;
    }
    return &self->item[self->count++];
}

/** Grains and shapes of walls that are within the skin, walls as they were at the rebuild. */
static bool find_walls(clod_neighbour *self, const clod_state *state, const clod_laws *laws)
{
    self->walls.count = 0;
    const clod_grains *grains = &state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        const double *p = state->build_place[g];
        for (int32_t w = 0; w < state->walls.count; w++) {
            const clod_wall *wall = &state->walls.wall[w];
            for (int32_t s = 0; s < wall->shape_count; s++) {
                if (clod_wall_rows_gap(&self->build_rows, w, s, p).distance >=
                    p[3] + self->skin) {
                    continue;
                }
                clod_candidate *c = clod_neighbour_add(&self->walls);
                if (c == NULL) {
                    return false;
                }
                const int32_t law = clod_laws_index(laws, grains->material[g], wall->material);
                *c = (clod_candidate){(int32_t)g, w, -1, (int16_t)s, (uint32_t)law & 0x7fff, 0};
            }
        }
    }
    return true;
}

static bool walls_at_rebuild(clod_neighbour *self, const clod_state *state)
{
    if (self->build_rows.shape == NULL &&
        !clod_wall_rows_init(&self->build_rows, &state->walls)) {
        return false;
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        clod_wall then = state->walls.wall[w];
        const double *at = &state->build_walls[4 * (size_t)w];
        then.shift = (clod_vec3){at[0], at[1], at[2]};
        then.angle = at[3];
        clod_wall_rows_place(&self->build_rows, w, &then);
    }
    return true;
}

/** -1, 0, 1 as candidate `c` stands before, at, after contact `k`. */
static int compare(const clod_candidate *c, const clod_contact *k)
{
    if (c->i != k->i) {
        return c->i < k->i ? -1 : 1;
    }
    if (c->j != k->j) {
        return c->j < k->j ? -1 : 1;
    }
    return (c->shape > k->shape) - (c->shape < k->shape);
}

/** Both lists ascend: one walk tells each candidate its contact; the first one left, or end. */
static size_t attach(clod_candidates *self, const clod_contact *contacts, size_t begin,
                     size_t end)
{
    size_t k = begin;
    for (size_t c = 0; c < self->count && k < end; c++) {
        if (compare(&self->item[c], &contacts[k]) == 0) {
            self->item[c].lane = (int32_t)k++;
        }
    }
    return k;
}

bool clod_neighbour_build(clod_neighbour *self, const clod_state *state, const clod_laws *laws,
                          clod_status *status)
{
    self->pairs.count = 0;
    if (self->pairs.capacity == 0) { // memory that is never used costs nothing (base/memory.c)
        reserve_pairs(&self->pairs, LIKELY_PAIRS * state->grains.count);
    }
    if (!walls_at_rebuild(self, state) || !find_walls(self, state, laws) ||
        !(self->brute_force ? clod_cells_all_pairs(self, state, laws)
                            : clod_cells_find_pairs(self, state, laws))) {
        return clod_status_fail(status, CLOD_FAILED,
                                "no memory for the contact candidates of %zu grains",
                                state->grains.count);
    }
    const size_t pairs = state->contact_count - state->wall_contact_count;
    size_t left = attach(&self->pairs, state->contacts, 0, pairs);
    if (left == pairs) {
        left = attach(&self->walls, state->contacts, pairs, state->contact_count);
    }
    if (left < state->contact_count) {
        const uint64_t grain = state->grains.id[state->contacts[left].i];
        return clod_status_fail(status, CLOD_FAILED,
                                "step %lld: grain %llu is far away from a grain or wall that "
                                "it touched one step before; the time step (%g s) is most "
                                "likely too large, see clod check",
                                (long long)state->step, (unsigned long long)grain, state->dt);
    }
    return true;
}

void clod_neighbour_fini(clod_neighbour *self)
{
    clod_memory_free(self->pairs.item);
    clod_memory_free(self->walls.item);
    clod_wall_rows_fini(&self->build_rows);
    clod_memory_free(self->cell_of);
    clod_memory_free(self->cell_item);
    clod_memory_free(self->cell_start);
    clod_memory_free(self->sort);
    clod_memory_free(self->sort_scratch);
    clod_memory_free(self->rank);
    *self = (clod_neighbour){0};
}
