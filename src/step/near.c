#include "step/near.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"
#include "parallel/threads.h"
#include "step/near_between.h"
#include "step/near_known.h"
#include "step/near_parts.h"
#include "step/near_skins.h"
#include "step/near_walk.h"
#include "step/near_walls.h"
#include "step/touch.h"
#include "step/wall_mesh.h"

// ---- which candidates are near

/** By what rounding may be wrong: a distance in double, as a part of the radius; */
#define ROUNDING 1e-9
/** an origin and an own skin in float, both at most half of the wide skin, as a part of that. */
#define FLOAT_ROUNDING 1e-7

static bool wall_is_near(const clod_near_job *job, const clod_wall_candidate *c)
{
    double p[3];
    const double range = clod_near_middle(job, (size_t)c->i, p);
    const double reach = job->state->grains.position[c->i][3] + range + job->skins.wall;
    return clod_wall_rows_patch(job->walls, c->wall, c->shape)->surface != NULL
               ? clod_wall_mesh_mark(&job->neighbour->walls, c, job->walls, p, reach)
               : clod_wall_rows_is_near(job->walls, c->wall, c->shape, p, reach);
}

/** Add work to a grain's: several threads may, and the sum does not depend on their order. */
static void add_work(const clod_near_job *job, size_t grain, int32_t work)
{
    if (job->near->parts > 1) {
        __atomic_fetch_add(&job->near->weight[grain], work, __ATOMIC_RELAXED);
    }
}

static clod_kernel_courses courses_of(const clod_near_job *job)
{
    clod_kernel_courses courses = {.position = (const double(*)[4])job->state->grains.position,
                                   .course = (const float(*)[4])job->near->course,
                                   .horizon = job->near->follow ? job->skins.horizon : 0.0};
    const clod_domain *domain = &job->state->domain;
    for (int a = 0; a < 3; a++) {
        if (domain->periodic[a]) {
            courses.period[a] = domain->max[a] - domain->min[a];
            courses.inverse_period[a] = 1.0 / courses.period[a];
        }
    }
    return courses;
}

/** Pairs that are looked at together. */
#define TOGETHER 64

/** Candidates [first, first + count) of the pairs. */
static void mark_some(const clod_near_job *job, const clod_kernel_courses *courses,
                      const int32_t *i, const int32_t *j, size_t first, size_t count)
{
    clod_partner *item = job->neighbour->pairs.item + first;
    const uint64_t near = job->neighbour->kernel->can_touch(courses, i, j, count);
    for (size_t k = 0; k < count; k++) {
        item[k].near = (near >> k) & 1;
    }
    for (uint64_t left = job->near->parts > 1 ? near : 0; left != 0; left &= left - 1) {
        add_work(job, (size_t)j[__builtin_ctzll(left)], CLOD_NEAR_PAIR_WORK);
    }
}

static void mark_pairs(const clod_near_job *job, clod_chunk rows)
{
    const clod_kernel_courses courses = courses_of(job);
    const clod_pairs *pairs = &job->neighbour->pairs;
    int32_t i[TOGETHER] = {0}, j[TOGETHER] = {0};
    size_t count = 0, next = pairs->start[rows.begin];
    for (size_t row = rows.begin; row < rows.end; row++) {
        for (; next < pairs->start[row + 1]; next++) {
            i[count] = (int32_t)row;
            j[count++] = (int32_t)pairs->item[next].j;
            if (count == TOGETHER) {
                mark_some(job, &courses, i, j, next + 1 - count, count);
                count = 0;
            }
        }
    }
    if (count > 0) { // a bed may have no candidates, and no room for any
        mark_some(job, &courses, i, j, next - count, count);
    }
}

void clod_near_mark(const clod_near_job *job, int part)
{
    const int parts = job->near->parts;
    mark_pairs(job, clod_threads_chunk(job->state->grains.count, part, parts));
    const clod_wall_candidates *walls = &job->neighbour->walls;
    const clod_chunk items = clod_threads_chunk(walls->count, part, parts);
    for (size_t k = items.begin; k < items.end; k++) {
        clod_wall_candidate *c = &walls->item[k];
        c->near = wall_is_near(job, c);
        if (c->near != 0) {
            add_work(job, (size_t)c->i, CLOD_NEAR_WALL_WORK);
        }
    }
}

