// Columns of numbers in an HDF5 file, written and read slab by slab.
#include <hdf5.h>
#include <string.h>

#include "base/memory.h"
#include "output/hdf.h"
#include "output/hdf_open.h"

static size_t type_size(clod_hdf_type type)
{
    static const size_t SIZES[] = {
        [CLOD_HDF_F64] = 8, [CLOD_HDF_I64] = 8, [CLOD_HDF_I32] = 4, [CLOD_HDF_U64] = 8,
        [CLOD_HDF_U16] = 2, [CLOD_HDF_U8] = 1,  [CLOD_HDF_TEXT] = 1};
    return SIZES[type];
}

hid_t clod_hdf_native(clod_hdf_type type)
{
    const hid_t native[] = {
        [CLOD_HDF_F64] = H5T_NATIVE_DOUBLE, [CLOD_HDF_I64] = H5T_NATIVE_INT64,
        [CLOD_HDF_I32] = H5T_NATIVE_INT32,  [CLOD_HDF_U64] = H5T_NATIVE_UINT64,
        [CLOD_HDF_U16] = H5T_NATIVE_UINT16, [CLOD_HDF_U8] = H5T_NATIVE_UINT8,
        [CLOD_HDF_TEXT] = H5T_C_S1};
    return native[type];
}

