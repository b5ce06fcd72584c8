#include "clod/text_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/given.h"
#include "output/file.h"

/** Write to what is no file: nothing can be replaced there. */
static bool write_to(const char *path, const char *text, clod_status *status)
{
    const int descriptor = clod_file_open(AT_FDCWD, path, O_WRONLY);
    if (descriptor < 0) {
        return clod_file_fail(status, "write", path, errno);
    }
    const bool written = clod_file_write_all(descriptor, text, strlen(text));
    const int error = written ? 0 : errno;
    const int closing = clod_file_close(descriptor);
    return (error == 0 && closing == 0) ||
           clod_file_fail(status, "write", path, error != 0 ? error : closing);
}

/** Look at a file; false with status when it cannot be told whether it is there. */
static bool look_at(const char *path, struct stat *info, bool *there, clod_status *status)
{
    *there = stat(path, info) == 0;
    return *there || errno == ENOENT || errno == ENOTDIR || // a file where a folder would be
           clod_file_fail(status, "look at", path, errno);
}

bool clod_text_file_write(const char *path, const char *input, const char *text,
                          clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(input, status) || !CLOD_GIVEN(text, status)) {
        return false;
    }
    struct stat old, given;
    bool is_old, is_given;
    if (!look_at(path, &old, &is_old, status) || !look_at(input, &given, &is_given, status)) {
        return false;
    }
    if (!is_old) {
        return clod_file_replace(path, text, strlen(text), NULL, 0, status);
    }
    if (is_given && old.st_dev == given.st_dev && old.st_ino == given.st_ino) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s is the file that is read; it would be lost. Give another "
                                "name with -o.",
                                path);
    }
    if (!S_ISREG(old.st_mode)) {
        return write_to(path, text, status);
    }
    char *whole = realpath(path, NULL); // a link stays: the file behind it is replaced
    if (whole == NULL) {
        return clod_file_fail(status, "look at", path, errno);
    }
    const bool done = clod_file_replace(whole, text, strlen(text), NULL, 0, status);
    free(whole);
    return done;
}
