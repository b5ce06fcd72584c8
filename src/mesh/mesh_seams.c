#include "mesh/mesh_seams.h"

#include "base/memory.h"
#include "base/room.h"
#include "base/sort.h"
#include "mesh/mesh_edges.h"
#include "mesh/mesh_points.h"

/** Open edges, cut into pieces at all vertices of open edges that lie inside them. */
typedef struct seams {
    clod_mesh *mesh;
    size_t *edges; ///< [count] 3 facet + edge, ascending
    size_t count;
    uint32_t *vertices; ///< [vertex_count] of these edges, ascending
    size_t vertex_count;
    clod_sort_item *pieces; ///< [room] key: two vertices; index: the edge
    size_t piece_count, room;
    clod_mesh_points points;
    clod_mesh_hits hits;
} seams;

/** Vertices of an edge. */
static void ends_of(const seams *s, size_t edge, uint32_t ends[2])
{
    const uint32_t *v = s->mesh->facets[edge / 3];
    ends[0] = v[edge % 3];
    ends[1] = v[(edge % 3 + 1) % 3];
}

static bool collect_edges(seams *s)
{
    const size_t edges = 3 * s->mesh->view.facet_count;
    const uint8_t *kinds = &s->mesh->edges[0][0];
    for (size_t e = 0; e < edges; e++) {
        s->count += kinds[e] == CLOD_MESH_EDGE_OPEN;
    }
    s->edges = clod_memory_alloc(s->count, sizeof *s->edges);
    if (s->edges == NULL) {
        return false;
    }
    size_t found = 0;
    for (size_t e = 0; e < edges; e++) {
        if (kinds[e] == CLOD_MESH_EDGE_OPEN) {
            s->edges[found++] = e;
        }
    }
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
        uint32_t ends[2];
        ends_of(s, s->edges[k], ends);
        has[ends[0]] = 1;
        has[ends[1]] = 1;
    }
    for (uint32_t v = 0; v < all; v++) {
        if (has[v] != 0) {
            s->vertices[s->vertex_count++] = v;
        }
    }
    clod_memory_free(has);
    return true;
}

static bool add_piece(seams *s, uint32_t a, uint32_t b, size_t edge)
{
    if (!clod_room_for_one(&s->pieces, &s->room, s->piece_count, sizeof *s->pieces)) {
        return false;
    }
    s->pieces[s->piece_count++] = (clod_sort_item){clod_mesh_edges_key(a, b), edge};
    return true;
}

/** Cut an edge at the vertices inside it; one that has some is on a T. */
static bool cut_edge(seams *s, size_t edge)
{
    clod_mesh *mesh = s->mesh;
    uint32_t ends[2];
    ends_of(s, edge, ends);
    if (!clod_mesh_points_near(&s->points, mesh->vertices[ends[0]], mesh->vertices[ends[1]],
                               mesh->weld, &s->hits)) {
        return false;
    }
    if (s->hits.count > 0) {
        const uint32_t first = s->hits.items[0].point;
        clod_mesh_note(mesh, CLOD_MESH_T, (uint32_t)(edge / 3), clod_mesh_vertex(mesh, first));
        (&mesh->edges[0][0])[edge] = CLOD_MESH_EDGE_T;
    }
    uint32_t from = ends[0];
    for (size_t h = 0; h < s->hits.count; h++) {
        if (!add_piece(s, from, s->hits.items[h].point, edge)) {
            return false;
        }
        from = s->hits.items[h].point;
    }
    return add_piece(s, from, ends[1], edge);
}

static clod_vec3 middle_of(const clod_mesh *mesh, uint64_t key)
{
    const clod_vec3 a = clod_mesh_vertex(mesh, (uint32_t)(key >> 32));
    return clod_vec3_scale(clod_vec3_add(a, clod_mesh_vertex(mesh, (uint32_t)key)), 0.5);
}

/** The edges that have one piece in common: neighbours, if there are several. */
static void link_group(clod_mesh *mesh, const clod_sort_item *pieces, size_t count)
{
    uint8_t *kinds = &mesh->edges[0][0];
    const clod_vec3 middle = middle_of(mesh, pieces[0].key);
    for (size_t k = 0; k < count && count != 2; k++) {
        uint8_t *ends = &mesh->ends[pieces[k].index / 3];
        *ends = (uint8_t)(*ends | 1 << pieces[k].index % 3);
    }
    if (count == 1 && kinds[pieces[0].index] == CLOD_MESH_EDGE_T) {
        clod_mesh_note(mesh, CLOD_MESH_OPEN, (uint32_t)(pieces[0].index / 3), middle);
    }
    if (count > 2) {
        clod_mesh_note(mesh, CLOD_MESH_NONMANIFOLD, (uint32_t)(pieces[0].index / 3), middle);
    }
    for (size_t k = 0; k < count && count > 1; k++) {
        const size_t edge = pieces[k].index;
        uint32_t *neighbour = &(&mesh->neighbours[0][0])[edge];
        kinds[edge] = CLOD_MESH_EDGE_T;
        if (*neighbour == CLOD_MESH_NONE) {
            *neighbour = (uint32_t)(pieces[(k + 1) % count].index / 3);
        }
    }
}

static bool link_pieces(seams *s)
{
    clod_sort_item *scratch = clod_memory_alloc(s->piece_count, sizeof *scratch);
    if (scratch == NULL) {
        return false;
    }
    clod_sort(s->pieces, scratch, s->piece_count);
    clod_memory_free(scratch);
    for (size_t from = 0; from < s->piece_count;) {
        size_t to = from + 1;
        while (to < s->piece_count && s->pieces[to].key == s->pieces[from].key) {
            to++;
        }
        link_group(s->mesh, s->pieces + from, to - from);
        from = to;
    }
    return true;
}

static bool find_seams(seams *s)
{
    const double(*places)[3] = (const double(*)[3])s->mesh->vertices;
    bool done = collect_vertices(s) &&
                clod_mesh_points_init(&s->points, places, s->vertices, s->vertex_count);
    for (size_t k = 0; k < s->count && done; k++) {
        done = cut_edge(s, s->edges[k]);
    }
    return done && link_pieces(s);
}

bool clod_mesh_seams_find(clod_mesh *self, clod_status *status)
{
    seams s = {.mesh = self};
    self->ends = clod_memory_alloc(self->view.facet_count, sizeof *self->ends);
    const bool done =
        self->ends != NULL && collect_edges(&s) && (s.count == 0 || find_seams(&s));
    clod_memory_free(s.edges);
    clod_memory_free(s.vertices);
    clod_memory_free(s.pieces);
    clod_memory_free(s.hits.items);
    clod_mesh_points_fini(&s.points);
    return done || clod_mesh_lacks_memory(self, status);
}
