#pragma once
/**
 * @file surface_contacts.h
 * Contacts of a grain with the surface of a mesh made by code.
 */

#include <math.h>

#include "mesh/mesh_maker.h"
#include "mesh/surface_touch.h"

#define SMOOTH (20.0 * M_PI / 180.0)
#define RADIUS 0.2 ///< m, of the grain
#define MOST 64

static clod_surface_facet near_facets[MOST];
static clod_surface_hit hits[MOST];

static inline clod_surface *surface_of(const maker *made)
{
    clod_mesh *mesh = maker_read(made, &METRES);
    clod_status status;
    clod_surface *surface = clod_surface_make(mesh, NULL, SMOOTH, &status);
    assert_non_null(surface);
    clod_mesh_destroy(&mesh);
    return surface;
}

typedef struct list {
    const clod_surface *surface;
    int32_t count;
} list;

static inline double note(void *context, uint32_t facet, double reach)
{
    list *self = context;
    assert_true(self->count < MOST);
    near_facets[self->count++] = clod_surface_facet_of(self->surface, facet);
    return reach;
}

/** Contacts of a grain, the nearest first. */
static inline int contacts_of(const clod_surface *surface, clod_vec3 p,
                              clod_surface_closest *contact)
{
    list found = {surface, 0};
    clod_surface_near(surface, p, 1.3 * RADIUS, note, &found);
    const int32_t count = clod_surface_touch(near_facets, found.count, p, RADIUS, hits);
    int contacts = 0;
    for (int32_t k = 0; k < count; k++) {
        if (hits[k].root == k) {
            contact[contacts++] = hits[k].at;
        }
    }
    return contacts;
}
