// The preflight of measures of a test whose regions no grain comes to.

#include <stdio.h>

#include "support/preflight.h"

// A ring of 100 mm in radius, filled to 40 mm after it settles and to at most 100 mm before.
static const char RING[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3}\n"
    "  side: {}\n"
    "contacts:\n"
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"
    "    k_adh: 3.56e8 N/m^1.5, restitution: 0.3, friction: 0.35}\n"
    "gravity: [0, 0, -10 m/s2]\n"
    "ring_shear:\n"
    "  grain_material: ore\n"
    "  side_material: side\n"
    "  base_material: side\n"
    "  lid_material: side\n"
    "  radius: {mean: 3 mm, sd: 1 mm, min: 2.9 mm, max: 3.1 mm}\n"
    "  preshear_stress: 50 kPa\n"
    "  speed: 30 mm/s\n"
    "  shear_stresses: [12.5 kPa, 25 kPa, 40 kPa]\n";

#define ANNULUS                                                                                \
    "{annulus: {center: [0 m, 0 m, %s], inner_radius: 50 mm, outer_radius: 100 mm, height: 20 mm}}"

/** Whether a mean over an annulus, an index in it, or a grid beside it is warned of. */
static bool warns_of(const char *format, const char *place, const char *words)
{
    char change[256];
    snprintf(change, sizeof change, format, place);
    return preflight_warns(RING, change, words);
}

// Grains lie from the base at z = 0 upwards, below 0.1 m, and within 100 mm of the axis.
static void a_place_without_grains_is_warned_of(void **state)
{
    (void)state;
    const char *mean = "fields={f: {region: " ANNULUS "}}";
    const char *index = "mixing={m: {cell: 10 mm, above: 3 mm, region: " ANNULUS "}}";
    const char *grid =
        "fields={g: {cell: 10 mm, width: 15 mm, region: {box: {min: [%s, 0 m, 0 m],"
        " max: [350 mm, 50 mm, 40 mm]}}}}";
    assert_true(warns_of(mean, "600 mm", "fields.f.region is from 0.6 m to 0.62 m along z"));
    assert_true(warns_of(mean, "600 mm", "where no grain comes: they are filled in between"));
    assert_true(warns_of(mean, "-20 mm", "fields.f.region is from -0.02 m to 0 m along z"));
    assert_true(warns_of(index, "600 mm", "mixing.m.region is from 0.6 m"));
    assert_true(warns_of(grid, "320 mm", "fields.g.region is from 0.32 m to 0.35 m along x"));
    assert_false(warns_of(mean, "10 mm", "no grain comes"));
    assert_false(warns_of(index, "10 mm", "no grain comes"));
    assert_false(warns_of(grid, "90 mm", "no grain comes"));
}

// A grid sees grains as far from it as its kernel is wide: from 1 cm below, not from 2 cm.
static void a_kernel_reaches_into_the_bed(void **state)
{
    (void)state;
    const char *grid =
        "fields={g: {cell: 10 mm, width: 15 mm, region: {box: {min: [0 m, 50 mm, -40 mm],"
        " max: [50 mm, 100 mm, -%s]}}}}";
    assert_false(warns_of(grid, "10 mm", "no grain comes"));
    assert_true(warns_of(grid, "20 mm", "no grain comes"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_place_without_grains_is_warned_of),
        cmocka_unit_test(a_kernel_reaches_into_the_bed),
    };
    return cmocka_run_group_tests(tests, NULL, preflight_end);
}
