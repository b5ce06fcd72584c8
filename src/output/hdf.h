#pragma once
/**
 * @file hdf.h
 * HDF5 files written and read slab by slab through an open file: memory beyond a few MB does
 * not depend on their size. Only files whose checksum was verified are read.
 *
 * A first error is kept and the calls after it do nothing; clod_hdf_finish and
 * clod_hdf_end_reading report it, errors of the disk with the file's name. HDF5 is used by one
 * thread at a time: a clod_hdf holds the library from create or open to finish or end_reading,
 * which must be called in any case.
 */

#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"
#include "output/folder.h"

/** Rows of a chunk in the file, and those that are on their way at a time. */
#define CLOD_HDF_SLAB 16384

typedef struct clod_hdf clod_hdf;

/** Where an HDF5 file is; all borrowed until it is closed. */
typedef struct clod_hdf_place {
    const clod_folder *folder;
    const char *name; ///< of the file, for messages
    int descriptor;   ///< of the open file
    uint64_t start;   ///< bytes in front of those of HDF5
} clod_hdf_place;

typedef enum clod_hdf_type {
    CLOD_HDF_F64,
    CLOD_HDF_I64,
    CLOD_HDF_I32,
    CLOD_HDF_U64,
    CLOD_HDF_U16,
    CLOD_HDF_U8,
    CLOD_HDF_TEXT, ///< `components` is the length of the text, zero bytes included
} clod_hdf_type;

/** Numbers of one kind in rows that lie anywhere in memory, and their place in the file. */
typedef struct clod_hdf_column {
    const char *name;  ///< path in the file, e.g. "grains/radius"
    const char *units; ///< udunits text; NULL: no attribute
    clod_hdf_type type;
    size_t components; ///< numbers per row; 1 makes a dataset of one dimension
    size_t rows;
    const void *data; ///< first row; written to by clod_hdf_get
    size_t stride;    ///< bytes from row to row
} clod_hdf_column;

/** How numbers lie in the file. */
typedef enum clod_hdf_storage {
    CLOD_HDF_EXACT,  ///< as in memory; what has chunks, each with its Fletcher checksum
    CLOD_HDF_PICTURE ///< F64 stored as float32, compressed (shuffle, deflate 1)
} clod_hdf_storage;

/** Start a file, where there is none yet; the descriptor reads and writes. NULL with status. */
clod_hdf *clod_hdf_create(const clod_hdf_place *place, clod_hdf_storage storage,
                          clod_status *status);

/** Whether something went wrong before: nothing more is done then. */
bool clod_hdf_has_failed(const clod_hdf *self);

/** Make a group (with the groups above it). */
void clod_hdf_group(clod_hdf *self, const char *name);

/** Write a column. */
void clod_hdf_put(clod_hdf *self, const clod_hdf_column *column);

/**
 * Have room for a column that is written past HDF5, with clod_hdf_pack, when this file is closed: numbers in
 * one piece, of an exact file. Its data are not looked at.
 *
 * @param place  [out] its first byte in the file, that of HDF5's first byte being 0; without rows 0
 */
void clod_hdf_reserve(clod_hdf *self, const clod_hdf_column *column, uint64_t *place);

/** Bytes of a row in an exact file. */
size_t clod_hdf_row_size(const clod_hdf_column *column);

/** Rows [at, at + count) of a column as they lie in an exact file; all that clod runs on has their byte
 *  order. */
void clod_hdf_pack(const clod_hdf_column *column, size_t at, size_t count, char *packed);

/** Make room for a column whose rows are written later; its data are not looked at. */
void clod_hdf_make(clod_hdf *self, const clod_hdf_column *column);

/** Write rows of a dataset; `first` had better be a multiple of CLOD_HDF_SLAB. */
void clod_hdf_put_rows(clod_hdf *self, const clod_hdf_column *column, size_t first);

/** Attach integers, a number or a text to a group or dataset ("/" is the root). */
void clod_hdf_put_ints(clod_hdf *self, const char *object, const char *name,
                       const int64_t *values, size_t count);
void clod_hdf_put_real(clod_hdf *self, const char *object, const char *name, double value);
void clod_hdf_put_text(clod_hdf *self, const char *object, const char *name, const char *value);

/** Close: bytes of HDF5 in the file, which is not on the disk yet; false with the first error.
 */
bool clod_hdf_finish(clod_hdf **self, uint64_t *size, clod_status *status);

/** Open the `size` bytes of a file for reading; NULL with status. */
clod_hdf *clod_hdf_open(const clod_hdf_place *place, uint64_t size, clod_status *status);

/** Rows of a dataset; 0 when there is none of that name. */
size_t clod_hdf_rows(clod_hdf *self, const char *name);

/** Fill a column's data; type, rows and components must be those of the file. */
void clod_hdf_get(clod_hdf *self, const clod_hdf_column *column);

/** Fill a column's data from rows [first, first + rows) of a dataset of `total` rows. */
void clod_hdf_get_rows(clod_hdf *self, const clod_hdf_column *column, size_t first,
                       size_t total);

/** Whether memory or the disk failed, and not the file, since clod_hdf_open. */
bool clod_hdf_fails_outside(const clod_hdf *self);

/** Close: false with the first error since clod_hdf_open. */
bool clod_hdf_end_reading(clod_hdf **self, clod_status *status);
