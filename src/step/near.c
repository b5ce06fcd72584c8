#include "step/near.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "geometry/wall_gap.h"

/** What goes through the making of one list. */
typedef struct near_job {
    clod_near *near;
    const clod_state *state;
    const clod_contact *contacts; ///< source of history, or NULL: the old blocks
    size_t *fill;                 ///< [laws] contacts placed so far
} near_job;

static bool pair_is_near(const clod_state *state, const clod_candidate *c, double skin)
{
    const double *a = state->grains.place[c->i];
    const double *b = state->grains.place[c->j];
    const double x = clod_domain_separation(&state->domain, 0, a[0], b[0]);
    const double y = clod_domain_separation(&state->domain, 1, a[1], b[1]);
    const double z = clod_domain_separation(&state->domain, 2, a[2], b[2]);
    const double reach = a[3] + b[3] + skin;
    return x * x + y * y + z * z < reach * reach;
}

static bool wall_is_near(const clod_state *state, const clod_candidate *c,
                         const clod_wall_pose *pose, double skin)
{
    const double *p = state->grains.place[c->i];
    const clod_shape *shape = &state->walls.wall[c->j].shapes[c->shape];
    const clod_gap gap =
        clod_wall_gap_in_space(&pose[c->j], shape, (clod_vec3){p[0], p[1], p[2]});
    return gap.distance < p[3] + skin;
}

/** Room for `count` items, contents lost; `capacity` follows. */
static bool reserve(void *array, size_t *capacity, size_t count, size_t size)
{
    if (count <= *capacity) {
        return true;
    }
    void *old;
    memcpy(&old, array, sizeof old);
    clod_memory_free(old);
    void *fresh = clod_memory_alloc(count + count / 4, size);
    memcpy(array, &fresh, sizeof fresh);
    *capacity = fresh != NULL ? count + count / 4 : 0;
    return fresh != NULL;
}

/** Count near candidates by law (into law_start, one ahead) and by grain. */
static void count_near(clod_candidates *candidates, size_t *law_start, int32_t *slot_start,
                       bool pairs)
{
    for (size_t k = 0; k < candidates->count; k++) {
        const clod_candidate *c = &candidates->item[k];
        if (c->near != 0) {
            law_start[c->law + 1]++;
            slot_start[c->i + 1]++;
            slot_start[c->j + 1] += pairs ? 1 : 0;
        }
    }
}

/** From contacts per law to blocks: first block of each law, and how many in all. */
static size_t blocks_by_law(size_t *law_start, int32_t laws)
{
    for (int32_t l = 0; l < laws; l++) {
        const size_t blocks = (law_start[l + 1] + CLOD_LANES - 1) / CLOD_LANES;
        law_start[l + 1] = law_start[l] + blocks;
    }
    return law_start[laws];
}

/** Swap current and old blocks and make room for the new ones. */
static bool turn_blocks(clod_near_blocks *self, int32_t laws, size_t size)
{
    void *block = self->block;
    const size_t capacity = self->capacity;
    self->block = self->old;
    self->capacity = self->old_capacity;
    self->old = block;
    self->old_capacity = capacity;
    self->count = blocks_by_law(self->law_start, laws);
    return reserve(&self->block, &self->capacity, self->count, size);
}

static void history_put(clod_history *to, int lane, const double from[8])
{
    to->plastic[lane] = from[0];
    to->tangent[lane] = from[1];
    for (int c = 0; c < 3; c++) {
        to->spring[c][lane] = from[2 + c];
        to->roll[c][lane] = from[5 + c];
    }
}

static void history_get(const clod_history *from, int lane, double to[8])
{
    to[0] = from->plastic[lane];
    to[1] = from->tangent[lane];
    for (int c = 0; c < 3; c++) {
        to[2 + c] = from->spring[c][lane];
        to[5 + c] = from->roll[c][lane];
    }
}

/** History of a candidate from where it was, or none, into its new lane. */
static void carry_history(const near_job *job, const clod_candidate *c,
                          const clod_history *before, clod_history *to, int lane)
{
    double history[8] = {0.0};
    if (c->lane >= 0 && job->contacts != NULL) {
        memcpy(history, job->contacts[c->lane].history, sizeof history);
    } else if (c->lane >= 0) {
        history_get(before, c->lane % CLOD_LANES, history);
    }
    history_put(to, lane, history);
}

