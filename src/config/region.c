#include "config/region.h"

#include <math.h>

static double length_of(const double *v)
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/** Unit vector along c = a x b. */
static void cross(const double *a, const double *b, double *c)
{
    for (int k = 0; k < 3; k++) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        c[k] = a[l] * b[m] - a[m] * b[l];
    }
    const double length = length_of(c);
    for (int k = 0; k < 3; k++) {
        c[k] /= length;
    }
}

void clod_region_axes(const clod_case_region *self, double axis[3][3])
{
    const double length = length_of(self->normal);
    const bool rectangle = self->kind == CLOD_REGION_RECTANGLE;
    int least = 0; // the coordinate axis that is farthest from the normal
    for (int k = 0; k < 3; k++) {
        axis[2][k] = self->normal[k] / length;
        least = fabs(self->normal[k]) < fabs(self->normal[least]) ? k : least;
    }
    double along[3] = {0.0, 0.0, 0.0};
    along[least] = 1.0;
    if (rectangle) {
        const double edge = length_of(self->edge_1);
        for (int k = 0; k < 3; k++) {
            axis[0][k] = self->edge_1[k] / edge;
        }
    } else {
        cross(along, axis[2], axis[0]);
    }
    cross(axis[2], axis[0], axis[1]);
}

void clod_region_half(const clod_case_region *self, double half[2])
{
    const bool rectangle = self->kind == CLOD_REGION_RECTANGLE;
    half[0] = rectangle ? 0.5 * length_of(self->edge_1) : self->outer_radius;
    half[1] = rectangle ? 0.5 * length_of(self->edge_2) : self->outer_radius;
}

double clod_region_area(const clod_case_region *self)
{
    const double inner = self->kind == CLOD_REGION_ANNULUS ? self->inner_radius : 0.0;
    switch (self->kind) {
    case CLOD_REGION_BOX:
        return (self->max[0] - self->min[0]) * (self->max[1] - self->min[1]);
    case CLOD_REGION_RECTANGLE:
        return length_of(self->edge_1) * length_of(self->edge_2);
    default:
        return M_PI * (self->outer_radius * self->outer_radius - inner * inner);
    }
}

/** Of a face: its own extent and the way of depth along its normal. */
static void face_bounds(const clod_case_region *self, double low[3], double high[3])
{
    double axis[3][3], half[2];
    clod_region_axes(self, axis);
    clod_region_half(self, half);
    for (int k = 0; k < 3; k++) {
        const double reach = self->kind == CLOD_REGION_DISC
                                 ? half[0] * sqrt(fmax(0.0, 1.0 - axis[2][k] * axis[2][k]))
                                 : half[0] * fabs(axis[0][k]) + half[1] * fabs(axis[1][k]);
        const double way = self->depth * axis[2][k];
        low[k] = self->center[k] - reach + fmin(way, 0.0);
        high[k] = self->center[k] + reach + fmax(way, 0.0);
    }
}

void clod_region_bounds(const clod_case_region *self, double low[3], double high[3])
{
    if (clod_region_is_face(self)) {
        face_bounds(self, low, high);
        return;
    }
    const bool box = self->kind == CLOD_REGION_BOX;
    for (int a = 0; a < 3; a++) {
        const double down = a < 2 ? self->outer_radius : 0.0;
        const double up = a < 2 ? self->outer_radius : self->height;
        low[a] = box ? self->min[a] : self->center[a] - down;
        high[a] = box ? self->max[a] : self->center[a] + up;
    }
}

/** Whether one of two annuli is in the hole of the other, or beside it. */
static bool annuli_apart(const clod_case_region *a, const clod_case_region *b)
{
    const double off = hypot(a->center[0] - b->center[0], a->center[1] - b->center[1]);
    return off >= a->outer_radius + b->outer_radius ||
           off + a->outer_radius <= b->inner_radius || off + b->outer_radius <= a->inner_radius;
}

bool clod_region_overlap(const clod_case_region *a, const clod_case_region *b)
{
    double low[2][3], high[2][3];
    clod_region_bounds(a, low[0], high[0]);
    clod_region_bounds(b, low[1], high[1]);
    for (int k = 0; k < 3; k++) {
        if (high[0][k] <= low[1][k] || high[1][k] <= low[0][k]) {
            return false;
        }
    }
    const bool annuli = a->kind == CLOD_REGION_ANNULUS && b->kind == CLOD_REGION_ANNULUS;
    return !annuli || !annuli_apart(a, b);
}
