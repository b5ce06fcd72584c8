#pragma once
/**
 * @file gone.h
 * Grains that left, one by one, for a table of them: filled at rebuilds, emptied by whoever
 * writes it, also before every checkpoint.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** A grain that left. */
typedef struct clod_gone_grain {
    uint64_t id;
    double radius, mass; ///< m, kg
    double birth, left;  ///< s, when it came (0: there at the start), when it was removed
    int32_t material;
    int32_t exit; ///< as in clod_exchange
} clod_gone_grain;

/** Not part of a checkpoint, nor of a copy. */
typedef struct clod_gone {
    bool kept;             ///< somebody wants them
    bool lacks_memory;     ///< one could not be put in
    clod_gone_grain *rows; ///< owned
    size_t count, room;
} clod_gone;

/** Put one in, if they are kept. Threads: one per list. */
void clod_gone_add(clod_gone *self, const clod_gone_grain *grain);

/** Free its memory. */
void clod_gone_fini(clod_gone *self);