// ---- where the pairs go

/** The first block of each group from the numbers of its contacts. */
void clod_near_layout_groups(clod_near_blocks *blocks, size_t groups)
{
    blocks->group_start[0] = 0;
    for (size_t q = 0; q < groups; q++) {
        blocks->group_start[q + 1] =
            blocks->group_start[q] + (blocks->group_count[q] + CLOD_LANES - 1) / CLOD_LANES;
    }
}

/** Room for the blocks of all groups. */
bool clod_near_reserve_blocks(clod_near_blocks *self, size_t groups, size_t size)
{
    self->count = self->group_start[groups];
    return clod_room_for(&self->block, &self->capacity, self->count, size);
}

/** Where the next pair of a part goes in each group; [groups]. */
static size_t *fill_of(const clod_near *self, int part)
{
    return self->part_fill + (size_t)part * clod_near_groups(self);
}

void clod_near_count(const clod_near_job *job, int part)
{
    size_t *count = fill_of(job->near, part);
    memset(count, 0, clod_near_groups(job->near) * sizeof *count);
    clod_near_walk walk = clod_near_walk_begin(job, part);
    while (clod_near_walk_on(&walk)) {
        count[walk.group]++;
    }
    clod_near_walls_count(job, part);
}

/** Numbers of pairs in each group, and where those of each part begin: they ascend by part. */
static void sum_groups(clod_near *self)
{
    const size_t groups = clod_near_groups(self);
    for (size_t q = 0; q < groups; q++) {
        size_t sum = 0;
        for (int p = 0; p < self->parts; p++) {
            size_t *at = &fill_of(self, p)[q];
            const size_t count = *at;
            *at = sum;
            sum += count;
        }
        self->pairs.group_count[q] = sum;
    }
    clod_near_layout_groups(&self->pairs, groups);
}

bool clod_near_layout(const clod_near_job *job, clod_status *status)
{
    clod_near *self = job->near;
    sum_groups(self);
    if (clod_near_reserve_blocks(&self->pairs, clod_near_groups(self),
                                 sizeof(clod_contact_block)) &&
        clod_near_walls_layout(job) && clod_near_reserve_dissipated(self) &&
        clod_near_between_reserve(self)) {
        return true;
    }
    return clod_status_fail(status, CLOD_FAILED, "no memory for the contacts of %zu grains",
                            job->state->grains.count);
}

/** The near pairs of a part into blocks, with the histories of those that touch. */
static void place_pairs(const clod_near_job *job, int part)
{
    const clod_near *near = job->near;
    clod_contact_block *blocks = near->pairs.block;
    const clod_state *state = job->state;
    const size_t size = sizeof *state->contacts, page = CLOD_MEMORY_HUGE_PAGE;
    const size_t room = state->contact_capacity * size;
    size_t *fill = fill_of(near, part);
    clod_near_walk walk = clod_near_walk_begin(job, part);
    const size_t pairs = state->contact_count - state->wall_contact_count;
    clod_near_known known =
        clod_near_known_of(state->contacts, 0, pairs, &near->part_start[part]);
    size_t next = known.next + CLOD_NEAR_GIVE_BACK;
    size_t given = (known.next * size + page - 1) / page * page;
    while (clod_near_walk_on(&walk)) {
        const size_t at = near->pairs.group_start[walk.group] * CLOD_LANES + fill[walk.group]++;
        clod_contact_block *block = &blocks[at / CLOD_LANES];
        const int lane = (int)(at % CLOD_LANES);
        block->i[lane] = walk.i;
        block->j[lane] = walk.j;
        clod_history_put(&block->history, lane, clod_near_history(&known, walk.i, walk.j, -1));
        if (known.next >= next) {
            given = clod_near_give_back(state->contacts, room, given, known.next * size);
            next += CLOD_NEAR_GIVE_BACK;
        }
    }
}

