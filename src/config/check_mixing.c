// Rules for mixing indices and angles of repose.

#include <math.h>
#include <stdio.h>

#include "config/check.h"
#include "config/grid.h"
#include "config/region.h"

/** An index compares cells with each other: there must be two at least. */
static void check_several(clod_loader *loader, const char *path, const clod_case_mixing *mixing)
{
    double low[3], high[3], longest = 0.0;
    clod_region_bounds(&mixing->region, low, high);
    for (int a = 0; a < 3; a++) {
        longest = fmax(longest, high[a] - low[a]);
    }
    if (clod_grid_cells(low, high, mixing->cell) < 2.0) {
        char key[CLOD_LOAD_PATH + 8];
        snprintf(key, sizeof key, "%s.cell", path);
        clod_check_fail(
            loader, key,
            "is %.4g m, so the region is one cell, and an index compares cells with "
            "each other; make it less than the longest side of the region, %.4g m",
            mixing->cell, longest);
    }
}

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

/** Farthest that a slope, or a heap from its axis outwards, reaches within its region seen from above [m]; of a heap
 *  without a centre at most. */
static double reach_of(const clod_case_repose *angle)
{
    double low[3], high[3];
    clod_region_bounds(&angle->region, low, high);
    const bool round = clod_region_row(&angle->region)->upright;
    const double wide[2] = {high[0] - low[0], high[1] - low[1]};
    const double *n = angle->direction, *c = angle->center;
    if (angle->has_direction && !round) {
        return (wide[0] * fabs(n[0]) + wide[1] * fabs(n[1])) / hypot(n[0], n[1]);
    }
    if (angle->has_center && !angle->has_direction) {
        const double off[2] = {fabs(c[0] - 0.5 * (low[0] + high[0])),
                               fabs(c[1] - 0.5 * (low[1] + high[1]))};
        return round ? hypot(off[0], off[1]) + 0.5 * wide[0]
                     : hypot(off[0] + 0.5 * wide[0], off[1] + 0.5 * wide[1]);
    }
    return round ? wide[0] : hypot(wide[0], wide[1]); // of a heap with its axis in a corner
}

/** An angle needs three strips: along the slope, or from the axis of a heap outwards. */
static void check_strips(clod_loader *loader, const char *path, const clod_case_repose *angle)
{
    const double length = reach_of(angle);
    if (length < 3.0 * angle->cell * (1.0 - 1e-9)) {
        char key[CLOD_LOAD_PATH + 8];
        snprintf(key, sizeof key, "%s.cell", path);
        clod_check_fail(
            loader, key,
            "is %.4g m, too wide for a %s that is %.4g m long at most: an angle needs "
            "three strips at least; make it %.3g m or less",
            angle->cell, angle->has_direction ? "slope" : "flank", length,
            0.33 * length); // rounded, still below a third
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
            check_several(loader, path, mixing);
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
