#include "step/near.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "step/near_between.h"
#include "step/near_parts.h"

/** What goes through the making of one list. */
typedef struct near_job {
    clod_near *near;
    const clod_state *state;
    const clod_wall_rows *walls;
    size_t *fill; ///< [groups] contacts placed so far
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
                         const clod_wall_rows *walls, double skin)
{
    const double *p = state->grains.place[c->i];
    return clod_wall_rows_gap(walls, c->j, c->shape, p).distance < p[3] + skin;
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
    void *fresh = clod_memory_alloc(count + count / 8, size);
    memcpy(array, &fresh, sizeof fresh);
    *capacity = fresh != NULL ? count + count / 8 : 0;
    return fresh != NULL;
}

/** Groups of one list: each law within each part, and between two. */
static size_t group_number(const clod_near *self)
{
    return clod_near_group(self, self->parts + 1, 0);
}

/** Group of a pair (walls: of its grain). */
static size_t group_of(const clod_near *self, const clod_candidate *c)
{
    const int part = clod_near_part_of(self, c->i);
    const bool between = c->shape < 0 && clod_near_part_of(self, c->j) != part;
    return clod_near_group(self, between ? self->parts : part, c->law);
}

/** Count near candidates by group, and from that the first block of each group. */
static void count_groups(const clod_near *self, clod_near_blocks *blocks,
                         const clod_candidates *candidates)
{
    const size_t groups = group_number(self);
    memset(blocks->group_count, 0, groups * sizeof *blocks->group_count);
    for (size_t k = 0; k < candidates->count; k++) {
        if (candidates->item[k].near != 0) {
            blocks->group_count[group_of(self, &candidates->item[k])]++;
        }
    }
    blocks->group_start[0] = 0;
    for (size_t q = 0; q < groups; q++) {
        blocks->group_start[q + 1] =
            blocks->group_start[q] + (blocks->group_count[q] + CLOD_LANES - 1) / CLOD_LANES;
    }
}

