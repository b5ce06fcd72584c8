#include "picture/vtkhdf.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"

#define MOST_ROWS 2000000000u ///< of a file that makes sense

static const char *const GROUPS[] = {"VTKHDF/PointData", "VTKHDF/CellData"};

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

/** Rows and components of a dataset of one or two dimensions; false: it is no such. */
static bool measure(hid_t file, const char *name, size_t *rows, size_t *components)
{
    hsize_t size[2] = {0, 1};
    const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
    if (dataset < 0) {
        return false;
    }
    const hid_t space = H5Dget_space(dataset);
    const hid_t type = H5Dget_type(dataset);
    const H5T_class_t kind = H5Tget_class(type);
    const int rank = H5Sget_simple_extent_ndims(space);
    const bool good = (rank == 1 || rank == 2) && (kind == H5T_INTEGER || kind == H5T_FLOAT) &&
                      H5Sget_simple_extent_dims(space, size, NULL) == rank &&
                      size[0] <= MOST_ROWS && size[1] > 0 && size[1] <= 16;
    H5Tclose(type);
    H5Sclose(space);
    H5Dclose(dataset);
    *rows = (size_t)size[0];
    *components = (size_t)size[1];
    return good;
}

/** The text attribute "units" of an object; stays empty when there is none. */
static void read_units(hid_t file, const char *object, char units[32])
{
    units[0] = '\0';
    if (H5Aexists_by_name(file, object, "units", H5P_DEFAULT) <= 0) {
        return;
    }
    const hid_t attribute = H5Aopen_by_name(file, object, "units", H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    if (H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
        H5Tget_size(type) < 32) {
        memset(units, 0, 32);
        if (H5Aread(attribute, type, units) < 0) {
            units[0] = '\0';
        }
    }
    H5Tclose(type);
    H5Aclose(attribute);
}

/** List the columns of a group that have one row for each point or cell. */
static bool list_columns(clod_vtkhdf *self, clod_vtkhdf_place place, clod_status *status)
{
    H5G_info_t info;
    if (H5Lexists(self->file, GROUPS[place], H5P_DEFAULT) <= 0 ||
        H5Gget_info_by_name(self->file, GROUPS[place], &info, H5P_DEFAULT) < 0) {
        return true; // a file without such columns
    }
    self->columns[place] = clod_memory_alloc((size_t)info.nlinks + 1, sizeof **self->columns);
    if (self->columns[place] == NULL) {
        return fail_memory(self, status);
    }
    for (hsize_t k = 0; k < info.nlinks; k++) {
        clod_vtkhdf_column column;
        char path[128];
        size_t rows;
        const ssize_t length =
            H5Lget_name_by_idx(self->file, GROUPS[place], H5_INDEX_NAME, H5_ITER_INC, k,
                               column.name, sizeof column.name, H5P_DEFAULT);
        snprintf(path, sizeof path, "%s/%s", GROUPS[place], column.name);
        if (length > 0 && (size_t)length < sizeof column.name &&
            measure(self->file, path, &rows, &column.components) && rows == self->rows[place]) {
            read_units(self->file, path, column.units);
            self->columns[place][self->column_count[place]++] = column;
        }
    }
    return true;
}

static bool open_file(clod_vtkhdf *self, clod_status *status)
{
    size_t components;
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL); // what is wrong is told here
    if (access(self->path, R_OK) != 0) {
        return fail_damaged(self, "it is not there, or cannot be read", status);
    }
    self->file = H5Fopen(self->path, H5F_ACC_RDONLY, H5P_DEFAULT);
    if (self->file < 0) {
        return fail_damaged(self, "HDF5 cannot open it", status);
    }
    if (!measure(self->file, "VTKHDF/Points", &self->rows[CLOD_VTKHDF_POINTS], &components) ||
        components != 3 ||
        !measure(self->file, "VTKHDF/Types", &self->rows[CLOD_VTKHDF_CELLS], &components)) {
        return fail_damaged(self, "it has no points and cells of VTKHDF", status);
    }
    const hid_t time = H5Aopen_by_name(self->file, "/", "time_s", H5P_DEFAULT, H5P_DEFAULT);
    const bool timed = time >= 0 && H5Aread(time, H5T_NATIVE_DOUBLE, &self->time) >= 0;
    if (time >= 0) {
        H5Aclose(time);
    }
    if (!timed) {
        return fail_damaged(self, "it has no attribute time_s", status);
    }
    return list_columns(self, CLOD_VTKHDF_POINTS, status) &&
           list_columns(self, CLOD_VTKHDF_CELLS, status);
}

clod_vtkhdf *clod_vtkhdf_open(const char *path, clod_status *status)
{
    clod_vtkhdf *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL || (self->path = clod_memory_text(path)) == NULL) {
        clod_memory_free(self);
        clod_status_fail(status, CLOD_FAILED, "No memory to read %s.", path);
        return NULL;
    }
    self->file = -1;
    if (!open_file(self, status)) {
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

/** Owned numbers of a dataset of so many, or NULL. */
static void *read_numbers(const clod_vtkhdf *self, const char *name, size_t count, hid_t type,
                          clod_status *status)
{
    void *numbers = clod_memory_alloc(count + 1, H5Tget_size(type));
    if (numbers == NULL) {
        fail_memory(self, status);
        return NULL;
    }
    size_t rows, components;
    const hid_t dataset = H5Dopen2(self->file, name, H5P_DEFAULT);
    const bool good =
        dataset >= 0 && measure(self->file, name, &rows, &components) &&
        rows * components == count &&
        (count == 0 || H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers) >= 0);
    if (dataset >= 0) {
        H5Dclose(dataset);
    }
    if (!good) {
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
    return read_numbers(self, path, self->rows[place] * column->components, H5T_NATIVE_DOUBLE,
                        status);
}

double (*clod_vtkhdf_points(const clod_vtkhdf *self, clod_status *status))[3]
{
    return read_numbers(self, "VTKHDF/Points", 3 * self->rows[CLOD_VTKHDF_POINTS],
                        H5T_NATIVE_DOUBLE, status);
}

size_t (*clod_vtkhdf_triangles(const clod_vtkhdf *self, clod_status *status))[3]
{
    const size_t count = self->rows[CLOD_VTKHDF_CELLS];
    size_t *offset = read_numbers(self, "VTKHDF/Offsets", count + 1, H5T_NATIVE_ULONG, status);
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
    size_t *corner =
        read_numbers(self, "VTKHDF/Connectivity", 3 * count, H5T_NATIVE_ULONG, status);
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
    if ((*self)->file >= 0) {
        H5Fclose((*self)->file);
    }
    clod_memory_free((*self)->columns[CLOD_VTKHDF_POINTS]);
    clod_memory_free((*self)->columns[CLOD_VTKHDF_CELLS]);
    clod_memory_free((*self)->path);
    clod_memory_free(*self);
    *self = NULL;
}
