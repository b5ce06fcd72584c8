#include "output/hdf.h"

#include <hdf5.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"

#define CHUNK_ROWS 65536

struct clod_hdf {
    hid_t file;
    clod_hdf_storage storage;
    char error[256]; ///< empty: none so far
    bool no_memory;  ///< that is why
    H5E_auto2_t printer;
    void *printer_data;
};

/** HDF5 has state of its own for the whole process; not every build of it is thread-safe. */
static pthread_mutex_t library = PTHREAD_MUTEX_INITIALIZER;
static bool begun; ///< a file was made or opened; of whoever has the lock

static void keep_error(clod_hdf *self, const char *action, const char *name)
{
    if (self->error[0] == '\0') {
        snprintf(self->error, sizeof self->error, "HDF5 cannot %s %s", action, name);
    }
}

/** Memory for a column; without it that is what the first error says. */
static void *take_memory(clod_hdf *self, size_t count, size_t size)
{
    void *memory = clod_memory_alloc(count, size);
    self->no_memory = self->no_memory || memory == NULL;
    return memory;
}

static herr_t look_for_memory(unsigned number, const H5E_error2_t *error, void *self)
{
    (void)number;
    if (error->maj_num == H5E_RESOURCE) {
        ((clod_hdf *)self)->no_memory = true;
    }
    return 0;
}

/** Called by HDF5 for each of its errors, in place of printing it. */
static herr_t on_error(hid_t stack, void *self)
{
    return H5Ewalk2(stack, H5E_WALK_UPWARD, look_for_memory, self);
}

static clod_hdf *acquire(clod_status *status)
{
    clod_hdf *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "There is no memory for an HDF5 file.");
        return NULL;
    }
    pthread_mutex_lock(&library);
    if (!begun) {
        H5dont_atexit(); // its exit handler would run after a failure within the library, too
        begun = true;
    }
    H5Eget_auto2(H5E_DEFAULT, &self->printer, &self->printer_data);
    H5Eset_auto2(H5E_DEFAULT, on_error, self);
    return self;
}

/** Give the library back and free; false with the kept error. */
static bool release(clod_hdf **self, clod_status *status)
{
    clod_hdf *hdf = *self;
    *self = NULL;
    if (hdf->file >= 0 && H5Fclose(hdf->file) < 0) {
        keep_error(hdf, "close", "the file in memory");
    }
    H5Eset_auto2(H5E_DEFAULT, hdf->printer, hdf->printer_data);
    pthread_mutex_unlock(&library);
    const bool good = hdf->error[0] == '\0';
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "%s%s.", hdf->error,
                         hdf->no_memory ? ": there is no memory for it" : "");
    }
    clod_memory_free(hdf);
    return good;
}

/**
 * File access in memory only. The earliest format is readable everywhere, and in HDF5 1.10.8
 * the only one whose H5Fget_file_image can be opened again: in the later ones it clears a flag
 * that the checksum of the superblock covers.
 */
static hid_t memory_access(void)
{
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fapl_core(access, 1 << 20, false);
    H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V110);
    return access;
}

