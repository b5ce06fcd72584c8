#include "sim/free_stages.h"

#include <math.h>
#include <string.h>

#include "measure/contacts.h"

static int64_t stage_steps(const clod_case *from, int64_t stage, double dt)
{
    return (int64_t)fmax(1.0, round(from->stages[stage].duration / dt));
}

static void change_wall(const clod_case_wall_change *change, clod_wall *wall)
{
    if (change->has_velocity) {
        wall->velocity =
            (clod_vec3){change->velocity[0], change->velocity[1], change->velocity[2]};
    }
    if (change->has_surface_velocity) {
        const double *v = change->surface_velocity;
        wall->surface_velocity = (clod_vec3){v[0], v[1], v[2]};
    }
    if (change->has_spin) {
        wall->spin = change->spin;
    }
    if (change->has_force) {
        wall->load = CLOD_LOAD_FORCE;
        wall->load_force = change->force;
    }
    if (change->has_stress) {
        wall->load = CLOD_LOAD_STRESS;
        wall->load_force = change->stress * wall->area;
    }
}

static void begin_stage(const clod_case *from, int64_t stage, clod_state *state)
{
    const clod_case_stage *s = &from->stages[stage];
    state->adhesion = s->adhesion;
    for (size_t c = 0; c < s->wall_count; c++) {
        for (int32_t w = 0; w < state->walls.count; w++) {
            if (strcmp(state->walls.wall[w].name, s->walls[c].name) == 0) {
                change_wall(&s->walls[c], &state->walls.wall[w]);
            }
        }
    }
    clod_walls_reset_sums(&state->walls);
}

void clod_free_stages_begin(clod_free_stages *self, const clod_case *from, clod_state *state)
{
    *self = (clod_free_stages){0};
    begin_stage(from, 0, state);
}

int64_t clod_free_stages_plan(const clod_free_stages *self, const clod_case *from,
                              const clod_state *state)
{
    const double rows = (double)self->rows + 1.0;
    const int64_t end = stage_steps(from, self->stage, state->dt);
    const double next = rows * from->output.series_interval / state->dt;
    const int64_t at = (int64_t)fmin(fmax(round(next), rows), (double)end);
    const int64_t done = state->step - self->stage_start;
    return at > done ? at - done : 1;
}

bool clod_free_stages_next(clod_free_stages *self, const clod_case *from, clod_state *state)
{
    const bool rested = clod_measure_max_speed(state) < from->stages[self->stage].rest;
    clod_walls_reset_sums(&state->walls);
    self->rows++;
    const int64_t done = state->step - self->stage_start;
    if (done < stage_steps(from, self->stage, state->dt) && !rested) {
        return false;
    }
    if (self->stage + 1 == (int64_t)from->stage_count) {
        return true;
    }
    *self = (clod_free_stages){.stage = self->stage + 1, .stage_start = state->step};
    begin_stage(from, self->stage, state);
    return false;
}

const char *clod_free_stages_name(const clod_free_stages *self, const clod_case *from)
{
    return from->stages[self->stage].name;
}

double clod_free_stages_fraction(const clod_free_stages *self, const clod_case *from)
{
    double before = 0.0;
    double all = 0.0;
    for (size_t s = 0; s < from->stage_count; s++) {
        before += (int64_t)s < self->stage ? from->stages[s].duration : 0.0;
        all += from->stages[s].duration;
    }
    before += fmin((double)self->rows * from->output.series_interval,
                   from->stages[self->stage].duration);
    return all > 0.0 ? before / all : 0.0;
}
