#include "picture/film.h"

#include <dirent.h>
#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "output/file.h"
#include "output/hdf_series.h"

#define ENDING ".hdf.series"

static bool fail_memory(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "No memory for the list of snapshots.");
}

/** Owned "folder/name", or NULL without memory. */
static char *join(const char *folder, const char *name)
{
    const size_t size = strlen(folder) + strlen(name) + 2;
    char *path = clod_memory_alloc(size, 1);
    if (path != NULL) {
        snprintf(path, size, "%s/%s", folder, name);
    }
    return path;
}

/** Whether a file name is that of a list of grains; its part is copied. */
static bool is_series(const char *name, char part[256])
{
    const size_t length = strlen(name);
    if (length <= strlen(ENDING) || length >= 256 ||
        strcmp(name + length - strlen(ENDING), ENDING) != 0) {
        return false;
    }
    snprintf(part, 256, "%.*s", (int)(length - strlen(ENDING)), name);
    static const char *const OTHER[] = {"_walls", "_contacts"};
    for (int k = 0; k < 2; k++) {
        const size_t end = strlen(OTHER[k]);
        if (strlen(part) > end && strcmp(part + strlen(part) - end, OTHER[k]) == 0) {
            return false;
        }
    }
    return true;
}

/** The parts that have snapshots. */
typedef struct part_list {
    char name[64][256];
    size_t count;
} part_list;

static int compare_names(const void *a, const void *b)
{
    return strcmp(a, b);
}

static bool list_parts(const char *folder, part_list *parts, clod_status *status)
{
    DIR *open = opendir(folder);
    if (open == NULL) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: %s. Name the results folder of a run, e.g. run/first.",
                                folder, strerror(errno));
    }
    bool ours = false;
    parts->count = 0;
    for (const struct dirent *entry = readdir(open); entry != NULL; entry = readdir(open)) {
        ours = ours || strcmp(entry->d_name, ".clod-lock") == 0;
        if (parts->count < 64 && is_series(entry->d_name, parts->name[parts->count])) {
            parts->count++;
        }
    }
    closedir(open);
    qsort(parts->name, parts->count, sizeof parts->name[0], compare_names);
    return parts->count > 0 ||
           clod_status_fail(status, CLOD_USAGE,
                            ours
                                ? "%s has no snapshots: the case asks for none, or the run has "
                                  "not come to the first (output.snapshot_interval)."
                                : "%s is not the results folder of a run: it has no file "
                                  "run.hdf.series.",
                            folder);
}

/** Name of the part to show, one of those that are there. */
static bool choose_part(const char *folder, const char *part, char chosen[256],
                        clod_status *status)
{
    part_list *parts = clod_memory_alloc(1, sizeof *parts);
    if (parts == NULL) {
        return fail_memory(status);
    }
    bool good = list_parts(folder, parts, status);
    const char *found = good && part == NULL && parts->count == 1 ? parts->name[0] : NULL;
    char names[4096] = "";
    for (size_t k = 0; good && k < parts->count; k++) {
        const size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, "%s%s", k > 0 ? ", " : "", parts->name[k]);
        if (strcmp(parts->name[k], part != NULL ? part : "run") == 0) {
            found = parts->name[k];
        }
    }
    if (good && found == NULL) {
        good = part != NULL
                   ? clod_status_fail(status, CLOD_USAGE,
                                      "%s has no snapshots of a part %s. Parts that have: %s.",
                                      folder, part, names)
                   : clod_status_fail(status, CLOD_USAGE,
                                      "%s has snapshots of several parts: choose one with "
                                      "--part. There are: %s.",
                                      folder, names);
    } else if (good) {
        snprintf(chosen, 256, "%s", found);
    }
    clod_memory_free(parts);
    return good;
}

/** Owned entries of a list of snapshots; NULL with status when it is not one. */
static json_t *load_series(const char *folder, const char *name, clod_status *status)
{
    char *path = join(folder, name);
    if (path == NULL) {
        fail_memory(status);
        return NULL;
    }
    json_error_t error;
    json_t *root = json_load_file(path, 0, &error);
    json_t *files = json_incref(json_object_get(root, "files"));
    json_decref(root);
    if (!clod_hdf_series_is_list(files)) {
        clod_status_fail(status, CLOD_USAGE,
                         "%s is damaged: it is not the list of snapshots that clod writes.",
                         path);
        json_decref(files);
        files = NULL;
    }
    clod_memory_free(path);
    return files;
}

static double time_of(const json_t *files, size_t k)
{
    return json_number_value(json_object_get(json_array_get(files, k), "time"));
}

/** Owned path of entry k. */
static char *path_of(const clod_film *self, const json_t *files, size_t k)
{
    const json_t *entry = json_array_get(files, k);
    return join(self->folder, json_string_value(json_object_get(entry, "name")));
}

/** The frames of a list of grains, each with the walls of the same time. */
static bool take_frames(clod_film *self, const json_t *grains, const json_t *walls,
                        const char *part, clod_status *status)
{
    const size_t count = json_array_size(grains);
    if (count == 0) {
        return clod_status_fail(status, CLOD_USAGE, "%s/%s%s lists no snapshot.", self->folder,
                                part, ENDING);
    }
    self->frames = clod_memory_alloc(count, sizeof *self->frames);
    if (self->frames == NULL) {
        return fail_memory(status);
    }
    size_t w = 0;
    for (size_t k = 0; k < count; k++) {
        clod_film_frame *frame = &self->frames[self->count++];
        frame->time = time_of(grains, k);
        frame->grains = path_of(self, grains, k);
        while (w < json_array_size(walls) && time_of(walls, w) < frame->time) {
            w++;
        }
        const bool has_walls = w < json_array_size(walls) && time_of(walls, w) == frame->time;
        frame->walls = has_walls ? path_of(self, walls, w) : NULL;
        if (frame->grains == NULL || (has_walls && frame->walls == NULL)) {
            return fail_memory(status);
        }
        if (k > 0 && !(frame->time > frame[-1].time)) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "%s/%s%s is damaged: its times do not rise.", self->folder,
                                    part, ENDING);
        }
    }
    return true;
}

