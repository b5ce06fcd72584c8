#include "output/hdf.h"

#include <errno.h>
#include <hdf5.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "output/folder_files.h"
#include "output/hdf_disk.h"
#include "output/hdf_open.h"

/** HDF5 has state of its own for the whole process; not every build of it is thread-safe. */
static pthread_mutex_t library = PTHREAD_MUTEX_INITIALIZER;
static bool begun; ///< a file was made or opened; of whoever has the lock

bool clod_hdf_has_failed(const clod_hdf *self)
{
    return self->error[0] != '\0' || self->disk->error != 0;
}

void clod_hdf_keep_error(clod_hdf *self, const char *action, const char *name)
{
    if (self->error[0] == '\0') {
        snprintf(self->error, sizeof self->error, "HDF5 cannot %s %s", action, name);
    }
}

void *clod_hdf_take_memory(clod_hdf *self, size_t count, size_t size)
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

static clod_hdf *acquire(const clod_hdf_place *place, uint64_t size, clod_status *status)
{
    clod_hdf *self = clod_memory_alloc(1, sizeof *self);
    clod_hdf_disk *disk = clod_memory_alloc(1, sizeof *disk);
    if (self == NULL || disk == NULL) {
        clod_memory_free(self);
        clod_memory_free(disk);
        clod_status_fail(status, CLOD_FAILED, "There is no memory for an HDF5 file.");
        return NULL;
    }
    *disk = (clod_hdf_disk){place->descriptor, place->start, size, 0, 0};
    self->disk = disk;
    self->place = *place;
    self->file = -1;
    pthread_mutex_lock(&library);
    if (!begun) {
        H5dont_atexit(); // its exit handler would run after a failure within the library, too
        begun = true;
    }
    H5Eget_auto2(H5E_DEFAULT, &self->printer, &self->printer_data);
    H5Eset_auto2(H5E_DEFAULT, on_error, self);
    return self;
}

/** Say what went wrong first. */
static bool tell_error(const clod_hdf *self, clod_status *status)
{
    const clod_hdf_place *place = &self->place;
    if (self->disk->error != 0) {
        return clod_folder_fail(place->folder, self->writes ? "write" : "read", place->name,
                                self->disk->error, status);
    }
    if (self->no_memory) {
        return clod_status_fail(status, CLOD_FAILED, "%s/%s: %s: there is no memory for it.",
                                place->folder->path, place->name, self->error);
    }
    return clod_status_fail(status, CLOD_FAILED, "%s.", self->error);
}

/** Close, give the library back and free; false with the first error. */
static bool release(clod_hdf **self, clod_status *status)
{
    clod_hdf *hdf = *self;
    *self = NULL;
    if (hdf->file >= 0 && H5Fclose(hdf->file) < 0) {
        clod_hdf_keep_error(hdf, "close", "the file");
    }
    H5Eset_auto2(H5E_DEFAULT, hdf->printer, hdf->printer_data);
    const bool good = !clod_hdf_has_failed(hdf) || tell_error(hdf, status);
    if (hdf->disk->users > 0) { // HDF5 could not close it: whatever it may do later is dropped
        hdf->disk->descriptor = -1;
        hdf->disk->error = EBADF;
    } else {
        clod_memory_free(hdf->disk);
    }
    pthread_mutex_unlock(&library);
    clod_memory_free(hdf);
    return good;
}

/** Owned file access properties (H5Pclose). The earliest format is readable everywhere. */
static hid_t file_access(const clod_hdf *self)
{
    const hid_t access = clod_hdf_disk_access(self->disk);
    H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V110);
    return access;
}

clod_hdf *clod_hdf_create(const clod_hdf_place *place, clod_hdf_storage storage,
                          clod_status *status)
{
    clod_hdf *self = acquire(place, 0, status);
    if (self == NULL) {
        return NULL;
    }
    self->storage = storage;
    self->writes = true;
    const hid_t access = file_access(self);
    self->file = H5Fcreate(place->name, H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    if (self->file < 0) {
        clod_hdf_keep_error(self, "create", "a file");
        release(&self, status);
    }
    return self;
}

clod_hdf *clod_hdf_open(const clod_hdf_place *place, uint64_t size, clod_status *status)
{
    clod_hdf *self = acquire(place, size, status);
    if (self == NULL) {
        return NULL;
    }
    const hid_t access = file_access(self);
    self->file = H5Fopen(place->name, H5F_ACC_RDONLY, access);
    H5Pclose(access);
    if (self->file < 0) {
        clod_hdf_keep_error(self, "open", "the file");
        release(&self, status);
    }
    return self;
}

hid_t clod_hdf_links(void)
{
    const hid_t links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    return links;
}

void clod_hdf_group(clod_hdf *self, const char *name)
{
    if (clod_hdf_has_failed(self)) {
        return;
    }
    const hid_t links = clod_hdf_links();
    const hid_t group = H5Gcreate2(self->file, name, links, H5P_DEFAULT, H5P_DEFAULT);
    H5Pclose(links);
    if (group < 0 || H5Gclose(group) < 0) {
        clod_hdf_keep_error(self, "make the group", name);
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
        clod_hdf_keep_error(self, "write the attribute", name);
    }
}

void clod_hdf_put_ints(clod_hdf *self, const char *object, const char *name,
                       const int64_t *values, size_t count)
{
    if (clod_hdf_has_failed(self)) {
        return;
    }
    const hsize_t dimension = count;
    const hid_t space = H5Screate_simple(1, &dimension, NULL);
    put_attribute(self, object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, space, values);
    H5Sclose(space);
}

void clod_hdf_put_real(clod_hdf *self, const char *object, const char *name, double value)
{
    if (clod_hdf_has_failed(self)) {
        return;
    }
    const hid_t space = H5Screate(H5S_SCALAR);
    put_attribute(self, object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, space, &value);
    H5Sclose(space);
}

void clod_hdf_put_text(clod_hdf *self, const char *object, const char *name, const char *value)
{
    if (clod_hdf_has_failed(self)) {
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

bool clod_hdf_finish(clod_hdf **self, uint64_t *size, clod_status *status)
{
    clod_hdf *hdf = *self;
    if (H5Fclose(hdf->file) < 0) {
        clod_hdf_keep_error(hdf, "close", "the file");
    }
    hdf->file = -1;
    *size = hdf->disk->size;
    return release(self, status);
}

bool clod_hdf_fails_outside(const clod_hdf *self)
{
    return self->no_memory || self->disk->error != 0;
}

bool clod_hdf_end_reading(clod_hdf **self, clod_status *status)
{
    return release(self, status);
}
