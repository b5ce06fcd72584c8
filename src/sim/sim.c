#include "sim/sim.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "config/source.h"
#include "measure/contacts.h"
#include "parallel/ranks_mpi.h"
#include "parallel/threads.h"
#include "setup/begin.h"
#include "setup/bound.h"
#include "setup/grains.h"

pthread_mutex_t clod_sim_case_lock = PTHREAD_MUTEX_INITIALIZER;

bool clod_sim_finite(const double numbers[3], const char *function, const char *name,
                     clod_status *status)
{
    return (isfinite(numbers[0]) && isfinite(numbers[1]) && isfinite(numbers[2])) ||
           clod_status_fail(status, CLOD_USAGE, "%s: %s is (%g, %g, %g); give finite numbers",
                            function, name, numbers[0], numbers[1], numbers[2]);
}

bool clod_sim_settle(clod_sim *self, clod_status *status)
{
    const bool change = clod_changes_any(&self->state.changes);
    const bool good = clod_sim_take(self, status) && clod_step_change(&self->step, status);
    if (change && (good || self->step.failed)) {
        clod_sim_recall(self);
        self->written = false; // a change deals all
    }
    return good;
}

bool clod_sim_hold(clod_sim *self, clod_status *status)
{
    return clod_sim_settle(self, status) && clod_step_export(&self->step, status);
}

bool clod_sim_balance(clod_sim *self, double *energy, clod_status *status)
{
    if (!clod_sim_take(self, status)) {
        return false;
    }
    *energy = clod_step_balance(&self->step);
    return true;
}

void clod_sim_moved(clod_sim *self, double before)
{
    const clod_changes *queue = &self->state.changes;
    if (queue->moved && !queue->booked) { // after positions that the caller has written
        clod_step_book(&self->step, before);
    }
    clod_changes_moved_from(&self->state.changes, before);
}

bool clod_sim_take_up(clod_sim *self, clod_status *status)
{
    clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    if (!clod_step_init(&self->step, &self->state, &self->laws, &self->options, status)) {
        self->step.failed = true; // it says so from now on
        self->step.status = *status;
        return false;
    }
    self->options.simd = self->step.kernel->name; // the caller's text may go
    return true;
}

/** Of several ranks each has one thread, unless the caller asks for more. */
static int choose_threads(const clod_sim *self)
{
    const int threads = clod_threads_take(self->options.threads);
    if (self->options.threads > 0) {
        return threads;
    }
    return clod_sim_is_spread(self) ? 1 : clod_threads_worth(threads, self->state.grains.count);
}

static bool begin(clod_sim *self, const clod_sim_options *options, clod_status *status)
{
    self->options = (clod_step_options){.threads = options != NULL ? options->threads : 0,
                                        .simd = options != NULL ? options->simd : NULL,
                                        .ranks = options != NULL ? options->ranks : NULL,
                                        .overlap_limit = self->from->time.overlap_limit,
                                        .accepts = clod_setup_bound_accepts,
                                        .context = self->from};
    if (!clod_begin_state(self->from, self->from->seed, &self->state, status) ||
        !clod_laws_init(&self->laws, self->from, status)) {
        return false;
    }
    self->options.threads = choose_threads(self);
    return clod_sim_take_up(self, status) &&
           (!self->from->output.energy || clod_sim_open_ledger(self, status)) &&
           (clod_setup_grains_coming(self->from) == 0 || clod_sim_open_series(self, status));
}

/** Whether this process is alone, or knows that it is not. */
static bool check_processes(const clod_sim_options *options, const char *function,
                            clod_status *status)
{
    if (options != NULL && options->ranks != NULL) {
        return clod_sim_ranks_are_free(options->ranks, function, status);
    }
    const int processes = clod_ranks_mpi_processes();
    char number[16] = "several"; // a launcher that does not say
    if (processes > 0) {
        snprintf(number, sizeof number, "%d", processes);
    }
    return processes == 1 || (options != NULL && options->each_process) ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s processes were started together (mpirun, srun), and each would "
               "compute all of this simulation: give the ranks that are to compute it "
               "together (clod_ranks_open, in Python clod.ranks; docs/ranks.md), run the "
               "program without mpirun, or set each_process where every process shall have "
               "a simulation of its own",
               number);
}

clod_sim *clod_sim_create(const clod_case *from, const clod_sim_options *options,
                          clod_status *status)
{
    if (!CLOD_GIVEN(from, status) || !check_processes(options, __func__, status)) {
        return NULL;
    }
    clod_sim *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for a simulation");
        return NULL;
    }
    self->from = from;
    if (options != NULL && options->ranks != NULL) {
        options->ranks->user = self;
    }
    if (!begin(self, options, status)) {
        clod_sim_destroy(&self);
        clod_source_tell(from, status);
    }
    return self;
}

