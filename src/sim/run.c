#include "clod/run.h"

#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "base/given.h"
#include "base/memory.h"
#include "clod/ranks.h"
#include "clod/version.h"
#include "config/source.h"
#include "config/testers.h"
#include "output/folder_files.h"
#include "output/folder_names.h"
#include "parallel/threads.h"
#include "setup/begin.h"
#include "sim/earlier.h"
#include "sim/identity.h"
#include "sim/origin.h"
#include "sim/ranks_log.h"
#include "sim/sim.h"
#include "sim/testers.h"
#include "sim/trial.h"
#include "step/kernel.h"

/** Make the folder ready: clear it when asked, write the copies of the case, open the log. */
static bool fill_folder(clod_job_shared *sim, const char *complete, clod_status *status)
{
    if (sim->options->fresh && !clod_folder_clear(sim->folder, status)) {
        return false;
    }
    if (!clod_folder_write_case(sim->folder, sim->from->text, complete, status)) {
        return false;
    }
    sim->log = clod_eventlog_open(sim->folder, "log.jsonl", status);
    return sim->log != NULL;
}

static bool run_case(const clod_job_shared *sim, char **report, clod_status *status)
{
    const bool one = sim->options->ranks != NULL && sim->any_threads; // of each rank
    clod_eventlog_write(sim->log, "start", "{s:s, s:s, s:s, s:i}", "version",
                        clod_version_text(), "case", sim->from->path, "title",
                        sim->from->title != NULL ? sim->from->title : "", "threads",
                        one ? 1 : sim->options->threads);
    clod_ranks_log_places(sim);
    return clod_testers_of(sim->from)->run(sim, report, status);
}

/** What can be told before anything is written. */
static bool check_request(const clod_case *from, const clod_run_options *options,
                          clod_status *status)
{
    if (options->ranks != NULL &&
        !clod_sim_ranks_are_free(options->ranks, "clod_run", status)) {
        return false;
    }
    const bool stages = clod_case_tester(from) != NULL || from->stage_count > 0;
    if (clod_testers_of(from)->run == NULL || !stages) {
        char testers[CLOD_CONFIG_TESTER_KEYS];
        clod_config_tester_keys(testers);
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: nothing to run: a case needs %s, or grains, walls and "
                                "stages (clod contact runs a contact_bench)",
                                from->path, testers);
    }
    if (!clod_begin_has_grains(from, status)) {
        return false;
    }
    return clod_kernel_choose(options->simd) != NULL ||
           clod_status_fail(status, CLOD_USAGE,
                            "instruction set '%s' is unknown or not in this machine; use "
                            "scalar, avx2, avx512 or neon, or leave it out for the best",
                            options->simd);
}

static bool close_log(clod_job_shared *sim, bool ok, clod_status *status)
{
    clod_status log_status;
    if (!clod_eventlog_close(&sim->log, &log_status) && ok) {
        *status = log_status;
        ok = false;
    }
    return ok;
}

/** Run in a folder that is locked for it. */
static bool run_in_folder(clod_job_shared *sim, const char *complete, char **report,
                          clod_status *status)
{
    clod_folder *folder = clod_folder_open(sim->directory, status);
    sim->folder = folder;
    const clod_earlier earlier = folder != NULL
                                     ? clod_earlier_look(sim, complete, report, status)
                                     : CLOD_EARLIER_REFUSED;
    bool ok = earlier == CLOD_EARLIER_DONE;
    if (ok && sim->options->notice != NULL) {
        sim->options->notice(sim->options->context,
                             "the checkpoints are gone, but this run is complete: here is its "
                             "table (--fresh runs it again)");
    }
    if (earlier == CLOD_EARLIER_GO_ON) {
        // a run whose checkpoints are lost can only read its report
        ok = fill_folder(sim, complete, status) && run_case(sim, report, status) &&
             clod_folder_write(sim->folder, "report.txt", *report, status);
        clod_ranks_log_work(sim);
        ok = close_log(sim, ok, status);
    }
    clod_folder_close(&folder);
    return ok;
}

/** No more threads than processors; says so when more were asked for. */
static clod_run_options fit_threads(const clod_run_options *wanted)
{
    clod_run_options options = *wanted;
    options.threads = clod_threads_take(wanted->threads);
    if (wanted->threads > options.threads && wanted->notice != NULL) {
        char text[120];
        snprintf(text, sizeof text,
                 "warning: %d threads on %d processors slow each other down: %d are used",
                 wanted->threads, options.threads, options.threads);
        wanted->notice(wanted->context, text);
    }
    return options;
}

/**
 * The run that this one begins from, which is tried before anything is written, unless this
 * one has begun already and only goes on.
 */
static bool open_origin(clod_job_shared *sim, clod_origin *origin, clod_status *status)
{
    const clod_run_options *options = sim->options;
    bool begun = false;
    if (options->from == NULL) {
        return true;
    }
    sim->origin = origin;
    if (!clod_origin_name(origin, sim, status) ||
        (!options->fresh && !clod_earlier_has_checkpoints(sim->directory, &begun, status))) {
        return false;
    }
    return begun || (clod_origin_open(origin, sim, status) &&
                     clod_testers_of(sim->from)->try_origin(sim, status));
}

bool clod_run(const clod_case *self, const clod_run_options *options, char **report,
              clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(options, status) ||
        !CLOD_GIVEN(report, status)) {
        return false;
    }
    const double begin = clod_clock_now();
    const clod_run_options fitted = fit_threads(options);
    *report = NULL;
    if (!check_request(self, &fitted, status) ||
        (fitted.fresh && fitted.from == NULL && !clod_trial_run(self, &fitted, 0, status))) {
        return clod_source_tell(self, status);
    }
    char *complete = clod_identity_complete(self, status);
    if (complete == NULL) {
        return false;
    }
    char *identity = clod_identity_text(complete);
    char *standard = NULL;
    if (identity == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for %s", self->path);
    } else if (fitted.directory == NULL) {
        standard = clod_folder_default(self->path, status);
    }
    clod_job_shared sim = {.from = self,
                           .options = &fitted,
                           .limit = {begin, options->time_limit},
                           .any_threads = options->threads == 0,
                           .directory = standard != NULL ? standard : fitted.directory,
                           .identity = identity};
    clod_origin origin = {0};
    const bool ok = identity != NULL && sim.directory != NULL &&
                    open_origin(&sim, &origin, status) &&
                    run_in_folder(&sim, complete, report, status);
    clod_origin_fini(&origin);
    clod_memory_free(standard);
    clod_memory_free(identity);
    clod_memory_free(complete);
    return ok || clod_source_tell(self, status);
}

void clod_run_free(char *report)
{
    clod_memory_free(report);
}
