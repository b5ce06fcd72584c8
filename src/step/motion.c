// Stages drift and servo: how grains and walls move. The second half kick of a step is done by
// the drift of the next one, which is one way through memory for both.
#include <math.h>
#include <string.h>

#include "parallel/threads.h"
#include "step/step.h"

/** Walls that can move do; the fastest speed that a point of them can have [m/s]. */
static double drift_walls(clod_step *self)
{
    double fastest = 0.0;
    const double dt = self->state->dt;
    for (int32_t k = 0; k < self->moving_count; k++) {
        const int32_t w = self->moving[k];
        clod_wall *wall = &self->state->walls.wall[w];
        clod_wall_move(wall, dt, self->state->step + 1);
        clod_wall_rows_place(&self->walls, w, wall);
        fastest = fmax(fastest, clod_wall_speed_within(wall, self->walls.reach[w]));
    }
    return fastest;
}

/** The grains of the parts that belong to a thread. */
static clod_chunk my_grains(const clod_step *self, int part)
{
    const clod_chunk c = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    return (clod_chunk){self->near.part_start[c.begin], self->near.part_start[c.end]};
}

void clod_step_drift(clod_step *self, int part)
{
    clod_grains *grains = &self->state->grains;
    clod_step_thread *mine = &self->thread[part];
    const clod_chunk c = my_grains(self, part);
    if (self->near.ledger) {
        clod_step_settle(self, part);
        memcpy(grains->before[c.begin], grains->load[c.begin],
               (c.end - c.begin) * sizeof *grains->load);
    }
    const clod_kernel_speed seen = self->kernel->drift(
        grains->place, grains->motion, grains->turning, grains->load,
        mine->owed ? self->state->gravity : NULL, self->state->dt, c.begin, c.end);
    mine->owed = true; // this step's second half kick, when its forces are there
    mine->max_speed2 = seen.max_speed2;
    mine->finite = seen.finite;
    if (part == 0) {
        const double walls = drift_walls(self);
        mine->max_speed2 = fmax(mine->max_speed2, walls * walls);
    }
}

void clod_step_settle(clod_step *self, int part)
{
    clod_grains *grains = &self->state->grains;
    const clod_chunk c = my_grains(self, part);
    if (self->thread[part].owed) {
        self->kernel->kick(grains->motion, grains->turning, grains->load, self->state->gravity,
                           self->state->dt, c.begin, c.end);
    }
    self->thread[part].owed = false;
}

/** What the wall does to the grains with its force and torque and its velocity of now [W]. */
static double power_of(const clod_wall *wall)
{
    return -clod_vec3_dot(wall->force, clod_wall_velocity(wall)) -
           clod_wall_spin(wall) * clod_vec3_dot(wall->torque, wall->spin_axis);
}

/** Ordered sum of a wall's slots; power is what the wall does to the grains. */
static void sum_wall(clod_wall *wall, const double (*slots)[8], int32_t begin, int32_t end)
{
    double sum[8] = {0.0};
    for (int32_t s = begin; s < end; s++) {
        for (int c = 0; c < 8; c++) {
            sum[c] += slots[s][c];
        }
    }
    wall->force = (clod_vec3){sum[0], sum[1], sum[2]};
    wall->torque = (clod_vec3){sum[4], sum[5], sum[6]};
    wall->power = power_of(wall);
}

/**
 * Load servo: mass dv/dt = load + (grains on wall) - damping v along the load axis; the damping
 * is taken at the new velocity, so it is stable for any mass. The load is the force between
 * wall and grains: the wall's own weight does not act beside it.
 */
static void kick_servo(clod_wall *wall, double dt)
{
    const double push = wall->load_force + clod_vec3_dot(wall->force, wall->load_axis);
    wall->servo_velocity = (wall->servo_velocity + dt * push / wall->mass) /
                           (1.0 + dt * wall->damping / wall->mass);
}

void clod_step_servo(clod_step *self, int part)
{
    if (part != 0) {
        return;
    }
    for (int32_t k = 0; k < self->feeling_count; k++) {
        const int32_t w = self->feeling[k];
        clod_wall *wall = &self->state->walls.wall[w];
        const double before = power_of(wall); // the force before with the way of this step
        sum_wall(wall, (const double(*)[8])self->near.wall_slots, self->near.wall_slot_start[w],
                 self->near.wall_slot_start[w + 1]);
        wall->sum_force = clod_vec3_add(wall->sum_force, wall->force);
        wall->sum_torque = clod_vec3_add(wall->sum_torque, wall->torque);
        wall->sum_power += wall->power;
        if (self->near.ledger) {
            self->state->ledger.wall_work += 0.5 * self->view.dt * (before + wall->power);
        }
        if (wall->load != CLOD_LOAD_NONE) {
            kick_servo(wall, self->view.dt);
        }
    }
}
