#include "picture/vtkhdf.h"

#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/memory.h"
#include "output/file.h"
#include "output/folder_files.h"
#include "output/hdf_look.h"
#include "output/vtk_cells.h"

static const char *const GROUPS[] = {VTK_POINT_DATA, VTK_CELL_DATA};

static bool fail_damaged(const clod_vtkhdf *self, const char *what, clod_status *status)
{
    return clod_status_fail(status, CLOD_USAGE,
                            "%s: %s. The file is damaged or no snapshot of clod; take another "
                            "time, or remove its entry from the .hdf.series file.",
                            self->path, what);
}

static bool fail_memory(const clod_vtkhdf *self, clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "No memory to read %s.", self->path);
}

/** List the columns of a group that have one row for each point or cell. */
static bool list_columns(clod_vtkhdf *self, clod_vtkhdf_place place, clod_status *status)
{
    const size_t members = clod_hdf_members(self->hdf, GROUPS[place]);
    self->columns[place] = clod_memory_alloc(members + 1, sizeof **self->columns);
    if (self->columns[place] == NULL) {
        return fail_memory(self, status);
    }
    for (size_t k = 0; k < members; k++) {
        clod_vtkhdf_column column;
        char path[128];
        size_t rows;
        if (!clod_hdf_member(self->hdf, GROUPS[place], k, column.name, sizeof column.name)) {
            continue;
        }
        snprintf(path, sizeof path, "%s/%s", GROUPS[place], column.name);
        if (clod_hdf_size(self->hdf, path, &rows, &column.components) &&
            rows == self->rows[place]) {
            clod_hdf_get_text(self->hdf, path, "units", column.units, sizeof column.units);
            self->columns[place][self->column_count[place]++] = column;
        }
    }
    return true;
}

/** Open the file in its folder; `name` is that of the file alone. */
static bool open_hdf(clod_vtkhdf *self, const char *name, clod_status *status)
{
    struct stat found;
    clod_status unused;
    self->descriptor = clod_folder_open_file(self->folder, name, O_RDONLY, &unused);
    if (self->descriptor < 0 || fstat(self->descriptor, &found) != 0) {
        return fail_damaged(self, "it is not there, or cannot be read", status);
    }
    const clod_hdf_place place = {self->folder, name, self->descriptor, 0};
    self->hdf = clod_hdf_open(&place, (uint64_t)found.st_size, &unused);
    return self->hdf != NULL || fail_damaged(self, "HDF5 cannot open it", status);
}

static bool look_inside(clod_vtkhdf *self, clod_status *status)
{
    size_t components;
    if (!clod_hdf_size(self->hdf, VTK_POINTS, &self->rows[CLOD_VTKHDF_POINTS], &components) ||
        components != 3 ||
        !clod_hdf_size(self->hdf, VTK_TYPES, &self->rows[CLOD_VTKHDF_CELLS], &components)) {
        return fail_damaged(self, "it has no points and cells of VTKHDF", status);
    }
    if (!clod_hdf_get_real(self->hdf, "/", VTK_TIME, &self->time)) {
        return fail_damaged(self, "it has no attribute " VTK_TIME, status);
    }
    return list_columns(self, CLOD_VTKHDF_POINTS, status) &&
           list_columns(self, CLOD_VTKHDF_CELLS, status);
}

clod_vtkhdf *clod_vtkhdf_open(const char *path, clod_status *status)
{
    clod_vtkhdf *self = clod_memory_alloc(1, sizeof *self);
    char *folder = clod_memory_text(path);
    if (self == NULL || folder == NULL || (self->path = clod_memory_text(path)) == NULL) {
        clod_memory_free(self);
        clod_memory_free(folder);
        clod_status_fail(status, CLOD_FAILED, "No memory to read %s.", path);
        return NULL;
    }
    self->descriptor = -1;
    char *slash = strrchr(folder, '/');
    const char *name = slash != NULL ? self->path + (slash + 1 - folder) : self->path;
    if (slash != NULL) {
        slash[slash == folder ? 1 : 0] = '\0';
    }
    self->folder = clod_folder_look(slash != NULL ? folder : ".", status);
    clod_memory_free(folder);
    if (self->folder == NULL || !open_hdf(self, name, status) || !look_inside(self, status)) {
        clod_vtkhdf_close(&self);
    }
    return self;
}

