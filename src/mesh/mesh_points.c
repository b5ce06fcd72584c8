#include "mesh/mesh_points.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/room.h"
#include "base/sort.h"
#include "base/vec3.h"

#define BITS 21  ///< of a coordinate in the key of the curve
#define DEPTH 64 ///< boxes that wait to be looked at; the tree has at most 24 levels

/** The bits of a number with two zeros between any two. */
static uint64_t spread(uint64_t bits)
{
    bits = (bits | bits << 32) & 0x001F00000000FFFFu;
    bits = (bits | bits << 16) & 0x001F0000FF0000FFu;
    bits = (bits | bits << 8) & 0x100F00F00F00F00Fu;
    bits = (bits | bits << 4) & 0x10C30C30C30C30C3u;
    return (bits | bits << 2) & 0x1249249249249249u;
}

void clod_mesh_points_grow(double box[2][3], const double low[3], const double high[3])
{
    for (int k = 0; k < 3; k++) {
        box[0][k] = fmin(box[0][k], low[k]);
        box[1][k] = fmax(box[1][k], high[k]);
    }
}

static void empty_box(double box[2][3])
{
    for (int k = 0; k < 3; k++) {
        box[0][k] = INFINITY;
        box[1][k] = -INFINITY;
    }
}

/** Put the points into the order of the curve. */
static bool sort_points(clod_mesh_points *self, const uint32_t *points)
{
    clod_sort_item *items = clod_memory_alloc(self->count, 2 * sizeof *items);
    if (items == NULL) {
        return false;
    }
    double all[2][3];
    empty_box(all);
    for (size_t k = 0; k < self->count; k++) {
        clod_mesh_points_grow(all, self->places[points[k]], self->places[points[k]]);
    }
    for (size_t k = 0; k < self->count; k++) {
        uint64_t key = 0;
        for (int c = 0; c < 3; c++) {
            const double size = all[1][c] - all[0][c];
            const double at =
                size > 0.0 ? (self->places[points[k]][c] - all[0][c]) / size : 0.0;
            key |= spread((uint64_t)(at * ((1 << BITS) - 1))) << c;
        }
        items[k] = (clod_sort_item){key, points[k]};
    }
    clod_sort(items, items + self->count, self->count);
    for (size_t k = 0; k < self->count; k++) {
        self->order[k] = (uint32_t)items[k].index;
    }
    clod_memory_free(items);
    return true;
}

static void make_boxes(clod_mesh_points *self)
{
    for (size_t n = self->nodes; n-- > 0;) {
        empty_box(self->boxes[n]);
        if (n >= self->leaves - 1) {
            const size_t from = (n - (self->leaves - 1)) * CLOD_MESH_POINTS_LEAF;
            for (size_t k = from; k < from + CLOD_MESH_POINTS_LEAF && k < self->count; k++) {
                const double *at = self->places[self->order[k]];
                clod_mesh_points_grow(self->boxes[n], at, at);
            }
            continue;
        }
        for (size_t below = 2 * n + 1; below <= 2 * n + 2; below++) {
            clod_mesh_points_grow(self->boxes[n], self->boxes[below][0], self->boxes[below][1]);
        }
    }
}

bool clod_mesh_points_init(clod_mesh_points *self, const double (*places)[3],
                           const uint32_t *points, size_t count)
{
    *self = (clod_mesh_points){.places = places, .count = count, .leaves = 1};
    while (self->leaves * CLOD_MESH_POINTS_LEAF < count) {
        self->leaves *= 2;
    }
    self->nodes = 2 * self->leaves - 1;
    self->order = clod_memory_alloc(count, sizeof *self->order);
    self->boxes = clod_memory_alloc(self->nodes, sizeof *self->boxes);
    if (self->order == NULL || self->boxes == NULL || !sort_points(self, points)) {
        return false;
    }
    make_boxes(self);
    return true;
}

void clod_mesh_points_fini(clod_mesh_points *self)
{
    clod_memory_free(self->order);
    clod_memory_free(self->boxes);
    *self = (clod_mesh_points){0};
}

// As fmin and fmax for numbers, without a call.
static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

/** Whether a segment passes a box that is larger by `reach` on all sides; no box of the tree's rest
 *  that has no points. */
static bool passes(double box[2][3], const double begin[3], const double end[3], double reach)
{
    double from = 0.0, to = 1.0;
    if (box[0][0] > box[1][0]) { // from infinity to minus infinity, which every line would pass
        return false;
    }
    for (int k = 0; k < 3; k++) {
        const double low = box[0][k] - reach - begin[k];
        const double high = box[1][k] + reach - begin[k];
        const double run = end[k] - begin[k];
        if (run == 0.0) {
            if (low > 0.0 || high < 0.0) {
                return false;
            }
            continue;
        }
        const double first = low / run, second = high / run;
        from = larger(from, smaller(first, second));
        to = smaller(to, larger(first, second));
    }
    return from <= to;
}

static bool add_hit(clod_mesh_hits *hits, uint32_t point, double along)
{
    if (!clod_room_for_one(&hits->items, &hits->room, hits->count, sizeof *hits->items)) {
        return false;
    }
    hits->items[hits->count++] = (clod_mesh_hit){point, along};
    return true;
}

/** Points of one leaf. */
static bool look(const clod_mesh_points *self, size_t leaf, const double begin[3],
                 const double end[3], double reach, clod_mesh_hits *hits)
{
    const clod_vec3 run = clod_vec3_sub(clod_vec3_of(end), clod_vec3_of(begin));
    const double length = clod_vec3_length(run);
    const clod_vec3 u = clod_vec3_scale(run, 1.0 / length);
    for (size_t k = leaf * CLOD_MESH_POINTS_LEAF;
         k < (leaf + 1) * CLOD_MESH_POINTS_LEAF && k < self->count; k++) {
        const clod_vec3 arm =
            clod_vec3_sub(clod_vec3_of(self->places[self->order[k]]), clod_vec3_of(begin));
        const double along = clod_vec3_dot(arm, u);
        if (along > reach && along < length - reach &&
            clod_vec3_length(clod_vec3_axpy(arm, -along, u)) <= reach &&
            !add_hit(hits, self->order[k], along)) {
            return false;
        }
    }
    return true;
}

static int compare(const void *left, const void *right)
{
    const clod_mesh_hit *a = left, *b = right;
    if (a->along != b->along) {
        return a->along < b->along ? -1 : 1;
    }
    return a->point < b->point ? -1 : a->point > b->point;
}

bool clod_mesh_points_near(const clod_mesh_points *self, const double begin[3],
                           const double end[3], double reach, clod_mesh_hits *hits)
{
    size_t waiting[DEPTH] = {0};
    size_t count = 1;
    hits->count = 0;
    while (count > 0) {
        const size_t node = waiting[--count];
        hits->boxes++;
        if (!passes(self->boxes[node], begin, end, reach)) {
            continue;
        }
        if (node < self->leaves - 1) {
            waiting[count++] = 2 * node + 1;
            waiting[count++] = 2 * node + 2;
        } else if (!look(self, node - (self->leaves - 1), begin, end, reach, hits)) {
            return false;
        }
    }
    if (hits->count > 1) {
        qsort(hits->items, hits->count, sizeof *hits->items, compare);
    }
    return true;
}
