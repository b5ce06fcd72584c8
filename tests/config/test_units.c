/**
 * Numbers with units. Expected values: definitions of the units (BIPM, SI brochure, 9th
 * edition; NIST SP 811 for US units: lbf = 4.4482216152605 N, lb = 0.45359237 kg, ft = 0.3048
 * m).
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "config/unit.h"

#define PI 3.14159265358979323846

static double convert(const char *text, const char *unit)
{
    char message[CLOD_UNIT_MESSAGE] = "";
    double value = 0.0;
    const char *written = clod_unit_number(text, &value);
    assert_non_null(written);
    if (!clod_unit_convert(written, unit, &value, message)) {
        fail_msg("%s: %s", text, message);
    }
    return value;
}

static void same(double value, double expected)
{
    if (!(fabs(value - expected) <= 4e-16 * fabs(expected))) {
        fail_msg("%.17g is not %.17g", value, expected);
    }
}

static void refused(const char *text, const char *unit, const char *part)
{
    char message[CLOD_UNIT_MESSAGE] = "";
    double value = 0.0;
    const char *written = clod_unit_number(text, &value);
    assert_non_null(written);
    if (clod_unit_convert(written, unit, &value, message) || strstr(message, part) == NULL) {
        fail_msg("%s for %s gave %.17g and \"%s\"", text, unit, value, message);
    }
}

/** Limits of angles are so many degrees: what a user writes for one is allowed, to the last bit. */
static void degrees_are_those_of_the_limits(void **state)
{
    (void)state;
    for (int degrees = -360; degrees <= 360; degrees++) {
        char text[32];
        snprintf(text, sizeof text, "%d deg", degrees);
        assert_true(convert(text, "rad") == degrees * CLOD_UNIT_DEGREE);
    }
    same(CLOD_UNIT_DEGREE, PI / 180.0);
}

static void units_of_the_field_are_exact(void **state)
{
    (void)state;
    same(convert("54.8 kPa", "Pa"), 54800.0);
    same(convert("119 GPa", "Pa"), 119e9);
    same(convert("2 bar", "Pa"), 2e5);
    same(convert("6.35 mm", "m"), 0.00635);
    same(convert("3um", "m"), 3e-6);
    same(convert("25 cm2", "m2"), 25e-4);
    same(convert("2.4813 g/cm3", "kg/m3"), 2481.3);
    same(convert("1.2 t/m3", "kg/m3"), 1200.0);
    same(convert("2 kg m-3", "kg/m3"), 2.0);
    same(convert("2 kg*m^-3", "kg/m3"), 2.0);
    same(convert("30 mm/min", "m/s"), 0.03 / 60.0);
    same(convert("-9.81 m/s^2", "m/s2"), -9.81);
    same(convert("20 rpm", "rad/s"), 20.0 * 2.0 * PI / 60.0);
    same(convert("180 deg", "rad"), PI);
    same(convert("1 h", "s"), 3600.0);
    same(convert("2 mJ", "J"), 2e-3);
    same(convert("3 N m", "J"), 3.0);
    same(convert("1 kW h", "J"), 3.6e6);
    same(convert("5 kW", "W"), 5000.0);
    same(convert("4 kN m", "N m"), 4000.0);
    same(convert("2 1/s", "1/s"), 2.0);
    same(convert("60 Hz", "1/s"), 60.0);
    same(convert("3 mm3/h", "m3/s"), 3e-9 / 3600.0);
    same(convert("5 cm2/s2", "m2/s2"), 5e-4);
    same(convert("1 psf", "Pa"), 4.4482216152605 / (0.3048 * 0.3048));
    same(convert("100 pcf", "kg/m3"), 45.359237 / (0.3048 * 0.3048 * 0.3048));
    same(convert("1 psi", "Pa"), 4.4482216152605 / (0.0254 * 0.0254));
    same(convert("2 short_ton", "kg"), 2.0 * 2000.0 * 0.45359237);
}

