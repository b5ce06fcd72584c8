#pragma once
/**
 * @file vtk_file.h
 * Files of VTKHDF 1.0 read back, and held against the rules of an UnstructuredGrid.
 */

#include <hdf5.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "temp_folder.h"

static inline hid_t open_file(void **folder, const char *name)
{
    char path[PATH_MAX];
    const hid_t file = H5Fopen(temp_path(path, folder, name), H5F_ACC_RDONLY, H5P_DEFAULT);
    assert_true(file >= 0);
    return file;
}

/** Read a dataset after checking its class, size in the file and dimensions (0: none). */
static inline void read_array(hid_t file, const char *name, H5T_class_t class, size_t bytes,
                              hsize_t rows, hsize_t columns, hid_t memory, void *data)
{
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
    assert_true(set >= 0);
    const hid_t type = H5Dget_type(set);
    const hid_t space = H5Dget_space(set);
    hsize_t found[2] = {0, 0};
    assert_int_equal(H5Tget_class(type), class);
    assert_int_equal(H5Tget_size(type), bytes);
    assert_int_equal(H5Sget_simple_extent_ndims(space), columns == 0 ? 1 : 2);
    H5Sget_simple_extent_dims(space, found, NULL);
    assert_int_equal(found[0], rows);
    assert_int_equal(found[1], columns);
    if (rows > 0) {
        assert_true(H5Dread(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
    }
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(set);
}

static inline void read_reals(hid_t file, const char *name, hsize_t rows, hsize_t columns,
                              float *data)
{
    read_array(file, name, H5T_FLOAT, 4, rows, columns, H5T_NATIVE_FLOAT, data);
}

static inline void read_longs(hid_t file, const char *name, hsize_t rows, int64_t *data)
{
    read_array(file, name, H5T_INTEGER, 8, rows, 0, H5T_NATIVE_INT64, data);
}

/** The group's Version [1, 0], and its Type, a scalar ASCII string of fixed length. */
static inline void check_head(hid_t file)
{
    int64_t version[2];
    const hid_t group = H5Gopen2(file, "VTKHDF", H5P_DEFAULT);
    assert_true(group >= 0);
    hid_t attribute = H5Aopen(group, "Version", H5P_DEFAULT);
    hid_t space = H5Aget_space(attribute);
    assert_int_equal(H5Sget_simple_extent_npoints(space), 2);
    H5Aread(attribute, H5T_NATIVE_INT64, version);
    assert_int_equal(version[0], 1);
    assert_int_equal(version[1], 0);
    H5Sclose(space);
    H5Aclose(attribute);
    attribute = H5Aopen(group, "Type", H5P_DEFAULT);
    space = H5Aget_space(attribute);
    const hid_t type = H5Aget_type(attribute);
    char text[17] = "";
    assert_int_equal(H5Sget_simple_extent_type(space), H5S_SCALAR);
    assert_int_equal(H5Tget_class(type), H5T_STRING);
    assert_int_equal(H5Tis_variable_str(type), 0);
    assert_int_equal(H5Tget_cset(type), H5T_CSET_ASCII);
    assert_int_equal(H5Tget_size(type), 16);
    H5Aread(attribute, type, text);
    assert_string_equal(text, "UnstructuredGrid");
    H5Tclose(type);
    H5Sclose(space);
    H5Aclose(attribute);
    H5Gclose(group);
}

/** Counts, types, connectivity and offsets of `cells` separate cells with `corners` points. */
static inline void check_cells(hid_t file, int64_t cells, int64_t corners, uint8_t type)
{
    const int64_t points = cells * corners;
    int64_t number;
    read_longs(file, "VTKHDF/NumberOfPoints", 1, &number);
    assert_int_equal(number, points);
    read_longs(file, "VTKHDF/NumberOfCells", 1, &number);
    assert_int_equal(number, cells);
    read_longs(file, "VTKHDF/NumberOfConnectivityIds", 1, &number);
    assert_int_equal(number, points);
    int64_t *numbers = clod_memory_alloc((size_t)points + 1, sizeof *numbers);
    uint8_t *types = clod_memory_alloc((size_t)cells, 1);
    read_longs(file, "VTKHDF/Connectivity", (hsize_t)points, numbers);
    for (int64_t p = 0; p < points; p++) {
        assert_int_equal(numbers[p], p);
    }
    read_longs(file, "VTKHDF/Offsets", (hsize_t)cells + 1, numbers);
    for (int64_t c = 0; c <= cells; c++) {
        assert_int_equal(numbers[c], c * corners);
    }
    read_array(file, "VTKHDF/Types", H5T_INTEGER, 1, (hsize_t)cells, 0, H5T_NATIVE_UINT8,
               types);
    for (int64_t c = 0; c < cells; c++) {
        assert_int_equal(types[c], type);
    }
    clod_memory_free(numbers);
    clod_memory_free(types);
}
