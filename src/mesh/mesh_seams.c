#include "mesh/mesh_seams.h"

#include "base/memory.h"
#include "base/sort.h"
#include "mesh/mesh_points.h"

/** Open edges of a mesh. */
typedef struct seams {
    clod_mesh *mesh;
    clod_sort_item *items; ///< [count] by vertices, ascending; index 3 facet + edge
    size_t count;
    uint32_t *vertices; ///< [vertex_count] of these edges, ascending
    size_t vertex_count;
    clod_mesh_points points;
    clod_mesh_hits hits;
} seams;

static uint64_t key_of(uint32_t a, uint32_t b)
{
    return a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
}

static bool collect_edges(seams *s)
{
    const size_t edges = 3 * s->mesh->view.facet_count;
    const uint8_t *kinds = &s->mesh->edges[0][0];
    for (size_t e = 0; e < edges; e++) {
        s->count += kinds[e] == CLOD_MESH_EDGE_OPEN;
    }
    s->items = clod_memory_alloc(s->count, 2 * sizeof *s->items);
    if (s->items == NULL) {
        return false;
    }
    size_t found = 0;
    for (size_t e = 0; e < edges; e++) {
        if (kinds[e] == CLOD_MESH_EDGE_OPEN) {
            const uint32_t *v = s->mesh->facets[e / 3];
            s->items[found++] = (clod_sort_item){key_of(v[e % 3], v[(e + 1) % 3]), e};
        }
    }
    clod_sort(s->items, s->items + s->count, s->count);
    return true;
}

static bool collect_vertices(seams *s)
{
    const size_t all = s->mesh->view.vertex_count;
    uint8_t *has = clod_memory_alloc(all, sizeof *has);
    s->vertices = clod_memory_alloc(2 * s->count, sizeof *s->vertices);
    if (has == NULL || s->vertices == NULL) {
        clod_memory_free(has);
        return false;
    }
    for (size_t k = 0; k < s->count; k++) {
        has[s->items[k].key >> 32] = 1;
        has[(uint32_t)s->items[k].key] = 1;
    }
    for (uint32_t v = 0; v < all; v++) {
        if (has[v] != 0) {
            s->vertices[s->vertex_count++] = v;
        }
    }
    clod_memory_free(has);
    return true;
}

/** The open edge between two vertices, as 3 facet + edge; SIZE_MAX when there is none. */
static size_t find_edge(const seams *s, uint32_t a, uint32_t b)
{
    const uint64_t key = key_of(a, b);
    size_t low = 0, high = s->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (s->items[middle].key < key) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < s->count && s->items[low].key == key ? s->items[low].index : SIZE_MAX;
}

static void link_one(clod_mesh *mesh, size_t edge, size_t to)
{
    (&mesh->edges[0][0])[edge] = CLOD_MESH_EDGE_T;
    uint32_t *neighbour = &(&mesh->neighbours[0][0])[edge];
    if (*neighbour == CLOD_MESH_NONE) {
        *neighbour = (uint32_t)(to / 3);
    }
}

/** Join a long edge with the short ones between the vertices inside it. */
static void link_pieces(seams *s, size_t edge)
{
    const uint32_t *v = s->mesh->facets[edge / 3];
    const uint32_t end = v[(edge % 3 + 1) % 3];
    uint32_t from = v[edge % 3];
    bool covered = true;
    for (size_t h = 0; h <= s->hits.count; h++) {
        const uint32_t to = h < s->hits.count ? s->hits.items[h].point : end;
        const size_t piece = find_edge(s, from, to);
        if (piece == SIZE_MAX || piece == edge) {
            covered = false;
        } else {
            link_one(s->mesh, piece, edge);
            link_one(s->mesh, edge, piece);
        }
        from = to;
    }
    (&s->mesh->edges[0][0])[edge] = CLOD_MESH_EDGE_T;
    s->mesh->gaps += !covered;
}

static bool look_at_edge(seams *s, size_t edge)
{
    clod_mesh *mesh = s->mesh;
    const uint32_t f = (uint32_t)(edge / 3);
    const int e = (int)(edge % 3);
    const uint32_t *v = mesh->facets[f];
    if (!clod_mesh_points_near(&s->points, mesh->vertices[v[e]], mesh->vertices[v[(e + 1) % 3]],
                               mesh->weld, &s->hits)) {
        return false;
    }
    if (s->hits.count > 0) {
        const uint32_t first = s->hits.items[0].point;
        clod_mesh_note(mesh, CLOD_MESH_T, f, clod_mesh_vertex(mesh, first));
        link_pieces(s, edge);
    }
    return true;
}

bool clod_mesh_seams_find(clod_mesh *self, clod_status *status)
{
    seams s = {.mesh = self};
    bool done = collect_edges(&s);
    if (done && s.count > 0) {
        const double(*places)[3] = (const double(*)[3])self->vertices;
        done = collect_vertices(&s) &&
               clod_mesh_points_init(&s.points, places, s.vertices, s.vertex_count);
        for (size_t k = 0; k < s.count && done; k++) {
            done = look_at_edge(&s, s.items[k].index);
        }
    }
    clod_memory_free(s.items);
    clod_memory_free(s.vertices);
    clod_memory_free(s.hits.items);
    clod_mesh_points_fini(&s.points);
    return done || clod_mesh_lacks_memory(self, status);
}
