// Curves through measured points, and where they meet a flow factor: worked out by hand.

#include "hopper/curve.h"
#include "support/check.h"

static clod_curve_point SLOPED[] = {
    {.x = 2.0, .y = 3.0}, {.x = 4.0, .y = 4.0}, {.x = 8.0, .y = 4.8}};

static clod_curve curve(clod_curve_way way, clod_curve_point *points, size_t count)
{
    return (clod_curve){.way = way, .points = points, .count = count};
}

static void ways_differ_beyond_the_points(void **state)
{
    (void)state;
    const clod_curve held = curve(CLOD_CURVE_HELD, SLOPED, 3);
    const clod_curve extended = curve(CLOD_CURVE_EXTENDED, SLOPED, 3);
    const double both[][2] = {{2, 3}, {3, 3.5}, {4, 4}, {6, 4.4}, {8, 4.8}};
    for (size_t k = 0; k < 5; k++) {
        check_close(clod_curve_at(&held, both[k][0]), both[k][1], 1e-14);
        check_close(clod_curve_at(&extended, both[k][0]), both[k][1], 1e-14);
    }
    check_close(clod_curve_at(&held, 0.5), 3.0, 1e-15);
    check_close(clod_curve_at(&held, 20.0), 4.8, 1e-15);
    check_close(clod_curve_at(&extended, 0.0), 2.0, 1e-15);
    check_close(clod_curve_at(&extended, 18.0), 6.8, 1e-14);
}

/** Means 14/3 and 59/15; sums 56/3 and 16/3: slope 2/7, intercept 2.6. */
static void a_line_is_that_of_least_squares(void **state)
{
    (void)state;
    const clod_curve line = curve(CLOD_CURVE_LINE, SLOPED, 3);
    check_close(clod_curve_at(&line, 7.0), 2.6 + 2.0, 1e-13);
    check_close(clod_curve_at(&line, 0.0), 2.6, 1e-13);
}

static void one_point_is_a_line_from_the_origin(void **state)
{
    (void)state;
    clod_curve_point one = {.x = 2.0, .y = 1.0};
    const clod_curve extended = curve(CLOD_CURVE_EXTENDED, &one, 1);
    const clod_curve held = curve(CLOD_CURVE_HELD, &one, 1);
    check_close(clod_curve_at(&extended, 6.0), 3.0, 1e-15);
    check_close(clod_curve_at(&held, 6.0), 1.0, 1e-15);
    const clod_curve none = curve(CLOD_CURVE_HELD, NULL, 0);
    assert_true(isnan(clod_curve_at(&none, 6.0)));
}

static void properties_do_not_fall_below_zero(void **state)
{
    (void)state;
    clod_curve_point steep[] = {{.x = 2.0, .y = 1.0}, {.x = 3.0, .y = 2.0}};
    const clod_curve extended = curve(CLOD_CURVE_EXTENDED, steep, 2);
    check_close(clod_curve_at(&extended, 0.5), 0.0, 0.0);
}

/** On the first piece 2 + x/2 = x at 4: at the corner; = 1.25 x at 2.6667; on the last,
 *  3.2 + 0.2 x = 0.6 x at 8. */
static void rays_are_met_on_every_piece(void **state)
{
    (void)state;
    const clod_curve extended = curve(CLOD_CURVE_EXTENDED, SLOPED, 3);
    const double known[][2] = {{1.0, 4.0}, {1.25, 8.0 / 3.0}, {0.6, 8.0},
                               {0.7, 6.4}, {0.4, 16.0},       {20.0, 2.0 / 19.5}};
    for (size_t k = 0; k < 6; k++) {
        double x;
        assert_int_equal(clod_curve_meet(&extended, known[k][0], (double)INFINITY, &x),
                         CLOD_CURVE_MEETS);
        check_close(x, known[k][1], 1e-12);
    }
}

static void rays_may_be_missed_on_either_side(void **state)
{
    (void)state;
    double x;
    const clod_curve above = curve(CLOD_CURVE_EXTENDED, SLOPED, 3);
    assert_int_equal(clod_curve_meet(&above, 0.2, (double)INFINITY, &x), CLOD_CURVE_ABOVE);
    assert_int_equal(clod_curve_meet(&above, 0.1, (double)INFINITY, &x), CLOD_CURVE_ABOVE);
    clod_curve_point weak[] = {{.x = 2.0, .y = 0.2}, {.x = 4.0, .y = 0.4}};
    const clod_curve below = curve(CLOD_CURVE_EXTENDED, weak, 2);
    assert_int_equal(clod_curve_meet(&below, 0.5, (double)INFINITY, &x), CLOD_CURVE_BELOW);
    clod_curve_point nothing[] = {{.x = 2.0, .y = 0.0}, {.x = 4.0, .y = 0.0}};
    const clod_curve zero = curve(CLOD_CURVE_LINE, nothing, 2);
    assert_int_equal(clod_curve_meet(&zero, 0.5, (double)INFINITY, &x), CLOD_CURVE_BELOW);
}

/** -2 + x is above x/2 from 4 on, and stays: large outlets arch. With a flat end at 3 it comes down
 *  again at 6. */
static void a_curve_may_rise_through_the_ray_first(void **state)
{
    (void)state;
    double x;
    clod_curve_point rising[] = {
        {.x = 3.0, .y = 1.0}, {.x = 5.0, .y = 3.0}, {.x = 9.0, .y = 3.0}};
    const clod_curve two = curve(CLOD_CURVE_EXTENDED, rising, 2);
    assert_int_equal(clod_curve_meet(&two, 0.5, (double)INFINITY, &x), CLOD_CURVE_ABOVE);
    const clod_curve three = curve(CLOD_CURVE_EXTENDED, rising, 3);
    assert_int_equal(clod_curve_meet(&three, 0.5, (double)INFINITY, &x), CLOD_CURVE_MEETS);
    check_close(x, 6.0, 1e-13);
}

/** 0.6 + x/4 up to 2, -1.9 + 1.5 x up to 3, then 2 + 0.2 x: 0.8 x is crossed at 0.6/0.55, 1.9/0.7 and 2/0.6. */
static void the_last_crossing_below_a_bound_counts(void **state)
{
    (void)state;
    double x;
    clod_curve_point kinked[] = {{.x = 1.0, .y = 0.85},
                                 {.x = 2.0, .y = 1.1},
                                 {.x = 3.0, .y = 2.6},
                                 {.x = 13.0, .y = 4.6}};
    const clod_curve four = curve(CLOD_CURVE_EXTENDED, kinked, 4);
    const double known[][2] = {{(double)INFINITY, 2.0 / 0.6},
                               {3.4, 2.0 / 0.6},
                               {3.2, 3.2}, // above there
                               {3.0, 3.0},
                               {2.8, 2.8},
                               {2.7, 0.6 / 0.55},
                               {1.5, 0.6 / 0.55},
                               {1.0, 1.0}};
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++) {
        assert_int_equal(clod_curve_meet(&four, 0.8, known[k][0], &x), CLOD_CURVE_MEETS);
        check_close(x, known[k][1], 1e-12);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ways_differ_beyond_the_points),
        cmocka_unit_test(a_line_is_that_of_least_squares),
        cmocka_unit_test(one_point_is_a_line_from_the_origin),
        cmocka_unit_test(properties_do_not_fall_below_zero),
        cmocka_unit_test(rays_are_met_on_every_piece),
        cmocka_unit_test(rays_may_be_missed_on_either_side),
        cmocka_unit_test(a_curve_may_rise_through_the_ray_first),
        cmocka_unit_test(the_last_crossing_below_a_bound_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
