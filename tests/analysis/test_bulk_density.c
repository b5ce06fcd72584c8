// Bulk density over stress: the power law through points that have one, and what is no density.

#include "clod/bulk_density.h"

#include <string.h>

#include "support/check.h"

/** 1000 kg/m3 at 1 kPa, 1.1 times as much for each factor of 10: exponent log10(1.1). */
static void points_of_a_power_law_give_it_back(void **state)
{
    const clod_bulk_density_point points[] = {{.sigma_1 = 1e5, .rho_b = 1210.0},
                                              {.sigma_1 = 1e3, .rho_b = 1000.0},
                                              {.sigma_1 = 1e4, .rho_b = 1100.0}};
    clod_bulk_density self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_bulk_density_evaluate(points, 3, &self, &status));
    check_relative(self.rho_1.value, 1000.0, 1e-12);
    check_relative(self.compressibility.value, log10(1.1), 1e-12);
    check_close(self.compressibility.error, 0.0, 1e-9);
    check_close(self.r_squared, 1.0, 1e-12);
    assert_true(self.points[0].sigma_1 == 1e3 && self.points[2].sigma_1 == 1e5);
    clod_bulk_density_fini(&self);
}

/**
 * Logarithms of stress in decades 0, 1, 2, of density 0, a, 0: slope 0, scatter 2 a^2/3 about a
 * mean of a/3 with one degree of freedom; the sum of squares of ln is 2 (ln 10)^2.
 */
static void the_error_is_that_of_the_scatter(void **state)
{
    const double a = 0.06;
    const double ten = 2.302585092994046;
    const clod_bulk_density_point points[] = {{.sigma_1 = 1e3, .rho_b = 1000.0},
                                              {.sigma_1 = 1e4, .rho_b = 1000.0 * exp(a)},
                                              {.sigma_1 = 1e5, .rho_b = 1000.0}};
    clod_bulk_density self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_bulk_density_evaluate(points, 3, &self, &status));
    const double scatter = sqrt(2.0 / 3.0) * a;
    check_close(self.compressibility.value, 0.0, 1e-12);
    check_relative(self.compressibility.error, scatter / (sqrt(2.0) * ten), 1e-9);
    check_relative(self.rho_1.value, 1000.0 * exp(a / 3.0), 1e-12);
    // at 0 decades: variance of the mean 1/3, and of the slope 1/2 a decade away
    check_relative(self.rho_1.error / self.rho_1.value, scatter * sqrt(1.0 / 3.0 + 0.5), 1e-9);
    clod_bulk_density_fini(&self);
}

/** Two points a factor of 10 apart, of 1 % each: of beta sqrt(2) 1 %/ln 10, of rho_1 1 %, for the
 *  first point is at 1 kPa. Errors of 1 % of the stress are beta times as large. */
static void stated_errors_carry_over(void **state)
{
    clod_bulk_density_point points[] = {{.sigma_1 = 1e3, .rho_b = 1000.0, .rho_b_error = 10.0},
                                        {.sigma_1 = 1e4, .rho_b = 1100.0, .rho_b_error = 11.0}};
    clod_bulk_density self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_bulk_density_evaluate(points, 2, &self, &status));
    check_relative(self.compressibility.error, sqrt(2.0) * 0.01 / log(10.0), 1e-12);
    check_relative(self.rho_1.error, 10.0, 1e-12);
    clod_bulk_density_fini(&self);
    points[0] = (clod_bulk_density_point){1e3, 1000.0, 10.0, 0.0};
    points[1] = (clod_bulk_density_point){1e4, 1100.0, 100.0, 0.0};
    assert_true(clod_bulk_density_evaluate(points, 2, &self, &status));
    check_relative(self.rho_1.error, 10.0 * log10(1.1), 1e-9);
    clod_bulk_density_fini(&self);
    points[1].sigma_1_error = 0.0; // not all state one
    assert_true(clod_bulk_density_evaluate(points, 2, &self, &status));
    char *table = clod_bulk_density_table(&self);
    assert_true(isnan(self.rho_1.error));
    assert_non_null(strstr(table, "No error bars: they need three points"));
    assert_null(strstr(table, "one standard error"));
    clod_locus_free(table);
    clod_bulk_density_fini(&self);
}