const clod_vtkhdf_column *clod_vtkhdf_find(const clod_vtkhdf *self, clod_vtkhdf_place place,
                                           const char *name)
{
    for (size_t k = 0; k < self->column_count[place]; k++) {
        if (strcmp(self->columns[place][k].name, name) == 0) {
            return &self->columns[place][k];
        }
    }
    return NULL;
}

/** Owned numbers of a dataset of so many, each of 8 bytes; or NULL. */
static void *read_numbers(const clod_vtkhdf *self, const char *name, size_t count,
                          clod_hdf_type type, clod_status *status)
{
    void *numbers = clod_memory_alloc(count + 1, 8);
    if (numbers == NULL) {
        fail_memory(self, status);
        return NULL;
    }
    if (!clod_hdf_read(self->hdf, name, type, count, numbers)) {
        char text[160];
        snprintf(text, sizeof text, "%s cannot be read", name);
        fail_damaged(self, text, status);
        clod_memory_free(numbers);
        return NULL;
    }
    return numbers;
}

double *clod_vtkhdf_read(const clod_vtkhdf *self, clod_vtkhdf_place place,
                         const clod_vtkhdf_column *column, clod_status *status)
{
    char path[128];
    snprintf(path, sizeof path, "%s/%s", GROUPS[place], column->name);
    return read_numbers(self, path, self->rows[place] * column->components, CLOD_HDF_F64,
                        status);
}

double (*clod_vtkhdf_points(const clod_vtkhdf *self, clod_status *status))[3]
{
    return read_numbers(self, VTK_POINTS, 3 * self->rows[CLOD_VTKHDF_POINTS], CLOD_HDF_F64,
                        status);
}

size_t (*clod_vtkhdf_triangles(const clod_vtkhdf *self, clod_status *status))[3]
{
    const size_t count = self->rows[CLOD_VTKHDF_CELLS];
    size_t *offset = read_numbers(self, VTK_OFFSETS, count + 1, CLOD_HDF_U64, status);
    if (offset == NULL) {
        return NULL;
    }
    bool good = true;
    for (size_t c = 0; c <= count; c++) {
        good = good && offset[c] == 3 * c;
    }
    clod_memory_free(offset);
    if (!good) {
        fail_damaged(self, "its cells are not triangles", status);
        return NULL;
    }
    size_t *corner = read_numbers(self, VTK_CONNECTIVITY, 3 * count, CLOD_HDF_U64, status);
    for (size_t k = 0; corner != NULL && k < 3 * count; k++) {
        good = good && corner[k] < self->rows[CLOD_VTKHDF_POINTS];
    }
    if (!good) {
        fail_damaged(self, "a triangle has a corner that is not there", status);
        clod_memory_free(corner);
        return NULL;
    }
    return (size_t(*)[3])corner;
}

void clod_vtkhdf_close(clod_vtkhdf **self)
{
    if (*self == NULL) {
        return;
    }
    if ((*self)->hdf != NULL) {
        clod_status unused; // whatever failed was told where it did
        clod_hdf_end_reading(&(*self)->hdf, &unused);
    }
    if ((*self)->descriptor >= 0) {
        clod_file_close((*self)->descriptor);
    }
    clod_folder_close(&(*self)->folder);
    clod_memory_free((*self)->columns[CLOD_VTKHDF_POINTS]);
    clod_memory_free((*self)->columns[CLOD_VTKHDF_CELLS]);
    clod_memory_free((*self)->path);
    clod_memory_free(*self);
    *self = NULL;
}

bool clod_vtkhdf_parts(const clod_vtkhdf *self, char *names)
{
    memset(names, 0, CLOD_VTKHDF_PARTS);
    return clod_vtkhdf_find(self, CLOD_VTKHDF_CELLS, "part") != NULL &&
           clod_hdf_get_text(self->hdf, VTK_PARTS, VTK_PARTS_NAMES, names, CLOD_VTKHDF_PARTS) &&
           names[0] != '\0';
}
