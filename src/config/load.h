#pragma once
/**
 * @file load.h
 * Tree -> structs, driven by the parameter tables.
 */

#include <limits.h>
#include <stdbool.h>
#include <stddef.h>

#include "config/param.h"
#include "config/report.h"
#include "config/tree.h"

#define CLOD_LOAD_PATH 512

typedef struct clod_loader {
    clod_report *report;
    clod_arena *arena;  ///< for defaults that become nodes
    clod_node *root;    ///< of the tree
    const char *folder; ///< against which files are resolved
    const clod_table
        *around; ///< rows of the section around the one that is being read, or NULL
    char path[CLOD_LOAD_PATH]; ///< of what is being read, for messages
} clod_loader;

/**
 * Fill a struct from a section by its table: known keys, kinds, units, ranges, defaults.
 *
 * @param self     loader; errors go to its report
 * @param table    rows of the struct
 * @param node     the section, or NULL when it was left out (defaults only)
 * @param place    where to complain about keys that are missing
 * @param target   [out] the struct, zeroed before
 * Errors  in the report.   Threads  safe for different loaders.   Test  tests/config/
 */
void clod_load_section(clod_loader *self, const clod_table *table, const clod_node *node,
                       clod_place place, void *target);

/** Free what loading a struct by this table has allocated; the struct is zero afterwards. */
void clod_load_free(const clod_table *table, void *target);

/** Go one level down in the path of messages; returns what clod_load_leave wants. */
size_t clod_load_enter(clod_loader *self, const char *key);

/** Come back up. */
void clod_load_leave(clod_loader *self, size_t length);

/** Where a missing key is complained about: the section's own key, or the section. */
clod_place clod_load_place(const clod_node *node);

/** Folder of a file as its path names it, "." for one without; against which other files are found. */
void clod_load_folder(const char *path, char folder[PATH_MAX]);