// A kilopond is the weight of 1 kg at 9.80665 m/s2, a pound-force that of 0.45359237 kg.
static void masses_on_an_area_are_no_pressure(void **state)
{
    (void)state;
    same(convert("2 kgf/cm2", "Pa"), 2.0 * 9.80665e4);
    same(convert("2 kp/cm2", "Pa"), 2.0 * 9.80665e4);
    same(convert("3 kp", "N"), 3.0 * 9.80665);
    same(convert("1 gf/cm2", "Pa"), 98.0665);
    same(convert("1 lbf/ft2", "Pa"), 4.4482216152605 / (0.3048 * 0.3048));
    refused("1 g/cm2", "Pa",
            "1 g/cm2 is a mass on an area, not a pressure; its weight on it is 1 gf/cm2");
    refused("0.5 kg/cm^2", "Pa", "its weight on it is 0.5 kgf/cm^2");
    refused("20 kg/m2", "Pa", "its weight on it is 20 kgf/m2");
    refused("100 lb/ft2", "Pa", "its weight on it is 100 lbf/ft2");
    refused("2 m-2 kg", "Pa", "2 m-2 kg is not a pressure");
    refused("2 g/cm3", "Pa", "2 g/cm3 is not a pressure");
    refused("2 g/cm2", "kg", "2 g/cm2 is not a mass");
}

static void typeset_spellings_are_read(void **state)
{
    (void)state;
    same(convert("1 g/cm\u00b3", "kg/m3"), 1000.0);
    same(convert("3 \u00b5m", "m"), 3e-6);
    same(convert("3 \u03bcm", "m"), 3e-6);
    same(convert("90 \u00b0", "rad"), PI / 2.0);
    same(convert("4 m\u00b7s-2", "m/s2"), 4.0);
}

static void pure_numbers_take_percent_only(void **state)
{
    (void)state;
    same(convert("0.35", "1"), 0.35);
    same(convert("8 %", "1"), 0.08);
    refused("0.5 N", "1", "takes a pure number or %, not the unit \"N\"");
    refused("5 %", "Pa", "5 % is not a pressure");
    refused("5 W", "J", "5 W is not an energy; use a unit such as mJ");
    refused("5 rad/s", "1/s", "is not a rate");
}

static void zero_needs_no_unit_but_others_do(void **state)
{
    (void)state;
    same(convert("0", "Pa"), 0.0);
    same(convert("-0.0", "m"), 0.0);
    refused("54.8", "Pa", "54.8 needs a unit of pressure, for instance 54.8 kPa");
    refused("1e-300", "m", "needs a unit of length");
}

// The traps of UDUNITS-2 that are written down in DEPENDENCIES.md, and those found since.
static void traps_of_udunits_are_closed(void **state)
{
    (void)state;
    refused("1 N/m^1.5", "N", "is not a unit"); // 5 N/m to udunits
    refused("1 N m-1.5", "N", "is not a unit");
    refused("1 m2.5", "m2", "is not a unit");
    refused("1 ton/m3", "kg/m3", "\"ton\" means different masses");
    refused("1 kton", "kg", "means different masses");
    refused("20 Hz", "rad/s", "is not a speed of rotation"); // 1 Hz passes for 1 rad/s
    refused("20 degC", "m", "is not a length");
    refused("1 rad m", "m", "is not a length");
    refused("3 2 m", "m", "is not a unit");
    refused("1 m since 2000", "m", "is not a unit");
    refused("1 (m)", "m", "is not a unit");
    refused("54.8 kpa", "Pa", "did you mean kPa?");
    refused("6 mm", "Pa", "6 mm is not a pressure; use a unit such as kPa");
    refused("1e300 km2 Gm2", "m2", "is not an area");
    refused("1e308 km", "m", "is too large a number");
    same(convert("3 newton", "N"), 3.0); // ends like ton
    same(convert("3 kilonewtons", "N"), 3000.0);
}

