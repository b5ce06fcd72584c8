#pragma once
/**
 * @file surface_flush.h
 * Facets of a surface that are flush with a triangle of another body: in its plane, and over it or
 * beside it without a gap. A grain there is pushed by both.
 */

#include "mesh/surface.h"

/** Cosine of the angle by which planes of flush faces may differ, 20 degrees: the crack alone does not tell it of
 *  facets that are hardly wider. */
#define CLOD_SURFACE_FLUSH_COSINE 0.94

/** A triangle beside a surface, in its frame. */
typedef struct clod_surface_triangle {
    clod_vec3 corner[3]; ///< m; the normal is that of their order
    bool sheet;          ///< grains come to both its sides; else to that of the normal
} clod_surface_triangle;

/** A facet of a surface as a triangle. Threads: pure. */
clod_surface_triangle clod_surface_triangle_of(const clod_surface *self, uint32_t facet);

/** How two triangles lie. */
typedef struct clod_surface_flush {
    double crack;  ///< m, width of a gap that is none
    uint64_t left; ///< steps of searches; at 0 nothing more is found
} clod_surface_flush;

/**
 * Whether two triangles are flush: the corners of one lie within the crack of the plane of the other, the planes
 * differ by less than 20 degrees, no line along an edge parts them by more than the crack, and they face one side (a sheet
 * faces both).
 *
 * Errors  none.   Threads  pure.   Test  tests/setup/test_flush_walls.c
 */
bool clod_surface_flush_are(const clod_surface_triangle *a, const clod_surface_triangle *b,
                            double crack);

/**
 * Whether any facet of a surface is flush with a triangle.
 *
 * @param search  [in,out] its steps become fewer by the boxes and facets looked at
 * Errors  none.   Threads  pure.   Test  tests/setup/test_flush_walls.c
 */
bool clod_surface_flush_has(const clod_surface *self, const clod_surface_triangle *with,
                            clod_surface_flush *search);
