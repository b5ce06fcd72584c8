// The closest points of facets.
#include "mesh/surface_facet.h"

static clod_vec3 corner(const clod_surface *self, uint32_t facet, int c)
{
    return clod_vec3_of(self->vertex[self->facet[facet][c % 3]]);
}

/** Closest point of edge e of a facet; `end`: 0 it is its first corner, 1 its second, -1 none. */
static clod_vec3 on_edge(const clod_vec3 v[3], int e, clod_vec3 p, int *end)
{
    const clod_vec3 a = v[e], b = v[(e + 1) % 3];
    const clod_vec3 along = clod_vec3_sub(b, a);
    const double t = clod_vec3_dot(clod_vec3_sub(p, a), along);
    const double square = clod_vec3_dot(along, along);
    *end = t <= 0.0 ? 0 : t >= square ? 1 : -1;
    return *end == 0 ? a : *end == 1 ? b : clod_vec3_axpy(a, t / square, along);
}

/** Edges of a facet that hold a point of edge e: at a corner two. */
static uint8_t edges_at(int e, int end)
{
    const int other = end == 0 ? (e + 2) % 3 : end == 1 ? (e + 1) % 3 : e;
    return (uint8_t)(1 << e | 1 << other);
}

clod_surface_facet clod_surface_facet_of(const clod_surface *self, uint32_t number)
{
    const clod_surface_plane *plane = &self->planes[self->plane[number]];
    clod_surface_facet facet = {.surface = self,
                                .normal = plane->normal,
                                .point = plane->point,
                                .number = number,
                                .plane = self->plane[number],
                                .patch = self->patch[number],
                                .cylinder = plane->cylinder,
                                .rims = self->rims[number]};
    clod_vec3 *v = facet.corner;
    for (int c = 0; c < 3; c++) {
        v[c] = corner(self, number, c);
    }
    const clod_vec3 area =
        clod_vec3_cross(clod_vec3_sub(v[1], v[0]), clod_vec3_sub(v[2], v[0]));
    const double turn = clod_vec3_dot(area, plane->normal) < 0.0 ? -1.0 : 1.0;
    for (int e = 0; e < 3; e++) {
        const clod_vec3 along = clod_vec3_sub(v[(e + 1) % 3], v[e]);
        facet.inward[e] = clod_vec3_scale(clod_vec3_cross(plane->normal, along), turn);
        facet.square[e] = clod_vec3_dot(along, along);
    }
    return facet;
}

/** Closest point of the triangle of a facet. */
static clod_surface_closest of_triangle(const clod_surface_facet *facet, clod_vec3 p)
{
    const double height = clod_surface_facet_height(facet, p);
    const clod_vec3 side = clod_surface_facet_side(facet, height);
    const clod_vec3 foot = clod_vec3_axpy(p, -height, facet->normal);
    if (clod_surface_facet_holds(facet, foot)) {
        return (clod_surface_closest){fabs(height), foot, side, 0};
    }
    clod_surface_closest best = {INFINITY, foot, side, 0};
    for (int e = 0; e < 3; e++) {
        int end;
        const clod_vec3 at = on_edge(facet->corner, e, p, &end);
        const clod_vec3 away = clod_vec3_sub(p, at);
        const double distance = clod_vec3_length(away);
        if (distance < best.distance) {
            best.distance = distance;
            best.edges = edges_at(e, end);
            best.point = at;
            best.direction = distance > 0.0 ? clod_vec3_scale(away, 1.0 / distance) : side;
        }
    }
    best.distance = fmax(best.distance, fabs(height)); // corners may be off their plane
    return best;
}

/** What of a vector is across a cylinder's axis. */
static clod_vec3 across(const clod_surface_cylinder *self, clod_vec3 v)
{
    return clod_vec3_axpy(v, -clod_vec3_dot(v, self->axis), self->axis);
}

/** Sines of the angles by which a direction across the axis is beyond those of a facet's corners;
 *  whether it is between them. */
