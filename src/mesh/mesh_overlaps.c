#include "mesh/mesh_overlaps.h"

#include <math.h>

#include "base/memory.h"
#include "base/room.h"
#include "mesh/mesh_pair.h"
#include "mesh/mesh_points.h"

#define DEPTH 64 ///< boxes that wait to be looked at; the tree has at most 24 levels

/** A search. Facets are in the order in which their centres lie along a curve. */
typedef struct search {
    clod_mesh *mesh;
    clod_mesh_points tree; ///< of centres; its boxes are made wider, to hold the facets
    double (*centres)[3];  ///< [facet_count]
    uint32_t *over;    ///< [facet_count] the earliest facet under this one, or its own number
    uint32_t *through; ///< [facet_count] the earliest that crosses this one, or its own number
    uint32_t *joined;  ///< [facet_count] another facet of the same group, or itself
    size_t room;
    uint64_t left; ///< steps
} search;

/** Whether boxes, the second one from `low` to `high`, have no point in common. */
static bool is_apart(const clod_mesh_pair_facet *self, const double low[3],
                     const double high[3])
{
    return low[0] > self->high[0] || high[0] < self->low[0] || low[1] > self->high[1] ||
           high[1] < self->low[1] || low[2] > self->high[2] || high[2] < self->low[2];
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

/** Record that two facets cross. */
static void record_crossing(search *self, uint32_t a, uint32_t b)
{
    self->through[a] = b < self->through[a] || self->through[a] == a ? b : self->through[a];
    self->through[b] = a < self->through[b] || self->through[b] == b ? a : self->through[b];
}

/** Record that two facets lie over each other; false without memory. */
static bool record_over(search *self, uint32_t a, uint32_t b)
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
static bool look(search *self, const clod_mesh_pair_facet *own, size_t place, size_t from)
{
    const clod_mesh_points *tree = &self->tree;
    for (size_t k = from; k < from + CLOD_MESH_POINTS_LEAF && k < tree->count; k++) {
        clod_mesh_pair_facet other;
        if (k <= place) {
            continue;
        }
        clod_mesh_pair_corners(self->mesh, tree->order[k], &other);
        if (is_apart(own, other.low, other.high)) {
            continue;
        }
        clod_mesh_pair_plane(&other);
        clod_vec3 at;
        const clod_mesh_pair pair = clod_mesh_pair_of(self->mesh, own, &other, &at);
        if (pair == CLOD_MESH_PAIR_CROSSING) {
            record_crossing(self, own->number, other.number);
        }
        if (pair == CLOD_MESH_PAIR_OVER && !record_over(self, own->number, other.number)) {
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
    clod_mesh_pair_facet own;
    clod_mesh_pair_corners(self->mesh, tree->order[place], &own);
    clod_mesh_pair_plane(&own);
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
            clod_mesh_pair_facet own;
            clod_mesh_pair_corners(self->mesh, tree->order[k], &own);
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
    self->through = clod_memory_alloc(count, sizeof *self->through);
    self->joined = clod_memory_alloc(count, sizeof *self->joined);
    if (self->centres == NULL || self->over == NULL || self->through == NULL ||
        self->joined == NULL) {
        return false;
    }
    for (uint32_t f = 0; f < count; f++) {
        clod_vec3_put(self->centres[f], clod_mesh_centre(self->mesh, f));
        self->over[f] = self->through[f] = self->joined[f] = f;
    }
    if (!clod_mesh_points_init(&self->tree, (const double(*)[3])self->centres, self->joined,
                               count)) {
        return false;
    }
    widen(self);
    return true;
}

/** Note what was found, in the order of the file. */
static void note_all(const search *self)
{
    clod_mesh *mesh = self->mesh;
    for (uint32_t f = 0; f < mesh->view.facet_count; f++) {
        const uint32_t over = self->over[f], through = self->through[f];
        if (over != f) {
            clod_mesh_note_pair(mesh, CLOD_MESH_OVERLAP, f, over, clod_mesh_centre(mesh, f));
            mesh->found[over] = (uint16_t)(mesh->found[over] | 1u << CLOD_MESH_OVERLAP);
        }
        if (through != f) {
            clod_mesh_pair_facet own, other;
            clod_mesh_pair_corners(mesh, f, &own);
            clod_mesh_pair_corners(mesh, through, &other);
            clod_mesh_pair_plane(&own);
            clod_mesh_pair_plane(&other);
            clod_vec3 at = clod_mesh_centre(mesh, f);
            (void)clod_mesh_pair_of(mesh, &own, &other, &at);
            clod_mesh_note_pair(mesh, CLOD_MESH_CROSSING, f, through, at);
        }
    }
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
    if (done) {
        note_all(&all);
    }
    clod_mesh_points_fini(&all.tree);
    clod_memory_free(all.centres);
    clod_memory_free(all.over);
    clod_memory_free(all.through);
    clod_memory_free(all.joined);
    return done || clod_mesh_lacks_memory(self, status);
}
