// Stages drift and servo: how grains and walls move. The second half kick of a step is done by
// the drift of the next one, which is one way through memory for both.
#include <math.h>
#include <string.h>

#include "parallel/threads.h"
#include "step/near_skins.h"
#include "step/passages.h"
#include "step/spread.h"

void clod_step_move_walls(clod_step *self)
{
    clod_step_thread *first = &self->thread[0];
    double fastest = 0.0;
    for (int32_t k = 0; k < self->moving_count; k++) {
        const int32_t w = self->moving[k];
        clod_wall *wall = &self->state->walls.wall[w];
        clod_wall_move(wall, self->state->dt, self->state->step + 1);
        fastest = fmax(fastest, clod_wall_speed_within(wall, self->walls.reach[w]));
    }
    first->max_speed2 = fmax(first->max_speed2, fastest * fastest);
    first->wall_speed = fastest;
    first->finite = first->finite && self->walls_finite;
}

/** A thread's share of the shapes that move and have grains near, where they are now. */
void clod_step_place(clod_step *self, int part)
{
    const clod_chunk c = clod_threads_chunk(self->placed_count, part, self->threads);
    clod_wall_placement placement;
    for (size_t k = c.begin; k < c.end; k++) {
        const clod_step_shape at = self->placed[k];
        if (k == c.begin || at.wall != self->placed[k - 1].wall) {
            placement = clod_wall_placement_of(&self->state->walls.wall[at.wall]);
        }
        clod_wall_rows_place_shape(&self->walls, at.wall, &placement, at.shape);
    }
    clod_gate_open(&self->placed_gate[part]);
}

/** The grains of the parts that belong to a thread. */
static clod_chunk my_grains(const clod_step *self, int part)
{
    const clod_chunk c = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    return (clod_chunk){self->near.part_start[c.begin], self->near.part_start[c.end]};
}

/** What the grains of a watch can have left their courses by; where that may be more than a skin,
 *  they are looked at. */
static void watch_rows(clod_step *self, clod_step_thread *mine, clod_near_watch *watch,
                       clod_chunk rows, double speed)
{
    watch->motion += (speed + watch->fastest) * self->state->dt;
    if (watch->motion < watch->left) {
        return;
    }
    const clod_near_seen seen =
        clod_near_look(&self->near, self->state, mine->age, rows.begin, rows.end);
    *watch =
        (clod_near_watch){.left = seen.left, .fastest = seen.fastest, .noted = watch->noted};
    if (mine->age > self->state->dt) { // after one step all grains are where they were expected
        mine->gone += seen.gone;
        mine->off_course += seen.off_course;
    }
    mine->used_up = mine->used_up || seen.left < 0.0;
}

/** Drift of the rows of a watch, where there are planes. */
static clod_kernel_speed drift_past_planes(clod_step *self, const clod_step_thread *mine,
                                           const double *gravity, size_t number,
                                           clod_chunk rows)
{
    clod_grains *grains = &self->state->grains;
    clod_near_watch *watch = &self->near.watch[number];
    const size_t planes = (size_t)self->state->planes.count, count = rows.end - rows.begin;
    clod_passage *seen = self->near.passage + number * planes;
    if (!watch->noted) {
        clod_passages_note(seen, self->state, rows.begin, count);
        watch->noted = true;
    }
    const clod_kernel_speed some =
        self->kernel->drift(grains->position, grains->velocity, grains->angular_velocity,
                            grains->load, gravity, self->state->dt, rows.begin, rows.end);
    clod_passed *passed = self->passed + (size_t)(mine - self->thread) * planes;
    clod_passages_count(passed, seen, self->state, sqrt(some.max_speed2), rows.begin, count);
    return some;
}

/** Drift of rows, watch by watch; `cuts` of rows are before them. */
static clod_kernel_speed drift_rows(clod_step *self, clod_step_thread *mine, clod_chunk rows,
                                    size_t cuts)
{
    clod_grains *grains = &self->state->grains;
    const double *gravity = mine->kick_due ? self->state->gravity : NULL;
    clod_kernel_speed seen = {0.0, true};
    size_t number = rows.begin / CLOD_NEAR_WATCHED;
    for (size_t begin = rows.begin; begin < rows.end; number++) {
        const size_t next = (number + 1) * CLOD_NEAR_WATCHED;
        const size_t end = next < rows.end ? next : rows.end;
        const clod_chunk watched = {begin, end};
        const clod_kernel_speed some =
            self->passed != NULL
                ? drift_past_planes(self, mine, gravity, number + cuts, watched)
                : self->kernel->drift(grains->position, grains->velocity,
                                      grains->angular_velocity, grains->load, gravity,
                                      self->state->dt, begin, end);
        seen.max_speed2 = fmax(seen.max_speed2, some.max_speed2);
        seen.finite = seen.finite && some.finite;
        watch_rows(self, mine, &self->near.watch[number + cuts], watched,
                   sqrt(some.max_speed2));
        begin = end;
    }
    return seen;
}

