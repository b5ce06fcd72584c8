// The near list's contacts with walls: each part's by the thread of that part.
#include "step/near_walls.h"

#include <string.h>

#include "base/lower_bound.h"
#include "base/room.h"
#include "step/near_known.h"
#include "step/near_parts.h"
#include "step/touch.h"

static clod_wall_form form_of(const clod_near_job *job, const clod_wall_candidate *c)
{
    return clod_wall_rows_form(job->walls, clod_wall_rows_shape(job->walls, c->wall, c->shape));
}

/** Group of a wall contact of a part. */
static size_t group_of(const clod_near_job *job, int part, const clod_wall_candidate *c)
{
    return clod_near_wall_group(job->near, part, c->law, form_of(job, c));
}

/** The first of the candidates, which ascend by grain, whose grain is not before a row. */
static size_t first_from(const clod_wall_candidates *candidates, size_t row)
{
    clod_lower_bound in = {0, candidates->count};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        clod_lower_bound_halve(&in, (size_t)candidates->item[middle].i < row);
    }
    return in.low;
}

/** A part's numbers of its sums, by wall; until the layout numbers of its contacts. */
static int32_t *sums_of(const clod_near_job *job, int part)
{
    return job->near->part_sum + (size_t)part * (size_t)job->state->walls.count;
}

void clod_near_walls_count(const clod_near_job *job, int part)
{
    clod_near *near = job->near;
    const clod_wall_candidates *candidates = &job->neighbour->walls;
    const size_t first = clod_near_wall_group(near, part, 0, (clod_wall_form)0);
    const size_t groups = clod_near_wall_group(near, part + 1, 0, (clod_wall_form)0) - first;
    memset(near->walls.group_count + first, 0, groups * sizeof *near->walls.group_count);
    int32_t *sum = sums_of(job, part);
    for (int32_t w = 0; w < job->state->walls.count; w++) {
        sum[w] = -1;
    }
    clod_touch_begin(&near->touch.part[part]);
    const size_t end = first_from(candidates, near->part_start[part + 1]);
    for (size_t k = first_from(candidates, near->part_start[part]); k < end; k++) {
        const clod_wall_candidate *c = &candidates->item[k];
        if (c->near != 0) {
            near->walls.group_count[group_of(job, part, c)]++;
            sum[c->wall] = sum[c->wall] < 0 ? 1 : sum[c->wall] + 1;
            if (form_of(job, c) == CLOD_FORM_MESH) {
                clod_touch_add(job, part, c);
            }
        }
    }
}

/** A sum for each wall and part that has it, those of a wall side by side. */
static bool layout_sums(const clod_near_job *job)
{
    clod_near *near = job->near;
    const int32_t walls = job->state->walls.count;
    int32_t sums = 0;
    near->crowded = false;
    for (int32_t w = 0; w < walls; w++) {
        near->sum_start[w] = sums;
        for (int p = 0; p < near->parts; p++) {
            int32_t *sum = &sums_of(job, p)[w];
            near->crowded = near->crowded || *sum > CLOD_FIXED_ADDENDS;
            *sum = *sum < 0 ? -1 : sums++;
        }
    }
    near->sum_start[walls] = sums;
    if (!clod_room_for(&near->wall_sum, &near->wall_sum_capacity, (size_t)sums + 1,
                       sizeof *near->wall_sum)) {
        return false;
    }
    memset(near->wall_sum, 0, (size_t)sums * sizeof *near->wall_sum);
    return true;
}

bool clod_near_walls_layout(const clod_near_job *job)
{
    clod_near_blocks *walls = &job->near->walls;
    const size_t groups = clod_near_wall_groups(job->near);
    clod_near_layout_groups(walls, groups);
    return clod_near_reserve_blocks(walls, groups, sizeof(clod_wall_block)) &&
           clod_touch_layout(job->near) && layout_sums(job);
}

static void place(const clod_near_job *job, int part, const clod_wall_candidate *c,
                  clod_near_known *known)
{
    clod_near_blocks *walls = &job->near->walls;
    const size_t group = group_of(job, part, c);
    size_t *fill = walls->group_count + clod_near_wall_groups(job->near);
    const size_t at = walls->group_start[group] * CLOD_LANES + fill[group]++;
    clod_wall_block *block = (clod_wall_block *)walls->block + at / CLOD_LANES;
    const int lane = (int)(at % CLOD_LANES);
    block->i[lane] = c->i;
    block->wall[lane] = c->wall;
    block->shape[lane] = clod_wall_rows_shape(job->walls, c->wall, c->shape);
    block->sum[lane] = sums_of(job, part)[c->wall];
    block->touch[lane] = form_of(job, c) == CLOD_FORM_MESH
                             ? clod_touch_place(job->near, part, at / CLOD_LANES, lane)
                             : 0;
    clod_history_put(&block->history, lane, clod_near_history(known, c->i, c->wall, c->shape));
}

/** Fill the lanes behind the last contact of a group. */
static void pad(const clod_near_job *job, size_t group)
{
    const clod_near_blocks *walls = &job->near->walls;
    const clod_wall_form form = (clod_wall_form)(group % CLOD_FORMS);
    const size_t first = walls->group_start[group] * CLOD_LANES + walls->group_count[group];
    for (size_t at = first; at < walls->group_start[group + 1] * CLOD_LANES; at++) {
        clod_wall_block *block = (clod_wall_block *)walls->block + at / CLOD_LANES;
        const int lane = (int)(at % CLOD_LANES);
        block->i[lane] = (int32_t)job->state->grains.count;
        block->wall[lane] = 0;
        block->shape[lane] = clod_wall_rows_padding(job->walls, job->state->walls.count, form);
        block->sum[lane] = 0; // never added to
        block->touch[lane] = 0;
        clod_history_put(&block->history, lane, CLOD_NEAR_NO_HISTORY);
    }
}

void clod_near_walls_place(const clod_near_job *job, int part)
{
    const clod_near *near = job->near;
    const clod_state *state = job->state;
    const clod_wall_candidates *candidates = &job->neighbour->walls;
    const size_t groups = clod_near_wall_groups(near);
    const size_t begin = clod_near_wall_group(near, part, 0, (clod_wall_form)0);
    const size_t end = clod_near_wall_group(near, part + 1, 0, (clod_wall_form)0);
    memset(near->walls.group_count + groups + begin, 0,
           (end - begin) * sizeof *near->walls.group_count);
    const size_t *rows = &near->part_start[part];
    const size_t pairs = state->contact_count - state->wall_contact_count;
    clod_near_known known =
        clod_near_known_of(state->contacts, pairs, state->contact_count, rows);
    const size_t last = first_from(candidates, rows[1]);
    for (size_t k = first_from(candidates, rows[0]); k < last; k++) {
        if (candidates->item[k].near != 0) {
            place(job, part, &candidates->item[k], &known);
        }
    }
    for (size_t group = begin; group < end; group++) {
        pad(job, group);
    }
}
