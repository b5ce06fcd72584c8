#pragma once
/**
 * @file bytes.h
 * Bytes put one behind the other: what is packed to be sent or stored.
 */

#include <stdbool.h>
#include <stddef.h>

/** All zero: empty. */
typedef struct clod_bytes {
    char *data; ///< [count] owned
    size_t count, capacity;
    bool lacks_memory; ///< something could not be put in
} clod_bytes;

/** Append so many bytes; without memory that is noted, and the bytes stay as they are. */
void clod_bytes_put(clod_bytes *self, const void *from, size_t bytes);

/** Empty; the memory is kept. */
static inline void clod_bytes_clear(clod_bytes *self)
{
    self->count = 0;
    self->lacks_memory = false;
}

void clod_bytes_fini(clod_bytes *self);