static void place_pair(near_job *job, clod_candidate *c)
{
    clod_near *near = job->near;
    clod_contact_block *blocks = near->pairs.block;
    const clod_contact_block *old = near->pairs.old;
    const size_t at = near->pairs.law_start[c->law] * CLOD_LANES + job->fill[c->law]++;
    clod_contact_block *block = &blocks[at / CLOD_LANES];
    const int lane = (int)(at % CLOD_LANES);
    block->i[lane] = c->i;
    block->j[lane] = c->j;
    block->slot_i[lane] = near->slot_fill[c->i]++;
    block->slot_j[lane] = near->slot_fill[c->j]++;
    const clod_history *before =
        c->lane < 0 || job->contacts != NULL ? NULL : &old[c->lane / CLOD_LANES].history;
    carry_history(job, c, before, &block->history, lane);
    c->lane = (int32_t)at;
}

static void place_wall(near_job *job, clod_candidate *c)
{
    clod_near *near = job->near;
    clod_wall_block *blocks = near->walls.block;
    const clod_wall_block *old = near->walls.old;
    const size_t at = near->walls.law_start[c->law] * CLOD_LANES + job->fill[c->law]++;
    clod_wall_block *block = &blocks[at / CLOD_LANES];
    const int lane = (int)(at % CLOD_LANES);
    block->i[lane] = c->i;
    block->wall[lane] = c->j;
    block->shape[lane] = c->shape;
    block->slot_i[lane] = near->slot_fill[c->i]++;
    block->slot_wall[lane] = near->wall_slot_fill[c->j]++;
    const clod_history *before =
        c->lane < 0 || job->contacts != NULL ? NULL : &old[c->lane / CLOD_LANES].history;
    carry_history(job, c, before, &block->history, lane);
    c->lane = (int32_t)at;
}

/** Fill the lanes behind the last contact of each law with the padding rows of the grains. */
static void pad_pairs(near_job *job, int32_t laws, int32_t *spare)
{
    const clod_near_blocks *pairs = &job->near->pairs;
    const int32_t far = (int32_t)job->state->grains.count;
    clod_contact_block *blocks = pairs->block;
    for (int32_t l = 0; l < laws; l++) {
        const size_t first = pairs->law_start[l] * CLOD_LANES + job->fill[l];
        for (size_t at = first; at < pairs->law_start[l + 1] * CLOD_LANES; at++) {
            clod_contact_block *block = &blocks[at / CLOD_LANES];
            const int lane = (int)(at % CLOD_LANES);
            block->i[lane] = far;
            block->j[lane] = far + 1;
            block->slot_i[lane] = (*spare)++;
            block->slot_j[lane] = (*spare)++;
            history_put(&block->history, lane, (double[8]){0.0});
        }
    }
}

static void pad_walls(near_job *job, int32_t laws, int32_t *spare, int32_t *wall_spare)
{
    const clod_near_blocks *walls = &job->near->walls;
    clod_wall_block *blocks = walls->block;
    for (int32_t l = 0; l < laws; l++) {
        const size_t first = walls->law_start[l] * CLOD_LANES + job->fill[l];
        for (size_t at = first; at < walls->law_start[l + 1] * CLOD_LANES; at++) {
            clod_wall_block *block = &blocks[at / CLOD_LANES];
            const int lane = (int)(at % CLOD_LANES);
            block->i[lane] = (int32_t)job->state->grains.count;
            block->wall[lane] = -1;
            block->shape[lane] = -1;
            block->slot_i[lane] = (*spare)++;
            block->slot_wall[lane] = (*wall_spare)++;
            history_put(&block->history, lane, (double[8]){0.0});
        }
    }
}

