#include "step/neighbour.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"
#include "parallel/threads.h"
#include "state/limits.h"
#include "step/cells.h"
#include "step/layers.h"
#include "step/separated.h"
#include "step/wall_cells.h"

/** Wide skin as a fraction of the largest radius, at least: few candidates in slow beds. */
#define SKIN_FRACTION 0.3
/** And at most: rebuilds of fast streams become no cheaper beyond. */
#define SKIN_MOST 1.0
/** Cost of a rebuild over that of carrying a skin of one radius for a step. */
#define SKIN_COST 60.0
/** Room to begin with for candidates, per grain: twice what a dense bed of one size has. */
#define LIKELY_PAIRS 10

void clod_neighbour_init(clod_neighbour *self, const clod_state *state, bool brute_force)
{
    *self = (clod_neighbour){.brute_force = brute_force, .kernel = clod_kernel_choose(NULL)};
    clod_neighbour_size(self, state);
    clod_neighbour_choose_skin(self, state, 0.0);
}

void clod_neighbour_size(clod_neighbour *self, const clod_state *state)
{
    self->radius_min = INFINITY;
    self->radius_max = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        const double radius = state->grains.position[g][3];
        self->radius_min = fmin(self->radius_min, radius);
        self->radius_max = fmax(self->radius_max, radius);
    }
}

void clod_neighbour_choose_skin(clod_neighbour *self, const clod_state *state, double speed)
{
    const double closing = 2.0 * speed * state->dt;
    double most = SKIN_MOST * self->radius_max;
    for (int a = 0; a < 3; a++) {
        if (state->domain.periodic[a]) { // see clod_neighbour_periods_fit
            const double period = state->domain.max[a] - state->domain.min[a];
            most = fmin(most, 0.5 * period - 2.0 * self->radius_max);
        }
    }
    self->skin = fmax(SKIN_FRACTION * self->radius_max,
                      fmin(most, sqrt(SKIN_COST * closing * self->radius_max)));
    if (clod_walls_remove(&state->walls)) { // no grain may pass a surface between two rebuilds
        self->skin = fmin(self->skin, 2.0 * self->radius_min);
    }
}

bool clod_neighbour_periods_fit(const clod_domain *domain, double radius_max,
                                clod_status *status)
{
    const double least = (4.0 + 2.0 * SKIN_FRACTION) * radius_max;
    for (int a = 0; a < 3; a++) {
        const double period = domain->max[a] - domain->min[a];
        if (domain->periodic[a] && !(period > least)) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "domain: the period along %c is %g m, but a grain would meet its own "
                "neighbours twice; at least %g m is needed for these grains",
                "xyz"[a], period, least);
        }
    }
    return true;
}

/** Room for a number of pairs, or none: then it is asked for as they come. */
static void reserve_pairs(clod_pairs *self, size_t count)
{
    self->item = clod_memory_alloc(count, sizeof *self->item);
    self->capacity = self->item != NULL ? count : 0;
}

bool clod_neighbour_grow(clod_pairs *self)
{
    return !self->fixed &&
           clod_room_for_one(&self->item, &self->capacity, self->count, sizeof *self->item);
}

static bool walls_at_rebuild(clod_neighbour *self, const clod_state *state)
{
    if (self->build_rows.shape == NULL &&
        !clod_wall_rows_init(&self->build_rows, &state->walls)) {
        return false;
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        clod_wall then = state->walls.wall[w];
        clod_wall_pose_set(&then, state->build_walls[w]);
        clod_wall_rows_place(&self->build_rows, w, &then);
    }
    return true;
}

/** A layer of the largest grains, and something for what is uneven. */
static size_t lead_of(const clod_neighbour *self, const clod_state *state)
{
    const double(*position)[4] = clod_neighbour_places(self, state);
    const clod_layers layers = clod_layers_of(position, state->grains.count);
    const size_t fullest = clod_layers_fullest(&layers, position, state->grains.count);
    const double reach = 2.0 * self->radius_max / (self->radius_min + self->radius_max);
    return (size_t)((reach + 0.0625) * (double)fullest) + 64;
}

bool clod_neighbour_fail_to_add(const clod_neighbour *self, size_t grains, clod_status *status)
{
    return clod_limits_pairs(self->pairs.count + 1, status) &&
           clod_limits_wall_pairs(self->walls.count + 1, status) &&
           clod_status_fail(status, CLOD_FAILED,
                            "no memory for the contact candidates of %zu grains", grains);
}

/** Room for what so many parts find; what is there stays. */
static bool reserve_found(clod_neighbour *self, size_t parts)
{
    if (parts > self->found_capacity) {
        clod_neighbour_found *grown =
            clod_memory_grow(self->found, self->found_capacity, parts, sizeof *self->found);
        if (grown == NULL) {
            return false;
        }
        for (size_t p = self->found_capacity; p < parts; p++) {
            grown[p] = (clod_neighbour_found){0};
        }
        self->found = grown;
        self->found_capacity = parts;
    }
    return true;
}

