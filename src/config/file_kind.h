#pragma once
/**
 * @file file_kind.h
 * The kinds of YAML files that clod reads, told apart by the keys that each of them must have.
 */

#include <stdbool.h>

#include "config/load.h"

typedef enum clod_file_kind {
    CLOD_FILE_CASE,   ///< of a simulation
    CLOD_FILE_HOPPER, ///< of a design
    CLOD_FILE_PLAN,   ///< of a calibration
    CLOD_FILE_CARD,   ///< of a material, for cases to include
    CLOD_FILE_KINDS,
    CLOD_FILE_UNKNOWN = CLOD_FILE_KINDS,
} clod_file_kind;

/** Whether a file may be of the kind that a verb wants, which is no card; false after saying which it is of,
 *  and who reads it.   Test  tests/hopper/test_refusals.py */
bool clod_file_kind_check(clod_loader *loader, clod_file_kind wanted);
