// Which walls a step has to do with: those that can move, and those that a force acts on. All
// others cost nothing, however many there are.
#include <string.h>

#include "step/step.h"

static bool can_move(const clod_wall *wall)
{
    return wall->velocity.x != 0.0 || wall->velocity.y != 0.0 || wall->velocity.z != 0.0 ||
           wall->spin != 0.0 || wall->oscillation.frequency > 0.0 ||
           wall->servo_velocity != 0.0 || wall->load != CLOD_LOAD_NONE || wall->belt_lag > 0.0;
}

static bool has_force(const clod_wall *wall)
{
    const clod_vec3 f = wall->force, t = wall->torque;
    return f.x != 0.0 || f.y != 0.0 || f.z != 0.0 || t.x != 0.0 || t.y != 0.0 || t.z != 0.0;
}

void clod_step_list_moving(clod_step *self)
{
    const clod_walls *walls = &self->state->walls;
    self->moving_count = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        clod_wall_rows_place(&self->walls, w, &walls->wall[w]); // someone may have set it
        if (can_move(&walls->wall[w])) {
            self->moving[self->moving_count++] = w;
        }
    }
}

/** Shapes of walls that can move, where grains are near: the others are placed with a list. */
static void list_placed(clod_step *self)
{
    const clod_walls *walls = &self->state->walls;
    const int32_t *first = self->walls.first_shape;
    self->placed_count = 0;
    if (self->moving_count == 0) {
        return;
    }
    memset(self->is_near, 0, (size_t)first[walls->count]);
    const clod_wall_block *block = self->near.walls.block;
    for (size_t at = 0; at < self->near.walls.count * CLOD_LANES; at++) {
        const int32_t shape = block[at / CLOD_LANES].shape[at % CLOD_LANES] / CLOD_SHAPE_ROWS;
        if (shape < first[walls->count]) { // not a padding lane
            self->is_near[shape] = 1;
        }
    }
    for (int32_t k = 0; k < self->moving_count; k++) {
        const int32_t w = self->moving[k];
        for (int32_t s = 0; s < walls->wall[w].shape_count; s++) {
            if (self->is_near[first[w] + s] != 0) {
                self->placed[self->placed_count++] = (clod_step_shape){w, s};
            }
        }
    }
}

void clod_step_list_summed(clod_step *self)
{
    const clod_walls *walls = &self->state->walls;
    const int32_t *sums = self->near.sum_start;
    self->summed_count = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        const clod_wall *wall = &walls->wall[w];
        // where grains are spread over ranks, any wall may have contacts on another one
        if (sums[w] < sums[w + 1] || self->spread != NULL || wall->load != CLOD_LOAD_NONE ||
            has_force(wall)) {
            self->summed[self->summed_count++] = w;
        }
    }
    list_placed(self);
}

void clod_step_count_steps(clod_step *self, int64_t steps)
{
    for (int32_t w = 0; w < self->state->walls.count; w++) {
        self->state->walls.wall[w].sum_steps += steps;
    }
}
