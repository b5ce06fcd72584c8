// Whether what comes through inlets has room where it comes in.
#include <math.h>
#include <stdio.h>

#include "config/check.h"
#include "config/region.h"
#include "config/sizes.h"

/** Area of a face across a velocity [m2]. */
static double face_across(const clod_case_region *region, const double *v, double speed)
{
    double axis[3][3];
    clod_region_axes(region, axis);
    const double *n = axis[2];
    return clod_region_area(region) * (v[0] * n[0] + v[1] * n[1] + v[2] * n[2]) / speed;
}

/** Area of a region across a velocity [m2]; 0 without velocity. */
static double area_across(const clod_case_region *region, const double velocity[3])
{
    const double speed = hypot(hypot(velocity[0], velocity[1]), velocity[2]);
    if (speed == 0.0) {
        return 0.0;
    }
    if (clod_region_is_face(region)) {
        return face_across(region, velocity, speed);
    }
    double size[3];
    clod_region_row(region)->size(region, size);
    const double across[3] = {size[1] * size[2], size[2] * size[0], clod_region_area(region)};
    double area = 0.0;
    for (int a = 0; a < 3; a++) {
        area += across[a] * fabs(velocity[a]) / speed;
    }
    return area;
}

/** Solid that a group brings in a second [m3/s]; 0: not known here. */
static double solid_flow(const clod_case *self, const clod_case_grains *grains)
{
    const int material = clod_case_material_index(self, grains->material);
    const clod_case_inlet *inlet = &grains->inlet;
    if (inlet->mass_flow > 0.0) {
        return material < 0 ? 0.0 : inlet->mass_flow / self->materials[material].density;
    }
    clod_sizes sizes;
    clod_status ignored = {0}; // told where grains are made
    const double volume =
        clod_sizes_init(&sizes, grains, &ignored) ? clod_sizes_mean_volume(&sizes) : 0.0;
    clod_sizes_fini(&sizes);
    return inlet->number_flow * volume;
}

/** Solid fraction of the stream of a group where it comes in; 0: not known here. */
static double fraction_of(const clod_case *self, const clod_case_grains *grains)
{
    const double *v = grains->velocity;
    const double through =
        area_across(&grains->region, v) * hypot(hypot(v[0], v[1]), v[2]); // m3/s
    return through > 0.0 ? solid_flow(self, grains) / through : 0.0;
}

/** Whether group b comes while group a begins, in the same space; of those that begin together
 *  the one that is written later has the others with it. */
static bool is_with(const clod_case *self, size_t a, size_t b)
{
    const clod_case_inlet *one = &self->grains[a].inlet, *other = &self->grains[b].inlet;
    const bool goes_on = other->end == 0.0 || other->end > one->start;
    const bool before = other->start < one->start || (other->start == one->start && b <= a);
    return self->grains[b].comes && goes_on && before &&
           clod_region_overlap(&self->grains[a].region, &self->grains[b].region);
}

/** As clod_check_rest_fraction, of one stream. */
static double rest_fraction(const clod_case *self, const clod_case_grains *grains,
                            double gravity)
{
    const double *g = self->gravity;
    double size[3], height = 0.0;
    clod_region_row(&grains->region)->size(&grains->region, size);
    for (int a = 0; a < 3; a++) {
        height += size[a] * fabs(g[a]) / gravity;
    }
    const double volume = clod_region_area(&grains->region) * size[2];
    return solid_flow(self, grains) * sqrt(2.0 * height / gravity) / volume;
}

double clod_check_rest_fraction(const clod_case *self, size_t index)
{
    const double *g = self->gravity;
    const double gravity = hypot(hypot(g[0], g[1]), g[2]);
    double all = 0.0;
    for (size_t k = 0; gravity > 0.0 && k < self->grains_count; k++) {
        const double *v = self->grains[k].velocity;
        if (is_with(self, index, k) && v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0) {
            all += rest_fraction(self, &self->grains[k], gravity);
        }
    }
    return gravity > 0.0 ? all : HUGE_VAL;
}

static void check_room(clod_loader *loader, const clod_case *self, size_t index)
{
    const clod_case_grains *grains = &self->grains[index];
    double all = 0.0;
    int streams = 0;
    for (size_t k = 0; k < self->grains_count; k++) {
        if (is_with(self, index, k)) {
            all += fraction_of(self, &self->grains[k]);
            streams++;
        }
    }
    const double own = fraction_of(self, grains);
    if (own == 0.0 || all <= CLOD_CHECK_DENSE) {
        return;
    }
    const bool by_mass = grains->inlet.mass_flow > 0.0;
    const double flow = by_mass ? grains->inlet.mass_flow : grains->inlet.number_flow;
    char key[CLOD_LOAD_PATH], with[64] = "";
    snprintf(key, sizeof key, "grains.%zu.inlet.%s", index,
             by_mass ? "mass_flow" : "number_flow");
    if (streams > 1) {
        snprintf(with, sizeof with, " with the %s in its region",
                 streams > 2 ? "others" : "other");
    }
    clod_check_fail(loader, key,
                    "%.4g %s at this velocity are a solid fraction of %.2g%s; grains at random "
                    "places without overlap go up to %.2g: at most %.4g %s%s, or make the "
                    "region wider or velocity larger",
                    flow, by_mass ? "kg/s" : "grains/s", all, with, CLOD_CHECK_DENSE,
                    flow * CLOD_CHECK_DENSE / all, by_mass ? "kg/s" : "grains/s",
                    streams > 1 ? ", the others in the same proportion" : "");
}

void clod_check_streams(clod_loader *loader, const clod_case *self)
{
    for (size_t k = 0; k < self->grains_count; k++) {
        if (self->grains[k].comes) {
            check_room(loader, self, k);
        }
    }
}
