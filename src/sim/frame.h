#pragma once
/**
 * @file frame.h
 * A snapshot that is being written, or the files at the end: where to, and of what.
 */

#include <stdint.h>

#include "output/folder.h"

typedef struct clod_frame {
    const clod_folder *folder;
    int64_t number;   ///< of the snapshot
    const char *part; ///< of a test, whose name files begin with; NULL: a free run has none
} clod_frame;
