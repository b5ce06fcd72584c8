// Stage near: when motion has used a skin up, make the near list anew, or rebuild everything.
#include <math.h>
#include <stdatomic.h>

#include "parallel/threads.h"
#include "state/alter.h"
#include "step/change.h"
#include "step/reorder.h"

/**
 * What a near list costs, over what the pairs within a skin of one smallest radius cost in a
 * step (docs/adr/0020).
 */
#define NEAR_COST 3.0
/** The thinnest skin, as a fraction of the smallest radius: next to no pairs. */
#define NEAR_LEAST 1e-3

double clod_step_thin_skin(const clod_step *self, double speed)
{
    const double radius = self->neighbour.radius_min;
    const double closing = 2.0 * speed * self->state->dt;
    const double skin = fmax(NEAR_LEAST * radius, sqrt(NEAR_COST * closing * radius));
    return fmin(skin, self->neighbour.skin);
}

/** The list that is being made. */
static clod_near_job job_of(clod_step *self)
{
    return (clod_near_job){.near = &self->near,
                           .neighbour = &self->neighbour,
                           .state = self->state,
                           .laws = self->laws,
                           .walls = &self->walls,
                           .skin = clod_step_thin_skin(self, self->remake.speed)};
}

// ---- the phases, in the order of the table below

/** Whether contacts go straight to their new order: at a rebuild, unless grains leave. */
static bool reorders(const clod_step *self)
{
    return self->remake.again && self->remake.leavers == 0;
}

/** Grains that leave through an open side are marked; else the new order is found. */
static void begin(clod_step *self, int part)
{
    (void)part;
    self->remake.leavers = self->remake.again ? clod_change_find_leavers(self) : 0;
    self->remake.before = self->remake.leavers > 0 ? clod_change_balance(self) : 0.0;
    if (reorders(self)) {
        self->failed = !clod_neighbour_order(&self->neighbour, self->state, &self->status);
        if (!self->failed) {
            clod_reorder_begin(&self->neighbour, self->state->grains.count);
        }
    }
}

static void count_old(clod_step *self, int part)
{
    if (reorders(self)) {
        clod_reorder_count(&self->neighbour, &self->near, part);
    } else {
        clod_near_gather_count(&self->near, part);
    }
}

static void make_room(clod_step *self, int part)
{
    (void)part;
    self->failed =
        reorders(self)
            ? !clod_reorder_room(&self->neighbour, &self->near, self->state, &self->status)
            : !clod_near_gather_room(&self->near, self->state, &self->status);
}

/** Histories into the state. */
static void copy_old(clod_step *self, int part)
{
    if (reorders(self)) {
        clod_reorder_copy(&self->neighbour, &self->near, self->state, &self->walls, part);
    } else {
        clod_near_gather_copy(&self->near, self->state, &self->walls, part, true);
    }
}

/** Contacts and rows of grains into the new order. */
static void reorder(clod_step *self, clod_chunk parts)
{
    clod_state *state = self->state;
    clod_row_column columns[CLOD_ROW_COLUMNS];
    const int count = clod_neighbour_columns(&state->grains, columns);
    for (int k = -1; reorders(self) && k < count; k++) {
        for (size_t p = parts.begin; p < parts.end; p++) {
            const clod_chunk rows =
                clod_threads_chunk(state->grains.count, (int)p, self->near.parts);
            if (k < 0) {
                clod_reorder_ascend(&self->neighbour, state, rows);
            } else {
                clod_neighbour_rows_out(&self->neighbour, &columns[k], rows);
            }
        }
        clod_barrier_wait(&self->barrier);
        for (size_t p = parts.begin; k >= 0 && p < parts.end; p++) {
            clod_neighbour_rows_back(
                &self->neighbour, &columns[k],
                clod_threads_chunk(state->grains.count, (int)p, self->near.parts));
        }
        clod_barrier_wait(&self->barrier);
    }
}

/** The near list is no more; at a rebuild the search begins. */
static void begin_search(clod_step *self, int part)
{
    (void)part;
    clod_state *state = self->state;
    clod_near_gather_end(&self->near, true);
    if (!self->remake.again) {
        return;
    }
    bool good;
    if (self->remake.leavers > 0) { // with what they carried
        clod_state_drop_grains(state, self->neighbour.rank);
        clod_neighbour_size(&self->neighbour, state);
        good = clod_neighbour_sort(&self->neighbour, state, &self->status);
    } else {
        clod_neighbour_give_back(&self->neighbour);
        good = clod_neighbour_note(state, &self->status);
    }
    self->failed = !good || !clod_neighbour_build_begin(&self->neighbour, state, self->laws,
                                                        self->near.parts, &self->status);
}

