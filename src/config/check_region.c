// Rules for regions, whoever has one: grains, outlets, gauges, clumps, the map of histories.

#include <stdio.h>

#include "config/check.h"

bool clod_check_region(clod_loader *loader, const char *path, const clod_case_region *region)
{
    char key[CLOD_LOAD_PATH + 40];
    bool good;
    if (region->kind == CLOD_REGION_ANNULUS) {
        good = region->inner_radius < region->outer_radius;
        snprintf(key, sizeof key, "%s.region.annulus.inner_radius", path);
    } else {
        const double *low = region->min, *high = region->max;
        good = low[0] < high[0] && low[1] < high[1] && low[2] < high[2];
        snprintf(key, sizeof key, "%s.region.box.max", path);
    }
    if (!good) {
        clod_check_fail(loader, key, "%s",
                        region->kind == CLOD_REGION_ANNULUS
                            ? "must be smaller than outer_radius"
                            : "must be larger than min in x, y and z");
    }
    return good;
}
