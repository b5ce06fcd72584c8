#include "mesh/mesh_edges.h"

#include <math.h>

#include "base/memory.h"
#include "base/sort.h"

#define FLAT 1e-3 ///< sine of the angle between facets up to which they are one plane

/** What lies over an edge without knowing angles. */
static void link_group(clod_mesh *self, const clod_sort_item *items, size_t count)
{
    const uint8_t kind = count == 1   ? CLOD_MESH_EDGE_OPEN
                         : count == 2 ? CLOD_MESH_EDGE_FLAT
                                      : CLOD_MESH_EDGE_NONMANIFOLD;
    for (size_t k = 0; k < count; k++) {
        const size_t own = items[k].index;
        const size_t next = items[(k + 1) % count].index;
        (&self->edges[0][0])[own] = kind;
        (&self->neighbours[0][0])[own] = count == 1 ? CLOD_MESH_NONE : (uint32_t)(next / 3);
    }
}

bool clod_mesh_edges_pair(clod_mesh *self, clod_status *status)
{
    const size_t count = 3 * self->view.facet_count;
    self->neighbours = clod_memory_alloc(self->view.facet_count, sizeof *self->neighbours);
    self->edges = clod_memory_alloc(self->view.facet_count, sizeof *self->edges);
    clod_sort_item *items = clod_memory_alloc(count, 2 * sizeof *items);
    if (self->neighbours == NULL || self->edges == NULL || items == NULL) {
        clod_memory_free(items);
        return clod_mesh_lacks_memory(self, status);
    }
    for (size_t e = 0; e < count; e++) {
        const uint32_t a = self->facets[e / 3][e % 3];
        const uint32_t b = self->facets[e / 3][(e + 1) % 3];
        items[e] = (clod_sort_item){clod_mesh_edges_key(a, b), e};
    }
    clod_sort(items, items + count, count);
    for (size_t from = 0; from < count;) {
        size_t to = from + 1;
        while (to < count && items[to].key == items[from].key) {
            to++;
        }
        link_group(self, items + from, to - from);
        from = to;
    }
    clod_memory_free(items);
    return true;
}

/** Which edge of `facet` has these vertices, and whether it runs from a to b. */
static int edge_of(const clod_mesh *self, uint32_t facet, uint32_t a, uint32_t b, bool *same)
{
    const uint32_t *v = self->facets[facet];
    for (int e = 0; e < 2; e++) {
        *same = v[e] == a && v[e + 1] == b;
        if (*same || (v[e] == b && v[e + 1] == a)) {
            return e;
        }
    }
    *same = v[2] == a;
    return 2;
}

/** Whether the normal of the neighbour over an edge of two facets disagrees. */
static bool disagrees(const clod_mesh *self, uint32_t facet, int e)
{
    const uint32_t *v = self->facets[facet];
    bool same = false;
    edge_of(self, self->neighbours[facet][e], v[e], v[(e + 1) % 3], &same);
    return same;
}

enum { SIDE_NONE, SIDE_KEEP, SIDE_TURN };

/**
 * Give sides to the piece around `first`: neighbours get the same one where normals agree.
 *
 * @param queue  [facet_count] gets the facets of the piece
 * @return       how many there are
 */
static size_t give_sides(const clod_mesh *self, uint32_t first, uint8_t *side, uint32_t *queue)
{
    size_t count = 0;
    queue[count++] = first;
    side[first] = SIDE_KEEP;
    for (size_t k = 0; k < count; k++) {
        const uint32_t f = queue[k];
        for (int e = 0; e < 3; e++) {
            const uint32_t next = self->neighbours[f][e];
            if (self->edges[f][e] != CLOD_MESH_EDGE_FLAT || side[next] != SIDE_NONE) {
                continue;
            }
            side[next] =
                disagrees(self, f, e) ? (uint8_t)(SIDE_KEEP + SIDE_TURN - side[f]) : side[f];
            queue[count++] = next;
        }
    }
    return count;
}

/** Swap two corners of a facet, and its edges with them. */
static void turn_facet(clod_mesh *self, uint32_t f)
{
    uint32_t *v = self->facets[f], *n = self->neighbours[f];
    const uint32_t corner = v[1], neighbour = n[0];
    const uint8_t edge = self->edges[f][0];
    v[1] = v[2];
    v[2] = corner;
    n[0] = n[2];
    n[2] = neighbour;
    self->edges[f][0] = self->edges[f][2];
    self->edges[f][2] = edge;
}

/** Turn the fewer facets of a piece; on a tie the first one stays. */
static void turn_piece(const uint32_t *piece, size_t count, uint8_t *side)
{
    size_t turned = 0;
    for (size_t k = 0; k < count; k++) {
        turned += side[piece[k]] == SIDE_TURN;
    }
    const uint8_t which = 2 * turned <= count ? SIDE_TURN : SIDE_KEEP;
    for (size_t k = 0; k < count; k++) {
        side[piece[k]] = side[piece[k]] == which ? SIDE_TURN : SIDE_KEEP;
    }
}

