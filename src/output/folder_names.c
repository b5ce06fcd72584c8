#include "output/folder_names.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <regex.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "output/file.h"
#include "output/folder_files.h"

#define PART CLOD_FOLDER_PART

/** Names of what a run leaves in its folder, but for the copies of the case. */
#define RESULT                                                                                 \
    "log[.]jsonl|(series|energy|leavers|" PART                                                 \
    "(-energy)?)[.]csv|case(-complete)?[.]yaml[.]part|"                                        \
    "(summary[.]json|report[.]txt|points[.]csv|flow_function[.]csv|wall_friction[.]csv|"       \
    "gauge_[A-Za-z0-9_]+-(profile|trajectory)[.]csv|"                                          \
    "(clumps|impacts|residence)[.]csv|report[.]html|report-[A-Za-z0-9-]+[.]svg)([.]part)?|" CLOD_FOLDER_SPARE

#define COPY_OF_CASE "case(-complete)?[.]yaml"

/** A folder that is being read for names that match a pattern. */
typedef struct name_scan {
    DIR *folder;
    regex_t pattern;
    int error; ///< errno of what ended it early, or 0
} name_scan;

static bool scan_begin(name_scan *self, const clod_folder *folder, const char *pattern,
                       clod_status *status)
{
    // a descriptor of its own: reading moves the place in the folder
    const int descriptor = clod_file_open(folder->descriptor, ".", O_RDONLY | O_DIRECTORY);
    self->folder = descriptor < 0 ? NULL : fdopendir(descriptor);
    self->error = 0;
    if (self->folder == NULL) {
        const int error = errno;
        if (descriptor >= 0) {
            clod_file_close(descriptor);
        }
        return clod_file_fail(status, "read the folder", folder->path, error);
    }
    if (regcomp(&self->pattern, pattern, REG_EXTENDED | REG_NOSUB) != 0) {
        closedir(self->folder);
        return clod_file_fail(status, "read the folder", folder->path, ENOMEM);
    }
    return true;
}

/** The next name that matches, borrowed until the next call; NULL at the end. */
static const char *scan_next(name_scan *self)
{
    for (;;) {
        errno = 0;
        const struct dirent *entry = readdir(self->folder);
        if (entry == NULL) {
            self->error = errno;
            return NULL;
        }
        if (regexec(&self->pattern, entry->d_name, 0, NULL, 0) == 0) {
            return entry->d_name;
        }
    }
}

/** End; false when not all names were seen. */
static bool scan_end(name_scan *self, const clod_folder *folder, clod_status *status)
{
    closedir(self->folder);
    regfree(&self->pattern);
    return self->error == 0 ||
           clod_file_fail(status, "read the folder", folder->path, self->error);
}

bool clod_folder_names_first(const clod_folder *self, char name[NAME_MAX + 1],
                             clod_status *status)
{
    name_scan scan;
    name[0] = '\0';
    if (!scan_begin(&scan, self, "^(" RESULT "|" COPY_OF_CASE ")$", status)) {
        return false;
    }
    for (const char *next; (next = scan_next(&scan)) != NULL;) {
        if (name[0] == '\0' || strcmp(next, name) < 0) {
            snprintf(name, NAME_MAX + 1, "%s", next);
        }
    }
    return scan_end(&scan, self, status);
}

bool clod_folder_names_each(const clod_folder *self, const char *pattern,
                            bool (*visit)(void *context, const char *name, clod_status *status),
                            void *context, clod_status *status)
{
    name_scan scan;
    if (!scan_begin(&scan, self, pattern, status)) {
        return false;
    }
    bool good = true;
    for (const char *name; good && (name = scan_next(&scan)) != NULL;) {
        good = visit(context, name, status);
    }
    return scan_end(&scan, self, good ? status : &(clod_status){0}) && good;
}

/** Remove a regular file of this name; what is none stays. */
static bool remove_file(const clod_folder *folder, const char *name, clod_status *status)
{
    struct stat info;
    if (fstatat(folder->descriptor, name, &info, AT_SYMLINK_NOFOLLOW) != 0) {
        return errno == ENOENT || clod_folder_fail(folder, "look at", name, errno, status);
    }
    return !S_ISREG(info.st_mode) || clod_folder_remove(folder, name, status);
}

bool clod_folder_clear(const clod_folder *self, clod_status *status)
{
    name_scan scan;
    if (!scan_begin(&scan, self, "^(" RESULT ")$", status)) {
        return false;
    }
    bool good = true;
    for (const char *name; good && (name = scan_next(&scan)) != NULL;) {
        good = remove_file(self, name, status);
    }
    return scan_end(&scan, self, good ? status : &(clod_status){0}) && good;
}
