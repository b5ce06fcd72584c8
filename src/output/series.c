#include "output/series.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/file.h"

#define NUMBER_BYTES 32 // "%.17g" of a double and a comma need at most 25

struct clod_series {
    int descriptor;
    size_t columns;
    int64_t bytes;
    char *path; ///< owned
    char *row;  ///< owned, [columns * NUMBER_BYTES]
};

void clod_series_close(clod_series **self)
{
    if (*self != NULL) {
        if ((*self)->descriptor >= 0) {
            close((*self)->descriptor);
        }
        clod_memory_free((*self)->path);
        clod_memory_free((*self)->row);
        clod_memory_free(*self);
        *self = NULL;
    }
}

/** Owned header line; NULL without memory. */
static char *header_line(const char *const *columns, size_t count)
{
    size_t size = 1;
    for (size_t c = 0; c < count; c++) {
        size += strlen(columns[c]) + 1;
    }
    char *line = clod_memory_alloc(size, 1);
    for (size_t c = 0, used = 0; line != NULL && c < count; c++) {
        used += (size_t)snprintf(line + used, size - used, "%s%s", columns[c],
                                 c + 1 < count ? "," : "\n");
    }
    return line;
}

static bool append(clod_series *self, const char *text, size_t length, clod_status *status)
{
    if (!clod_file_write_all(self->descriptor, text, length)) {
        return clod_file_fail(status, "write", self->path, errno);
    }
    self->bytes += (int64_t)length;
    return true;
}

/** Whether the file on disk is the table that was left at the checkpoint. */
static bool check_old(const char *path, const char *header, int64_t resume_bytes,
                      clod_status *status)
{
    void *bytes;
    size_t size;
    if (!clod_file_read(path, &bytes, &size, status)) {
        return false;
    }
    const size_t length = strlen(header);
    const size_t kept = (size_t)resume_bytes;
    const char *fault = NULL;
    if (size < kept) {
        fault = "is shorter than at the checkpoint";
    } else if (kept < length || strncmp(bytes, header, length) != 0) {
        fault = "has other columns than this run writes";
    } else if (((const char *)bytes)[kept - 1] != '\n') {
        fault = "was changed since the checkpoint";
    }
    clod_memory_free(bytes);
    return fault == NULL || clod_status_fail(status, CLOD_FAILED,
                                             "Cannot go on with %s: it %s. Start over with "
                                             "--fresh.",
                                             path, fault);
}

/** Open the file and write the header, or cut it to resume_bytes. */
static bool open_file(clod_series *self, const char *header, int64_t resume_bytes,
                      clod_status *status)
{
    const bool fresh = resume_bytes < 0;
    if (!fresh && !check_old(self->path, header, resume_bytes, status)) {
        return false;
    }
    const int flags = O_WRONLY | O_APPEND | O_CLOEXEC | (fresh ? O_CREAT | O_TRUNC : 0);
    self->descriptor = open(self->path, flags, 0666);
    if (self->descriptor < 0) {
        return clod_file_fail(status, "write", self->path, errno);
    }
    if (fresh) {
        return append(self, header, strlen(header), status);
    }
    if (ftruncate(self->descriptor, resume_bytes) != 0) {
        return clod_file_fail(status, "shorten", self->path, errno);
    }
    self->bytes = resume_bytes;
    return true;
}

clod_series *clod_series_open(const char *path, const char *const *columns, size_t column_count,
                              int64_t resume_bytes, clod_status *status)
{
    clod_series *self = clod_memory_alloc(1, sizeof *self);
    char *header = header_line(columns, column_count);
    if (self != NULL) {
        self->descriptor = -1;
        self->columns = column_count;
        self->path = clod_memory_text(path);
        self->row = clod_memory_alloc(column_count, NUMBER_BYTES);
    }
    bool good = header != NULL && self != NULL && self->path != NULL && self->row != NULL;
    if (!good) {
        clod_file_fail(status, "write", path, ENOMEM);
    }
    good = good && open_file(self, header, resume_bytes, status);
    clod_memory_free(header);
    if (!good) {
        clod_series_close(&self);
    }
    return self;
}

/** Print with as few digits as read back exactly; returns the length. */
static size_t print_number(char text[NUMBER_BYTES], double value)
{
    if (value != value) {
        return (size_t)snprintf(text, NUMBER_BYTES, "nan");
    }
    int length = 0;
    for (int digits = 15; digits <= 17; digits++) {
        length = snprintf(text, NUMBER_BYTES, "%.*g", digits, value);
        if (strtod(text, NULL) == value) {
            break;
        }
    }
    return (size_t)length;
}

bool clod_series_row(clod_series *self, const double *values, clod_status *status)
{
    size_t length = 0;
    for (size_t c = 0; c < self->columns; c++) {
        length += print_number(self->row + length, values[c]);
        self->row[length++] = c + 1 < self->columns ? ',' : '\n';
    }
    return append(self, self->row, length, status);
}

int64_t clod_series_bytes(const clod_series *self)
{
    return self->bytes;
}

bool clod_series_sync(clod_series *self, clod_status *status)
{
    return fdatasync(self->descriptor) == 0 ||
           clod_file_fail(status, "write", self->path, errno);
}
