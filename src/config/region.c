#include "config/region.h"

#include <math.h>
#include <string.h>

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

// ---- box

static double area_of_box(const clod_case_region *self)
{
    return (self->max[0] - self->min[0]) * (self->max[1] - self->min[1]);
}

static double top_of_box(const clod_case_region *self)
{
    return self->max[2];
}

static void size_of_box(const clod_case_region *self, double size[3])
{
    for (int a = 0; a < 3; a++) {
        size[a] = self->max[a] - self->min[a];
    }
}

static void bounds_of_box(const clod_case_region *self, double low[3], double high[3])
{
    memcpy(low, self->min, sizeof self->min);
    memcpy(high, self->max, sizeof self->max);
}

static clod_region_fault fault_of_box(const clod_case_region *self)
{
    const double *low = self->min, *high = self->max;
    if (low[0] < high[0] && low[1] < high[1] && low[2] < high[2]) {
        return (clod_region_fault){0};
    }
    return (clod_region_fault){"box.max", "must be larger than min in x, y and z"};
}

// ---- annulus

static double area_of_annulus(const clod_case_region *self)
{
    const double inner = self->inner_radius;
    return M_PI * (self->outer_radius * self->outer_radius - inner * inner);
}

static double top_of_annulus(const clod_case_region *self)
{
    return self->center[2] + self->height;
}

static void size_of_annulus(const clod_case_region *self, double size[3])
{
    size[0] = size[1] = 2.0 * self->outer_radius;
    size[2] = self->height;
}

static void bounds_of_annulus(const clod_case_region *self, double low[3], double high[3])
{
    for (int a = 0; a < 2; a++) {
        low[a] = self->center[a] - self->outer_radius;
        high[a] = self->center[a] + self->outer_radius;
    }
    low[2] = self->center[2];
    high[2] = top_of_annulus(self);
}

static clod_region_fault fault_of_annulus(const clod_case_region *self)
{
    if (self->inner_radius < self->outer_radius) {
        return (clod_region_fault){0};
    }
    return (clod_region_fault){"annulus.inner_radius", "must be smaller than outer_radius"};
}

// ---- faces

static double top_of_face(const clod_case_region *self)
{
    return self->center[2];
}

/** A face that reaches so far to both sides along x, y and z, and its way of depth. */
static void bounds_of_face(const clod_case_region *self, const double normal[3],
                           const double reach[3], double low[3], double high[3])
{
    for (int k = 0; k < 3; k++) {
        const double way = self->depth * normal[k];
        low[k] = self->center[k] - reach[k] + fmin(way, 0.0);
        high[k] = self->center[k] + reach[k] + fmax(way, 0.0);
    }
}

static double area_of_disc(const clod_case_region *self)
{
    return M_PI * (self->outer_radius * self->outer_radius);
}

static void bounds_of_disc(const clod_case_region *self, double low[3], double high[3])
{
    double axis[3][3], reach[3];
    clod_region_axes(self, axis);
    for (int k = 0; k < 3; k++) {
        reach[k] = self->outer_radius * sqrt(fmax(0.0, 1.0 - axis[2][k] * axis[2][k]));
    }
    bounds_of_face(self, axis[2], reach, low, high);
}

/** Any direction will do: across the coordinate axis that is farthest from the normal. */
static void axis_of_disc(const clod_case_region *self, const double normal[3], double axis[3])
{
    int least = 0;
    for (int k = 0; k < 3; k++) {
        least = fabs(self->normal[k]) < fabs(self->normal[least]) ? k : least;
    }
    double along[3] = {0.0, 0.0, 0.0};
    along[least] = 1.0;
    cross(along, normal, axis);
}

static void half_of_disc(const clod_case_region *self, double half[2])
{
    half[0] = half[1] = self->outer_radius;
}

static double area_of_rectangle(const clod_case_region *self)
{
    return length_of(self->edge_1) * length_of(self->edge_2);
}

static void half_of_rectangle(const clod_case_region *self, double half[2])
{
    half[0] = 0.5 * length_of(self->edge_1);
    half[1] = 0.5 * length_of(self->edge_2);
}

static void bounds_of_rectangle(const clod_case_region *self, double low[3], double high[3])
{
    double axis[3][3], half[2], reach[3];
    clod_region_axes(self, axis);
    half_of_rectangle(self, half);
    for (int k = 0; k < 3; k++) {
        reach[k] = half[0] * fabs(axis[0][k]) + half[1] * fabs(axis[1][k]);
    }
    bounds_of_face(self, axis[2], reach, low, high);
}

static void axis_of_rectangle(const clod_case_region *self, const double normal[3],
                              double axis[3])
{
    (void)normal;
    const double edge = length_of(self->edge_1);
    for (int k = 0; k < 3; k++) {
        axis[k] = self->edge_1[k] / edge;
    }
}

static const clod_region_kind_row REGIONS[] = {
    [CLOD_REGION_BOX] = {.name = "box",
                         .area = area_of_box,
                         .top = top_of_box,
                         .size = size_of_box,
                         .bounds = bounds_of_box,
                         .fault = fault_of_box},
    [CLOD_REGION_ANNULUS] = {.name = "annulus",
                             .upright = true,
                             .area = area_of_annulus,
                             .top = top_of_annulus,
                             .size = size_of_annulus,
                             .bounds = bounds_of_annulus,
                             .fault = fault_of_annulus},
    [CLOD_REGION_DISC] = {.name = "disc",
                          .face = true,
                          .area = area_of_disc,
                          .top = top_of_face,
                          .bounds = bounds_of_disc,
                          .axis = axis_of_disc,
                          .half = half_of_disc},
    [CLOD_REGION_RECTANGLE] = {.name = "rectangle",
                               .face = true,
                               .area = area_of_rectangle,
                               .top = top_of_face,
                               .bounds = bounds_of_rectangle,
                               .axis = axis_of_rectangle,
                               .half = half_of_rectangle},
};

const clod_region_kind_row *clod_region_row(const clod_case_region *self)
{
    return &REGIONS[self->kind];
}

bool clod_region_is_face(const clod_case_region *self)
{
    return clod_region_row(self)->face;
}

double clod_region_height(const clod_case_region *self)
{
    double size[3] = {0.0, 0.0, self->depth};
    if (!clod_region_is_face(self)) {
        clod_region_row(self)->size(self, size);
    }
    return size[2];
}

void clod_region_axes(const clod_case_region *self, double axis[3][3])
{
    const double length = length_of(self->normal);
    for (int k = 0; k < 3; k++) {
        axis[2][k] = self->normal[k] / length;
    }
    clod_region_row(self)->axis(self, axis[2], axis[0]);
    cross(axis[2], axis[0], axis[1]);
}

void clod_region_half(const clod_case_region *self, double half[2])
{
    clod_region_row(self)->half(self, half);
}

double clod_region_area(const clod_case_region *self)
{
    return clod_region_row(self)->area(self);
}

void clod_region_bounds(const clod_case_region *self, double low[3], double high[3])
{
    clod_region_row(self)->bounds(self, low, high);
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
    const bool annuli = clod_region_row(a)->upright && clod_region_row(b)->upright;
    return !annuli || !annuli_apart(a, b);
}
