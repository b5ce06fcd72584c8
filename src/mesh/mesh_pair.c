#include "mesh/mesh_pair.h"

#include <math.h>

/** Where the corners of a facet are, seen from the plane of another one. */
typedef struct stand {
    double height[3]; ///< times the length of the plane's normal
    int side[3];      ///< -1 below, 1 above, 0 within the weld distance
    int below, above; ///< how many corners
} stand;

static stand stand_of(const clod_mesh *mesh, const clod_mesh_pair_facet *self,
                      const clod_mesh_pair_facet *plane)
{
    const double most = mesh->weld * mesh->weld * plane->square;
    stand found = {.below = 0};
    for (int c = 0; c < 3; c++) {
        const clod_vec3 arm = clod_vec3_sub(self->corner[c], plane->corner[0]);
        const double height = clod_vec3_dot(arm, plane->normal);
        found.height[c] = height;
        found.side[c] = height * height <= most ? 0 : height < 0.0 ? -1 : 1;
        found.below += found.side[c] < 0;
        found.above += found.side[c] > 0;
    }
    return found;
}

/** Whether it has corners on both sides. */
static bool is_cut(const stand *self)
{
    return self->below > 0 && self->above > 0;
}

/** The edge of a facet that lies in the plane while the third corner does not; 3 = none. */
static int edge_in_plane(const stand *self)
{
    int edge = 3;
    for (int e = 0; e < 3; e++) {
        if (self->side[e] == 0 && self->side[(e + 1) % 3] == 0) {
            edge = e;
        }
    }
    return edge;
}

// ---- over each other

/** Whether the corners of a facet lie in the plane of another one. */
static bool lies_in(const clod_mesh *mesh, const clod_mesh_pair_facet *self,
                    const clod_mesh_pair_facet *plane)
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
static void project(const clod_mesh_pair_facet *self, clod_vec3 along, double *low,
                    double *high)
{
    const double x = clod_vec3_dot(self->corner[0], along);
    const double y = clod_vec3_dot(self->corner[1], along);
    const double z = clod_vec3_dot(self->corner[2], along);
    *low = clod_mesh_pair_least(x, y, z);
    *high = clod_mesh_pair_most(x, y, z);
}

/** Whether no line along an edge parts two facets of one plane: then they have an area in common
 *  that is wider than `least` across every edge. */