/** The same of the own rows among them. */
static clod_kernel_speed drift_own(clod_step *self, clod_step_thread *mine, clod_chunk rows,
                                   size_t cuts)
{
    clod_kernel_speed seen = {0.0, true};
    for (size_t k = 0; k < self->spread->runs; k++) {
        const clod_chunk run = clod_spread_run(self->spread, k, rows);
        if (run.begin < run.end) {
            const clod_kernel_speed some = drift_rows(self, mine, run, cuts + k);
            seen.max_speed2 = fmax(seen.max_speed2, some.max_speed2);
            seen.finite = seen.finite && some.finite;
        }
    }
    return seen;
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
    mine->age += self->state->dt;
    mine->used_up = false;
    const clod_kernel_speed seen = self->spread == NULL
                                       ? drift_rows(self, mine, c, (size_t)part)
                                       : drift_own(self, mine, c, (size_t)part);
    mine->kick_due = true; // this step's second half kick, when its forces are there
    mine->max_speed2 = seen.max_speed2;
    mine->finite = seen.finite;
    if (part == 0 &&
        self->spread == NULL) { // else stage ghosts does, when it knows their speed
        clod_step_move_walls(self);
    }
}

static void kick_rows(clod_step *self, clod_chunk rows)
{
    clod_grains *grains = &self->state->grains;
    self->kernel->kick(grains->velocity, grains->angular_velocity, grains->load,
                       self->state->gravity, self->state->dt, rows.begin, rows.end);
}

void clod_step_settle(clod_step *self, int part)
{
    const clod_chunk c = my_grains(self, part);
    if (self->thread[part].kick_due && self->spread == NULL) {
        kick_rows(self, c);
    } else if (self->thread[part].kick_due) {
        for (size_t k = 0; k < self->spread->runs; k++) {
            const clod_chunk run = clod_spread_run(self->spread, k, c);
            if (run.begin < run.end) {
                kick_rows(self, run);
            }
        }
    }
    self->thread[part].kick_due = false;
}

/** What the wall does to the grains with its force and torque and its velocity of now, without
 *  its belts [W]. */
static double power_of(const clod_wall *wall)
{
    return -clod_vec3_dot(wall->force, clod_wall_velocity(wall)) -
           clod_wall_spin(wall) * clod_vec3_dot(wall->torque, wall->spin_axis);
}

/** Forces on the wall: the sums of all parts, which begin anew. */
static void sum_wall(clod_step *self, int32_t w)
{
    clod_wall *wall = &self->state->walls.wall[w];
    clod_fixed all = {0};
    if (self->spread != NULL) { // stage ghosts has added them up
        all = self->spread->wall_sum[w];
    }
    for (int32_t s = self->near.sum_start[w]; s < self->near.sum_start[w + 1]; s++) {
        clod_fixed_merge(&all, &self->near.wall_sum[s]);
        self->near.wall_sum[s] = (clod_fixed){0};
    }
    double wall_sum[CLOD_FIXED_COLUMNS];
    clod_fixed_value(&all, wall_sum);
    wall->force = clod_vec3_of(&wall_sum[CLOD_WALL_SUM_FORCE]);
    wall->torque = clod_vec3_of(&wall_sum[CLOD_WALL_SUM_TORQUE]);
    wall->belt_power = wall_sum[CLOD_WALL_SUM_BELT_POWER];
    wall->power = power_of(wall) + wall->belt_power;
    self->walls_finite =
        self->walls_finite && isfinite(wall_sum[0] + wall_sum[1] + wall_sum[2] + wall->power);
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

void clod_step_push_walls(clod_step *self)
{
    clod_exact work = {0};
    for (int32_t k = 0; k < self->summed_count; k++) {
        const int32_t w = self->summed[k];
        clod_wall *wall = &self->state->walls.wall[w];
        // the force before with the way of this step
        const double before = power_of(wall) + wall->belt_power;
        sum_wall(self, w);
        wall->sum_force = clod_vec3_add(wall->sum_force, wall->force);
        wall->sum_torque = clod_vec3_add(wall->sum_torque, wall->torque);
        wall->sum_power += wall->power;
        if (self->near.ledger) {
            clod_exact_add(&work, 0.5 * self->view.dt * (before + wall->power));
        }
        if (wall->load != CLOD_LOAD_NONE) {
            kick_servo(wall, self->view.dt);
        }
    }
    if (self->near.ledger) {
        self->state->ledger.wall_work += clod_exact_value(&work);
    }
}

void clod_step_servo(clod_step *self, int part)
{
    if (part == 0 && self->spread == NULL) {
        clod_step_push_walls(self);
    } else if (part == 0) { // with what other ranks' contacts did, in the next step
        self->spread->sums_due = true;
    }
}
