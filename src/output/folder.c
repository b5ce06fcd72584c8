#include "output/folder.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/file.h"
#include "output/folder_files.h"
#include "output/folder_names.h"

/** "run/NAME" of a name that is not ended by a zero; NULL without memory. */
static char *below_run(const char *name, size_t length)
{
    const size_t size = length + sizeof "run/";
    char *path = clod_memory_alloc(size, 1);
    if (path != NULL) {
        snprintf(path, size, "run/%.*s", (int)length, name);
    }
    return path;
}

/**
 * Owned name of the folder that holds a file, as it is on the disk; NULL for that of the root
 * and for a folder that is not there, and with *error not 0 when that cannot be told.
 */
static char *name_of_folder(const char *file, int *error)
{
    char folder[PATH_MAX];
    char whole[PATH_MAX];
    const char *slash = strrchr(file, '/');
    snprintf(folder, sizeof folder, "%.*s", slash == NULL ? 1 : (int)(slash - file) + 1,
             slash == NULL ? "." : file);
    const char *found = realpath(folder, whole);
    *error = found == NULL && errno != ENOENT ? errno : 0;
    const char *name = found == NULL ? NULL : strrchr(found, '/') + 1;
    if (name == NULL || name[0] == '\0') {
        return NULL;
    }
    char *copy = clod_memory_text(name);
    *error = copy == NULL ? ENOMEM : 0;
    return copy;
}

char *clod_folder_default(const char *case_path, clod_status *status)
{
    const char *slash = strrchr(case_path, '/');
    const char *name = slash == NULL ? case_path : slash + 1;
    const char *dot = strrchr(name, '.');
    const size_t length = dot == NULL || dot == name ? strlen(name) : (size_t)(dot - name);
    int error = 0;
    char *holder = strcmp(name, "case.yaml") == 0 ? name_of_folder(case_path, &error) : NULL;
    char *path = NULL;
    if (error == 0) {
        path = holder != NULL ? below_run(holder, strlen(holder)) : below_run(name, length);
        error = path == NULL ? ENOMEM : 0;
    }
    clod_memory_free(holder);
    if (error != 0) {
        clod_file_fail(status, "look at the folder of", case_path, error);
    }
    return path;
}

/** Make one folder; one that exists is fine. */
static bool make_one(const char *path, clod_status *status)
{
    struct stat info;
    int error = mkdir(path, 0777) == 0 ? 0 : errno;
    if (error == 0) {
        error = clod_file_sync_entry(path);
    } else if (error == EEXIST && stat(path, &info) != 0) {
        return clod_file_fail(status, "look at", path, errno);
    } else if (error == EEXIST && S_ISDIR(info.st_mode)) {
        error = 0;
    } else if (error == EEXIST) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s is there and is not a folder: results cannot be written "
                                "into it. Choose another folder with -o, or move it away.",
                                path);
    }
    return error == 0 || clod_file_fail(status, "make the folder", path, error);
}

bool clod_folder_make(const char *path, clod_status *status)
{
    char part[PATH_MAX];
    if ((size_t)snprintf(part, sizeof part, "%s", path) >= sizeof part) {
        return clod_file_fail(status, "make the folder", path, ENAMETOOLONG);
    }
    for (char *next = part + 1; part[0] != '\0' && *next != '\0'; next++) {
        if (*next == '/') {
            *next = '\0';
            if (!make_one(part, status)) {
                return false;
            }
            *next = '/';
        }
    }
    return make_one(part, status);
}

/** Refuse a folder that no run has locked before and that has what a run would write over. */
static bool check_ours(const clod_folder *self, clod_status *status)
{
    char first[NAME_MAX + 1];
    bool locked = false;
    if (!clod_folder_names_first(self, first, status)) {
        return false;
    }
    // the lock is looked for after the names: another run that begins here makes it first
    if (first[0] != '\0' && !clod_folder_has(self, CLOD_FOLDER_LOCK, &locked, status)) {
        return false;
    }
    return first[0] == '\0' || locked ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s/%s is in the way: a run would replace it, and clod did not "
                            "make this folder (there is no %s in it). Choose another folder "
                            "with -o, or move the file away. If this is a copy of a results "
                            "folder, copy its %s too.",
                            self->path, first, CLOD_FOLDER_LOCK, CLOD_FOLDER_LOCK);
}

/** Say who holds the lock, as far as its file tells. */
static bool fail_locked(const clod_folder *self, clod_status *status)
{
    char process[32] = "";
    const ssize_t length = pread(self->lock, process, sizeof process - 1, 0);
    process[length > 0 ? strcspn(process, "\n") : 0] = '\0';
    return clod_status_fail(
        status, CLOD_USAGE,
        "Another run%s%s%s is writing into %s. Wait for its end, or choose another "
        "folder with -o.",
        length > 0 ? " (process " : "", process, length > 0 ? ")" : "", self->path);
}

