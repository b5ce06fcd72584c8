#include "mesh/surface_bytes.h"

#include <string.h>

#include "base/memory.h"

/** Arrays of a surface. */
enum { ARRAYS = 14 };

typedef struct surface_array {
    void **array; ///< where the pointer is
    size_t count, size;
} surface_array;

static void arrays_of(clod_surface *self, surface_array all[ARRAYS])
{
    int k = 0;
#define ADD(field, number)                                                                     \
    all[k++] = (surface_array){(void **)&self->field, (number), sizeof *self->field}
    ADD(vertex, self->vertex_count);
    ADD(facet, self->facet_count);
    ADD(plane, self->facet_count);
    ADD(piece, self->facet_count);
    ADD(patch, self->facet_count);
    ADD(part, self->facet_count);
    ADD(rims, self->facet_count);
    ADD(planes, self->plane_count);
    ADD(patches, self->patch_count);
    ADD(cylinders, self->cylinder_count);
    ADD(part_name, self->part_count);
    ADD(part_label, self->part_count);
    ADD(node, self->facet_count + 2); // as many as the tree has room for
    ADD(leaf, self->facet_count);
#undef ADD
}

void clod_surface_pack(const clod_surface *self, clod_bytes *to)
{
    surface_array all[ARRAYS];
    arrays_of((clod_surface *)self, all);
    clod_bytes_put(to, self, sizeof *self);
    for (int k = 0; k < ARRAYS; k++) {
        if (all[k].count > 0) { // else there may be no array
            clod_bytes_put(to, *all[k].array, all[k].count * all[k].size);
        }
    }
}

clod_surface *clod_surface_unpack(const char **at)
{
    clod_surface *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        return NULL;
    }
    memcpy(self, *at, sizeof *self);
    *at += sizeof *self;
    atomic_init(&self->users, 1);
    surface_array all[ARRAYS];
    arrays_of(self, all);
    bool good = true;
    for (int k = 0; k < ARRAYS; k++) {
        const size_t bytes = all[k].count * all[k].size;
        *all[k].array = clod_memory_alloc(all[k].count + 1, all[k].size);
        good = good && *all[k].array != NULL;
        if (*all[k].array != NULL && bytes > 0) {
            memcpy(*all[k].array, *at, bytes);
        }
        *at += bytes;
    }
    if (!good) {
        clod_surface_release(self);
        return NULL;
    }
    return self;
}