clod_hdf *clod_hdf_create(clod_hdf_storage storage, clod_status *status)
{
    clod_hdf *self = acquire(status);
    if (self == NULL) {
        return NULL;
    }
    self->storage = storage;
    const hid_t access = memory_access();
    self->file = H5Fcreate("clod-in-memory", H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    if (self->file < 0) {
        keep_error(self, "create", "a file in memory");
        release(&self, status);
    }
    return self;
}

clod_hdf *clod_hdf_open(const void *image, size_t size, clod_status *status)
{
    clod_hdf *self = acquire(status);
    if (self == NULL) {
        return NULL;
    }
    const hid_t access = memory_access();
    void *borrowed;
    memcpy(&borrowed, &image, sizeof borrowed); // HDF5 copies the bytes but asks for non-const
    self->file = H5Pset_file_image(access, borrowed, size) < 0
                     ? -1
                     : H5Fopen("clod-in-memory", H5F_ACC_RDONLY, access);
    H5Pclose(access);
    if (self->file < 0) {
        keep_error(self, "open", "the file in memory");
        release(&self, status);
    }
    return self;
}

static size_t type_size(clod_hdf_type type)
{
    static const size_t SIZES[] = {
        [CLOD_HDF_F64] = 8, [CLOD_HDF_I64] = 8, [CLOD_HDF_I32] = 4, [CLOD_HDF_U64] = 8,
        [CLOD_HDF_U16] = 2, [CLOD_HDF_U8] = 1,  [CLOD_HDF_TEXT] = 1};
    return SIZES[type];
}

/** Owned type (H5Tclose) in memory. */
static hid_t memory_type(const clod_hdf_column *column)
{
    const hid_t native[] = {
        [CLOD_HDF_F64] = H5T_NATIVE_DOUBLE, [CLOD_HDF_I64] = H5T_NATIVE_INT64,
        [CLOD_HDF_I32] = H5T_NATIVE_INT32,  [CLOD_HDF_U64] = H5T_NATIVE_UINT64,
        [CLOD_HDF_U16] = H5T_NATIVE_UINT16, [CLOD_HDF_U8] = H5T_NATIVE_UINT8,
        [CLOD_HDF_TEXT] = H5T_C_S1};
    const hid_t type = H5Tcopy(native[column->type]);
    if (column->type == CLOD_HDF_TEXT) {
        H5Tset_size(type, column->components);
        H5Tset_strpad(type, H5T_STR_NULLPAD);
    }
    return type;
}

/** Owned type (H5Tclose) in the file: little-endian. */
static hid_t file_type(const clod_hdf *self, const clod_hdf_column *column)
{
    if (column->type == CLOD_HDF_F64 && self->storage == CLOD_HDF_PICTURE) {
        return H5Tcopy(H5T_IEEE_F32LE);
    }
    const hid_t type = memory_type(column);
    if (column->type != CLOD_HDF_TEXT) {
        H5Tset_order(type, H5T_ORDER_LE);
    }
    return type;
}

/** Dimensions of a column's dataset; returns their number. */
static int column_dimensions(const clod_hdf_column *column, hsize_t dimensions[2])
{
    dimensions[0] = column->rows;
    dimensions[1] = column->components;
    return column->components == 1 || column->type == CLOD_HDF_TEXT ? 1 : 2;
}

/** Owned copy (clod_memory_free) of the rows without the gaps between them. */
static void *pack_rows(clod_hdf *self, const clod_hdf_column *column)
{
    const size_t row = column->components * type_size(column->type);
    char *packed = take_memory(self, column->rows, row);
    for (size_t r = 0; packed != NULL && r < column->rows; r++) {
        memcpy(packed + r * row, (const char *)column->data + r * column->stride, row);
    }
    return packed;
}

/** Owned creation properties (H5Pclose) of a column's dataset. */
static hid_t dataset_properties(const clod_hdf *self, const clod_hdf_column *column)
{
    hsize_t chunk[2];
    const int rank = column_dimensions(column, chunk);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_obj_track_times(properties, false); // the same data give the same bytes
    if (column->rows > 0) {
        chunk[0] = chunk[0] < CHUNK_ROWS ? chunk[0] : CHUNK_ROWS;
        H5Pset_chunk(properties, rank, chunk);
        if (self->storage == CLOD_HDF_PICTURE) {
            H5Pset_shuffle(properties);
            H5Pset_deflate(properties, 1);
        } else {
            H5Pset_fletcher32(properties);
        }
    }
    return properties;
}

/** Owned link properties (H5Pclose) that make the groups above an object. */
static hid_t link_properties(void)
{
    const hid_t links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    return links;
}

void clod_hdf_group(clod_hdf *self, const char *name)
{
    if (self->error[0] != '\0') {
        return;
    }
    const hid_t links = link_properties();
    const hid_t group = H5Gcreate2(self->file, name, links, H5P_DEFAULT, H5P_DEFAULT);
    H5Pclose(links);
    if (group < 0 || H5Gclose(group) < 0) {
        keep_error(self, "make the group", name);
    }
}

void clod_hdf_put(clod_hdf *self, const clod_hdf_column *column)
{
    if (self->error[0] != '\0') {
        return;
    }
    hsize_t dimensions[2];
    const int rank = column_dimensions(column, dimensions);
    const hid_t space = H5Screate_simple(rank, dimensions, NULL);
    const hid_t in_memory = memory_type(column);
    const hid_t in_file = file_type(self, column);
    const hid_t properties = dataset_properties(self, column);
    const hid_t links = link_properties();
    const hid_t dataset =
        H5Dcreate2(self->file, column->name, in_file, space, links, properties, H5P_DEFAULT);
    void *packed = pack_rows(self, column);
    bool good = dataset >= 0 && packed != NULL;
    if (good && column->rows > 0) {
        good = H5Dwrite(dataset, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, packed) >= 0;
    }
    clod_memory_free(packed);
    good = (dataset < 0 || H5Dclose(dataset) >= 0) && good;
    H5Pclose(links);
    H5Pclose(properties);
    H5Tclose(in_file);
    H5Tclose(in_memory);
    H5Sclose(space);
    if (!good) {
        keep_error(self, "write", column->name);
    } else if (column->units != NULL) {
        clod_hdf_put_text(self, column->name, "units", column->units);
    }
}

/** Attach a value with the given type and dimensions. */
static void put_attribute(clod_hdf *self, const char *object, const char *name, hid_t in_file,
                          hid_t in_memory, hid_t space, const void *value)
{
    const hid_t attribute = H5Acreate_by_name(self->file, object, name, in_file, space,
                                              H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    bool good = attribute >= 0 && H5Awrite(attribute, in_memory, value) >= 0;
    good = (attribute < 0 || H5Aclose(attribute) >= 0) && good;
    if (!good) {
        keep_error(self, "write the attribute", name);
    }
}

void clod_hdf_put_ints(clod_hdf *self, const char *object, const char *name,
                       const int64_t *values, size_t count)
{
    if (self->error[0] != '\0') {
        return;
    }
    const hsize_t dimension = count;
    const hid_t space = H5Screate_simple(1, &dimension, NULL);
    put_attribute(self, object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, space, values);
    H5Sclose(space);
}

void clod_hdf_put_real(clod_hdf *self, const char *object, const char *name, double value)
{
    if (self->error[0] != '\0') {
        return;
    }
    const hid_t space = H5Screate(H5S_SCALAR);
    put_attribute(self, object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space, &value);
    H5Sclose(space);
}

void clod_hdf_put_text(clod_hdf *self, const char *object, const char *name, const char *value)
{
    if (self->error[0] != '\0') {
        return;
    }
    const size_t length = strlen(value);
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t type = H5Tcopy(H5T_C_S1); // fixed length, ASCII: what VTKHDF asks for
    H5Tset_size(type, length > 0 ? length : 1);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    put_attribute(self, object, name, type, type, space, value);
    H5Tclose(type);
    H5Sclose(space);
}

bool clod_hdf_finish(clod_hdf **self, void **image, size_t *size, clod_status *status)
{
    clod_hdf *hdf = *self;
    *image = NULL;
    *size = 0;
    if (hdf->error[0] == '\0') {
        const ssize_t needed = H5Fflush(hdf->file, H5F_SCOPE_GLOBAL) < 0
                                   ? -1
                                   : H5Fget_file_image(hdf->file, NULL, 0);
        *image = needed > 0 ? take_memory(hdf, (size_t)needed, 1) : NULL;
        *size = needed > 0 ? (size_t)needed : 0;
        if (*image == NULL || H5Fget_file_image(hdf->file, *image, *size) != needed) {
            keep_error(hdf, "copy", "the file in memory");
        }
    }
    if (!release(self, status)) {
        clod_memory_free(*image);
        *image = NULL;
        return false;
    }
    return true;
}

size_t clod_hdf_rows(clod_hdf *self, const char *name)
{
    if (self->error[0] != '\0') {
        return 0;
    }
    const hid_t dataset = H5Dopen2(self->file, name, H5P_DEFAULT);
    if (dataset < 0) {
        if (self->no_memory) { // else there is none
            keep_error(self, "open", name);
        }
        return 0;
    }
    hsize_t dimensions[2] = {0, 0};
    const hid_t space = H5Dget_space(dataset);
    if (H5Sget_simple_extent_ndims(space) <= 2) {
        H5Sget_simple_extent_dims(space, dimensions, NULL);
    }
    H5Sclose(space);
    H5Dclose(dataset);
    return (size_t)dimensions[0];
}

/** Whether the dataset has the column's dimensions, and its type but for the byte order. */
static bool dataset_matches(hid_t dataset, const clod_hdf_column *column)
{
    hsize_t wanted[2], found[2];
    const int rank = column_dimensions(column, wanted);
    const hid_t space = H5Dget_space(dataset);
    const hid_t type = H5Dget_type(dataset);
    const hid_t in_memory = memory_type(column);
    const bool matches = H5Sget_simple_extent_ndims(space) == rank &&
                         H5Sget_simple_extent_dims(space, found, NULL) == rank &&
                         found[0] == wanted[0] && (rank == 1 || found[1] == wanted[1]) &&
                         H5Tget_class(type) == H5Tget_class(in_memory) &&
                         H5Tget_size(type) == H5Tget_size(in_memory);
    H5Tclose(in_memory);
    H5Tclose(type);
    H5Sclose(space);
    return matches;
}

void clod_hdf_get(clod_hdf *self, const clod_hdf_column *column)
{
    if (self->error[0] != '\0') {
        return;
    }
    const size_t row = column->components * type_size(column->type);
    const hid_t dataset = H5Dopen2(self->file, column->name, H5P_DEFAULT);
    char *packed = take_memory(self, column->rows, row);
    bool good = dataset >= 0 && packed != NULL && dataset_matches(dataset, column);
    if (good && column->rows > 0) {
        const hid_t type = memory_type(column);
        good = H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, packed) >= 0;
        H5Tclose(type);
    }
    if (good) {
        char *data;
        memcpy(&data, &column->data, sizeof data); // a column to read into is not const
        for (size_t r = 0; r < column->rows; r++) {
            memcpy(data + r * column->stride, packed + r * row, row);
        }
    } else {
        keep_error(self, "read (not there, or of another size)", column->name);
    }
    clod_memory_free(packed);
    if (dataset >= 0) {
        H5Dclose(dataset);
    }
}

bool clod_hdf_lacks_memory(const clod_hdf *self)
{
    return self->no_memory;
}

bool clod_hdf_end_reading(clod_hdf **self, clod_status *status)
{
    return release(self, status);
}