static bool prepare(clod_near *self, const clod_state *state, const clod_laws *laws)
{
    const size_t grains = state->grains.count;
    const size_t walls = (size_t)state->walls.count;
    const size_t kinds = (size_t)laws->count + 1;
    if (self->pairs.law_start == NULL) {
        self->pairs.law_start = clod_memory_alloc(2 * kinds, sizeof(size_t));
        self->walls.law_start = clod_memory_alloc(2 * kinds, sizeof(size_t));
        self->wall_slot_start = clod_memory_alloc(walls + 1, sizeof(int32_t));
        self->wall_slot_fill = clod_memory_alloc(walls + 1, sizeof(int32_t));
    }
    if (grains + 1 > self->slot_start_capacity) {
        clod_memory_free(self->slot_start);
        clod_memory_free(self->slot_fill);
        self->slot_start = clod_memory_alloc(grains + 1, sizeof(int32_t));
        self->slot_fill = clod_memory_alloc(grains + 1, sizeof(int32_t));
        self->slot_start_capacity = grains + 1;
    }
    if (self->pairs.law_start == NULL || self->walls.law_start == NULL ||
        self->wall_slot_start == NULL || self->wall_slot_fill == NULL ||
        self->slot_start == NULL || self->slot_fill == NULL) {
        return false;
    }
    memset(self->pairs.law_start, 0, 2 * kinds * sizeof(size_t));
    memset(self->walls.law_start, 0, 2 * kinds * sizeof(size_t));
    memset(self->slot_start, 0, (grains + 1) * sizeof(int32_t));
    memset(self->wall_slot_start, 0, (walls + 1) * sizeof(int32_t));
    return true;
}

static void mark_near(clod_neighbour *neighbour, const clod_state *state,
                      const clod_wall_pose *pose, double skin)
{
    for (size_t k = 0; k < neighbour->pairs.count; k++) {
        clod_candidate *c = &neighbour->pairs.item[k];
        c->near = pair_is_near(state, c, skin);
    }
    for (size_t k = 0; k < neighbour->walls.count; k++) {
        clod_candidate *c = &neighbour->walls.item[k];
        c->near = wall_is_near(state, c, pose, skin);
    }
}

/** Offsets of the slots from the counts; returns slots and wall slots including the padding. */
static bool layout_slots(clod_near *self, const clod_state *state, int32_t laws)
{
    const size_t grains = state->grains.count;
    for (size_t g = 0; g < grains; g++) {
        self->slot_start[g + 1] += self->slot_start[g];
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        self->wall_slot_start[w + 1] += self->wall_slot_start[w];
    }
    memcpy(self->slot_fill, self->slot_start, grains * sizeof(int32_t));
    memcpy(self->wall_slot_fill, self->wall_slot_start,
           (size_t)state->walls.count * sizeof(int32_t));
    const size_t padding = (size_t)laws * CLOD_LANES;
    const size_t used = (size_t)self->slot_start[grains];
    const size_t wall_used = (size_t)self->wall_slot_start[state->walls.count];
    return reserve(&self->slots, &self->slot_capacity, used + 3 * padding,
                   sizeof *self->slots) &&
           reserve(&self->wall_slots, &self->wall_slot_capacity, wall_used + padding,
                   sizeof *self->wall_slots);
}

static void place_all(clod_near *self, clod_neighbour *neighbour, const clod_state *state,
                      int32_t laws, bool from_contacts)
{
    near_job job = {self, state, from_contacts ? state->contacts : NULL,
                    self->pairs.law_start + laws + 1};
    int32_t spare = self->slot_start[state->grains.count];
    int32_t wall_spare = self->wall_slot_start[state->walls.count];
    for (size_t k = 0; k < neighbour->pairs.count; k++) {
        clod_candidate *c = &neighbour->pairs.item[k];
        if (c->near != 0) {
            place_pair(&job, c);
        } else {
            c->lane = -1;
        }
    }
    pad_pairs(&job, laws, &spare);
    job.fill = self->walls.law_start + laws + 1;
    for (size_t k = 0; k < neighbour->walls.count; k++) {
        clod_candidate *c = &neighbour->walls.item[k];
        if (c->near != 0) {
            place_wall(&job, c);
        } else {
            c->lane = -1;
        }
    }
    pad_walls(&job, laws, &spare, &wall_spare);
}

