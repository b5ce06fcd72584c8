#include "mesh/surface_flush.h"

#include <math.h>

#define DEPTH 64 ///< more than the tree, which is cut in halves

/** Box about a triangle. */
typedef struct box {
    double low[3], high[3];
} box;

clod_surface_triangle clod_surface_triangle_of(const clod_surface *self, uint32_t facet)
{
    clod_surface_triangle made = {.sheet = (self->rims[facet] & CLOD_SURFACE_SHEET) != 0};
    for (int c = 0; c < 3; c++) {
        const double *at = self->vertex[self->facet[facet][c]];
        made.corner[c] = clod_vec3_of(at);
    }
    return made;
}

/** Twice the area times the normal. */
static clod_vec3 normal_of(const clod_surface_triangle *self)
{
    return clod_vec3_cross(clod_vec3_sub(self->corner[1], self->corner[0]),
                           clod_vec3_sub(self->corner[2], self->corner[0]));
}

/** Whether the corners of a triangle lie within the crack of the plane of another one. */
static bool lies_in(const clod_surface_triangle *self, const clod_surface_triangle *plane,
                    clod_vec3 normal, double crack)
{
    const double most = crack * crack * clod_vec3_dot(normal, normal);
    bool in = true;
    for (int c = 0; c < 3; c++) {
        const double height =
            clod_vec3_dot(clod_vec3_sub(self->corner[c], plane->corner[0]), normal);
        in = in && height * height <= most;
    }
    return in;
}

/** Where a triangle is along a direction. */
static void project(const clod_surface_triangle *self, clod_vec3 along, double *low,
                    double *high)
{
    *low = INFINITY;
    *high = -INFINITY;
    for (int c = 0; c < 3; c++) {
        const double at = clod_vec3_dot(self->corner[c], along);
        *low = fmin(*low, at);
        *high = fmax(*high, at);
    }
}

/** Whether no line along an edge parts two triangles of one plane by more than the crack. */
static bool meet(const clod_surface_triangle *a, const clod_surface_triangle *b,
                 clod_vec3 normal, double crack)
{
    for (int e = 0; e < 6; e++) {
        const clod_surface_triangle *of = e < 3 ? a : b;
        const clod_vec3 edge = clod_vec3_sub(of->corner[(e + 1) % 3], of->corner[e % 3]);
        const clod_vec3 across = clod_vec3_cross(normal, edge);
        double low[2], high[2];
        project(a, across, &low[0], &high[0]);
        project(b, across, &low[1], &high[1]);
        const double gap = fmax(low[0], low[1]) - fmin(high[0], high[1]);
        if (gap > crack * clod_vec3_length(across)) {
            return false;
        }
    }
    return true;
}

bool clod_surface_flush_are(const clod_surface_triangle *a, const clod_surface_triangle *b,
                            double crack)
{
    const clod_vec3 of_a = normal_of(a), of_b = normal_of(b);
    const double square_a = clod_vec3_dot(of_a, of_a), square_b = clod_vec3_dot(of_b, of_b);
    const double dot = clod_vec3_dot(of_a, of_b);
    const double cosine = CLOD_SURFACE_FLUSH_COSINE;
    return dot * dot > cosine * cosine * square_a * square_b &&
           (dot > 0.0 || a->sheet || b->sheet) &&
           (lies_in(a, b, of_b, crack) || lies_in(b, a, of_a, crack)) &&
           meet(a, b, square_a > square_b ? of_a : of_b, crack);
}

static box box_of(const clod_surface_triangle *self, double wider)
{
    box made;
    for (int a = 0; a < 3; a++) {
        double at[3][3];
        for (int c = 0; c < 3; c++) {
            clod_vec3_put(at[c], self->corner[c]);
        }
        made.low[a] = fmin(fmin(at[0][a], at[1][a]), at[2][a]) - wider;
        made.high[a] = fmax(fmax(at[0][a], at[1][a]), at[2][a]) + wider;
    }
    return made;
}

static bool is_apart(const box *self, const clod_surface_node *node)
{
    bool apart = false;
    for (int a = 0; a < 3; a++) {
        apart = apart || node->low[a] > self->high[a] || node->high[a] < self->low[a];
    }
    return apart;
}

bool clod_surface_flush_has(const clod_surface *self, const clod_surface_triangle *with,
                            clod_surface_flush *search)
{
    uint32_t waiting[DEPTH] = {0};
    int depth = 1;
    const box around = box_of(with, search->crack);
    while (depth > 0 && search->left > 0) {
        const clod_surface_node *node = &self->node[waiting[--depth]];
        search->left--;
        if (is_apart(&around, node)) {
            continue;
        }
        for (uint32_t k = node->first; k < node->first + node->count; k++) {
            const clod_surface_triangle own = clod_surface_triangle_of(self, self->leaf[k]);
            search->left -= search->left > 0;
            if (clod_surface_flush_are(&own, with, search->crack)) {
                return true;
            }
        }
        if (node->count == 0) {
            waiting[depth++] = node->first;
            waiting[depth++] = node->first + 1;
        }
    }
    return false;
}
