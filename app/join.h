#pragma once
/**
 * @file join.h
 * A verb that shares its work among the processes of mpirun.
 */

#include "clod/ranks.h"

/**
 * Join the ranks; however this program ends, they are left. On others than rank 0 it does what rank 0 asks
 * for and ends the program.
 *
 * @param verb    "clod VERB", for messages
 * @param result  [out] exit status, if it fails
 * @return        borrowed; NULL, and a message is written, on failure
 */
clod_ranks *clod_app_join(const char *verb, int *result);
