#include "output/hdf_look.h"

#include <string.h>

#include "output/hdf_open.h"

#define MOST_ROWS 2000000000u ///< of a file that makes sense
#define MOST_COMPONENTS 16

/** Size of an open dataset of numbers; false: it has other things in it. */
static bool measure(hid_t dataset, size_t *rows, size_t *components)
{
    hsize_t size[2] = {0, 1};
    const hid_t space = H5Dget_space(dataset);
    const hid_t type = H5Dget_type(dataset);
    const H5T_class_t kind = H5Tget_class(type);
    const int rank = H5Sget_simple_extent_ndims(space);
    const bool good = (rank == 1 || rank == 2) && (kind == H5T_INTEGER || kind == H5T_FLOAT) &&
                      H5Sget_simple_extent_dims(space, size, NULL) == rank &&
                      size[0] <= MOST_ROWS && size[1] > 0 && size[1] <= MOST_COMPONENTS;
    H5Tclose(type);
    H5Sclose(space);
    *rows = (size_t)size[0];
    *components = (size_t)size[1];
    return good;
}

bool clod_hdf_size(const clod_hdf *self, const char *name, size_t *rows, size_t *components)
{
    const hid_t dataset = H5Dopen2(self->file, name, H5P_DEFAULT);
    const bool good = dataset >= 0 && measure(dataset, rows, components);
    if (dataset >= 0) {
        H5Dclose(dataset);
    }
    return good;
}

size_t clod_hdf_members(const clod_hdf *self, const char *group)
{
    H5G_info_t info;
    return H5Lexists(self->file, group, H5P_DEFAULT) > 0 &&
                   H5Gget_info_by_name(self->file, group, &info, H5P_DEFAULT) >= 0
               ? (size_t)info.nlinks
               : 0;
}

bool clod_hdf_member(const clod_hdf *self, const char *group, size_t k, char *name, size_t size)
{
    const ssize_t length = H5Lget_name_by_idx(self->file, group, H5_INDEX_NAME, H5_ITER_INC,
                                              (hsize_t)k, name, size, H5P_DEFAULT);
    return length > 0 && (size_t)length < size;
}

bool clod_hdf_get_real(const clod_hdf *self, const char *object, const char *name,
                       double *value)
{
    const hid_t attribute = H5Aopen_by_name(self->file, object, name, H5P_DEFAULT, H5P_DEFAULT);
    const bool good = attribute >= 0 && H5Aread(attribute, H5T_NATIVE_DOUBLE, value) >= 0;
    if (attribute >= 0) {
        H5Aclose(attribute);
    }
    return good;
}

bool clod_hdf_get_text(const clod_hdf *self, const char *object, const char *name, char *text,
                       size_t size)
{
    memset(text, 0, size);
    if (H5Aexists_by_name(self->file, object, name, H5P_DEFAULT) <= 0) {
        return false;
    }
    const hid_t attribute = H5Aopen_by_name(self->file, object, name, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    const bool good = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0 &&
                      H5Tget_size(type) < size && H5Aread(attribute, type, text) >= 0;
    H5Tclose(type);
    H5Aclose(attribute);
    if (!good) {
        memset(text, 0, size);
    }
    return good;
}

bool clod_hdf_read(clod_hdf *self, const char *name, clod_hdf_type type, size_t count, void *to)
{
    size_t rows, components;
    const hid_t in_memory = clod_hdf_native(type);
    const hid_t dataset = H5Dopen2(self->file, name, H5P_DEFAULT);
    const bool good =
        dataset >= 0 && measure(dataset, &rows, &components) && rows * components == count &&
        (count == 0 || H5Dread(dataset, in_memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) >= 0);
    if (dataset >= 0) {
        H5Dclose(dataset);
    }
    return good;
}
