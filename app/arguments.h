#pragma once
/**
 * @file arguments.h
 * Arguments of a verb, read with argp.
 */

#include <argp.h>
#include <stdbool.h>

/**
 * Read the arguments of a verb. Wrong ones, --help and --version end the program, as argp does.
 *
 * @param argv   [argc] argv[0] begins the messages
 * @param flags  of argp_parse
 * @param input  handed to the parser
 * @return       false without memory, which is told
 * Test  tests/faults/test_alloc_faults.py
 */
bool clod_arguments_parse(const struct argp *argp, int argc, char **argv, unsigned flags,
                          void *input);
