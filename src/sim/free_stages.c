#include "sim/free_stages.h"

#include <math.h>

#include "measure/contacts.h"
#include "sim/outputs.h"

#define LOOK_STEPS 200.0 ///< between two looks at least: longer than a collision
#define LOOK_STEPS_MOST 1e15

static int64_t stage_steps(const clod_free_stages *self, const clod_case *from, double dt)
{
    return clod_outputs_stage_steps(from, (size_t)self->stage, dt);
}

/**
 * Steps between two looks. A grain that flies freely is slower than `rest` for 2 rest/g about
 * the top of its way, or right after it was put there: all looks in a row take longer.
 */
static int64_t look_steps(double rest, const clod_state *state)
{
    const double *g = state->gravity;
    const double gravity = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    const double flight = gravity > 0.0 ? 2.0 * rest / (gravity * state->dt) : 0.0;
    const double steps = floor(flight / (CLOD_FREE_LOOKS - 1)) + 1.0;
    return (int64_t)fmin(fmax(steps, LOOK_STEPS), LOOK_STEPS_MOST);
}

static void change_wall(const clod_case_wall_change *change, clod_wall *wall)
{
    if (change->has_velocity) {
        wall->velocity = clod_vec3_of(change->velocity);
    }
    if (change->has_surface_velocity) {
        const double *v = change->surface_velocity;
        wall->surface_velocity = clod_vec3_of(v);
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
        const int32_t w = clod_walls_find(&state->walls, s->walls[c].name);
        if (w >= 0) {
            change_wall(&s->walls[c], &state->walls.wall[w]);
        }
    }
    clod_walls_reset_sums(&state->walls);
}

void clod_free_stages_begin(clod_free_stages *self, const clod_case *from, clod_state *state)
{
    *self = (clod_free_stages){.stage_start = state->step};
    begin_stage(from, 0, state);
}

int64_t clod_free_stages_plan(const clod_free_stages *self, const clod_case *from,
                              const clod_state *state)
{
    const int64_t done = state->step - self->stage_start;
    const int64_t end = stage_steps(self, from, state->dt);
    const int64_t row = clod_outputs_next(from->output.series_interval, state->dt, done);
    int64_t next = row < end ? row : end;
    const double rest = from->stages[self->stage].rest;
    if (rest > 0.0) {
        const int64_t each = look_steps(rest, state);
        const int64_t look = (done / each + 1) * each;
        next = look < next ? look : next;
    }
    return next > done ? next - done : 1;
}

/** Count a look at which the grains rest; whether there were enough in a row. */
static bool have_come_to_rest(clod_free_stages *self, double rest, const clod_survey *survey)
{
    const clod_measure_motion bed = clod_measure_motion_from(survey);
    const bool calm = bed.max_speed < rest && bed.loaded > 0;
    self->calm = calm ? self->calm + 1 : 0;
    return self->calm >= CLOD_FREE_LOOKS;
}

bool clod_free_stages_look(clod_free_stages *self, const clod_case *from,
                           const clod_state *state, const clod_survey *survey)
{
    const double rest = from->stages[self->stage].rest;
    const int64_t done = state->step - self->stage_start;
    self->done = (double)done * state->dt;
    if (rest > 0.0 && done % look_steps(rest, state) == 0 &&
        have_come_to_rest(self, rest, survey)) {
        self->end = CLOD_FREE_AT_REST;
    } else if (done >= stage_steps(self, from, state->dt)) {
        self->end = CLOD_FREE_DURATION;
    }
    return self->end != CLOD_FREE_GOES_ON ||
           clod_outputs_are_due(from->output.series_interval, state->dt, done);
}

bool clod_free_stages_next(clod_free_stages *self, const clod_case *from, clod_state *state)
{
    clod_walls_reset_sums(&state->walls);
    if (self->end == CLOD_FREE_GOES_ON) {
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

const char *clod_free_stages_reason(clod_free_end end)
{
    return end == CLOD_FREE_AT_REST ? "at rest" : "its duration is over";
}

double clod_free_stages_fraction(const clod_free_stages *self, const clod_case *from)
{
    double before = 0.0;
    double all = 0.0;
    for (size_t s = 0; s < from->stage_count; s++) {
        before += (int64_t)s < self->stage ? from->stages[s].duration : 0.0;
        all += from->stages[s].duration;
    }
    before += fmin(self->done, from->stages[self->stage].duration);
    return all > 0.0 ? before / all : 0.0;
}
