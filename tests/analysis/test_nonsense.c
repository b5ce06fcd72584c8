// Numbers that no solid has are remarked on, and what one specimen cannot tell is said.

#include "locus_helpers.h"

#include <jansson.h>

static const double SIGMA[] = {3e3, 4.5e3, 6e3, 7.5e3};

static void expect(const clod_locus_point *points, const char *warning)
{
    clod_locus locus = evaluate(points, 4);
    if (!has_warning(&locus, warning)) {
        for (size_t i = 0; i < locus.warning_count; i++) {
            print_message("warning: %s\n", locus.warnings[i]);
        }
        fail_msg("expected: %s", warning);
    }
    clod_locus_fini(&locus);
}

static void expect_none(const clod_locus_point *points)
{
    clod_locus locus = evaluate(points, 4);
    assert_int_equal(locus.warning_count, 0);
    clod_locus_fini(&locus);
}

// 1.65 g/cm3 read as kg/m3; 10 and 15 000 kg/m3 are the ends of the range.
static void bulk_density_in_another_unit(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double wrong[] = {1.65, 9.9, 15100.0, 1.65e6};
    const double right[] = {10.1, 50.0, 1650.0, 14900.0};
    good_points(points);
    for (size_t k = 0; k < 4; k++) {
        char text[64];
        snprintf(text, sizeof text, "A bulk density of %.4g kg/m3 is outside 10 to 15000 kg/m3",
                 wrong[k]);
        for (size_t i = 0; i < 4; i++) {
            points[i].rho_b = wrong[k];
        }
        expect(points, text);
        for (size_t i = 0; i < 4; i++) {
            points[i].rho_b = right[k];
        }
        expect_none(points);
    }
}

// 1690/1600 = 1.056 is a slip, 1670/1600 = 1.044 is not; one point does not tell its density.
static void bulk_densities_of_one_preshear(void **state)
{
    (void)state;
    clod_locus_point points[4];
    good_points(points);
    for (size_t i = 0; i < 3; i++) {
        points[i].rho_b = 1600.0;
    }
    expect_none(points);
    points[3].rho_b = 1670.0;
    expect_none(points);
    points[3].rho_b = 1690.0;
    expect(points, "Bulk densities from 1600 to 1690 kg/m3 are of one preshear stress");
    points[0].rho_b = 1510.0;
    expect(points, "Bulk densities from 1510 to 1690 kg/m3 are of one preshear stress");
}

// Packings differ by more than the rows of one: 1750/1600 = 1.094 may be, 1770/1600 = 1.106 not.
static void bulk_densities_of_seeds(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus loci[2], all;
    clod_locus_point points[4];
    const double second[] = {1750.0, 1770.0};
    for (size_t k = 0; k < 2; k++) {
        for (size_t s = 0; s < 2; s++) {
            good_points(points);
            for (size_t i = 0; i < 4; i++) {
                points[i].rho_b = s == 0 ? 1600.0 : second[k];
            }
            loci[s] = evaluate(points, 4);
        }
        assert_true(clod_locus_combine(loci, 2, &all, &status));
        assert_int_equal(all.warning_count, k);
        assert_true(k == 0 || has_warning(&all, "Bulk densities of the seeds are from 1600 to "
                                                "1770 kg/m3, more than 10 % apart"));
        clod_locus_fini(&all);
        clod_locus_fini(&loci[0]);
        clod_locus_fini(&loci[1]);
    }
}

// tau_pre in Pa read as kPa: atan(7600/10) = 89.92 deg.
static void preshear_in_another_unit(void **state)
{
    (void)state;
    clod_locus_point points[4];
    good_points(points);
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_p = 7.6e6;
    }
    expect(points, "phi_sf = 89.92 deg is outside 5 to 65 deg");
}

