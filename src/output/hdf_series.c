#include "output/hdf_series.h"

#include <errno.h>
#include <jansson.h>
#include <string.h>

#include "base/json.h"
#include "base/memory.h"
#include "output/file.h"
#include "output/folder_files.h"

#define DAMAGED "was changed, or is damaged: its checksum is another one"

bool clod_hdf_series_is_list(const json_t *files)
{
    bool good = json_is_array(files);
    size_t e;
    json_t *entry;
    json_array_foreach(files, e, entry)
    {
        const char *name = json_string_value(json_object_get(entry, "name"));
        good = good && name != NULL && strchr(name, '/') == NULL &&
               json_is_number(json_object_get(entry, "time"));
    }
    return good;
}

static bool fail_damaged(const clod_folder *folder, const char *index, const char *fault,
                         clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED,
                            "%s/%s %s. Put back the file as the run left it, or remove it: the "
                            "next snapshot then starts a new one.",
                            folder->path, index, fault);
}

/**
 * Owned list of {"name", "time"}; empty when there is no file, NULL with status.
 * @param sum  [out] checksum of the file; 0 when there is none
 */
static json_t *load_entries(const clod_folder *folder, const char *index, uint64_t *sum,
                            clod_status *status)
{
    void *text;
    size_t size = 0;
    if (!clod_folder_read(folder, index, &text, &size, status)) {
        return NULL;
    }
    const bool there = text != NULL;
    json_error_t error;
    json_t *root = there ? json_loadb(text, size, 0, &error) : json_pack("{s:[]}", "files");
    *sum = there ? clod_file_crc32(0, text, size) : 0;
    clod_memory_free(text);
    json_t *entries = json_incref(json_object_get(root, "files"));
    json_decref(root);
    if (clod_hdf_series_is_list(entries)) {
        return entries;
    }
    json_decref(entries);
    if (root == NULL && (!there || clod_json_lacks_memory())) {
        clod_folder_fail(folder, "read", index, ENOMEM, status);
    } else {
        fail_damaged(folder, index, "is not a list of snapshots", status);
    }
    return NULL;
}

static double entry_time(const json_t *entries, size_t number)
{
    return json_number_value(json_object_get(json_array_get(entries, number), "time"));
}

/** How many of the entries are of `time` or before. */
static size_t count_until(const json_t *entries, double time)
{
    size_t count = json_array_size(entries);
    while (count > 0 && entry_time(entries, count - 1) > time) {
        count--;
    }
    return count;
}

/** Owned text of an index; takes over the reference to `entries`. */
static char *print_index(json_t *entries)
{
    json_t *root = json_pack("{s:s, s:o}", "file-series-version", "1.0", "files", entries);
    char *text = clod_json_text(root, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
    json_decref(root);
    return text;
}

static uint64_t sum_of(const char *text)
{
    return clod_file_crc32(clod_file_crc32(0, text, strlen(text)), "\n", 1);
}

/** Write the index; takes over the reference to `entries`. */
static bool store_entries(const clod_folder *folder, const char *index, json_t *entries,
                          uint64_t *sum, clod_status *status)
{
    char *text = print_index(entries);
    if (text == NULL) {
        return clod_folder_fail(folder, "write", index, ENOMEM, status);
    }
    const bool done = clod_folder_replace(folder, index, text, strlen(text), "\n", 1, status);
    *sum = sum_of(text);
    clod_memory_free(text);
    return done;
}

bool clod_hdf_series_add(const clod_folder *folder, const char *index, const char *name,
                         double time, uint64_t *sum, clod_status *status)
{
    uint64_t found;
    json_t *entries = load_entries(folder, index, &found, status);
    if (entries == NULL) {
        return false;
    }
    if (*sum != 0 && found != 0 && found != *sum) {
        json_decref(entries);
        return fail_damaged(folder, index, DAMAGED, status);
    }
    for (size_t e = json_array_size(entries); e > 0 && entry_time(entries, e - 1) >= time;
         e--) {
        json_array_remove(entries, e - 1);
    }
    if (json_array_append_new(entries, json_pack("{s:s, s:f}", "name", name, "time", time)) !=
        0) {
        json_decref(entries);
        return clod_folder_fail(folder, "write", index, ENOMEM, status);
    }
    return store_entries(folder, index, entries, sum, status);
}

bool clod_hdf_series_cut(const clod_folder *folder, const char *index, double time,
                         clod_status *status)
{
    uint64_t sum;
    json_t *entries = load_entries(folder, index, &sum, status);
    if (entries == NULL) {
        return false;
    }
    const size_t kept = count_until(entries, time);
    size_t e = json_array_size(entries);
    const bool cut = e > kept;
    bool good = true;
    for (; good && e > kept; e--) {
        const json_t *name = json_object_get(json_array_get(entries, e - 1), "name");
        good = clod_folder_remove(folder, json_string_value(name), status);
        json_array_remove(entries, e - 1);
    }
    if (!good || !cut) {
        json_decref(entries);
        return good;
    }
    return store_entries(folder, index, entries, &sum, status);
}

bool clod_hdf_series_check(const clod_folder *folder, const char *index, double time,
                           uint64_t sum, clod_status *status)
{
    uint64_t found;
    json_t *entries = load_entries(folder, index, &found, status);
    if (entries == NULL) {
        return false;
    }
    const size_t kept = count_until(entries, time);
    if (found == 0 || (kept == 0 && sum == 0)) {
        json_decref(entries);
        return true;
    }
    while (json_array_size(entries) > kept) {
        json_array_remove(entries, kept);
    }
    char *text = print_index(entries);
    if (text == NULL) {
        return clod_folder_fail(folder, "read", index, ENOMEM, status);
    }
    const bool same = sum_of(text) == sum;
    clod_memory_free(text);
    return same || fail_damaged(folder, index, DAMAGED, status);
}
