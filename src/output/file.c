#include "output/file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"

bool clod_file_path(char *path, size_t size, const char *directory, const char *name,
                    clod_status *status)
{
    const int length = snprintf(path, size, "%s/%s", directory, name);
    if (length < 0 || (size_t)length >= size) {
        return clod_status_fail(status, CLOD_FAILED,
                                "The path %s/%s is too long: choose a shorter folder with -o.",
                                directory, name);
    }
    return true;
}

bool clod_file_fail(clod_status *status, const char *action, const char *path, int error)
{
    const char *advice = "";
    if (error == ENOSPC || error == EDQUOT || error == EFBIG) {
        advice = " Free some space, then give the same command again: the run goes on from its "
                 "last checkpoint. What was complete before is untouched.";
    } else if (error == ENOENT && strcmp(action, "write") == 0) {
        advice = " Does the folder exist?";
    } else if (error == ENOENT && strcmp(action, "make the folder") == 0) {
        advice = " No folder can be made there; choose another one with -o.";
    } else if (error == EACCES || error == EROFS || error == EPERM) {
        advice = " Choose a folder that you may write to with -o.";
    }
    return clod_status_fail(status, CLOD_FAILED, "Cannot %s %s: %s.%s", action, path,
                            strerror(error), advice);
}

bool clod_file_write_all(int descriptor, const void *bytes, size_t size)
{
    const char *next = bytes;
    while (size > 0) {
        const ssize_t written = write(descriptor, next, size);
        if (written > 0) {
            next += written;
            size -= (size_t)written;
        } else if (written == 0) {
            errno = ENOSPC;
            return false;
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

/** Bring the entry of a renamed file to the disk; file systems that cannot are accepted. */
static void sync_folder_of(const char *path)
{
    char folder[PATH_MAX];
    const char *slash = strrchr(path, '/');
    const size_t length = slash == NULL ? 0 : (size_t)(slash - path);
    snprintf(folder, sizeof folder, "%.*s", (int)length, path);
    const int descriptor = open(slash == NULL ? "."
                                : length == 0 ? "/"
                                              : folder,
                                O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        fsync(descriptor);
        close(descriptor);
    }
}

bool clod_file_replace(const char *path, const void *head, size_t head_size, const void *body,
                       size_t body_size, clod_status *status)
{
    char part[PATH_MAX];
    if ((size_t)snprintf(part, sizeof part, "%s.part", path) >= sizeof part) {
        return clod_file_fail(status, "write", path, ENAMETOOLONG);
    }
    const int descriptor = open(part, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        return clod_file_fail(status, "write", path, errno);
    }
    bool done = clod_file_write_all(descriptor, head, head_size) &&
                clod_file_write_all(descriptor, body, body_size) && fsync(descriptor) == 0;
    int error = done ? 0 : errno;
    if (close(descriptor) != 0 && done) {
        done = false;
        error = errno;
    }
    if (done && rename(part, path) != 0) {
        done = false;
        error = errno;
    }
    if (!done) {
        unlink(part);
        return clod_file_fail(status, "write", path, error);
    }
    sync_folder_of(path);
    return true;
}

/** Fill `bytes` from the file; *size becomes what was there. */
static bool read_all(int descriptor, char *bytes, size_t *size)
{
    size_t filled = 0;
    while (filled < *size) {
        const ssize_t got = read(descriptor, bytes + filled, *size - filled);
        if (got > 0) {
            filled += (size_t)got;
        } else if (got == 0) {
            break;
        } else if (errno != EINTR) {
            return false;
        }
    }
    *size = filled;
    return true;
}

bool clod_file_read(const char *path, void **bytes, size_t *size, clod_status *status)
{
    *bytes = NULL;
    const int descriptor = open(path, O_RDONLY | O_CLOEXEC);
    struct stat info;
    if (descriptor < 0 || fstat(descriptor, &info) != 0) {
        const int error = errno;
        if (descriptor >= 0) {
            close(descriptor);
        }
        return clod_file_fail(status, "read", path, error);
    }
    *size = (size_t)info.st_size;
    *bytes = clod_memory_alloc(*size + 1, 1);
    const bool done = *bytes != NULL && read_all(descriptor, *bytes, size);
    const int error = *bytes == NULL ? ENOMEM : errno;
    close(descriptor);
    if (!done) {
        clod_memory_free(*bytes);
        *bytes = NULL;
        return clod_file_fail(status, "read", path, error);
    }
    ((char *)*bytes)[*size] = '\0';
    return true;
}

/** One step of the hash: for a given word a one-to-one map of the hash, and the reverse. */
static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * 0x9fb21c651e98df25u; // an odd factor loses nothing
    return hash ^ (hash >> 32);
}

uint64_t clod_file_hash(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *next = bytes;
    for (size_t left = size; left > 0;) {
        uint64_t word = 0;
        const size_t take = left < sizeof word ? left : sizeof word;
        memcpy(&word, next, take);
        hash = mix(hash, word);
        next += take;
        left -= take;
    }
    return mix(hash, size);
}
