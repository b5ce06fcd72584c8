#include "mesh/mesh_vertices.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/sort.h"

#define SEEN 0x80000000u     ///< bit of a vertex that was noted; no mesh has so many
#define DOUBLE_STEPS 0x1p-50 ///< four steps of a double
#define FARTHEST 1e7         ///< m; no plant on Earth is larger
#define CELL_PER_WELD                                                                          \
    4.0 ///< a vertex looks into one cell of the grid mostly, never more than 8

/** Bits of a coordinate; 0 and -0 are one place. */
static uint32_t bits_of(float value)
{
    uint32_t bits = 0;
    const float plain = value == 0.0f ? 0.0f : value;
    memcpy(&bits, &plain, sizeof bits);
    return bits;
}

/** Corners sorted by place: equal ones stand side by side, the first in the file first. */
static clod_sort_item *sort_corners(const float (*places)[3], size_t count)
{
    clod_sort_item *items = clod_memory_alloc(count, 2 * sizeof *items);
    if (items == NULL) {
        return NULL;
    }
    for (size_t c = 0; c < count; c++) {
        items[c] = (clod_sort_item){bits_of(places[c][2]), c};
    }
    clod_sort(items, items + count, count);
    for (size_t c = 0; c < count; c++) {
        const float *at = places[items[c].index];
        items[c].key = (uint64_t)bits_of(at[0]) << 32 | bits_of(at[1]);
    }
    clod_sort(items, items + count, count);
    return items;
}

/** For each corner the first one of the file at the same place. */
static bool find_first(const float (*places)[3], size_t count, uint32_t *first)
{
    clod_sort_item *items = sort_corners(places, count);
    if (items == NULL) {
        return false;
    }
    for (size_t k = 0; k < count; k++) {
        const size_t own = items[k].index;
        const bool same = k > 0 && items[k].key == items[k - 1].key &&
                          bits_of(places[own][2]) == bits_of(places[items[k - 1].index][2]);
        first[own] = same ? first[items[k - 1].index] : (uint32_t)own;
    }
    clod_memory_free(items);
    return true;
}

/** Corners of the same bits become one vertex, in the order of the file. */
static bool join_same(clod_mesh *self, const float (*places)[3], size_t count)
{
    uint32_t *vertex = &self->facets[0][0];
    if (!find_first(places, count, vertex)) {
        return false;
    }
    size_t found = 0;
    for (size_t c = 0; c < count; c++) {
        found += vertex[c] == c;
    }
    self->vertices = clod_memory_alloc(found, sizeof *self->vertices);
    if (self->vertices == NULL) {
        return false;
    }
    self->view.vertex_count = 0;
    for (size_t c = 0; c < count; c++) {
        if (vertex[c] == c) {
            for (int k = 0; k < 3; k++) {
                self->vertices[self->view.vertex_count][k] = (double)places[c][k];
            }
            vertex[c] = (uint32_t)self->view.vertex_count++;
        } else {
            vertex[c] = vertex[vertex[c]]; // an earlier corner, which has its vertex already
        }
    }
    return true;
}

static double farthest_coordinate(const clod_mesh *self)
{
    double most = 0.0;
    for (size_t v = 0; v < self->view.vertex_count; v++) {
        for (int k = 0; k < 3; k++) {
            most = fmax(most, fabs(self->vertices[v][k]));
        }
    }
    return most;
}

/** Vertices that others are welded to, by the cells of a grid; open addressing. */
typedef struct grid {
    const double (*places)[3];
    uint32_t *slots; ///< [size] vertex + 1; 0 = free
    size_t size;     ///< a power of two, at least twice the vertices
    double cell, weld;
} grid;

static size_t slot_of(const grid *g, const int64_t cell[3])
{
    uint64_t hash = 0;
    for (int k = 0; k < 3; k++) {
        hash = (hash ^ (uint64_t)cell[k]) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 29;
    }
    return (size_t)hash & (g->size - 1);
}

/** The first vertex of the file within reach that stands in a cell, or `otherwise`. */
static uint32_t find_in_cell(const grid *g, const int64_t cell[3], const double at[3],
                             uint32_t otherwise)
{
    uint32_t found = otherwise;
    for (size_t s = slot_of(g, cell); g->slots[s] != 0; s = (s + 1) & (g->size - 1)) {
        const uint32_t other = g->slots[s] - 1;
        const double *there = g->places[other];
        const double dx = there[0] - at[0], dy = there[1] - at[1], dz = there[2] - at[2];
        if (other < found && dx * dx + dy * dy + dz * dz <= g->weld * g->weld) {
            found = other;
        }
    }
    return found;
}

