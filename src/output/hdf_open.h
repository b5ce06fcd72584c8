#pragma once
/**
 * @file hdf_open.h
 * What hdf.c, hdf_columns.c and hdf_look.c share: an open HDF5 file, and its first error.
 */

#include "output/hdf.h"
#include "output/hdf_disk.h"

struct clod_hdf {
    hid_t file;
    clod_hdf_storage storage;
    clod_hdf_place place;
    clod_hdf_disk *disk; ///< owned
    bool writes;
    char error[256]; ///< empty: none so far
    bool no_memory;  ///< that is why
    H5E_auto2_t printer;
    void *printer_data;
};

/** Keep an error, if it is the first: "HDF5 cannot ACTION NAME". */
void clod_hdf_keep_error(clod_hdf *self, const char *action, const char *name);

/** Memory for a column, owned; without it that is what the first error says. */
void *clod_hdf_take_memory(clod_hdf *self, size_t count, size_t size);

/** Type of HDF5 of a number in memory; not owned. */
hid_t clod_hdf_native(clod_hdf_type type);

/** Owned link properties (H5Pclose) that make the groups above an object. */
hid_t clod_hdf_links(void);
