#include "mesh/surface_tree.h"

#include <math.h>

#include "base/memory.h"
#include "base/sort.h"
#include "mesh/surface_facet.h"

#define LEAF 4   ///< facets of a leaf
#define DEPTH 64 ///< more than the tree, which is cut in halves
#define BITS 21  ///< of each coordinate in a key

/** Box about facets of the order. */
static void surround(const clod_surface *self, clod_surface_node *node)
{
    for (int a = 0; a < 3; a++) {
        node->low[a] = INFINITY;
        node->high[a] = -INFINITY;
        for (uint32_t k = node->first; k < node->first + node->count; k++) {
            for (int c = 0; c < 3; c++) {
                const double x = self->vertex[self->facet[self->leaf[k]][c]][a];
                node->low[a] = fmin(node->low[a], x);
                node->high[a] = fmax(node->high[a], x);
            }
        }
    }
}

/** Place of a facet's centroid along a curve that fills a box and stays near where it is: the
 *  bits of its coordinates in turn (Morton, 1966). */
static uint64_t place_of(const clod_surface *self, uint32_t facet, const clod_surface_node *box)
{
    uint64_t key = 0;
    for (int a = 0; a < 3; a++) {
        double middle = 0.0;
        for (int c = 0; c < 3; c++) {
            middle += self->vertex[self->facet[facet][c]][a] / 3.0;
        }
        const double size = box->high[a] - box->low[a];
        const double share = size > 0.0 ? (middle - box->low[a]) / size : 0.0;
        const double most = (double)(1 << BITS) - 1.0;
        const uint64_t at = (uint64_t)fmin(fmax(share * most, 0.0), most);
        for (int b = 0; b < BITS; b++) {
            key |= (at >> b & 1) << (3 * b + a);
        }
    }
    return key;
}

/** Facets along the curve; false without memory. */
static bool order(clod_surface *self, const clod_surface_node *box)
{
    clod_sort_item *items = clod_memory_alloc(2 * self->facet_count + 1, sizeof *items);
    if (items == NULL) {
        return false;
    }
    for (size_t f = 0; f < self->facet_count; f++) {
        items[f] = (clod_sort_item){place_of(self, (uint32_t)f, box), f};
    }
    clod_sort(items, items + self->facet_count, self->facet_count);
    for (size_t f = 0; f < self->facet_count; f++) {
        self->leaf[f] = (uint32_t)items[f].index;
    }
    clod_memory_free(items);
    return true;
}

bool clod_surface_tree_make(clod_surface *self)
{
    const uint32_t facets = (uint32_t)self->facet_count;
    self->leaf = clod_memory_alloc((size_t)facets + 1, sizeof *self->leaf);
    self->node = clod_memory_alloc((size_t)facets + 2, sizeof *self->node);
    if (self->leaf == NULL || self->node == NULL) {
        return false;
    }
    for (uint32_t f = 0; f < facets; f++) {
        self->leaf[f] = f;
    }
    self->node[0] = (clod_surface_node){.count = facets};
    surround(self, &self->node[0]);
    if (!order(self, &self->node[0])) {
        return false;
    }
    uint32_t nodes = 1;
    for (uint32_t n = 0; n < nodes; n++) {
        clod_surface_node *node = &self->node[n];
        surround(self, node);
        if (node->count > LEAF) {
            const uint32_t half = node->count / 2;
            self->node[nodes] = (clod_surface_node){.first = node->first, .count = half};
            self->node[nodes + 1] =
                (clod_surface_node){.first = node->first + half, .count = node->count - half};
            node->first = nodes;
            node->count = 0;
            nodes += 2;
        }
    }
    return true;
}

/** Whether the box about a facet is farther from p than `reach`. */
static bool is_far(const clod_surface *self, uint32_t facet, clod_vec3 p, double reach)
{
    const double *a = self->vertex[self->facet[facet][0]];
    const double *b = self->vertex[self->facet[facet][1]];
    const double *c = self->vertex[self->facet[facet][2]];
    const double at[3] = {p.x, p.y, p.z};
    double square = 0.0;
    for (int k = 0; k < 3; k++) {
        const double least = a[k] < b[k] ? a[k] : b[k], most = a[k] < b[k] ? b[k] : a[k];
        const double low = least < c[k] ? least : c[k], high = most < c[k] ? c[k] : most;
        const double below = low - at[k], above = at[k] - high;
        const double out = below > above ? below : above;
        square += out > 0.0 ? out * out : 0.0;
    }
    return square > reach * reach;
}

/** Squared distance of a point from the box of a node [m2]. */
static double square_from(const clod_surface_node *node, clod_vec3 p)
{
    const double at[3] = {p.x, p.y, p.z};
    double square = 0.0;
    for (int a = 0; a < 3; a++) {
        const double below = node->low[a] - at[a], above = at[a] - node->high[a];
        const double out = below > above ? below : above;
        square += out > 0.0 ? out * out : 0.0;
    }
    return square;
}

bool clod_surface_facet_box_is_far(const clod_surface *self, uint32_t number, clod_vec3 p,
                                   double reach)
{
    return is_far(self, number, p, reach + self->bulge);
}

void clod_surface_near(const clod_surface *self, clod_vec3 p, double reach,
                       clod_surface_take take, void *context)
{
    struct {
        uint32_t node;
        double square;
    } stack[DEPTH];
    int depth = 0;
    stack[depth].node = 0;
    stack[depth++].square = square_from(&self->node[0], p);
    while (depth > 0 && reach >= 0.0) {
        depth--;
        const clod_surface_node *node = &self->node[stack[depth].node];
        const double most = reach + self->bulge;
        if (stack[depth].square > most * most) {
            continue;
        }
        for (uint32_t k = node->first; k < node->first + node->count && reach >= 0.0; k++) {
            if (!is_far(self, self->leaf[k], p, reach + self->bulge)) {
                reach = take(context, self->leaf[k], reach);
            }
        }
        if (node->count == 0) {
            const clod_surface_node *child = &self->node[node->first];
            const double first = square_from(&child[0], p);
            const double second = square_from(&child[1], p);
            const uint32_t far = second < first ? 0 : 1; // looked at last
            stack[depth].node = node->first + far;
            stack[depth++].square = far == 0 ? first : second;
            stack[depth].node = node->first + 1 - far;
            stack[depth++].square = far == 0 ? second : first;
        }
    }
}
