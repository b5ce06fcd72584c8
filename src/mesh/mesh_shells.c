#include "mesh/mesh_shells.h"

#include "base/memory.h"

/** The first facet of a tree; the way to it is halved. */
static uint32_t root_of(uint32_t *above, uint32_t facet)
{
    while (above[facet] != facet) {
        above[facet] = above[above[facet]];
        facet = above[facet];
    }
    return facet;
}

bool clod_mesh_shells_number(clod_mesh *self, clod_status *status)
{
    const size_t count = self->view.facet_count;
    uint32_t *above = clod_memory_alloc(count, sizeof *above);
    if (above == NULL) {
        return clod_mesh_lacks_memory(self, status);
    }
    for (uint32_t f = 0; f < count; f++) {
        above[f] = f;
    }
    for (uint32_t f = 0; f < count; f++) {
        for (int e = 0; e < 3; e++) {
            if (self->neighbours[f][e] == CLOD_MESH_NONE) {
                continue;
            }
            const uint32_t own = root_of(above, f);
            const uint32_t other = root_of(above, self->neighbours[f][e]);
            above[own > other ? own : other] = own > other ? other : own;
        }
    }
    self->view.shell_count = 0;
    self->shell = clod_memory_alloc(count, sizeof *self->shell);
    if (self->shell == NULL) {
        clod_memory_free(above);
        return clod_mesh_lacks_memory(self, status);
    }
    for (uint32_t f = 0; f < count; f++) {
        const uint32_t root = root_of(above, f); // never behind f
        self->shell[f] = root == f ? (uint32_t)self->view.shell_count++ : self->shell[root];
    }
    clod_memory_free(above);
    return true;
}