/** Fill the lanes behind the last contact of a group with the padding rows of the grains. */
static void pad_group(const clod_near_job *job, size_t group)
{
    const clod_near_blocks *pairs = &job->near->pairs;
    const int32_t far = (int32_t)job->state->grains.count;
    clod_contact_block *blocks = pairs->block;
    const size_t first = pairs->group_start[group] * CLOD_LANES + pairs->group_count[group];
    for (size_t at = first; at < pairs->group_start[group + 1] * CLOD_LANES; at++) {
        clod_contact_block *block = &blocks[at / CLOD_LANES];
        const int lane = (int)(at % CLOD_LANES);
        block->i[lane] = far;
        block->j[lane] = far + 1;
        clod_history_put(&block->history, lane, CLOD_NEAR_NO_HISTORY);
    }
}

void clod_near_place(const clod_near_job *job, int part)
{
    place_pairs(job, part);
    clod_near_walls_place(job, part);
    for (int32_t law = 0; law < job->near->laws; law++) {
        pad_group(job, clod_near_group(job->near, part, law));
        pad_group(job, clod_near_group_between(job->near, part, law));
    }
    clod_touch_find(job->near, job->state, job->walls,
                    part); // for those who look before a step
}

// ---- once for all

/** Arrays whose size follows from parts and laws, which stay. */
static bool allocate(clod_near *self)
{
    const size_t groups = clod_near_groups(self);
    const size_t parts = (size_t)self->parts;
    self->part_start = clod_memory_alloc(parts + 1, sizeof(size_t));
    self->between.run_start = clod_memory_alloc(groups + 1, sizeof(size_t));
    self->source = clod_memory_alloc(parts * clod_near_sources(self), sizeof *self->source);
    self->part_fill = clod_memory_alloc(parts * groups, sizeof *self->part_fill);
    self->gathered = clod_memory_alloc(parts, sizeof *self->gathered);
    self->touch.part = clod_memory_alloc(parts, sizeof *self->touch.part);
    bool good = self->touch.part != NULL && self->part_start != NULL &&
                self->between.run_start != NULL && self->source != NULL &&
                self->part_fill != NULL && self->gathered != NULL;
    clod_near_blocks *lists[] = {&self->pairs, &self->walls};
    for (int k = 0; k < 2; k++) {
        const size_t count = k == 0 ? groups : clod_near_wall_groups(self);
        lists[k]->group_start = clod_memory_alloc(count + 1, sizeof(size_t));
        lists[k]->group_count = clod_memory_alloc(2 * count, sizeof(size_t));
        good = good && lists[k]->group_start != NULL && lists[k]->group_count != NULL;
    }
    return good;
}

static size_t watches_of(const clod_near_job *job)
{
    return clod_near_watches(job->state->grains.count, (size_t)job->near->parts + job->runs);
}

/** Room for what follows from the numbers of grains and walls. */
static bool reserve(const clod_near_job *job)
{
    clod_near *self = job->near;
    const size_t walls = (size_t)job->state->walls.count;
    return clod_room_for(&self->origin, &self->origin_capacity, job->state->grains.count,
                         sizeof *self->origin) &&
           clod_room_for(&self->course, &self->course_capacity, job->state->grains.count,
                         sizeof *self->course) &&
           clod_room_for(&self->watch, &self->watch_capacity, watches_of(job),
                         sizeof *self->watch) &&
           clod_room_for(&self->passage, &self->passage_capacity,
                         watches_of(job) * (size_t)job->state->planes.count,
                         sizeof *self->passage) &&
           clod_room_for(&self->sum_start, &self->sum_start_capacity, walls + 1,
                         sizeof *self->sum_start) &&
           clod_room_for(&self->part_sum, &self->part_sum_capacity,
                         (size_t)self->parts * walls + 1, sizeof *self->part_sum) &&
           (self->parts == 1 || clod_room_for(&self->weight, &self->weight_capacity,
                                              job->state->grains.count, sizeof *self->weight));
}

