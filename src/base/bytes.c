#include "base/bytes.h"

#include <string.h>

#include "base/memory.h"

/** Room for so many bytes behind those that are there. */
static bool reserve(clod_bytes *self, size_t bytes)
{
    const size_t count = self->count + bytes;
    if (count <= self->capacity) {
        return true;
    }
    const size_t more = count + count / 2 + 256;
    char *grown = clod_memory_grow(self->data, self->capacity, more, 1);
    if (grown == NULL) {
        return false;
    }
    self->data = grown;
    self->capacity = more;
    return true;
}

void clod_bytes_put(clod_bytes *self, const void *from, size_t bytes)
{
    if (self->lacks_memory || !reserve(self, bytes)) {
        self->lacks_memory = true;
        return;
    }
    if (bytes > 0) { // else there may be nothing to copy from
        memcpy(self->data + self->count, from, bytes);
    }
    self->count += bytes;
}

void clod_bytes_fini(clod_bytes *self)
{
    clod_memory_free(self->data);
    *self = (clod_bytes){0};
}
