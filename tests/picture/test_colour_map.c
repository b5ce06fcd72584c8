/**
 * @file test_colour_map.c
 * Colour maps: equal steps look equally large, and lightness tells the order in grey print.
 */

#include "picture/colour_map.h"

#include <math.h>
#include <string.h>

#include "support/check.h"

static double to_light(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}

/** CIE L* of an sRGB colour (D65): another measure than the one the maps are made with. */
static double lightness(const double rgb[3])
{
    const double y =
        0.2126 * to_light(rgb[0]) + 0.7152 * to_light(rgb[1]) + 0.0722 * to_light(rgb[2]);
    return y > 216.0 / 24389.0 ? 116.0 * cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

/** Linear sRGB to OKLab by the other pair of matrices of its definition. */
static void to_lab(const double rgb[3], double lab[3])
{
    const double r = to_light(rgb[0]);
    const double g = to_light(rgb[1]);
    const double b = to_light(rgb[2]);
    const double l = cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    lab[0] = 0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s;
    lab[1] = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
    lab[2] = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
}

static clod_colour_map make(const char *name)
{
    clod_colour_map map;
    clod_status status;
    assert_true(clod_colour_map_make(&map, name, &status));
    return map;
}

static void steps_look_equally_large(void **state)
{
    (void)state;
    static const char *const NAMES[] = {"sea", "ember", "balance", "grey"};
    for (int n = 0; n < 4; n++) {
        const clod_colour_map map = make(NAMES[n]);
        double least = HUGE_VAL;
        double most = 0.0;
        for (int k = 4; k < CLOD_COLOUR_MAP_SIZE; k += 4) {
            double a[3], b[3];
            to_lab(map.colour[k - 4], a);
            to_lab(map.colour[k], b);
            const double step =
                sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                     (a[2] - b[2]) * (a[2] - b[2]));
            least = fmin(least, step);
            most = fmax(most, step);
        }
        // four steps of a bent path are a little shorter than along it
        assert_true(least > 0.9 * most);
    }
}

static void lightness_rises(void **state)
{
    (void)state;
    static const char *const NAMES[] = {"sea", "ember", "grey"};
    for (int n = 0; n < 3; n++) {
        const clod_colour_map map = make(NAMES[n]);
        for (int k = 1; k < CLOD_COLOUR_MAP_SIZE; k++) {
            assert_true(lightness(map.colour[k]) > lightness(map.colour[k - 1]));
        }
        assert_true(lightness(map.colour[255]) - lightness(map.colour[0]) > 45.0);
    }
}

/** The middle of `balance` is a light grey; both ends are equally dark and blue and red. */
static void balance_is_even(void **state)
{
    (void)state;
    const clod_colour_map map = make("balance");
    const double *middle = map.colour[128];
    check_close(middle[0], middle[1], 0.02);
    check_close(middle[1], middle[2], 0.02);
    check_close(lightness(map.colour[0]), lightness(map.colour[255]), 6.0);
    assert_true(map.colour[0][2] > map.colour[0][0]);
    assert_true(map.colour[255][0] > map.colour[255][2]);
}

static void values_find_their_colour(void **state)
{
    (void)state;
    assert_int_equal(clod_colour_map_index(-1.0, 0.0, 1.0), 0);
    assert_int_equal(clod_colour_map_index(0.0, 0.0, 1.0), 0);
    assert_int_equal(clod_colour_map_index(0.5, 0.0, 1.0), 128);
    assert_int_equal(clod_colour_map_index(1.0, 0.0, 1.0), 255);
    assert_int_equal(clod_colour_map_index(9.0, 0.0, 1.0), 255);
    assert_int_equal(clod_colour_map_index(1.0, -3.0, 5.0), 128);
}

static void an_unknown_map_is_refused(void **state)
{
    (void)state;
    clod_colour_map map;
    clod_status status;
    assert_false(clod_colour_map_make(&map, "rainbow", &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "rainbow"));
    assert_non_null(strstr(status.text, "sea, ember, balance, grey"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_look_equally_large),  cmocka_unit_test(lightness_rises),
        cmocka_unit_test(balance_is_even),           cmocka_unit_test(values_find_their_colour),
        cmocka_unit_test(an_unknown_map_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
