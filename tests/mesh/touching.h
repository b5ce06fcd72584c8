#pragma once
/**
 * @file touching.h
 * Facets near a grain, and those that it touches: the one place where tests ask for them. It knows no
 * test library, since the fuzzer has none: what may not be aborts.
 */

#include <stdlib.h>

#include "mesh/surface_touch.h"

#define TOUCHING_MOST 65536

/** What a grain touches; static, since it is large. */
typedef struct touching {
    const clod_surface *surface;             ///< of the facets that are added
    clod_surface_facet facet[TOUCHING_MOST]; ///< near ones
    uint32_t near[TOUCHING_MOST];            ///< all of them
    int32_t count;
    clod_surface_hit hit[TOUCHING_MOST]; ///< those that overlap, the nearest first
    int32_t hits;
    const clod_surface_hit
        *contact[TOUCHING_MOST]; ///< those that are contacts, the nearest first
    int contacts;
} touching;

static inline double touching_take(void *context, uint32_t facet, double reach)
{
    touching *self = context;
    if (self->count == TOUCHING_MOST) {
        abort();
    }
    self->near[self->count] = (uint32_t)self->count;
    self->facet[self->count++] = clod_surface_facet_of(self->surface, facet);
    return reach;
}

/** Facets of one more surface of the wall are near too. */
static inline void touching_add(touching *self, const clod_surface *surface, clod_vec3 p,
                                double reach)
{
    self->surface = surface;
    clod_surface_near(surface, p, reach, touching_take, self);
}

/** Only those of this surface are near. */
static inline void touching_near(touching *self, const clod_surface *surface, clod_vec3 p,
                                 double reach)
{
    self->count = 0;
    touching_add(self, surface, p, reach);
}

/** Contacts of a grain with what is near; how many. Each hit goes with one of them, not a farther one. */
static inline int touching_find(touching *self, clod_vec3 p, double radius)
{
    self->hits = clod_surface_touch(self->facet, self->near, self->count, p, radius, self->hit);
    self->contacts = 0;
    for (int32_t k = 0; k < self->hits; k++) {
        const int32_t root = self->hit[k].root;
        if (root < 0 || root > k || self->hit[root].root != root) {
            abort();
        }
        if (root == k) {
            self->contact[self->contacts++] = &self->hit[k];
        }
    }
    return self->contacts;
}