static void only_decimal_numbers_are_numbers(void **state)
{
    (void)state;
    static const char *const WRONG[] = {"",  "x",  "nan", "inf",   "-",
                                        ".", "e5", "--1", "1e999", "+-2"};
    double value = 0.0;
    for (size_t i = 0; i < sizeof WRONG / sizeof WRONG[0]; i++) {
        if (clod_unit_number(WRONG[i], &value) != NULL) {
            fail_msg("\"%s\" passed for a number", WRONG[i]);
        }
    }
    assert_string_equal(clod_unit_number("0x10", &value), "x10"); // then not a unit
    assert_string_equal(clod_unit_number(" 4.75e8 N/m", &value), "N/m");
    same(value, 4.75e8);
    assert_string_equal(clod_unit_number("5e m", &value), "e m");
    same(value, 5.0);
    same(convert(".5 m", "m"), 0.5);
    same(convert("+5. m", "m"), 5.0);
}

static double stiffness(const char *text, double exponent)
{
    char message[CLOD_UNIT_MESSAGE] = "";
    double value = 0.0;
    const char *written = clod_unit_number(text, &value);
    assert_non_null(written);
    if (!clod_unit_stiffness(written, exponent, &value, message)) {
        fail_msg("%s: %s", text, message);
    }
    return value;
}

// By hand: 1 N/mm^1.5 = 1 N / (1e-3 m)^1.5 = 10^4.5 N/m^1.5.
static void stiffness_goes_with_its_exponent(void **state)
{
    (void)state;
    same(stiffness("4.75e8 N/m^1.5", 1.5), 4.75e8);
    same(stiffness("475 MN/m^1.5", 1.5), 4.75e8);
    same(stiffness("2 kN/m", 1.0), 2000.0);
    same(stiffness("2 GN/m^1", 1.0), 2e9);
    same(stiffness("3 N/mm", 1.0), 3000.0);
    same(stiffness("1 N/mm^1.5", 1.5), 31622.776601683792);
    same(stiffness("7 N/m^2", 2.0), 7.0);
    same(stiffness("0", 1.5), 0.0);
}

static void other_stiffness_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *unit, *part;
    } WRONG[] = {
        {"N/m", "N/m does not go with exponent 1.5 of this contact; write N/m^1.5"},
        {"N/m^2", "does not go with exponent 1.5"},
        {"N/mm", "does not go with exponent 1.5"},
        {"", "4 needs a unit of stiffness, for instance 4 N/m^1.5"},
        {"N/m^", "is not a stiffness"},
        {"N/m^-1.5", "is not a stiffness"},
        {"N/m1.5", "is not a stiffness"},
        {"N/", "is not a stiffness"},
        {"N", "is not a stiffness"},
        {"mN/m^1.5", "is not a stiffness"},
        {"Pa", "is not a stiffness"},
        {"N/m^1.5 x", "is not a stiffness"},
    };
    for (size_t i = 0; i < sizeof WRONG / sizeof WRONG[0]; i++) {
        char message[CLOD_UNIT_MESSAGE] = "";
        double value = 4.0;
        if (clod_unit_stiffness(WRONG[i].unit, 1.5, &value, message) ||
            strstr(message, WRONG[i].part) == NULL) {
            fail_msg("%s: \"%s\"", WRONG[i].unit, message);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(degrees_are_those_of_the_limits),
        cmocka_unit_test(units_of_the_field_are_exact),
        cmocka_unit_test(masses_on_an_area_are_no_pressure),
        cmocka_unit_test(typeset_spellings_are_read),
        cmocka_unit_test(pure_numbers_take_percent_only),
        cmocka_unit_test(zero_needs_no_unit_but_others_do),
        cmocka_unit_test(traps_of_udunits_are_closed),
        cmocka_unit_test(only_decimal_numbers_are_numbers),
        cmocka_unit_test(stiffness_goes_with_its_exponent),
        cmocka_unit_test(other_stiffness_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
