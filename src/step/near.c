#include "step/near.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "step/near_between.h"
#include "step/near_parts.h"
#include "step/near_walk.h"
#include "step/room.h"

/** What goes through the making of one list. */
typedef struct near_job {
    clod_near *near;
    clod_state *state;
    const clod_laws *laws;
    const clod_wall_rows *walls;
} near_job;

static const double NO_HISTORY[CLOD_HISTORY_NUMBERS] = {0.0};

static bool pair_is_near(const clod_state *state, size_t i, size_t j, double skin)
{
    const double *a = state->grains.place[i];
    const double *b = state->grains.place[j];
    const double x = clod_domain_separation(&state->domain, 0, a[0], b[0]);
    const double y = clod_domain_separation(&state->domain, 1, a[1], b[1]);
    const double z = clod_domain_separation(&state->domain, 2, a[2], b[2]);
    const double reach = a[3] + b[3] + skin;
    return x * x + y * y + z * z < reach * reach;
}

static bool wall_is_near(const clod_state *state, const clod_wall_candidate *c,
                         const clod_wall_rows *walls, double skin)
{
    const double *p = state->grains.place[c->i];
    return clod_wall_rows_gap(walls, c->wall, c->shape, p).distance < p[3] + skin;
}

/** Group of a wall contact. */
static size_t wall_group(const clod_near *self, const clod_wall_candidate *c)
{
    return clod_near_group(self, clod_near_part_of(self, c->i), c->law);
}

/** The first block of each group from the numbers of its contacts. */
static void layout_groups(clod_near_blocks *blocks, size_t groups)
{
    blocks->group_start[0] = 0;
    for (size_t q = 0; q < groups; q++) {
        blocks->group_start[q + 1] =
            blocks->group_start[q] + (blocks->group_count[q] + CLOD_LANES - 1) / CLOD_LANES;
    }
}

/** Count near pairs by group. */
static void count_pairs(const near_job *job, const clod_pairs *pairs)
{
    clod_near_blocks *blocks = &job->near->pairs;
    const size_t groups = clod_near_groups(job->near);
    memset(blocks->group_count, 0, groups * sizeof *blocks->group_count);
    clod_near_walk walk = clod_near_walk_begin(job->near, pairs, job->state, job->laws);
    while (clod_near_walk_on(&walk)) {
        blocks->group_count[walk.group]++;
    }
    layout_groups(blocks, groups);
}

/** Count near grains at walls by group. */
static void count_walls(const near_job *job, const clod_wall_candidates *candidates)
{
    clod_near_blocks *blocks = &job->near->walls;
    const size_t groups = clod_near_groups(job->near);
    memset(blocks->group_count, 0, groups * sizeof *blocks->group_count);
    for (size_t k = 0; k < candidates->count; k++) {
        if (candidates->item[k].near != 0) {
            blocks->group_count[wall_group(job->near, &candidates->item[k])]++;
        }
    }
    layout_groups(blocks, groups);
}

/** Room for the blocks of all groups. */
static bool reserve_blocks(clod_near_blocks *self, size_t groups, size_t size)
{
    self->count = self->group_start[groups];
    return clod_room_for(&self->block, &self->capacity, self->count, size);
}

/** Contacts of the state's list as a list that ascends as they do goes along beside them. */
typedef struct known_contacts {
    const clod_contact *item;
    size_t next, end;
} known_contacts;

/** History of the contact (i, j, shape), or none; contacts before it are not asked for again.
 */
static const double *history_of(known_contacts *known, int32_t i, int32_t j, int32_t shape)
{
    const clod_contact wanted = {.i = i, .j = j, .shape = shape};
    for (; known->next < known->end; known->next++) {
        const int order = clod_contact_compare(&known->item[known->next], &wanted);
        if (order >= 0) {
            return order == 0 ? known->item[known->next].history : NO_HISTORY;
        }
    }
    return NO_HISTORY;
}

/** Near pairs into blocks, with the histories of those contacts that are there. */
static void place_pairs(near_job *job, const clod_pairs *pairs)
{
    clod_contact_block *blocks = job->near->pairs.block;
    const clod_state *state = job->state;
    clod_near_walk walk = clod_near_walk_begin(job->near, pairs, state, job->laws);
    const size_t room = state->contact_capacity * sizeof *state->contacts;
    known_contacts known = {state->contacts, 0,
                            state->contact_count - state->wall_contact_count};
    size_t next = CLOD_NEAR_GIVE_BACK, given = 0;
    while (clod_near_walk_on(&walk)) {
        const size_t at = clod_near_walk_lane(&walk);
        clod_contact_block *block = &blocks[at / CLOD_LANES];
        const int lane = (int)(at % CLOD_LANES);
        block->i[lane] = walk.i;
        block->j[lane] = walk.j;
        clod_history_put(&block->history, lane, history_of(&known, walk.i, walk.j, -1));
        if (known.next >= next) {
            const size_t read = known.next * sizeof *state->contacts;
            given = clod_near_give_back(state->contacts, room, given, read);
            next += CLOD_NEAR_GIVE_BACK;
        }
    }
}