static bool is_between(const clod_surface_cylinder *self, const clod_vec3 v[3], clod_vec3 out,
                       double sine[3])
{
    for (int c = 0; c < 3; c++) {
        const clod_vec3 arm = across(self, clod_vec3_sub(v[c], self->point));
        sine[c] = clod_vec3_dot(clod_vec3_cross(arm, out), self->axis);
    }
    return fmin(sine[0], fmin(sine[1], sine[2])) <= 0.0 &&
           fmax(sine[0], fmax(sine[1], sine[2])) >= 0.0;
}

/** Closest point of the side of a facet that a direction is nearer to: an edge along the axis, or
 *  the corner where that of its other half ends. */
static clod_surface_closest of_side(const clod_vec3 v[3], const double sine[3], clod_vec3 p,
                                    clod_vec3 otherwise)
{
    const double least = fmin(fabs(sine[0]), fmin(fabs(sine[1]), fabs(sine[2])));
    const double most = fmax(fabs(sine[0]), fmax(fabs(sine[1]), fabs(sine[2])));
    int edge = 0, end = 0;
    clod_vec3 at = v[0];
    for (int c = 0; c < 3; c++) {
        const bool here = fabs(sine[c]) < 0.5 * (least + most);
        const bool next = fabs(sine[(c + 1) % 3]) < 0.5 * (least + most);
        const bool before = fabs(sine[(c + 2) % 3]) < 0.5 * (least + most);
        if (here && next) {
            edge = c;
            at = on_edge(v, c, p, &end);
        } else if (here && !before) {
            edge = c;
            end = 0;
            at = v[c];
        }
    }
    const clod_vec3 away = clod_vec3_sub(p, at);
    const double distance = clod_vec3_length(away);
    return (clod_surface_closest){
        distance, at, distance > 0.0 ? clod_vec3_scale(away, 1.0 / distance) : otherwise,
        edges_at(edge, end)};
}

/** Closest point of the piece of a cylinder that a facet stands for: at the place along the axis
 *  of that of the triangle. */
static clod_surface_closest of_cylinder(const clod_surface_cylinder *self, const clod_vec3 v[3],
                                        clod_vec3 p, clod_surface_closest flat)
{
    const clod_vec3 out = across(self, clod_vec3_sub(p, self->point));
    const double length = clod_vec3_length(out);
    double sine[3];
    if (length < 0.5 * self->radius) {
        return flat; // nothing that touches
    }
    if (!is_between(self, v, out, sine)) {
        return of_side(v, sine, p, flat.direction);
    }
    const double along = clod_vec3_dot(clod_vec3_sub(flat.point, self->point), self->axis);
    const clod_vec3 foot = clod_vec3_axpy(self->point, along, self->axis);
    const clod_vec3 point = clod_vec3_axpy(foot, self->radius / length, out);
    const clod_vec3 away = clod_vec3_sub(p, point);
    const double distance = clod_vec3_length(away);
    const clod_vec3 direction =
        distance > 0.0 ? clod_vec3_scale(away, 1.0 / distance) : flat.direction;
    return (clod_surface_closest){distance, point, direction, flat.edges};
}

clod_surface_closest clod_surface_facet_beside(const clod_surface *self,
                                               const clod_surface_facet *facet, clod_vec3 p)
{
    const clod_surface_closest flat = of_triangle(facet, p);
    return facet->cylinder == 0
               ? flat
               : of_cylinder(&self->cylinders[facet->cylinder - 1], facet->corner, p, flat);
}

clod_surface_closest clod_surface_closest_of(const clod_surface *self, uint32_t facet,
                                             clod_vec3 p)
{
    const clod_surface_facet made = clod_surface_facet_of(self, facet);
    return clod_surface_facet_closest(&made, p);
}

/** The nearest facet of a patch so far. */
typedef struct nearest {
    const clod_surface *surface;
    uint32_t patch;
    clod_vec3 from;
    clod_surface_closest at;
} nearest;

static double take_nearest(void *context, uint32_t facet, double reach)
{
    nearest *self = context;
    if (self->surface->patch[facet] == self->patch) {
        const clod_surface_closest at =
            clod_surface_closest_of(self->surface, facet, self->from);
        self->at = at.distance < self->at.distance ? at : self->at;
    }
    return self->at.distance < reach ? self->at.distance : reach;
}