/** A simulation that owns its case, which may be NULL after a failure. */
static clod_sim *create_owning(clod_case *from, const clod_sim_options *options,
                               clod_status *status)
{
    clod_sim *self = from != NULL ? clod_sim_create(from, options, status) : NULL;
    if (self == NULL) {
        clod_case_destroy(&from);
        return NULL;
    }
    self->owned = from;
    return self;
}

clod_sim *clod_sim_create_from_file(const char *path, const clod_sim_options *options,
                                    clod_status *status)
{
    if (!CLOD_GIVEN(path, status)) {
        return NULL;
    }
    pthread_mutex_lock(&clod_sim_case_lock);
    clod_case *from = clod_case_load(path, NULL, 0, status);
    pthread_mutex_unlock(&clod_sim_case_lock);
    return create_owning(from, options, status);
}

clod_sim *clod_sim_create_from_text(const char *name, const char *text,
                                    const clod_sim_options *options, clod_status *status)
{
    if (!CLOD_GIVEN(name, status) || !CLOD_GIVEN(text, status)) {
        return NULL;
    }
    pthread_mutex_lock(&clod_sim_case_lock);
    clod_case *from = clod_case_parse(name, text, strlen(text), NULL, 0, status);
    pthread_mutex_unlock(&clod_sim_case_lock);
    return create_owning(from, options, status);
}

void clod_sim_destroy(clod_sim **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    clod_step_fini(&(*self)->step);
    if ((*self)->options.ranks != NULL) {
        (*self)->options.ranks->user = NULL;
    }
    clod_sim_free_loans(*self);
    clod_state_fini(&(*self)->state);
    clod_laws_fini(&(*self)->laws);
    clod_memory_free((*self)->contacts);
    clod_sim_close_series(*self);
    clod_case_destroy(&(*self)->owned);
    clod_memory_free(*self);
    *self = NULL;
}

bool clod_sim_advance(clod_sim *self, int64_t steps, clod_status *status)
{
    if (!CLOD_GIVEN(self, status)) {
        return false;
    }
    if (steps < 0) {
        return clod_status_fail(status, CLOD_USAGE, "%s: %lld steps; give 0 or more", __func__,
                                (long long)steps);
    }
    if (steps == 0) {
        return true;
    }
    if (!clod_sim_settle(self, status)) {
        return false;
    }
    clod_sim_recall(self);
    return self->measures != NULL ? clod_sim_advance_measured(self, steps, status)
                                  : clod_step_advance(&self->step, steps, status);
}

double clod_sim_time(const clod_sim *self)
{
    CLOD_NEED(self);
    return self->state.time;
}

double clod_sim_dt(const clod_sim *self)
{
    CLOD_NEED(self);
    return self->state.dt;
}

int64_t clod_sim_step(const clod_sim *self)
{
    CLOD_NEED(self);
    return self->state.step;
}

bool clod_sim_set_adhesion(clod_sim *self, double fraction, clod_status *status)
{
    if (!CLOD_GIVEN(self, status)) {
        return false;
    }
    if (!(fraction >= 0.0 && fraction <= 1.0)) {
        return clod_status_fail(status, CLOD_USAGE, "%s: fraction is %g; give 0 to 1", __func__,
                                fraction);
    }
    double before;
    if (!clod_sim_balance(self, &before, status)) {
        return false;
    }
    self->state.adhesion = fraction;
    clod_laws_set_adhesion(&self->laws, fraction);
    if (!self->state.changes.booked) { // else it is booked with what was put elsewhere
        clod_step_book(&self->step, before);
    }
    return true;
}

bool clod_sim_energies(clod_sim *self, clod_sim_energy *energy, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(energy, status)) {
        return false;
    }
    if (!clod_sim_settle(self, status)) {
        return false;
    }
    const clod_energies now = clod_step_energies(&self->step);
    *energy = (clod_sim_energy){.translation = now.translation,
                                .rotation = now.rotation,
                                .potential = now.potential,
                                .normal = now.normal,
                                .sliding = now.sliding,
                                .rolling = now.rolling};
    return true;
}

bool clod_sim_measure(clod_sim *self, clod_sim_bed *bed, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(bed, status) ||
        !clod_sim_settle(self, status)) {
        return false;
    }
    clod_step_reader reader;
    clod_measure_contacts now;
    const clod_contact_source contacts = clod_step_contacts(&self->step, &reader);
    const clod_survey survey = clod_step_survey(&self->step, &contacts);
    if (!clod_measure_contacts_from(&survey, &now, status)) {
        return false;
    }
    *bed = (clod_sim_bed){.pairs = now.pairs,
                          .walls = now.walls,
                          .coordination = now.coordination,
                          .max_overlap = now.max_overlap,
                          .mean_overlap = now.mean_overlap,
                          .max_speed = clod_measure_motion_from(&survey).max_speed};
    return true;
}