static void stated_error_as_large_as_its_value(void **state)
{
    (void)state;
    clod_locus_point points[4];
    good_points(points);
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_p_error = 90e3;
    }
    expect(points, "tau_pre is 7.600 kPa with a stated standard error of 90.000 kPa");
    good_points(points);
    points[2].tau_s_error = 2.0 * points[2].tau_s;
    expect(points, "tau_sh is 5.201 kPa with a stated standard error of 10.402 kPa");
}

// The tangent is known to +- 5 or so: carried through the arctangent that gives more than 90
// deg.
static void error_of_an_angle_above_90_deg_is_none(void **state)
{
    (void)state;
    clod_locus_point points[4];
    points_on_line(5e3, 0.0, 10e3, 7.6e3, SIGMA, 4, points);
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_s_error = 1e8;
        points[i].tau_p_error = 1e3;
    }
    clod_locus locus = evaluate(points, 4);
    assert_true(isnan(locus.phi_lin.error));
    assert_true(isfinite(locus.phi_sf.error) && locus.phi_sf.error < PI / 2.0);
    assert_false(has_warning(&locus, "the points do not lie on a line"));
    assert_false(has_warning(&locus, "the errors stated leave the angle open"));
    assert_true(has_warning(&locus, "nothing was measured then"));
    clod_locus_fini(&locus);
}

/** Points on their line whose stated errors leave its angle open: half of the smallest tau_sh; and two points so close, 110 Pa, that
 *  errors of 4 kPa turn the line by 88 deg each way, each of them. atan(0.07/0.11) = 32.5 deg. */
static void stated_errors_leave_the_angle_open(void **state)
{
    (void)state;
    clod_locus_point points[4];
    good_points(points);
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_s_error = 1.5e3;
        points[i].tau_p_error = 100.0;
    }
    clod_locus locus = evaluate(points, 4);
    assert_int_equal(locus.warning_count, 1);
    assert_true(has_warning(
        &locus, "deg, r2 = 1.000: the errors stated leave the angle open (at most"));
    clod_locus_fini(&locus);
    for (size_t i = 0; i < 2; i++) {
        points[i] = (clod_locus_point){.sigma_p = 10e3,
                                       .tau_p = 7.6e3,
                                       .sigma_s = i == 0 ? 5e3 : 5.11e3,
                                       .tau_s = i == 0 ? 4.5e3 : 4.57e3,
                                       .tau_s_error = 4e3,
                                       .tau_p_error = 100.0};
    }
    locus = evaluate(points, 2);
    assert_true(has_warning(
        &locus,
        "phi_lin = 32.5 +- more than 90 deg, r2 = 1.000: the errors stated leave the angle open"));
    clod_locus_fini(&locus);
}

