#include "output/folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <regex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/file.h"

#define LOCK_NAME ".clod-lock"

/** Parts of the testers, as sim/ring_run.c (ring_shear and jenike) and sim/uniaxial_run.c name
 * them. */
#define PART "((seed-[0-9]+-)?(preshear|reverse|point-[0-9]+)|fill|stress-[0-9]+)"

/** Names of what a run leaves in its folder, but for the copies of the case. */
#define RESULT                                                                                 \
    "log[.]jsonl|(series|energy|" PART "(-energy)?)[.]csv|case(-complete)?[.]yaml[.]part|"     \
    "(summary[.]json|points[.]csv|flow_function[.]csv|"                                        \
    "restart(-" PART ")?(-failed)?_[ab][.]h5|"                                                 \
    "(" PART "_)?(snap|walls|contacts)_[0-9]{6,}[.]hdf|"                                       \
    "(run|" PART ")(_walls|_contacts)?[.]hdf[.]series)([.]part)?"

#define COPY_OF_CASE "case(-complete)?[.]yaml"

struct clod_folder {
    char *path; ///< owned
    int lock;
};

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

/** Name of the folder that holds a file, as it is on the disk; NULL for that of the root. */
static char *name_of_folder(const char *file)
{
    char folder[PATH_MAX];
    char whole[PATH_MAX];
    const char *slash = strrchr(file, '/');
    snprintf(folder, sizeof folder, "%.*s", slash == NULL ? 1 : (int)(slash - file) + 1,
             slash == NULL ? "." : file);
    const char *found = realpath(folder, whole);
    const char *name = found == NULL ? NULL : strrchr(found, '/') + 1;
    return name == NULL || name[0] == '\0' ? NULL : clod_memory_text(name);
}

char *clod_folder_default(const char *case_path)
{
    const char *slash = strrchr(case_path, '/');
    const char *name = slash == NULL ? case_path : slash + 1;
    const char *dot = strrchr(name, '.');
    const size_t length = dot == NULL || dot == name ? strlen(name) : (size_t)(dot - name);
    char *holder = strcmp(name, "case.yaml") == 0 ? name_of_folder(case_path) : NULL;
    char *path = holder != NULL ? below_run(holder, strlen(holder)) : below_run(name, length);
    clod_memory_free(holder);
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
    if (error == EEXIST) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s is there and is not a folder: results cannot be written "
                                "into it. Choose another folder with -o, or move it away.",
                                path);
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

/** A folder that is being read for names that match a pattern. */
typedef struct name_scan {
    DIR *folder;
    regex_t pattern;
} name_scan;

static bool scan_begin(name_scan *self, const char *path, const char *pattern,
                       clod_status *status)
{
    self->folder = opendir(path);
    if (self->folder == NULL) {
        return clod_file_fail(status, "read the folder", path, errno);
    }
    if (regcomp(&self->pattern, pattern, REG_EXTENDED | REG_NOSUB) != 0) {
        closedir(self->folder);
        return clod_file_fail(status, "read the folder", path, ENOMEM);
    }
    return true;
}

/** The next name that matches, borrowed until the next call; NULL at the end. */
static const char *scan_next(name_scan *self)
{
    const struct dirent *entry = readdir(self->folder);
    while (entry != NULL && regexec(&self->pattern, entry->d_name, 0, NULL, 0) != 0) {
        entry = readdir(self->folder);
    }
    return entry == NULL ? NULL : entry->d_name;
}

static void scan_end(name_scan *self)
{
    closedir(self->folder);
    regfree(&self->pattern);
}

/** Refuse a folder that no run has locked before and that has what a run would write over. */
static bool check_ours(const char *path, const char *lock, clod_status *status)
{
    name_scan scan;
    char first[NAME_MAX + 1] = "";
    if (!scan_begin(&scan, path, "^(" RESULT "|" COPY_OF_CASE ")$", status)) {
        return false;
    }
    for (const char *name; (name = scan_next(&scan)) != NULL;) {
        if (first[0] == '\0' || strcmp(name, first) < 0) {
            snprintf(first, sizeof first, "%s", name);
        }
    }
    scan_end(&scan);
    // the lock is looked for after the names: another run that begins here makes it first
    return first[0] == '\0' || access(lock, F_OK) == 0 ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s/%s is in the way: a run would replace it, and clod did not "
                            "make this folder (there is no %s in it). Choose another folder "
                            "with -o, or move the file away. If this is a copy of a results "
                            "folder, copy its %s too.",
                            path, first, LOCK_NAME, LOCK_NAME);
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

/** Open and lock the lock file, if the folder may be written to; -1 with status. */
static int take_lock(const char *path, clod_status *status)
{
    char name[PATH_MAX];
    if (!clod_file_path(name, sizeof name, path, LOCK_NAME, status) ||
        !check_ours(path, name, status)) {
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

/** Remove a regular file of this name; what is none stays. */
static bool remove_file(const char *path, const char *name, clod_status *status)
{
    char whole[PATH_MAX];
    struct stat info;
    if (!clod_file_path(whole, sizeof whole, path, name, status)) {
        return false;
    }
    return lstat(whole, &info) != 0 || !S_ISREG(info.st_mode) || unlink(whole) == 0 ||
           clod_file_fail(status, "remove", whole, errno);
}

bool clod_folder_clear(const clod_folder *self, clod_status *status)
{
    name_scan scan;
    if (!scan_begin(&scan, self->path, "^(" RESULT ")$", status)) {
        return false;
    }
    bool good = true;
    for (const char *name; good && (name = scan_next(&scan)) != NULL;) {
        good = remove_file(self->path, name, status);
    }
    scan_end(&scan);
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
