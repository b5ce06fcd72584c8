// Stages between, contact and wall: the force of every contact onto its grains, in the order of
// contacts whatever the number of threads.
#include "geometry/wall_gap.h"
#include "parallel/threads.h"
#include "step/near_between.h"
#include "step/step.h"

/** Contacts of one group, whose grains come before row `end`. */
static bool run_group(clod_step *self, size_t group, int32_t law, size_t end)
{
    const clod_near_blocks *pairs = &self->near.pairs;
    clod_contact_block *blocks = pairs->block;
    const size_t begin = pairs->group_start[group];
    for (size_t b = begin; self->near.ledger && b < pairs->group_start[group + 1]; b++) {
        self->kernel->contact_spend(&self->view, &self->laws->law[law], &blocks[b],
                                    &pairs->spent[b]);
    }
    const size_t contacts = pairs->group_count[group];
    return contacts > 0 && self->kernel->contact(&self->view, &self->laws->law[law],
                                                 &blocks[begin], contacts, end, NULL);
}

/** This thread's share of the blocks of a law between two parts. */
static bool run_between(clod_step *self, int32_t law, int part)
{
    const clod_near *near = &self->near;
    const size_t group = clod_near_group(near, near->parts, law);
    const size_t begin = near->pairs.group_start[group];
    const size_t first = near->pairs.group_start[clod_near_group(near, near->parts, 0)];
    const size_t end = near->pairs.group_start[group + 1];
    const clod_chunk mine = clod_threads_chunk(end - begin, part, self->threads);
    clod_contact_block *blocks = near->pairs.block;
    for (size_t b = begin + mine.begin; near->ledger && b < begin + mine.end; b++) {
        self->kernel->contact_spend(&self->view, &self->laws->law[law], &blocks[b],
                                    &near->pairs.spent[b]);
    }
    const size_t from = mine.begin * CLOD_LANES;
    const size_t all = near->pairs.group_count[group];
    const size_t to = mine.end * CLOD_LANES < all ? mine.end * CLOD_LANES : all;
    const size_t number = (begin - first) * CLOD_LANES + from;
    return to > from && self->kernel->contact(&self->view, &self->laws->law[law],
                                              blocks + begin + mine.begin, to - from, 0,
                                              near->between.share + 2 * number);
}

void clod_step_between(clod_step *self, int part)
{
    bool excess = false;
    for (int32_t l = 0; l < self->laws->count && self->near.parts > 1; l++) {
        excess |= run_between(self, l, part);
    }
    self->thread[part].excess = excess;
}

void clod_step_contact(clod_step *self, int part)
{
    double(*load)[8] = self->state->grains.load;
    const clod_chunk mine = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    bool excess = false;
    for (int p = (int)mine.begin; p < (int)mine.end; p++) {
        for (int32_t l = 0; l < self->laws->count; l++) {
            if (self->near.parts > 1) {
                clod_near_between_add(&self->near, p, l, false, load);
            }
            excess |= run_group(self, clod_near_group(&self->near, p, l), l,
                                self->near.part_start[p + 1]);
            if (self->near.parts > 1) {
                clod_near_between_add(&self->near, p, l, true, load);
            }
        }
    }
    self->thread[part].excess |= excess;
}

/** Geometry of one lane: gap, normal, and how the wall moves at the contact. */
static void stage_lane(const clod_step *self, const clod_wall_block *block, int lane,
                       clod_kernel_wall_stage *stage)
{
    if (block->wall[lane] < 0) { // padding: far from everything
        stage->distance[lane] = 1.0;
        for (int c = 0; c < 3; c++) {
            stage->normal[c][lane] = stage->velocity[c][lane] = 0.0;
            stage->spin[c][lane] = stage->lever[c][lane] = 0.0;
        }
        return;
    }
    const double *row = self->state->grains.place[block->i[lane]];
    const clod_vec3 p = {row[0], row[1], row[2]};
    const clod_wall *wall = &self->state->walls.wall[block->wall[lane]];
    const clod_wall_pose *pose = &self->pose[block->wall[lane]];
    const clod_gap gap = clod_wall_gap_in_space(pose, &wall->shapes[block->shape[lane]], p);
    const clod_vec3 at = clod_vec3_axpy(p, -gap.distance, gap.normal);
    const clod_vec3 v = clod_wall_pose_velocity(pose, at);
    const clod_vec3 w = clod_vec3_scale(pose->axis, pose->spin);
    const clod_vec3 lever = clod_vec3_sub(p, pose->origin);
    const double normal[3] = {gap.normal.x, gap.normal.y, gap.normal.z};
    const double velocity[3] = {v.x, v.y, v.z};
    const double spin[3] = {w.x, w.y, w.z};
    const double to[3] = {lever.x, lever.y, lever.z};
    stage->distance[lane] = gap.distance;
    for (int c = 0; c < 3; c++) {
        stage->normal[c][lane] = normal[c];
        stage->velocity[c][lane] = velocity[c];
        stage->spin[c][lane] = spin[c];
        stage->lever[c][lane] = to[c];
    }
}

void clod_step_stage_walls(const clod_step *self, const clod_wall_block *block,
                           clod_kernel_wall_stage *stage)
{
    for (int lane = 0; lane < CLOD_LANES; lane++) {
        stage_lane(self, block, lane, stage);
    }
}

/** Wall contacts of one group. */
static bool run_walls(clod_step *self, size_t group, const clod_law *law)
{
    const clod_near_blocks *walls = &self->near.walls;
    clod_wall_block *blocks = walls->block;
    size_t left = walls->group_count[group];
    bool excess = false;
    for (size_t b = walls->group_start[group]; b < walls->group_start[group + 1]; b++) {
        clod_kernel_wall_stage stage;
        clod_step_stage_walls(self, &blocks[b], &stage);
        if (self->near.ledger) {
            self->kernel->wall_spend(&self->view, law, &stage, &blocks[b], &walls->spent[b]);
        }
        const int contacts = left < CLOD_LANES ? (int)left : CLOD_LANES;
        excess |= self->kernel->wall(&self->view, law, &stage, &blocks[b], contacts);
        left -= (size_t)contacts;
    }
    return excess;
}

void clod_step_wall(clod_step *self, int part)
{
    const clod_chunk mine = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    bool excess = false;
    for (int p = (int)mine.begin; p < (int)mine.end; p++) {
        for (int32_t l = 0; l < self->laws->count; l++) {
            excess |= run_walls(self, clod_near_group(&self->near, p, l), &self->laws->law[l]);
        }
    }
    self->thread[part].excess |= excess;
}
