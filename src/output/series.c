#include "output/series.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/file.h"
#include "output/folder_files.h"

struct clod_series {
    const clod_folder *folder; ///< borrowed
    int descriptor;
    size_t columns;
    clod_series_mark mark; ///< end of the file
    char *name;            ///< owned
    char *row;             ///< owned, [columns * CLOD_SERIES_NUMBER]
};

static bool fail(const clod_series *self, const char *action, int error, clod_status *status)
{
    return clod_folder_fail(self->folder, action, self->name, error, status);
}

bool clod_series_close(clod_series **self, clod_status *status)
{
    clod_series *series = *self;
    *self = NULL;
    if (series == NULL) {
        return true;
    }
    const int error = series->descriptor >= 0 ? clod_file_close(series->descriptor) : 0;
    const bool good = error == 0 || fail(series, "write", error, status);
    clod_memory_free(series->name);
    clod_memory_free(series->row);
    clod_memory_free(series);
    return good;
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
        return fail(self, "write", errno, status);
    }
    self->mark.bytes += (int64_t)length;
    self->mark.crc32 = clod_file_crc32(self->mark.crc32, text, length);
    return true;
}

/** What is wrong with the bytes of a table; NULL: nothing. `header` may be NULL. */
static const char *find_fault(const char *bytes, size_t size, const char *header,
                              const clod_series_mark *mark)
{
    const size_t kept = (size_t)mark->bytes;
    const size_t length = header != NULL ? strlen(header) : 0;
    if (bytes == NULL) {
        return "is not there any more";
    }
    if (size < kept) {
        return "is shorter than at the checkpoint";
    }
    if (kept < length || (header != NULL && strncmp(bytes, header, length) != 0)) {
        return "has other columns than this run writes";
    }
    return clod_file_crc32(0, bytes, kept) == mark->crc32
               ? NULL
               : "was changed since the checkpoint, or is damaged: its checksum is another one";
}

/** Whether the file on disk is the table that was left at the checkpoint. */
static bool check_old(const clod_folder *folder, const char *name, const char *header,
                      const clod_series_mark *mark, clod_status *status)
{
    void *bytes;
    size_t size = 0;
    if (!clod_folder_read(folder, name, &bytes, &size, status)) {
        return false;
    }
    const char *fault = find_fault(bytes, size, header, mark);
    clod_memory_free(bytes);
    return fault == NULL ||
           clod_status_fail(status, CLOD_FAILED,
                            "Cannot go on with %s/%s: it %s. Put back the file "
                            "as the run left it, or start over with --fresh.",
                            folder->path, name, fault);
}

bool clod_series_check(const clod_folder *folder, const char *name,
                       const clod_series_mark *mark, clod_status *status)
{
    return check_old(folder, name, NULL, mark, status);
}

/** Shorten an open file, again after signals. */
static bool shorten(clod_series *self, int64_t bytes, clod_status *status)
{
    int result;
    do {
        result = ftruncate(self->descriptor, bytes);
    } while (result != 0 && errno == EINTR);
    return result == 0 || fail(self, "shorten", errno, status);
}

/** Open the file and write the header, or cut it to the mark. */
static bool open_file(clod_series *self, const char *header, const clod_series_mark *resume,
                      clod_status *status)
{
    if (resume != NULL && !check_old(self->folder, self->name, header, resume, status)) {
        return false;
    }
    const int flags = O_WRONLY | O_APPEND | (resume == NULL ? O_CREAT | O_TRUNC : 0);
    self->descriptor = clod_folder_open_file(self->folder, self->name, flags, status);
    if (self->descriptor < 0) {
        return false;
    }
    if (resume == NULL) {
        return append(self, header, strlen(header), status);
    }
    self->mark = *resume;
    return shorten(self, resume->bytes, status);
}

clod_series *clod_series_open(const clod_folder *folder, const char *name,
                              const char *const *columns, size_t column_count,
                              const clod_series_mark *resume, clod_status *status)
{
    clod_series *self = clod_memory_alloc(1, sizeof *self);
    char *header = header_line(columns, column_count);
    if (self != NULL) {
        self->folder = folder;
        self->descriptor = -1;
        self->columns = column_count;
        self->name = clod_memory_text(name);
        self->row = clod_memory_alloc(column_count, CLOD_SERIES_NUMBER);
    }
    bool good = header != NULL && self != NULL && self->name != NULL && self->row != NULL;
    if (!good) {
        clod_folder_fail(folder, "write", name, ENOMEM, status);
    }
    good = good && open_file(self, header, resume, status);
    clod_memory_free(header);
    if (!good) {
        clod_series_close(&self, &(clod_status){0}); // the first error is the one to tell
    }
    return self;
}

size_t clod_series_number(char text[CLOD_SERIES_NUMBER], double value)
{
    if (value != value) {
        return (size_t)snprintf(text, CLOD_SERIES_NUMBER, "nan");
    }
    int length = 0;
    for (int digits = 15; digits <= 17; digits++) {
        length = snprintf(text, CLOD_SERIES_NUMBER, "%.*g", digits, value);
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
        length += clod_series_number(self->row + length, values[c]);
        self->row[length++] = c + 1 < self->columns ? ',' : '\n';
    }
    return append(self, self->row, length, status);
}

bool clod_series_text(clod_series *self, const char *text, size_t length, clod_status *status)
{
    return append(self, text, length, status);
}

clod_series_mark clod_series_position(const clod_series *self)
{
    return self->mark;
}

bool clod_series_sync(clod_series *self, clod_status *status)
{
    const int error = clod_file_sync(self->descriptor);
    return error == 0 || fail(self, "write", error, status);
}
