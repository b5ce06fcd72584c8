#pragma once
/**
 * @file mesh_maker.h
 * Meshes made by code: binary STL, since its numbers are exactly those given.
 */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clod/mesh.h"
#include "mesh/surface.h"
#include "support/check.h"

#define MAKER_MOST 120000

/** A binary STL in memory. */
typedef struct maker {
    char bytes[84 + 50 * MAKER_MOST];
    uint32_t count;
} maker;

static const clod_mesh_placing METRES = {.unit = 1.0, .scale = 1.0};

/** One for all tests of a program, empty. */
static inline maker *maker_new(void)
{
    static maker all;
    memset(all.bytes, 0, 84);
    all.count = 0;
    return &all;
}

static inline void maker_add(maker *self, const float a[3], const float b[3], const float c[3])
{
    assert_true(self->count < MAKER_MOST);
    char *at = self->bytes + 84 + 50 * (size_t)self->count++;
    memset(at, 0, 50);
    memcpy(at + 12, a, 12);
    memcpy(at + 24, b, 12);
    memcpy(at + 36, c, 12);
    memcpy(self->bytes + 80, &self->count, 4); // the tests run on little-endian machines
}

/** Facets by numbers of points. */
static inline void maker_add_all(maker *self, const float (*points)[3], const int (*facets)[3],
                                 size_t count)
{
    for (size_t f = 0; f < count; f++) {
        maker_add(self, points[facets[f][0]], points[facets[f][1]], points[facets[f][2]]);
    }
}

static inline size_t maker_length(const maker *self)
{
    return 84 + 50 * (size_t)self->count;
}

/** The mesh; it must be accepted. */
static inline clod_mesh *maker_read(const maker *self, const clod_mesh_placing *placing)
{
    clod_status status = {CLOD_OK, ""};
    clod_mesh *mesh =
        clod_mesh_parse("made.stl", self->bytes, maker_length(self), placing, &status);
    if (mesh == NULL) {
        print_error("%s\n", status.text);
    }
    assert_non_null(mesh);
    return mesh;
}

/** The surface of the mesh; smooth below an angle [rad]. */
static inline clod_surface *maker_surface(const maker *self, double smooth)
{
    clod_mesh *mesh = maker_read(self, &METRES);
    clod_status status;
    clod_surface *surface = clod_surface_make(mesh, NULL, smooth, &status);
    assert_non_null(surface);
    clod_mesh_destroy(&mesh);
    return surface;
}

static inline clod_mesh_report maker_report(const clod_mesh *mesh, double radius)
{
    clod_mesh_report report;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_mesh_examine(mesh, radius, &report, &status));
    return report;
}

/** A mesh and its report from what was made. */
static inline clod_mesh_report maker_finish(const maker *self, clod_mesh **mesh)
{
    *mesh = maker_read(self, &METRES);
    return maker_report(*mesh, 0.0);
}

/** Findings of all kinds together. */
static inline size_t maker_found(const clod_mesh_report *report)
{
    size_t count = 0;
    for (int k = 0; k < CLOD_MESH_KINDS; k++) {
        count += report->findings[k].count;
    }
    return count;
}

/** A box from `low` to `low` + `size` of twelve facets, normals outwards. */
static inline void maker_box(maker *self, const float low[3], const float size[3])
{
    static const int FACETS[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7},
                                      {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
                                      {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    float points[8][3];
    for (int p = 0; p < 8; p++) {
        const int x = p == 1 || p == 2 || p == 5 || p == 6;
        const int y = p == 2 || p == 3 || p == 6 || p == 7;
        points[p][0] = low[0] + (x ? size[0] : 0.0f);
        points[p][1] = low[1] + (y ? size[1] : 0.0f);
        points[p][2] = low[2] + (p >= 4 ? size[2] : 0.0f);
    }
    maker_add_all(self, (const float(*)[3])points, FACETS, 12);
}
