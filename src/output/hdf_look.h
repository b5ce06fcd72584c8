#pragma once
/**
 * @file hdf_look.h
 * What an open HDF5 file holds, for who does not know it beforehand: names, sizes, attributes
 * and numbers of any type. What is not there or is of another kind is no error of the file; the
 * functions say so.
 */

#include "output/hdf.h"

/** Rows and components of numbers in one or two dimensions; false: there are no such. */
bool clod_hdf_size(const clod_hdf *self, const char *name, size_t *rows, size_t *components);

/** How many members a group has; 0 when there is no group. */
size_t clod_hdf_members(const clod_hdf *self, const char *group);

/** Name of member k of a group, in the order of names; false: longer than `size` - 1. */
bool clod_hdf_member(const clod_hdf *self, const char *group, size_t k, char *name,
                     size_t size);

/** A number that is attached to an object ("/": the root); false: there is none. */
bool clod_hdf_get_real(const clod_hdf *self, const char *object, const char *name,
                       double *value);

/** A text of fixed length that is attached to an object; false, and "": there is none that fits.
 */
bool clod_hdf_get_text(const clod_hdf *self, const char *object, const char *name, char *text,
                       size_t size);

/**
 * Read all numbers of a dataset, converted.
 *
 * @param type   of those in memory, no text
 * @param count  as many as there are: rows times components
 * @return       false: not so many, or they cannot be read
 * Test  tests/output/test_hdf.c
 */
bool clod_hdf_read(clod_hdf *self, const char *name, clod_hdf_type type, size_t count,
                   void *to);
