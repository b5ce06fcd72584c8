#include "calibrate/calibrate.h"

#include <stdio.h>

#include "base/given.h"
#include "base/memory.h"
#include "calibrate/estimate.h"
#include "calibrate/plan.h"
#include "calibrate/result.h"
#include "calibrate/runs.h"
#include "calibrate/study.h"
#include "output/folder_files.h"
#include "parallel/threads.h"

/** Write a text that was made, and free it. */
static bool put(const clod_folder *folder, const char *name, char *text, clod_status *status)
{
    const bool good = clod_folder_write(folder, name, text, status);
    clod_memory_free(text);
    return good;
}

/** The runs as a table. */
static bool put_runs(const clod_runs *runs, const clod_study *study, clod_status *status)
{
    const size_t points = runs->points < study->points ? runs->points : study->points;
    return put(runs->folder, "runs.csv",
               clod_runs_csv(runs, points, study->places, study->results), status);
}

/** The runs of a calibration that came to no end; results of an earlier end stay together as they are. */
static void put_unfinished(const clod_runs *runs, const clod_study *study)
{
    clod_status second; // the first failure is told
    bool finished;
    if (clod_folder_has(runs->folder, "calibration.json", &finished, &second) && !finished) {
        (void)put_runs(runs, study, &second);
    }
}

static bool put_all(const clod_plan *plan, const clod_runs *runs, const clod_study *study,
                    char **report, clod_status *status)
{
    clod_result *result = clod_memory_alloc(1, sizeof *result);
    if (result == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the result.");
    }
    *result = (clod_result){.plan = plan, .study = study, .runs = runs};
    clod_result_warn(result);
    *report = clod_result_table(result);
    const bool good = clod_folder_write(runs->folder, "plan.yaml", plan->text, status) &&
                      put(runs->folder, "card.yaml", clod_result_card(result), status) &&
                      put(runs->folder, "posterior.csv", clod_result_samples(result), status) &&
                      put(runs->folder, "calibration.json", clod_result_json(result), status) &&
                      put(runs->folder, "report.txt", clod_memory_text(*report), status);
    clod_memory_free(result);
    return good;
}

/** What the course of the study says, by way of the runs, which are its context. */
static void tell(void *context, const char *text)
{
    const clod_runs *runs = context;
    if (runs->options.tell != NULL) {
        runs->options.tell(runs->options.context, text);
    }
}

static void tell_all(const clod_warning_list *list, void (*say)(void *, const char *),
                     void *context)
{
    for (size_t k = 0; k < list->count && say != NULL; k++) {
        char text[CLOD_WARNING_LIST_TEXT + 16];
        snprintf(text, sizeof text, "WARNING: %s", list->text[k]);
        say(context, text);
    }
}

/** A number that the first point does not define will lack in others too: told before they are run, with the reason. */
static void tell_lacks(const clod_runs *runs)
{
    for (size_t t = 0; t < runs->plan->target_count; t++) {
        char reason[CLOD_RUNS_REASON], text[CLOD_PLAN_NAME + CLOD_RUNS_REASON + 192];
        if (runs->options.tell != NULL && clod_runs_lacks(runs, t, reason)) {
            const clod_plan_target *of = &runs->plan->targets[t];
            snprintf(
                text, sizeof text,
                "%s is not defined in the middle of all ranges, in %s; if so few points have it that it gets no "
                "surrogate, %s",
                of->name, reason,
                of->held_back ? "it is not predicted" : "the calibration comes to no result");
            runs->options.tell(runs->options.context, text);
        }
    }
}

/** What the first point lacks, and whether it lies outside the tables that it is compared with: before the others are run. */
static void look_at_first(void *context)
{
    const clod_runs *runs = context;
    tell_lacks(runs);
    clod_warning_list *list = clod_memory_alloc(1, sizeof *list);
    if (list != NULL) {
        clod_runs_warn_outside(runs, list);
        tell_all(list, runs->options.tell, runs->options.context);
    }
    clod_memory_free(list);
}

static bool stopped(void *context)
{
    return atomic_load((clod_run_signal *)context) != 0;
}

static int workers_of(const clod_calibrate_options *options)
{
    return options->workers > 0 ? options->workers : clod_threads_available();
}

/** What the runs would take, and what is doubtful about their cases. */
static bool tell_estimate(const clod_plan *plan, const clod_calibrate_options *options,
                          clod_warning_list *warnings, clod_status *status)
{
    char text[512];
    clod_estimate estimate;
    const int workers = workers_of(options);
    if (!clod_estimate_make(plan, workers, &estimate, warnings, status)) {
        return false;
    }
    tell_all(warnings, options->tell, options->context);
    clod_estimate_text(&estimate, plan, workers, text, sizeof text);
    if (clod_estimate_hopeless(&estimate, plan)) {
        return clod_status_fail(status, CLOD_USAGE, "%s: %s", plan->path, text);
    }
    if (options->tell != NULL) {
        options->tell(options->context, text);
    }
    return true;
}

/** The plan without its runs: the folder that they would go into, the preflight of its cases. */
static bool look(const clod_plan *plan, const char *directory,
                 const clod_calibrate_options *options, clod_status *status)
{
    if (!clod_runs_look(plan, directory, status)) {
        return false;
    }
    clod_warning_list *warnings = clod_memory_alloc(1, sizeof *warnings);
    const bool good = warnings != NULL ? tell_estimate(plan, options, warnings, status)
                                       : clod_status_fail(status, CLOD_FAILED,
                                                          "No memory to check the cases.");
    clod_memory_free(warnings);
    return good;
}

/** Design, runs, posterior, files. */
static bool work(const clod_plan *plan, const char *directory,
                 const clod_calibrate_options *options, char **report, clod_status *status)
{
    const clod_stop stop = {.asked = stopped, .context = options->stop};
    const clod_runs_options how = {.program = options->program,
                                   .workers = workers_of(options),
                                   .stop = options->stop != NULL ? &stop : NULL,
                                   .tell = options->tell,
                                   .context = options->context};
    clod_runs *runs = clod_runs_open(plan, directory, &how, status);
    if (runs == NULL) {
        return false;
    }
    const clod_study_source source = {.compute = clod_runs_compute,
                                      .seconds = clod_runs_seconds,
                                      .tell = tell,
                                      .look = look_at_first,
                                      .context = runs,
                                      .stop = how.stop};
    clod_study study;
    bool good = clod_study_run(plan, &source, &study, status);
    if (good) {
        good = put_runs(runs, &study, status) && put_all(plan, runs, &study, report, status);
    } else {
        put_unfinished(runs, &study);
    }
    clod_study_fini(&study);
    clod_runs_close(&runs);
    return good;
}

bool clod_calibrate_run(const char *path, const clod_calibrate_options *options, char **report,
                        clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(options, status) ||
        !CLOD_GIVEN(report, status)) {
        return false;
    }
    *report = NULL;
    clod_plan plan;
    bool good =
        clod_plan_load(path, options->overrides, options->override_count, &plan, status);
    char *standard =
        good && options->directory == NULL ? clod_folder_default(path, status) : NULL;
    const char *directory = options->directory != NULL ? options->directory : standard;
    good = good && directory != NULL;
    if (good) {
        tell_all(&plan.warnings, options->tell, options->context); // before hours are spent
    }
    if (good) {
        good = options->dry ? look(&plan, directory, options, status)
                            : work(&plan, directory, options, report, status);
    }
    clod_memory_free(standard);
    clod_plan_fini(&plan);
    return good;
}

void clod_calibrate_free(char *text)
{
    clod_memory_free(text);
}
