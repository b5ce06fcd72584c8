#include "report/run_files.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/json.h"
#include "base/memory.h"
#include "config/yaml.h"
#include "output/file.h"
#include "report/calibration_page.h"
#include "report/run_damage.h"
#include "report/run_kinds.h"

#define TIME_LENGTH strlen("2026-01-31T12:00") ///< what the head of a page shows

/** Read a text of the folder; none there is fine. */
static bool load_text(const clod_run_files *self, const char *name, char **text,
                      clod_status *status)
{
    char path[4096];
    void *bytes;
    size_t size;
    snprintf(path, sizeof path, "%s/%s", self->folder, name);
    const int error = clod_file_load(AT_FDCWD, path, &bytes, &size);
    *text = error == 0 ? bytes : NULL;
    return error == 0 || error == ENOENT || clod_file_fail(status, "read", path, error);
}

static bool load_summary(clod_run_files *self, clod_status *status)
{
    char *text;
    json_error_t error;
    if (!load_text(self, "summary.json", &text, status)) {
        return false;
    }
    self->summary = text != NULL ? clod_json_parse(text, strlen(text), &error) : NULL;
    const bool good = text == NULL || json_is_object(self->summary);
    clod_memory_free(text);
    if (!good && clod_json_lacks_memory()) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %s/summary.json.",
                                self->folder);
    }
    return good ||
           clod_status_fail(status, CLOD_USAGE, "%s/summary.json is damaged: line %d, %s.",
                            self->folder, error.line, error.text);
}

/** Keep what a line of the log tells of a run that has no summary yet: who computes it, and a part of it. */
static void take_line(clod_run_files *self, const char *line)
{
    json_t *entry = json_loadb(line, strcspn(line, "\n"), 0, NULL);
    json_t *version = json_object_get(entry, "version");
    json_t *name = json_object_get(entry, "part");
    json_t *parts = json_object_get(self->log, "parts");
    if (json_is_string(version)) {
        json_object_set(self->log, "version", version);
    }
    bool known = !json_is_string(name);
    size_t k;
    const json_t *part;
    json_array_foreach(parts, k, part)
    {
        known = known || json_equal(json_object_get(part, "part"), name);
    }
    if (!known) {
        json_array_append_new(parts, json_pack("{s:O}", "part", name));
    }
    json_decref(entry);
}

/** The time in the first and the last line of the log that have a whole one, and what these lines tell. */
static bool load_times(clod_run_files *self, clod_status *status)
{
    static const char KEY[] = "{\"time\":\"";
    char *text;
    if (!load_text(self, "log.jsonl", &text, status)) {
        return false;
    }
    self->log = json_pack("{s:[]}", "parts");
    for (const char *line = text != NULL ? strstr(text, KEY) : NULL; line != NULL;
         line = strstr(line + 1, KEY)) {
        const char *at = line + strlen(KEY);
        const size_t length = strcspn(at, "\"\n");
        char time[32];
        if (length < TIME_LENGTH || at[length] != '"') {
            continue; // the line is just being written
        }
        snprintf(time, sizeof time, "%.*s", (int)length, at);
        if (self->began == NULL) {
            self->began = clod_memory_text(time);
        }
        clod_memory_free(self->ended);
        self->ended = clod_memory_text(time);
        take_line(self, line);
    }
    clod_memory_free(text);
    return true;
}

/** Title of the complete case, owned; NULL: it has none. */
static char *read_title(const clod_run_files *self)
{
    clod_arena arena = {0};
    clod_report errors = {.name =
                              "case-complete.yaml"}; // a case that cannot be read has no title
    const char *text = self->complete != NULL ? self->complete : "";
    const clod_node *title =
        clod_tree_find(clod_yaml_read(&arena, text, strlen(text), 0, &errors), "title");
    const bool good =
        title != NULL && title->kind == CLOD_NODE_SCALAR && title->text[0] != '\0';
    char *copy = good ? clod_memory_text(title->text) : NULL;
    clod_report_fini(&errors);
    clod_arena_fini(&arena);
    return copy;
}

/** The title of the summary, or in the complete case, or the folder. */
static void find_title(clod_run_files *self)
{
    const char *known = json_string_value(json_object_get(self->summary, "title"));
    self->title =
        known != NULL && known[0] != '\0' ? clod_memory_text(known) : read_title(self);
    if (self->title == NULL) {
        self->title = clod_memory_text(self->folder);
    }
}

