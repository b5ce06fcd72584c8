#include <math.h>
#include <stdio.h>

#include "base/plural.h"
#include "config/check.h"
#include "config/wall_cells.h"
#include "config/wall_ridges.h"

#define SECTION "wall_friction"
#define RIDGES SECTION ".plate_ridges"
#define MOST_RIDGES 20000             ///< each is up to four surfaces of the plate
#define FLATTEST (2.0 * M_PI / 180.0) ///< rad of a flank: flatter ones are a plane to a mesh
#define STRESSES "wall_friction.wall_stresses"

static bool clean(const clod_loader *loader, const char *path)
{
    return clod_report_clean(loader->report, path);
}

/** Whether ridges of such a width fit beside one another, and have flanks. */
static bool ridges_fit(clod_loader *loader, const clod_wall_ridges *ridges, bool ring)
{
    if (ridges->width > ridges->room * (1.0 + 1e-9)) {
        clod_check_fail(
            loader, clod_check_written(loader, RIDGES ".width", RIDGES ".spacing"),
            "the ridges overlap: %.6g m at the foot, and there is room for %.6g m%s; "
            "make them narrower, or the spacing wider",
            ridges->width, ridges->room, ring ? " at the inner wall of the ring" : "");
        return false;
    }
    if (ridges->crest > ridges->width) {
        clod_check_fail(loader, RIDGES ".crest",
                        "%.6g m is wider than the ridge at its foot, %.6g m", ridges->crest,
                        ridges->width);
        return false;
    }
    return true;
}

static void check_ridges(clod_loader *loader, const clod_case_wall_friction *test)
{
    const clod_wall_ridges ridges = clod_wall_ridges_of(test);
    const double hang = clod_wall_cell_bars(test) > 0 ? test->bar_height : 0.0;
    if (ridges.height == 0.0 || !clean(loader, RIDGES) ||
        !ridges_fit(loader, &ridges, clod_wall_cell_of(test)->turns)) {
        return;
    }
    if (ridges.flank < FLATTEST) {
        clod_check_fail(
            loader, RIDGES ".height",
            "flanks of %.3g deg: below 2 deg the plate counts as flat; raise height, "
            "or make the ridges narrower by width, crest or spacing",
            ridges.flank * 180.0 / M_PI);
    }
    if (ridges.height + hang >= test->depth) {
        clod_check_fail(loader, RIDGES ".height",
                        "the ridges reach %s: %.6g m%s is not less than depth = %.6g m",
                        hang > 0.0 ? "the bars of the lid" : "the top of the specimen",
                        ridges.height + hang, hang > 0.0 ? " with bar_height" : "",
                        test->depth);
    }
    if (ridges.count > MOST_RIDGES) {
        clod_check_fail(loader, RIDGES ".spacing",
                        "the plate would have %lld ridges, and clod takes %d; make the spacing "
                        "wider",
                        (long long)ridges.count, MOST_RIDGES);
    }
}

static void check_bars(clod_loader *loader, const clod_case_wall_friction *test)
{
    if (test->bar_height >= test->depth) {
        clod_check_fail(loader,
                        clod_check_written(loader, SECTION ".bar_height", SECTION ".depth"),
                        "the bars of the lid reach the plate: %.10g m is not less than depth = "
                        "%.10g m",
                        test->bar_height, test->depth);
    }
    if ((double)test->bar_count * test->bar_width >= 2.0 * M_PI * test->inner_radius) {
        clod_check_fail(loader, SECTION ".bar_width",
                        "%lld bar%s of %.10g m: there is no gap at the inner radius",
                        (long long)test->bar_count, clod_plural((double)test->bar_count),
                        test->bar_width);
    }
}

static void check_cell(clod_loader *loader, const clod_case_wall_friction *test)
{
    if (!clean(loader, SECTION)) {
        return;
    }
    const double width = clod_wall_cell_width(test);
    if (width <= 0.0) {
        clod_check_fail(loader, SECTION ".inner_radius",
                        "must be smaller than outer_radius = %.10g m", test->outer_radius);
        return;
    }
    if (2.0 * test->radius_max > fmin(width, test->depth)) {
        clod_check_fail(
            loader, SECTION ".radius.max",
            "grains of %.10g m diameter do not fit into the cell: width %.10g m, depth %.10g m",
            2.0 * test->radius_max, width, test->depth);
    }
    if (clod_wall_cell_bars(test) > 0) {
        check_bars(loader, test);
    }
    check_ridges(loader, test);
}

