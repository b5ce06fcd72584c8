#include "mesh/surface.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/mesh.h"
#include "mesh/surface_parts.h"
#include "mesh/surface_tree.h"

/** Copy of an array; NULL without memory. */
static void *copy_of(const void *array, size_t count, size_t size)
{
    void *copy = clod_memory_alloc(count + 1, size);
    if (copy != NULL && count > 0) {
        memcpy(copy, array, count * size);
    }
    return copy;
}

static bool allocate(clod_surface *self, const clod_mesh_view *view)
{
    const size_t facets = view->facet_count;
    self->vertex_count = view->vertex_count;
    self->facet_count = facets;
    self->vertex = copy_of(view->vertices, view->vertex_count, sizeof *self->vertex);
    self->facet = copy_of(view->facets, facets, sizeof *self->facet);
    self->part = copy_of(view->part, facets, sizeof *self->part);
    self->plane = clod_memory_alloc(facets + 1, sizeof *self->plane);
    self->piece = clod_memory_alloc(facets + 1, sizeof *self->piece);
    self->patch = clod_memory_alloc(facets + 1, sizeof *self->patch);
    self->rims = clod_memory_alloc(facets + 1, sizeof *self->rims);
    self->planes = clod_memory_alloc(facets + 1, sizeof *self->planes);
    self->patches = clod_memory_alloc(facets + 1, sizeof *self->patches);
    return self->vertex != NULL && self->facet != NULL && self->part != NULL &&
           self->plane != NULL && self->piece != NULL && self->patch != NULL &&
           self->rims != NULL && self->planes != NULL && self->patches != NULL;
}

/** Give back what planes and patches do not need. */
static void trim(clod_surface *self)
{
    void *planes = copy_of(self->planes, self->plane_count, sizeof *self->planes);
    void *patches = copy_of(self->patches, self->patch_count, sizeof *self->patches);
    if (planes != NULL && patches != NULL) {
        clod_memory_free(self->planes);
        clod_memory_free(self->patches);
        self->planes = planes;
        self->patches = patches;
    } else {
        clod_memory_free(planes);
        clod_memory_free(patches);
    }
}

static void place(clod_surface *self, const clod_mesh_placing *at)
{
    const clod_vec3 point = clod_vec3_of(at->rotate.point), move = clod_vec3_of(at->move);
    const bool turns = at->rotate.angle != 0.0;
    const clod_vec3 axis =
        turns ? clod_vec3_unit(clod_vec3_of(at->rotate.axis)) : (clod_vec3){0.0, 0.0, 1.0};
    for (size_t v = 0; v < self->vertex_count; v++) {
        clod_vec3 to = clod_vec3_of(self->vertex[v]);
        if (turns) {
            const clod_vec3 arm = clod_vec3_sub(to, point);
            to = clod_vec3_add(point, clod_vec3_rotate(arm, axis, at->rotate.angle));
        }
        clod_vec3_put(self->vertex[v], clod_vec3_add(to, move));
    }
}

/** Names of the mesh's parts; false without memory. */
static bool name_parts(clod_surface *self, const clod_mesh_view *view)
{
    self->part_count = view->part_count;
    self->part_name = clod_memory_alloc(view->part_count + 1, sizeof *self->part_name);
    for (size_t p = 0; self->part_name != NULL && p < view->part_count; p++) {
        snprintf(self->part_name[p], sizeof self->part_name[p], "%s", view->parts[p].name);
    }
    self->part_label = clod_memory_alloc(view->part_count + 1, sizeof *self->part_label);
    return self->part_name != NULL && self->part_label != NULL;
}

clod_surface *clod_surface_make(const clod_mesh *mesh, const clod_mesh_placing *then,
                                double smooth, clod_status *status)
{
    clod_surface *self = clod_memory_alloc(1, sizeof *self);
    clod_surface_links links = {0};
    bool good = self != NULL;
    if (good) {
        atomic_init(&self->users, 1);
        self->weld = mesh->weld;
        self->smooth = smooth;
        self->smooth_cosine = cos(smooth);
        good = allocate(self, &mesh->view) && name_parts(self, &mesh->view) &&
               clod_surface_links_make(&links, mesh);
        if (good && then != NULL) {
            place(self, then);
        }
        good =
            good && clod_surface_parts_find(self, mesh, &links) && clod_surface_tree_make(self);
    }
    clod_surface_links_fini(&links);
    if (!good) {
        clod_mesh_lacks_memory(mesh, status);
        clod_surface_release(self);
        return NULL;
    }
    trim(self);
    return self;
}

size_t clod_surface_bytes(const clod_surface *self)
{
    const size_t facet = sizeof *self->facet + sizeof *self->plane + sizeof *self->piece +
                         sizeof *self->patch + sizeof *self->part + sizeof *self->rims +
                         sizeof *self->leaf + sizeof *self->node;
    return self->facet_count * facet + self->vertex_count * sizeof *self->vertex +
           self->plane_count * sizeof *self->planes +
           self->patch_count * sizeof *self->patches +
           self->cylinder_count * sizeof *self->cylinders +
           self->part_count * (sizeof *self->part_name + sizeof *self->part_label);
}

clod_surface *clod_surface_share(clod_surface *self)
{
    if (self != NULL) {
        atomic_fetch_add(&self->users, 1);
    }
    return self;
}

void clod_surface_release(clod_surface *self)
{
    if (self == NULL || atomic_fetch_sub(&self->users, 1) > 1) {
        return;
    }
    clod_memory_free(self->vertex);
    clod_memory_free(self->facet);
    clod_memory_free(self->plane);
    clod_memory_free(self->piece);
    clod_memory_free(self->patch);
    clod_memory_free(self->part);
    clod_memory_free(self->rims);
    clod_memory_free(self->planes);
    clod_memory_free(self->patches);
    clod_memory_free(self->cylinders);
    clod_memory_free(self->part_name);
    clod_memory_free(self->part_label);
    clod_memory_free(self->node);
    clod_memory_free(self->leaf);
    clod_memory_free(self);
}