// 0.99 % of the preshear stress apart is one normal stress, 1.01 % are two.
static void normal_stresses_that_are_one(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus locus;
    clod_locus_point points[4];
    good_points(points);
    for (size_t i = 0; i < 4; i++) {
        points[i].sigma_s = 5e3 + (i == 3 ? 99.0 : 0.0);
    }
    assert_false(clod_locus_evaluate(points, 4, &locus, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(
        status.text, "All 4 points have the same normal stress, 5.000 kPa to within 1 % of "
                     "the preshear stress: a line needs points at different normal stresses.");
    points[3].sigma_s = 5e3 + 101.0;
    locus = evaluate(points, 4);
    clod_locus_fini(&locus);
    // sigma_sh of 3 to 7.5 kPa in kPa, read as Pa
    good_points(points);
    for (size_t i = 0; i < 4; i++) {
        points[i].sigma_s *= 1e-3;
    }
    assert_false(clod_locus_evaluate(points, 4, &locus, &status));
    assert_string_equal(
        status.text, "All 4 points have the same normal stress, 0.003 kPa to within 1 % of "
                     "the preshear stress: a line needs points at different normal stresses. "
                     "The preshear stress is 10.000 kPa; is the unit of sigma_sh another one?");
}

static clod_locus_study *make_study(const clod_locus_point *points, size_t count)
{
    static clod_status status;
    clod_locus_study *study = clod_locus_study_create(points, count, &status);
    if (study == NULL) {
        fail_msg("%s", status.text);
    }
    return study;
}

/** Two consolidations, 10 and 20 kPa, with the cohesion of each. */
static clod_locus_study *two_consolidations(double c_10, double c_20, double tau_error)
{
    clod_locus_point points[8];
    double sigma[4];
    for (size_t i = 0; i < 4; i++) {
        sigma[i] = 2.0 * SIGMA[i];
    }
    points_on_line(c_10, 35.0 * DEG, 10e3, 7.6e3, SIGMA, 4, points);
    points_on_line(c_20, 35.0 * DEG, 20e3, 15.2e3, sigma, 4, points + 4);
    for (size_t i = 0; i < 8; i++) {
        points[i].tau_s_error = tau_error;
        points[i].tau_p_error = tau_error;
    }
    return make_study(points, 8);
}

// sigma_c = 2 c (1 + sin 35 deg)/cos 35 deg = 3.84196 c: 3.842 kPa, and 3.074 kPa with 0.8 kPa.
static void strength_that_falls_with_consolidation(void **state)
{
    (void)state;
    clod_locus_study *study = two_consolidations(1e3, 0.8e3, 1.0);
    assert_string_equal(study->warning,
                        "sigma_c falls from 3.842 to 3.074 kPa while the consolidation stress "
                        "rises from 10.000 to 20.000 kPa, more than twice the standard errors "
                        "explain: a solid gains strength with consolidation. See the warnings "
                        "of both, and repeat them with other specimens.");
    char *table = clod_locus_table(study);
    assert_non_null(strstr(table, "  Warnings\n  - sigma_c falls from 3.842 to 3.074 kPa"));
    clod_locus_free(table);
    char *text = clod_locus_json(study);
    json_t *all = json_loads(text, 0, NULL);
    const json_t *list = json_object_get(all, "warnings");
    assert_int_equal(json_array_size(list), 1);
    assert_string_equal(json_string_value(json_array_get(list, 0)), study->warning);
    json_decref(all);
    clod_locus_free(text);
    clod_locus_study_destroy(&study);
    study = two_consolidations(1e3, 0.8e3, 1e3);
    assert_non_null(strstr(study->warning, "kPa, which is within twice the standard errors:"));
    clod_locus_study_destroy(&study);
}

// A fall of less than 2 % is none, nor is a rise, nor a strength that is not defined.
static void strength_that_does_not_fall(void **state)
{
    (void)state;
    const double cohesion[][2] = {
        {1e3, 0.985e3}, {1e3, 1.0e3}, {1e3, 1.5e3}, {1e3, -0.2e3}, {-0.2e3, 1e3}};
    for (size_t k = 0; k < sizeof cohesion / sizeof cohesion[0]; k++) {
        clod_locus_study *study = two_consolidations(cohesion[k][0], cohesion[k][1], 1.0);
        assert_string_equal(study->warning, "");
        clod_locus_study_destroy(&study);
    }
}

/** Normal and shear stresses in each other's columns, of preshear and points: tau_s 4, 5, 6 kPa over 3, 5, 7 kPa have
 *  c = 2.5 kPa; exchanged, c is -5 kPa. Where preshear has less shear than normal stress the points are to blame. */
static void exchanged_columns_of_points_and_preshear(void **state)
{
    (void)state;
    clod_locus_point points[3] = {
        {.sigma_p = 8e3, .tau_p = 10e3, .sigma_s = 4e3, .tau_s = 3e3},
        {.sigma_p = 8e3, .tau_p = 10e3, .sigma_s = 5e3, .tau_s = 5e3},
        {.sigma_p = 8e3, .tau_p = 10e3, .sigma_s = 6e3, .tau_s = 7e3}};
    static const char *const WORDS = "have the columns sigma and tau been exchanged";
    clod_locus locus = evaluate(points, 3);
    assert_true(fabs(locus.c.value + 5e3) < 1e-6);
    assert_true(has_warning(&locus, WORDS));
    clod_locus_fini(&locus);
    for (int k = 0; k < 3; k++) {
        points[k].tau_p = 7.9e3;
    }
    locus = evaluate(points, 3);
    assert_true(has_warning(&locus, "Points at low normal stress bend down, or are wrong."));
    assert_false(has_warning(&locus, WORDS));
    clod_locus_fini(&locus);
}

#define UNSURE CLOD_LOCUS_ONE_SPECIMEN ", " CLOD_LOCUS_UNLESS_JENIKE

/** That the table and the JSON say so much of the specimens of one consolidation; NULL: nothing. */
static void check_specimens(const clod_locus_point *points, size_t count, const char *expected)
{
    clod_locus_study *study = make_study(points, count);
    char *table = clod_locus_table(study);
    char *text = clod_locus_json(study);
    json_t *all = json_loads(text, 0, NULL);
    const json_t *locus = json_array_get(json_object_get(all, "loci"), 0);
    const json_t *note = json_object_get(locus, "errors_note");
    assert_non_null(note);
    assert_int_equal(expected == NULL, json_is_null(note));
    if (expected != NULL) {
        assert_string_equal(json_string_value(note), expected);
        assert_string_equal(clod_locus_specimen_note(&study->groups[0].locus), expected);
    }
    assert_int_equal(expected != NULL, strstr(table, CLOD_LOCUS_ONE_SPECIMEN) != NULL);
    assert_int_equal(expected != NULL && strcmp(expected, UNSURE) == 0,
                     strstr(table, ",\n  " CLOD_LOCUS_UNLESS_JENIKE ".\n") != NULL);
    json_decref(all);
    clod_locus_free(text);
    clod_locus_free(table);
    clod_locus_study_destroy(&study);
}

// A ring shear tester makes all preshears in one specimen, a Jenike tester each in one of its own: the seed
// tells, or nothing does. Where no errors are given there is nothing to add to them.
static void errors_of_one_specimen_are_told(void **state)
{
    (void)state;
    clod_locus_point points[8];
    good_points(points);
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_p_error = 10.0;
    }
    check_specimens(points, 4, CLOD_LOCUS_ONE_SPECIMEN);
    check_specimens(points, 2, NULL); // no errors
    points[0].tau_p *= 1.01;
    check_specimens(points, 4, UNSURE); // four preshears, of nobody knows how many specimens
    for (size_t i = 0; i < 4; i++) {
        points[i].seed = 1;
    }
    check_specimens(points, 4, CLOD_LOCUS_ONE_SPECIMEN); // four of specimen 1
    good_points(points);
    good_points(points + 4);
    for (size_t i = 4; i < 8; i++) {
        points[i].seed = 1;
        points[i].tau_s *= 1.02;
    }
    points[0].tau_p *= 1.01;          // so the error of tau_p is known
    check_specimens(points, 8, NULL); // two specimens
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bulk_density_in_another_unit),
        cmocka_unit_test(bulk_densities_of_one_preshear),
        cmocka_unit_test(bulk_densities_of_seeds),
        cmocka_unit_test(preshear_in_another_unit),
        cmocka_unit_test(stated_error_as_large_as_its_value),
        cmocka_unit_test(error_of_an_angle_above_90_deg_is_none),
        cmocka_unit_test(stated_errors_leave_the_angle_open),
        cmocka_unit_test(normal_stresses_that_are_one),
        cmocka_unit_test(strength_that_falls_with_consolidation),
        cmocka_unit_test(strength_that_does_not_fall),
        cmocka_unit_test(exchanged_columns_of_points_and_preshear),
        cmocka_unit_test(errors_of_one_specimen_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
