#pragma once
/**
 * @file frame.h
 * A snapshot that is being written: where to, and which it is.
 */

#include <stdint.h>

#include "output/folder.h"

typedef struct clod_frame {
    const clod_folder *folder;
    int64_t number; ///< of the snapshot
} clod_frame;
