// Grains and contacts into the one total order (layer_order.h). Sums run in this order.
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "step/layer_order.h"

/** Places of contacts that one item of the scratch for sorting has room for. */
#define PLACES_PER_ITEM (sizeof(clod_sort_item) / sizeof(int32_t))

/** Room for at least `items` items in sort and sort_scratch. */
static bool reserve_sort(clod_neighbour *self, size_t items)
{
    if (items > self->sort_capacity) {
        clod_memory_free(self->sort);
        clod_memory_free(self->sort_scratch);
        self->sort_capacity = items + items / 4;
        self->sort = clod_memory_alloc(self->sort_capacity, sizeof *self->sort);
        self->sort_scratch = clod_memory_alloc(self->sort_capacity, sizeof *self->sort);
    }
    return items == 0 || (self->sort != NULL && self->sort_scratch != NULL);
}

static bool reserve(clod_neighbour *self, const clod_state *state)
{
    const size_t grains = state->grains.capacity;
    const size_t pairs = state->contact_count - state->wall_contact_count;
    size_t items = CLOD_NEIGHBOUR_ROW_ITEMS * grains;
    const size_t most = pairs > state->wall_contact_count ? pairs : state->wall_contact_count;
    items = items > most / PLACES_PER_ITEM ? items : most / PLACES_PER_ITEM + 1;
    if (grains > self->grain_capacity) {
        clod_memory_free(self->pairs.start);
        clod_memory_free(self->cell_of);
        clod_memory_free(self->cell_item);
        clod_memory_free(self->rank);
        self->pairs.start = clod_memory_alloc(grains, sizeof *self->pairs.start);
        self->cell_of = clod_memory_alloc(grains, sizeof *self->cell_of);
        self->cell_item = clod_memory_alloc(grains, sizeof *self->cell_item);
        self->rank = clod_memory_alloc(grains, sizeof *self->rank);
        self->grain_capacity = grains;
    }
    return self->pairs.start != NULL && self->cell_of != NULL && self->cell_item != NULL &&
           self->rank != NULL && clod_layer_order_reserve(self, 1) && reserve_sort(self, items);
}

bool clod_neighbour_reserve(clod_neighbour *self, const clod_state *state, clod_status *status)
{
    return reserve(self, state) ||
           clod_status_fail(status, CLOD_FAILED, "no memory to sort %zu grains",
                            state->grains.count);
}

/** Whether a coordinate is one that a grain of the domain may have, once it is wrapped. */
static bool is_inside(const clod_domain *domain, int a, double x)
{
    return domain->periodic[a] ? isfinite(x) : x >= domain->min[a] && x <= domain->max[a];
}

bool clod_neighbour_wrap(const clod_neighbour *self, clod_state *state, size_t going,
                         clod_chunk rows)
{
    const clod_domain *domain = &state->domain;
    bool inside = true;
    for (size_t g = rows.begin; g < rows.end; g++) {
        for (int a = 0; a < 3 && !clod_neighbour_goes(self, going, g); a++) {
            double *x = &state->grains.position[g][a];
            if (isfinite(*x)) { // else it is told
                *x = clod_domain_within(domain, a, *x);
            }
            inside &= is_inside(domain, a, *x);
        }
    }
    return inside;
}

bool clod_neighbour_inside(const clod_neighbour *self, const clod_state *state, size_t going,
                           clod_status *status)
{
    static const char AXIS[] = "xyz";
    const clod_domain *domain = &state->domain;
    for (size_t g = 0; g < state->grains.count; g++) {
        for (int a = 0; a < 3 && !clod_neighbour_goes(self, going, g); a++) {
            const double x = state->grains.position[g][a];
            if (!is_inside(domain, a, x)) {
                return clod_status_fail(
                    status, CLOD_FAILED,
                    "step %lld: grain %llu has left the domain: %c = %g m, allowed %g to %g m; "
                    "enlarge domain, close the gap in the walls, take a smaller time step, or "
                    "set domain.open: delete",
                    (long long)state->step, (unsigned long long)state->grains.id[g], AXIS[a], x,
                    domain->min[a], domain->max[a]);
            }
        }
    }
    return true;
}

