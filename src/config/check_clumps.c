// Rules for clumps, build-up and the map of histories.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "config/check.h"
#include "config/grid.h"

static void check_counts(clod_loader *loader, const clod_case_clumps *clumps)
{
    char key[CLOD_LOAD_PATH];
    if (clumps->count_count > CLOD_CASE_CLUMP_COUNTS) {
        clod_check_fail(loader, "clumps.counts", "has %zu counts; at most %d",
                        clumps->count_count, CLOD_CASE_CLUMP_COUNTS);
    }
    for (size_t k = 0; k < clumps->count_count; k++) {
        const clod_case_clump_count *count = &clumps->counts[k];
        snprintf(key, sizeof key, "clumps.counts.%s", count->name);
        if (strcmp(count->name, "all") == 0) {
            clod_check_fail(loader, key, "all are counted anyway; take another name");
        } else if (!count->has_region && !count->free) {
            clod_check_fail(loader, key,
                            "counts what all clumps are; give it a region, free: true or both");
        } else if (count->has_region) {
            clod_check_region(loader, key, &count->region);
        }
    }
}

static void check_map(clod_loader *loader, const clod_case *self)
{
    const clod_case_history_map *map = &self->history_map;
    if (map->has_region && map->region.kind != CLOD_REGION_BOX) {
        clod_check_fail(loader, "history_map.region", "must be a box, which is cut into cells");
        return;
    }
    if (map->has_region && !clod_check_region(loader, "history_map", &map->region)) {
        return;
    }
    if (!map->has_region && !self->has_domain) {
        clod_check_fail(loader, "history_map",
                        "needs a region, a box that is cut into cells; or give the case a "
                        "domain");
        return;
    }
    const double *low = map->has_region ? map->region.min : self->domain_min;
    const double *high = map->has_region ? map->region.max : self->domain_max;
    const double cells = clod_grid_cells(low, high, map->cell);
    if (cells > CLOD_CASE_MAP_CELLS) {
        clod_check_fail(
            loader, "history_map.cell",
            "makes %.3g cells of the region, at most %d are allowed; make it %.3g m "
            "or the region smaller",
            cells, CLOD_CASE_MAP_CELLS, 1.1 * map->cell * cbrt(cells / CLOD_CASE_MAP_CELLS));
    }
}

void clod_check_clumps(clod_loader *loader, const clod_case *self)
{
    if (self->clumps.present && clod_report_clean(loader->report, "clumps")) {
        check_counts(loader, &self->clumps);
    }
    if (self->history_map.present && clod_report_clean(loader->report, "history_map") &&
        clod_report_clean(loader->report, "domain")) {
        check_map(loader, self);
    }
}
