// The near list's contacts with walls: few beside those between grains, by one thread.
#include "step/near_walls.h"

#include <string.h>

#include "step/near_known.h"
#include "step/near_parts.h"
#include "step/room.h"

/** Group of a wall contact. */
static size_t wall_group(const clod_near *self, const clod_wall_candidate *c)
{
    return clod_near_group(self, clod_near_part_of(self, c->i), c->law);
}

/** Count near grains at walls by group. */
static void count_walls(const clod_near_job *job)
{
    const clod_wall_candidates *candidates = &job->neighbour->walls;
    clod_near_blocks *blocks = &job->near->walls;
    const size_t groups = clod_near_groups(job->near);
    memset(blocks->group_count, 0, groups * sizeof *blocks->group_count);
    for (size_t k = 0; k < candidates->count; k++) {
        if (candidates->item[k].near != 0) {
            blocks->group_count[wall_group(job->near, &candidates->item[k])]++;
        }
    }
    clod_near_layout_groups(blocks, groups);
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

static void place_wall(const clod_near_job *job, const clod_wall_candidate *c, size_t *fill,
                       clod_near_known *known)
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
    clod_history_put(&block->history, lane, clod_near_history(known, c->i, c->wall, c->shape));
}

static void place_walls(const clod_near_job *job)
{
    const clod_wall_candidates *candidates = &job->neighbour->walls;
    const clod_state *state = job->state;
    const size_t groups = clod_near_groups(job->near);
    size_t *fill = job->near->walls.group_count + groups;
    memset(fill, 0, groups * sizeof *fill);
    clod_near_known known = {state->contacts, state->contact_count - state->wall_contact_count,
                             state->contact_count};
    for (size_t k = 0; k < candidates->count; k++) {
        const clod_wall_candidate *c = &candidates->item[k];
        if (c->near != 0) {
            place_wall(job, c, fill, &known);
        }
    }
}

static void pad_walls(const clod_near_job *job)
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
            clod_history_put(&block->history, lane, CLOD_NEAR_NO_HISTORY);
        }
    }
}

bool clod_near_walls_layout(const clod_near_job *job)
{
    count_walls(job);
    const size_t groups = clod_near_groups(job->near);
    return clod_near_reserve_blocks(&job->near->walls, groups, sizeof(clod_wall_block)) &&
           layout_wall_slots(job->near, job->neighbour, job->state->walls.count);
}

void clod_near_walls_place(const clod_near_job *job)
{
    place_walls(job);
    pad_walls(job);
}
