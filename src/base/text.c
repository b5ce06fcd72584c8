#define _GNU_SOURCE // fopencookie

#include "base/text.h"

#include <string.h>

#include "base/memory.h"

#define ROOM 1024 ///< bytes to begin with

static bool reserve(clod_text *self, size_t size)
{
    if (size < self->capacity - self->length) { // the end fits too
        return true;
    }
    const size_t capacity = 2 * self->capacity + size;
    char *grown = clod_memory_grow(self->bytes, self->capacity, capacity, 1);
    if (grown == NULL) {
        return false;
    }
    self->bytes = grown;
    self->capacity = capacity;
    return true;
}

static ssize_t append(void *cookie, const char *bytes, size_t size)
{
    clod_text *self = cookie;
    self->lost = self->lost || !reserve(self, size);
    if (self->lost) {
        return 0; // the stream remembers it as an error
    }
    memcpy(self->bytes + self->length, bytes, size);
    self->length += size;
    return (ssize_t)size;
}

FILE *clod_text_open(clod_text *self)
{
    *self = (clod_text){.bytes = clod_memory_alloc(ROOM, 1), .capacity = ROOM};
    if (self->bytes != NULL) {
        self->out = fopencookie(self, "w", (cookie_io_functions_t){.write = append});
    }
    if (self->out == NULL) {
        clod_memory_free(self->bytes);
        self->bytes = NULL;
    }
    return self->out;
}

char *clod_text_close(clod_text *self)
{
    const bool whole = ferror(self->out) == 0;
    const bool closed = fclose(self->out) == 0;
    char *text = self->bytes;
    self->out = NULL;
    self->bytes = NULL;
    if (!whole || !closed || self->lost) {
        clod_memory_free(text);
        return NULL;
    }
    return text;
}
