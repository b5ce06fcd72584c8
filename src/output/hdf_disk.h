#pragma once
/**
 * @file hdf_disk.h
 * An open file as the storage of HDF5, a file driver of our own.
 *
 * HDF5 never opens a file by a path: it reads and writes through a descriptor of ours, behind
 * the bytes of a head. The first error of the system is kept; from then on what HDF5 writes is
 * dropped and reported to it as written, so that it closes its file as after a success. With
 * HDF5 1.10.8 a flush that fails leaves its file open for good (docs/known-crashes.md).
 */

#include <hdf5.h>
#include <stdint.h>

typedef struct clod_hdf_disk {
    int descriptor; ///< borrowed; read with pread, written with pwrite
    uint64_t start; ///< bytes of the file before those of HDF5
    uint64_t size;  ///< bytes of HDF5 that are there
    int error;      ///< errno of the first failure; 0: none
    int users;      ///< how often HDF5 has it open
} clod_hdf_disk;

/**
 * File access through the driver.
 *
 * @param disk  borrowed until HDF5 has closed the file
 * @return      owned properties (H5Pclose), negative without memory
 * Threads  one at a time, as all of HDF5.   Test  tests/output/test_hdf.c
 */
hid_t clod_hdf_disk_access(clod_hdf_disk *disk);
