#include "step/step.h"

#include <string.h>

#include "base/memory.h"
#include "parallel/threads.h"
#include "step/crew.h"
#include "step/derived.h"
#include "step/spread.h"
#include "step/stages.h"
#include "step/team.h"
#include "step/trouble.h"

#define POSITION CLOD_STAGE_POSITION
#define VELOCITY CLOD_STAGE_VELOCITY
#define LISTS CLOD_STAGE_LISTS
#define SHARE CLOD_STAGE_SHARE
#define HISTORY CLOD_STAGE_HISTORY
#define FORCE CLOD_STAGE_FORCE
#define WALL_SUM CLOD_STAGE_WALL_SUM
#define WALLS CLOD_STAGE_WALLS
#define SURFACES CLOD_STAGE_SURFACES
#define DISSIPATED CLOD_STAGE_DISSIPATED
#define SUMS CLOD_STAGE_DISSIPATED_SUMS
#define LEDGER CLOD_STAGE_LEDGER
#define TOUCH CLOD_STAGE_TOUCH
#define SEEN CLOD_STAGE_SEEN
#define EXCESS CLOD_STAGE_EXCESS
#define RUB CLOD_STAGE_RUB
#define WEAR CLOD_STAGE_WEAR
#define PASSED CLOD_STAGE_PASSED
#define ENDS (WALL_SUM | SUMS | EXCESS | WALLS | LEDGER) // with ranks: of the step before
#define ROWS (POSITION | VELOCITY | FORCE | HISTORY)     // a rebuild puts them into a new order

/** An overlap beyond the laws' range in this step, from flags that stay until all threads have seen
 *  them. */
static bool has_excess(const clod_step *self)
{
    bool excess = false;
    for (int t = 0; t < self->threads; t++) {
        excess |= self->thread[t].excess;
    }
    return excess;
}

/** After steps: trouble in any of them, of any rank. */
static bool has_trouble(const clod_step *self)
{
    const clod_step_thread *first = &self->thread[0];
    return self->failed || !first->all_finite || first->late ||
           (self->spread == NULL && has_excess(self));
}

/** The first overlap too large is looked at while no thread moves anything. */
static void note_excess(clod_step *self, int part)
{
    if (has_excess(self) && self->thread[part].all_finite && !self->thread[part].noted) {
        if (part == 0) {
            clod_trouble_note(self);
        }
        self->thread[part].noted = true;
        clod_barrier_wait(&self->barrier);
    }
}

/** The step is made. An overlap too large stops the step after its own: by then all ranks know
 *  of it. */
static void check(clod_step *self, int part)
{
    clod_step_thread *mine = &self->thread[part];
    if (part == 0) {
        self->state->step++;
    }
    note_excess(self, part);
    mine->stop = self->failed || !mine->all_finite || mine->late;
    mine->late = mine->late || (self->spread == NULL && has_excess(self));
}

/** Ranks merge the sums of walls of the last step; ghosts does so for the step before. */
static void merge_last(clod_step *self, int part)
{
    if (part == 0 && self->spread != NULL) {
        clod_spread_settle(self);
    }
}

// drift completes the half kick of the step before; settle does after the last step
const clod_stage CLOD_STAGE[CLOD_STAGES] = {
    // clang-format off
    //name,       function,             reads,                                      writes,                                      by thread 0,                        barrier
    {"drift",     clod_step_drift,     ROWS | LISTS | WALLS,                      POSITION | VELOCITY | FORCE | WALLS | SEEN | PASSED, WALLS,                      CLOD_BARRIER_AFTER},
    {"ghosts",    clod_step_ghosts,    POSITION | VELOCITY | SEEN | LISTS | ENDS, POSITION | VELOCITY | FORCE | SEEN | ENDS,  POSITION | VELOCITY | SEEN | ENDS, CLOD_BARRIER_RANKS},
    {"place",     clod_step_place,     WALLS | LISTS,                             SURFACES,                                   0,                                 CLOD_BARRIER_NONE},
    {"near",      clod_step_near,      ROWS | WALLS | SEEN,                       ROWS | LISTS | SURFACES,                    0,                                 CLOD_BARRIER_WITHIN},
    {"contact",   clod_step_contact,   POSITION | VELOCITY | LISTS,               FORCE | HISTORY | SHARE | DISSIPATED | EXCESS, 0,                                 CLOD_BARRIER_NONE},
    {"touch",     clod_step_touch,     POSITION | LISTS | SURFACES,               HISTORY | TOUCH,                            0,                                 CLOD_BARRIER_NONE},
    {"wall",      clod_step_wall,      POSITION | VELOCITY | LISTS | SURFACES | TOUCH, FORCE | HISTORY | WALL_SUM | DISSIPATED | RUB | EXCESS, 0,                                 CLOD_BARRIER_NONE},
    {"dissipate", clod_step_dissipate, LISTS | DISSIPATED,                        SUMS,                                       0,                                 CLOD_BARRIER_AFTER},
    {"wear",      clod_step_wear,      LISTS | RUB | TOUCH | WEAR,                WEAR,                                       0,                                 CLOD_BARRIER_NONE},
    {"servo",     clod_step_servo,     WALL_SUM | WALLS | LISTS,                  WALL_SUM | WALLS | LEDGER,                  WALL_SUM | WALLS | LEDGER,         CLOD_BARRIER_NONE},
    {"ledger",    clod_step_ledger,    SUMS | LEDGER,                             LEDGER,                                     SUMS | LEDGER,                     CLOD_BARRIER_NONE},
    {"check",     check,               EXCESS,                                    0,                                          0,                                 CLOD_BARRIER_NONE}, // within, at the first excess
    // clang-format on
};

