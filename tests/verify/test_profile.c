// The slope of made-up heaps, against the angle they are made with.

#include "support/check.h"
#include "verify/profile.h"

#define ALONG 12
#define ACROSS 4
#define GRAINS (2 * ALONG * ACROSS)
#define DEGREES (180.0 / M_PI)

/** Columns of 1 m from x = 2 m, a heap 4 m deep. */
static clod_verify_profile columns(size_t count)
{
    return (clod_verify_profile){.begin = 2.0, .width = 1.0, .depth = ACROSS, .count = count};
}

/** A grain whose top is on a slope of `angle` degrees in every column, and one below it. */
static void make_heap(double angle, double place[GRAINS][4])
{
    const double fall = tan(angle / DEGREES);
    for (int g = 0; g < ALONG * ACROSS; g++) {
        const double x = 2.5 + g % ALONG;
        const double y = 0.3 + g / ALONG; // NOLINT(bugprone-integer-division): a row
        const double radius = 0.4 + 0.01 * g;
        const double top = 20.0 - fall * x;
        const double on_top[4] = {x, y, top - radius, radius};
        const double below[4] = {x, y, top - 3.0 * radius, radius};
        for (int c = 0; c < 4; c++) {
            place[2 * g][c] = on_top[c];
            place[2 * g + 1][c] = below[c];
        }
    }
}

static void the_angle_is_that_of_the_slope(void **state)
{
    (void)state;
    static const double ANGLES[] = {0.0, 5.0, 23.0, 45.0, -10.0};
    for (size_t a = 0; a < sizeof ANGLES / sizeof *ANGLES; a++) {
        double place[GRAINS][4];
        double error;
        clod_verify_profile profile = columns(ALONG);
        make_heap(ANGLES[a], place);
        clod_verify_profile_find(&profile, (const double(*)[4])place, GRAINS);
        check_close(clod_verify_profile_angle(&profile, 1.0, &error), ANGLES[a], 1e-10);
        check_close(error, 0.0, 1e-5);
    }
}

/** What is outside the columns is not seen; what has left the period across comes back. */
static void grains_are_found_where_they_are(void **state)
{
    (void)state;
    clod_verify_profile profile = columns(2);
    const double place[][4] = {{2.1, 0.5, 5.0, 0.5},  {2.9, 1.5, 6.0, 0.5},
                               {2.5, 2.5, 7.0, 0.5},  {2.5, -0.5, 8.0, 0.5}, // row 3
                               {3.5, 5.5, 3.5, 0.5},                         // row 1
                               {1.9, 0.5, 90.0, 0.5}, {4.1, 0.5, 90.0, 0.5}};
    clod_verify_profile_find(&profile, place, sizeof place / sizeof *place);
    check_relative(profile.x[0], 2.5, 1e-15);
    check_relative(profile.height[0], (5.5 + 6.5 + 7.5 + 8.5) / 4.0, 1e-15);
    check_relative(profile.height[1], 4.0 / 4.0, 1e-15);
}

/**
 * Four columns off a line of slope -1/2 by e, -e, -e, e: the slope stays, the sum of squares is
 * 4 e^2, its variance 4 e^2/2/5, and an angle turns by 1/(1 + 1/4) of that.
 */
static void the_error_is_that_of_the_regression(void **state)
{
    (void)state;
    const double e = 0.1;
    double error;
    clod_verify_profile profile = {
        .count = 4, .x = {1.0, 2.0, 3.0, 4.0}, .height = {9.5 + e, 9.0 - e, 8.5 - e, 8.0 + e}};
    check_relative(clod_verify_profile_angle(&profile, 1.0, &error), DEGREES * atan(0.5),
                   1e-12);
    check_relative(error, DEGREES * sqrt(0.4) * e / 1.25, 1e-9);
}

/** The foot of the heap is left out, and so is what lies beyond it. */
static void low_columns_end_the_slope(void **state)
{
    (void)state;
    double error;
    clod_verify_profile profile = {.count = 7,
                                   .x = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0},
                                   .height = {8.0, 7.0, 6.0, 5.0, 1.0, 9.0, 9.0}};
    check_relative(clod_verify_profile_angle(&profile, 2.5, &error), 45.0, 1e-12);
    assert_true(isnan(clod_verify_profile_angle(&profile, 5.5, &error)));
    assert_true(isnan(error));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_angle_is_that_of_the_slope),
        cmocka_unit_test(grains_are_found_where_they_are),
        cmocka_unit_test(the_error_is_that_of_the_regression),
        cmocka_unit_test(low_columns_end_the_slope),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