/** At a rebuild the candidates are found anew. */
static void search(clod_step *self, int part)
{
    if (self->remake.again) {
        clod_neighbour_build_part(&self->neighbour, self->state, part);
    }
}

static void join(clod_step *self, int part)
{
    (void)part;
    self->failed = self->remake.again &&
                   !clod_neighbour_build_end(&self->neighbour, self->state, &self->status);
    if (!self->failed) {
        self->remake.job = job_of(self);
        self->failed = !clod_near_begin(&self->remake.job, &self->status);
    }
}

/** Shapes of walls that move, where they are now: until now only those with grains near. */
static void place_walls(clod_step *self, int part)
{
    const clod_walls *walls = &self->state->walls;
    for (int32_t k = 0; k < self->moving_count; k++) {
        const int32_t w = self->moving[k];
        const clod_wall *wall = &walls->wall[w];
        const clod_wall_stand stand = clod_wall_stand_of(wall);
        const clod_chunk c =
            clod_threads_chunk((size_t)wall->shape_count, part, self->near.parts);
        for (size_t s = c.begin; s < c.end; s++) {
            clod_wall_rows_place_shape(&self->walls, w, &stand, (int32_t)s);
        }
        if (part == 0) {
            clod_wall_rows_note(&self->walls, w, wall);
        }
    }
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

static void end(clod_step *self, int part)
{
    (void)part;
    clod_near_end(&self->remake.job);
    clod_step_list_feeling(self);
    self->view.wall_sum = self->near.wall_sum;
    self->view.lead = self->neighbour.lead;
    if (self->remake.leavers > 0) {
        self->state->ledger.exchanged += clod_change_balance(self) - self->remake.before;
    }
    self->rebuilds += self->remake.again;
    self->refreshes += !self->remake.again;
}

typedef struct list_phase {
    void (*run)(clod_step *self, int part);
    bool all; ///< by every thread for its parts; else by thread 0 alone
    void (*together)(clod_step *self, clod_chunk parts); ///< in place of run, with barriers
} list_phase;

static const list_phase PHASES[] = {
    {.run = begin},
    {.run = count_old, .all = true},
    {.run = make_room},
    {.run = copy_old, .all = true},
    {.together = reorder},
    {.run = begin_search},
    {.run = place_walls, .all = true},
    {.run = search, .all = true},
    {.run = join},
    {.run = mark, .all = true},
    {.run = cut},
    {.run = count_new, .all = true},
    {.run = layout},
    {.run = place, .all = true},
    {.run = end},
};
#define PHASE_COUNT ((int)(sizeof PHASES / sizeof *PHASES))

/**
 * The phases as one thread sees them; a barrier follows each. Where one has failed, all threads
 * leave after its barrier: thread 0 may be in the next one by then, so the number counts.
 */
static void remake_lists(clod_step *self, int part)
{
    const clod_chunk mine = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    for (int k = 0; k < PHASE_COUNT && atomic_load(&self->remake.failed) >= k; k++) {
        for (size_t p = mine.begin; PHASES[k].all && p < mine.end; p++) {
            PHASES[k].run(self, (int)p);
        }
        if (PHASES[k].together != NULL) {
            PHASES[k].together(self, mine);
        } else if (!PHASES[k].all && part == 0) {
            PHASES[k].run(self, 0);
            if (self->failed) {
                atomic_store(&self->remake.failed, k);
            }
        }
        clod_barrier_wait(&self->barrier);
    }
}

/** Every thread takes the same decision from the same numbers; all make the lists. */
void clod_step_near(clod_step *self, int part)
{
    clod_step_thread *mine = &self->thread[part];
    double speed2 = 0.0;
    bool finite = true;
    for (int t = 0; t < self->threads; t++) {
        speed2 = fmax(speed2, self->thread[t].max_speed2);
        finite &= self->thread[t].finite;
    }
    mine->all_finite = finite;
    const double speed = sqrt(speed2);
    mine->build_motion += speed * self->state->dt;
    mine->near_motion += speed * self->state->dt;
    const bool again = 2.0 * mine->build_motion > self->neighbour.skin;
    const bool thin = 2.0 * mine->near_motion > self->near.skin;
    if (!finite || !(again || thin)) { // positions that are not finite cannot be sorted
        return;
    }
    if (part == 0) {
        self->remake.again = again;
        self->remake.speed = speed;
        atomic_store(&self->remake.failed, PHASE_COUNT);
    }
    clod_barrier_wait(&self->barrier);
    remake_lists(self, part);
    mine->near_motion = 0.0;
    mine->build_motion = again ? 0.0 : mine->build_motion;
}