bool clod_near_reserve_spent(clod_near *self)
{
    return !self->ledger || (reserve(&self->pairs.spent, &self->pairs.spent_capacity,
                                     self->pairs.count, sizeof *self->pairs.spent) &&
                             reserve(&self->walls.spent, &self->walls.spent_capacity,
                                     self->walls.count, sizeof *self->walls.spent));
}

bool clod_near_make(clod_near *self, clod_neighbour *neighbour, const clod_state *state,
                    const clod_laws *laws, const clod_wall_pose *pose, double skin,
                    bool from_contacts, clod_status *status)
{
    self->skin = skin;
    mark_near(neighbour, state, pose, skin);
    if (prepare(self, state, laws)) {
        count_near(&neighbour->pairs, self->pairs.law_start, self->slot_start, true);
        count_near(&neighbour->walls, self->walls.law_start, self->slot_start, false);
        for (size_t k = 0; k < neighbour->walls.count; k++) {
            const clod_candidate *c = &neighbour->walls.item[k];
            self->wall_slot_start[c->j + 1] += c->near;
        }
        if (turn_blocks(&self->pairs, laws->count, sizeof(clod_contact_block)) &&
            turn_blocks(&self->walls, laws->count, sizeof(clod_wall_block)) &&
            layout_slots(self, state, laws->count) && clod_near_reserve_spent(self)) {
            place_all(self, neighbour, state, laws->count, from_contacts);
            return true;
        }
    }
    return clod_status_fail(status, CLOD_FAILED, "no memory for the contacts of %zu grains",
                            state->grains.count);
}

static bool export_one(clod_state *state, int32_t i, int32_t j, int32_t shape,
                       const clod_history *history, int lane)
{
    if (history->tangent[lane] == 0.0) { // never touched
        return true;
    }
    if (state->contact_count == state->contact_capacity) {
        const size_t capacity = state->contact_capacity + state->contact_capacity / 2 + 1024;
        void *grown = clod_memory_grow(state->contacts, state->contact_capacity, capacity,
                                       sizeof *state->contacts);
        if (grown == NULL) {
            return false;
        }
        state->contacts = grown;
        state->contact_capacity = capacity;
    }
    clod_contact *c = &state->contacts[state->contact_count++];
    *c = (clod_contact){.i = i, .j = j, .shape = shape};
    history_get(history, lane, c->history);
    return true;
}

bool clod_near_export(const clod_near *self, clod_neighbour *neighbour, clod_state *state,
                      clod_status *status)
{
    bool ok = true;
    state->contact_count = 0;
    const clod_contact_block *pairs = self->pairs.block;
    for (size_t b = 0; b < self->pairs.count; b++) {
        for (int l = 0; l < CLOD_LANES; l++) {
            ok =
                ok && export_one(state, pairs[b].i[l], pairs[b].j[l], -1, &pairs[b].history, l);
        }
    }
    const size_t before = state->contact_count;
    const clod_wall_block *walls = self->walls.block;
    for (size_t b = 0; b < self->walls.count; b++) {
        for (int l = 0; l < CLOD_LANES; l++) {
            ok = ok && export_one(state, walls[b].i[l], walls[b].wall[l], walls[b].shape[l],
                                  &walls[b].history, l);
        }
    }
    state->wall_contact_count = state->contact_count - before;
    if (!ok) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu contacts",
                                state->contact_count);
    }
    return clod_neighbour_sort_contacts(neighbour, state, status);
}

void clod_near_fini(clod_near *self)
{
    clod_memory_free(self->pairs.block);
    clod_memory_free(self->pairs.old);
    clod_memory_free(self->pairs.law_start);
    clod_memory_free(self->pairs.spent);
    clod_memory_free(self->walls.spent);
    clod_memory_free(self->walls.block);
    clod_memory_free(self->walls.old);
    clod_memory_free(self->walls.law_start);
    clod_memory_free(self->slot_start);
    clod_memory_free(self->slot_fill);
    clod_memory_free(self->slots);
    clod_memory_free(self->wall_slot_start);
    clod_memory_free(self->wall_slot_fill);
    clod_memory_free(self->wall_slots);
    *self = (clod_near){0};
}
