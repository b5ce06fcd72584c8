#include "calibrate/rows.h"

#include <errno.h>
#include <fcntl.h>
#include <jansson.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/input.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "clod/version.h"
#include "output/file.h"
#include "output/folder_files.h"
#include "output/folder_names.h"

#define MARK "design.txt"
#define MOST_SHOWN 160 ///< bytes of a line of it
#define SHOWN (MOST_SHOWN + 8)
#define LAST_BYTES 2000 ///< of a log that are looked at
#define WORDS 400       ///< bytes kept of them

static const char *const STATES[] = {NULL, "begun", "done", "failed"}; // of clod_runs_state

char *clod_rows_settings(const clod_plan *plan, size_t row, const double *places)
{
    const size_t point = clod_runs_point_of(plan, row);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out, "seed=%lld", (long long)clod_runs_seed(plan, row));
    clod_plan_settings settings;
    text.lost = !clod_plan_settings_at(plan, &plan->tests[clod_runs_test_of(plan, row)],
                                       places + point * plan->parameter_count, &settings) ||
                text.lost;
    for (size_t k = 0; k < settings.count; k++) {
        fprintf(out, "; %s", settings.items[k]);
    }
    clod_plan_settings_fini(&settings);
    return clod_text_close(&text);
}

/** A row as the file has it into `to`, when it has the same settings; whether it is in order. */
static bool take(const json_t *found, clod_runs_row *to)
{
    const char *state = json_string_value(json_object_get(found, "state"));
    const char *settings = json_string_value(json_object_get(found, "settings"));
    const json_t *seconds = json_object_get(found, "seconds");
    if (state == NULL || settings == NULL || !json_is_number(seconds)) {
        return false;
    }
    for (int k = CLOD_RUNS_BEGUN; k <= CLOD_RUNS_FAILED; k++) {
        if (strcmp(state, STATES[k]) == 0) {
            if (strcmp(settings, to->settings) == 0) {
                to->state = (clod_runs_state)k;
                to->seconds = json_number_value(seconds);
                to->why = clod_memory_text(json_string_value(json_object_get(found, "why")));
            }
            return true;
        }
    }
    return false;
}

bool clod_rows_read(const clod_runs *runs, size_t row, clod_runs_row *to, clod_status *status)
{
    char path[PATH_MAX];
    clod_runs_path(runs, row, ".json", path);
    bool there;
    if (!clod_file_is_there(path, &there, status)) {
        return false;
    }
    if (!there) {
        return true;
    }
    char *text;
    size_t length;
    if (!clod_input_read_regular(path, (size_t)1 << 20, &text, &length, status)) {
        return false;
    }
    json_t *found = clod_json_parse(text, length, NULL);
    clod_memory_free(text);
    const bool good = take(found, to);
    json_decref(found);
    if (clod_json_lacks_memory()) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %s.", path);
    }
    return good || clod_status_fail(status, CLOD_USAGE,
                                    "%s: damaged; remove it, and the run is done again", path);
}

bool clod_rows_write(const clod_runs *runs, size_t row, clod_status *status)
{
    char path[PATH_MAX];
    const clod_runs_row *from = &runs->rows[row];
    clod_runs_path(runs, row, ".json", path);
    json_t *made = json_pack("{s:s, s:s, s:f, s:s*}", "settings", from->settings, "state",
                             STATES[from->state], "seconds", from->seconds, "why", from->why);
    char *text = clod_json_text(made, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    json_decref(made);
    if (text == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %s.", path);
    }
    char name[CLOD_RUNS_NAME];
    char parent[PATH_MAX];
    clod_runs_name(runs->plan, row, ".json", name);
    snprintf(parent, sizeof parent, "%s/" CLOD_RUNS_FOLDER, runs->folder->path);
    clod_folder *inside = clod_folder_look(parent, status);
    const bool good = inside != NULL && clod_folder_write(inside, name, text, status);
    clod_folder_close(&inside);
    clod_memory_free(text);
    return good;
}

void clod_rows_forget(const clod_runs *runs, size_t row)
{
    char path[PATH_MAX];
    clod_runs_path(runs, row, ".json", path);
    (void)unlink(path); // what stays is told by clod run: the case has changed
}

bool clod_rows_in_use(const char *folder)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/" CLOD_FOLDER_LOCK, folder);
    const int file = open(path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0) {
        return false;
    }
    const bool held = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    close(file);
    return held;
}

