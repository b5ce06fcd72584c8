#include "step/remake.h"

#include <stdatomic.h>
#include <string.h>

#include "base/memory.h"
#include "parallel/threads.h"
#include "state/alter.h"
#include "step/derived.h"
#include "step/near_skins.h"
#include "step/remake_order.h"
#include "step/spread.h"

/** The list that is being made. */
static clod_near_job job_of(clod_step *self)
{
    return (clod_near_job){.near = &self->near,
                           .neighbour = &self->neighbour,
                           .state = self->state,
                           .laws = self->laws,
                           .walls = &self->walls,
                           .skins = clod_step_skins(self, self->remake.speed),
                           .runs = self->spread != NULL ? self->spread->runs : 1};
}

// ---- the phases, in the order of the table below

static void count_old(clod_step *self, int part)
{
    if (clod_remake_order_is_new(self)) {
        clod_reorder_count(&self->remake.reorder, part);
    } else {
        clod_near_gather_count(&self->near, part);
    }
}

static void make_room(clod_step *self, int part)
{
    (void)part;
    self->failed = clod_remake_order_is_new(self)
                       ? !clod_reorder_room(&self->remake.reorder, &self->status)
                       : !clod_near_gather_room(&self->near, self->state, &self->status);
}

/** Histories into the state. */
static void copy_old(clod_step *self, int part)
{
    if (clod_remake_order_is_new(self)) {
        clod_reorder_copy(&self->remake.reorder, part);
    } else {
        clod_near_gather_copy(&self->near, self->state, &self->walls, part, true);
    }
}

/** Grains that are spread over ranks go to their new owners, and into the new order there. */
static void migrate(clod_step *self, int part)
{
    (void)part;
    if (self->spread != NULL) {
        if (self->remake.changes) {
            self->remake.speed = clod_spread_fastest(self);
        }
        self->failed = !clod_spread_rebuild(self, self->remake.speed, &self->status);
    }
}

/** Walls go and come, and what depends on the set of grains and walls is made anew. */
static bool change_walls(clod_step *self)
{
    clod_state *state = self->state;
    clod_changes *queue = &state->changes;
    if (self->remake.wall_rank != NULL) {
        clod_state_keep_walls(state, self->remake.wall_rank);
    }
    clod_state_add_walls(state, queue->new_wall, queue->new_walls);
    clod_memory_free(state->build_position); // for other numbers of grains and walls
    clod_memory_free(state->build_walls);
    state->build_position = NULL;
    state->build_capacity = 0;
    state->build_walls = NULL;
    if (!clod_step_derive(self, &self->status)) {
        return false;
    }
    clod_step_list_moving(self);
    self->remake.speed = clod_step_fastest(state);
    return true;
}

/** The near list is no more; at a rebuild the search begins, with the grains that stay. */
static void begin_search(clod_step *self, int part)
{
    (void)part;
    clod_state *state = self->state;
    clod_near_gather_end(&self->near);
    if (!self->remake.again) {
        return;
    }
    if (clod_remake_order_is_new(self)) {
        state->grains.count = self->remake.reorder.grains;
    }
    bool good = true;
    if (self->remake.changes && self->spread != NULL) { // only grains have come
        clod_step_list_moving(self);
    } else if (self->remake.changes) {
        good = change_walls(self);
    } else if (self->remake.going > 0) {
        clod_grains_pad(&state->grains);
        clod_neighbour_size(&self->neighbour, state);
    }
    clod_neighbour_give_back(&self->neighbour);
    clod_neighbour_choose_skin(&self->neighbour, state, self->remake.speed);
    self->failed =
        !good || !clod_neighbour_note(&self->neighbour, state, &self->status) ||
        !clod_neighbour_build_begin(&self->neighbour, state, self->near.parts, &self->status);
}

/** Where each cell begins; grains are entered into their cells next. */
static void add_cells(clod_step *self, int part)
{
    (void)part;
    clod_neighbour_build_add(&self->neighbour, self->state);
}

static void enter_cells(clod_step *self, int part)
{
    clod_neighbour_build_enter(&self->neighbour, self->state, part);
}

/** The candidates are found anew. */
static void search(clod_step *self, int part)
{
    clod_neighbour_build_part(&self->neighbour, self->state, self->laws, part);
}

/** The candidates of all parts; every contact must be among them. */
static bool find_candidates(clod_step *self)
{
    if (!clod_neighbour_build_end(&self->neighbour, self->state, &self->status)) {
        return false;
    }
    const clod_spread *spread = self->spread;
    return spread == NULL || !spread->separated.any ||
           clod_neighbour_fail_separated(self->state, spread->separated.id, &self->status);
}

static void join(clod_step *self, int part)
{
    (void)part;
    self->failed = !find_candidates(self);
    if (!self->failed && self->spread != NULL) {
        clod_spread_leave_out(self->spread, &self->neighbour, self->state->grains.count);
    }
}

/** Which candidates are near is looked at next. */
static void begin_list(clod_step *self, int part)
{
    (void)part;
    self->remake.job = job_of(self);
    self->failed = !clod_near_begin(&self->remake.job, &self->status);
}

/** Shapes of walls that move, where they are now: until now only those with grains near. At a
 *  rebuild grains are counted by cell. */