/** Owned type (H5Tclose) in memory. */
static hid_t memory_type(const clod_hdf_column *column)
{
    const hid_t type = H5Tcopy(clod_hdf_native(column->type));
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

size_t clod_hdf_row_size(const clod_hdf_column *column)
{
    return column->components * type_size(column->type);
}

/** Bytes up to which a dataset lies in its header, without chunks: most columns of walls. */
#define COMPACT 4096

/** Owned creation properties (H5Pclose) of a column's dataset. */
static hid_t dataset_properties(const clod_hdf *self, const clod_hdf_column *column)
{
    hsize_t chunk[2];
    const int rank = column_dimensions(column, chunk);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_obj_track_times(properties, false); // the same data give the same bytes
    if (self->storage == CLOD_HDF_EXACT &&
        column->rows * clod_hdf_row_size(column) <= COMPACT) {
        H5Pset_layout(properties, H5D_COMPACT);
    } else if (column->rows > 0) {
        chunk[0] = chunk[0] < CLOD_HDF_SLAB ? chunk[0] : CLOD_HDF_SLAB;
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

/** One slab of a column, on its way between memory and file. */
typedef struct slab {
    hid_t dataset;
    hid_t type; ///< of the numbers in memory
    const clod_hdf_column *column;
    char *packed; ///< the rows without the gaps between them
    size_t first; ///< row of the dataset that the column's first row is
} slab;

/** Move `count` rows of the column, from its row `at` on, between packed rows and file. */
static bool move_packed(const slab *self, size_t at, size_t count, bool write)
{
    hsize_t size[2];
    const int rank = column_dimensions(self->column, size);
    const hsize_t begin[2] = {self->first + at, 0};
    size[0] = count;
    const hid_t here = H5Screate_simple(rank, size, NULL);
    const hid_t there = H5Dget_space(self->dataset);
    bool good = H5Sselect_hyperslab(there, H5S_SELECT_SET, begin, NULL, size, NULL) >= 0;
    if (good && write) {
        good = H5Dwrite(self->dataset, self->type, here, there, H5P_DEFAULT, self->packed) >= 0;
    } else if (good) {
        good = H5Dread(self->dataset, self->type, here, there, H5P_DEFAULT, self->packed) >= 0;
    }
    H5Sclose(there);
    H5Sclose(here);
    return good;
}

void clod_hdf_pack(const clod_hdf_column *column, size_t at, size_t count, char *packed)
{
    const size_t row = clod_hdf_row_size(column);
    for (size_t r = 0; r < count; r++) {
        memcpy(packed + r * row, (const char *)column->data + (at + r) * column->stride, row);
    }
}

static bool write_slab(const slab *self, size_t at, size_t count)
{
    clod_hdf_pack(self->column, at, count, self->packed);
    return move_packed(self, at, count, true);
}

static bool read_slab(const slab *self, size_t at, size_t count)
{
    const clod_hdf_column *column = self->column;
    const size_t row = clod_hdf_row_size(column);
    if (!move_packed(self, at, count, false)) {
        return false;
    }
    char *data;
    memcpy(&data, &column->data, sizeof data); // a column to read into is not const
    for (size_t r = 0; r < count; r++) {
        memcpy(data + (at + r) * column->stride, self->packed + r * row, row);
    }
    return true;
}

/** All rows of a column, to or from rows of an open dataset. */
static bool move_rows(clod_hdf *self, hid_t dataset, const clod_hdf_column *column,
                      size_t first, bool write)
{
    const size_t rows = column->rows;
    const size_t most = rows < CLOD_HDF_SLAB ? rows : CLOD_HDF_SLAB;
    char *packed = clod_hdf_take_memory(self, most, clod_hdf_row_size(column));
    const slab all = {dataset, memory_type(column), column, packed, first};
    bool good = packed != NULL;
    for (size_t at = 0; good && at < rows; at += most) {
        const size_t count = rows - at < most ? rows - at : most;
        good = write ? write_slab(&all, at, count) : read_slab(&all, at, count);
    }
    H5Tclose(all.type);
    clod_memory_free(packed);
    return good;
}

/** Owned creation properties (H5Pclose) of a dataset in one piece, which has its place at once. */
static hid_t reserved_properties(void)
{
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_obj_track_times(properties, false);
    H5Pset_layout(properties, H5D_CONTIGUOUS);
    H5Pset_alloc_time(properties, H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER);
    return properties;
}

/** Owned dataset (H5Dclose) for a column, without data; `properties` are closed. */
static hid_t make_dataset_with(clod_hdf *self, const clod_hdf_column *column, hid_t properties)
{
    hsize_t dimensions[2];
    const int rank = column_dimensions(column, dimensions);
    const hid_t space = H5Screate_simple(rank, dimensions, NULL);
    const hid_t in_file = file_type(self, column);
    const hid_t links = clod_hdf_links();
    const hid_t dataset =
        H5Dcreate2(self->file, column->name, in_file, space, links, properties, H5P_DEFAULT);
    H5Pclose(links);
    H5Pclose(properties);
    H5Tclose(in_file);
    H5Sclose(space);
    return dataset;
}

static hid_t make_dataset(clod_hdf *self, const clod_hdf_column *column)
{
    return make_dataset_with(self, column, dataset_properties(self, column));
}

/** Close a dataset that was written to, and note what went wrong. */
static void end_writing(clod_hdf *self, hid_t dataset, const char *name, bool good)
{
    good = (dataset < 0 || H5Dclose(dataset) >= 0) && good;
    if (!good) {
        clod_hdf_keep_error(self, "write", name);
    }
}

static void put_units(clod_hdf *self, const clod_hdf_column *column)
{
    if (column->units != NULL && !clod_hdf_has_failed(self)) {
        clod_hdf_put_text(self, column->name, "units", column->units);
    }
}

void clod_hdf_make(clod_hdf *self, const clod_hdf_column *column)
{
    if (clod_hdf_has_failed(self)) {
        return;
    }
    const hid_t dataset = make_dataset(self, column);
    end_writing(self, dataset, column->name, dataset >= 0);
    put_units(self, column);
}

void clod_hdf_reserve(clod_hdf *self, const clod_hdf_column *column, uint64_t *place)
{
    *place = 0;
    if (clod_hdf_has_failed(self)) {
        return;
    }
    const hid_t dataset = make_dataset_with(
        self, column,
        column->rows > 0 ? reserved_properties() : dataset_properties(self, column));
    const haddr_t at = dataset >= 0 && column->rows > 0 ? H5Dget_offset(dataset) : 0;
    *place = at;
    end_writing(self, dataset, column->name, dataset >= 0 && at != HADDR_UNDEF);
    put_units(self, column);
}

void clod_hdf_put_rows(clod_hdf *self, const clod_hdf_column *column, size_t first)
{
    if (clod_hdf_has_failed(self)) {
        return;
    }
    const hid_t dataset = H5Dopen2(self->file, column->name, H5P_DEFAULT);
    const bool good = dataset >= 0 && move_rows(self, dataset, column, first, true);
    end_writing(self, dataset, column->name, good);
}

void clod_hdf_put(clod_hdf *self, const clod_hdf_column *column)
{
    if (clod_hdf_has_failed(self)) {
        return;
    }
    const hid_t dataset = make_dataset(self, column);
    const bool good = dataset >= 0 && move_rows(self, dataset, column, 0, true);
    end_writing(self, dataset, column->name, good);
    put_units(self, column);
}

size_t clod_hdf_rows(clod_hdf *self, const char *name)
{
    if (clod_hdf_has_failed(self)) {
        return 0;
    }
    const hid_t dataset = H5Dopen2(self->file, name, H5P_DEFAULT);
    if (dataset < 0) {
        if (self->no_memory) { // else there is none
            clod_hdf_keep_error(self, "open", name);
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

/** Whether the dataset has `total` rows, and the column's other dimension, and its type but for
 * the byte order. */
static bool dataset_matches(hid_t dataset, const clod_hdf_column *column, size_t total)
{
    hsize_t wanted[2], found[2];
    const int rank = column_dimensions(column, wanted);
    const hid_t space = H5Dget_space(dataset);
    const hid_t type = H5Dget_type(dataset);
    const hid_t in_memory = memory_type(column);
    const bool matches = H5Sget_simple_extent_ndims(space) == rank &&
                         H5Sget_simple_extent_dims(space, found, NULL) == rank &&
                         found[0] == total && (rank == 1 || found[1] == wanted[1]) &&
                         H5Tget_class(type) == H5Tget_class(in_memory) &&
                         H5Tget_size(type) == H5Tget_size(in_memory);
    H5Tclose(in_memory);
    H5Tclose(type);
    H5Sclose(space);
    return matches;
}

void clod_hdf_get_rows(clod_hdf *self, const clod_hdf_column *column, size_t first,
                       size_t total)
{
    if (clod_hdf_has_failed(self)) {
        return;
    }
    const hid_t dataset = H5Dopen2(self->file, column->name, H5P_DEFAULT);
    if (dataset < 0 || !dataset_matches(dataset, column, total) ||
        !move_rows(self, dataset, column, first, false)) {
        clod_hdf_keep_error(self, "read (not there, or of another size)", column->name);
    }
    if (dataset >= 0) {
        H5Dclose(dataset);
    }
}

void clod_hdf_get(clod_hdf *self, const clod_hdf_column *column)
{
    clod_hdf_get_rows(self, column, 0, column->rows);
}
