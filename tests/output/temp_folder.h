#pragma once
/**
 * @file temp_folder.h
 * A folder of its own for each test, removed with everything in it.
 */

#include <dirent.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/file.h"
#include "output/folder.h"

/** The folder of the test that runs, open; not locked. */
static clod_folder *temp_opened;

/** cmocka setup: *state becomes the path of a fresh folder. */
static inline int temp_folder_make(void **state)
{
    const char *root = getenv("TMPDIR");
    char *path = clod_memory_alloc(PATH_MAX, 1);
    snprintf(path, PATH_MAX, "%s/clod-test-XXXXXX", root != NULL ? root : P_tmpdir);
    *state = path;
    clod_status status;
    temp_opened = mkdtemp(path) == NULL ? NULL : clod_folder_look(path, &status);
    return temp_opened == NULL;
}

/** The folder of the test as clod names it. */
static inline const clod_folder *temp_folder(void **state)
{
    return *state == NULL ? NULL : temp_opened;
}

/** Remove everything in an open folder, and close it. */
static inline void temp_empty(int descriptor)
{
    DIR *folder = fdopendir(descriptor);
    for (struct dirent *entry; folder != NULL && (entry = readdir(folder)) != NULL;) {
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0) {
            continue;
        }
        if (entry->d_type == DT_DIR) {
            temp_empty(openat(descriptor, name, O_RDONLY | O_DIRECTORY));
            unlinkat(descriptor, name, AT_REMOVEDIR);
        } else {
            unlinkat(descriptor, name, 0);
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
}

/** cmocka teardown. */
static inline int temp_folder_remove(void **state)
{
    clod_folder_close(&temp_opened);
    temp_empty(open(*state, O_RDONLY | O_DIRECTORY));
    const int left = rmdir(*state);
    clod_memory_free(*state);
    return left;
}

/** "folder/name" in a buffer that the caller brings. */
static inline const char *temp_path(char path[PATH_MAX], void **state, const char *name)
{
    snprintf(path, PATH_MAX, "%s/%s", (const char *)*state, name);
    return path;
}

static inline bool temp_exists(void **state, const char *name)
{
    char path[PATH_MAX];
    return access(temp_path(path, state, name), F_OK) == 0;
}

/** Owned content of a file. */
static inline char *temp_read(void **state, const char *name, size_t *size)
{
    char path[PATH_MAX];
    void *bytes = NULL;
    clod_status status;
    if (!clod_file_read(temp_path(path, state, name), &bytes, size, &status)) {
        *size = 0;
    }
    return bytes;
}

static inline void temp_write(void **state, const char *name, const void *bytes, size_t size)
{
    char path[PATH_MAX];
    FILE *file = fopen(temp_path(path, state, name), "wb");
    if (file == NULL || fwrite(bytes, 1, size, file) != size || fclose(file) != 0) {
        abort();
    }
}