static void place_walls(clod_step *self, int part)
{
    if (self->remake.again) {
        clod_neighbour_build_count(&self->neighbour, self->state, part);
    }
    const clod_walls *walls = &self->state->walls;
    for (int32_t k = 0; k < self->moving_count; k++) {
        const int32_t w = self->moving[k];
        const clod_wall *wall = &walls->wall[w];
        const clod_wall_placement placement = clod_wall_placement_of(wall);
        const clod_chunk c =
            clod_threads_chunk((size_t)wall->shape_count, part, self->near.parts);
        for (size_t s = c.begin; s < c.end; s++) {
            clod_wall_rows_place_shape(&self->walls, w, &placement, (int32_t)s);
        }
        if (part == 0) {
            clod_wall_rows_note(&self->walls, w, wall);
        }
    }
}

static void allow(clod_step *self, int part)
{
    clod_near_choose_skins(&self->remake.job, part);
}

static void mark(clod_step *self, int part)
{
    clod_near_mark(&self->remake.job, part);
}

static void cut(clod_step *self, int part)
{
    (void)part;
    clod_near_cut(&self->remake.job);
}

static void count_new(clod_step *self, int part)
{
    clod_near_count(&self->remake.job, part);
}

static void layout(clod_step *self, int part)
{
    (void)part;
    self->failed = !clod_near_layout(&self->remake.job, &self->status);
}

/** Pairs into blocks, with their histories. */
static void place(clod_step *self, int part)
{
    clod_near_place(&self->remake.job, part);
}

/** Where the grains are: now that the old contacts have left room for it. */
static void note(clod_step *self, int part)
{
    clod_state *state = self->state;
    clod_near_note(&self->remake.job, part);
    if (self->remake.again) {
        clod_neighbour_note_positions(
            state, clod_threads_chunk(state->grains.count, part, self->near.parts));
    }
}

static void end(clod_step *self, int part)
{
    (void)part;
    self->neighbour.now = false;
    clod_near_end(&self->remake.job);
    clod_step_list_summed(self);
    clod_step_set_view(self);
    if (self->remake.changes || self->remake.left) {
        clod_step_book(self, self->remake.before);
    }
    self->rebuilds += self->remake.again;
    self->refreshes += !self->remake.again;
}

typedef struct list_phase {
    void (*run)(clod_step *self, int part);
    bool all;     ///< by every thread for its parts; else by thread 0 alone
    bool rebuild; ///< only at a rebuild
    void (*together)(clod_step *self, clod_chunk parts); ///< in place of run, with barriers
} list_phase;

static const list_phase PHASES[] = {
    {.run = clod_remake_order_begin},
    {.run = clod_remake_order_measure, .all = true, .rebuild = true},
    {.run = clod_remake_order_layers, .rebuild = true},
    {.run = clod_remake_order_find_keys, .all = true, .rebuild = true},
    {.together = clod_remake_order_sort, .rebuild = true},
    {.run = count_old, .all = true},
    {.run = make_room},
    {.run = copy_old, .all = true},
    {.run = clod_remake_order_ascend, .all = true, .rebuild = true},
    {.together = clod_remake_order_move_rows, .rebuild = true},
    {.run = migrate, .rebuild = true},
    {.run = begin_search},
    {.run = place_walls, .all = true},
    {.run = add_cells, .rebuild = true},
    {.run = enter_cells, .all = true, .rebuild = true},
    {.run = search, .all = true, .rebuild = true},
    {.run = join, .rebuild = true},
    {.run = begin_list},
    {.run = allow, .all = true},
    {.run = mark, .all = true},
    {.run = cut},
    {.run = count_new, .all = true},
    {.run = layout},
    {.run = place, .all = true},
    {.run = note, .all = true},
    {.run = end},
};
#define PHASE_COUNT ((int)(sizeof PHASES / sizeof *PHASES))

void clod_remake_begin(clod_step *self, bool again, double speed)
{
    self->remake.again = again;
    self->remake.speed = speed;
    self->remake.changes = false;
    self->remake.going = 0;
    self->remake.left = false;
    self->remake.wall_rank = NULL;
    atomic_store(&self->remake.failed, PHASE_COUNT);
}

/** A list that could not be made after the rows got their new order: what is noted of the rebuild
 *  is in that order too. */
static void note_failed(clod_step *self)
{
    clod_state *state = self->state;
    if (self->neighbour.now) {
        clod_neighbour_note_positions(state, (clod_chunk){0, state->grains.count});
        self->neighbour.now = false;
    }
}

/**
 * The phases as one thread sees them; a barrier follows each. Where one has failed, all threads
 * leave after its barrier: thread 0 may be in the next one by then, so the number counts.
 */
void clod_remake_lists(clod_step *self, int part)
{
    const clod_chunk mine = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    for (int k = 0; k < PHASE_COUNT && atomic_load(&self->remake.failed) >= k; k++) {
        if (PHASES[k].rebuild && !self->remake.again) {
            continue;
        }
        for (size_t p = mine.begin; PHASES[k].all && p < mine.end; p++) {
            PHASES[k].run(self, (int)p);
        }
        if (PHASES[k].together != NULL) {
            PHASES[k].together(self, mine);
        } else if (!PHASES[k].all && part == 0) {
            PHASES[k].run(self, 0);
            self->failed = !clod_spread_agree(self->spread, !self->failed, &self->status);
            if (self->failed) {
                note_failed(self);
                atomic_store(&self->remake.failed, k);
            }
        }
        clod_barrier_wait(&self->barrier);
    }
}
