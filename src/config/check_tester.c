#include <stdio.h>
#include <string.h>

#include "config/check.h"

#define PI 3.14159265358979323846

static bool clean(const clod_loader *loader, const char *path)
{
    return clod_report_clean(loader->report, path);
}

/** Radii of a tester's grains, at `section`.radius; the mean lies between the ends. */
static void check_radius(clod_loader *loader, const char *section, double mean, double min,
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
                        "%lld bars of %.10g m leave no gap at the inner radius",
                        (long long)ring->bar_count, ring->bar_width);
    }
}

/** Weight of the solid between the lid's bars, above the shear plane [Pa]. */
static double solid_above(const clod_case *self)
{
    const clod_case_ring_shear *ring = &self->ring_shear;
    const int ore = ring->grain_material == NULL
                        ? -1
                        : clod_case_material_index(self, ring->grain_material);
    const double density = ore < 0 ? 0.0 : self->materials[ore].density;
    return -ring->fill_fraction * density * self->gravity[2] * ring->bar_height;
}

static void check_stresses(clod_loader *loader, const clod_case *self)
{
    const clod_case_ring_shear *ring = &self->ring_shear;
    const double least = solid_above(self);
    if (ring->preshear_stress == 0.0) {
        return; // missing or wrong, which has been said
    }
    for (size_t i = 0; i < ring->shear_stress_count; i++) {
        char path[64];
        snprintf(path, sizeof path, "ring_shear.shear_stresses.%zu", i);
        if (ring->shear_stresses[i] <= least) {
            clod_check_fail(loader, path,
                            "%.10g Pa is not above the weight of the solid between the bars of "
                            "the lid, about %.2g Pa; the lid cannot pull",
                            ring->shear_stresses[i], least);
        }
        if (ring->shear_stresses[i] >= ring->preshear_stress) {
            clod_check_fail(
                loader, path,
                "%.10g Pa is not below preshear_stress = %.10g Pa; points of a yield "
                "locus lie below it",
                ring->shear_stresses[i], ring->preshear_stress);
        }
    }
}

/** Complain at the one of two keys that was written; at the first when both were. */
static const char *written(const clod_loader *loader, const char *first, const char *second)
{
    return clod_check_has(loader, first) || !clod_check_has(loader, second) ? first : second;
}

/** The ways of shear must be long enough for what is to be seen on them. */
static void check_ways(clod_loader *loader, const clod_case_ring_shear *ring)
{
    if (!clean(loader, "ring_shear")) {
        return;
    }
    const double blocks = (double)ring->steady_blocks * ring->block_displacement;
    if (blocks > ring->preshear_max * (1.0 + 1e-9)) { // products of decimal numbers round
        clod_check_fail(
            loader, written(loader, "ring_shear.preshear_max", "ring_shear.block_displacement"),
            "preshear can never be steady: %lld blocks (steady_blocks) of %.10g m "
            "(block_displacement) are longer than preshear_max = %.10g m",
            (long long)ring->steady_blocks, ring->block_displacement, ring->preshear_max);
    }
    if (ring->beyond_peak + ring->peak_window >= ring->shear_max) {
        clod_check_fail(
            loader, written(loader, "ring_shear.shear_max", "ring_shear.beyond_peak"),
            "no peak can be passed: beyond_peak + peak_window = %.10g m is not less "
            "than shear_max = %.10g m",
            ring->beyond_peak + ring->peak_window, ring->shear_max);
    }
}

/** The cell stands upright: weight presses the solid onto its base. */
static void check_gravity(clod_loader *loader, const clod_case *self, const char *cell)
{
    const double *g = self->gravity;
    if (clean(loader, "gravity") && (g[0] != 0.0 || g[1] != 0.0 || g[2] > 0.0)) {
        clod_check_fail(loader, "gravity",
                        "%s stands upright: gravity must be [0, 0, -g], not "
                        "[%.10g, %.10g, %.10g] m/s2",
                        cell, g[0], g[1], g[2]);
    }
}

static void check_ring(clod_loader *loader, const clod_case *self)
{
    const clod_case_ring_shear *ring = &self->ring_shear;
    clod_check_material(loader, self, "ring_shear.grain_material", ring->grain_material);
    clod_check_material(loader, self, "ring_shear.side_material", ring->side_material);
    clod_check_material(loader, self, "ring_shear.base_material", ring->base_material);
    clod_check_material(loader, self, "ring_shear.lid_material", ring->lid_material);
    check_gravity(loader, self, "a ring shear cell");
    check_radius(loader, "ring_shear", ring->radius_mean, ring->radius_min, ring->radius_max);
    check_cell(loader, ring);
    check_stresses(loader, self);
    check_ways(loader, ring);
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
        clod_check_fail(loader, written(loader, "uniaxial.crush_max", "uniaxial.beyond_peak"),
                        "no peak can be passed: beyond_peak = %.10g is not less than "
                        "crush_max = %.10g",
                        test->beyond_peak, test->crush_max);
    }
}

static void check_uniaxial(clod_loader *loader, const clod_case *self)
{
    const clod_case_uniaxial *test = &self->uniaxial;
    clod_check_material(loader, self, "uniaxial.grain_material", test->grain_material);
    clod_check_material(loader, self, "uniaxial.side_material", test->side_material);
    clod_check_material(loader, self, "uniaxial.base_material", test->base_material);
    clod_check_material(loader, self, "uniaxial.lid_material", test->lid_material);
    check_gravity(loader, self, "the mould of a uniaxial test");
    check_radius(loader, "uniaxial", test->radius_mean, test->radius_min, test->radius_max);
    check_mould(loader, test);
}

static void check_bench(clod_loader *loader, const clod_case *self)
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
    if (self->ring_shear.present) {
        check_ring(loader, self);
    }
    if (self->uniaxial.present) {
        check_uniaxial(loader, self);
    }
    if (self->contact_bench.present) {
        check_bench(loader, self);
    }
}
