/**
 * @file mesh_ply_binary.c
 * The data of a binary PLY file.
 */

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/mesh_ply.h"

#define VERTEX_BYTES 13 ///< a byte, x, y, z
#define HEADER_MOST 400

#define HEADER                                                                                 \
    "ply\nformat binary_little_endian 1.0\nelement vertex %lld\nproperty uchar pad\n"          \
    "property float x\nproperty float y\nproperty float z\nelement face %lld\n"                \
    "property list uchar int vertex_indices\nend_header\n"

/** The bits of a number, whatever it is. */
static uint64_t bits_at(const clod_mesh_ply *self, const char *bytes, int size)
{
    uint64_t value = 0;
    for (int b = 0; b < size; b++) {
        const int at = self->form == CLOD_MESH_PLY_BIG ? b : size - 1 - b;
        value = value << 8 | (unsigned char)bytes[at];
    }
    return value;
}

/** The number that a property is. */
static double number_at(const clod_mesh_ply *self, const char *bytes,
                        const clod_mesh_ply_property *own)
{
    const uint64_t bits = bits_at(self, bytes, own->size);
    if (own->whole) {
        const uint64_t sign = (uint64_t)1 << (8 * own->size - 1);
        return own->negative && (bits & sign) != 0 ? (double)bits - 2.0 * (double)sign
                                                   : (double)bits;
    }
    if (own->size == 4) {
        const uint32_t half = (uint32_t)bits;
        float single = 0.0f;
        memcpy(&single, &half, sizeof single);
        return (double)single;
    }
    double number = 0.0;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static char *put_bits(char *out, uint32_t bits)
{
    for (int b = 0; b < 4; b++) {
        *out++ = (char)(unsigned char)(bits >> (8 * b) & 0xFF);
    }
    return out;
}

/** Write the vertices; they are there. */
static bool write_vertices(const clod_mesh_ply *self, const char *at, char *out)
{
    const clod_mesh_ply_element *vertex = &self->elements[CLOD_MESH_PLY_VERTEX];
    for (int64_t v = 1; v <= vertex->count; v++, out += VERTEX_BYTES) {
        out[0] = 'v';
        for (size_t p = 0; p < vertex->property_count; p++) {
            const clod_mesh_ply_property *own = &vertex->properties[p];
            if (own->axis >= 0) {
                const double number = number_at(self, at, own);
                if (!(fabs(number) <= (double)FLT_MAX)) {
                    return clod_status_fail(
                        self->status, CLOD_USAGE,
                        "%s: vertex %lld: coordinate %c is %g; it must be finite and below "
                        "3e38: export the mesh again",
                        self->source->path, (long long)v, "xyz"[own->axis], number);
                }
                const float single = (float)number;
                uint32_t bits = 0;
                memcpy(&bits, &single, sizeof bits);
                put_bits(out + 1 + 4 * own->axis, bits);
            }
            at += own->size;
        }
    }
    return true;
}

/** Walk over a face; its corners go to `out` unless that is NULL. */
static bool read_face(const clod_mesh_ply *self, const char **at, int64_t number, char **out,
                      uint64_t *corners)
{
    const clod_mesh_ply_element *face = &self->elements[CLOD_MESH_PLY_FACE];
    for (size_t p = 0; p < face->property_count; p++) {
        const clod_mesh_ply_property *own = &face->properties[p];
        const size_t size = (size_t)own->size;
        uint64_t items = 1;
        if (self->at.end - *at < own->counter) {
            return clod_mesh_ply_fail_end(self, "face", number, face->count);
        }
        if (own->counter > 0) {
            items = bits_at(self, *at, own->counter);
            if (!clod_mesh_ply_check_count(self, number, items)) {
                return false;
            }
            *at += own->counter;
            *corners = items;
        }
        if ((uint64_t)(self->at.end - *at) < items * size) {
            return clod_mesh_ply_fail_end(self, "face", number, face->count);
        }
        if (own->counter > 0 && out != NULL) {
            *(*out)++ = (char)(unsigned char)items;
        }
        for (uint64_t i = 0; i < items && own->counter > 0; i++) {
            const uint64_t vertex = bits_at(self, *at + i * size, own->size);
            if (!clod_mesh_ply_check_corner(self, number, vertex)) {
                return false;
            }
            if (out != NULL) {
                *out = put_bits(*out, (uint32_t)vertex);
            }
        }
        *at += items * size;
    }
    return true;
}

/** Check all faces and count their corners. */
static bool check_faces(const clod_mesh_ply *self, const char *at, size_t *corners)
{
    for (int64_t k = 1; k <= self->elements[CLOD_MESH_PLY_FACE].count; k++) {
        uint64_t own = 0;
        if (!read_face(self, &at, k, NULL, &own) ||
            !clod_mesh_source_add(self->source, own - 2, self->status)) {
            return false;
        }
        *corners += own;
    }
    return at == self->at.end ||
           clod_status_fail(self->status, CLOD_USAGE,
                            "%s: %td bytes follow the last face that the header announces; "
                            "export the mesh again",
                            self->source->path, self->at.end - at);
}

/** The file as Assimp gets it. */
static bool write_all(const clod_mesh_ply *self, const char *vertices, const char *faces,
                      size_t corners)
{
    const int64_t vertex_count = self->elements[CLOD_MESH_PLY_VERTEX].count;
    const int64_t face_count = self->elements[CLOD_MESH_PLY_FACE].count;
    clod_mesh_source *source = self->source;
    char *all = clod_memory_alloc(HEADER_MOST + VERTEX_BYTES * (size_t)vertex_count +
                                      (size_t)face_count + 4 * corners,
                                  1);
    if (all == NULL) {
        return clod_status_fail(self->status, CLOD_FAILED, "%s: no memory for the mesh",
                                source->path);
    }
    char *out = all + snprintf(all, HEADER_MOST, HEADER, (long long)vertex_count,
                               (long long)face_count);
    if (!write_vertices(self, vertices, out)) {
        clod_memory_free(all);
        return false;
    }
    out += VERTEX_BYTES * vertex_count;
    for (int64_t k = 1; k <= face_count; k++) {
        uint64_t own = 0;
        read_face(self, &faces, k, &out, &own); // checked before
    }
    clod_memory_free(source->bytes);
    source->bytes = all;
    source->length = (size_t)(out - all);
    return true;
}

bool clod_mesh_ply_binary_check(clod_mesh_ply *self)
{
    const clod_mesh_ply_element *vertex = &self->elements[CLOD_MESH_PLY_VERTEX];
    const char *vertices = self->at.at;
    const size_t left = (size_t)(self->at.end - vertices);
    size_t bytes = 0;
    for (size_t p = 0; p < vertex->property_count; p++) {
        bytes += (size_t)vertex->properties[p].size;
    }
    const size_t whole = bytes > 0 ? left / bytes : 0; // x, y and z have some
    if (whole < (size_t)vertex->count) {
        return clod_mesh_ply_fail_end(self, "vertex", (int64_t)whole + 1, vertex->count);
    }
    const char *faces = vertices + bytes * (size_t)vertex->count;
    size_t corners = 0;
    return check_faces(self, faces, &corners) && write_all(self, vertices, faces, corners);
}
