#include "sim/origin.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/memory.h"
#include "base/text.h"
#include "output/checkpoint_file.h"
#include "output/folder_files.h"
#include "output/folder_names.h"
#include "sim/case_diff.h"

#define TIME_CLOSE 1e-6 ///< relative: a time as it was told, with nine digits

bool clod_origin_fail(const clod_origin *self, clod_status *status)
{
    char text[4096];
    snprintf(text, sizeof text, "%.4000s", status->text);
    char *advice = strstr(text, " Start over with --fresh."); // that is about a run of its own
    if (advice != NULL) {
        *advice = '\0';
    }
    return clod_status_fail(status, CLOD_USAGE, "--from %s: %s", self->folder, text);
}

/** Split FOLDER@TIME; a folder of that whole name goes first. False: not a time. */
static bool split(clod_origin *self, const char *asked, clod_status *status)
{
    struct stat info;
    self->time = -1.0;
    snprintf(self->folder, sizeof self->folder, "%s", asked);
    char *at = strrchr(self->folder, '@');
    if (at == NULL || stat(self->folder, &info) == 0) {
        return true;
    }
    char *end;
    self->time = strtod(at + 1, &end);
    const bool fine = end != at + 1 && self->time >= 0.0 &&
                      (*end == '\0' || strcmp(end, "s") == 0 || strcmp(end, " s") == 0);
    *at = '\0';
    return fine || clod_status_fail(status, CLOD_USAGE,
                                    "--from %s: behind the @ a time in seconds is needed, for "
                                    "instance @0.25",
                                    asked);
}

/** The whole path, of a folder that is gone too: then what is left of its path is resolved. */
static void resolve(const char *folder, char whole[PATH_MAX])
{
    char start[PATH_MAX], real[PATH_MAX];
    snprintf(start, sizeof start, "%s", folder);
    size_t length = strlen(start);
    while (length > 1 && start[length - 1] == '/') {
        start[--length] = '\0';
    }
    const size_t end = length;
    while (length > 0 && realpath(start, real) == NULL && strcmp(start, "/") != 0) {
        while (length > 0 && start[length - 1] != '/') {
            length--;
        }
        while (length > 1 && start[length - 1] == '/') {
            length--;
        }
        start[length] = '\0';
    }
    if (length == 0 && realpath(".", real) == NULL) {
        real[0] = '\0';
    }
    const char *rest = folder + length + strspn(folder + length, "/");
    const int more = (int)(folder + end - rest);
    const bool apart = more > 0 && strcmp(real, "/") != 0;
    if ((size_t)snprintf(whole, PATH_MAX, "%s%s%.*s", real, apart ? "/" : "",
                         more > 0 ? more : 0, rest) >= PATH_MAX) {
        snprintf(whole, PATH_MAX, "%s", folder);
    }
}

/** Take a kept checkpoint when its time is the one asked for; else note its time. */
static bool consider(clod_origin *self, const char *stem, double time, FILE *times,
                     clod_status *status)
{
    clod_checkpoint_file files[2];
    const bool read = clod_checkpoint_file_find(files, self->shelf, stem, false, NULL, status);
    const int newest = read ? clod_checkpoint_file_newest(files) : -1;
    if (newest >= 0) {
        const double its = files[newest].head.time;
        fprintf(times, " %.9g s", its);
        if (fabs(its - time) <= TIME_CLOSE * time + 1e-12) {
            snprintf(self->stem, sizeof self->stem, "%s", stem);
        }
    }
    clod_checkpoint_file_release(files);
    return read || clod_origin_fail(self, status);
}

/** A time that is looked for among the kept checkpoints. */
typedef struct moment {
    clod_origin *origin;
    double time;
    FILE *times;
} moment;

static bool visit_kept(void *context, const char *name, clod_status *status)
{
    const moment *self = context;
    char stem[64];
    const size_t length = strlen(name) - strlen("_a.h5");
    if (length >= sizeof stem) {
        return true; // no number of a step is as long
    }
    snprintf(stem, sizeof stem, "%.*s", (int)length, name);
    return consider(self->origin, stem, self->time, self->times, status);
}

