/**
 * @file test_plan_loci.c
 * A table of shear points and a number of the same test that contradict each other: by hand.
 *
 * The points lie on tau = 5 kPa + 0.7 sigma at 10.96, 27.4 and 43.84 kPa, each known to 0.3 kPa: by least squares
 * the errors are 0.3/sqrt(2 16.44^2) = 0.0129 of the slope, 0.0129/(1 + 0.7^2) = 0.496 deg of phi_lin = 34.99 deg, and
 * 0.3 sqrt(1/3 + 27.4^2/(2 16.44^2)) = 0.394 kPa of c. sigma_c is c times 2 cos/(1 - sin) = 3.841: 19.21 +- 1.51 kPa
 * by c alone.
 */

#include "plan_lab.h"

#define HEAD "seed,sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]"

static void write_line(void **state, double c, const char *error_column, const char *error)
{
    char text[600];
    size_t used = (size_t)snprintf(text, sizeof text, HEAD "%s\n", error_column);
    static const double SIGMA[] = {10.96, 27.4, 43.84};
    for (size_t k = 0; k < 3; k++) {
        used +=
            (size_t)snprintf(text + used, sizeof text - used, "1,54.8,40,%.6g,%.6g,1700%s\n",
                             SIGMA[k], c + 0.7 * SIGMA[k], error);
    }
    lab_write_file(state, "lab.csv", text);
}

static void write_errors(void **state, double c)
{
    write_line(state, c, ",tau_sh_error [kPa]", ",0.3");
}

#define BESIDE(entry, number)                                                                  \
    "locus: lab.csv" entry "}, {test: lab, number: " number ", held_back: true"

static void load_beside(void **state, const char *number)
{
    clod_plan plan;
    char text[512];
    snprintf(text, sizeof text, BESIDE("", "%s"), number);
    lab_load_good(state, RING, text, &plan);
    assert_int_equal(plan.target_count, 4); // three points of the table, and the number
    assert_true(plan.targets[3].held_back);
    clod_plan_fini(&plan);
}

// 4 sqrt(0.394^2 + 0.1^2) = 1.62 kPa; 1.7 kPa are 4.2 standard errors.
static void cohesion_beside_the_points_it_follows_from(void **state)
{
    write_errors(state, 5.0);
    load_beside(state, "c, value: 6.6 kPa, error: 0.1 kPa");
    load_beside(state, "c, value: 3.4 kPa, error: 0.1 kPa");
    lab_refuse(
        state, RING, BESIDE("", "c, value: 6.7 kPa, error: 0.1 kPa"),
        "test lab: c 6.70 +- 0.10 kPa in targets.1 is not that of the yield locus of lab.csv in "
        "targets.0 at the preshear stress of the case, 5.00 +- 0.39 kPa (clod locus), by 4.2 standard "
        "errors: they contradict each other");
    lab_refuse(state, RING, BESIDE("", "c, value: 3.3 kPa, error: 0.1 kPa"),
               "by 4.2 standard errors");
}

// With 0.6 kPa for each point 4 sqrt(0.788^2 + 0.1^2) = 3.18 kPa; 3.3 kPa are 4.2 standard errors. 0.2 kPa are less than the table's.
static void cohesion_beside_points_with_the_error_of_the_plan(void **state)
{
    clod_plan plan;
    write_errors(state, 5.0);
    lab_load_good(state, RING, BESIDE(", error: 0.6 kPa", "c, value: 8.1 kPa, error: 0.1 kPa"),
                  &plan);
    clod_plan_fini(&plan);
    lab_refuse(state, RING, BESIDE(", error: 0.6 kPa", "c, value: 8.3 kPa, error: 0.1 kPa"),
               "by 4.2 standard errors");
    lab_load_good(state, RING, BESIDE(", error: 0.2 kPa", "c, value: 6.6 kPa, error: 0.1 kPa"),
                  &plan);
    clod_plan_fini(&plan);
}

// 4 sqrt(0.496^2 + 0.5^2) = 2.82 deg; 3.01 deg are 4.3 standard errors.
static void angle_beside_the_points_it_follows_from(void **state)
{
    write_errors(state, 5.0);
    load_beside(state, "phi_lin, value: 37.7 deg, error: 0.5 deg");
    lab_refuse(
        state, RING, BESIDE("", "phi_lin, value: 38 deg, error: 0.5 deg"),
        "test lab: phi_lin 38.0 +- 0.5 deg in targets.1 is not that of the yield locus of lab.csv "
        "in targets.0 at the preshear stress of the case, 35.0 +- 0.5 deg (clod locus), by 4.3 "
        "standard errors");
}

