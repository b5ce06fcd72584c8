#include "sim/earlier.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/memory.h"
#include "output/checkpoint.h"
#include "output/folder_files.h"
#include "output/folder_names.h"
#include "sim/identity.h"

#define CHECKPOINT "^restart(-" CLOD_FOLDER_PART ")?_[ab][.]h5$"
#define TABLE "^(series|" CLOD_FOLDER_PART ")[.]csv$"
#define OTHER_RESULT                                                                           \
    "^(summary[.]json|points[.]csv|flow_function[.]csv|(" CLOD_FOLDER_PART                     \
    "_)?snap_[0-9]+[.]hdf)$"

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
static void fail_changed(const clod_job_shared *sim, const char *before, const char *complete,
                         clod_status *status)
{
    char title[256];
    const char *file = clod_identity_changed_file(sim->from, before, complete);
    title_of(before, title, sizeof title);
    clod_status_fail(
        status, CLOD_USAGE,
        "%s%s has changed since the run%s in %s was begun; a run cannot go on with "
        "%s. Write to another folder with -o, or remove that run and start over "
        "with --fresh.",
        file != NULL ? "The file " : "The case", file != NULL ? file : "", title,
        sim->directory, file != NULL ? "another file" : "another case");
}

static bool is_same_case(const clod_job_shared *sim, const char *complete, clod_status *status)
{
    void *before;
    size_t size;
    if (!clod_folder_read(sim->folder, "case-complete.yaml", &before, &size, status)) {
        return false;
    }
    if (before == NULL) {
        return true;
    }
    char *identity = clod_identity_text(before);
    const bool same = identity != NULL && strcmp(identity, sim->identity) == 0;
    if (identity == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory to compare the case with that of %s",
                         sim->directory);
    } else if (!same) {
        fail_changed(sim, before, complete, status);
    }
    clod_memory_free(identity);
    clod_memory_free(before);
    return same;
}

/** What is in the folder. */
typedef struct leftovers {
    const clod_folder *folder;
    bool checkpoints;
    char lost[NAME_MAX + 1];   ///< a table with rows whose checkpoints are gone; "": none
    char result[NAME_MAX + 1]; ///< any other result; "": none
} leftovers;

static bool note_checkpoint(void *context, const char *name, clod_status *status)
{
    (void)name;
    (void)status;
    ((leftovers *)context)->checkpoints = true;
    return true;
}

static bool note_result(void *context, const char *name, clod_status *status)
{
    leftovers *self = context;
    (void)status;
    snprintf(self->result, sizeof self->result, "%s", name);
    return true;
}

/** Whether a table has a row behind its header. */
static bool has_rows(const clod_folder *folder, const char *name, bool *rows,
                     clod_status *status)
{
    void *text;
    size_t size;
    if (!clod_folder_read(folder, name, &text, &size, status)) {
        return false;
    }
    const char *line = text != NULL ? strchr(text, '\n') : NULL;
    *rows = line != NULL && line[1] != '\0';
    clod_memory_free(text);
    return true;
}

/** A table with rows of a part that has no checkpoint. */
static bool note_table(void *context, const char *name, clod_status *status)
{
    leftovers *self = context;
    char stem[NAME_MAX + 16];
    bool exists = true, rows = false;
    const int length = (int)strcspn(name, ".");
    const bool plain = strncmp(name, "series", (size_t)length) == 0;
    snprintf(stem, sizeof stem, "restart%s%.*s", plain ? "" : "-", plain ? 0 : length, name);
    if (!clod_checkpoint_exists(self->folder, stem, &exists, status) ||
        !has_rows(self->folder, name, &rows, status)) {
        return false;
    }
    if (!exists && rows) {
        snprintf(self->lost, sizeof self->lost, "%s", name);
    }
    return true;
}

static bool find_leftovers(leftovers *self, const clod_folder *folder, clod_status *status)
{
    *self = (leftovers){.folder = folder};
    return clod_folder_names_each(folder, CHECKPOINT, note_checkpoint, self, status) &&
           clod_folder_names_each(folder, TABLE, note_table, self, status) &&
           clod_folder_names_each(folder, OTHER_RESULT, note_result, self, status);
}

bool clod_earlier_has_checkpoints(const char *directory, bool *found, clod_status *status)
{
    struct stat info;
    leftovers all = {0};
    *found = false;
    if (stat(directory, &info) == 0 ? !S_ISDIR(info.st_mode)
                                    : errno == ENOENT || errno == ENOTDIR) {
        return true; // it is made, or refused, when it is opened
    }
    clod_folder *folder = clod_folder_look(directory, status);
    const bool read = folder != NULL &&
                      clod_folder_names_each(folder, CHECKPOINT, note_checkpoint, &all, status);
    clod_folder_close(&folder);
    *found = all.checkpoints;
    return read;
}

/** The table of a finished run, from its text file; NULL when there is none. */
static bool read_report(const clod_folder *folder, char **report, clod_status *status)
{
    void *text;
    size_t size;
    bool finished;
    *report = NULL;
    if (!clod_folder_has(folder, "summary.json", &finished, status) ||
        (finished && !clod_folder_read(folder, "report.txt", &text, &size, status))) {
        return false;
    }
    *report = finished ? text : NULL;
    return true;
}

clod_earlier clod_earlier_look(const clod_job_shared *sim, const char *complete, char **report,
                               clod_status *status)
{
    leftovers found;
    if (sim->options->fresh) {
        return CLOD_EARLIER_GO_ON;
    }
    if (!find_leftovers(&found, sim->folder, status)) {
        return CLOD_EARLIER_REFUSED;
    }
    const bool lost = found.lost[0] != '\0' || (!found.checkpoints && found.result[0] != '\0');
    if ((lost || found.checkpoints) && !is_same_case(sim, complete, status)) {
        return CLOD_EARLIER_REFUSED;
    }
    if (!lost) {
        return CLOD_EARLIER_GO_ON;
    }
    if (!read_report(sim->folder, report, status)) {
        return CLOD_EARLIER_REFUSED;
    }
    if (*report != NULL) {
        return CLOD_EARLIER_DONE;
    }
    clod_status_fail(
        status, CLOD_USAGE,
        "%s/%s holds results, but the checkpoints that belong to it are gone: the run cannot "
        "go on, and beginning anew would write over what is there. Nothing was changed. Put "
        "the files restart*_a.h5 and restart*_b.h5 back, write to another folder with -o, or "
        "remove the results and start over with --fresh.",
        sim->directory, found.lost[0] != '\0' ? found.lost : found.result);
    return CLOD_EARLIER_REFUSED;
}
