// The preflight of cases with too many grains, too few, and of those that are hard to time.

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "support/preflight.h"

#define MATERIALS                                                                              \
    "materials:\n"                                                                             \
    "  ore: {density: 2481.3 kg/m3, youngs_modulus: 119 GPa, poissons_ratio: 0.34}\n"          \
    "contacts:\n"                                                                              \
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"          \
    "    k_adh: 3.56e8 N/m^1.5, restitution: 0.3, friction: 0.35}\n"

// Full to 40 mm by hand: 0.6 of 942478 mm3 (ring) - 37643 mm3 (40 bars of 49.4 x 3 x 6.35 mm)
// is the volume of 4800 grains of 3 mm, 542.9 cm3.
static const char RING[] = MATERIALS "gravity: [0, 0, -10 m/s2]\n"
                                     "ring_shear:\n"
                                     "  grain_material: ore\n"
                                     "  side_material: ore\n"
                                     "  base_material: ore\n"
                                     "  lid_material: ore\n"
                                     "  preshear_stress: 50 kPa\n"
                                     "  shear_stresses: [12.5 kPa, 25 kPa, 40 kPa]\n"
                                     "  radius: {mean: %s, sd: %s, min: %s, max: %s}\n";

static const char HERTZ[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3, youngs_modulus: 119 GPa, poissons_ratio: 0.34}\n"
    "contacts: {default: {law: hertz}}\n"
    "grains:\n"
    "  - material: ore\n"
    "    mass: 20 g\n"
    "    radius: {distribution: uniform, min: 2.999 mm, max: 3.001 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 60 mm]}}\n"
    "walls: {floor: {material: ore, shapes: [{plane: {point: [0 m, 0 m, 0 m]}}]}}\n"
    "stages: [{name: one, duration: 1 ms}]\n";

/** The preflight of a text with some changes for ranks (0: one process), which may be refused. */
static bool accepted_on(int ranks, const char *text, const char *const *changes, size_t count,
                        clod_status *status)
{
    const clod_check_options options = {.threads = 1, .ranks = ranks, .directory = "."};
    *status = (clod_status){CLOD_OK, ""};
    clod_case_destroy(&preflight_case);
    preflight_case = case_at("case.yaml", text, changes, count);
    return clod_check_report_make(preflight_case, &options, &report, status);
}

static bool accepted(const char *text, const char *const *changes, size_t count,
                     clod_status *status)
{
    return accepted_on(0, text, changes, count, status);
}

// 4800 * 15^3 = 16.2e6 grains of 0.2 mm: a sample tells what they are like, and the start is
// not tried. 1/15 of the diameter of 3 mm grains makes the cell 15 times as many wide.
static void a_powder_is_estimated_from_a_sample(void **state)
{
    (void)state;
    char powder[2048];
    clod_status status;
    const clock_t begin = clock();
    snprintf(powder, sizeof powder, RING, "0.2 mm", "1 mm", "0.1999 mm", "0.2001 mm");
    assert_true(accepted(powder, NULL, 0, &status));
    check_relative((double)report.grains, 16.2e6, 2e-3);
    assert_in_range(report.sampled, 1000, 100000);
    check_relative(report.solid_volume, 542.9e-6, 2e-3);
    check_relative(report.mass, 542.9e-6 * 2481.3, 2e-3);
    check_relative(report.height_aimed, 40e-3, 2e-3);
    check_relative(report.across_width, 50.0 / 0.4, 1e-3);
    assert_true(report.height_loose > 60e-3 && report.height_loose < 120e-3);
    assert_true(report.rate > 0.0 && report.clock_most > 0.0 && report.memory > 1e9);
    assert_non_null(strstr(report.note[report.note_count - 1], "no step was tried"));
    assert_true(clock() - begin < 10 * CLOCKS_PER_SEC);
}

// Cut at one sd the variance is 0.291 sd^2: 542.9e-6 m3 of grains of 4/3 pi (125 + 3 * 5 *
// 0.291) um3 are 1.0e12 grains. They are refused before one of them is made.
static void more_grains_than_memory_holds_are_refused_at_once(void **state)
{
    (void)state;
    char powder[2048];
    clod_status status;
    const clock_t begin = clock();
    snprintf(powder, sizeof powder, RING, "5 um", "1 um", "4 um", "6 um");
    assert_false(accepted(powder, NULL, 0, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "ring_shear: 1e+12 grains need at least"));
    assert_true(clock() - begin < 5 * CLOCKS_PER_SEC);
}