static bool list_frames(clod_film *self, const char *part, clod_status *status)
{
    char name[320], walls_name[320];
    snprintf(name, sizeof name, "%s%s", part, ENDING);
    snprintf(walls_name, sizeof walls_name, "%s_walls%s", part, ENDING);
    char *path = join(self->folder, walls_name);
    FILE *there = path != NULL ? fopen(path, "r") : NULL;
    clod_memory_free(path);
    json_t *grains = load_series(self->folder, name, status);
    json_t *walls = NULL;
    bool good = grains != NULL;
    if (there != NULL) { // walls that were taken away are no error
        fclose(there);
        walls = good ? load_series(self->folder, walls_name, status) : NULL;
        good = walls != NULL;
    }
    good = good && take_frames(self, grains, walls, part, status);
    json_decref(grains);
    json_decref(walls);
    return good;
}

/** Last name of the folder's path. */
static void folder_name(const char *folder, char name[256])
{
    char whole[4096];
    char *real = realpath(folder, NULL);
    snprintf(whole, sizeof whole, "%s", real != NULL ? real : folder);
    free(real);
    const char *slash = strrchr(whole, '/');
    snprintf(name, 256, "%.255s", slash != NULL && slash[1] != '\0' ? slash + 1 : whole);
}

/** The title in the text of a complete case; false: none. */
static bool find_title(const char *text, char title[256])
{
    static const char KEY[] = "\ntitle: \"";
    const char *at = text != NULL ? strstr(text, KEY) : NULL;
    const char *from = at != NULL ? at + strlen(KEY) : NULL;
    const char *end = from != NULL ? strpbrk(from, "\"\n") : NULL;
    if (end == NULL || end == from) {
        return false;
    }
    snprintf(title, 256, "%.*s", end - from < 255 ? (int)(end - from) : 255, from);
    return true;
}

/** The case of the run, as far as it can still be read: a mesh may be gone, the version old. */
static bool read_case(clod_film *self, clod_status *status)
{
    clod_status *unread = clod_memory_alloc(1, sizeof *unread);
    char *path = join(self->folder, "case-complete.yaml");
    void *text = NULL;
    size_t length;
    if (path != NULL && unread != NULL && clod_file_read(path, &text, &length, unread)) {
        self->of = clod_case_load(path, NULL, 0, unread);
    }
    char name[256];
    if (!find_title(text, name)) {
        folder_name(self->folder, name);
    }
    const bool known = self->of != NULL && self->of->title != NULL;
    self->title =
        clod_memory_text(known && self->of->title[0] != '\0' ? self->of->title : name);
    clod_memory_free(text);
    clod_memory_free(path);
    clod_memory_free(unread);
    return self->title != NULL || fail_memory(status);
}

bool clod_film_open(clod_film *self, const char *folder, const char *part, clod_status *status)
{
    *self = (clod_film){.folder = clod_memory_text(folder)};
    char chosen[256];
    if (self->folder == NULL) {
        return fail_memory(status);
    }
    return choose_part(folder, part, chosen, status) && list_frames(self, chosen, status) &&
           read_case(self, status);
}

bool clod_film_nearest(const clod_film *self, double time, size_t *frame, clod_status *status)
{
    const double first = self->frames[0].time;
    const double last = self->frames[self->count - 1].time;
    const double slack = self->count > 1 ? 0.5 * (last - first) / (double)(self->count - 1)
                                         : 0.5 * fabs(first) + 1e-9;
    if (!(time >= first - slack && time <= last + slack)) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "--time %g s is outside of the run: %s has %zu snapshot%s, from "
            "%.6g s to %.6g s.",
            time, self->folder, self->count, self->count == 1 ? "" : "s", first, last);
    }
    *frame = 0;
    for (size_t k = 1; k < self->count; k++) {
        if (fabs(self->frames[k].time - time) < fabs(self->frames[*frame].time - time)) {
            *frame = k;
        }
    }
    return true;
}

const char *clod_film_material_name(const clod_film *self, size_t k)
{
    return self->of != NULL && k < self->of->material_count ? self->of->materials[k].name
                                                            : NULL;
}

const char *clod_film_wall_name(const clod_film *self, size_t k)
{
    return self->of != NULL && k < self->of->wall_count ? self->of->walls[k].name : NULL;
}

int clod_film_wall(const clod_film *self, const char *name)
{
    for (size_t k = 0; self->of != NULL && k < self->of->wall_count; k++) {
        if (strcmp(self->of->walls[k].name, name) == 0) {
            return (int)k;
        }
    }
    char *end;
    const long number = strtol(name, &end, 10);
    return end != name && *end == '\0' && number >= 0 && number < 10000 ? (int)number : -1;
}

void clod_film_fini(clod_film *self)
{
    for (size_t k = 0; k < self->count; k++) {
        clod_memory_free(self->frames[k].grains);
        clod_memory_free(self->frames[k].walls);
    }
    clod_memory_free(self->frames);
    clod_case_destroy(&self->of);
    clod_memory_free(self->title);
    clod_memory_free(self->folder);
    *self = (clod_film){0};
}
