#pragma once
/**
 * @file touch_facets.h
 * Facets near the grains of a part, each once: grains that touch the same facets share one copy,
 * which stays in the processor's cache.
 */

#include "mesh/surface_facet.h"

typedef struct clod_touch_facets {
    clod_surface_facet *facet;
    uint32_t *slot; ///< [slots] 1 + number of a facet here, by its hash; 0: free
    size_t count, room;
    size_t slots; ///< 0 or a power of two, at least twice `count`
} clod_touch_facets;

/** Forget all; memory is kept. */
void clod_touch_facets_begin(clod_touch_facets *self);

/**
 * A facet, which is made where it is not there yet.
 *
 * @param surface  borrowed
 * @param number   of the facet in it
 * @param at       [out] its place in `facet`, until the next begin
 * @return         false without memory
 * Test  tests/step/test_touch_facets.c
 */
bool clod_touch_facets_take(clod_touch_facets *self, const clod_surface *surface,
                            uint32_t number, uint32_t *at);

void clod_touch_facets_fini(clod_touch_facets *self);