/** The checkpoint of a moment: the last one, or one that SIGUSR1 has kept. */
static bool find_time(clod_origin *self, double time, clod_status *status)
{
    clod_text times = {0};
    moment now = {self, time, clod_text_open(&times)};
    self->stem[0] = '\0';
    bool good = now.times != NULL;
    good = good && consider(self, "restart", time, now.times, status) &&
           clod_folder_names_each(self->shelf, "^restart-at-[0-9]+_a[.]h5$", visit_kept, &now,
                                  status);
    char *text = now.times != NULL ? clod_text_close(&times) : NULL;
    if (now.times == NULL || (good && text == NULL)) {
        good = clod_status_fail(status, CLOD_FAILED, "no memory to look for %s@%.9g",
                                self->folder, time);
    }
    if (good && self->stem[0] == '\0') {
        good = clod_status_fail(
            status, CLOD_USAGE,
            "--from %s@%.9g: no checkpoint of that time is there; there are:%s. "
            "Only the last one is kept, and those that SIGUSR1 asked for",
            self->folder, time, text[0] != '\0' ? text : " none");
    }
    clod_memory_free(text);
    return good;
}

/** What the comparison of two cases fills in. */
typedef struct comparison {
    clod_origin *origin;
    FILE *out;
    char refused[256]; ///< the first key that a test cannot change on the way
} comparison;

static bool begins(const char *key, const char *with)
{
    return strncmp(key, with, strlen(with)) == 0;
}

/** Whether a test may go on from a preparation with another value of this key. */
static bool comes_after(const char *key)
{
    static const char *const LATER[] = {"shear_stresses", "shear_max", "beyond_peak",
                                        "peak_window",    "crush_max", "consolidation_stresses",
                                        "wall_stresses",  "shear_min"};
    const char *dot = strchr(key, '.');
    for (size_t k = 0; dot != NULL && k < sizeof LATER / sizeof *LATER; k++) {
        if (strcmp(dot + 1, LATER[k]) == 0) {
            return true;
        }
    }
    return begins(key, "title") || begins(key, "output.");
}

static void note_difference(void *context, const char *key, const char *there, const char *here)
{
    comparison *self = context;
    clod_origin *origin = self->origin;
    const bool law = begins(key, "materials") || begins(key, "contacts") || begins(key, "time");
    origin->same_law = origin->same_law && !law;
    const bool domain = begins(key, "domain") || begins(key, "outlets");
    origin->same_domain = origin->same_domain && !domain;
    if (!comes_after(key) && self->refused[0] == '\0') {
        snprintf(self->refused, sizeof self->refused, "%.255s", key);
    }
    fprintf(self->out, "  %s: %.100s there, %.100s here\n", key, there != NULL ? there : "-",
            here != NULL ? here : "-");
}

/** Compare the cases; a test goes on with the same test only. */
static bool compare(clod_origin *self, const clod_job_shared *sim, clod_status *status)
{
    clod_text text = {0};
    comparison now = {.origin = self, .out = clod_text_open(&text)};
    char *there = clod_case_echo(self->from);
    char *here = clod_case_echo(sim->from);
    self->same_law = self->same_domain = true;
    bool ok = now.out != NULL && there != NULL && here != NULL;
    if (ok) {
        ok = clod_case_differences(there, here, note_difference, &now, status);
    } else {
        clod_status_fail(status, CLOD_FAILED, "no memory to compare two cases");
    }
    if (now.out != NULL) {
        self->differences = clod_text_close(&text);
    }
    clod_memory_free(there);
    clod_memory_free(here);
    if (ok && self->differences == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory to compare two cases");
    }
    if (ok && clod_case_tester(sim->from) != NULL && now.refused[0] != '\0') {
        return clod_status_fail(
            status, CLOD_USAGE,
            "--from %s: %s differs, so that specimen is not one of this case. A test can go on "
            "from the preparation of another run with other shear, wall or consolidation "
            "stresses, shear_min, shear_max, crush_max, beyond_peak and peak_window; all that "
            "differs:\n%s",
            self->folder, now.refused, self->differences);
    }
    return ok;
}

