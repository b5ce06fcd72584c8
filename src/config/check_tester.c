#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/plural.h"
#include "config/check.h"
#include "config/testers.h"

#define PI 3.14159265358979323846

static bool clean(const clod_loader *loader, const char *path)
{
    return clod_report_clean(loader->report, path);
}

/** Radii of a tester's grains, at `section`.radius; the mean lies between the ends. */
void clod_check_tester_radius(clod_loader *loader, const char *section, double mean, double min,
                              double max)
{
    char path[64];
    snprintf(path, sizeof path, "%s.radius", section);
    if (!clean(loader, path)) {
        return;
    }
    if (min > max) {
        snprintf(path, sizeof path, "%s.radius.min", section);
        clod_check_fail(loader, path, "the smallest radius is larger than max = %.10g m", max);
    } else if (mean < min || mean > max) {
        snprintf(path, sizeof path, "%s.radius.mean", section);
        clod_check_fail(loader, path,
                        "the mean must lie between min = %.10g m and max = %.10g m", min, max);
    }
}

static void check_cell(clod_loader *loader, const clod_case_ring_shear *ring)
{
    if (!clean(loader, "ring_shear")) {
        return;
    }
    const double gap = ring->outer_radius - ring->inner_radius;
    if (gap <= 0.0) {
        clod_check_fail(loader, "ring_shear.inner_radius",
                        "must be smaller than outer_radius = %.10g m", ring->outer_radius);
        return;
    }
    const double room = gap < ring->depth ? gap : ring->depth;
    if (2.0 * ring->radius_max > room) {
        clod_check_fail(
            loader, "ring_shear.radius.max",
            "grains of %.10g m diameter do not fit into the cell: width %.10g m, depth "
            "%.10g m",
            2.0 * ring->radius_max, gap, ring->depth);
    }
    if (2.0 * ring->bar_height >= ring->depth) {
        clod_check_fail(
            loader, "ring_shear.bar_height",
            "bars of lid and base meet: twice %.10g m is not less than depth = %.10g m",
            ring->bar_height, ring->depth);
    }
    if ((double)ring->bar_count * ring->bar_width >= 2.0 * PI * ring->inner_radius) {
        clod_check_fail(loader, "ring_shear.bar_width",
                        "%lld bar%s of %.10g m: there is no gap at the inner radius",
                        (long long)ring->bar_count, clod_plural((double)ring->bar_count),
                        ring->bar_width);
    }
}

/** Weight of a solid of some height, as dense as filling assumes [Pa]. */
double clod_check_tester_weight(const clod_case *self, const char *material, double fraction,
                                double height)
{
    const int ore = material == NULL ? -1 : clod_case_material_index(self, material);
    const double density = ore < 0 ? 0.0 : self->materials[ore].density;
    return -fraction * density * self->gravity[2] * height;
}

/** The cell stands upright and is filled from above: weight presses the solid onto its base.
 */
void clod_check_tester_gravity(clod_loader *loader, const clod_case *self, const char *cell)
{
    const double *g = self->gravity;
    if (clean(loader, "gravity") && (g[0] != 0.0 || g[1] != 0.0 || !(g[2] < 0.0))) {
        clod_check_fail(loader, "gravity",
                        "%s stands upright and its grains fall in: gravity must be [0, 0, -g] "
                        "with g above 0, not [%.10g, %.10g, %.10g] m/s2",
                        cell, g[0], g[1], g[2]);
    }
}

void clod_check_ring_shear(clod_loader *loader, const clod_case *self)
{
    const clod_case_ring_shear *ring = &self->ring_shear;
    clod_check_material(loader, self, "ring_shear.grain_material", ring->grain_material);
    clod_check_material(loader, self, "ring_shear.side_material", ring->side_material);
    clod_check_material(loader, self, "ring_shear.base_material", ring->base_material);
    clod_check_material(loader, self, "ring_shear.lid_material", ring->lid_material);
    clod_check_tester_gravity(loader, self, "a ring shear cell");
    clod_check_tester_radius(loader, "ring_shear", ring->radius_mean, ring->radius_min,
                             ring->radius_max);
    check_cell(loader, ring);
    const clod_check_above above = {clod_check_tester_weight(self, ring->grain_material,
                                                             ring->fill_fraction,
                                                             ring->bar_height),
                                    "between the bars of the lid"};
    clod_check_programme(loader, "ring_shear", &ring->programme, &above);
}

/** The rings cover each other's cells over the whole travel, and grains fit in. */
static void check_rings(clod_loader *loader, const clod_case_jenike *test)
{
    if (!clean(loader, "jenike")) {
        return;
    }
    const double width = test->diameter - 2.0 * test->offset;
    const double height =
        test->ring_height < test->base_height ? test->ring_height : test->base_height;
    if (test->offset > test->rim) {
        clod_check_fail(loader, "jenike.offset",
                        "grains would leak between the rings: must not be above rim = %.10g m",
                        test->rim);
    } else if (2.0 * test->radius_max > (width < height ? width : height)) {
        clod_check_fail(loader, "jenike.radius.max",
                        "grains of %.10g m diameter do not fit into the cell: %.10g m across "
                        "both rings, %.10g m in the lower one of them",
                        2.0 * test->radius_max, width, height);
    }
    const clod_case_programme *way = &test->programme;
    const double before = way->preshear_max + way->shear_max - test->offset;
    if (before > test->rim * (1.0 + 1e-9)) { // sums of decimal numbers round
        clod_check_fail(
            loader, clod_check_written(loader, "jenike.preshear_max", "jenike.shear_max"),
            "grains would leak between the rings: after preshear_max + shear_max the shear "
            "ring is %.10g m before the base ring, more than rim = %.10g m; shear less, or "
            "raise "
            "offset or rim",
            before, test->rim);
    }
}

