// Preshear points far below the line through their shear points: warned of, and of a table refused.

#include "locus_helpers.h"

#include "analysis/study_file.h"
#include "output/temp_folder.h"

static const double SIGMA[] = {3e3, 4.5e3, 6e3, 7.5e3};

/** Points on a line, with a preshear of this share of the height of the line at 10 kPa. */
static void points_of_share(double c, double phi, double share, clod_locus_point points[4])
{
    points_on_line(c, phi * DEG, 10e3, share * (c + 10e3 * tan(phi * DEG)), SIGMA, 4, points);
    for (size_t i = 0; i < 4; i++) {
        points[i].row = 2 + i;
    }
}

static bool lies_far_below(double c, double phi, double share)
{
    clod_locus_point points[4];
    points_of_share(c, phi, share, points);
    clod_locus locus = evaluate(points, 4);
    const bool found = has_warning(&locus, "kPa lies far below the line (");
    clod_locus_fini(&locus);
    return found;
}

// The steady circle touches the line: its radius is (c + t M) cos phi. A preshear at its top, (M, R), has R over the line
// there, (c + t M): cos phi, without cohesion and with much of it (ffc of 1.3 at 35 deg).
static void steady_flow_has_the_top_of_its_circle(void **state)
{
    (void)state;
    const double cohesion[] = {0.0, 0.5e3, 2e3, 4e3};
    for (size_t k = 0; k < 4; k++) {
        for (double phi = 10.0; phi < 65.0; phi += 5.0) {
            clod_locus_point points[4];
            const double middle = 10e3, t = tan(phi * DEG);
            const double radius = (cohesion[k] + t * middle) * cos(phi * DEG);
            points_on_line(cohesion[k], phi * DEG, middle, radius, SIGMA, 4, points);
            clod_locus locus = evaluate(points, 4);
            assert_near(locus.sigma_1.value, middle + radius, 1e-6); // it is that circle
            assert_false(has_warning(&locus, "far below"));
            clod_locus_fini(&locus);
        }
    }
}

// 0.75 as long as it is less than 0.9 cos phi (to 33.6 deg), which is 0.636 at 45 deg.
static void both_limits(void **state)
{
    (void)state;
    const struct {
        double phi, limit;
    } AT[] = {{10.0, 0.75}, {33.0, 0.75}, {35.0, 0.737237}, {45.0, 0.636396}, {60.0, 0.45}};
    for (size_t k = 0; k < sizeof AT / sizeof AT[0]; k++) {
        for (double c = 0.0; c < 5e3; c += 2e3) {
            assert_false(lies_far_below(c, AT[k].phi, AT[k].limit + 0.001));
            assert_true(lies_far_below(c, AT[k].phi, AT[k].limit - 0.001));
        }
    }
}

// A circle through (10, tau_p) kPa that touches 9 kPa + sigma tan(30 deg) at 0 goes through (0, 9) kPa: its centre is
// (10^2 + tau_p^2 - 9^2)/20 = 9 tan(30 deg), so tau_p = 9.215 kPa.
static void circles_that_touch_in_tension(void **state)
{
    (void)state;
    const double tau_p[] = {9.1e3, 9.3e3};
    for (size_t k = 0; k < 2; k++) {
        clod_locus_point points[4];
        points_on_line(9e3, 30.0 * DEG, 10e3, tau_p[k], SIGMA, 4, points);
        clod_locus locus = evaluate(points, 4);
        assert_true(has_warning(&locus, "is tension: phi_e is undefined."));
        assert_true(has_warning(&locus, "touches the line in tension too") == (k == 0));
        assert_true((locus.ffc.value < 0.5) == (k == 0)); // half of the circle of sigma_c
        clod_locus_fini(&locus);
    }
}

// By hand: 1 kPa + 10 kPa tan 35 deg = 8.002 kPa.
static void the_warning_says_what_to_do(void **state)
{
    (void)state;
    clod_locus_point points[4];
    points_on_line(1e3, 35.0 * DEG, 10e3, 5.5e3, SIGMA, 4, points);
    clod_locus locus = evaluate(points, 4);
    assert_true(has_warning(
        &locus,
        "The preshear point (10.000, 5.500) kPa lies far below the line (8.002 kPa there; "
        "steady flow has 0.74 of it or more): sigma_1 and ffc do not hold. Did preshear "
        "end before steady flow, or has sigma_pre or tau_pre another unit or column?"));
    clod_locus_fini(&locus);
}

/** A line below 0 at the preshear stress has no share. */
static void a_line_below_0_says_nothing_of_preshear(void **state)
{
    (void)state;
    clod_locus_point points[4];
    points_on_line(6e3, -35.0 * DEG, 10e3, 4e3, SIGMA, 4, points); // 6 kPa - 7 kPa
    clod_locus locus = evaluate(points, 4);
    assert_false(has_warning(&locus, "far below"));
    clod_locus_fini(&locus);
}

/** Of a table of a line of 1 kPa + sigma tan(phi); the status is that of the last call. */
static bool taken(double phi, double share, clod_status *status)
{
    clod_locus_point points[4];
    points_of_share(1e3, phi, share, points);
    *status = (clod_status){0};
    clod_locus_study *study = clod_study_of_points("a.csv", points, 4, status);
    const bool good = study != NULL;
    clod_locus_study_destroy(&study);
    return good;
}

// 3.20 kPa of 8.002 kPa. 0.9 cos(70 deg) = 0.308 is what the steepest have to have.
static void tables_are_refused_below_two_fifths(void **state)
{
    (void)state;
    static clod_status status;
    assert_true(taken(35.0, 0.401, &status));
    assert_false(taken(35.0, 0.399, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(
        status.text,
        "a.csv:2, 3, 4, 5: the yield locus at a preshear stress of 10.000 kPa has tau_pre = 3.193 kPa, 0.399 of the 8.002 kPa "
        "that the line through its points has there; it must be 0.40 of it or more, and steady flow has at least 0.74. Has "
        "sigma_pre or tau_pre another unit or column than the points, are sigma_sh and tau_sh exchanged, or has one of them a slip? If not, preshear ended "
        "long before steady flow: shear further, and measure again.");
    assert_true(taken(70.0, 0.309, &status));
    assert_false(taken(70.0, 0.307, &status));
}

static void a_run_is_not_refused(void **state)
{
    static clod_status status;
    char path[PATH_MAX];
    FILE *out = fopen(temp_path(path, state, "points.csv"), "w");
    assert_non_null(out);
    fputs("sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n10,2,3,3\n10,2,5,4\n",
          out);
    assert_int_equal(fclose(out), 0);
    assert_null(clod_study_of_file(path, &status));
    assert_non_null(strstr(status.text, "points.csv:2, 3: the yield locus at a preshear stress "
                                        "of 10.000 kPa has tau_pre = 2.000 kPa, 0.308 of"));
    clod_locus_study *study = clod_study_of_run(path, &status);
    assert_non_null(study);
    assert_true(has_warning(&study->groups[0].locus, "lies far below the line (6.500 kPa"));
    clod_locus_study_destroy(&study);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_flow_has_the_top_of_its_circle),
        cmocka_unit_test(both_limits),
        cmocka_unit_test(circles_that_touch_in_tension),
        cmocka_unit_test(the_warning_says_what_to_do),
        cmocka_unit_test(a_line_below_0_says_nothing_of_preshear),
        cmocka_unit_test(tables_are_refused_below_two_fifths),
        cmocka_unit_test_setup_teardown(a_run_is_not_refused, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
