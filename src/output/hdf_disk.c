#include "output/hdf_disk.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include "base/memory.h"
#include "output/file.h"

/** What HDF5 holds of an open file: its own part first. */
typedef struct open_file {
    H5FD_t of_hdf5;
    clod_hdf_disk *disk;
    haddr_t end; ///< of what HDF5 has given out; the file may still be shorter
} open_file;

static H5FD_t *open_disk(const char *name, unsigned flags, hid_t access, haddr_t most)
{
    (void)name;
    (void)flags; // the descriptor was opened for what is to be done
    (void)most;
    clod_hdf_disk *const *disk = H5Pget_driver_info(access);
    if (disk == NULL) {
        return NULL;
    }
    open_file *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        (*disk)->error = ENOMEM;
        return NULL;
    }
    self->disk = *disk;
    self->disk->users++;
    return &self->of_hdf5;
}

static herr_t close_disk(H5FD_t *file)
{
    open_file *self = (open_file *)file;
    self->disk->users--;
    clod_memory_free(self);
    return 0;
}

/** The same abilities as HDF5's drivers of files and of memory: so the bytes are the same. */
static herr_t query(const H5FD_t *file, unsigned long *flags)
{
    (void)file;
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA |
             H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

static haddr_t get_eoa(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const open_file *)file)->end;
}

static herr_t set_eoa(H5FD_t *file, H5FD_mem_t type, haddr_t address)
{
    (void)type;
    ((open_file *)file)->end = address;
    return 0;
}

static haddr_t get_eof(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const open_file *)file)->disk->size;
}

/** Bytes that are not in the file are zero, as HDF5 expects. */
static herr_t read_disk(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t address,
                        size_t size, void *bytes)
{
    (void)type;
    (void)transfer;
    clod_hdf_disk *disk = ((open_file *)file)->disk;
    const size_t there = address >= disk->size         ? 0
                         : disk->size - address < size ? (size_t)(disk->size - address)
                                                       : size;
    if (disk->error == 0) {
        disk->error = clod_file_read_at(disk->descriptor, disk->start + address, bytes, there);
    }
    memset((char *)bytes + there, 0, size - there);
    return disk->error == 0 ? 0 : -1;
}

static herr_t write_disk(H5FD_t *file, H5FD_mem_t type, hid_t transfer, haddr_t address,
                         size_t size, const void *bytes)
{
    (void)type;
    (void)transfer;
    clod_hdf_disk *disk = ((open_file *)file)->disk;
    if (disk->error == 0) {
        disk->error = clod_file_write_at(disk->descriptor, disk->start + address, bytes, size);
    }
    if (disk->error == 0 && address + size > disk->size) {
        disk->size = address + size;
    }
    return 0; // the error is kept
}

/** Make the file as long as HDF5 has given out. */
static herr_t truncate_disk(H5FD_t *file, hid_t transfer, hbool_t closing)
{
    (void)transfer;
    (void)closing;
    const open_file *self = (const open_file *)file;
    clod_hdf_disk *disk = self->disk;
    if (disk->error == 0 && disk->size != self->end) {
        disk->error = clod_file_truncate(disk->descriptor, disk->start + self->end);
        disk->size = self->end;
    }
    return 0;
}

static const H5FD_class_t DRIVER = {
#ifdef H5FD_CLASS_VERSION
    .version = H5FD_CLASS_VERSION,
#endif
#if H5_VERSION_GE(1, 13, 0)
    .value = 511, // of those that are free for use within one program
#endif
    .name = "clod",
    .maxaddr = INT64_MAX,
    .fc_degree = H5F_CLOSE_STRONG,
    .fapl_size = sizeof(clod_hdf_disk *),
    .open = open_disk,
    .close = close_disk,
    .query = query,
    .get_eoa = get_eoa,
    .set_eoa = set_eoa,
    .get_eof = get_eof,
    .read = read_disk,
    .write = write_disk,
    .truncate = truncate_disk,
    .fl_map = H5FD_FLMAP_DICHOTOMY,
};

/**
 * The driver, for good: HDF5 1.10.8 looks at it once more after the last file of it is closed.
 * A program that uses HDF5 itself may have closed the library since.
 */
static hid_t the_driver(void)
{
    static hid_t driver = -1; // of whoever has HDF5
    if (driver < 0 || H5Iget_type(driver) != H5I_VFL) {
        driver = H5FDregister(&DRIVER);
    }
    return driver;
}

hid_t clod_hdf_disk_access(clod_hdf_disk *disk)
{
    const hid_t driver = the_driver();
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    const bool set = driver >= 0 && access >= 0 && H5Pset_driver(access, driver, &disk) >= 0;
    if (!set && access >= 0) {
        H5Pclose(access);
    }
    return set ? access : -1;
}
