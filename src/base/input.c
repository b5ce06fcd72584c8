#include "base/input.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"

#define FIRST 65536 ///< bytes; the room doubles when they are full

/** Record that `action` on a file failed, and what the user can do about it. */
static bool fail(const char *name, const char *action, int error, clod_status *status)
{
    const bool users = error == ENOENT || error == EISDIR || error == EACCES ||
                       error == ENOTDIR || error == ELOOP || error == ENAMETOOLONG;
    const char *advice = error == EISDIR ? "; name a file in it"
                         : error == EACCES
                             ? "; you have no right to read it, ls -l shows whose "
                               "it is and what is allowed"
                             : "";
    return clod_status_fail(status, users ? CLOD_USAGE : CLOD_FAILED, "%s: cannot be %s: %s%s",
                            name, action, strerror(error), advice);
}

/** Open to read, again after signals. */
static int open_again(const char *path, int flags)
{
    int descriptor;
    do {
        descriptor = open(path, O_RDONLY | O_CLOEXEC | flags);
    } while (descriptor < 0 && errno == EINTR);
    return descriptor;
}

/** Read until the end or `most`, with room for `first` bytes to begin with; false with errno
 *  set, ENOMEM included. */
static bool read_all(int descriptor, size_t first, size_t most, char **text, size_t *length)
{
    size_t room = 0;
    for (;;) {
        if (*length + 1 >= room && *length < most) {
            const size_t wanted = room == 0 ? first : 2 * room;
            char *grown = clod_memory_grow(*text, room, wanted, 1);
            if (grown == NULL) {
                errno = ENOMEM;
                return false;
            }
            *text = grown;
            room = wanted;
        }
        const size_t free_room = room - *length - 1;
        const size_t left = most - *length;
        const ssize_t got =
            read(descriptor, *text + *length, left < free_room ? left : free_room);
        if (got > 0) {
            *length += (size_t)got;
        }
        if (got == 0 || *length == most) {
            (*text)[*length] = '\0';
            return true;
        }
        if (got < 0 && errno != EINTR) {
            return false;
        }
    }
}

bool clod_input_read(const char *path, size_t most, char **text, size_t *length,
                     clod_status *status)
{
    const char *name = path != NULL ? path : CLOD_INPUT_STANDARD;
    *text = NULL;
    *length = 0;
    const int descriptor = path != NULL ? open_again(path, 0) : STDIN_FILENO;
    if (descriptor < 0) {
        return fail(name, "opened", errno, status);
    }
    const bool done = read_all(descriptor, FIRST, most, text, length);
    const int error = errno;
    if (path != NULL) {
        close(descriptor); // nothing was written
    }
    if (!done) {
        clod_memory_free(*text);
        *text = NULL;
        return fail(name, "read", error, status);
    }
    return true;
}

/** Whether an open file is regular and not too large. */
static bool is_readable(const char *path, const struct stat *about, size_t most,
                        clod_status *status)
{
    if (!S_ISREG(about->st_mode) && !S_ISDIR(about->st_mode)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: it is no regular file, so its size is not known before it "
                                "is read; copy its content into a file",
                                path);
    }
    if (S_ISREG(about->st_mode) && (uintmax_t)about->st_size > most) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: the file has %.3g GB; %.3g GB are read at most: take "
                                "a coarser one, or split it into several files",
                                path, (double)about->st_size * 1e-9, (double)most * 1e-9);
    }
    return true;
}

bool clod_input_read_named(const char **path, char **text, size_t *length, clod_status *status)
{
    const bool standard = strcmp(*path, "-") == 0;
    const bool good = clod_input_read(standard ? NULL : *path, SIZE_MAX, text, length, status);
    *path = standard ? CLOD_INPUT_STANDARD : *path;
    return good;
}

bool clod_input_read_regular(const char *path, size_t most, char **text, size_t *length,
                             clod_status *status)
{
    *text = NULL;
    *length = 0;
    const int descriptor =
        open_again(path, O_NONBLOCK); // a pipe without a writer waits for one
    if (descriptor < 0) {
        return fail(path, "opened", errno, status);
    }
    struct stat about;
    bool done = fstat(descriptor, &about) == 0;
    if (done && !is_readable(path, &about, most, status)) {
        close(descriptor);
        return false;
    }
    const size_t first = // the end is seen without more room
        done && S_ISREG(about.st_mode) ? (size_t)about.st_size + 2 : FIRST;
    done = done && read_all(descriptor, first, most, text, length);
    const int error = errno;
    close(descriptor); // nothing was written
    if (!done) {
        clod_memory_free(*text);
        *text = NULL;
        return fail(path, "read", error, status);
    }
    return true;
}

size_t clod_input_mark(const char *text)
{
    const size_t length = sizeof CLOD_INPUT_MARK - 1;
    return strncmp(text, CLOD_INPUT_MARK, length) == 0 ? length : 0;
}