/** Seconds from one file's last change to another's; 0 without them. */
static double between(const char *from, const char *to)
{
    struct stat first;
    struct stat last;
    if (stat(from, &first) != 0 || stat(to, &last) != 0) {
        return 0.0;
    }
    const double seconds = difftime(last.st_mtim.tv_sec, first.st_mtim.tv_sec) +
                           1e-9 * (double)(last.st_mtim.tv_nsec - first.st_mtim.tv_nsec);
    return seconds > 0.0 ? seconds : 0.0;
}

bool clod_rows_begin(const clod_runs *runs, size_t row, clod_status *status)
{
    clod_runs_row *of = &runs->rows[row];
    char path[PATH_MAX];
    char json[PATH_MAX];
    char log[PATH_MAX];
    clod_runs_path(runs, row, "", path);
    clod_runs_path(runs, row, ".json", json);
    clod_runs_path(runs, row, ".log", log);
    clod_folder *folder = clod_folder_open(path, status);
    bool good = folder != NULL;
    if (good && of->state == CLOD_RUNS_BEGUN) {
        of->seconds += between(json, log); // its log was written when the last piece ended
    } else if (good) {
        clod_rows_forget(runs, row);
        good = clod_folder_clear(folder, status);
        of->state = CLOD_RUNS_BEGUN;
    }
    good = good && clod_rows_write(runs, row, status);
    clod_folder_close(&folder);
    return good;
}

/** What stays only takes room. */
static bool remove_spare(void *context, const char *name, clod_status *status)
{
    (void)status;
    clod_status none = {CLOD_OK, ""};
    (void)clod_folder_remove(context, name, &none);
    return true;
}

void clod_rows_trim(const clod_runs *runs, size_t row)
{
    char path[PATH_MAX];
    clod_runs_path(runs, row, "", path);
    clod_status none = {CLOD_OK, ""};
    clod_folder *folder = clod_folder_look(path, &none);
    if (folder != NULL) {
        (void)clod_folder_names_each(folder, "^(" CLOD_FOLDER_SPARE ")$", remove_spare, folder,
                                     &none);
    }
    clod_folder_close(&folder);
}

/** Line ends and runs of blanks become one blank. */
static void flatten(char *text)
{
    size_t to = 0;
    for (const char *from = text; *from != '\0'; from++) {
        const bool blank = (unsigned char)*from <= ' ';
        if (!blank || (to > 0 && text[to - 1] != ' ')) {
            text[to] = *from;
            if (blank) {
                text[to] = ' ';
            }
            to++;
        }
    }
    text[to] = '\0';
}

char *clod_rows_last_words(const clod_runs *runs, size_t row)
{
    static const char BEGIN[] = "clod run: ";
    char path[PATH_MAX];
    clod_runs_path(runs, row, ".log", path);
    char *text;
    size_t length;
    clod_status none = {CLOD_OK, ""};
    if (!clod_input_read_regular(path, (size_t)1 << 24, &text, &length, &none)) {
        return clod_memory_text("its log cannot be read");
    }
    char *from = length > LAST_BYTES ? text + length - LAST_BYTES : text;
    for (char *next = strstr(from, BEGIN); next != NULL; next = strstr(from, BEGIN)) {
        from = next + strlen(BEGIN);
    }
    flatten(from);
    if (strlen(from) > WORDS) {
        from[WORDS] = '\0';
    }
    char *words = clod_memory_text(from[0] == '\0' ? "it said nothing" : from);
    clod_memory_free(text);
    return words;
}