static void place_wall(near_job *job, const clod_wall_candidate *c, size_t *fill,
                       known_contacts *known)
{
    clod_near *near = job->near;
    clod_wall_block *blocks = near->walls.block;
    const size_t group = wall_group(near, c);
    const size_t at = near->walls.group_start[group] * CLOD_LANES + fill[group]++;
    clod_wall_block *block = &blocks[at / CLOD_LANES];
    const int lane = (int)(at % CLOD_LANES);
    block->i[lane] = c->i;
    block->wall[lane] = CLOD_WALL_ROWS * c->wall;
    block->shape[lane] = clod_wall_rows_shape(job->walls, c->wall, c->shape);
    block->slot_wall[lane] = near->wall_slot_fill[c->wall]++;
    clod_history_put(&block->history, lane, history_of(known, c->i, c->wall, c->shape));
}

static void place_walls(near_job *job, const clod_wall_candidates *candidates)
{
    const clod_state *state = job->state;
    const size_t groups = clod_near_groups(job->near);
    size_t *fill = job->near->walls.group_count + groups;
    memset(fill, 0, groups * sizeof *fill);
    known_contacts known = {state->contacts, state->contact_count - state->wall_contact_count,
                            state->contact_count};
    for (size_t k = 0; k < candidates->count; k++) {
        const clod_wall_candidate *c = &candidates->item[k];
        if (c->near != 0) {
            place_wall(job, c, fill, &known);
        }
    }
}

/** Fill the lanes behind the last contact of each group with the padding rows of the grains. */
static void pad_pairs(near_job *job)
{
    const clod_near_blocks *pairs = &job->near->pairs;
    const int32_t far = (int32_t)job->state->grains.count;
    clod_contact_block *blocks = pairs->block;
    for (size_t q = 0; q < clod_near_groups(job->near); q++) {
        const size_t first = pairs->group_start[q] * CLOD_LANES + pairs->group_count[q];
        for (size_t at = first; at < pairs->group_start[q + 1] * CLOD_LANES; at++) {
            clod_contact_block *block = &blocks[at / CLOD_LANES];
            const int lane = (int)(at % CLOD_LANES);
            block->i[lane] = far;
            block->j[lane] = far + 1;
            clod_history_put(&block->history, lane, NO_HISTORY);
        }
    }
}

static void pad_walls(near_job *job)
{
    const clod_near_blocks *walls = &job->near->walls;
    clod_wall_block *blocks = walls->block;
    int32_t spare = job->near->wall_slot_start[job->state->walls.count];
    for (size_t q = 0; q < clod_near_groups(job->near); q++) {
        const size_t first = walls->group_start[q] * CLOD_LANES + walls->group_count[q];
        for (size_t at = first; at < walls->group_start[q + 1] * CLOD_LANES; at++) {
            clod_wall_block *block = &blocks[at / CLOD_LANES];
            const int lane = (int)(at % CLOD_LANES);
            block->i[lane] = (int32_t)job->state->grains.count;
            block->wall[lane] = 0;
            block->shape[lane] = clod_wall_rows_padding(job->walls, job->state->walls.count);
            block->slot_wall[lane] = spare++;
            clod_history_put(&block->history, lane, NO_HISTORY);
        }
    }
}

/** Arrays whose size follows from parts and laws, which stay. */
static bool allocate(clod_near *self)
{
    const size_t groups = clod_near_groups(self);
    self->part_start = clod_memory_alloc((size_t)self->parts + 1, sizeof(size_t));
    self->between.run_start = clod_memory_alloc(groups + 1, sizeof(size_t));
    self->source = clod_memory_alloc(groups, sizeof *self->source);
    bool good =
        self->part_start != NULL && self->between.run_start != NULL && self->source != NULL;
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
        if (!allocate(self)) {
            return false;
        }
    }
    const size_t walls = (size_t)state->walls.count + 1;
    if (!clod_room_for(&self->wall_slot_start, &self->wall_start_capacity, walls,
                       sizeof *self->wall_slot_start) ||
        !clod_room_for(&self->wall_slot_fill, &self->wall_fill_capacity, walls,
                       sizeof *self->wall_slot_fill)) {
        return false;
    }
    return self->parts == 1 || clod_room_for(&self->weight, &self->weight_capacity,
                                             state->grains.count, sizeof *self->weight);
}

