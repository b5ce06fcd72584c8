#include "clod/run.h"

#include <dirent.h>
#include <fnmatch.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "clod/version.h"
#include "output/file.h"
#include "output/folder.h"
#include "sim/free_run.h"
#include "sim/identity.h"
#include "sim/ring_run.h"
#include "sim/trial.h"
#include "sim/uniaxial_run.h"
#include "step/kernel.h"

#define PATH_TEXT 4096

/** Whether there are checkpoints in the folder. */
static bool has_checkpoints(const char *directory)
{
    DIR *folder = opendir(directory);
    bool any = false;
    for (struct dirent *entry; folder != NULL && !any && (entry = readdir(folder)) != NULL;) {
        any = fnmatch("restart*_[ab].h5", entry->d_name, 0) == 0;
    }
    if (folder != NULL) {
        closedir(folder);
    }
    return any;
}

/** Title of a complete case with the words around it, for a message; empty without one. */
static void title_of(const char *complete, char *text, size_t size)
{
    static const char KEY[] = "\ntitle: ";
    const char *line = strstr(complete, KEY);
    text[0] = '\0';
    if (line != NULL) {
        const char *title = line + sizeof KEY - 1;
        snprintf(text, size, " (%.*s)", (int)strcspn(title, "\n"), title);
    }
}

/** Say in what the case differs from that of the run in the folder. */
static void fail_changed(const clod_sim *sim, const char *before, const char *complete,
                         clod_status *status)
{
    char title[256];
    const char *grains = clod_identity_changed_grains(sim->from, before, complete);
    title_of(before, title, sizeof title);
    clod_status_fail(
        status, CLOD_USAGE,
        "%s%s has changed since the run%s in %s was begun; a run cannot go on with "
        "%s. Write to another folder with -o, or remove that run and start over "
        "with --fresh.",
        grains != NULL ? "The grain file " : "The case", grains != NULL ? grains : "", title,
        sim->directory, grains != NULL ? "other grains" : "another case");
}

/**
 * Refuse to go on with another case before its copies in the folder are replaced. Checkpoints
 * know their case too; this is for the copies.
 */
static bool check_same_case(const clod_sim *sim, const char *complete, clod_status *status)
{
    char path[PATH_TEXT];
    void *before;
    size_t size;
    clod_status unread;
    snprintf(path, sizeof path, "%s/case-complete.yaml", sim->directory);
    if (sim->options->fresh || !has_checkpoints(sim->directory) ||
        !clod_file_read(path, &before, &size, &unread)) {
        return true;
    }
    char *identity = clod_identity_text(before);
    const bool same = identity != NULL && strcmp(identity, sim->identity) == 0;
    if (!same) {
        fail_changed(sim, before, complete, status);
    }
    clod_memory_free(identity);
    clod_memory_free(before);
    return same;
}

/** Make the folder ready: clear it when asked, write the copies of the case, open the log. */
static bool fill_folder(clod_sim *sim, const clod_folder *folder, const char *complete,
                        clod_status *status)
{
    char path[PATH_TEXT];
    if (!check_same_case(sim, complete, status)) {
        return false;
    }
    if (sim->options->fresh && !clod_folder_clear(folder, status)) {
        return false;
    }
    if (!clod_folder_write_case(sim->directory, sim->from->text, complete, status)) {
        return false;
    }
    snprintf(path, sizeof path, "%s/log.jsonl", sim->directory);
    sim->log = clod_eventlog_open(path, status);
    return sim->log != NULL;
}

static bool run_case(const clod_sim *sim, char **report, clod_status *status)
{
    clod_eventlog_write(sim->log, "start", "{s:s, s:s, s:s, s:i}", "version",
                        clod_version_text(), "case", sim->from->path, "title",
                        sim->from->title != NULL ? sim->from->title : "", "threads",
                        sim->options->threads);
    if (sim->from->uniaxial.present) {
        return clod_uniaxial_run(sim, report, status);
    }
    return clod_case_shear(sim->from) != NULL ? clod_ring_run(sim, report, status)
                                              : clod_free_run(sim, report, status);
}

/** What can be told before anything is written. */
static bool check_request(const clod_case *from, const clod_run_options *options,
                          clod_status *status)
{
    if (clod_case_tester(from) == NULL && from->stage_count == 0) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: nothing to run: a case needs ring_shear, jenike, uniaxial, or grains, "
            "walls and stages (clod contact runs a contact_bench)",
            from->path);
    }
    return clod_kernel_choose(options->simd) != NULL ||
           clod_status_fail(status, CLOD_USAGE,
                            "instruction set '%s' is unknown or not in this machine; use "
                            "scalar, avx2, avx512 or neon, or leave it out for the best",
                            options->simd);
}

/** Run in a folder that is locked for it. */
static bool run_in_folder(clod_sim *sim, const char *complete, char **report,
                          clod_status *status)
{
    clod_folder *folder = clod_folder_open(sim->directory, status);
    bool ok = folder != NULL && fill_folder(sim, folder, complete, status) &&
              run_case(sim, report, status);
    if (ok && *report == NULL) {
        ok = clod_status_fail(status, CLOD_FAILED, "no memory for the report");
    }
    clod_status log_status;
    if (!clod_eventlog_close(&sim->log, &log_status) && ok) {
        *status = log_status;
        ok = false;
    }
    clod_folder_close(&folder);
    return ok;
}

bool clod_run(const clod_case *self, const clod_run_options *options, char **report,
              clod_status *status)
{
    *report = NULL;
    if (!check_request(self, options, status) ||
        (options->fresh && !clod_trial_run(self, options, status))) {
        return false;
    }
    char *complete = clod_identity_complete(self, status);
    if (complete == NULL) {
        return false;
    }
    char *standard = options->directory == NULL ? clod_folder_default(self->path) : NULL;
    char *identity = clod_identity_text(complete);
    clod_sim sim = {.from = self,
                    .options = options,
                    .directory = standard != NULL ? standard : options->directory,
                    .identity = identity};
    const bool ok = sim.directory != NULL && identity != NULL
                        ? run_in_folder(&sim, complete, report, status)
                        : clod_status_fail(status, CLOD_FAILED, "no memory for %s", self->path);
    clod_memory_free(standard);
    clod_memory_free(identity);
    clod_memory_free(complete);
    return ok;
}

void clod_run_free(char *report)
{
    clod_memory_free(report);
}