bool clod_near_begin(const clod_near_job *job, clod_status *status)
{
    clod_near *self = job->near;
    self->wall_skin = job->skins.wall;
    self->rounding = ROUNDING * job->skins.largest + FLOAT_ROUNDING * job->neighbour->skin;
    self->follow = job->skins.follow;
    self->horizon = job->skins.horizon;
    self->made = false;
    bool good = self->part_start != NULL;
    if (!good) {
        self->laws = job->laws->count;
        good = allocate(self);
    }
    if (!good || !reserve(job)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the contacts of %zu grains",
                                job->state->grains.count);
    }
    for (size_t g = 0; self->parts > 1 && g < job->state->grains.count; g++) {
        self->weight[g] = CLOD_NEAR_GRAIN_WORK;
    }
    return true;
}

void clod_near_end(const clod_near_job *job)
{
    clod_state *state = job->state;
    const size_t room = state->contact_capacity * sizeof *state->contacts;
    clod_near_give_back(state->contacts, room, 0, room);
    state->contact_count = state->wall_contact_count = 0;
    clod_near_between_make(job->near);
    memset(job->near->watch, 0, watches_of(job) * sizeof *job->near->watch); // look at all soon
    job->near->made = true;
}

bool clod_near_reserve_dissipated(clod_near *self)
{
    if (self->wear && !clod_room_for(&self->walls.rub, &self->walls.rub_capacity,
                                     self->walls.count, sizeof *self->walls.rub)) {
        return false;
    }
    return !self->ledger ||
           (clod_room_for(&self->pairs.dissipated, &self->pairs.dissipated_capacity,
                          self->pairs.count, sizeof *self->pairs.dissipated) &&
            clod_room_for(&self->walls.dissipated, &self->walls.dissipated_capacity,
                          self->walls.count, sizeof *self->walls.dissipated));
}

void clod_near_give_skins_back(clod_near *self)
{
    const size_t origins = self->origin_capacity * sizeof *self->origin;
    clod_memory_give_back(self->origin, origins, origins);
    const size_t courses = self->course_capacity * sizeof *self->course;
    clod_memory_give_back(self->course, courses, courses);
}

bool clod_near_make(const clod_near_job *job, clod_status *status)
{
    if (!clod_near_begin(job, status)) {
        return false;
    }
    const int parts = job->near->parts;
    for (int p = 0; p < parts; p++) {
        clod_near_choose_skins(job, p);
    }
    for (int p = 0; p < parts; p++) {
        clod_near_mark(job, p);
    }
    clod_near_cut(job);
    for (int p = 0; p < parts; p++) {
        clod_near_count(job, p);
    }
    if (!clod_near_layout(job, status)) {
        return false;
    }
    for (int p = 0; p < parts; p++) {
        clod_near_place(job, p);
    }
    for (int p = 0; p < parts; p++) {
        clod_near_note(job, p);
    }
    clod_near_end(job);
    return true;
}

void clod_near_fini(clod_near *self)
{
    clod_memory_free(self->pairs.block);
    clod_memory_free(self->pairs.group_start);
    clod_memory_free(self->pairs.group_count);
    clod_memory_free(self->pairs.dissipated);
    clod_memory_free(self->walls.dissipated);
    clod_memory_free(self->walls.rub);
    clod_memory_free(self->walls.block);
    clod_memory_free(self->walls.group_start);
    clod_memory_free(self->walls.group_count);
    clod_memory_free(self->between.share);
    clod_memory_free(self->between.run);
    clod_memory_free(self->between.run_start);
    clod_memory_free(self->part_start);
    clod_memory_free(self->origin);
    clod_memory_free(self->course);
    clod_memory_free(self->watch);
    clod_memory_free(self->passage);
    clod_memory_free(self->weight);
    clod_memory_free(self->wall_sum);
    clod_memory_free(self->sum_start);
    clod_memory_free(self->part_sum);
    clod_memory_free(self->source);
    clod_memory_free(self->part_fill);
    clod_memory_free(self->gathered);
    clod_touch_fini(&self->touch, self->parts);
    *self = (clod_near){0};
}
