#pragma once
/**
 * @file one_case.h
 * The arguments that verbs of one case share: CASE and --set KEY=VALUE.
 */

#include <argp.h>
#include <stdbool.h>
#include <stddef.h>

#include "clod/case.h"

typedef struct clod_one_case {
    const char *example; ///< verb and arguments that write an example case
    const char *path;
    const char **overrides; ///< owned
    size_t override_count;
} clod_one_case;

/** The row of --set for a table of options. */
#define CLOD_ONE_CASE_SET                                                                      \
    {                                                                                          \
        "set", 'S', "KEY=VALUE", 0, "change a key of the case; may be given often", 0          \
    }

/**
 * Read a command line.
 *
 * @param input  of the parser
 * @return       false: what is wrong has been said, and nothing is owned
 */
bool clod_one_case_init(clod_one_case *self, const struct argp *argp, int argc, char **argv,
                        void *input);

/** What a parser of argp answers to keys that are not its own. */
error_t clod_one_case_parse(clod_one_case *self, int key, char *argument,
                            struct argp_state *state);

/** Read the case; NULL with a status. Owned by the caller. */
clod_case *clod_one_case_load(const clod_one_case *self, clod_status *status);

/** Free the overrides and say what failed, if anything did; returns the exit status. */
int clod_one_case_fini(clod_one_case *self, char **argv, bool good, const clod_status *status);