/** Weight of the solid on the plate [Pa]; of a number of grains a little less than it is, for the
 *  mean grain has less than the mean volume. */
static double weight_of(const clod_case *self)
{
    const clod_case_wall_friction *test = &self->wall_friction;
    if (test->grain_count == 0) {
        return clod_check_tester_weight(self, test->grain_material, test->fill_fraction,
                                        test->depth);
    }
    const double r = test->radius_mean;
    const double volume = (double)test->grain_count * 4.0 / 3.0 * M_PI * r * r * r;
    return clod_check_tester_weight(self, test->grain_material, 1.0,
                                    volume / clod_wall_cell_area(test));
}

/** Two stresses make a line; none is below the weight of the solid on the plate. */
static void check_stresses(clod_loader *loader, const clod_case *self)
{
    const clod_case_wall_friction *test = &self->wall_friction;
    if (test->wall_stress_count == 0 || !clean(loader, STRESSES)) {
        return; // missing or wrong, which has been said
    }
    if (test->wall_stress_count < 2 || test->wall_stress_count > CLOD_CASE_WALL_STRESSES) {
        clod_check_fail(loader, STRESSES,
                        "%zu stress%s: a wall yield locus needs two at least, and takes %d at "
                        "most; five are usual",
                        test->wall_stress_count, test->wall_stress_count == 1 ? "" : "es",
                        CLOD_CASE_WALL_STRESSES);
        return;
    }
    double most = 0.0;
    const double weight = weight_of(self);
    for (size_t k = 0; k < test->wall_stress_count; k++) {
        most = fmax(most, test->wall_stresses[k]);
        if (test->wall_stresses[k] <= weight) {
            char path[64];
            snprintf(path, sizeof path, STRESSES ".%zu", k);
            clod_check_fail(loader, path,
                            "%.10g Pa is not above the weight of the solid on the plate, about "
                            "%.2g Pa; the lid cannot pull",
                            test->wall_stresses[k], weight);
        }
    }
    clod_check_apart(loader, STRESSES, test->wall_stresses, test->wall_stress_count,
                     CLOD_CHECK_APART * most,
                     "both give the same point of the wall yield locus");
}

/** The ways of shear must be long enough for what is to be seen on them. */
static void check_ways(clod_loader *loader, const clod_case_wall_friction *test)
{
    const double blocks = (double)test->steady_blocks * test->block_displacement;
    if (!clean(loader, SECTION)) {
        return;
    }
    if (blocks > test->shear_max * (1.0 + 1e-9)) { // products of decimal numbers round
        clod_check_fail(
            loader,
            clod_check_written(loader, SECTION ".shear_max", SECTION ".block_displacement"),
            "the shear stress can never be steady: %lld blocks (steady_blocks) of %.10g m "
            "(block_displacement) are longer than shear_max = %.10g m",
            (long long)test->steady_blocks, test->block_displacement, test->shear_max);
    }
    if (test->shear_min > test->shear_max) {
        clod_check_fail(loader,
                        clod_check_written(loader, SECTION ".shear_max", SECTION ".shear_min"),
                        "shear cannot end: it goes on for shear_min = %.10g m at least, which "
                        "is above shear_max = %.10g m",
                        test->shear_min, test->shear_max);
    }
}

void clod_check_wall_friction(clod_loader *loader, const clod_case *self)
{
    const clod_case_wall_friction *test = &self->wall_friction;
    clod_check_material(loader, self, SECTION ".grain_material", test->grain_material);
    clod_check_material(loader, self, SECTION ".side_material", test->side_material);
    clod_check_material(loader, self, SECTION ".plate_material", test->plate_material);
    clod_check_material(loader, self, SECTION ".lid_material", test->lid_material);
    clod_check_tester_gravity(loader, self, "a wall friction cell");
    clod_check_tester_radius(loader, SECTION, test->radius_mean, test->radius_min,
                             test->radius_max);
    check_cell(loader, test);
    check_stresses(loader, self);
    check_ways(loader, test);
}
