#include "setup/surface.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "clod/mesh.h"
#include "mesh/surface_touch.h"

/** Most patches of a surface: the shapes of each take 3 kB. */
#define PATCHES_MOST 200000

/** Names of the parts of a mesh, or that it has none, for a message. */
static const char *names_of(const clod_mesh_view *view, char *text, size_t size)
{
    snprintf(text, size, "its parts have no names");
    size_t used = 0;
    for (size_t p = 0; p < view->part_count && used < size; p++) {
        if (view->parts[p].name[0] != '\0') {
            used += (size_t)snprintf(text + used, size - used, "%s%s",
                                     used == 0 ? "its parts are " : ", ", view->parts[p].name);
        }
    }
    return text;
}

/** Find the parts of the case in the file. */
static bool find_parts(clod_setup_mesh *self, const clod_mesh_view *view,
                       const clod_case_wall *wall, const clod_case_shape *shape,
                       clod_status *status)
{
    self->parts = clod_memory_alloc(view->part_count + 1, sizeof *self->parts);
    if (self->parts == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the parts of %s",
                                shape->file);
    }
    for (size_t k = 0; k < shape->part_count; k++) {
        bool found = false;
        for (size_t p = 0; p < view->part_count; p++) {
            if (strcmp(view->parts[p].name, shape->parts[k].name) == 0) {
                self->parts[p] = &shape->parts[k];
                found = true;
            }
        }
        if (!found) {
            char names[400];
            return clod_status_fail(
                status, CLOD_USAGE, "walls.%s: the mesh %s has no part '%s'; %s", wall->name,
                shape->file, shape->parts[k].name, names_of(view, names, sizeof names));
        }
    }
    return true;
}

/** The surface of a mesh, where it stands at the start; NULL: failed. */
static clod_surface *make_surface(const clod_mesh *mesh, const clod_case_wall *wall,
                                  const clod_case_shape *shape, clod_status *status)
{
    clod_mesh_placing then = {.unit = 1.0, .scale = 1.0, .rotate = wall->rotate};
    memcpy(then.move, wall->move, sizeof then.move);
    clod_surface *surface = clod_surface_make(mesh, &then, shape->smooth_angle, status);
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

clod_setup_mesh clod_setup_mesh_read(const clod_case_wall *wall, const clod_case_shape *shape,
                                     clod_status *status)
{
    clod_setup_mesh self = {0};
    clod_mesh_placing placing = {
        .unit = shape->unit, .scale = shape->scale, .rotate = shape->rotate};
    memcpy(placing.move, shape->move, sizeof placing.move);
    clod_mesh *mesh = clod_mesh_read(shape->file, &placing, status);
    if (mesh != NULL && find_parts(&self, clod_mesh_look(mesh), wall, shape, status)) {
        self.surface = make_surface(mesh, wall, shape, status);
    }
    clod_mesh_destroy(&mesh);
    return self;
}

void clod_setup_mesh_fini(clod_setup_mesh *self)
{
    clod_surface_release(self->surface);
    clod_memory_free(self->parts);
    *self = (clod_setup_mesh){0};
}