/** Room for the blocks of all groups. */
static bool reserve_blocks(clod_near_blocks *self, size_t groups, size_t size)
{
    self->count = self->group_start[groups];
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

/** History of a candidate from its row of contacts, or none, into its new lane. */
static void carry_history(const near_job *job, const clod_candidate *c, clod_history *to,
                          int lane)
{
    static const double NONE[8] = {0.0};
    history_put(to, lane, c->lane >= 0 ? job->state->contacts[c->lane].history : NONE);
}

/** Lane of the next contact of its group. */
static size_t next_lane(near_job *job, const clod_near_blocks *blocks, const clod_candidate *c)
{
    const size_t group = group_of(job->near, c);
    return blocks->group_start[group] * CLOD_LANES + job->fill[group]++;
}

static void place_pair(near_job *job, clod_candidate *c)
{
    clod_near *near = job->near;
    clod_contact_block *blocks = near->pairs.block;
    const size_t at = next_lane(job, &near->pairs, c);
    clod_contact_block *block = &blocks[at / CLOD_LANES];
    const int lane = (int)(at % CLOD_LANES);
    block->i[lane] = c->i;
    block->j[lane] = c->j;
    carry_history(job, c, &block->history, lane);
    c->lane = (int32_t)at;
}

static void place_wall(near_job *job, clod_candidate *c)
{
    clod_near *near = job->near;
    clod_wall_block *blocks = near->walls.block;
    const size_t at = next_lane(job, &near->walls, c);
    clod_wall_block *block = &blocks[at / CLOD_LANES];
    const int lane = (int)(at % CLOD_LANES);
    block->i[lane] = c->i;
    block->wall[lane] = CLOD_WALL_ROWS * c->j;
    block->shape[lane] = clod_wall_rows_shape(job->walls, c->j, c->shape);
    block->slot_wall[lane] = near->wall_slot_fill[c->j]++;
    carry_history(job, c, &block->history, lane);
    c->lane = (int32_t)at;
}

/** Fill the lanes behind the last contact of each group with the padding rows of the grains. */
static void pad_pairs(near_job *job)
{
    const clod_near_blocks *pairs = &job->near->pairs;
    const int32_t far = (int32_t)job->state->grains.count;
    clod_contact_block *blocks = pairs->block;
    for (size_t q = 0; q < group_number(job->near); q++) {
        const size_t first = pairs->group_start[q] * CLOD_LANES + pairs->group_count[q];
        for (size_t at = first; at < pairs->group_start[q + 1] * CLOD_LANES; at++) {
            clod_contact_block *block = &blocks[at / CLOD_LANES];
            const int lane = (int)(at % CLOD_LANES);
            block->i[lane] = far;
            block->j[lane] = far + 1;
            history_put(&block->history, lane, (double[8]){0.0});
        }
    }
}

static void pad_walls(near_job *job)
{
    const clod_near_blocks *walls = &job->near->walls;
    clod_wall_block *blocks = walls->block;
    int32_t spare = job->near->wall_slot_start[job->state->walls.count];
    for (size_t q = 0; q < group_number(job->near); q++) {
        const size_t first = walls->group_start[q] * CLOD_LANES + walls->group_count[q];
        for (size_t at = first; at < walls->group_start[q + 1] * CLOD_LANES; at++) {
            clod_wall_block *block = &blocks[at / CLOD_LANES];
            const int lane = (int)(at % CLOD_LANES);
            block->i[lane] = (int32_t)job->state->grains.count;
            block->wall[lane] = 0;
            block->shape[lane] = clod_wall_rows_padding(job->walls, job->state->walls.count);
            block->slot_wall[lane] = spare++;
            history_put(&block->history, lane, (double[8]){0.0});
        }
    }
}

/** Arrays whose size follows from parts, laws and walls, which stay. */
static bool allocate(clod_near *self, const clod_state *state)
{
    const size_t walls = (size_t)state->walls.count;
    const size_t groups = group_number(self);
    self->part_start = clod_memory_alloc((size_t)self->parts + 1, sizeof(size_t));
    self->between.as_i = clod_memory_alloc(groups + 1, sizeof(size_t));
    self->between.as_j = clod_memory_alloc(groups + 1, sizeof(size_t));
    self->wall_slot_start = clod_memory_alloc(walls + 1, sizeof(int32_t));
    self->wall_slot_fill = clod_memory_alloc(walls + 1, sizeof(int32_t));
    bool good = self->part_start != NULL && self->between.as_i != NULL &&
                self->between.as_j != NULL && self->wall_slot_start != NULL &&
                self->wall_slot_fill != NULL;
    clod_near_blocks *lists[] = {&self->pairs, &self->walls};
    for (int k = 0; k < 2; k++) {
        lists[k]->group_start = clod_memory_alloc(groups + 1, sizeof(size_t));
        lists[k]->group_count = clod_memory_alloc(2 * groups, sizeof(size_t));
        good = good && lists[k]->group_start != NULL && lists[k]->group_count != NULL;
    }
    return good;
}

static bool prepare(clod_near *self, const clod_state *state, const clod_laws *laws)
{
    if (self->part_start == NULL) {
        self->laws = laws->count;
        if (!allocate(self, state)) {
            return false;
        }
    }
    return self->parts == 1 || reserve(&self->weight, &self->weight_capacity,
                                       state->grains.count, sizeof *self->weight);
}

static void mark_near(clod_neighbour *neighbour, const clod_state *state,
                      const clod_wall_rows *walls, double skin)
{
    for (size_t k = 0; k < neighbour->pairs.count; k++) {
        clod_candidate *c = &neighbour->pairs.item[k];
        c->near = pair_is_near(state, c, skin);
    }
    for (size_t k = 0; k < neighbour->walls.count; k++) {
        clod_candidate *c = &neighbour->walls.item[k];
        c->near = wall_is_near(state, c, walls, skin);
    }
}

/** Offsets of the walls' slots from their contacts. */
static bool layout_wall_slots(clod_near *self, const clod_neighbour *neighbour, int32_t walls)
{
    memset(self->wall_slot_start, 0, ((size_t)walls + 1) * sizeof(int32_t));
    for (size_t k = 0; k < neighbour->walls.count; k++) {
        const clod_candidate *c = &neighbour->walls.item[k];
        self->wall_slot_start[c->j + 1] += c->near;
    }
    for (int32_t w = 0; w < walls; w++) {
        self->wall_slot_start[w + 1] += self->wall_slot_start[w];
    }
    memcpy(self->wall_slot_fill, self->wall_slot_start, (size_t)walls * sizeof(int32_t));
    const size_t padding = group_number(self) * CLOD_LANES;
    return reserve(&self->wall_slots, &self->wall_slot_capacity,
                   (size_t)self->wall_slot_start[walls] + padding, sizeof *self->wall_slots);
}

static void place_all(clod_near *self, clod_neighbour *neighbour, const clod_state *state,
                      const clod_wall_rows *walls)
{
    const size_t groups = group_number(self);
    near_job job = {self, state, walls, self->pairs.group_count + groups};
    memset(job.fill, 0, groups * sizeof *job.fill);
    for (size_t k = 0; k < neighbour->pairs.count; k++) {
        clod_candidate *c = &neighbour->pairs.item[k];
        if (c->near != 0) {
            place_pair(&job, c);
        } else {
            c->lane = -1;
        }
    }
    pad_pairs(&job);
    job.fill = self->walls.group_count + groups;
    memset(job.fill, 0, groups * sizeof *job.fill);
    for (size_t k = 0; k < neighbour->walls.count; k++) {
        clod_candidate *c = &neighbour->walls.item[k];
        if (c->near != 0) {
            place_wall(&job, c);
        } else {
            c->lane = -1;
        }
    }
    pad_walls(&job);
}

bool clod_near_reserve_spent(clod_near *self)
{
    return !self->ledger || (reserve(&self->pairs.spent, &self->pairs.spent_capacity,
                                     self->pairs.count, sizeof *self->pairs.spent) &&
                             reserve(&self->walls.spent, &self->walls.spent_capacity,
                                     self->walls.count, sizeof *self->walls.spent));
}

/** Contacts between two parts, of all laws. */
static size_t between_count(const clod_near *self)
{
    size_t count = 0;
    for (int32_t l = 0; l < self->laws; l++) {
        count += self->pairs.group_count[clod_near_group(self, self->parts, l)];
    }
    return count;
}

bool clod_near_make(clod_near *self, clod_neighbour *neighbour, const clod_state *state,
                    const clod_laws *laws, const clod_wall_rows *walls, double skin,
                    clod_status *status)
{
    self->skin = skin;
    mark_near(neighbour, state, walls, skin);
    if (prepare(self, state, laws)) {
        const size_t groups = group_number(self);
        clod_near_cut(self, neighbour, state->grains.count);
        count_groups(self, &self->pairs, &neighbour->pairs);
        count_groups(self, &self->walls, &neighbour->walls);
        if (reserve_blocks(&self->pairs, groups, sizeof(clod_contact_block)) &&
            reserve_blocks(&self->walls, groups, sizeof(clod_wall_block)) &&
            layout_wall_slots(self, neighbour, state->walls.count) &&
            clod_near_reserve_spent(self)) {
            place_all(self, neighbour, state, walls);
            if (clod_neighbour_reserve_sort(neighbour, between_count(self)) &&
                clod_near_between_make(self, neighbour->sort, neighbour->sort_scratch)) {
                return true;
            }
        }
    }
    return clod_status_fail(status, CLOD_FAILED, "no memory for the contacts of %zu grains",
                            state->grains.count);
}

/** Append the history of a candidate if it has touched; its row, or -1. */
static int32_t export_one(clod_state *state, const clod_candidate *c,
                          const clod_history *history, int lane)
{
    if (history->tangent[lane] == 0.0) { // never touched
        return -1;
    }
    clod_contact *to = &state->contacts[state->contact_count];
    *to = (clod_contact){.i = c->i, .j = c->j, .shape = c->shape};
    history_get(history, lane, to->history);
    return (int32_t)state->contact_count++;
}

/** Room for as many contacts as the lists have lanes, and none in it; unchanged without memory.
 */
static bool reserve_contacts(const clod_near *self, clod_state *state)
{
    const size_t most = (self->pairs.count + self->walls.count) * CLOD_LANES;
    if (most > state->contact_capacity) {
        const size_t capacity = most + most / 8;
        void *fresh = clod_memory_alloc(capacity, sizeof *state->contacts);
        if (fresh == NULL) {
            return false;
        }
        clod_memory_free(state->contacts);
        state->contacts = fresh;
        state->contact_capacity = capacity;
    }
    state->contact_count = state->wall_contact_count = 0;
    return true;
}

bool clod_near_export(const clod_near *self, clod_neighbour *neighbour, clod_state *state,
                      bool leave, clod_status *status)
{
    if (!reserve_contacts(self, state)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the contacts of %zu grains",
                                state->grains.count);
    }
    const clod_contact_block *pairs = self->pairs.block;
    for (size_t k = 0; k < neighbour->pairs.count; k++) { // candidates ascend: no sorting
        clod_candidate *c = &neighbour->pairs.item[k];
        if (c->lane >= 0) {
            const int32_t row = export_one(state, c, &pairs[c->lane / CLOD_LANES].history,
                                           c->lane % CLOD_LANES);
            c->lane = leave ? row : c->lane;
        }
    }
    const size_t before = state->contact_count;
    const clod_wall_block *walls = self->walls.block;
    for (size_t k = 0; k < neighbour->walls.count; k++) {
        clod_candidate *c = &neighbour->walls.item[k];
        if (c->lane >= 0) {
            const int32_t row = export_one(state, c, &walls[c->lane / CLOD_LANES].history,
                                           c->lane % CLOD_LANES);
            c->lane = leave ? row : c->lane;
        }
    }
    state->wall_contact_count = state->contact_count - before;
    return true;
}

void clod_near_fini(clod_near *self)
{
    clod_memory_free(self->pairs.block);
    clod_memory_free(self->pairs.group_start);
    clod_memory_free(self->pairs.group_count);
    clod_memory_free(self->pairs.spent);
    clod_memory_free(self->walls.spent);
    clod_memory_free(self->walls.block);
    clod_memory_free(self->walls.group_start);
    clod_memory_free(self->walls.group_count);
    clod_memory_free(self->between.share);
    clod_memory_free(self->between.by_later);
    clod_memory_free(self->between.as_i);
    clod_memory_free(self->between.as_j);
    clod_memory_free(self->part_start);
    clod_memory_free(self->weight);
    clod_memory_free(self->wall_slot_start);
    clod_memory_free(self->wall_slot_fill);
    clod_memory_free(self->wall_slots);
    *self = (clod_near){0};
}