void clod_neighbour_rows_out(const clod_neighbour *self, const clod_row_column *column,
                             clod_chunk rows)
{
    char *to = (char *)clod_neighbour_rows(self);
    for (size_t g = rows.begin; g < rows.end; g++) {
        memcpy(to + g * column->size, column->array + self->sort[g].index * column->stride,
               column->size);
    }
}

void clod_neighbour_rows_back(const clod_neighbour *self, const clod_row_column *column,
                              clod_chunk rows)
{
    const char *from = (const char *)clod_neighbour_rows(self);
    for (size_t g = rows.begin; g < rows.end; g++) {
        memcpy(column->array + g * column->stride, from + g * column->size, column->size);
    }
}

/** Bring all rows of an array into the new order. */
static void permute(const clod_neighbour *self, clod_row_column column, size_t count)
{
    clod_neighbour_rows_out(self, &column, (clod_chunk){0, count});
    clod_neighbour_rows_back(self, &column, (clod_chunk){0, count});
}

int clod_neighbour_columns(const clod_grains *grains, clod_row_column columns[CLOD_ROW_COLUMNS])
{
    int count = 0;
#define ADD(rows, first, bytes)                                                                \
    columns[count++] = (clod_row_column){(char *)(rows) + (first), sizeof *(rows), bytes}
    ADD(grains->position, 0, sizeof *grains->position);
    ADD(grains->velocity, 0, sizeof *grains->velocity);
    ADD(grains->angular_velocity, 0, sizeof *grains->angular_velocity);
    const size_t half =
        sizeof *grains->load / 2; // the scratch has room for rows of four numbers
    ADD(grains->load, 0, half);
    ADD(grains->load, half, half);
    if (grains->before != NULL) {
        ADD(grains->before, 0, half);
        ADD(grains->before, half, half);
    }
    ADD(grains->id, 0, sizeof *grains->id);
    ADD(grains->birth, 0, sizeof *grains->birth);
    ADD(grains->material, 0, sizeof *grains->material);
    if (grains->clump != NULL) {
        ADD(grains->clump, 0, sizeof *grains->clump);
    }
#undef ADD
    return count;
}

/** The rows of all grains, and what belongs to them. */
static void permute_grains(const clod_neighbour *self, const clod_grains *grains)
{
    clod_row_column columns[CLOD_ROW_COLUMNS];
    const int count = clod_neighbour_columns(grains, columns);
    for (int k = 0; k < count; k++) {
        permute(self, columns[k], grains->count);
    }
}

void clod_neighbour_rename(const clod_neighbour *self, clod_contact *c)
{
    c->i = self->rank[c->i];
    if (c->shape >= 0) {
        return;
    }
    c->j = self->rank[c->j];
    if (c->i > c->j) {
        clod_contact_turn(c);
    }
}

/** Put `count` contacts into ascending order: by counting to the run of their i, in place along
 *  the cycles of that permutation, then by partner, a handful in each run. */
static void sort_contacts(clod_neighbour *self, clod_contact *contacts, size_t count,
                          size_t grains)
{
    int32_t *place = (int32_t *)self->sort;
    int32_t *next = self->cell_of; // where the next contact of each grain goes
    memset(next, 0, grains * sizeof *next);
    for (size_t k = 0; k < count; k++) {
        next[contacts[k].i]++;
    }
    int32_t sum = 0;
    for (size_t g = 0; g < grains; g++) {
        const int32_t mine = next[g];
        next[g] = sum;
        sum += mine;
    }
    for (size_t k = 0; k < count; k++) {
        place[k] = next[contacts[k].i]++;
    }
    for (size_t k = 0; k < count; k++) {
        while ((size_t)place[k] != k) {
            const size_t to = (size_t)place[k];
            const clod_contact moving = contacts[to];
            contacts[to] = contacts[k];
            contacts[k] = moving;
            place[k] = place[to];
            place[to] = (int32_t)to;
        }
    }
    clod_contacts_ascend(contacts, 0, count);
}

/** Rows and contacts of the state into the order that was found. */
static void apply_order(clod_neighbour *self, clod_state *state)
{
    permute_grains(self, &state->grains);
    for (size_t k = 0; k < state->contact_count; k++) {
        clod_neighbour_rename(self, &state->contacts[k]);
    }
}