void clod_check_jenike(clod_loader *loader, const clod_case *self)
{
    const clod_case_jenike *test = &self->jenike;
    clod_check_material(loader, self, "jenike.grain_material", test->grain_material);
    clod_check_material(loader, self, "jenike.side_material", test->side_material);
    clod_check_material(loader, self, "jenike.base_material", test->base_material);
    clod_check_material(loader, self, "jenike.lid_material", test->lid_material);
    clod_check_tester_gravity(loader, self, "a Jenike cell");
    clod_check_tester_radius(loader, "jenike", test->radius_mean, test->radius_min,
                             test->radius_max);
    check_rings(loader, test);
    const clod_check_above above = {clod_check_tester_weight(self, test->grain_material,
                                                             test->fill_fraction,
                                                             test->ring_height),
                                    "in the shear ring"};
    clod_check_programme(loader, "jenike", &test->programme, &above);
}

static void check_mould(clod_loader *loader, const clod_case_uniaxial *test)
{
    if (!clean(loader, "uniaxial")) {
        return;
    }
    const double room = test->diameter < test->height ? test->diameter : test->height;
    if (2.0 * test->radius_max > room) {
        clod_check_fail(
            loader, "uniaxial.radius.max",
            "grains of %.10g m diameter do not fit into the mould: diameter %.10g m, "
            "height %.10g m",
            2.0 * test->radius_max, test->diameter, test->height);
    }
    if (test->beyond_peak >= test->crush_max) {
        clod_check_fail(
            loader, clod_check_written(loader, "uniaxial.crush_max", "uniaxial.beyond_peak"),
            "no peak can be passed: beyond_peak = %.10g is not less than "
            "crush_max = %.10g",
            test->beyond_peak, test->crush_max);
    }
}

/** Two equal consolidations begin with the same filled mould and end the same. */
static void check_consolidations(clod_loader *loader, const clod_case_uniaxial *test)
{
    static const char PATH[] = "uniaxial.consolidation_stresses";
    const double *stress = test->consolidation_stresses;
    const size_t count = test->consolidation_stress_count;
    if (count == 0 || !clean(loader, PATH)) {
        return;
    }
    double lowest = stress[0];
    for (size_t k = 1; k < count; k++) {
        lowest = fmin(lowest, stress[k]);
    }
    clod_check_apart(loader, PATH, stress, count, CLOD_CHECK_APART * lowest,
                     "both give the same point of the flow function");
}

void clod_check_uniaxial(clod_loader *loader, const clod_case *self)
{
    const clod_case_uniaxial *test = &self->uniaxial;
    clod_check_material(loader, self, "uniaxial.grain_material", test->grain_material);
    clod_check_material(loader, self, "uniaxial.side_material", test->side_material);
    clod_check_material(loader, self, "uniaxial.base_material", test->base_material);
    clod_check_material(loader, self, "uniaxial.lid_material", test->lid_material);
    clod_check_tester_gravity(loader, self, "the mould of a uniaxial test");
    clod_check_tester_radius(loader, "uniaxial", test->radius_mean, test->radius_min,
                             test->radius_max);
    check_mould(loader, test);
    check_consolidations(loader, test);
}

void clod_check_contact_bench(clod_loader *loader, const clod_case *self)
{
    const clod_case_contact_bench *bench = &self->contact_bench;
    clod_check_material(loader, self, "contact_bench.material_1", bench->material_1);
    clod_check_material(loader, self, "contact_bench.material_2", bench->material_2);
    if (!clean(loader, "contact_bench")) {
        return;
    }
    if (bench->wall && bench->radius_2 > 0.0) {
        clod_check_fail(loader, "contact_bench.radius_2",
                        "a flat wall has no radius; remove this key, or wall: true");
    }
    if (!bench->wall && bench->radius_2 == 0.0) {
        clod_check_fail(
            loader, "contact_bench",
            "needs the key radius_2, for instance radius_2: 3.175 mm, or wall: true");
    }
    for (size_t i = 0; i < bench->leg_count; i++) {
        if (bench->legs[i].overlap >= bench->radius_1) {
            char path[64];
            snprintf(path, sizeof path, "contact_bench.legs.%zu.overlap", i);
            clod_check_fail(loader, path, "must be smaller than radius_1 = %.10g m",
                            bench->radius_1);
        }
    }
}

void clod_check_tester(clod_loader *loader, clod_case *self)
{
    for (int k = 0; k < CLOD_CASE_KINDS; k++) {
        const clod_config_tester *tester = &CLOD_CONFIG_TESTER[k];
        if (tester->key != NULL && tester->present(self)) {
            tester->check(loader, self);
        }
    }
}
