// Rules for regions, whoever has one: grains, outlets, gauges, clumps, the map of histories.

#include <math.h>
#include <stdio.h>

#include "config/check.h"
#include "config/region.h"

/** Cosine of the angle between two directions below which they are across each other. */
#define ACROSS 1e-9

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool clod_check_face(clod_loader *loader, const char *path, clod_case_grains *grains)
{
    clod_case_region *region = &grains->region;
    const double *a = region->edge_1, *b = region->edge_2, *v = grains->velocity;
    char key[CLOD_LOAD_PATH + 40];
    if (region->kind == CLOD_REGION_RECTANGLE) {
        if (!(fabs(dot(a, b)) <= ACROSS * sqrt(dot(a, a) * dot(b, b)))) {
            snprintf(key, sizeof key, "%s.region.rectangle.edge_2", path);
            clod_check_fail(loader, key, "must be at a right angle to edge_1");
            return false;
        }
        for (int k = 0; k < 3; k++) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            region->normal[k] = a[l] * b[m] - a[m] * b[l];
        }
        const double side = dot(region->normal, v) < 0.0 ? -1.0 : 1.0;
        for (int k = 0; k < 3; k++) {
            region->normal[k] *= side;
        }
    }
    const double speed = dot(region->normal, v) / sqrt(dot(region->normal, region->normal));
    region->depth = speed * CLOD_CASE_INLET_INTERVAL;
    if (!grains->comes || !(speed > 0.0)) {
        snprintf(key, sizeof key, "%s.%s", path, grains->comes ? "velocity" : "region");
        clod_check_fail(
            loader, key, "%s",
            grains->comes ? "must lead through the face, to the side that normal points to"
                          : "is a face: only grains of an inlet come through one; write a box "
                            "or an annulus, or give the group an inlet");
        return false;
    }
    return true;
}

bool clod_check_region(clod_loader *loader, const char *path, const clod_case_region *region)
{
    char key[CLOD_LOAD_PATH + 40];
    const clod_region_kind_row *row = clod_region_row(region);
    const clod_region_fault fault =
        row->fault != NULL ? row->fault(region) : (clod_region_fault){0};
    if (fault.key != NULL) {
        snprintf(key, sizeof key, "%s.region.%s", path, fault.key);
        clod_check_fail(loader, key, "%s", fault.text);
    }
    return fault.key == NULL;
}

bool clod_check_region_place(clod_loader *loader, const clod_case *self, const char *path,
                             const clod_case_region *region)
{
    char key[CLOD_LOAD_PATH + 8];
    double low[3], high[3];
    clod_region_bounds(region, low, high);
    snprintf(key, sizeof key, "%s.region", path);
    for (int a = 0; self->has_domain && a < 3; a++) {
        const double begin = self->domain_min[a], end = self->domain_max[a];
        if (self->periodic[a] && (low[a] < begin || high[a] > end)) {
            clod_check_fail(
                loader, key,
                "reaches beyond the domain along %c, in which it is periodic: grains "
                "would count twice; stay between %.6g m and %.6g m",
                "xyz"[a], begin, end);
            return false;
        }
        if (low[a] >= end || high[a] <= begin) {
            clod_check_fail(loader, key,
                            "is outside the domain, in which all grains are: %.6g m to %.6g m "
                            "along %c; the domain is from %.6g m to %.6g m",
                            low[a], high[a], "xyz"[a], begin, end);
            return false;
        }
    }
    return true;
}
