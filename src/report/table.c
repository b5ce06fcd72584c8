#include "report/table.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "output/file.h"

static bool fail_memory(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "No memory for a table of the report.");
}

static size_t count_of(const char *text, char what)
{
    size_t count = 0;
    for (; *text != '\0'; text++) {
        count += *text == what;
    }
    return count;
}

/** Cut "name [unit]" into its two texts. */
static void split_head(char *head, char **name, char **unit)
{
    char *open = strstr(head, " [");
    char *close = open != NULL ? strchr(open, ']') : NULL;
    *name = head;
    *unit = head + strlen(head);
    if (close != NULL) {
        *open = '\0';
        *close = '\0';
        *unit = open + 2;
    }
}

/** Cut a line at its commas into at most `most` texts; how many there were. */
static size_t cut_line(char *line, char **cells, size_t most)
{
    size_t count = 0;
    for (char *rest = line; rest != NULL;) {
        char *cell = strsep(&rest, ",");
        if (count < most) {
            cells[count] = cell;
        }
        count++;
    }
    return count;
}

static bool cut_rows(clod_table *self, const char *path, char *rest, clod_status *status)
{
    size_t line_number = 1;
    char *line;
    while ((line = strsep(&rest, "\n")) != NULL && rest != NULL) {
        line_number++;
        const size_t found =
            cut_line(line, self->cells + self->rows * self->columns, self->columns);
        if (found != self->columns) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "%s:%zu: %zu cells, but the header has %zu columns.", path,
                                    line_number, found, self->columns);
        }
        self->rows++;
    }
    return true;
}

bool clod_table_parse(clod_table *self, const char *path, const char *text, size_t length,
                      clod_status *status)
{
    *self = (clod_table){.bytes = clod_memory_alloc(length + 1, 1)};
    if (self->bytes == NULL) {
        return fail_memory(status);
    }
    memcpy(self->bytes, text, length);
    const size_t lines = count_of(self->bytes, '\n');
    char *rest = self->bytes;
    char *head = strsep(&rest, "\n");
    if (rest == NULL) {
        return true; // no complete line yet
    }
    const size_t columns = count_of(head, ',') + 1;
    self->names = clod_memory_alloc(columns, sizeof *self->names);
    self->units = clod_memory_alloc(columns, sizeof *self->units);
    self->cells = clod_memory_alloc(lines * columns, sizeof *self->cells);
    if (self->names == NULL || self->units == NULL || self->cells == NULL) {
        return fail_memory(status);
    }
    self->columns = cut_line(head, self->names, columns);
    for (size_t c = 0; c < columns; c++) {
        split_head(self->names[c], &self->names[c], &self->units[c]);
    }
    return cut_rows(self, path, rest, status);
}

bool clod_table_read(clod_table *self, const char *folder, const char *name,
                     clod_status *status)
{
    *self = (clod_table){0};
    const size_t room = strlen(folder) + strlen(name) + 2;
    char *path = clod_memory_alloc(room, 1);
    if (path == NULL) {
        return fail_memory(status);
    }
    snprintf(path, room, "%s/%s", folder, name);
    void *bytes;
    size_t size;
    const int error = clod_file_load(AT_FDCWD, path, &bytes, &size);
    bool good = error == ENOENT;
    if (error == 0) {
        good = clod_table_parse(self, path, bytes, size, status);
        clod_memory_free(bytes);
    } else if (!good) {
        clod_file_fail(status, "read", path, error);
    }
    clod_memory_free(path);
    return good;
}

int clod_table_find(const clod_table *self, const char *name)
{
    for (size_t c = 0; c < self->columns; c++) {
        if (strcmp(self->names[c], name) == 0) {
            return (int)c;
        }
    }
    return -1;
}

double *clod_table_numbers(const clod_table *self, int column)
{
    double *number = clod_memory_alloc(self->rows > 0 ? self->rows : 1, sizeof *number);
    for (size_t r = 0; number != NULL && r < self->rows; r++) {
        const char *cell = self->cells[r * self->columns + (size_t)column];
        char *end;
        number[r] = strtod(cell, &end);
        number[r] = end == cell || *end != '\0' ? (double)NAN : number[r];
    }
    return number;
}

void clod_table_fini(clod_table *self)
{
    clod_memory_free(self->cells);
    clod_memory_free(self->units);
    clod_memory_free(self->names);
    clod_memory_free(self->bytes);
    *self = (clod_table){0};
}