bool clod_neighbour_build_begin(clod_neighbour *self, const clod_state *state, int parts,
                                clod_status *status)
{
    const size_t grains = state->grains.count;
    self->pairs.count = 0;
    self->parts = parts;
    self->lead = lead_of(self, state);
    if (self->pairs.capacity <
        LIKELY_PAIRS * grains) { // unused memory costs nothing (memory.c)
        clod_memory_free(self->pairs.item);
        reserve_pairs(&self->pairs, LIKELY_PAIRS * grains);
    }
    bool good = walls_at_rebuild(self, state) && reserve_found(self, (size_t)parts);
    if (!self->brute_force && grains > 0) {
        self->grid = clod_cells_grid_of(self, state);
        good = good && clod_wall_cells_fill(self, state) && clod_cells_begin(self, grains);
    }
    return good || clod_neighbour_fail_to_add(self, grains, status);
}

static clod_chunk grains_of(const clod_neighbour *self, const clod_state *state, int part)
{
    return clod_threads_chunk(state->grains.count, part, self->parts);
}

void clod_neighbour_build_count(clod_neighbour *self, const clod_state *state, int part)
{
    if (!self->brute_force) {
        clod_cells_count(self, state, grains_of(self, state, part), self->parts > 1);
    }
}

void clod_neighbour_build_add(clod_neighbour *self, const clod_state *state)
{
    if (!self->brute_force && state->grains.count > 0) {
        clod_cells_add(self);
    }
}

void clod_neighbour_build_enter(clod_neighbour *self, const clod_state *state, int part)
{
    if (!self->brute_force) {
        clod_cells_enter(self, state, grains_of(self, state, part), self->parts > 1);
    }
}

void clod_neighbour_build_part(clod_neighbour *self, const clod_state *state,
                               const clod_laws *laws, int part)
{
    const clod_chunk grains = grains_of(self, state, part);
    clod_neighbour_found *found = &self->found[part];
    found->walls.count = found->walls.facets = 0;
    found->walls_fit = self->brute_force
                           ? clod_wall_cells_find_all(self, state, laws, grains, &found->walls)
                           : clod_wall_cells_find(self, state, laws, grains, &found->walls);
    if (self->brute_force || self->parts == 1) { // pairs with room to grow, in the end
        return;
    }
    const clod_chunk room = clod_threads_chunk(self->pairs.capacity, part, self->parts);
    clod_pairs *pairs = &found->pairs;
    *pairs = (clod_pairs){.start = self->pairs.start,
                          .item = self->pairs.item + room.begin,
                          .capacity = room.end - room.begin,
                          .fixed = true};
    if (!clod_cells_find_pairs(self, state, grains.begin, grains.end, pairs)) {
        pairs->item = NULL; // too little room
    } else if (found->walls_fit) {
        found->separated = clod_separated_first(pairs, &found->walls, state, grains);
    }
}

/** The pairs that the parts have found, one behind the other; false when a part had too little
 *  room. */
static bool join_pairs(clod_neighbour *self, const clod_state *state)
{
    clod_pairs *pairs = &self->pairs;
    bool all = self->parts > 1;
    for (int p = 0; all && p < self->parts; p++) {
        all = self->found[p].pairs.item != NULL;
    }
    pairs->count = 0;
    for (int p = 0; all && p < self->parts; p++) {
        const clod_pairs *found = &self->found[p].pairs;
        const clod_chunk grains = grains_of(self, state, p);
        for (size_t i = grains.begin; i < grains.end; i++) {
            pairs->start[i] += (uint32_t)pairs->count;
        }
        memmove(pairs->item + pairs->count, found->item, found->count * sizeof *found->item);
        pairs->count += found->count;
    }
    pairs->start[state->grains.count] = (uint32_t)pairs->count;
    const size_t size = sizeof *pairs->item;
    if (all) { // the parts' room was wider than what is left
        clod_memory_give_back(pairs->item + pairs->count,
                              (pairs->capacity - pairs->count) * size, pairs->capacity * size);
    }
    return all;
}

/** Put what a part has found behind what is there; there is room. */
static void append_walls(clod_wall_candidates *walls, const clod_wall_candidates *found)
{
    for (size_t k = 0; k < found->count; k++) {
        walls->item[walls->count] = found->item[k];
        walls->item[walls->count++].facet += walls->facets;
    }
    if (found->facets > 0) {
        memcpy(walls->facet + walls->facets, found->facet,
               found->facets * sizeof *found->facet);
    }
    walls->facets += found->facets;
}

/** The candidates with walls that the parts have found; false without memory, or too many. */
static bool join_walls(clod_neighbour *self)
{
    clod_wall_candidates *walls = &self->walls;
    size_t count = 0, facets = 0;
    bool fit = true;
    for (int p = 0; p < self->parts; p++) {
        count += self->found[p].walls.count;
        facets += self->found[p].walls.facets;
        fit = fit && self->found[p].walls_fit;
    }
    walls->count = count < CLOD_LIMITS_WALL_PAIRS ? count : CLOD_LIMITS_WALL_PAIRS;
    if (!fit || count > CLOD_LIMITS_WALL_PAIRS) {
        return false;
    }
    if (self->parts == 1) { // the arrays change places
        const clod_wall_candidates old = *walls;
        *walls = self->found[0].walls;
        self->found[0].walls = old;
        return true;
    }
    if (!clod_room_for(&walls->item, &walls->capacity, count, sizeof *walls->item) ||
        !clod_room_for(&walls->facet, &walls->facet_capacity, facets, sizeof *walls->facet)) {
        return false;
    }
    walls->count = walls->facets = 0;
    for (int p = 0; p < self->parts; p++) {
        append_walls(walls, &self->found[p].walls);
    }
    return true;
}

