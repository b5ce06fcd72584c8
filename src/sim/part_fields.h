#pragma once
/**
 * @file part_fields.h
 * Fields of a test (docs/fields.md): means over regions, in columns behind those of the tester. A
 * part samples them at its rows: at the first one since each interval.
 */

#include "sim/job.h"

/** What the parts of a batch have in common; nothing without fields. */
typedef struct clod_part_fields {
    const clod_case *from;
    const clod_procedure *tester;
    const char **columns; ///< [count] owned, of the tester and then of the fields
    char *text;           ///< owned, header texts of the fields
    size_t count;         ///< 0: there are no fields
} clod_part_fields;

/** Bytes that the fields of a part remember. Threads: pure. */
size_t clod_part_fields_size(const clod_case *from);

/**
 * @param tester  procedure without fields; borrowed, as the case
 * Errors  CLOD_FAILED: no memory.
 */
bool clod_part_fields_init(clod_part_fields *self, const clod_case *from,
                           const clod_procedure *tester, clod_status *status);

void clod_part_fields_fini(clod_part_fields *self);

/**
 * Give a part's procedure the fields.
 *
 * @param self       borrowed by the procedure
 * @param procedure  that of the tester; its data has clod_part_fields_size bytes behind it, zero at
 *                   the beginning
 * Threads  several may share `self`.   Test  tests/cli/test_fields_testers.py
 */
void clod_part_fields_join(const clod_part_fields *self, clod_procedure *procedure);
