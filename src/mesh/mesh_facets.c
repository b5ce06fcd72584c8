#include "mesh/mesh_facets.h"

#include <string.h>

#include "base/memory.h"
#include "base/sort.h"

#define THIN 0.01 ///< a ratio of lengths that is below makes a needle or a sliver

/** Corners of a facet in ascending order. */
static void sort_three(const uint32_t facet[3], uint32_t sorted[3])
{
    memcpy(sorted, facet, 3 * sizeof *sorted);
    for (int pass = 0; pass < 3; pass++) {
        const int k = pass % 2; // 0 1, 1 2, 0 1
        if (sorted[k] > sorted[k + 1]) {
            const uint32_t swap = sorted[k];
            sorted[k] = sorted[k + 1];
            sorted[k + 1] = swap;
        }
    }
}

static bool is_degenerate(const clod_mesh *self, uint32_t f)
{
    const uint32_t *v = self->facets[f];
    return v[0] == v[1] || v[1] == v[2] || v[2] == v[0] ||
           !(clod_mesh_measure(self, f).height > self->weld);
}

static void mark_degenerate(clod_mesh *self, uint8_t *drop)
{
    for (uint32_t f = 0; f < self->view.facet_count; f++) {
        if (is_degenerate(self, f)) {
            drop[f] = 1;
            clod_mesh_note(self, CLOD_MESH_DEGENERATE, f, clod_mesh_centre(self, f));
        }
    }
}

/** Facets sorted by their corners; of equal ones the first in the file first. */
static void sort_facets(const clod_mesh *self, clod_sort_item *items, size_t count)
{
    uint32_t v[3];
    for (size_t f = 0; f < count; f++) {
        sort_three(self->facets[f], v);
        items[f] = (clod_sort_item){v[2], f};
    }
    clod_sort(items, items + count, count);
    for (size_t k = 0; k < count; k++) {
        sort_three(self->facets[items[k].index], v);
        items[k].key = (uint64_t)v[0] << 32 | v[1];
    }
    clod_sort(items, items + count, count);
}

/** Mark all but the first of facets with the same corners. */
static bool mark_duplicates(clod_mesh *self, uint8_t *drop)
{
    const size_t count = self->view.facet_count;
    clod_sort_item *items = clod_memory_alloc(count, 2 * sizeof *items);
    if (items == NULL) {
        return false;
    }
    sort_facets(self, items, count);
    size_t first = 0;
    for (size_t k = 1; k < count; k++) {
        uint32_t own[3], before[3];
        sort_three(self->facets[items[k].index], own);
        sort_three(self->facets[items[k - 1].index], before);
        first = memcmp(own, before, sizeof own) == 0 ? first : k;
        if (first != k && drop[items[k].index] == 0) {
            drop[items[k].index] = 2;
            uint16_t *kept = &self->found[items[first].index];
            *kept = (uint16_t)(*kept | 1u << CLOD_MESH_DUPLICATE);
        }
    }
    clod_memory_free(items);
    for (uint32_t f = 0; f < count; f++) {
        if (drop[f] == 2) {
            clod_mesh_note(self, CLOD_MESH_DUPLICATE, f, clod_mesh_centre(self, f));
        }
    }
    return true;
}

static void drop_facets(clod_mesh *self, const uint8_t *drop)
{
    size_t kept = 0;
    for (size_t f = 0; f < self->view.facet_count; f++) {
        if (drop[f] == 0) {
            memcpy(self->facets[kept], self->facets[f], sizeof self->facets[f]);
            self->part[kept] = self->part[f];
            self->number[kept] = self->number[f];
            self->found[kept] = self->found[f];
            self->parts[self->part[f]].facets++;
            kept++;
        }
    }
    self->view.facet_count = kept;
}

/** Number the vertices that facets have, in their order. */
static bool drop_vertices(clod_mesh *self)
{
    uint32_t *to = clod_memory_alloc(self->view.vertex_count, sizeof *to);
    if (to == NULL) {
        return false;
    }
    const size_t corners = 3 * self->view.facet_count;
    uint32_t *vertex = &self->facets[0][0];
    for (size_t c = 0; c < corners; c++) {
        to[vertex[c]] = 1;
    }
    size_t kept = 0;
    for (size_t v = 0; v < self->view.vertex_count; v++) {
        if (to[v] != 0) {
            memmove(self->vertices[kept], self->vertices[v], sizeof self->vertices[v]);
            to[v] = (uint32_t)kept++;
        }
    }
    for (size_t c = 0; c < corners; c++) {
        vertex[c] = to[vertex[c]];
    }
    self->view.vertex_count = kept;
    clod_memory_free(to);
    return true;
}

static void note_shapes(clod_mesh *self)
{
    for (uint32_t f = 0; f < self->view.facet_count; f++) {
        const clod_mesh_triangle t = clod_mesh_measure(self, f);
        if (t.height < THIN * t.longest) {
            clod_mesh_note(self,
                           t.shortest < THIN * t.longest ? CLOD_MESH_NEEDLE : CLOD_MESH_SLIVER,
                           f, clod_mesh_centre(self, f));
        }
    }
}

bool clod_mesh_facets_clean(clod_mesh *self, clod_status *status)
{
    uint8_t *drop = clod_memory_alloc(self->view.facet_count, sizeof *drop);
    if (drop == NULL) {
        return clod_mesh_lacks_memory(self, status);
    }
    mark_degenerate(self, drop);
    const bool done = mark_duplicates(self, drop);
    if (done) {
        drop_facets(self, drop);
    }
    clod_memory_free(drop);
    if (!done) {
        return clod_mesh_lacks_memory(self, status);
    }
    if (self->view.facet_count == 0) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: none of the %zu facets has an area above rounding (heights "
            "up to %.3g m count as none); export the mesh again, nearer to "
            "the origin",
            self->path, self->read_facets, self->weld);
    }
    note_shapes(self);
    return drop_vertices(self) || clod_mesh_lacks_memory(self, status);
}
