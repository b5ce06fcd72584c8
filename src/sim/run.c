#include "clod/run.h"

#include <stdio.h>

#include "base/memory.h"
#include "clod/version.h"
#include "output/folder.h"
#include "sim/free_run.h"
#include "sim/ring_run.h"

#define PATH_TEXT 4096

/** Files of a ring shear test that --fresh removes beside the usual ones. */
static const char *const OWN_FILES[] = {
    "points.csv",        "preshear.csv",   "point-[0-9]*.csv",   "seed-[0-9]*-*.csv",
    "restart-*_[ab].h5", "preshear_*.hdf", "point-[0-9]*_*.hdf", "seed-[0-9]*_*.hdf",
};

/** Make the folder ready: clear it when asked, write the copies of the case, open the log. */
static bool open_folder(clod_sim *sim, char *effective, clod_status *status)
{
    char path[PATH_TEXT];
    if (sim->options->fresh &&
        !clod_folder_clear(sim->directory, OWN_FILES, sizeof OWN_FILES / sizeof *OWN_FILES,
                           status)) {
        return false;
    }
    if (!clod_folder_write_case(sim->directory, sim->from->text, effective, status)) {
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
    return sim->from->ring_shear.present ? clod_ring_run(sim, report, status)
                                         : clod_free_run(sim, report, status);
}

bool clod_run(const clod_case *self, const clod_run_options *options, char **report,
              clod_status *status)
{
    *report = NULL;
    if (!self->ring_shear.present && self->stage_count == 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: nothing to run: a case needs ring_shear, or grains, walls "
                                "and stages (clod contact runs a contact_bench)",
                                self->path);
    }
    char *standard = options->directory == NULL ? clod_folder_default(self->path) : NULL;
    char *effective = clod_case_echo(self);
    const char *directory = standard != NULL ? standard : options->directory;
    clod_folder *folder =
        directory != NULL && effective != NULL ? clod_folder_open(directory, status) : NULL;
    clod_sim sim = {
        .from = self, .options = options, .directory = directory, .effective = effective};
    bool ok = folder != NULL && open_folder(&sim, effective, status) &&
              run_case(&sim, report, status);
    clod_status log_status;
    if (!clod_eventlog_close(&sim.log, &log_status) && ok) {
        *status = log_status;
        ok = false;
    }
    clod_folder_close(&folder);
    clod_memory_free(standard);
    clod_memory_free(effective);
    return ok;
}

void clod_run_free(char *report)
{
    clod_memory_free(report);
}
