// Stages contact and wall: the force of every contact into its slots.
#include "geometry/wall_gap.h"
#include "parallel/threads.h"
#include "step/step.h"

/** The part of [begin, end) that belongs to one law. */
static clod_chunk clip(clod_chunk chunk, size_t first, size_t last)
{
    const size_t begin = chunk.begin > first ? chunk.begin : first;
    const size_t end = chunk.end < last ? chunk.end : last;
    return (clod_chunk){begin, end > begin ? end : begin};
}

void clod_step_contact(clod_step *self, int part)
{
    const clod_near_blocks *pairs = &self->near.pairs;
    clod_contact_block *blocks = pairs->block;
    const clod_chunk mine = clod_threads_chunk(pairs->count, part, self->threads);
    bool excess = false;
    for (int32_t l = 0; l < self->laws->count; l++) {
        const clod_chunk c = clip(mine, pairs->law_start[l], pairs->law_start[l + 1]);
        for (size_t b = c.begin; self->near.ledger && b < c.end; b++) {
            self->kernel->contact_spend(&self->view, &self->laws->law[l], &blocks[b],
                                        &pairs->spent[b]);
        }
        if (c.end > c.begin) {
            excess |= self->kernel->contact(&self->view, &self->laws->law[l], blocks + c.begin,
                                            c.end - c.begin);
        }
    }
    self->thread[part].excess = excess;
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
    const clod_vec3 v = clod_wall_velocity_at(wall, at);
    const clod_vec3 w = clod_vec3_scale(wall->spin_axis, clod_wall_spin(wall));
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

void clod_step_wall(clod_step *self, int part)
{
    const clod_near_blocks *walls = &self->near.walls;
    clod_wall_block *blocks = walls->block;
    const clod_chunk mine = clod_threads_chunk(walls->count, part, self->threads);
    bool excess = false;
    for (int32_t l = 0; l < self->laws->count; l++) {
        const clod_chunk c = clip(mine, walls->law_start[l], walls->law_start[l + 1]);
        for (size_t b = c.begin; b < c.end; b++) {
            clod_kernel_wall_stage stage;
            clod_step_stage_walls(self, &blocks[b], &stage);
            if (self->near.ledger) {
                self->kernel->wall_spend(&self->view, &self->laws->law[l], &stage, &blocks[b],
                                         &walls->spent[b]);
            }
            excess |= self->kernel->wall(&self->view, &self->laws->law[l], &stage, &blocks[b]);
        }
    }
    self->thread[part].excess |= excess;
}
