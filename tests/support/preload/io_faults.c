// Calls that touch files, counted, recorded, and made to fail at will; preloaded into the
// program (LD_PRELOAD) by tests/faults/test_io_faults.py.
//
//   CLOD_FAULT_UNDER  only calls on paths that begin with this text are counted
//   CLOD_FAULT_LOG    file that gets a line for each counted call: its name and its path
//   CLOD_FAULT_AT     number of the call that fails, from 1; none fails without it
//   CLOD_FAULT_ONLY   a line of the log: only such calls are numbered for CLOD_FAULT_AT
//   CLOD_FAULT_ERROR  errno value it fails with; 0: a read or write that does half of its work
//   CLOD_FAULT_ON     1: every counted call from there on fails
//   CLOD_FAULT_HANG   1: it does not come back, in place of failing
//   CLOD_FAULT_SLOW   s that it takes, in place of failing
//
// A close that fails has closed, as on Linux. EINTR is only given to calls that may say so.

#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <unistd.h>

#define SHORT (-1) // a read or write of half the bytes

static atomic_long calls;
static __thread bool in_stream; // of a stream, which a signal does not interrupt (SA_RESTART)

/** The function of this name behind this library. */
#define NEXT(name)                                                                             \
    static __typeof__(&name) next;                                                             \
    if (next == NULL) {                                                                        \
        *(void **)&next = dlsym(RTLD_NEXT, #name);                                             \
    }

static void write_log(const char *name, const char *path)
{
    const char *log = getenv("CLOD_FAULT_LOG");
    char line[PATH_MAX + 64];
    const int length = snprintf(line, sizeof line, "%s %s\n", name, path);
    if (log != NULL && length > 0) {
        const long file =
            syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
        if (file >= 0) {
            syscall(SYS_write, file, line, (size_t)length);
            syscall(SYS_close, file);
        }
    }
}

/** Whole path of a name in an open folder, or of the open file when there is no name. */
static void path_of(int descriptor, const char *name, char path[PATH_MAX])
{
    char link[64];
    char folder[PATH_MAX / 2] = "";
    if (name == NULL || (name[0] != '/' && descriptor != AT_FDCWD)) {
        snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
        const long length = syscall(SYS_readlinkat, AT_FDCWD, link, folder, sizeof folder - 1);
        folder[length > 0 ? length : 0] = '\0';
    }
    if (name == NULL) {
        snprintf(path, PATH_MAX, "%s", folder);
    } else {
        snprintf(path, PATH_MAX, "%s%s%s", folder, folder[0] != '\0' ? "/" : "", name);
    }
}

static long number_of(const char *variable, long without)
{
    const char *text = getenv(variable);
    return text == NULL ? without : strtol(text, NULL, 10);
}

/** Count and record a call: 0 when it shall be made, SHORT, or the errno value it fails with.
 */
static int fault(const char *call, int descriptor, const char *name, bool may_interrupt,
                 bool may_be_short)
{
    char path[PATH_MAX];
    const char *under = getenv("CLOD_FAULT_UNDER");
    const int before = errno;
    if (name == NULL && descriptor <= STDERR_FILENO) {
        return 0;
    }
    path_of(descriptor, name, path);
    errno = before;
    if (under != NULL && strncmp(path, under, strlen(under)) != 0) {
        return 0;
    }
    write_log(call, path);
    errno = before;
    const char *only = getenv("CLOD_FAULT_ONLY");
    const size_t length = strlen(call);
    if (only != NULL && (strncmp(only, call, length) != 0 || only[length] != ' ' ||
                         strcmp(only + length + 1, path) != 0)) {
        return 0;
    }
    const long number = atomic_fetch_add(&calls, 1) + 1;
    const long at = number_of("CLOD_FAULT_AT", 0);
    const int error = (int)number_of("CLOD_FAULT_ERROR", EIO);
    const bool later = number_of("CLOD_FAULT_ON", 0) != 0 && number > at;
    if (at == 0 || (number != at && !later) ||
        (error == EINTR && (in_stream || !may_interrupt))) {
        return 0;
    }
    while (number_of("CLOD_FAULT_HANG", 0) != 0) {
        pause(); // until a signal ends the program
    }
    const long slow = number_of("CLOD_FAULT_SLOW", 0);
    if (slow > 0) {
        sleep((unsigned)slow);
        return 0;
    }
    return error != 0 ? error : may_be_short ? SHORT : 0;
}

/** Body of a call that fails by `failed` or is made. */
#define CALL(failed, may_interrupt, descriptor, path, name, ...)                               \
    NEXT(name)                                                                                 \
    const int error = fault(#name, descriptor, path, may_interrupt, false);                    \
    if (error > 0) {                                                                           \
        errno = error;                                                                         \
        return failed;                                                                         \
    }                                                                                          \
    return next(__VA_ARGS__);

/** Body of a read or write. */
#define TRANSFER(name, size, ...)                                                              \
    NEXT(name)                                                                                 \
    const int error = fault(#name, descriptor, NULL, true, size > 1);                          \
    if (error > 0) {                                                                           \
        errno = error;                                                                         \
        return -1;                                                                             \
    }                                                                                          \
    size = error == SHORT ? size / 2 : size;                                                   \
    return next(__VA_ARGS__);

#define MODE(flags)                                                                            \
    mode_t mode = 0;                                                                           \
    if ((flags & O_CREAT) != 0) {                                                              \
        va_list more;                                                                          \
        va_start(more, flags);                                                                 \
        mode = va_arg(more, mode_t);                                                           \
        va_end(more);                                                                          \
    }

int open(const char *path, int flags, ...)
{
    MODE(flags)
    CALL(-1, true, AT_FDCWD, path, open, path, flags, mode)
}

int open64(const char *path, int flags, ...)
{
    MODE(flags)
    CALL(-1, true, AT_FDCWD, path, open64, path, flags, mode)
}

int openat(int folder, const char *path, int flags, ...)
{
    MODE(flags)
    CALL(-1, true, folder, path, openat, folder, path, flags, mode)
}

int openat64(int folder, const char *path, int flags,
             ...){MODE(flags) CALL(-1, true, folder, path, openat64, folder, path, flags, mode)}

ssize_t read(int descriptor, void *bytes,
             size_t size){TRANSFER(read, size, descriptor, bytes, size)}

ssize_t write(int descriptor, const void *bytes,
              size_t size){TRANSFER(write, size, descriptor, bytes, size)}

ssize_t pread(int descriptor, void *bytes, size_t size,
              off_t at){TRANSFER(pread, size, descriptor, bytes, size, at)}

ssize_t pwrite(int descriptor, const void *bytes, size_t size, off_t at)
{
    TRANSFER(pwrite, size, descriptor, bytes, size, at)
}

int fsync(int descriptor)
{
    CALL(-1, true, descriptor, NULL, fsync, descriptor)
}

int fdatasync(int descriptor)
{
    CALL(-1, true, descriptor, NULL, fdatasync, descriptor)
}

int ftruncate(int descriptor, off_t size)
{
    CALL(-1, true, descriptor, NULL, ftruncate, descriptor, size)
}

int flock(int descriptor, int operation)
{
    CALL(-1, true, descriptor, NULL, flock, descriptor, operation)
}

int close(int descriptor)
{
    NEXT(close)
    const int error = fault("close", descriptor, NULL, true, false);
    const int closed = next(descriptor);
    if (error > 0) {
        errno = error;
        return -1;
    }
    return closed;
}

int rename(const char *from, const char *to)
{
    CALL(-1, false, AT_FDCWD, to, rename, from, to)
}

int renameat(int from_folder, const char *from, int to_folder, const char *to)
{
    CALL(-1, false, to_folder, to, renameat, from_folder, from, to_folder, to)
}

int unlink(const char *path)
{
    CALL(-1, false, AT_FDCWD, path, unlink, path)
}

int unlinkat(int folder, const char *path, int flags)
{
    CALL(-1, false, folder, path, unlinkat, folder, path, flags)
}

int mkdir(const char *path, mode_t mode)
{
    CALL(-1, false, AT_FDCWD, path, mkdir, path, mode)
}

int stat(const char *restrict path, struct stat *restrict info)
{
    CALL(-1, false, AT_FDCWD, path, stat, path, info)
}

int lstat(const char *restrict path, struct stat *restrict info)
{
    CALL(-1, false, AT_FDCWD, path, lstat, path, info)
}

int fstat(int descriptor, struct stat *info)
{
    CALL(-1, false, descriptor, NULL, fstat, descriptor, info)
}

int fstatat(int folder, const char *restrict path, struct stat *restrict info, int flags)
{
    CALL(-1, false, folder, path, fstatat, folder, path, info, flags)
}

int statvfs(const char *restrict path, struct statvfs *restrict info)
{
    CALL(-1, true, AT_FDCWD, path, statvfs, path, info)
}

int access(const char *path, int mode)
{
    CALL(-1, false, AT_FDCWD, path, access, path, mode)
}

char *realpath(const char *restrict path, char *restrict resolved){
    CALL(NULL, false, AT_FDCWD, path, realpath, path, resolved)}

DIR *opendir(const char *path){CALL(NULL, false, AT_FDCWD, path, opendir, path)}

DIR *fdopendir(int descriptor)
{
    CALL(NULL, false, descriptor, NULL, fdopendir, descriptor)
}

struct dirent *readdir(DIR *folder)
{
    CALL(NULL, false, dirfd(folder), NULL, readdir, folder)
}

// A stream reads and writes by calls within the C library, which no one else can answer. So
// streams are made of the functions above.

static ssize_t stream_read(void *cookie, char *bytes, size_t size)
{
    in_stream = true;
    const ssize_t got = read((int)(intptr_t)cookie, bytes, size);
    in_stream = false;
    return got;
}

static ssize_t stream_write(void *cookie, const char *bytes, size_t size)
{
    size_t done = 0;
    in_stream = true;
    while (done < size) {
        const ssize_t written = write((int)(intptr_t)cookie, bytes + done, size - done);
        if (written <= 0) {
            break;
        }
        done += (size_t)written;
    }
    in_stream = false;
    return done == size ? (ssize_t)done : 0; // as the C library: it goes on after a short write
}

static int stream_seek(void *cookie, off64_t *offset, int from)
{
    *offset = lseek((int)(intptr_t)cookie, *offset, from);
    return *offset < 0 ? -1 : 0;
}

static int stream_close(void *cookie)
{
    in_stream = true;
    const int closed = close((int)(intptr_t)cookie);
    in_stream = false;
    return closed;
}

static FILE *open_stream(const char *path, const char *mode)
{
    const bool plus = strchr(mode, '+') != NULL;
    const int exclusive = strchr(mode, 'x') != NULL ? O_EXCL : 0;
    const int flags = mode[0] == 'r'   ? (plus ? O_RDWR : O_RDONLY)
                      : mode[0] == 'w' ? (plus ? O_RDWR : O_WRONLY) | O_CREAT | O_TRUNC
                                       : (plus ? O_RDWR : O_WRONLY) | O_CREAT | O_APPEND;
    in_stream = true;
    const int descriptor = open(path, flags | exclusive, 0666);
    in_stream = false;
    if (descriptor < 0) {
        return NULL;
    }
    char plain[3] = {mode[0], plus ? '+' : '\0', '\0'};
    return fopencookie((void *)(intptr_t)descriptor, plain,
                       (cookie_io_functions_t){.read = stream_read,
                                               .write = stream_write,
                                               .seek = stream_seek,
                                               .close = stream_close});
}

/** Whether calls on this path are counted: other streams are left as they are. */
static bool is_watched(const char *path)
{
    const char *under = getenv("CLOD_FAULT_UNDER");
    return under == NULL || strncmp(path, under, strlen(under)) == 0;
}

FILE *fopen(const char *restrict path, const char *restrict mode)
{
    NEXT(fopen)
    return is_watched(path) ? open_stream(path, mode) : next(path, mode);
}

FILE *fopen64(const char *restrict path, const char *restrict mode)
{
    NEXT(fopen64)
    return is_watched(path) ? open_stream(path, mode) : next(path, mode);
}
