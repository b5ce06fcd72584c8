#include "clod/text_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "output/file.h"

/** Write to what is no file: nothing can be replaced there. */
static bool write_to(const char *path, const char *text, clod_status *status)
{
    const int descriptor = open(path, O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) {
        return clod_file_fail(status, "write", path, errno);
    }
    const bool written = clod_file_write_all(descriptor, text, strlen(text));
    const int error = errno;
    const bool closed = close(descriptor) == 0;
    return (written && closed) ||
           clod_file_fail(status, "write", path, written ? errno : error);
}

bool clod_text_file_write(const char *path, const char *input, const char *text,
                          clod_status *status)
{
    struct stat there;
    struct stat given;
    if (stat(path, &there) != 0) {
        return clod_file_replace(path, text, strlen(text), NULL, 0, status);
    }
    if (stat(input, &given) == 0 && there.st_dev == given.st_dev &&
        there.st_ino == given.st_ino) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s is the file that is read; it would be lost. Give another "
                                "name with -o.",
                                path);
    }
    if (!S_ISREG(there.st_mode)) {
        return write_to(path, text, status);
    }
    char *whole = realpath(path, NULL); // a link stays: the file behind it is replaced
    const bool done =
        clod_file_replace(whole != NULL ? whole : path, text, strlen(text), NULL, 0, status);
    free(whole);
    return done;
}
