#pragma once
/**
 * @file identity.h
 * What makes a run the same run: the case with its defaults, and the content of its files of
 * grains and meshes. The copy case-complete.yaml holds all of it, files as comments behind the
 * case.
 */

#include "clod/case.h"

/**
 * The complete case as its copy in the results folder: the echo, and for each file of
 * grains or of a mesh a comment with its size and its hash.
 *
 * @return  owned text (clod_memory_free), or NULL
 * Errors  CLOD_USAGE: a file cannot be read; CLOD_FAILED without memory.
 * Threads pure.   Test  tests/sim/test_identity.c
 */
char *clod_identity_complete(const clod_case *from, clod_status *status);

/**
 * A complete case without the keys that change neither a bit of the results nor where the
 * series has its rows (snapshots and checkpoints): checkpoints belong to this text.
 *
 * @return  owned text, NULL without memory
 */
char *clod_identity_text(const char *complete);

/**
 * The file by which two complete cases differ.
 *
 * @param before  complete case of the earlier run
 * @param now     complete case of `from`
 * @return        path, borrowed from `from`; NULL when more than files differs
 */
const char *clod_identity_changed_file(const clod_case *from, const char *before,
                                       const char *now);