/** Refuse what is there, but is no folder: a design, a table, a case. */
static bool is_folder(const char *folder, clod_status *status)
{
    struct stat about;
    const char *ending = strrchr(folder, '.');
    const bool design = ending != NULL && strcmp(ending, ".json") == 0;
    return stat(folder, &about) != 0 || S_ISDIR(about.st_mode) ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s is a file, not the results folder of a run. Name a folder, e.g. run/first%s.",
               folder, design ? "; clod hopper -o writes the page of a design itself" : "");
}

/** Say why a folder is not that of a run. */
static bool fail_other(const char *folder, clod_status *status)
{
    if (access(folder, F_OK) != 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s does not exist. Name the results folder "
                                "of a run, e.g. run/first.",
                                folder);
    }
    return clod_status_fail(
        status, CLOD_USAGE,
        clod_calibration_page_is(folder)
            ? "%s is the results folder of a calibration, not of a run: clod report makes a page "
              "of it; clod compare takes runs, also those in its folder runs."
            : "%s is not the results folder of a run: it has no file case-complete.yaml. Name "
              "one, e.g. run/first.",
        folder);
}

bool clod_run_files_open(clod_run_files *self, const char *folder, clod_status *status)
{
    *self = (clod_run_files){.folder = clod_memory_text(folder)};
    if (self->folder == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the report.");
    }
    for (size_t k = strlen(self->folder); k > 1 && self->folder[k - 1] == '/'; k--) {
        self->folder[k - 1] = '\0';
    }
    if (!is_folder(self->folder, status) ||
        !load_text(self, "case-complete.yaml", &self->complete, status) ||
        !load_text(self, "case.yaml", &self->case_text, status) ||
        !load_text(self, "report.txt", &self->report, status) || !load_summary(self, status) ||
        !load_times(self, status)) {
        return false;
    }
    if (self->complete == NULL) {
        return fail_other(self->folder, status);
    }
    find_title(self);
    self->kind = clod_run_kinds_of(self->complete);
    if (self->title == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the report.");
    }
    return clod_run_damage_look(self, status);
}

/** Put one more folder of the path before the name; false: the name is the whole path. */
static bool lengthen(clod_run_files *self)
{
    const char *at = self->name;
    while (at > self->folder && at[-1] == '/') {
        at--;
    }
    while (at > self->folder && at[-1] != '/') {
        at--;
    }
    const bool longer = at < self->name;
    self->name = at;
    return longer;
}

/** Lengthen all names that are that of run k; whether any became longer. */
static bool part_names(clod_run_files *runs, size_t count, size_t k)
{
    const char *name = runs[k].name;
    bool longer = false;
    bool shared = false;
    for (size_t j = k + 1; j < count; j++) {
        if (strcmp(runs[j].name, name) == 0) {
            shared = true;
            longer = lengthen(&runs[j]) || longer;
        }
    }
    return (shared && lengthen(&runs[k])) || longer;
}

void clod_run_files_names(clod_run_files *runs, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        runs[k].name = runs[k].folder + strlen(runs[k].folder);
        lengthen(&runs[k]);
    }
    for (bool longer = true; longer;) {
        longer = false;
        for (size_t k = 0; k < count; k++) {
            longer = part_names(runs, count, k) || longer;
        }
    }
}

const char *clod_run_files_part(const clod_run_files *self, size_t k)
{
    const json_t *from = self->summary != NULL ? self->summary : self->log;
    const json_t *part = json_array_get(json_object_get(from, "parts"), k);
    return json_string_value(json_object_get(part, "part"));
}

const char *clod_run_files_version(const clod_run_files *self)
{
    const json_t *from = self->summary != NULL ? self->summary : self->log;
    return json_string_value(json_object_get(from, "version"));
}

void clod_run_files_gravity(const clod_run_files *self, double gravity[3])
{
    clod_arena arena = {0};
    clod_report errors = {.name = "case-complete.yaml"};
    const clod_node *found = clod_tree_find(
        clod_yaml_read(&arena, self->complete, strlen(self->complete), 0, &errors), "gravity");
    for (size_t a = 0; a < 3; a++) {
        const bool there = found != NULL && found->kind == CLOD_NODE_LIST &&
                           found->count == 3 && found->items[a]->kind == CLOD_NODE_SCALAR;
        gravity[a] = there ? strtod(found->items[a]->text, NULL) : 0.0;
    }
    clod_report_fini(&errors);
    clod_arena_fini(&arena);
}

void clod_run_files_fini(clod_run_files *self)
{
    json_decref(self->summary);
    json_decref(self->log);
    json_decref(self->damage);
    clod_memory_free(self->folder);
    clod_memory_free(self->title);
    clod_memory_free(self->case_text);
    clod_memory_free(self->complete);
    clod_memory_free(self->report);
    clod_memory_free(self->began);
    clod_memory_free(self->ended);
    *self = (clod_run_files){0};
}