/** The vertex that `vertex` is welded to; itself when there is none, and then others find it. */
static uint32_t find_near(grid *g, uint32_t vertex)
{
    const double *at = g->places[vertex];
    int64_t low[3], high[3], own[3];
    for (int k = 0; k < 3; k++) {
        low[k] = (int64_t)floor((at[k] - g->weld) / g->cell);
        high[k] = (int64_t)floor((at[k] + g->weld) / g->cell);
        own[k] = (int64_t)floor(at[k] / g->cell);
    }
    uint32_t found = vertex;
    int64_t cell[3];
    for (cell[0] = low[0]; cell[0] <= high[0]; cell[0]++) {
        for (cell[1] = low[1]; cell[1] <= high[1]; cell[1]++) {
            for (cell[2] = low[2]; cell[2] <= high[2]; cell[2]++) {
                found = find_in_cell(g, cell, at, found);
            }
        }
    }
    if (found == vertex) {
        size_t s = slot_of(g, own);
        while (g->slots[s] != 0) {
            s = (s + 1) & (g->size - 1);
        }
        g->slots[s] = vertex + 1;
    }
    return found;
}

/** For each vertex the one that it is welded to. Those are farther apart than the tolerance. */
static bool find_welds(const clod_mesh *self, uint32_t *to)
{
    grid g = {.places = (const double(*)[3])self->vertices,
              .size = 16,
              .cell = CELL_PER_WELD * self->weld,
              .weld = self->weld};
    while (g.size < 2 * self->view.vertex_count) {
        g.size *= 2;
    }
    g.slots = clod_memory_alloc(g.size, sizeof *g.slots);
    if (g.slots == NULL) {
        return false;
    }
    for (size_t v = 0; v < self->view.vertex_count; v++) {
        to[v] = find_near(&g, (uint32_t)v);
    }
    clod_memory_free(g.slots);
    return true;
}

/** Note every vertex that is welded, at the first facet that has it, and let facets follow. */
static void weld(clod_mesh *self, uint32_t *to)
{
    for (uint32_t f = 0; f < self->view.facet_count; f++) {
        for (int c = 0; c < 3; c++) {
            const uint32_t vertex = self->facets[f][c];
            const uint32_t target = to[vertex] & ~SEEN;
            if (target != vertex && (to[vertex] & SEEN) == 0) {
                clod_mesh_note(self, CLOD_MESH_WELDED, f, clod_mesh_vertex(self, vertex));
                to[vertex] |= SEEN;
            }
            self->facets[f][c] = target;
        }
    }
}

bool clod_mesh_vertices_join(clod_mesh *self, const float (*corners)[3][3], size_t count,
                             clod_status *status)
{
    self->facets = clod_memory_alloc(count, sizeof *self->facets);
    if (self->facets == NULL || !join_same(self, corners[0], 3 * count)) {
        return clod_mesh_lacks_memory(self, status);
    }
    self->view.facet_count = count;
    return true;
}

/** A vertex at its place; `turn` has an angle or is left out. */
static clod_vec3 place_vertex(const clod_mesh_placing *placing, clod_vec3 at, clod_vec3 axis)
{
    const clod_case_rotation *turn = &placing->rotate;
    at = clod_vec3_scale(at, placing->unit * placing->scale);
    if (turn->angle != 0.0) {
        const clod_vec3 point = {turn->point[0], turn->point[1], turn->point[2]};
        const clod_vec3 arm = clod_vec3_sub(at, point);
        at = clod_vec3_add(point, clod_vec3_rotate(arm, axis, turn->angle));
    }
    const clod_vec3 move = {placing->move[0], placing->move[1], placing->move[2]};
    return clod_vec3_add(at, move);
}

bool clod_mesh_vertices_place(clod_mesh *self, const clod_mesh_placing *placing,
                              clod_status *status)
{
    const double *given = placing->rotate.axis;
    const clod_vec3 axis = placing->rotate.angle != 0.0 ? clod_vec3_unit(clod_vec3_of(given))
                                                        : (clod_vec3){0.0, 0.0, 1.0};
    self->weld = CLOD_MESH_WELD_STEPS * (double)FLT_EPSILON * farthest_coordinate(self) *
                 placing->unit * placing->scale;
    for (uint32_t v = 0; v < self->view.vertex_count; v++) {
        const clod_vec3 at = place_vertex(placing, clod_mesh_vertex(self, v), axis);
        self->vertices[v][0] = at.x;
        self->vertices[v][1] = at.y;
        self->vertices[v][2] = at.z;
    }
    const double farthest = farthest_coordinate(self);
    self->weld = fmax(self->weld, DOUBLE_STEPS * farthest); // moved far away
    return farthest <= FARTHEST ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: a vertex is %.3g m from the origin; %.0g m are allowed. Is the "
               "unit right?",
               self->path, farthest, FARTHEST);
}

bool clod_mesh_vertices_weld(clod_mesh *self, clod_status *status)
{
    if (self->weld == 0.0) {
        return true; // a single place
    }
    uint32_t *to = clod_memory_alloc(self->view.vertex_count, sizeof *to);
    const bool done = to != NULL && find_welds(self, to);
    if (done) {
        weld(self, to);
    }
    clod_memory_free(to);
    return done || clod_mesh_lacks_memory(self, status);
}