// By hand, as below: 280.63 t are 1e9 grains of 0.28063 g. They want 500 GB at least, which no machine that
// builds this has, but many together may. A share of a million takes 720 bytes a grain.
static void more_grains_than_memory_holds_are_for_ranks(void **state)
{
    (void)state;
    static const char *const change[] = {
        "grains.0.mass=280630 kg",
        "grains.0.region={box: {min: [0 m, 0 m, 0 m], max: [7.5 m, 7.5 m, 7.5 m]}}"};
    clod_status status;
    assert_false(accepted_on(1, HERTZ, change, 2, &status));
    assert_non_null(strstr(status.text, "of memory, and this machine has"));
    if (!accepted_on(1000, HERTZ, change, 2, &status)) {
        fail_msg("%s", status.text);
    }
    check_relative(report.of_ranks.own, 1e6, 1e-3);
    check_at_least(report.of_ranks.begin_0, 0.72e9);
    bool told = false;
    for (size_t w = 0; w < report.warning_count; w++) {
        told = told || strstr(report.warning[w], "all ranks together may need") != NULL;
    }
    assert_true(told);
}

// By hand: a grain of 3 mm has 0.28063 g, so 71 of them are 0.02 kg within 0.4 %; 0.8 g are
// nearest to three of them, 5.2 % more; less than half a grain more or less is taken.
static void whole_grains_that_miss_the_mass_are_told(void **state)
{
    (void)state;
    preflight(HERTZ, NULL);
    assert_int_equal(report.grains, 71);
    assert_false(preflight_warns(HERTZ, NULL, "asks for"));
    assert_true(preflight_warns(HERTZ, "grains.0.mass=0.8 g",
                                "3 grains of 0.000842 kg in all stand for the 0.0008 kg"));
    assert_true(preflight_warns(HERTZ, "grains.0.mass=0.3 g", "1 grain of 0.00028 kg"));
    assert_false(preflight_warns(HERTZ, "grains.0.mass=0.56 g", "asks for"));
}

// These had a timing bed that overlapped, or was thinner than the skin.
static void soft_fast_and_high_cases_are_timed(void **state)
{
    (void)state;
    static const char *const CHANGES[] = {
        "materials.ore.youngs_modulus=1 kPa",
        "grains.0.velocity=[0 m/s, 200 m/s, 0 m/s]",
        "grains.0.region.box={min: [0 m, 0 m, 200 m], max: [0.06 m, 0.06 m, 200.06 m]}",
        "gravity=[0 m/s2, 0 m/s2, -10000 m/s2]",
    };
    for (size_t c = 0; c < sizeof CHANGES / sizeof CHANGES[0]; c++) {
        preflight(HERTZ, CHANGES[c]);
        assert_int_equal(report.note_count, 0);
        assert_true(report.rate > 1e4 && report.rate < 1e10);
        assert_true(report.rate_slowest > 0.0 && report.rate_slowest <= report.rate);
        assert_true(report.processor_share > 0.0 && report.processor_share <= 1.0);
    }
}

// 4 radii of 3.001 mm and twice the skin of 0.3 of them are 13.8 mm.
static void a_period_that_is_too_short_is_refused(void **state)
{
    (void)state;
    static const char *const CHANGES[] = {
        "grains.0.region.box.max=[13 mm, 60 mm, 60 mm]",
        "domain={min: [0 mm, 0 mm, 0 mm], max: [13 mm, 60 mm, 60 mm],"
        " periodic: [true, false, false]}",
    };
    clod_status status;
    assert_false(accepted(HERTZ, CHANGES, 2, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "the period along x is 0.013 m"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_powder_is_estimated_from_a_sample),
        cmocka_unit_test(more_grains_than_memory_holds_are_refused_at_once),
        cmocka_unit_test(more_grains_than_memory_holds_are_for_ranks),
        cmocka_unit_test(whole_grains_that_miss_the_mass_are_told),
        cmocka_unit_test(soft_fast_and_high_cases_are_timed),
        cmocka_unit_test(a_period_that_is_too_short_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, preflight_end);
}
