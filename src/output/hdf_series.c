#include "output/hdf_series.h"

#include <errno.h>
#include <jansson.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "output/file.h"

/** Owned list of {"name", "time"}; empty when there is no file, NULL with status. */
static json_t *load_entries(const char *path, clod_status *status)
{
    if (access(path, F_OK) != 0) {
        return json_array();
    }
    json_error_t error;
    json_t *index = json_load_file(path, 0, &error);
    json_t *entries = json_object_get(index, "files");
    bool good = json_is_array(entries);
    size_t e;
    json_t *entry;
    json_array_foreach(entries, e, entry)
    {
        good = good && json_is_string(json_object_get(entry, "name")) &&
               json_is_number(json_object_get(entry, "time"));
    }
    if (good) {
        json_incref(entries);
    } else {
        clod_status_fail(status, CLOD_FAILED,
                         "%s is not a list of snapshots. Remove it; the next snapshot starts a "
                         "new one.",
                         path);
        entries = NULL;
    }
    json_decref(index);
    return entries;
}

static double entry_time(const json_t *entries, size_t number)
{
    return json_number_value(json_object_get(json_array_get(entries, number), "time"));
}

/** Write the index; takes over the reference to `entries`. */
static bool store_entries(const char *path, json_t *entries, clod_status *status)
{
    json_t *index = json_pack("{s:s, s:o}", "file-series-version", "1.0", "files", entries);
    char *text = json_dumps(index, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
    json_decref(index);
    if (text == NULL) {
        return clod_file_fail(status, "write", path, ENOMEM);
    }
    const bool done = clod_file_replace(path, text, strlen(text), "\n", 1, status);
    free(text);
    return done;
}

bool clod_hdf_series_add(const char *path, const char *name, double time, clod_status *status)
{
    json_t *entries = load_entries(path, status);
    if (entries == NULL) {
        return false;
    }
    for (size_t e = json_array_size(entries); e > 0 && entry_time(entries, e - 1) >= time;
         e--) {
        json_array_remove(entries, e - 1);
    }
    json_array_append_new(entries, json_pack("{s:s, s:f}", "name", name, "time", time));
    return store_entries(path, entries, status);
}

/** Remove a file that lies next to the index. */
static bool remove_beside(const char *path, const char *name, clod_status *status)
{
    char file[PATH_MAX];
    const char *slash = strrchr(path, '/');
    const size_t length = slash == NULL ? 0 : (size_t)(slash - path) + 1;
    if (strchr(name, '/') != NULL || length + strlen(name) >= sizeof file) {
        return clod_file_fail(status, "remove", name, EINVAL);
    }
    memcpy(file, path, length);
    memcpy(file + length, name, strlen(name) + 1);
    return unlink(file) == 0 || errno == ENOENT ||
           clod_file_fail(status, "remove", file, errno);
}

bool clod_hdf_series_cut(const char *path, double time, clod_status *status)
{
    json_t *entries = load_entries(path, status);
    if (entries == NULL) {
        return false;
    }
    size_t e = json_array_size(entries);
    const size_t before = e;
    bool good = true;
    for (; good && e > 0 && entry_time(entries, e - 1) > time; e--) {
        const json_t *name = json_object_get(json_array_get(entries, e - 1), "name");
        good = remove_beside(path, json_string_value(name), status);
        json_array_remove(entries, e - 1);
    }
    if (!good || e == before) {
        json_decref(entries);
        return good;
    }
    return store_entries(path, entries, status);
}