/** Contacts of grains whose later one comes first are met from the other side. */
static void turn_contacts(clod_state *state)
{
    for (size_t k = 0; k < state->contact_count; k++) {
        clod_contact *c = &state->contacts[k];
        if (c->shape < 0 && c->i > c->j) {
            clod_contact_turn(c);
        }
    }
}

/** Both lists of contacts into ascending order. */
static bool sort_lists(clod_neighbour *self, clod_state *state, clod_status *status)
{
    if (!reserve(self, state)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory to sort %zu contacts",
                                state->contact_count);
    }
    const size_t pairs = state->contact_count - state->wall_contact_count;
    const size_t walls = state->wall_contact_count;
    sort_contacts(self, state->contacts, pairs, state->grains.count);
    if (walls > 0) {
        sort_contacts(self, state->contacts + pairs, walls, state->grains.count);
    }
    clod_neighbour_give_back(self);
    return true;
}

bool clod_neighbour_sort_as_built(clod_neighbour *self, clod_state *state, clod_status *status)
{
    if (!clod_neighbour_reserve(self, state, status)) {
        return false;
    }
    const size_t count = state->grains.count;
    clod_layer_order order = {.neighbour = self,
                              .grains = &state->grains,
                              .place = (const double(*)[4])state->build_position};
    clod_layer_order_find(&order);
    bool sorted = true;
    for (size_t g = 0; g < count; g++) {
        sorted = sorted && self->sort[g].index == g;
    }
    if (!sorted) {
        const size_t row = sizeof *state->build_position;
        permute(self, (clod_row_column){(char *)state->build_position, row, row}, count);
        apply_order(self, state);
    } else { // rows that came from other ranks may be in order, and their contacts be of another
        turn_contacts(state);
    }
    return sort_lists(self, state, status);
}

/** Remember where the walls are at this rebuild, and have room for where the grains are. */
static bool note_rebuild(clod_neighbour *self, clod_state *state)
{
    if (state->build_position == NULL) {
        state->build_walls =
            clod_memory_alloc((size_t)state->walls.count + 1, sizeof *state->build_walls);
        if (!clod_state_reserve_build(state) || state->build_walls == NULL) {
            return false;
        }
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        clod_wall_pose_get(&state->walls.wall[w], state->build_walls[w]);
    }
    state->build_motion = 0.0;
    state->build_skin = self->skin;
    self->now = true;
    return true;
}

void clod_neighbour_note_positions(clod_state *state, clod_chunk grains)
{
    memcpy(state->build_position + grains.begin, state->grains.position + grains.begin,
           (grains.end - grains.begin) * sizeof *state->build_position);
}

void clod_neighbour_give_old_back(const clod_neighbour *self, const clod_state *state)
{
    const size_t pairs = self->pairs.capacity * sizeof *self->pairs.item;
    clod_memory_give_back(self->pairs.item, pairs, pairs);
    if (state->build_position != NULL) {
        const size_t places = state->build_capacity * sizeof *state->build_position;
        clod_memory_give_back(state->build_position, places, places);
    }
}

bool clod_neighbour_note(clod_neighbour *self, clod_state *state, clod_status *status)
{
    return note_rebuild(self, state) ||
           clod_status_fail(status, CLOD_FAILED, "no memory to sort %zu grains",
                            state->grains.count);
}

bool clod_neighbour_sort(clod_neighbour *self, clod_state *state, clod_status *status)
{
    const clod_chunk all = {0, state->grains.count};
    if (!clod_neighbour_reserve(self, state, status) ||
        (!clod_neighbour_wrap(self, state, 0, all) &&
         !clod_neighbour_inside(self, state, 0, status))) {
        return false;
    }
    clod_neighbour_give_old_back(self, state);
    clod_layer_order order = {.neighbour = self,
                              .grains = &state->grains,
                              .place = (const double(*)[4])state->grains.position};
    clod_layer_order_find(&order);
    apply_order(self, state);
    if (!sort_lists(self, state, status) || !clod_neighbour_note(self, state, status)) {
        return false;
    }
    clod_neighbour_note_positions(state, all);
    self->now = false;
    return true;
}
