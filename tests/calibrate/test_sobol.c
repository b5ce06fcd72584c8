/**
 * Sobol points. Expected: the sequence is a (0, m, 1)-net in each coordinate: of the first 2^m points,
 * the origin among them, each interval [k, k + 1) / 2^m has one. That is its definition.
 */

#include <math.h>

#include "calibrate/sobol.h"
#include "support/check.h"

#define POINTS 64
#define DIMENSIONS 16

static void every_interval_of_a_coordinate_has_one_point(void **state)
{
    (void)state;
    static double points[POINTS][DIMENSIONS]; // row 0 stays the origin
    assert_true(clod_sobol_fill(DIMENSIONS, POINTS - 1, points[1]));
    for (int k = 0; k < DIMENSIONS; k++) {
        int found[POINTS] = {0};
        for (int i = 0; i < POINTS; i++) {
            found[(int)(points[i][k] * POINTS)]++;
        }
        for (int i = 0; i < POINTS; i++) {
            assert_int_equal(found[i], 1);
        }
    }
}

static void the_first_point_is_the_middle_and_all_lie_inside(void **state)
{
    (void)state;
    double points[POINTS][3];
    assert_true(clod_sobol_fill(3, POINTS, points[0]));
    for (int k = 0; k < 3; k++) {
        assert_true(points[0][k] == 0.5);
        for (int i = 0; i < POINTS; i++) {
            assert_true(points[i][k] > 0.0 && points[i][k] < 1.0);
        }
    }
}

/** Of the first 4^m points in two dimensions each square of 2^-m has one (it is a (0, 2m, 2)-net). */
static void every_square_of_two_coordinates_has_one_point(void **state)
{
    (void)state;
    double points[POINTS][2] = {{0.0, 0.0}};
    assert_true(clod_sobol_fill(2, POINTS - 1, points[1]));
    int found[8][8] = {{0}};
    for (int i = 0; i < POINTS; i++) {
        found[(int)(8.0 * points[i][0])][(int)(8.0 * points[i][1])]++;
    }
    for (int i = 0; i < POINTS; i++) {
        assert_int_equal(found[i / 8][i % 8], 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_interval_of_a_coordinate_has_one_point),
        cmocka_unit_test(the_first_point_is_the_middle_and_all_lie_inside),
        cmocka_unit_test(every_square_of_two_coordinates_has_one_point),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
