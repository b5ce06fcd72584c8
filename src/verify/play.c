#include "verify/play.h"

#include <math.h>

#include "setup/state.h"

static void find_rows(clod_verify_play *self)
{
    const clod_grains *grains = &self->state.grains;
    for (size_t g = 0; g < grains->count; g++) {
        self->row[grains->id[g]] = g; // ids are the numbers in the deck
    }
}

/** The walls' velocities of a stage; the decks change nothing else. */
static void begin_stage(clod_verify_play *self)
{
    const clod_verify_stage *stage = &self->deck->stages[self->stage];
    for (int w = 0; w < self->deck->wall_count; w++) {
        self->state.walls.wall[w].velocity =
            clod_vec3_scale(self->frame->n, stage->velocity[w]);
    }
}

static bool run_stage(clod_verify_play *self, clod_verify_look look, void *context,
                      clod_status *status)
{
    const double duration = self->deck->stages[self->stage].duration;
    const int64_t steps = (int64_t)fmax(1.0, round(duration / self->state.dt));
    begin_stage(self);
    for (int64_t s = 0; s < steps; s++) {
        if (!clod_step_advance(&self->step, 1, status)) {
            return false;
        }
        find_rows(self);
        if (!look(context, self, status)) {
            return false;
        }
    }
    return true;
}

static bool run_stages(clod_verify_play *self, clod_verify_look look, void *context,
                       clod_status *status)
{
    find_rows(self);
    bool ok = look(context, self, status);
    for (self->stage = 0; ok && self->stage < self->deck->stage_count; self->stage++) {
        ok = run_stage(self, look, context, status);
    }
    return ok;
}

static bool run_loaded(clod_verify_play *self, clod_verify_look look, void *context,
                       clod_status *status)
{
    const clod_step_options options = {.threads = 1,
                                       .overlap_limit = self->from->time.overlap_limit};
    if (!clod_laws_init(&self->laws, self->from, status)) {
        return false;
    }
    clod_laws_set_adhesion(&self->laws, self->from->stages[0].adhesion);
    bool ok = clod_setup_state(self->from, self->from->seed, &self->state, status);
    if (ok) {
        ok = clod_step_init(&self->step, &self->state, &self->laws, &options, status) &&
             (!self->deck->ledger || clod_step_open_ledger(&self->step, status)) &&
             run_stages(self, look, context, status);
        clod_step_fini(&self->step);
    }
    clod_state_fini(&self->state);
    clod_laws_fini(&self->laws);
    return ok;
}

bool clod_verify_play_run(const clod_verify_bench *bench, const clod_verify_deck *deck,
                          const clod_verify_frame *frame, clod_verify_look look, void *context,
                          clod_status *status)
{
    char path[4096];
    clod_verify_play self = {.deck = deck, .frame = frame};
    if (!clod_verify_deck_write(deck, frame, bench->directory, path, status)) {
        return false;
    }
    self.from = clod_case_load(path, NULL, 0, status);
    if (self.from == NULL) {
        return false;
    }
    const bool ok = run_loaded(&self, look, context, status);
    clod_case_destroy(&self.from);
    return ok;
}

static clod_vec3 local(const clod_verify_play *self, const double *row)
{
    return clod_verify_frame_in(self->frame, clod_vec3_of(row));
}

clod_vec3 clod_verify_play_place(const clod_verify_play *self, int grain)
{
    return local(self, self->state.grains.position[self->row[grain]]);
}

clod_vec3 clod_verify_play_velocity(const clod_verify_play *self, int grain)
{
    return local(self, self->state.grains.velocity[self->row[grain]]);
}

clod_vec3 clod_verify_play_spin(const clod_verify_play *self, int grain)
{
    return local(self, self->state.grains.angular_velocity[self->row[grain]]);
}

clod_vec3 clod_verify_play_force(const clod_verify_play *self, int grain)
{
    return local(self, self->state.grains.load[self->row[grain]]);
}

clod_vec3 clod_verify_play_torque(const clod_verify_play *self, int grain)
{
    const double *load = self->state.grains.load[self->row[grain]];
    return clod_verify_frame_in(self->frame, (clod_vec3){load[4], load[5], load[6]});
}