const clod_stage CLOD_LAST_STAGE[CLOD_LAST_STAGES] = {
    // clang-format off
    {"settle",   clod_step_settle,   VELOCITY | FORCE | LISTS,              VELOCITY,                                   0,                     CLOD_BARRIER_RANKS},
    {"merge",    merge_last,         ENDS,                                  ENDS,                                       ENDS,                  CLOD_BARRIER_NONE},
    {"passages", clod_step_passages, PASSED,                                PASSED,                                     PASSED,                CLOD_BARRIER_NONE},
    // clang-format on
};

/** `number` is for those who measure: the last stages come behind those of a step. */
static void run_stage(clod_step *self, int part, const clod_stage *stage, int number)
{
    stage->run(self, part);
    if (stage->barrier == CLOD_BARRIER_AFTER ||
        (stage->barrier == CLOD_BARRIER_RANKS && self->spread != NULL)) {
        clod_barrier_wait(&self->barrier);
    }
    if (self->after_stage != NULL) {
        self->after_stage(part, number);
    }
}

/** The steps as one thread sees them. */
static void advance_part(clod_step *self, int part)
{
    for (int64_t s = 0; s < self->steps; s++) {
        for (int k = 0; k < CLOD_STAGES; k++) {
            run_stage(self, part, &CLOD_STAGE[k], k);
            if (self->failed) { // set between barriers: all threads see it here
                return;
            }
        }
        if (self->thread[part].stop) { // all agree
            break;
        }
    }
    for (int k = 0; k < CLOD_LAST_STAGES; k++) {
        run_stage(self, part, &CLOD_LAST_STAGE[k], CLOD_STAGES + k);
    }
}

/** After steps: an overlap too large in the last of them, which asks for the step after its own. */
static bool lacks_step(const clod_step *self)
{
    return !self->failed && self->thread[0].late && !self->thread[0].stop;
}

bool clod_step_advance(clod_step *self, int64_t steps, clod_status *status)
{
    if (self->failed) { // once and for all
        *status = self->status;
        return false;
    }
    if (!clod_step_change(self, status)) {
        return false;
    }
    if (self->crew != NULL) {
        return clod_crew_advance(self->crew, steps, status);
    }
    self->state->contact_count = self->state->wall_contact_count = 0; // of the moment before
    for (int t = 0; t < self->threads; t++) {
        self->thread[t].build_motion = self->state->build_motion;
        self->thread[t].late = self->thread[t].noted = false;
    }
    self->trouble.any = false;
    self->view.dt = self->state->dt;
    const int64_t first = self->state->step;
    clod_step_list_moving(self);
    clod_step_list_summed(self); // a load may have been put on
    self->steps = steps;
    clod_team_run(self, advance_part);
    if (lacks_step(
            self)) { // a run stops in the same step, however its steps are cut into calls
        self->steps = 1;
        clod_team_run(self, advance_part);
    }
    clod_step_count_steps(self, self->state->step - first);
    self->state->build_motion = self->thread[0].build_motion;
    self->state->time = (double)self->state->step * self->state->dt;
    if (self->spread != NULL && self->thread[0].late) {
        clod_spread_merge_trouble(self);
    }
    if (self->failed && !self->trouble.any) {
        *status = self->status;
        return false;
    }
    return !has_trouble(self) || clod_trouble_report(self, status);
}

/** Threads that want this step's processors: its own, and those of other ranks. */
static int threads_beside(const clod_step *self)
{
    return self->spread == NULL ? self->threads
                                : self->threads * clod_ranks_beside(self->spread->ranks);
}

static bool allocate(clod_step *self)
{
    const int beside = threads_beside(self);
    self->thread = clod_memory_alloc((size_t)self->threads, sizeof *self->thread);
    self->gate = clod_memory_alloc((size_t)self->threads, sizeof *self->gate);
    self->placed_gate = clod_memory_alloc((size_t)self->threads, sizeof *self->placed_gate);
    const size_t planes = (size_t)self->state->planes.count;
    if (planes > 0) {
        self->passed = clod_memory_alloc((size_t)self->threads * planes, sizeof *self->passed);
    }
    if (self->thread == NULL || (planes > 0 && self->passed == NULL) || self->gate == NULL ||
        self->placed_gate == NULL ||
        !clod_layer_order_reserve(&self->neighbour, self->near.parts)) {
        return false;
    }
    for (int t = 0; t < self->threads; t++) {
        self->thread[t].finite = self->thread[t].all_finite = true;
        clod_gate_init(&self->gate[t], beside);
        clod_gate_init(&self->placed_gate[t], beside);
    }
    return true;
}

