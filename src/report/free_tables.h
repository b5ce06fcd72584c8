#pragma once
/**
 * @file free_tables.h
 * The tables of free runs: which parts of a summary they show, and what the numbers behind +- are.
 */

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

/** A table. */
typedef struct clod_free_table {
    const char *title;
    const char *key;    ///< of the summary
    const char *within; ///< key of what has the objects in it; NULL: itself
    const char *alone;  ///< name of the one object that it is; NULL: it has objects
    const char *spread; ///< what the numbers behind +- are; NULL: there are none
    bool
        nothing; ///< also numbers that are zero in all runs are compared: nothing spilled, nothing lost
} clod_free_table;

#define CLOD_FREE_TABLE_COUNT 16
extern const clod_free_table CLOD_FREE_TABLES[CLOD_FREE_TABLE_COUNT];

/** The objects of a table: a new reference; NULL: the summary has none. Threads  safe. */
json_t *clod_free_tables_of(const clod_free_table *self, const json_t *summary);
