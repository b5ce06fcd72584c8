// Facets that stand for a cylinder.
#include <math.h>

#include "base/memory.h"
#include "mesh/surface.h"

/** How far a cylinder is beyond a facet whose corners lie on it, at most [m]: between corners
 *  that are `length` apart across the axis. */
static double bulge_of(const clod_surface *self, uint32_t facet,
                       const clod_surface_cylinder *cylinder)
{
    double longest = 0.0;
    for (int c = 0; c < 3; c++) {
        const clod_vec3 a = clod_vec3_of(self->vertex[self->facet[facet][c]]);
        const clod_vec3 b = clod_vec3_of(self->vertex[self->facet[facet][(c + 1) % 3]]);
        const clod_vec3 way = clod_vec3_sub(b, a);
        const double along = clod_vec3_dot(way, cylinder->axis);
        longest = fmax(longest, clod_vec3_length(clod_vec3_axpy(way, -along, cylinder->axis)));
    }
    const double half = fmin(0.5 * longest / cylinder->radius, 1.0);
    return cylinder->radius * (1.0 - sqrt(1.0 - half * half));
}

bool clod_surface_make_round(clod_surface *self, uint32_t part,
                             const clod_surface_cylinder *cylinder)
{
    const size_t count = self->cylinder_count;
    clod_surface_cylinder *grown =
        clod_memory_grow(self->cylinders, count, count + 1, sizeof *grown);
    bool *shared = clod_memory_alloc(self->plane_count + 1, sizeof *shared);
    if (grown != NULL) {
        self->cylinders = grown;
    }
    if (grown == NULL || shared == NULL) {
        clod_memory_free(shared);
        return false;
    }
    self->cylinders[self->cylinder_count++] = *cylinder;
    for (size_t f = 0; f < self->facet_count; f++) {
        shared[self->plane[f]] = shared[self->plane[f]] || self->part[f] != part;
    }
    for (size_t f = 0; f < self->facet_count; f++) {
        if (self->part[f] == part && !shared[self->plane[f]]) {
            self->planes[self->plane[f]].cylinder = (uint32_t)self->cylinder_count;
            self->bulge = fmax(self->bulge, bulge_of(self, (uint32_t)f, cylinder));
        }
    }
    clod_memory_free(shared);
    return true;
}
