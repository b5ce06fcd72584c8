#pragma once
/**
 * @file surface_parts.h
 * Planes, smooth pieces and patches of a surface that has its facets.
 */

#include "mesh/surface.h"

/** Facets that have an edge in common, both ways. */
typedef struct clod_surface_links {
    uint32_t *start; ///< [facets + 1]
    uint32_t *item;  ///< [start[facets]] other facets
    uint32_t *work;  ///< [facets] scratch
} clod_surface_links;

/** Neighbours over edges of any kind, and facets that lie over each other; false without memory. */
bool clod_surface_links_make(clod_surface_links *self, const clod_mesh *mesh);
void clod_surface_links_fini(clod_surface_links *self);

/**
 * Find the planes: each grows from its largest facet over facets whose corners are within `weld`
 * of it; then the smooth pieces, the patches and the rims.
 * @return  false without memory.   Test  tests/mesh/test_surface_touch.c
 */
bool clod_surface_parts_find(clod_surface *self, const clod_mesh *mesh,
                             const clod_surface_links *links);
