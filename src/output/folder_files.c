#include "output/folder_files.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/json.h"
#include "base/memory.h"
#include "output/file.h"

bool clod_folder_fail(const clod_folder *self, const char *action, const char *name, int error,
                      clod_status *status)
{
    char path[PATH_MAX + NAME_MAX + 2];
    snprintf(path, sizeof path, "%s/%s", self->path, name);
    if (clod_file_is_full(error)) {
        return clod_status_fail(
            status, CLOD_FAILED,
            "Cannot %s %s: %s. Free some space, then give the same command again: the run goes "
            "on from its last checkpoint. What was complete before is untouched.",
            action, path, strerror(error));
    }
    return clod_file_fail(status, action, path, error);
}

bool clod_folder_has(const clod_folder *self, const char *name, bool *there,
                     clod_status *status)
{
    struct stat info;
    *there = fstatat(self->descriptor, name, &info, AT_SYMLINK_NOFOLLOW) == 0;
    return *there || errno == ENOENT || clod_folder_fail(self, "look at", name, errno, status);
}

int clod_folder_open_file(const clod_folder *self, const char *name, int flags,
                          clod_status *status)
{
    const int descriptor = clod_file_open(self->descriptor, name, flags | O_NOFOLLOW);
    if (descriptor < 0) {
        clod_folder_fail(self, "write", name, errno, status);
    }
    return descriptor;
}

bool clod_folder_read(const clod_folder *self, const char *name, void **bytes, size_t *size,
                      clod_status *status)
{
    const int error = clod_file_load(self->descriptor, name, bytes, size);
    return error == 0 || error == ENOENT || clod_folder_fail(self, "read", name, error, status);
}

bool clod_folder_draft_begin(clod_folder_draft *self, const clod_folder *folder,
                             const char *name, clod_status *status)
{
    *self = (clod_folder_draft){.folder = folder, .name = name, .descriptor = -1};
    if ((size_t)snprintf(self->part, sizeof self->part, "%s.part", name) >= sizeof self->part) {
        return clod_folder_fail(folder, "write", name, ENAMETOOLONG, status);
    }
    self->descriptor =
        clod_file_open(folder->descriptor, self->part, O_RDWR | O_CREAT | O_TRUNC | O_NOFOLLOW);
    const int error = errno; // a link in the way has the name of the part
    return self->descriptor >= 0 ||
           clod_folder_fail(folder, "write", error == ELOOP ? self->part : name, error, status);
}

/** Close, and bring it to the disk before that if it is good; false with the reason. */
static bool close_draft(clod_folder_draft *self, bool good, clod_status *status)
{
    int error = good ? clod_file_sync(self->descriptor) : 0;
    const int closing = clod_file_close(self->descriptor);
    self->descriptor = -1;
    error = error != 0 ? error : closing;
    if (good && error != 0) {
        return clod_folder_fail(self->folder, "write", self->name, error, status);
    }
    return good;
}

static bool rename_draft(const clod_folder_draft *self, clod_status *status)
{
    const int folder = self->folder->descriptor;
    return renameat(folder, self->part, folder, self->name) == 0 ||
           clod_folder_fail(self->folder, "write", self->name, errno, status);
}

bool clod_folder_draft_end(clod_folder_draft *self, bool good, clod_status *status)
{
    const int folder = self->folder->descriptor;
    good = close_draft(self, good, status) && clod_folder_check(self->folder, status) &&
           rename_draft(self, status);
    if (!good) {
        unlinkat(folder, self->part, 0);
        return false;
    }
    const int error = clod_file_sync(folder);
    return error == 0 || error == EINVAL || // the file system cannot sync folders
           clod_folder_fail(self->folder, "write", self->name, error, status);
}

bool clod_folder_replace(const clod_folder *self, const char *name, const void *head,
                         size_t head_size, const void *body, size_t body_size,
                         clod_status *status)
{
    clod_folder_draft draft;
    if (!clod_folder_draft_begin(&draft, self, name, status)) {
        return false;
    }
    const bool written = clod_file_write_all(draft.descriptor, head, head_size) &&
                         clod_file_write_all(draft.descriptor, body, body_size);
    if (!written) {
        clod_folder_fail(self, "write", name, errno, status);
    }
    return clod_folder_draft_end(&draft, written, status);
}

bool clod_folder_remove(const clod_folder *self, const char *name, clod_status *status)
{
    return unlinkat(self->descriptor, name, 0) == 0 || errno == ENOENT ||
           clod_folder_fail(self, "remove", name, errno, status);
}

bool clod_folder_write(const clod_folder *self, const char *name, const char *text,
                       clod_status *status)
{
    return text != NULL ? clod_folder_replace(self, name, text, strlen(text), NULL, 0, status)
                        : clod_folder_fail(self, "write", name, ENOMEM, status);
}

bool clod_folder_write_json(const clod_folder *self, const char *name, const json_t *json,
                            clod_status *status)
{
    if (json == NULL) {
        return clod_status_fail(status, CLOD_FAILED,
                                "%s/%s: no memory, or a number in it is not finite", self->path,
                                name);
    }
    char *text = clod_json_text(json, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    if (text == NULL) {
        return clod_folder_fail(self, "write", name, ENOMEM, status);
    }
    const bool done = clod_folder_replace(self, name, text, strlen(text), "\n", 1, status);
    clod_memory_free(text);
    return done;
}

bool clod_folder_write_case(const clod_folder *self, const char *case_text,
                            const char *complete_text, clod_status *status)
{
    return clod_folder_write(self, "case.yaml", case_text, status) &&
           clod_folder_write(self, "case-complete.yaml", complete_text, status);
}