/** All that the runs depend on; owned, NULL without memory. */
static char *describe(const clod_runs *runs)
{
    const clod_plan *plan = runs->plan;
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out,
            "Runs of a calibration: another plan needs another folder.\nclod %s\nseed %lld, "
            "seeds %lld\n",
            clod_version_text(), (long long)plan->seed, (long long)plan->seeds);
    for (size_t k = 0; k < plan->parameter_count; k++) {
        const clod_plan_parameter *one = &plan->parameters[k];
        fprintf(out, "parameter %s %.17g %.17g %s %s", one->key, one->low, one->high, one->unit,
                one->scale == CLOD_PLAN_LOG ? "log" : "linear");
        for (size_t m = 1; m <= one->multiple_count; m++) {
            fprintf(out, ", %.17g times it %s", clod_plan_factor(one, m),
                    clod_plan_key(one, m));
        }
        fprintf(out, "%s%s\n", one->base != NULL ? ", times " : "",
                one->base != NULL ? one->base->key : "");
    }
    for (size_t k = 0; k < plan->test_count; k++) {
        fputs(runs->cases[k], out);
    }
    return clod_text_close(&text);
}

/** The line that begins here, without what it is indented by, cut to be shown. */
static void show_line(const char *at, char line[SHOWN])
{
    at += strspn(at, " ");
    const size_t length = strcspn(at, "\n");
    if (at[0] == '\0') {
        snprintf(line, SHOWN, "no line");
    } else {
        snprintf(line, SHOWN, "\"%.*s%s\"", (int)(length < MOST_SHOWN ? length : MOST_SHOWN),
                 at, length > MOST_SHOWN ? " ..." : "");
    }
}

/** Whether the folder's design is that of this plan; a complaint with the first line that is not. */
static bool is_same(const char *folder, const char *before, const char *now,
                    clod_status *status)
{
    size_t line = 1, start = 0;
    for (size_t k = 0; before[k] == now[k]; k++) {
        if (now[k] == '\0') {
            return true;
        }
        if (now[k] == '\n') {
            line++;
            start = k + 1;
        }
    }
    char theirs[SHOWN], own[SHOWN];
    show_line(before + start, theirs);
    show_line(now + start, own);
    return clod_status_fail(
        status, CLOD_USAGE,
        "%s has runs of another plan: line %zu of its " MARK
        " is %s, and that of this plan %s. "
        "Parameters, ranges, seeds, cases, files they name and the version of clod must be the "
        "same. Give another folder with -o, or remove this one. (Targets, budget and points may "
        "change.)",
        folder, line, theirs, own);
}

bool clod_rows_mark(const clod_runs *runs, clod_status *status)
{
    char *text = describe(runs);
    void *before = NULL;
    size_t size;
    bool good =
        text != NULL || clod_status_fail(status, CLOD_FAILED, "No memory for the design.");
    good = good && clod_folder_read(runs->folder, MARK, &before, &size, status);
    if (good && before == NULL) {
        good = clod_folder_write(runs->folder, MARK, text, status);
    } else if (good) {
        good = is_same(runs->folder->path, before, text, status);
    }
    clod_memory_free(before);
    clod_memory_free(text);
    return good;
}

bool clod_rows_look(const clod_runs *runs, const char *directory, clod_status *status)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/" MARK, directory);
    bool there;
    if (!clod_file_is_there(path, &there, status)) {
        return false;
    }
    if (!there) {
        return true;
    }
    void *before;
    size_t size;
    if (!clod_file_read(path, &before, &size, status)) {
        return false;
    }
    char *text = describe(runs);
    const bool good = text != NULL
                          ? is_same(directory, before, text, status)
                          : clod_status_fail(status, CLOD_FAILED, "No memory for the design.");
    clod_memory_free(before);
    clod_memory_free(text);
    return good;
}
