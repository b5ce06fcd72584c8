#pragma once
/**
 * @file text_maker.h
 * Contents of mesh files, written by tests.
 */

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "clod/mesh.h"
#include "support/check.h"

/** A text that grows. */
typedef struct text {
    char bytes[32768];
    size_t length;
} text;

static inline void __attribute__((format(printf, 2, 3)))
put(text *self, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    self->length += (size_t)vsnprintf(self->bytes + self->length,
                                      sizeof self->bytes - self->length, format, args);
    va_end(args);
    assert_true(self->length < sizeof self->bytes);
}

static inline void put_bytes(text *self, const void *bytes, size_t length)
{
    assert_true(self->length + length < sizeof self->bytes);
    memcpy(self->bytes + self->length, bytes, length);
    self->length += length;
}

static inline clod_mesh *parse(const char *name, const text *content,
                               const clod_mesh_placing *placing)
{
    clod_status status = {CLOD_OK, ""};
    clod_mesh *mesh = clod_mesh_parse(name, content->bytes, content->length, placing, &status);
    if (mesh == NULL) {
        print_error("%s\n", status.text);
    }
    assert_non_null(mesh);
    return mesh;
}
