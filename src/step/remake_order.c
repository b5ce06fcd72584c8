#include "step/remake_order.h"

#include <string.h>

#include "step/leavers.h"
#include "step/spread.h"

bool clod_remake_order_is_new(const clod_step *self)
{
    return self->remake.again && self->spread == NULL;
}

/** Whether grains may leave by themselves. */
static bool some_leave(const clod_state *state)
{
    return state->domain.removes || state->domain.outlets > 0;
}

/** Grains that leave at this rebuild are marked, counted and, on all ranks, told. */
static void mark_leavers(clod_step *self)
{
    clod_step_remake *remake = &self->remake;
    clod_state *state = self->state;
    if (!some_leave(state)) {
        return;
    }
    if (!remake->changes) {
        memset(self->neighbour.rank, 0, state->grains.count * sizeof(int32_t));
    }
    clod_leavers leavers = {0};
    const clod_leavers_outlets outlets = {&self->outlets, &self->walls};
    clod_outlet_shapes_place(&self->outlets, &self->walls, &state->walls);
    const double half_kick = remake->changes ? 0.0 : 0.5 * state->dt;
    if (self->spread != NULL) {
        clod_spread_mark_leavers(self, &outlets, half_kick, &leavers);
    } else {
        remake->going +=
            clod_leavers_mark(&leavers, state, &outlets, half_kick, self->neighbour.rank);
    }
    clod_leavers_book(&leavers, state);
    if (leavers.grains > 0 && !remake->changes) {
        remake->left = true;
        remake->before = clod_step_balance(self);
    }
}

void clod_remake_order_begin(clod_step *self, int part)
{
    (void)part;
    clod_near_give_skins_back(&self->near);
    clod_step_remake *remake = &self->remake;
    clod_state *state = self->state;
    if (!remake->again) {
        return;
    }
    mark_leavers(self);
    if (!clod_layer_order_reserve(&self->neighbour,
                                  self->near.parts)) { // a crew begins without
        self->failed = true;
        clod_status_fail(&self->status, CLOD_FAILED, "no memory to sort %zu grains",
                         state->grains.count);
        return;
    }
    if (self->spread != NULL) {
        return;
    }
    self->failed = !clod_neighbour_reserve(&self->neighbour, state, &self->status);
    remake->order = (clod_layer_order){.neighbour = &self->neighbour,
                                       .grains = &state->grains,
                                       .place = (const double(*)[4])state->grains.position,
                                       .going = remake->going,
                                       .parts = self->near.parts};
    remake->reorder = (clod_reorder){.neighbour = &self->neighbour,
                                     .near = &self->near,
                                     .state = state,
                                     .walls = &self->walls,
                                     .grains = state->grains.count - remake->going,
                                     .wall_rank = remake->wall_rank,
                                     .moved = remake->changes && state->changes.moved};
}

/** How many grains are marked as those that go; where they are spread over ranks 1 if any may be:
 *  nobody asks for more there than whether it is 0. */
static size_t marked(const clod_step *self)
{
    return self->spread == NULL ? self->remake.going : some_leave(self->state) ? 1 : 0;
}

void clod_remake_order_measure(clod_step *self, int part)
{
    clod_state *state = self->state;
    const clod_chunk rows = clod_threads_chunk(state->grains.count, part, self->near.parts);
    self->neighbour.order_part[part].outside =
        !clod_neighbour_wrap(&self->neighbour, state, marked(self), rows);
    if (clod_remake_order_is_new(self)) {
        clod_layer_order_measure(&self->remake.order, part);
        clod_reorder_begin(&self->remake.reorder, part);
    }
}

void clod_remake_order_layers(clod_step *self, int part)
{
    (void)part;
    clod_state *state = self->state;
    if (self->spread != NULL && some_leave(state)) {
        clod_spread_disown(self);
    }
    bool outside = false;
    for (int p = 0; p < self->near.parts; p++) {
        outside |= self->neighbour.order_part[p].outside;
    }
    self->failed =
        outside && !clod_neighbour_inside(&self->neighbour, state, marked(self), &self->status);
    if (!self->failed && clod_remake_order_is_new(self)) {
        clod_neighbour_give_old_back(&self->neighbour, state);
        clod_layer_order_begin(&self->remake.order);
    }
}

void clod_remake_order_find_keys(clod_step *self, int part)
{
    if (clod_remake_order_is_new(self)) {
        clod_layer_order_find_keys(&self->remake.order, part);
    }
}

void clod_remake_order_sort(clod_step *self, clod_chunk parts)
{
    if (clod_remake_order_is_new(self)) {
        clod_layer_order_sort(&self->remake.order, parts, &self->barrier);
    }
}

void clod_remake_order_ascend(clod_step *self, int part)
{
    if (clod_remake_order_is_new(self)) {
        clod_reorder_ascend(&self->remake.reorder, part);
    }
}

void clod_remake_order_move_rows(clod_step *self, clod_chunk parts)
{
    if (!clod_remake_order_is_new(self)) {
        return;
    }
    const int all = self->near.parts;
    const size_t grains = self->remake.reorder.grains;
    if (parts.begin == 0) { // the contacts are in order: nobody needs it any more
        clod_neighbour_give_ranks_back(&self->neighbour);
    }
    clod_row_column columns[CLOD_ROW_COLUMNS];
    const int count = clod_neighbour_columns(&self->state->grains, columns);
    for (int k = 0; k < count; k++) {
        for (size_t p = parts.begin; p < parts.end; p++) {
            clod_neighbour_rows_out(&self->neighbour, &columns[k],
                                    clod_threads_chunk(grains, (int)p, all));
        }
        clod_barrier_wait(&self->barrier);
        for (size_t p = parts.begin; p < parts.end; p++) {
            clod_neighbour_rows_back(&self->neighbour, &columns[k],
                                     clod_threads_chunk(grains, (int)p, all));
        }
        clod_barrier_wait(&self->barrier);
    }
}
