#include "mesh/mesh_overlaps.h"

#include <math.h>

#include "base/memory.h"
#include "base/room.h"
#include "mesh/mesh_points.h"

#define DEPTH 64 ///< boxes that wait to be looked at; the tree has at most 24 levels

/** A search. Facets are in the order in which their centres lie along a curve. */
typedef struct search {
    clod_mesh *mesh;
    clod_mesh_points tree; ///< of centres; its boxes are made wider, to hold the facets
    double (*centres)[3];  ///< [facet_count]
    uint32_t *over;   ///< [facet_count] the earliest facet under this one; its own number: none
    uint32_t *joined; ///< [facet_count] another facet of the same group, or itself
    size_t room;
    uint64_t left; ///< steps
} search;

/** A facet while it is compared with others; the normal is found where boxes meet. */
typedef struct facet {
    uint32_t number;
    clod_vec3 corner[3];
    clod_vec3 normal; ///< as long as twice the area
    double square;    ///< of its length
    double low[3], high[3];
} facet;

static void facet_of(const clod_mesh *mesh, uint32_t number, facet *self)
{
    self->number = number;
    for (int c = 0; c < 3; c++) {
        self->corner[c] = clod_mesh_corner(mesh, number, c);
    }
    for (int k = 0; k < 3; k++) {
        const double *a = mesh->vertices[mesh->facets[number][0]];
        const double *b = mesh->vertices[mesh->facets[number][1]];
        const double *c = mesh->vertices[mesh->facets[number][2]];
        self->low[k] = fmin(a[k], fmin(b[k], c[k]));
        self->high[k] = fmax(a[k], fmax(b[k], c[k]));
    }
}

static void find_normal(facet *self)
{
    self->normal = clod_vec3_cross(clod_vec3_sub(self->corner[1], self->corner[0]),
                                   clod_vec3_sub(self->corner[2], self->corner[0]));
    self->square = clod_vec3_dot(self->normal, self->normal);
}

/** Whether boxes, the second one from `low` to `high`, have no point in common. */
static bool is_apart(const facet *self, const double low[3], const double high[3])
{
    return low[0] > self->high[0] || high[0] < self->low[0] || low[1] > self->high[1] ||
           high[1] < self->low[1] || low[2] > self->high[2] || high[2] < self->low[2];
}

/** Whether the corners of a facet lie in the plane of another one. */
static bool lies_in(const clod_mesh *mesh, const facet *self, const facet *plane)
{
    const double most = mesh->weld * mesh->weld * plane->square;
    for (int c = 0; c < 3; c++) {
        const clod_vec3 arm = clod_vec3_sub(self->corner[c], plane->corner[0]);
        const double height = clod_vec3_dot(arm, plane->normal);
        if (height * height > most) {
            return false;
        }
    }
    return true;
}

/** Where a facet is along a direction. */
static void project(const facet *self, clod_vec3 along, double *low, double *high)
{
    const double x = clod_vec3_dot(self->corner[0], along);
    const double y = clod_vec3_dot(self->corner[1], along);
    const double z = clod_vec3_dot(self->corner[2], along);
    *low = fmin(x, fmin(y, z));
    *high = fmax(x, fmax(y, z));
}

/** Whether no line along an edge parts two facets of one plane: then they have an area in common
 *  that is wider than `least` across every edge. */
static bool has_common_area(const facet *a, const facet *b, double least)
{
    const clod_vec3 normal = a->square >= b->square ? a->normal : b->normal;
    for (int e = 0; e < 6; e++) {
        const facet *of = e < 3 ? a : b;
        const clod_vec3 edge = clod_vec3_sub(of->corner[(e + 1) % 3], of->corner[e % 3]);
        const clod_vec3 across = clod_vec3_cross(normal, edge); // not of unit length
        double low[2], high[2];
        project(a, across, &low[0], &high[0]);
        project(b, across, &low[1], &high[1]);
        const double common = fmin(high[0], high[1]) - fmax(low[0], low[1]);
        if (common <= 0.0 || common * common <= least * least * clod_vec3_dot(across, across)) {
            return false;
        }
    }
    return true;
}

/** The facet that stands for the group of another one. */
static uint32_t group_of(search *self, uint32_t number)
{
    while (self->joined[number] != number) {
        self->joined[number] = self->joined[self->joined[number]];
        number = self->joined[number];
    }
    return number;
}

/** Record that two facets lie over each other; false without memory. */
static bool record(search *self, uint32_t a, uint32_t b)
{
    clod_mesh *mesh = self->mesh;
    const uint32_t first = a < b ? a : b, later = a < b ? b : a;
    self->over[later] = first < self->over[later] ? first : self->over[later];
    const uint32_t groups[2] = {group_of(self, first), group_of(self, later)};
    if (groups[0] == groups[1]) {
        return true;
    }
    self->joined[groups[0] > groups[1] ? groups[0] : groups[1]] =
        groups[0] > groups[1] ? groups[1] : groups[0];
    if (!clod_room_for_one(&mesh->overlaps, &self->room, mesh->overlap_count,
                           sizeof *mesh->overlaps)) {
        return false;
    }
    mesh->overlaps[mesh->overlap_count][0] = first;
    mesh->overlaps[mesh->overlap_count++][1] = later;
    return true;
}