clod_surface_closest clod_surface_patch_closest(const clod_surface *self, uint32_t patch,
                                                clod_vec3 p, double most)
{
    nearest best = {.surface = self,
                    .patch = patch,
                    .from = p,
                    .at = {INFINITY, p, self->patches[patch].axis[2], 0}};
    if (clod_surface_patch_box(self, patch, p) <= most) {
        clod_surface_near(self, p, most, take_nearest, &best);
    }
    return best.at;
}

#define ANY_PATCH UINT32_MAX

/** Whether a facet has been found. */
typedef struct any_facet {
    const clod_surface *surface;
    uint32_t patch; ///< of it, or ANY_PATCH
    clod_vec3 from;
    bool found;
} any_facet;

static double take_any(void *context, uint32_t facet, double reach)
{
    any_facet *self = context;
    const clod_surface *surface = self->surface;
    self->found = (self->patch == ANY_PATCH || self->patch == surface->patch[facet]) &&
                  clod_surface_closest_of(surface, facet, self->from).distance < reach;
    return self->found ? -1.0 : reach;
}

bool clod_surface_is_near(const clod_surface *self, clod_vec3 p, double reach)
{
    any_facet any = {.surface = self, .patch = ANY_PATCH, .from = p};
    clod_surface_near(self, p, reach, take_any, &any);
    return any.found;
}

bool clod_surface_patch_is_near(const clod_surface *self, uint32_t patch, clod_vec3 p,
                                double reach)
{
    any_facet any = {.surface = self, .patch = patch, .from = p};
    if (clod_surface_patch_box(self, patch, p) <= reach) {
        clod_surface_near(self, p, reach, take_any, &any);
    }
    return any.found;
}

bool clod_surface_facet_is_beyond_round(const clod_surface *self,
                                        const clod_surface_facet *facet, clod_vec3 p,
                                        double reach)
{
    // its closest points are along the axis and across it, in the plane, where its corners are,
    // and no farther from the plane than cylinders bulge
    const clod_vec3 axis = self->cylinders[facet->cylinder - 1].axis;
    const clod_vec3 across = clod_vec3_cross(axis, facet->normal);
    const clod_vec3 along[2] = {axis, across};
    const double most = reach + 2.0 * self->weld;
    const double off = fmax(fabs(clod_surface_facet_height(facet, p)) - self->bulge, 0.0);
    double square = off * off;
    for (int a = 0; a < 2; a++) {
        double low = INFINITY, high = -INFINITY;
        for (int c = 0; c < 3; c++) {
            const double at = clod_vec3_dot(clod_vec3_sub(facet->corner[c], p), along[a]);
            low = fmin(low, at);
            high = fmax(high, at);
        }
        const double gap = fmax(fmax(low, -high), 0.0);
        square += gap * gap;
    }
    return square > most * most;
}

bool clod_surface_facet_rim_is_near(const clod_surface_facet *self, clod_vec3 p, double reach)
{
    bool near = false;
    for (int e = 0; e < 3; e++) {
        int end;
        if ((self->rims >> e & 1) != 0) {
            const clod_vec3 away = clod_vec3_sub(p, on_edge(self->corner, e, p, &end));
            near = near || clod_vec3_dot(away, away) < reach * reach;
        }
    }
    return near;
}

/** Whether a rim of a patch has been found. */
typedef struct rim {
    const clod_surface *surface;
    uint32_t patch;
    clod_vec3 from;
    bool found;
} rim;

static double take_rim(void *context, uint32_t facet, double reach)
{
    rim *self = context;
    if (self->surface->patch[facet] == self->patch) {
        const clod_surface_facet made = clod_surface_facet_of(self->surface, facet);
        self->found = clod_surface_facet_rim_is_near(&made, self->from, reach);
    }
    return self->found ? -1.0 : reach;
}

bool clod_surface_rim_is_near(const clod_surface *self, uint32_t patch, clod_vec3 p,
                              double reach)
{
    rim any = {.surface = self, .patch = patch, .from = p};
    if (self->patches[patch].rims && clod_surface_patch_box(self, patch, p) <= reach) {
        clod_surface_near(self, p, reach, take_rim, &any);
    }
    return any.found;
}