/** Open and lock the lock file, if the folder may be written to. */
static bool take_lock(clod_folder *self, clod_status *status)
{
    if (!check_ours(self, status)) {
        return false;
    }
    self->lock = clod_folder_open_file(self, CLOD_FOLDER_LOCK, O_RDWR | O_CREAT, status);
    if (self->lock < 0) {
        return false;
    }
    int locked;
    do {
        locked = flock(self->lock, LOCK_EX | LOCK_NB);
    } while (locked != 0 && errno == EINTR);
    if (locked != 0) {
        return errno == EWOULDBLOCK
                   ? fail_locked(self, status)
                   : clod_folder_fail(self, "lock", CLOD_FOLDER_LOCK, errno, status);
    }
    if (!clod_folder_check(self, status)) {
        return false;
    }
    char process[32];
    const int length = snprintf(process, sizeof process, "%ld\n", (long)getpid());
    const bool told = ftruncate(self->lock, 0) == 0 &&
                      pwrite(self->lock, process, (size_t)length, 0) == length;
    (void)told; // only a help in the message to the next run: a full disk does not matter
    return true;
}

clod_folder *clod_folder_look(const char *path, clod_status *status)
{
    clod_folder *self = clod_memory_alloc(1, sizeof *self);
    char *copy = clod_memory_text(path);
    const int descriptor = clod_file_open(AT_FDCWD, path, O_RDONLY | O_DIRECTORY);
    const int error = descriptor < 0 ? errno : 0;
    if (self == NULL || copy == NULL || descriptor < 0) {
        clod_file_fail(status, "open", path, descriptor < 0 ? error : ENOMEM);
        if (descriptor >= 0) {
            clod_file_close(descriptor);
        }
        clod_memory_free(self);
        clod_memory_free(copy);
        return NULL;
    }
    *self = (clod_folder){.path = copy, .descriptor = descriptor, .lock = -1};
    return self;
}

clod_folder *clod_folder_open(const char *path, clod_status *status)
{
    if (!clod_folder_make(path, status)) {
        return NULL;
    }
    clod_folder *self = clod_folder_look(path, status);
    if (self != NULL && !take_lock(self, status)) {
        clod_folder_close(&self);
    }
    return self;
}

static bool same_file(const struct stat *one, const struct stat *other)
{
    return one->st_dev == other->st_dev && one->st_ino == other->st_ino;
}

bool clod_folder_mark_of(const clod_folder *self, clod_folder_mark *mark, clod_status *status)
{
    struct stat lock;
    if (fstatat(self->descriptor, CLOD_FOLDER_LOCK, &lock, AT_SYMLINK_NOFOLLOW) != 0) {
        return clod_folder_fail(self, "look at", CLOD_FOLDER_LOCK, errno, status);
    }
    *mark = (clod_folder_mark){lock.st_ino, lock.st_mtim.tv_sec, lock.st_mtim.tv_nsec};
    return true;
}

bool clod_folder_mark_equals(const clod_folder_mark *a, const clod_folder_mark *b)
{
    return a->file == b->file && a->seconds == b->seconds && a->nanoseconds == b->nanoseconds;
}

/** Look at a name and at an open file: 0 when they are the same, ENOENT when not, or errno. */
static int compare(int folder, const char *name, int flags, int descriptor)
{
    struct stat by_name, opened;
    if (fstat(descriptor, &opened) != 0 || fstatat(folder, name, &by_name, flags) != 0) {
        return errno == ENOTDIR ? ENOENT : errno;
    }
    return same_file(&by_name, &opened) ? 0 : ENOENT;
}

bool clod_folder_check(const clod_folder *self, clod_status *status)
{
    int error = compare(AT_FDCWD, self->path, 0, self->descriptor);
    if (error == 0 && self->lock >= 0) {
        error = compare(self->descriptor, CLOD_FOLDER_LOCK, AT_SYMLINK_NOFOLLOW, self->lock);
    }
    if (error == ENOENT) {
        return clod_status_fail(
            status, CLOD_FAILED,
            "The folder %s was moved away, removed or replaced (or the %s in "
            "it was) while this run was writing into it. The run stops, and "
            "writes nothing into what is there now. Bring the folder back to "
            "its place and give the same command again: the run goes on from "
            "its last checkpoint.",
            self->path, CLOD_FOLDER_LOCK);
    }
    return error == 0 || clod_file_fail(status, "look at", self->path, error);
}

void clod_folder_close(clod_folder **self)
{
    clod_folder *folder = *self;
    *self = NULL;
    if (folder == NULL) {
        return;
    }
    if (folder->lock >= 0) {
        clod_file_close(folder->lock); // the lock file stays: removing it would let two runs in
    }
    clod_file_close(folder->descriptor);
    clod_memory_free(folder->path);
    clod_memory_free(folder);
}

bool clod_folder_space(const char *path, double *bytes, clod_status *status)
{
    char parent[PATH_MAX];
    struct statvfs info;
    if ((size_t)snprintf(parent, sizeof parent, "%s", path) >= sizeof parent) {
        return clod_file_fail(status, "look at", path, ENAMETOOLONG);
    }
    while (statvfs(parent, &info) != 0) {
        char *slash = strrchr(parent, '/');
        if (errno == EINTR) {
            continue;
        }
        if (errno != ENOENT && errno != ENOTDIR) { // one is a file where a folder would be
            return clod_file_fail(status, "look at", parent, errno);
        }
        if (slash == NULL && strcmp(parent, ".") == 0) {
            return clod_file_fail(status, "look at", path, ENOENT);
        }
        if (slash == NULL || slash == parent) {
            snprintf(parent, sizeof parent, slash == NULL ? "." : "/");
        } else {
            *slash = '\0';
        }
    }
    *bytes = (double)info.f_bavail * (double)info.f_frsize;
    return true;
}
