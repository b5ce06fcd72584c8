// The preflight of a Jenike shear test against hand calculations (docs/theory/time-step.md,
// jenike.md).

#include <jansson.h>
#include <math.h>
#include <string.h>

#include "support/preflight.h"

#define DENSITY 2481.3

// Radii differ by at most one part in 3000: all grains count as 3 mm. Full by hand: 0.6 pi/4
// 0.06^2 (0.019 + 0.021) m3 = 67858 mm3 is 600 grains of 113.1 mm3.
static const char CASE[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3}\n"
    "  side: {}\n"
    "contacts:\n"
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"
    "    k_adh: 0 N/m^1.5, restitution: 0.3, friction: 0.35}\n"
    "gravity: [0 m/s2, 0 m/s2, -10 m/s2]\n"
    "jenike:\n"
    "  grain_material: ore\n"
    "  side_material: side\n"
    "  base_material: side\n"
    "  lid_material: side\n"
    "  radius: {mean: 3 mm, sd: 1 mm, min: 2.999 mm, max: 3.001 mm}\n"
    "  diameter: 60 mm\n"
    "  base_height: 19 mm\n"
    "  ring_height: 21 mm\n"
    "  grain_count: 600\n"
    "  lid_mass: 0.2 kg\n"
    "  preshear_stress: 50 kPa\n"
    "  shear_stresses: [12.5 kPa, 25 kPa, 40 kPa]\n"
    "  speed: 10 mm/s\n";

// I = (v/h) d sqrt(rho/sigma), h = 40 mm; the points with the same I, half the speed at 1/4.
static void numbers_by_hand(void **state)
{
    (void)state;
    preflight(CASE, NULL);
    assert_int_equal(report.kind, CLOD_CASE_JENIKE);
    assert_int_equal(report.grains, 600);
    check_relative((double)report.full_grains, 600.0, 2e-3);
    check_relative(report.height_aimed, 0.04, 2e-3);
    check_relative(report.across_width, 10.0, 1e-3);
    check_relative(report.across_depth, 40.0 / 6.0, 3e-3);
    check_relative(report.stress, 50e3, 1e-14);
    check_relative(report.lowest_stress, 12.5e3, 1e-14);
    check_relative(report.lowest_speed, 5e-3, 1e-12);
    const double inertia = 0.01 / 0.04 * 6e-3 * sqrt(DENSITY / 50e3);
    check_relative(report.inertial_preshear, inertia, 3e-3);
    check_relative(report.inertial_lowest, inertia, 3e-3);
    assert_true(report.bar_diameters == 0.0);
}

// At most: fill 0.6 s, lower 6 mm at 0.1 m/s, rest 0.3 s, 4 mm at 10 mm/s; once 2 mm back at
// 0.33 mm/s; each point rest 0.3 s, and 2 mm at 5, 7.07 and 8.94 mm/s. Twists: 4 ways of 10
// degrees each, the edge at 10 mm/s.
static void limits_bound_the_time(void **state)
{
    (void)state;
    preflight(CASE, NULL);
    const double usual = 0.6 + 0.06 + 0.3 + 0.4 + 2.0 / 0.33 + 3.0 * 0.3 + 0.2 / 0.5 +
                         0.2 / sqrt(0.5) + 0.2 / sqrt(0.8);
    check_relative(report.time_most, usual, 1e-9);
    assert_true(report.time_likely < report.time_most);
    const double likely = report.time_likely;
    preflight(CASE, "jenike.twists=3");
    const double twisted = 3.0 * 4.0 * (10.0 * M_PI / 180.0) * 0.03 / 0.01;
    check_relative(report.time_most, usual + twisted, 1e-9);
    check_relative(report.time_likely, likely + twisted, 1e-9);
}

static void json_and_text_say_the_same(void **state)
{
    static char text[CLOD_CHECK_TEXT];
    (void)state;
    preflight(CASE, NULL);
    assert_true(clod_check_report_json(&report, text));
    json_t *json = json_loads(text, 0, NULL);
    assert_string_equal(json_string_value(json_object_get(json, "kind")), "jenike");
    assert_true(json_real_value(json_object_get(json, "lowest_stress_Pa")) == 12.5e3);
    assert_null(json_object_get(json, "bar_height_diameters"));
    json_decref(json);
    clod_check_report_text(&report, text);
    assert_non_null(strstr(text, "cell               10.0 grain diameters wide, 6.7 deep\n"));
    assert_non_null(strstr(text, "preshear stress    50 kPa"));
}

static void each_fault_has_its_warning(void **state)
{
    (void)state;
    preflight(CASE, NULL);
    assert_int_equal(report.warning_count, 0);
    assert_true(preflight_warns(CASE, "jenike.speed=60 mm/s", "Lower jenike.speed to 30 mm/s"));
    assert_true(preflight_warns(CASE, "jenike.grain_count=900",
                                "Change jenike.grain_count, or write auto"));
    assert_true(
        preflight_warns(CASE, "jenike.grain_count=440", "grain diameters across the depth"));
    assert_true(
        preflight_warns(CASE, "jenike.diameter=28 mm", "grain diameters across the width"));
    assert_false(preflight_warns(CASE, "jenike.lid_mass=10 kg", "jenike.lid_mass"));
    assert_non_null(strstr(report.note[0], "With a lower jenike.lid_mass it needs none"));
    assert_true(preflight_warns(CASE, "jenike.shear_stresses=[20 kPa, 30 kPa]",
                                "jenike.shear_stresses"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_by_hand),
        cmocka_unit_test(limits_bound_the_time),
        cmocka_unit_test(json_and_text_say_the_same),
        cmocka_unit_test(each_fault_has_its_warning),
    };
    return cmocka_run_group_tests(tests, NULL, preflight_end);
}