bool clod_step_first_forces(clod_step *self, clod_status *status)
{
    clod_grains *grains = &self->state->grains;
    memset(grains->load, 0, grains->count * sizeof *grains->load);
    for (int t = self->threads; t-- > 0;) { // the last first, as in clod_step_contact
        clod_step_contact(self, t);
    }
    for (int t = 0; t < self->threads; t++) {
        clod_step_wall(self, t);
    }
    for (size_t g = 0; g < grains->count; g++) {
        for (int a = 0; a < 3; a++) {
            grains->load[g][a] += grains->velocity[g][3] * self->state->gravity[a];
        }
    }
    clod_step_servo(self, 0);
    if (self->spread != NULL) {
        clod_spread_settle(self);
    }
    if (self->spread != NULL && self->thread[0].late) { // on all ranks alike
        clod_trouble_note(self);
        clod_spread_merge_trouble(self);
    }
    clod_walls_reset_sums(&self->state->walls);
    return !has_trouble(self) || clod_trouble_report(self, status);
}

/** Everything but the lists. */
static bool prepare(clod_step *self, clod_state *state, const clod_laws *laws,
                    const clod_step_options *options, clod_status *status)
{
    *self = (clod_step){.state = state,
                        .laws = laws,
                        .accepts = options->accepts,
                        .context = options->context,
                        .begin = state->step,
                        .spread = options->spread};
    self->near.ledger = state->ledger.open != 0;
    self->kernel = clod_kernel_choose(options->simd);
    if (self->kernel == NULL) {
        return clod_status_fail(status, CLOD_USAGE,
                                "instruction set '%s' is unknown or not in this machine; use "
                                "scalar, avx2, avx512 or neon, or leave it out for the best",
                                options->simd != NULL ? options->simd : "best");
    }
    self->threads = options->threads > 0 ? options->threads : clod_threads_available();
    self->near.parts = self->threads;
    clod_neighbour_init(&self->neighbour, state, options->brute_force);
    self->neighbour.kernel = self->kernel;
    self->neighbour.layers = self->spread != NULL ? &self->spread->layers : NULL;
    if (!allocate(self)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the step");
    }
    if (self->near.ledger && !clod_grains_keep_before(&state->grains, status)) {
        return false;
    }
    self->view.overlap_limit =
        options->overlap_limit > 0.0 ? options->overlap_limit : CLOD_STEP_OVERLAP;
    clod_barrier_init(&self->barrier, self->threads, threads_beside(self));
    return clod_step_derive(self, status);
}

bool clod_step_init(clod_step *self, clod_state *state, const clod_laws *laws,
                    const clod_step_options *options, clod_status *status)
{
    const bool fresh = state->build_motion < 0.0 || state->build_position == NULL;
    if (fresh) { // nobody has touched yet
        state->contact_count = state->wall_contact_count = 0;
    }
    const bool prepared = prepare(self, state, laws, options, status);
    if (!clod_spread_agree(self->spread, prepared, status)) {
        return false;
    }
    if (options->ranks != NULL && options->ranks->size > 1) {
        return clod_crew_begin(self, options, true, status);
    }
    return clod_step_build_lists(self, fresh, status) &&
           (!fresh || clod_step_first_forces(self, status));
}

bool clod_step_see(clod_step *self, clod_status *status)
{
    return self->crew == NULL || clod_crew_see(self->crew, status);
}

bool clod_step_see_near(clod_step *self, const clod_domain_box *box, int count,
                        clod_status *status)
{
    return self->crew == NULL || clod_crew_see_near(self->crew, box, count, status);
}

bool clod_step_see_gone(clod_step *self, clod_status *status)
{
    return self->crew == NULL || clod_crew_see_gone(self->crew, status);
}

bool clod_step_renew(clod_step *self, clod_status *status)
{
    return self->crew == NULL || clod_crew_renew(self, status);
}

size_t clod_step_grains(const clod_step *self)
{
    return self->crew == NULL ? self->state->grains.count : clod_crew_grains(self->crew);
}

bool clod_step_export(clod_step *self, clod_status *status)
{
    return clod_step_see(self, status) &&
           clod_near_gather(&self->near, self->state, &self->walls, status);
}

void clod_step_fini(clod_step *self)
{
    clod_crew_end(&self->crew);
    clod_neighbour_fini(&self->neighbour);
    clod_near_fini(&self->near);
    clod_memory_free(self->thread);
    clod_memory_free(self->gate);
    clod_memory_free(self->placed_gate);
    clod_memory_free(self->passed);
    clod_memory_free(self->moving);
    clod_memory_free(self->summed);
    clod_memory_free(self->placed);
    clod_memory_free(self->is_near);
    clod_outlet_shapes_fini(&self->outlets);
    clod_wall_rows_fini(&self->walls);
    *self = (clod_step){0};
}
