// The preflight of a uniaxial test against hand calculations (docs/theory/mepa.md,
// time-step.md).

#include <jansson.h>
#include <math.h>
#include <string.h>

#include "support/preflight.h"

#define DENSITY 2481.3

// Radii differ by at most one part in 3000: all grains count as 3 mm. Full to 60 mm by hand:
// 0.6 pi/4 0.06^2 0.06 m3 = 101788 mm3 is 900 grains of 113.1 mm3.
static const char CASE[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3}\n"
    "  side: {}\n"
    "contacts:\n"
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"
    "    k_adh: 3.56e8 N/m^1.5, restitution: 0.3, friction: 0.35}\n"
    "uniaxial:\n"
    "  grain_material: ore\n"
    "  side_material: side\n"
    "  base_material: side\n"
    "  lid_material: side\n"
    "  radius: {mean: 3 mm, sd: 1 mm, min: 2.999 mm, max: 3.001 mm}\n"
    "  diameter: 60 mm\n"
    "  height: 60 mm\n"
    "  grain_count: 450\n"
    "  consolidation_stresses: [50 kPa, 10 kPa]\n"
    "  speed: 10 mm/s\n"
    "  crush_max: 15 %\n";

// Half of the grains: 30 mm. I = (v/h) d sqrt(rho/sigma) at the lower stress.
static void numbers_by_hand(void **state)
{
    (void)state;
    preflight(CASE, NULL);
    assert_int_equal(report.kind, CLOD_CASE_UNIAXIAL);
    assert_int_equal(report.grains, 450);
    check_relative((double)report.full_grains, 900.0, 2e-3);
    check_relative(report.height_aimed, 0.03, 2e-3);
    check_relative(report.across_width, 10.0, 1e-3);
    check_relative(report.across_depth, 5.0, 3e-3);
    check_relative(report.stress, 50e3, 1e-14);
    check_relative(report.lowest_stress, 10e3, 1e-14);
    check_relative(report.inertial_lowest, 0.01 / 0.03 * 6e-3 * sqrt(DENSITY / 10e3), 3e-3);
    // filling 0.6 s; each of two: lid from 60 mm at 0.1 m/s, two rests of 0.3 s, 9 mm at 10
    // mm/s
    check_relative(report.time_most, 0.6 + 2.0 * (0.6 + 0.6 + 0.9), 1e-12);
    assert_true(report.time_likely < report.time_most);
}

static void json_and_text_say_the_same(void **state)
{
    static char text[CLOD_CHECK_TEXT];
    (void)state;
    preflight(CASE, NULL);
    assert_true(clod_check_report_json(&report, text));
    json_t *json = json_loads(text, 0, NULL);
    assert_string_equal(json_string_value(json_object_get(json, "kind")), "uniaxial");
    assert_true(json_real_value(json_object_get(json, "lowest_stress_Pa")) == 10e3);
    json_decref(json);
    clod_check_report_text(&report, text);
    assert_non_null(strstr(text, "mould              10.0 grain diameters wide, 5.0 high"));
    assert_non_null(strstr(text, "largest stress     50 kPa"));
}

static void a_fast_or_thin_test_is_told(void **state)
{
    (void)state;
    assert_false(preflight_warns(CASE, NULL, "inertial number"));
    assert_true(
        preflight_warns(CASE, "uniaxial.speed=20 mm/s", "Lower uniaxial.speed to 10 mm/s"));
    assert_true(preflight_warns(CASE, "uniaxial.diameter=50 mm",
                                "only 8.3 grain diameters across the specimen"));
    assert_false(preflight_warns(CASE, "uniaxial.diameter=70 mm", "across the specimen"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_by_hand),
        cmocka_unit_test(json_and_text_say_the_same),
        cmocka_unit_test(a_fast_or_thin_test_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, preflight_end);
}