/** All pairs there are, in ascending order, found by one thread; false without memory. */
static bool find_all_pairs(clod_neighbour *self, const clod_state *state)
{
    if (self->brute_force) {
        return clod_cells_all_pairs(self, state);
    }
    if (!clod_cells_find_pairs(self, state, 0, state->grains.count, &self->pairs)) {
        return false;
    }
    self->pairs.start[state->grains.count] = (uint32_t)self->pairs.count;
    return true;
}

bool clod_neighbour_fail_separated(const clod_state *state, uint64_t id, clod_status *status)
{
    const bool *periodic = state->domain.periodic;
    return clod_status_fail(status, CLOD_FAILED,
                            "step %lld: grain %llu is far away from a grain or wall that "
                            "it touched one step before; the time step (%g s) is most "
                            "likely too large, see clod check%s",
                            (long long)state->step, (unsigned long long)id, state->dt,
                            periodic[0] || periodic[1] || periodic[2]
                                ? "; or the grain crossed a periodic side within its radius of "
                                  "where a wall ends: walls do not repeat, so let them end "
                                  "farther from the side, or go on beyond both sides"
                                : "");
}

bool clod_neighbour_build_end(clod_neighbour *self, const clod_state *state,
                              clod_status *status)
{
    const bool joined = !self->brute_force && join_pairs(self, state);
    if (!join_walls(self) || (!joined && !find_all_pairs(self, state))) {
        return clod_neighbour_fail_to_add(self, state->grains.count, status);
    }
    const clod_chunk all = {0, state->grains.count};
    size_t left = state->contact_count;
    if (!joined) {
        left = clod_separated_first(&self->pairs, &self->walls, state, all);
    }
    for (int p = 0; joined && p < self->parts; p++) {
        left = self->found[p].separated < left ? self->found[p].separated : left;
    }
    if (left < state->contact_count) {
        return clod_neighbour_fail_separated(state, state->grains.id[state->contacts[left].i],
                                             status);
    }
    clod_neighbour_give_back(self);
    return true;
}

bool clod_neighbour_build(clod_neighbour *self, const clod_state *state, const clod_laws *laws,
                          clod_status *status)
{
    if (!clod_neighbour_build_begin(self, state, 1, status)) {
        return false;
    }
    clod_neighbour_build_count(self, state, 0);
    clod_neighbour_build_add(self, state);
    clod_neighbour_build_enter(self, state, 0);
    clod_neighbour_build_part(self, state, laws, 0);
    return clod_neighbour_build_end(self, state, status);
}

void clod_neighbour_give_ranks_back(clod_neighbour *self)
{
    const size_t grains = self->grain_capacity * sizeof *self->rank;
    clod_memory_give_back(self->cell_of, grains, grains);
    clod_memory_give_back(self->cell_item, grains, grains);
    clod_memory_give_back(self->rank, grains, grains);
}

void clod_neighbour_give_back(clod_neighbour *self)
{
    const size_t sort = self->sort_capacity * sizeof *self->sort;
    const size_t cells = self->cell_capacity * sizeof *self->cell_start;
    clod_memory_give_back(self->sort, sort, sort);
    clod_memory_give_back(self->sort_scratch, sort, sort);
    clod_neighbour_give_ranks_back(self);
    const size_t places = self->place_capacity * sizeof *self->cell_place;
    clod_memory_give_back(self->cell_place, places, places);
    clod_memory_give_back(self->cell_start, cells, cells);
    clod_memory_give_back(self->cell_last, cells, cells);
}

static void free_walls(clod_wall_candidates *walls)
{
    clod_memory_free(walls->item);
    clod_memory_free(walls->facet);
    clod_memory_free(walls->found);
}

void clod_neighbour_fini(clod_neighbour *self)
{
    clod_memory_free(self->pairs.start);
    clod_memory_free(self->pairs.item);
    for (size_t p = 0; p < self->found_capacity; p++) {
        free_walls(&self->found[p].walls);
    }
    clod_memory_free(self->found);
    free_walls(&self->walls);
    clod_wall_rows_fini(&self->build_rows);
    clod_wall_cells_fini(&self->wall_cells);
    clod_memory_free(self->cell_of);
    clod_memory_free(self->cell_item);
    clod_memory_free(self->cell_start);
    clod_memory_free(self->cell_last);
    clod_memory_free(self->cell_place);
    clod_memory_free(self->sort);
    clod_memory_free(self->sort_scratch);
    clod_memory_free(self->rank);
    clod_memory_free(self->order_part);
    clod_memory_free(self->sort_part);
    *self = (clod_neighbour){0};
}
