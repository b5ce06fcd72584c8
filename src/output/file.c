#include "output/file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "base/memory.h"

bool clod_file_is_there(const char *path, bool *there, clod_status *status)
{
    *there = access(path, F_OK) == 0;
    return *there || errno == ENOENT || errno == ENOTDIR || // a file where a folder would be
           clod_file_fail(status, "look at", path, errno);
}

bool clod_file_is_full(int error)
{
    return error == ENOSPC || error == EDQUOT || error == EFBIG;
}

bool clod_file_fail(clod_status *status, const char *action, const char *path, int error)
{
    const char *advice = "";
    if (clod_file_is_full(error)) {
        advice = " Free some space, then give the same command again.";
    } else if (error == ENOENT && strcmp(action, "write") == 0) {
        advice = " Does the folder exist?";
    } else if (error == ENOENT && strcmp(action, "make the folder") == 0) {
        advice = " No folder can be made there; choose another one with -o.";
    } else if (error == EACCES || error == EROFS || error == EPERM) {
        advice = " Choose a folder that you may write to with -o.";
    } else if (error == ELOOP) {
        advice = " clod does not write through symbolic links in a results folder: remove it.";
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

int clod_file_write_at(int descriptor, uint64_t at, const void *bytes, size_t size)
{
    for (size_t done = 0; done < size;) {
        const ssize_t written =
            pwrite(descriptor, (const char *)bytes + done, size - done, (off_t)(at + done));
        if (written > 0) {
            done += (size_t)written;
        } else if (written == 0) {
            return ENOSPC;
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

int clod_file_read_at(int descriptor, uint64_t at, void *bytes, size_t size)
{
    for (size_t done = 0; done < size;) {
        const ssize_t got =
            pread(descriptor, (char *)bytes + done, size - done, (off_t)(at + done));
        if (got > 0) {
            done += (size_t)got;
        } else if (got == 0) {
            return EIO; // cut off since its length was asked for
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

int clod_file_truncate(int descriptor, uint64_t size)
{
    int result;
    do {
        result = ftruncate(descriptor, (off_t)size);
    } while (result != 0 && errno == EINTR);
    return result == 0 ? 0 : errno;
}

int clod_file_open(int folder, const char *name, int flags)
{
    int descriptor;
    do {
        descriptor = openat(folder, name, flags | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EINTR);
    return descriptor;
}

int clod_file_sync(int descriptor)
{
    int result;
    do {
        result = fsync(descriptor);
    } while (result != 0 && errno == EINTR);
    return result == 0 ? 0 : errno;
}

int clod_file_close(int descriptor)
{
    // Linux frees the descriptor before it can be interrupted: another close could hit a new
    // file
    return close(descriptor) == 0 || errno == EINTR ? 0 : errno;
}

int clod_file_sync_entry(const char *path)
{
    char folder[PATH_MAX];
    if ((size_t)snprintf(folder, sizeof folder, "%s", path) >= sizeof folder) {
        return ENAMETOOLONG;
    }
    size_t length = strlen(folder);
    while (length > 1 && folder[length - 1] == '/') {
        folder[--length] = '\0';
    }
    char *slash = strrchr(folder, '/');
    if (slash == NULL) {
        snprintf(folder, sizeof folder, ".");
    } else {
        slash[slash == folder ? 1 : 0] = '\0';
    }
    const int descriptor = clod_file_open(AT_FDCWD, folder, O_RDONLY | O_DIRECTORY);
    if (descriptor < 0) {
        return errno == EACCES ? 0 : errno; // a folder that may be written to but not read
    }
    const int error = clod_file_sync(descriptor);
    clod_file_close(descriptor);
    return error == EINVAL ? 0 : error; // the file system cannot
}

/** Write a new file and bring it to the disk; 0 or an errno value, and there is no file then.
 */
static int write_new(const char *path, const void *head, size_t head_size, const void *body,
                     size_t body_size)
{
    const int descriptor =
        clod_file_open(AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (descriptor < 0) {
        return errno;
    }
    const bool written = clod_file_write_all(descriptor, head, head_size) &&
                         clod_file_write_all(descriptor, body, body_size);
    int error = written ? clod_file_sync(descriptor) : errno;
    const int closing = clod_file_close(descriptor);
    error = error != 0 ? error : closing;
    if (error != 0) {
        unlink(path);
    }
    return error;
}

bool clod_file_replace(const char *path, const void *head, size_t head_size, const void *body,
                       size_t body_size, clod_status *status)
{
    char part[PATH_MAX];
    if ((size_t)snprintf(part, sizeof part, "%s.part", path) >= sizeof part) {
        return clod_file_fail(status, "write", path, ENAMETOOLONG);
    }
    int error = write_new(part, head, head_size, body, body_size);
    if (error == 0 && rename(part, path) != 0) {
        error = errno;
        unlink(part);
    }
    if (error == 0) {
        error = clod_file_sync_entry(path);
    }
    return error == 0 || clod_file_fail(status, "write", path, error);
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

int clod_file_load(int folder, const char *name, void **bytes, size_t *size)
{
    *bytes = NULL;
    const int descriptor = clod_file_open(folder, name, O_RDONLY);
    if (descriptor < 0) {
        return errno;
    }
    struct stat info;
    int error = fstat(descriptor, &info) == 0 ? 0 : errno;
    if (error == 0) {
        *size = (size_t)info.st_size;
        *bytes = clod_memory_alloc(*size + 1, 1);
        error = *bytes == NULL ? ENOMEM : read_all(descriptor, *bytes, size) ? 0 : errno;
    }
    clod_file_close(descriptor); // nothing was written
    if (error != 0) {
        clod_memory_free(*bytes);
        *bytes = NULL;
        return error;
    }
    ((char *)*bytes)[*size] = '\0';
    return 0;
}

bool clod_file_read(const char *path, void **bytes, size_t *size, clod_status *status)
{
    const int error = clod_file_load(AT_FDCWD, path, bytes, size);
    return error == 0 || clod_file_fail(status, "read", path, error);
}

uint64_t clod_file_crc32(uint64_t sum, const void *bytes, size_t size)
{
    return crc32_z((uLong)sum, bytes, size);
}

/** One step of the hash: for a given word a one-to-one map of the hash, and the reverse. */
static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * 0x9fb21c651e98df25u; // an odd factor loses nothing
    return hash ^ (hash >> 32);
}

uint64_t clod_file_hash_words(uint64_t hash, const void *bytes, size_t size)
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
    return hash;
}

uint64_t clod_file_hash_end(uint64_t hash, uint64_t size)
{
    return mix(hash, size);
}

uint64_t clod_file_hash(uint64_t hash, const void *bytes, size_t size)
{
    return clod_file_hash_end(clod_file_hash_words(hash, bytes, size), size);
}

#define READ_BYTES 65536 // of a file at a time; a multiple of the hash's words

uint64_t clod_file_blocks(uint64_t bytes)
{
    return bytes / CLOD_FILE_BLOCK + (bytes % CLOD_FILE_BLOCK > 0);
}

int clod_file_hash_block(int descriptor, uint64_t start, uint64_t bytes, uint64_t number,
                         uint64_t *hash)
{
    char some[READ_BYTES];
    const uint64_t first = number * CLOD_FILE_BLOCK, left = bytes - first;
    const uint64_t size = left < CLOD_FILE_BLOCK ? left : CLOD_FILE_BLOCK;
    *hash = CLOD_FILE_HASH_START;
    for (uint64_t at = 0; at < size;) {
        const size_t take = size - at < sizeof some ? (size_t)(size - at) : sizeof some;
        const int error = clod_file_read_at(descriptor, start + first + at, some, take);
        if (error != 0) {
            return error;
        }
        *hash = clod_file_hash_words(*hash, some, take);
        at += take;
    }
    *hash = clod_file_hash_end(*hash, size);
    return 0;
}
