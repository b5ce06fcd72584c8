// Rules for grains that come during a run.
#include <math.h>
#include <stdio.h>

#include "config/check.h"

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
