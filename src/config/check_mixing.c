// Rules for mixing indices and angles of repose.

#include <math.h>
#include <stdio.h>

#include "config/check.h"
#include "config/grid.h"
#include "config/region.h"

/** Cells of the box about a region, or of what is seen of it from above, must be few. */
static void check_cells(clod_loader *loader, const char *path, const clod_case_region *region,
                        double cell, bool from_above)
{
    double low[3], high[3];
    clod_region_bounds(region, low, high);
    high[2] = from_above ? low[2] : high[2];

    const double cells = clod_grid_cells(low, high, cell);
    if (cells > CLOD_CASE_MIXING_CELLS) {
        char key[CLOD_LOAD_PATH + 8];
        snprintf(key, sizeof key, "%s.cell", path);
        clod_check_fail(
            loader, key,
            "makes %.3g cells of the region, at most %d are allowed; make it %.3g m "
            "or the region smaller",
            cells, CLOD_CASE_MIXING_CELLS,
            1.1 * cell * pow(cells / CLOD_CASE_MIXING_CELLS, from_above ? 0.5 : 1.0 / 3.0));
    }
}

static void check_kinds(clod_loader *loader, const clod_case *self, const char *path,
                        const clod_case_mixing *mixing)
{
    char key[CLOD_LOAD_PATH + 16];
    const char *tester = clod_case_tester(self);
    if (tester != NULL && (mixing->material != NULL || mixing->above == 0.0)) {
        snprintf(key, sizeof key, "%s%s", path, mixing->material != NULL ? ".material" : "");
        clod_check_fail(loader, key,
                        "all grains of %s are of one material: tell two kinds of them apart by "
                        "their radius, for instance above: 3 mm",
                        tester);
        return;
    }
    const bool both = mixing->material != NULL && mixing->above > 0.0;
    snprintf(key, sizeof key, "%s%s", path, both ? ".above" : "");
    if (both || (mixing->material == NULL && mixing->above == 0.0)) {
        clod_check_fail(loader, key,
                        "needs one of material and above, to tell two kinds of grains apart; "
                        "for instance material: ore");
    } else if (mixing->material != NULL) {
        snprintf(key, sizeof key, "%s.material", path);
        clod_check_material(loader, self, key, mixing->material);
    }
}

static void check_angle(clod_loader *loader, const char *path, const clod_case_repose *angle)
{
    char key[CLOD_LOAD_PATH + 16];
    const double *n = angle->direction;
    if (angle->has_direction && angle->has_center) {
        snprintf(key, sizeof key, "%s.center", path);
        clod_check_fail(loader, key,
                        "is that of a round heap; a slope with a direction has none");
    }
    double low[3], high[3];
    clod_region_bounds(&angle->region, low, high);
    for (int a = 0; angle->has_center && a < 2; a++) {
        if (!(angle->center[a] >= low[a] && angle->center[a] <= high[a])) {
            snprintf(key, sizeof key, "%s.center", path);
            clod_check_fail(loader, key, "must be within the region, %.6g m to %.6g m along %c",
                            low[a], high[a], "xy"[a]);
            break;
        }
    }
    if (angle->has_direction && fabs(n[2]) > 1e-6 * hypot(n[0], n[1])) {
        snprintf(key, sizeof key, "%s.direction", path);
        clod_check_fail(loader, key, "must be level, for instance [1, 0, 0]");
    }
    if (!(angle->from < angle->to)) {
        snprintf(key, sizeof key, "%s.to", path);
        clod_check_fail(
            loader, key,
            "is %.6g %%, and from is %.6g %%: must be larger than from, for instance "
            "from: 10 %% and to: 75 %%",
            100.0 * angle->to, 100.0 * angle->from);
    }
}

/** An angle needs three strips: along the slope, or from the axis of a heap outwards. */
static void check_strips(clod_loader *loader, const char *path, const clod_case_repose *angle)
{
    double low[3], high[3];
    clod_region_bounds(&angle->region, low, high);
    const double wide[2] = {high[0] - low[0], high[1] - low[1]};
    double length = hypot(wide[0], wide[1]); // of a heap with its axis in a corner
    if (angle->has_direction) {
        const double *n = angle->direction;
        length = (wide[0] * fabs(n[0]) + wide[1] * fabs(n[1])) / hypot(n[0], n[1]);
    } else if (angle->has_center) {
        const double *c = angle->center;
        length =
            hypot(fmax(c[0] - low[0], high[0] - c[0]), fmax(c[1] - low[1], high[1] - c[1]));
    }
    if (length < 2.0 * angle->cell) {
        char key[CLOD_LOAD_PATH + 8];
        snprintf(key, sizeof key, "%s.cell", path);
        clod_check_fail(loader, key,
                        "is %.4g m, too wide for a region that is %.4g m long: an angle needs "
                        "three strips at least; make it %.2g m or less",
                        angle->cell, length, 0.1 * length);
    }
}

static void check_count(clod_loader *loader, const char *key, size_t count)
{
    if (count > CLOD_CASE_MIXINGS) {
        clod_check_fail(loader, key, "has %zu of them; at most %d", count, CLOD_CASE_MIXINGS);
    }
}

void clod_check_mixing(clod_loader *loader, const clod_case *self)
{
    char path[CLOD_LOAD_PATH];
    check_count(loader, "mixing", self->mixing_count);
    check_count(loader, "repose", self->repose_count);
    for (size_t k = 0; k < self->mixing_count; k++) {
        const clod_case_mixing *mixing = &self->mixings[k];
        snprintf(path, sizeof path, "mixing.%s", mixing->name);
        if (clod_report_clean(loader->report, path) &&
            clod_check_region(loader, path, &mixing->region) &&
            clod_check_region_place(loader, self, path, &mixing->region)) {
            check_cells(loader, path, &mixing->region, mixing->cell, false);
            check_kinds(loader, self, path, mixing);
        }
    }
    for (size_t k = 0; k < self->repose_count; k++) {
        const clod_case_repose *angle = &self->reposes[k];
        snprintf(path, sizeof path, "repose.%s", angle->name);
        if (clod_report_clean(loader->report, path) &&
            clod_check_region(loader, path, &angle->region) &&
            clod_check_region_place(loader, self, path, &angle->region)) {
            check_cells(loader, path, &angle->region, angle->cell, true);
            check_angle(loader, path, angle);
            check_strips(loader, path, angle);
        }
    }
}