/** Compare a facet with those of a leaf that come after it; false without memory. */
static bool look(search *self, const facet *own, size_t place, size_t from)
{
    const clod_mesh_points *tree = &self->tree;
    const double least = 2.0 * self->mesh->weld;
    for (size_t k = from; k < from + CLOD_MESH_POINTS_LEAF && k < tree->count; k++) {
        facet other;
        if (k <= place) {
            continue;
        }
        facet_of(self->mesh, tree->order[k], &other);
        if (is_apart(own, other.low, other.high)) {
            continue;
        }
        find_normal(&other);
        if ((lies_in(self->mesh, own, &other) || lies_in(self->mesh, &other, own)) &&
            has_common_area(own, &other, least) && !record(self, own->number, other.number)) {
            return false;
        }
    }
    return true;
}

/** A box that waits to be looked at: it has `span` places of the order from `from` on. */
typedef struct box {
    size_t node, from, span;
} box;

/** Compare the facet at a place of the order with all after it; false without memory. */
static bool look_after(search *self, size_t place)
{
    const clod_mesh_points *tree = &self->tree;
    box waiting[DEPTH] = {{0, 0, tree->leaves * CLOD_MESH_POINTS_LEAF}};
    size_t count = 1;
    facet own;
    facet_of(self->mesh, tree->order[place], &own);
    find_normal(&own);
    for (int k = 0; k < 3; k++) { // planes may be so far apart
        own.low[k] -= self->mesh->weld;
        own.high[k] += self->mesh->weld;
    }
    while (count > 0) {
        const box at = waiting[--count];
        const size_t half = at.span / 2;
        if (at.from + at.span <= place + 1 ||
            is_apart(&own, tree->boxes[at.node][0], tree->boxes[at.node][1])) {
            continue;
        }
        if (at.span > CLOD_MESH_POINTS_LEAF) {
            self->left -= self->left > 0;
            waiting[count++] = (box){2 * at.node + 1, at.from, half};
            waiting[count++] = (box){2 * at.node + 2, at.from + half, half};
            continue;
        }
        self->left -= self->left < CLOD_MESH_POINTS_LEAF ? self->left : CLOD_MESH_POINTS_LEAF;
        if (!look(self, &own, place, at.from)) {
            return false;
        }
    }
    return true;
}

/** Make the boxes hold the facets, of which they hold the centres. */
static void widen(search *self)
{
    clod_mesh_points *tree = &self->tree;
    for (size_t n = tree->nodes; n-- > 0;) {
        double(*around)[3] = tree->boxes[n];
        const bool leaf = n >= tree->leaves - 1;
        const size_t from = leaf ? (n - (tree->leaves - 1)) * CLOD_MESH_POINTS_LEAF : 0;
        for (size_t k = from; leaf && k < from + CLOD_MESH_POINTS_LEAF && k < tree->count;
             k++) {
            facet own;
            facet_of(self->mesh, tree->order[k], &own);
            clod_mesh_points_grow(around, own.low, own.high);
        }
        for (size_t below = 2 * n + 1; !leaf && below <= 2 * n + 2; below++) {
            clod_mesh_points_grow(around, tree->boxes[below][0], tree->boxes[below][1]);
        }
    }
}

static bool begin(search *self)
{
    const size_t count = self->mesh->view.facet_count;
    self->left = CLOD_MESH_OVERLAPS_STEPS + CLOD_MESH_OVERLAPS_STEPS_EACH * (uint64_t)count;
    self->centres = clod_memory_alloc(count, sizeof *self->centres);
    self->over = clod_memory_alloc(count, sizeof *self->over);
    self->joined = clod_memory_alloc(count, sizeof *self->joined);
    if (self->centres == NULL || self->over == NULL || self->joined == NULL) {
        return false;
    }
    for (uint32_t f = 0; f < count; f++) {
        clod_vec3_put(self->centres[f], clod_mesh_centre(self->mesh, f));
        self->over[f] = self->joined[f] = f;
    }
    if (!clod_mesh_points_init(&self->tree, (const double(*)[3])self->centres, self->joined,
                               count)) {
        return false;
    }
    widen(self);
    return true;
}

bool clod_mesh_overlaps_find(clod_mesh *self, clod_status *status)
{
    search all = {.mesh = self};
    const size_t count = self->view.facet_count;
    bool done = begin(&all);
    size_t place = 0;
    for (; done && place < count && all.left > 0; place++) {
        done = look_after(&all, place);
    }
    self->unsearched = count - place;
    for (uint32_t f = 0; done && f < count; f++) {
        if (all.over[f] != f) {
            clod_mesh_note_over(self, f, all.over[f]);
        }
    }
    clod_mesh_points_fini(&all.tree);
    clod_memory_free(all.centres);
    clod_memory_free(all.over);
    clod_memory_free(all.joined);
    return done || clod_mesh_lacks_memory(self, status);
}
