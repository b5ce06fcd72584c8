#include "setup/region_prism.h"

#include <math.h>
#include <string.h>

#include "config/region.h"

/** What lies in a face is before none of it: of the margin of its other sides. */
#define FACE_END 0.01
/** Each of six sides adds a corner at most. */
#define MOST (CLOD_REGION_PRISM_CORNERS + 6)

clod_region_prism clod_region_prism_make(const clod_case_region *region, double radius)
{
    clod_region_prism self = {.axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    if (clod_region_is_face(region)) {
        double axis[3][3], half[2];
        clod_region_axes(region, axis);
        clod_region_half(region, half);
        const double way = region->depth + 2.0 * radius;
        for (int a = 0; a < 3; a++) {
            self.axis[a] = clod_vec3_of(axis[a]);
            self.half[a] = a < 2 ? half[a] : 0.5 * way;
        }
        self.middle = clod_vec3_axpy(clod_vec3_of(region->center), 0.5 * way, self.axis[2]);
        self.round = region->kind == CLOD_REGION_DISC;
        return self;
    }
    double low[3], high[3], middle[3];
    clod_region_bounds(region, low, high);
    for (int a = 0; a < 3; a++) {
        self.half[a] = 0.5 * (high[a] - low[a]);
        middle[a] = 0.5 * (low[a] + high[a]);
    }
    self.middle = clod_vec3_of(middle);
    self.round = clod_region_row(region)->upright;
    self.inner = self.round ? region->inner_radius : 0.0;
    return self;
}

bool clod_region_prism_shrink(const clod_case_region *region, double margin,
                              clod_region_prism *self)
{
    const bool face = clod_region_is_face(region);
    bool left = true;
    for (int a = 0; a < 3; a++) {
        self->half[a] -= face && a == 2 ? FACE_END * margin : margin;
        left = left && self->half[a] > 0.0;
    }
    self->inner += self->inner > 0.0 ? margin : 0.0;
    return left && (!self->round || self->inner < self->half[0]);
}

double clod_region_prism_extent(const clod_region_prism *self, clod_vec3 along)
{
    double part[3];
    for (int a = 0; a < 3; a++) {
        part[a] = fabs(clod_vec3_dot(self->axis[a], along));
    }
    const double across = self->round ? self->half[0] * sqrt(fmax(0.0, 1.0 - part[2] * part[2]))
                                      : self->half[0] * part[0] + self->half[1] * part[1];
    return across + self->half[2] * part[2];
}

/** Keep of a polygon what is within half the extent on one side; the number of its corners. */
static int clip(clod_vec3 *corner, int count, int axis, double sign, double half)
{
    clod_vec3 kept[MOST];
    int number = 0;
    for (int k = 0; k < count; k++) {
        const clod_vec3 a = corner[k], b = corner[(k + 1) % count];
        const double part[2] = {sign * (axis == 0   ? a.x
                                        : axis == 1 ? a.y
                                                    : a.z) -
                                    half,
                                sign * (axis == 0   ? b.x
                                        : axis == 1 ? b.y
                                                    : b.z) -
                                    half};
        if (part[0] <= 0.0) {
            kept[number++] = a;
        }
        if ((part[0] < 0.0 && part[1] > 0.0) || (part[0] > 0.0 && part[1] < 0.0)) {
            const double t = part[0] / (part[0] - part[1]);
            kept[number++] = clod_vec3_axpy(clod_vec3_scale(a, 1.0 - t), t, b);
        }
    }
    memcpy(corner, kept, (size_t)number * sizeof *corner);
    return number;
}

/** Corner of a polygon that is farthest from the axis. */
static clod_vec3 farthest(const clod_vec3 *corner, int count)
{
    clod_vec3 far = corner[0];
    for (int k = 1; k < count; k++) {
        far = hypot(corner[k].x, corner[k].y) > hypot(far.x, far.y) ? corner[k] : far;
    }
    return far;
}

/** Point of a convex polygon that is nearest to the axis. */
static clod_vec3 nearest(const clod_vec3 *corner, int count)
{
    clod_vec3 near = corner[0];
    double left = 0.0, right = 0.0;
    for (int k = 0; k < count; k++) {
        const clod_vec3 a = corner[k], side = clod_vec3_sub(corner[(k + 1) % count], a);
        const double square = side.x * side.x + side.y * side.y;
        const double t = square > 0.0 ? -(a.x * side.x + a.y * side.y) / square : 0.0;
        const clod_vec3 p = clod_vec3_axpy(a, fmin(fmax(t, 0.0), 1.0), side);
        near = hypot(p.x, p.y) < hypot(near.x, near.y) ? p : near;
        const double turn = side.x * a.y - side.y * a.x; // which side of the axis the edge is
        left = fmax(left, turn);
        right = fmin(right, turn);
    }
    if (left > 0.0 && right < 0.0) {
        return near;
    }
    // the axis goes through the polygon, unless it is seen edge-on
    return left - right > 0.0 ? (clod_vec3){0.0, 0.0, near.z} : near;
}

bool clod_region_prism_cut(const clod_region_prism *self, const clod_vec3 *corner, int count,
                           clod_vec3 *at)
{
    clod_vec3 left[MOST] = {{0.0, 0.0, 0.0}};
    for (int k = 0; k < count; k++) {
        const clod_vec3 r = clod_vec3_sub(corner[k], self->middle);
        left[k] = (clod_vec3){clod_vec3_dot(r, self->axis[0]), clod_vec3_dot(r, self->axis[1]),
                              clod_vec3_dot(r, self->axis[2])};
    }
    for (int a = self->round ? 2 : 0; a < 3 && count > 0; a++) {
        count = clip(left, count, a, 1.0, self->half[a]);
        count = count > 0 ? clip(left, count, a, -1.0, self->half[a]) : 0;
    }
    if (count == 0) {
        return false;
    }
    clod_vec3 point = {0.0, 0.0, 0.0};
    if (self->round) {
        const clod_vec3 near = nearest(left, count), far = farthest(left, count);
        if (hypot(near.x, near.y) >= self->half[0] || hypot(far.x, far.y) <= self->inner) {
            return false;
        }
        point = hypot(near.x, near.y) >= self->inner ? near : far;
    } else {
        for (int k = 0; k < count; k++) {
            point = clod_vec3_axpy(point, 1.0 / count, left[k]);
        }
    }
    *at = clod_vec3_axpy(self->middle, point.x, self->axis[0]);
    *at = clod_vec3_axpy(*at, point.y, self->axis[1]);
    *at = clod_vec3_axpy(*at, point.z, self->axis[2]);
    return true;
}