static bool has_common_area(const clod_mesh_pair_facet *a, const clod_mesh_pair_facet *b,
                            double least)
{
    const clod_vec3 normal = a->square >= b->square ? a->normal : b->normal;
    for (int e = 0; e < 6; e++) {
        const clod_mesh_pair_facet *of = e < 3 ? a : b;
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

// ---- through each other

/** Whether the surface goes on beyond the plane over an edge that lies in it. */
static bool goes_on(const clod_mesh *mesh, const clod_mesh_pair_facet *self, const stand *own,
                    int edge, const clod_mesh_pair_facet *plane)
{
    const uint32_t other = mesh->neighbours[self->number][edge];
    if (other == CLOD_MESH_NONE) {
        return false;
    }
    clod_mesh_pair_facet beyond;
    clod_mesh_pair_corners(mesh, other, &beyond);
    const stand far = stand_of(mesh, &beyond, plane);
    return own->above > 0 ? far.below > 0 : far.above > 0;
}

/** Where a facet is cut by a plane: the ends of the segment. It has corners on both sides, or an
 *  edge in the plane. */
static void cut(const clod_mesh_pair_facet *self, const stand *own, clod_vec3 ends[2])
{
    int count = 0;
    for (int e = 0; e < 3 && count < 2; e++) {
        const int to = (e + 1) % 3;
        if (own->side[e] == 0) {
            ends[count++] = self->corner[e];
        } else if (own->side[e] * own->side[to] < 0) {
            const double share = own->height[e] / (own->height[e] - own->height[to]);
            const clod_vec3 edge = clod_vec3_sub(self->corner[to], self->corner[e]);
            ends[count++] = clod_vec3_axpy(self->corner[e], share, edge);
        }
    }
}

/** Whether two cuts, which lie on one line, have a segment in common that is longer than `least`;
 *  its middle and its direction. */
static bool has_common_segment(const clod_vec3 a[2], const clod_vec3 b[2], double least,
                               clod_vec3 *middle, clod_vec3 *direction)
{
    const clod_vec3 run = clod_vec3_sub(a[1], a[0]);
    const double length = clod_vec3_length(run);
    if (length <= least) {
        return false;
    }
    const clod_vec3 along = clod_vec3_scale(run, 1.0 / length);
    const double p = clod_vec3_dot(clod_vec3_sub(b[0], a[0]), along);
    const double q = clod_vec3_dot(clod_vec3_sub(b[1], a[0]), along);
    const double low = fmax(0.0, fmin(p, q)), high = fmin(length, fmax(p, q));
    *middle = clod_vec3_axpy(a[0], 0.5 * (low + high), along);
    *direction = along;
    return high - low > least;
}

/** Whether a facet goes on from a point of its cut by a plane to more than `least` off the plane, to
 *  each side, or to the one where it lies if an edge is in the plane. Heights of corners do not tell: those
 *  of a needle may lie far from the other facet, whose plane rounding tilts. */
static bool reaches(const clod_mesh_pair_facet *self, const stand *own,
                    const clod_mesh_pair_facet *plane, const clod_vec3 cut_at[2], double least)
{
    const clod_vec3 way = clod_vec3_cross(self->normal, cut_at[1]); // across the cut
    double far[2] = {INFINITY, INFINITY};                           // along it, to both sides
    for (int e = 0; e < 3; e++) {
        const clod_vec3 edge = clod_vec3_sub(self->corner[(e + 1) % 3], self->corner[e]);
        const clod_vec3 outwards = clod_vec3_cross(edge, self->normal);
        const clod_vec3 arm = clod_vec3_sub(self->corner[e], cut_at[0]);
        const double slope = clod_vec3_dot(way, outwards);
        if (slope != 0.0) {
            const double until = clod_vec3_dot(arm, outwards) / slope;
            far[slope < 0.0] = fmin(far[slope < 0.0], fabs(until));
        }
    }
    const double rise = clod_vec3_dot(way, plane->normal); // times the length of the normal
    const double most = least * least * plane->square;
    const bool has[2] = {own->above > 0, own->below > 0};
    for (int side = 0; side < 2; side++) {
        const double height = far[(side == 1) != (rise < 0.0)] * rise;
        if (has[side] && height * height <= most) {
            return false;
        }
    }
    return true;
}

static bool cross(const clod_mesh *mesh, const clod_mesh_pair_facet *a, const stand *of_a,
                  const clod_mesh_pair_facet *b, const stand *of_b, clod_vec3 *at)
{
    clod_vec3 cuts[2][2];
    cut(a, of_a, cuts[0]);
    cut(b, of_b, cuts[1]);
    clod_vec3 middle[2]; // of the common segment, and its direction
    if (!has_common_segment((const clod_vec3 *)cuts[0], (const clod_vec3 *)cuts[1], mesh->weld,
                            &middle[0], &middle[1]) ||
        !reaches(a, of_a, b, middle, mesh->weld) || !reaches(b, of_b, a, middle, mesh->weld)) {
        return false;
    }
    *at = middle[0];
    const int edges[2] = {edge_in_plane(of_a), edge_in_plane(of_b)};
    return (edges[0] == 3 || goes_on(mesh, a, of_a, edges[0], b)) &&
           (edges[1] == 3 || goes_on(mesh, b, of_b, edges[1], a));
}

clod_mesh_pair clod_mesh_pair_of(const clod_mesh *mesh, const clod_mesh_pair_facet *a,
                                 const clod_mesh_pair_facet *b, clod_vec3 *at)
{
    if (lies_in(mesh, a, b) || lies_in(mesh, b, a)) {
        return has_common_area(a, b, 2.0 * mesh->weld) ? CLOD_MESH_PAIR_OVER
                                                       : CLOD_MESH_PAIR_APART;
    }
    const stand of_a = stand_of(mesh, a, b), of_b = stand_of(mesh, b, a);
    const bool cut_a = is_cut(&of_a), cut_b = is_cut(&of_b);
    const bool both = (cut_a && cut_b) || (cut_a && edge_in_plane(&of_b) < 3) ||
                      (cut_b && edge_in_plane(&of_a) < 3);
    return both && cross(mesh, a, &of_a, b, &of_b, at) ? CLOD_MESH_PAIR_CROSSING
                                                       : CLOD_MESH_PAIR_APART;
}