/** 1000 to 900 kg/m3; within two errors of 100 kg/m3 it may be chance. */
static void a_density_that_falls_is_told(void **state)
{
    clod_bulk_density_point points[] = {{.sigma_1 = 1e3, .rho_b = 1000.0},
                                        {.sigma_1 = 1e4, .rho_b = 900.0}};
    clod_bulk_density self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_bulk_density_evaluate(points, 2, &self, &status));
    assert_non_null(strstr(self.warnings[0], "falls while the stress rises (beta = -0.0458)"));
    char *table = clod_bulk_density_table(&self);
    char *json = clod_bulk_density_json(&self);
    assert_non_null(strstr(table, "Warnings\n  - The bulk density falls"));
    assert_non_null(strstr(json, "The bulk density falls"));
    clod_locus_free(table);
    clod_locus_free(json);
    clod_bulk_density_fini(&self);
    points[0].rho_b_error = points[1].rho_b_error = 100.0;
    assert_true(clod_bulk_density_evaluate(points, 2, &self, &status));
    assert_int_equal(self.warning_count, 0);
    clod_bulk_density_fini(&self);
}

/** What an evaluation says, with so many warnings. */
static void expect_warnings(const clod_bulk_density_point *points, size_t count, size_t wanted,
                            const char *text)
{
    clod_bulk_density self;
    clod_status status = {0};
    assert_true(clod_bulk_density_evaluate(points, count, &self, &status));
    assert_int_equal(self.warning_count, wanted);
    if (wanted > 0 && strstr(self.warnings[wanted - 1], text) == NULL) {
        fail_msg("\"%s\" is not in \"%s\"", text, self.warnings[wanted - 1]);
    }
    clod_bulk_density_fini(&self);
}

/** Three stresses in a geometric series: the line of logarithms passes a middle point that is off by ln f at 2/3 ln f, the others at
 *  1/3. So f = 1.07 is 4.5 % off the law and f = 1.09 5.7 %; 1000, 100, 1400 kg/m3 lie at 519.2 in the middle. r2 is 0 of the
 *  first, as of all whose ends are equal. */
static void points_off_the_law_are_told(void **state)
{
    clod_bulk_density_point points[] = {{.sigma_1 = 2e3, .rho_b = 1000.0},
                                        {.sigma_1 = 4e3, .rho_b = 1070.0},
                                        {.sigma_1 = 8e3, .rho_b = 1000.0}};
    (void)state;
    expect_warnings(points, 3, 0, "");
    points[1].rho_b = 1090.0;
    expect_warnings(points, 3, 1,
                    "(r2 = 0.000): 1090 kg/m3 at 4.000 kPa, where the law has 1029.1");
    points[1].rho_b_error = 40.0; // 5.7 % are within two errors
    expect_warnings(points, 3, 0, "");
    points[1] = (clod_bulk_density_point){.sigma_1 = 4e3, .rho_b = 100.0};
    points[2].rho_b = 1400.0;
    expect_warnings(
        points, 3, 1,
        "The points do not follow the law (r2 = 0.014): 100 kg/m3 at 4.000 kPa, where "
        "the law has 519.2; more than 5 % apart.");
}

/** 100 and 1000 kg/m3 at 2 and 4 kPa: ln 10/ln 2 = 3.32; twice the density at four times the stress is allowed. */
static void an_exponent_that_no_solid_has_is_told(void **state)
{
    clod_bulk_density_point points[] = {{.sigma_1 = 2e3, .rho_b = 100.0},
                                        {.sigma_1 = 4e3, .rho_b = 1000.0}};
    (void)state;
    expect_warnings(points, 2, 1, "beta = 3.3219: no solid is compressed as much");
    points[1] = (clod_bulk_density_point){.sigma_1 = 8e3, .rho_b = 199.0};
    expect_warnings(points, 2, 0, "");
}