static void strength_beside_the_points_it_follows_from(void **state)
{
    write_errors(state, 5.0);
    load_beside(state, "sigma_c, value: 19.2 kPa, error: 0.1 kPa");
    lab_refuse(
        state, RING, BESIDE("", "sigma_c, value: 30 kPa, error: 0.1 kPa"),
        "sigma_c 30.00 +- 0.10 kPa in targets.1 is not that of the yield locus of lab.csv");
    lab_refuse(
        state, RING,
        BESIDE(", held_back: true}, {test: lab, number: phi_e, value: 44 deg, error: 2 deg",
               "sigma_c, value: 30 kPa, error: 0.1 kPa"),
        "sigma_c 30.00 +- 0.10 kPa in targets.2 is not that of the yield locus of lab.csv");
}

// -1 3.841 = -3.84 +- 1.51 kPa: 5.8 kPa are 3.7, and 13.8 kPa 8.7 of sqrt(1.51^2 + 0.5^2) = 1.59 kPa.
static void strength_beside_a_line_with_no_cohesion(void **state)
{
    write_errors(state, -1.0);
    load_beside(state, "sigma_c, value: 2 kPa, error: 0.5 kPa");
    lab_refuse(state, RING, BESIDE("", "sigma_c, value: 10 kPa, error: 0.5 kPa"),
               "-3.84 +- 1.51 kPa (clod locus), by 8.7 standard errors");
}

// The plan's error stands for a column that is missing: 1.7 kPa of c are 4.2 standard errors again, and of ten
// times the error 0.4.
static void error_of_the_plan_for_points_without(void **state)
{
    clod_plan plan;
    write_line(state, 5.0, "", "");
    lab_refuse(state, RING, BESIDE(", error: 0.3 kPa", "c, value: 6.7 kPa, error: 0.1 kPa"),
               "5.00 +- 0.39 kPa (clod locus), by 4.2 standard errors");
    lab_load_good(state, RING, BESIDE(", error: 3 kPa", "c, value: 6.7 kPa, error: 0.1 kPa"),
                  &plan);
    clod_plan_fini(&plan);
}

// One preshear tells no error of tau_p and rho_b: it is taken to be that of the number, so
// 4 sqrt(2) 0.1 kPa = 0.57 kPa and 4 sqrt(2) 20 kg/m3 = 113 kg/m3 are allowed.
static void numbers_of_which_the_table_has_no_error(void **state)
{
    write_errors(state, 5.0);
    load_beside(state, "tau_p, value: 40.5 kPa, error: 0.1 kPa");
    lab_refuse(state, RING, BESIDE("", "tau_p, value: 40.6 kPa, error: 0.1 kPa"),
               "tau_p 40.60 +- 0.10 kPa in targets.1 is not that of the yield locus");
    load_beside(state, "rho_b, value: 1810 kg/m3, error: 20 kg/m3");
    lab_refuse(state, RING, BESIDE("", "rho_b, value: 1820 kg/m3, error: 20 kg/m3"),
               "rho_b 1820 +- 20 kg/m3 in targets.1 is not that of the yield locus");
}

// sigma_1 and phi_e by docs/theory/yield-locus.md, eq. (4): M = 64.723 and R = 41.213 kPa, phi_e = 39.55 deg. The error
// that clod locus has of it lacks that of tau_p, so it counts for no less than the number's: 4 sqrt(2) 0.5 deg = 2.83 deg.
static void numbers_whose_error_lacks_that_of_preshear(void **state)
{
    write_errors(state, 5.0);
    load_beside(state, "phi_e, value: 42.2 deg, error: 0.5 deg");
    lab_refuse(state, RING, BESIDE("", "phi_e, value: 42.5 deg, error: 0.5 deg"),
               "39.5 +- 0.5 deg (clod locus), by 4.2 standard errors");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(cohesion_beside_the_points_it_follows_from),
        TEST(cohesion_beside_points_with_the_error_of_the_plan),
        TEST(angle_beside_the_points_it_follows_from),
        TEST(strength_beside_the_points_it_follows_from),
        TEST(strength_beside_a_line_with_no_cohesion),
        TEST(error_of_the_plan_for_points_without),
        TEST(numbers_of_which_the_table_has_no_error),
        TEST(numbers_whose_error_lacks_that_of_preshear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