/** Whether both paths lead to the same folder. */
static bool are_same(const char *one, const char *other)
{
    struct stat a, b;
    return stat(one, &a) == 0 && stat(other, &b) == 0 && a.st_dev == b.st_dev &&
           a.st_ino == b.st_ino;
}

static bool load_case(clod_origin *self, clod_status *status)
{
    char path[PATH_MAX + 32];
    bool there;
    self->shelf = clod_folder_look(self->folder, status);
    if (self->shelf == NULL ||
        !clod_folder_has(self->shelf, "case-complete.yaml", &there, status)) {
        char text[1024];
        snprintf(text, sizeof text, "%.1000s", status->text);
        return clod_status_fail(status, CLOD_USAGE,
                                "--from %s: %s The results folder of another run is needed",
                                self->folder, text);
    }
    snprintf(path, sizeof path, "%s/case-complete.yaml", self->folder);
    if (!there) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "--from %s: %s is not there. The results folder of another run is needed",
            self->folder, path);
    }
    self->from = clod_case_load(path, NULL, 0, status);
    return self->from != NULL || clod_origin_fail(self, status);
}

/** Whether both are free runs, or both the same test, which has no moments. */
static bool check_kind(const clod_origin *self, const clod_case *from, clod_status *status)
{
    const char *here = clod_case_tester(from) != NULL ? clod_case_tester(from) : "a free run";
    const char *there =
        clod_case_tester(self->from) != NULL ? clod_case_tester(self->from) : "a free run";
    if (strcmp(here, there) != 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "--from %s: that run is %s, this one %s; grains can only be "
                                "taken over from a run of the same kind",
                                self->folder, there, here);
    }
    return clod_case_tester(from) == NULL || self->time < 0.0 ||
           clod_status_fail(status, CLOD_USAGE,
                            "--from %s: a test goes on from a finished preparation; a time "
                            "(@) is for free runs",
                            self->folder);
}

bool clod_origin_name(clod_origin *self, const clod_job_shared *sim, clod_status *status)
{
    char whole[PATH_MAX];
    *self = (clod_origin){.stem = "restart"};
    if (!split(self, sim->options->from, status)) {
        return false;
    }
    if (are_same(self->folder, sim->directory)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "--from %s is the results folder of this run itself. Write to "
                                "another folder with -o",
                                self->folder);
    }
    resolve(self->folder, whole);
    if (self->time >= 0.0) {
        snprintf(self->text, sizeof self->text, "%.480s@%.9g", whole, self->time);
    } else {
        snprintf(self->text, sizeof self->text, "%.500s", whole);
    }
    return true;
}

bool clod_origin_open(clod_origin *self, const clod_job_shared *sim, clod_status *status)
{
    static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&lock);
    bool open = self->differences != NULL;
    if (!open) {
        open = load_case(self, status) && check_kind(self, sim->from, status) &&
               (self->time < 0.0 || find_time(self, self->time, status)) &&
               compare(self, sim, status);
        if (!open) {
            clod_origin_fini(self);
        }
    }
    pthread_mutex_unlock(&lock);
    return open;
}

void clod_origin_fini(clod_origin *self)
{
    clod_case_destroy(&self->from);
    clod_folder_close(&self->shelf);
    clod_memory_free(self->differences);
    self->differences = NULL;
}

void clod_origin_print_differences(const clod_origin *self, FILE *out)
{
    fprintf(out, "  %s\n%s",
            self->differences[0] != '\0' ? "what differs:" : "the case is the same",
            self->differences);
}

bool clod_origin_is_that(const clod_origin *self, const char *text, const char *directory,
                         clod_status *status)
{
    return self == NULL || strcmp(self->text, text) == 0 ||
           clod_status_fail(status, CLOD_USAGE,
                            "the run in %s was begun %s%s, not from %s; it cannot go on from "
                            "another one. Write to another folder with -o, or start over with "
                            "--fresh.",
                            directory, text[0] != '\0' ? "from " : "without --from", text,
                            self->text);
}
