#include "setup/surface.h"

#include <stdio.h>
#include <string.h>

#include "clod/mesh.h"
#include "mesh/surface_touch.h"

/** Most patches of a surface: the shapes of each take 3 kB. */
#define PATCHES_MOST 200000

clod_surface *clod_setup_surface(const clod_case_wall *wall, const clod_case_shape *shape,
                                 clod_status *status)
{
    clod_mesh_placing placing = {
        .unit = shape->unit, .scale = shape->scale, .rotate = shape->rotate};
    memcpy(placing.move, shape->move, sizeof placing.move);
    clod_mesh_placing then = {.unit = 1.0, .scale = 1.0, .rotate = wall->rotate};
    memcpy(then.move, wall->move, sizeof then.move);
    clod_mesh *mesh = clod_mesh_read(shape->file, &placing, status);
    clod_surface *surface =
        mesh != NULL ? clod_surface_make(mesh, &then, shape->smooth_angle, status) : NULL;
    clod_mesh_destroy(&mesh);
    if (surface != NULL && surface->patch_count > PATCHES_MOST) {
        clod_status_fail(status, CLOD_USAGE,
                         "walls.%s: the mesh %s is rough: its facets make %zu pieces of smooth "
                         "surface, and clod takes %d; make it coarser, or smooth_angle larger",
                         wall->name, shape->file, surface->patch_count, PATCHES_MOST);
        clod_surface_release(surface);
        return NULL;
    }
    return surface;
}
