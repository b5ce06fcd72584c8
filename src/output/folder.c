#include "output/folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <fnmatch.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/checkpoint_file.h"
#include "output/file.h"

#define LOCK_NAME ".clod-lock"
#define NUMBER "[0-9][0-9][0-9][0-9][0-9][0-9]"

struct clod_folder {
    char *path; ///< owned
    int lock;
};

/** Names that belong to clod alone, wherever they lie. */
static const char *const OWN_NAMES[] = {
    "log.jsonl",
    "summary.json",
    "series.csv",
    "restart_[ab].h5",
    "snap_" NUMBER ".hdf",
    "walls_" NUMBER ".hdf",
    "contacts_" NUMBER ".hdf",
    "*_snap_" NUMBER ".hdf",
    "*_walls_" NUMBER ".hdf",
    "*_contacts_" NUMBER ".hdf",
    "*.hdf.series",
    "*.hdf.part",
    "*.hdf.series.part",
    "*_[ab].h5.part",
    "case.yaml.part",
    "case-complete.yaml.part",
    "summary.json.part",
};

char *clod_folder_default(const char *case_path)
{
    const char *slash = strrchr(case_path, '/');
    const char *name = slash == NULL ? case_path : slash + 1;
    const char *dot = strrchr(name, '.');
    const size_t length = dot == NULL || dot == name ? strlen(name) : (size_t)(dot - name);
    const size_t size = length + sizeof "run/";
    char *path = clod_memory_alloc(size, 1);
    if (path != NULL) {
        snprintf(path, size, "run/%.*s", (int)length, name);
    }
    return path;
}

/** Make one folder; one that exists is fine. */
static bool make_one(const char *path, clod_status *status)
{
    struct stat info;
    if (mkdir(path, 0777) == 0) {
        return true;
    }
    const int error = errno;
    if (error == EEXIST && stat(path, &info) == 0 && S_ISDIR(info.st_mode)) {
        return true;
    }
    return clod_file_fail(status, "make the folder", path, error);
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

/** Say who holds the lock, as far as its file tells. */
static void fail_locked(int lock, const char *path, clod_status *status)
{
    char process[32] = "";
    const ssize_t length = pread(lock, process, sizeof process - 1, 0);
    process[length > 0 ? strcspn(process, "\n") : 0] = '\0';
    clod_status_fail(
        status, CLOD_USAGE,
        "Another run%s%s%s is writing into %s. Wait for its end, or choose another "
        "folder with -o.",
        length > 0 ? " (process " : "", process, length > 0 ? ")" : "", path);
}

/** Open and lock the lock file; -1 with status. */
static int take_lock(const char *path, clod_status *status)
{
    char name[PATH_MAX];
    if (!clod_file_path(name, sizeof name, path, LOCK_NAME, status)) {
        return -1;
    }
    const int lock = open(name, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lock < 0) {
        clod_file_fail(status, "write", name, errno);
        return -1;
    }
    if (flock(lock, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK) {
            fail_locked(lock, path, status);
        } else {
            clod_file_fail(status, "lock", name, errno);
        }
        close(lock);
        return -1;
    }
    char process[32];
    const int length = snprintf(process, sizeof process, "%ld\n", (long)getpid());
    const bool told =
        ftruncate(lock, 0) == 0 && pwrite(lock, process, (size_t)length, 0) == length;
    (void)told; // only a help in the message to the next run: a full disk does not matter
    return lock;
}

clod_folder *clod_folder_open(const char *path, clod_status *status)
{
    if (!clod_folder_make(path, status)) {
        return NULL;
    }
    clod_folder *self = clod_memory_alloc(1, sizeof *self);
    char *copy = clod_memory_text(path);
    if (self == NULL || copy == NULL) {
        clod_file_fail(status, "open", path, ENOMEM);
        clod_memory_free(self);
        clod_memory_free(copy);
        return NULL;
    }
    self->path = copy;
    self->lock = take_lock(path, status);
    if (self->lock < 0) {
        clod_memory_free(copy);
        clod_memory_free(self);
        return NULL;
    }
    return self;
}

const char *clod_folder_path(const clod_folder *self)
{
    return self->path;
}

void clod_folder_close(clod_folder **self)
{
    if (*self != NULL) {
        close((*self)->lock); // the lock file stays: removing it would let two runs in
        clod_memory_free((*self)->path);
        clod_memory_free(*self);
        *self = NULL;
    }
}

static bool name_matches(const char *name, const char *const *patterns, size_t count)
{
    for (size_t p = 0; p < count; p++) {
        if (fnmatch(patterns[p], name, FNM_PATHNAME) == 0) {
            return true;
        }
    }
    return false;
}

/** Whether a regular file is clod's: by its name, or by the head of a checkpoint. */
static bool is_own(const char *path, const char *name, const char *const *more,
                   size_t more_count)
{
    struct stat info;
    if (lstat(path, &info) != 0 || !S_ISREG(info.st_mode)) {
        return false;
    }
    return name_matches(name, OWN_NAMES, sizeof OWN_NAMES / sizeof *OWN_NAMES) ||
           name_matches(name, more, more_count) ||
           (fnmatch("*_[ab].h5", name, 0) == 0 && clod_checkpoint_file_is_ours(path));
}

bool clod_folder_clear(const char *path, const char *const *more, size_t more_count,
                       clod_status *status)
{
    DIR *folder = opendir(path);
    if (folder == NULL) {
        return errno == ENOENT || clod_file_fail(status, "read the folder", path, errno);
    }
    bool good = true;
    for (struct dirent *entry; good && (entry = readdir(folder)) != NULL;) {
        char name[PATH_MAX];
        good = clod_file_path(name, sizeof name, path, entry->d_name, status);
        if (good && is_own(name, entry->d_name, more, more_count) && unlink(name) != 0) {
            good = clod_file_fail(status, "remove", name, errno);
        }
    }
    closedir(folder);
    return good;
}

bool clod_folder_write(const char *path, const char *text, clod_status *status)
{
    return clod_file_replace(path, text, strlen(text), NULL, 0, status);
}

bool clod_folder_write_json(const char *path, const json_t *json, clod_status *status)
{
    char *text = json_dumps(json, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    if (text == NULL) {
        return clod_file_fail(status, "write", path, ENOMEM);
    }
    const bool done = clod_file_replace(path, text, strlen(text), "\n", 1, status);
    free(text);
    return done;
}

bool clod_folder_write_case(const char *directory, const char *case_text,
                            const char *complete_text, clod_status *status)
{
    char given[PATH_MAX], complete[PATH_MAX];
    return clod_file_path(given, sizeof given, directory, "case.yaml", status) &&
           clod_file_path(complete, sizeof complete, directory, "case-complete.yaml", status) &&
           clod_folder_write(given, case_text, status) &&
           clod_folder_write(complete, complete_text, status);
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
        if (errno != ENOENT) {
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