static void stated_errors_as_large_as_their_values_are_told(void **state)
{
    clod_bulk_density_point points[] = {
        {.sigma_1 = 2e3, .rho_b = 1000.0, .rho_b_error = 999.0},
        {.sigma_1 = 4e3, .rho_b = 1100.0, .sigma_1_error = 3e3}};
    (void)state;
    expect_warnings(points, 2, 0, "");
    points[1].sigma_1_error = 4e3;
    expect_warnings(
        points, 2, 1,
        "sigma_1 is 4.000 kPa with a stated standard error of 4.000 kPa: nothing was "
        "measured then");
    points[0].rho_b_error = 2000.0;
    expect_warnings(points, 2, 1,
                    "rho_b is 1000.000 kg/m3 with a stated standard error of 2000.000 kg/m3");
}

static void expect_error(const char *text, const char *wanted)
{
    clod_bulk_density_point *points;
    clod_bulk_density self = {0};
    size_t count;
    clod_status status = {0};
    const bool read =
        clod_bulk_density_parse("rho.csv", text, strlen(text), &points, &count, &status);
    assert_false(read && clod_bulk_density_evaluate(points, count, &self, &status));
    clod_locus_free(points);
    assert_int_equal(status.code, CLOD_USAGE);
    if (strstr(status.text, wanted) == NULL) {
        fail_msg("\"%s\" is not in \"%s\"", wanted, status.text);
    }
}

// 1 lb/ft3 is 0.45359237 kg in (0.3048 m)^3, so 50 are 800.9 kg/m3.
static void a_density_in_pounds_is_told(void **state)
{
    clod_bulk_density_point points[] = {{.sigma_1 = 1e3, .rho_b = 50.0},
                                        {.sigma_1 = 1e4, .rho_b = 55.0}};
    clod_bulk_density self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_bulk_density_evaluate(points, 2, &self, &status));
    assert_int_equal(self.warning_count, 1);
    assert_string_equal(self.warnings[0],
                        "rho_b is 50.0 kg/m3, as light as perlite, foam or aerogel. Is it in "
                        "lb/ft3? 50.0 lb/ft3 are 801 kg/m3.");
    clod_bulk_density_fini(&self);
    points[0].rho_b = 101.0;
    points[1].rho_b = 105.0;
    assert_true(clod_bulk_density_evaluate(points, 2, &self, &status));
    assert_int_equal(self.warning_count, 0);
    clod_bulk_density_fini(&self);
}

static void what_is_no_density_is_refused(void **state)
{
    (void)state;
    expect_error("sigma_1 [kPa],rho_b [kg/m3]\n1,1.65\n",
                 "rho.csv:2: column rho_b: 1.65 kg/m3 is outside 10 to 15000 kg/m3");
    expect_error("sigma_1 [kPa],rho_b [kg/m3]\n1,1650\n", "at least two points");
    expect_error("sigma_1 [kPa],rho_b [kg/m3]\n1,1650\n1,1660\n", "at different stresses");
    expect_error("sigma_1 [kPa],depth [m]\n1,1\n", "depth");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_of_a_power_law_give_it_back),
        cmocka_unit_test(the_error_is_that_of_the_scatter),
        cmocka_unit_test(stated_errors_carry_over),
        cmocka_unit_test(a_density_that_falls_is_told),
        cmocka_unit_test(points_off_the_law_are_told),
        cmocka_unit_test(an_exponent_that_no_solid_has_is_told),
        cmocka_unit_test(stated_errors_as_large_as_their_values_are_told),
        cmocka_unit_test(a_density_in_pounds_is_told),
        cmocka_unit_test(what_is_no_density_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