static void mark_near(clod_neighbour *neighbour, const clod_state *state,
                      const clod_wall_rows *walls, double skin)
{
    const clod_pairs *pairs = &neighbour->pairs;
    for (size_t i = 0; i < state->grains.count; i++) {
        for (size_t k = pairs->start[i]; k < pairs->start[i + 1]; k++) {
            pairs->item[k].near = pair_is_near(state, i, pairs->item[k].j, skin);
        }
    }
    for (size_t k = 0; k < neighbour->walls.count; k++) {
        clod_wall_candidate *c = &neighbour->walls.item[k];
        c->near = wall_is_near(state, c, walls, skin);
    }
}

/** Offsets of the walls' slots from their contacts. */
static bool layout_wall_slots(clod_near *self, const clod_neighbour *neighbour, int32_t walls)
{
    memset(self->wall_slot_start, 0, ((size_t)walls + 1) * sizeof(int32_t));
    for (size_t k = 0; k < neighbour->walls.count; k++) {
        const clod_wall_candidate *c = &neighbour->walls.item[k];
        self->wall_slot_start[c->wall + 1] += c->near;
    }
    for (int32_t w = 0; w < walls; w++) {
        self->wall_slot_start[w + 1] += self->wall_slot_start[w];
    }
    memcpy(self->wall_slot_fill, self->wall_slot_start, (size_t)walls * sizeof(int32_t));
    const size_t padding = clod_near_groups(self) * CLOD_LANES;
    return clod_room_for(&self->wall_slots, &self->wall_slot_capacity,
                         (size_t)self->wall_slot_start[walls] + padding,
                         sizeof *self->wall_slots);
}

/** All contacts into blocks; the state's list is empty then. */
static void place_all(near_job *job, clod_neighbour *neighbour)
{
    place_walls(job, &neighbour->walls); // first: pairs give the contacts back as they go
    pad_walls(job);
    place_pairs(job, &neighbour->pairs);
    pad_pairs(job);
    clod_state *state = job->state;
    const size_t room = state->contact_capacity * sizeof *state->contacts;
    clod_near_give_back(state->contacts, room, 0, room);
    state->contact_count = state->wall_contact_count = 0;
}

bool clod_near_reserve_spent(clod_near *self)
{
    return !self->ledger || (clod_room_for(&self->pairs.spent, &self->pairs.spent_capacity,
                                           self->pairs.count, sizeof *self->pairs.spent) &&
                             clod_room_for(&self->walls.spent, &self->walls.spent_capacity,
                                           self->walls.count, sizeof *self->walls.spent));
}

bool clod_near_make(clod_near *self, clod_neighbour *neighbour, clod_state *state,
                    const clod_laws *laws, const clod_wall_rows *walls, double skin,
                    clod_status *status)
{
    self->skin = skin;
    self->made = false;
    mark_near(neighbour, state, walls, skin);
    if (prepare(self, state, laws)) {
        near_job job = {self, state, laws, walls};
        const size_t groups = clod_near_groups(self);
        clod_near_cut(self, neighbour, state->grains.count);
        count_pairs(&job, &neighbour->pairs);
        count_walls(&job, &neighbour->walls);
        if (reserve_blocks(&self->pairs, groups, sizeof(clod_contact_block)) &&
            reserve_blocks(&self->walls, groups, sizeof(clod_wall_block)) &&
            layout_wall_slots(self, neighbour, state->walls.count) &&
            clod_near_reserve_spent(self) && clod_near_between_reserve(self)) {
            place_all(&job, neighbour);
            clod_near_between_make(self);
            clod_neighbour_give_back(neighbour);
            self->made = true;
            return true;
        }
    }
    return clod_status_fail(status, CLOD_FAILED, "no memory for the contacts of %zu grains",
                            state->grains.count);
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
    clod_memory_free(self->between.run);
    clod_memory_free(self->between.run_start);
    clod_memory_free(self->part_start);
    clod_memory_free(self->weight);
    clod_memory_free(self->wall_slot_start);
    clod_memory_free(self->wall_slot_fill);
    clod_memory_free(self->wall_slots);
    clod_memory_free(self->source);
    *self = (clod_near){0};
}
