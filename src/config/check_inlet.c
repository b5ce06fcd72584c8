// Rules for grains that come during a run.
#include <math.h>
#include <stdio.h>

#include "config/check.h"

/** Solid fraction of a stream that random places without overlap still allow, with some ease. */
#define DENSE 0.25

static void fail(clod_loader *loader, const char *path, const char *key, const char *text)
{
    char whole[CLOD_LOAD_PATH + 64];
    snprintf(whole, sizeof whole, "%s.%s", path, key);
    clod_check_fail(loader, whole, "%s", text);
}

static bool has(const clod_loader *loader, const char *path, const char *key)
{
    char whole[CLOD_LOAD_PATH + 64];
    snprintf(whole, sizeof whole, "%s.%s", path, key);
    return clod_check_has(loader, whole);
}

/** Numbers of groups that have an inlet. */
static size_t count_inlets(const clod_case *self)
{
    size_t count = 0;
    for (size_t k = 0; k < self->grains_count; k++) {
        count += self->grains[k].comes;
    }
    return count;
}

/** Area of a region across a velocity [m2]; 0 without velocity. */
static double area_across(const clod_case_region *region, const double velocity[3])
{
    const double speed = hypot(hypot(velocity[0], velocity[1]), velocity[2]);
    if (speed == 0.0) {
        return 0.0;
    }
    const bool box = region->kind == CLOD_REGION_BOX;
    const double wide = 2.0 * region->outer_radius;
    const double size[3] = {box ? region->max[0] - region->min[0] : wide,
                            box ? region->max[1] - region->min[1] : wide,
                            box ? region->max[2] - region->min[2] : region->height};
    const double round = M_PI * (region->outer_radius * region->outer_radius -
                                 region->inner_radius * region->inner_radius);
    const double across[3] = {size[1] * size[2], size[2] * size[0],
                              box ? size[0] * size[1] : round};
    double area = 0.0;
    for (int a = 0; a < 3; a++) {
        area += across[a] * fabs(velocity[a]) / speed;
    }
    return area;
}

/** A stream that its region cannot let through at its velocity. */
static void check_dense(clod_loader *loader, const char *path, const clod_case *self,
                        const clod_case_grains *grains)
{
    const int material = clod_case_material_index(self, grains->material);
    const double area = area_across(&grains->region, grains->velocity);
    if (material < 0 || area == 0.0 || grains->inlet.mass_flow == 0.0) {
        return; // told elsewhere, or not known before
    }
    const double *v = grains->velocity;
    const double speed = hypot(hypot(v[0], v[1]), v[2]);
    const double solid = grains->inlet.mass_flow / self->materials[material].density;
    if (solid > DENSE * area * speed) {
        char text[256];
        snprintf(text, sizeof text,
                 "%.4g kg/s through %.3g m2 at %.3g m/s is a solid fraction of %.2g; grains at "
                 "random places without overlap go up to %.2g: at most %.4g kg/s, or make the "
                 "region wider or velocity larger",
                 grains->inlet.mass_flow, area, speed, solid / (area * speed), DENSE,
                 DENSE * area * speed * self->materials[material].density);
        fail(loader, path, "inlet.mass_flow", text);
    }
}

void clod_check_inlet(clod_loader *loader, const char *path, const clod_case *self,
                      const clod_case_grains *grains)
{
    const clod_case_inlet *inlet = &grains->inlet;
    if ((inlet->mass_flow > 0.0) == (inlet->number_flow > 0.0)) {
        fail(loader, path, "inlet", "must have exactly one of mass_flow, number_flow");
    }
    if (grains->file != NULL || grains->fill_height > 0.0) {
        fail(loader, path, grains->file != NULL ? "file" : "fill_height",
             "an inlet makes grains until it ends, or there are count or mass of them; remove "
             "this key");
    } else if (grains->count > 0 && grains->mass > 0.0) {
        fail(loader, path, "mass", "the amount is given twice; keep one of count, mass");
    }
    if (has(loader, path, "inlet.end") && inlet->end <= inlet->start) {
        char text[128];
        snprintf(text, sizeof text, "%.6g s must be later than start, %.6g s", inlet->end,
                 inlet->start);
        fail(loader, path, "inlet.end", text);
    }
    if (self->time.design_stress == 0.0) {
        fail(
            loader, path, "inlet",
            "nothing tells under which load grains will come; give it, for instance "
            "time: {design_stress: 5 kPa}, the weight of the deepest bed that there will be on "
            "its area");
    }
    if (count_inlets(self) > CLOD_CASE_INLETS) {
        char text[64];
        snprintf(text, sizeof text, "there are %zu inlets; at most %d", count_inlets(self),
                 CLOD_CASE_INLETS);
        fail(loader, path, "inlet", text);
    }
    check_dense(loader, path, self, grains);
}

// ---- outlets

/** Thickness of a region, the least of its sizes [m]. */
static double thickness(const clod_case_region *region)
{
    if (region->kind == CLOD_REGION_ANNULUS) {
        return fmin(region->height, region->outer_radius - region->inner_radius);
    }
    const double *a = region->min, *b = region->max;
    return fmin(b[0] - a[0], fmin(b[1] - a[1], b[2] - a[2]));
}

/** Largest radius that a group of grains can have [m]; 0: not known before the run. */
static double largest_radius(const clod_case_grains *grains)
{
    return grains->sizes == CLOD_SIZE_SIEVE && grains->sieve_count > 0
               ? 0.5 * grains->sieve[grains->sieve_count - 1].size
               : grains->radius_max;
}

void clod_check_outlets(clod_loader *loader, const clod_case *self)
{
    double radius = 0.0;
    for (size_t k = 0; k < self->grains_count; k++) {
        radius = fmax(radius, largest_radius(&self->grains[k]));
    }
    for (size_t k = 0; k < self->outlet_count; k++) {
        const clod_case_outlet *outlet = &self->outlets[k];
        char path[CLOD_LOAD_PATH], key[CLOD_LOAD_PATH];
        snprintf(path, sizeof path, "outlets.%s", outlet->name);
        snprintf(key, sizeof key, "outlets.%s.region", outlet->name);
        if (clod_report_clean(loader->report, key) &&
            clod_check_region(loader, path, &outlet->region) &&
            !(thickness(&outlet->region) > radius)) {
            clod_check_fail(loader, key,
                            "is %.4g m thick; grains move by up to a radius between two looks, "
                            "so make it thicker than that of the largest, %.4g m",
                            thickness(&outlet->region), radius);
        }
    }
    if (self->outlet_count > CLOD_CASE_OUTLETS) {
        clod_check_fail(loader, "outlets", "has %zu outlets; at most %d", self->outlet_count,
                        CLOD_CASE_OUTLETS);
    }
}
