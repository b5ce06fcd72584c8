#include "setup/domain.h"

#include <math.h>
#include <string.h>

#include "config/region.h"
#include "setup/planes.h"

/** Half extent of a shape along x, y or z, about the middle of it [m]. */
static double half_extent(const clod_shape *shape, int axis)
{
    double e[3]; // component of the shape's axes along the direction asked for
    for (int a = 0; a < 3; a++) {
        const double v[3] = {shape->axis[a].x, shape->axis[a].y, shape->axis[a].z};
        e[a] = fabs(v[axis]);
    }
    if (clod_shape_kinds_row(shape->kind)->boxed) {
        return e[0] * shape->half[0] + e[1] * shape->half[1] + e[2] * shape->half[2];
    } // half[2] is 0 for discs and annuli
    return fmax(shape->inner, shape->outer) * sqrt(fmax(0.0, 1.0 - e[2] * e[2])) +
           e[2] * shape->half[2];
}

static void include(double x, double reach, double *low, double *high)
{
    *low = fmin(*low, x - reach);
    *high = fmax(*high, x + reach);
}

bool clod_setup_domain_add_wall(const clod_wall *wall, double low[3], double high[3])
{
    bool bounded = true;
    for (int32_t s = 0; s < wall->shape_count; s++) {
        const clod_shape *shape = &wall->shapes[s];
        const clod_shape_kind_row *kind = clod_shape_kinds_row(shape->kind);
        if (kind->endless) {
            bounded = false;
            continue;
        }
        clod_vec3 middle = shape->center;
        if (kind->shell) {
            middle = clod_vec3_axpy(middle, shape->half[2], shape->axis[2]);
        }
        const double at[3] = {middle.x, middle.y, middle.z};
        for (int a = 0; a < 3; a++) {
            include(at[a], half_extent(shape, a), &low[a], &high[a]);
        }
    }
    return bounded;
}

bool clod_setup_bounds_around(const clod_walls *walls, double low[3], double high[3])
{
    for (int32_t w = 0; w < walls->count; w++) {
        (void)clod_setup_domain_add_wall(&walls->wall[w], low, high);
    }
    return low[0] <= high[0];
}

bool clod_setup_bounds(const clod_state *state, double low[3], double high[3])
{
    for (int a = 0; a < 3; a++) {
        low[a] = HUGE_VAL;
        high[a] = -HUGE_VAL;
    }
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *place = state->grains.position[g];
        for (int a = 0; a < 3; a++) {
            include(place[a], place[3], &low[a], &high[a]);
        }
    }
    return clod_setup_bounds_around(&state->walls, low, high);
}

clod_outlet clod_setup_domain_region(const clod_case_region *from)
{
    clod_outlet self = {0};
    clod_region_bounds(from, self.low, self.high);
    if (clod_region_row(from)->upright) {
        memcpy(self.middle, from->center, sizeof self.middle);
        self.inner = from->inner_radius;
        self.outer = from->outer_radius;
    }
    return self;
}

static void make_outlets(const clod_case *from, clod_domain *domain)
{
    domain->outlets = (int32_t)from->outlet_count; // checked at load
    for (int32_t k = 0; k < domain->outlets; k++) {
        domain->outlet[k] = from->outlets[k].has_region
                                ? clod_setup_domain_region(&from->outlets[k].region)
                                : (clod_outlet){.low = {1.0}, .high = {-1.0}}; // holds no point
    }
}

/** Extent of the domain, and what happens at its sides. */
static void find_space(const clod_case *from, const double low[3], const double high[3],
                       clod_state *state)
{
    clod_domain *domain = &state->domain;
    memcpy(domain->periodic, from->periodic, sizeof domain->periodic);
    domain->removes = from->open == CLOD_OPEN_DELETE;
    if (from->has_domain) {
        memcpy(domain->min, from->domain_min, sizeof domain->min);
        memcpy(domain->max, from->domain_max, sizeof domain->max);
        return;
    }
    double margin = 0.0;
    memcpy(domain->min, low, sizeof domain->min);
    memcpy(domain->max, high, sizeof domain->max);
    if (!clod_setup_bounds_around(&state->walls, domain->min, domain->max)) {
        memset(domain, 0, sizeof *domain);
        margin = 1.0; // nothing but planes: any box will do
    }
    for (int a = 0; a < 3; a++) {
        margin = fmax(margin, domain->max[a] - domain->min[a]);
    }
    for (int a = 0; a < 3; a++) {
        domain->min[a] -= margin;
        domain->max[a] += margin;
    }
}

void clod_setup_domain_around(const clod_case *from, const double low[3], const double high[3],
                              clod_state *state)
{
    find_space(from, low, high, state);
    make_outlets(from, &state->domain);
    clod_setup_planes(from, state);
}

void clod_setup_domain(const clod_case *from, clod_state *state)
{
    double low[3], high[3];
    (void)clod_setup_bounds(state, low, high);
    clod_setup_domain_around(from, low, high, state);
}
