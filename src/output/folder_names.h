#pragma once
/**
 * @file folder_names.h
 * Which files of a results folder are clod's, by their names.
 */

#include <limits.h>

#include "output/folder.h"

#define CLOD_FOLDER_LOCK ".clod-lock"

/**
 * How the parts of the testers are called in the names of files, as a regular expression;
 * sim/ring_run.c (ring_shear and jenike), sim/uniaxial_run.c and sim/wall_shear_run.c give these
 * names.
 */
#define CLOD_FOLDER_PART                                                                       \
    "((seed-[0-9]+-)?(preshear|reverse|point-[0-9]+|fill|wall)|stress-[0-9]+)"

/**
 * Names of what only continues or shows a run, as a regular expression: checkpoints, snapshots, their
 * series and states of ParaView, and the map of what contacts remember.
 */
#define CLOD_FOLDER_SPARE                                                                      \
    "(restart(-" CLOD_FOLDER_PART ")?(-failed|-at-[0-9]+)?_[ab][.]h5|"                         \
    "(" CLOD_FOLDER_PART "_)?(snap|walls|contacts)_[0-9]{6,}[.]hdf|history_map[.]hdf|"         \
    "(" CLOD_FOLDER_PART "_)?field_[A-Za-z0-9_]+(-[0-9]{6,})?[.]hdf([.]series)?|"              \
    "(run|" CLOD_FOLDER_PART ")((_walls|_contacts)?[.]hdf[.]series|[.]pvsm))([.]part)?"

/**
 * The first name in the folder, in the order of the alphabet, that a run would write to.
 * @param name  [out] empty when there is none
 */
bool clod_folder_names_first(const clod_folder *self, char name[NAME_MAX + 1],
                             clod_status *status);

/**
 * Visit the names in the folder that match, in no order, until a visit is false.
 *
 * @param pattern  extended regular expression
 * @return         true when all were seen; else with status, that of the visit or its own
 */
bool clod_folder_names_each(const clod_folder *self, const char *pattern,
                            bool (*visit)(void *context, const char *name, clod_status *status),
                            void *context, clod_status *status);

/**
 * Remove the files with the names that a run gives (--fresh), and nothing else; no sub-folders.
 * The copies of the case stay (the run that follows replaces them): one of them may be the very
 * file that the run was started with.
 *
 * Errors  CLOD_FAILED: the folder cannot be read, a file cannot be removed.
 * Threads one per folder.   Test  tests/output/test_folder.c, tests/cli/test_folder.py
 */
bool clod_folder_clear(const clod_folder *self, clod_status *status);
