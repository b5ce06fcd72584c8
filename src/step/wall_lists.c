// Which walls a step has to do with: those that can move, and those that feel something. All
// others cost nothing, however many there are.
#include "step/step.h"

static bool can_move(const clod_wall *wall)
{
    return wall->velocity.x != 0.0 || wall->velocity.y != 0.0 || wall->velocity.z != 0.0 ||
           wall->spin != 0.0 || wall->oscillation.frequency > 0.0 ||
           wall->servo_velocity != 0.0 || wall->load != CLOD_LOAD_NONE;
}

static bool has_felt(const clod_wall *wall)
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

void clod_step_list_feeling(clod_step *self)
{
    const clod_walls *walls = &self->state->walls;
    const int32_t *slots = self->near.wall_slot_start;
    self->feeling_count = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        const clod_wall *wall = &walls->wall[w];
        if (slots[w] < slots[w + 1] || wall->load != CLOD_LOAD_NONE || has_felt(wall)) {
            self->feeling[self->feeling_count++] = w;
        }
    }
}

void clod_step_count_steps(clod_step *self, int64_t steps)
{
    for (int32_t w = 0; w < self->state->walls.count; w++) {
        self->state->walls.wall[w].sum_steps += steps;
    }
}