/** Edges where normals still disagree: the piece is twisted like a Moebius strip. */
static void note_twists(clod_mesh *self)
{
    for (uint32_t f = 0; f < self->view.facet_count; f++) {
        for (int e = 0; e < 3; e++) {
            const bool pair = self->edges[f][e] == CLOD_MESH_EDGE_FLAT;
            const bool first = f < self->neighbours[f][e]; // each pair once
            if (pair && first && disagrees(self, f, e)) {
                clod_mesh_note(self, CLOD_MESH_TWISTED, f, clod_mesh_middle(self, f, e));
            }
        }
    }
}

bool clod_mesh_edges_turn(clod_mesh *self, clod_status *status)
{
    const size_t count = self->view.facet_count;
    uint8_t *side = clod_memory_alloc(count, sizeof *side);
    uint32_t *queue = clod_memory_alloc(count, sizeof *queue);
    const bool done = side != NULL && queue != NULL;
    for (uint32_t f = 0; done && f < count; f++) {
        if (side[f] == SIDE_NONE) {
            turn_piece(queue, give_sides(self, f, side, queue), side);
        }
    }
    for (uint32_t f = 0; done && f < count; f++) {
        if (side[f] == SIDE_TURN) {
            turn_facet(self, f);
            clod_mesh_note(self, CLOD_MESH_TURNED, f, clod_mesh_centre(self, f));
        }
    }
    clod_memory_free(side);
    clod_memory_free(queue);
    if (!done) {
        return clod_mesh_lacks_memory(self, status);
    }
    note_twists(self);
    return true;
}

/** Class of an edge of two facets, seen from the normal of `f`; `across` is its number there. */
static uint8_t class_pair(const clod_mesh *self, uint32_t f, int e, int across)
{
    const uint32_t other = self->neighbours[f][e];
    const clod_vec3 a = clod_mesh_corner(self, f, e);
    const clod_vec3 u = clod_vec3_unit(clod_vec3_sub(clod_mesh_corner(self, f, e + 1), a));
    const clod_vec3 normal = clod_mesh_measure(self, f).normal;
    const clod_vec3 inward = clod_vec3_cross(normal, u);
    const clod_vec3 arm = clod_vec3_sub(clod_mesh_corner(self, other, across + 2), a);
    const double height = clod_vec3_length(clod_vec3_cross(arm, u));
    const double own = clod_vec3_dot(clod_vec3_sub(clod_mesh_corner(self, f, e + 2), a),
                                     inward); // height of f itself
    const double out = clod_vec3_dot(arm, normal);
    const double rounding = self->weld * (1.0 + height / own);
    if (fabs(out) <= fmax(FLAT * height, rounding)) {
        return clod_vec3_dot(arm, inward) < 0.0 ? CLOD_MESH_EDGE_FLAT : CLOD_MESH_EDGE_CONVEX;
    }
    return out < 0.0 ? CLOD_MESH_EDGE_CONVEX : CLOD_MESH_EDGE_CONCAVE;
}

/** Class an edge of two facets for both. */
static void class_both(clod_mesh *self, uint32_t f, int e)
{
    const uint32_t other = self->neighbours[f][e];
    const uint32_t *v = self->facets[f];
    bool same = false;
    const int across = edge_of(self, other, v[e], v[(e + 1) % 3], &same);
    const uint8_t kind = class_pair(self, f, e, across);
    self->edges[f][e] = kind;
    const bool bent = kind != CLOD_MESH_EDGE_FLAT;
    self->edges[other][across] =
        bent && same ? (uint8_t)(CLOD_MESH_EDGE_CONVEX + CLOD_MESH_EDGE_CONCAVE - kind) : kind;
}

void clod_mesh_edges_class(clod_mesh *self)
{
    for (uint32_t f = 0; f < self->view.facet_count; f++) {
        for (int e = 0; e < 3; e++) {
            const uint8_t kind = self->edges[f][e];
            const uint32_t other = self->neighbours[f][e];
            if (kind == CLOD_MESH_EDGE_FLAT && f < other) {
                class_both(self, f, e);
            } else if (kind == CLOD_MESH_EDGE_OPEN) {
                clod_mesh_note(self, CLOD_MESH_OPEN, f, clod_mesh_middle(self, f, e));
            } else if (kind == CLOD_MESH_EDGE_NONMANIFOLD && other < f) { // once for its facets
                clod_mesh_note(self, CLOD_MESH_NONMANIFOLD, f, clod_mesh_middle(self, f, e));
            }
        }
    }
}
