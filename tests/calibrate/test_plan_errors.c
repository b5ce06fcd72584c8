/**
 * @file test_plan_errors.c
 * The error of a plan beside those of its tables, and tables of one specimen: expected values by hand.
 */

#include "plan_lab.h"

#define WALL "tests/cli/wall_friction.yaml"
#define PILE "cases/calibrate-repose/pile.yaml"
#define HEAD                                                                                   \
    "seed,sigma_pre [kPa],tau_pre [kPa],tau_pre_error [kPa],sigma_sh [kPa],tau_sh [kPa],"      \
    "tau_sh_error [kPa],rho_b [kg/m3],rho_b_error [kg/m3]\n"
#define SPECIMEN(seed, density)                                                                \
    seed ",54.8,40,0.3,10.96,12.7,0.3," density ",5\n" seed                                    \
         ",54.8,40,0.3,27.4,24.2,0.3," density ",5\n" seed                                     \
         ",54.8,40,0.3,43.84,35.7,0.9," density ",5\n"
#define DENSITY "sigma_1 [kPa],rho_b [kg/m3],rho_b_error [kg/m3]\n20,1500,9\n54.8,1600,9\n"

static void load(void **state, const char *from, const char *target, clod_plan *plan)
{
    clod_status status = {CLOD_OK, ""};
    const char *key = strcmp(from, WALL) == 0 ? "contacts.ore-plate.friction" : ROLLING;
    if (!lab_load(state, from, key, target, plan, &status)) {
        fail_msg("%s", status.text);
    }
}

/** Errors of all targets, SI. */
static void check_errors(void **state, const char *from, const char *target,
                         const double *errors, size_t count)
{
    clod_plan plan;
    load(state, from, target, &plan);
    assert_int_equal(plan.target_count, count);
    for (size_t k = 0; k < count; k++) {
        if (!(fabs(plan.targets[k].error / errors[k] - 1.0) < 1e-9)) {
            fail_msg("%s: %zu: %.17g, not %.17g", target, k, plan.targets[k].error, errors[k]);
        }
    }
    clod_plan_fini(&plan);
}

// Points of one preshear are prorated by 1.
static void the_larger_error_of_plan_and_table_counts(void **state)
{
    lab_write_file(state, "lab.csv", HEAD SPECIMEN("1", "1500"));
    check_errors(state, RING, "locus: lab.csv, error: 0.5 kPa", (double[]){0.5e3, 0.5e3, 0.9e3},
                 3);
    check_errors(state, RING, "locus: lab.csv, number: tau_p, error: 0.4 kPa",
                 (double[]){0.4e3}, 1);
    check_errors(state, RING, "locus: lab.csv, number: tau_p, error: 0.2 kPa",
                 (double[]){0.3e3}, 1);
    check_errors(state, RING, "locus: lab.csv, number: rho_b, error: 8 kg/m3", (double[]){8.0},
                 1);
    check_errors(state, RING, "locus: lab.csv, number: rho_b, error: 4 kg/m3", (double[]){5.0},
                 1);
    lab_write_file(state, "lab.csv",
                   "sigma_1 [kPa],f_c [kPa],f_c_error [kPa]\n20,6,0.4\n54.8,13,0.7\n");
    check_errors(state, UNIAXIAL, "locus: lab.csv, error: 0.5 kPa", (double[]){0.5e3, 0.7e3},
                 2);
}

// Three densities that differ by 1 kg/m3 are known to 1/sqrt(3), by their stated errors to 5/sqrt(3) kg/m3.
static void error_of_a_mean(void **state)
{
    lab_write_file(state, "lab.csv",
                   HEAD SPECIMEN("1", "1499") SPECIMEN("2", "1500") SPECIMEN("3", "1501"));
    check_errors(state, RING, "locus: lab.csv, number: rho_b", (double[]){5.0 / sqrt(3.0)}, 1);
    check_errors(state, RING, "locus: lab.csv, number: rho_b, error: 6 kg/m3",
                 (double[]){6.0 / sqrt(3.0)}, 1);
}

/** The only warning of a plan of one target, and none where the plan states an error that is larger than the
 *  table's; NULL: that is not looked at. */
static void check_warned(void **state, const char *from, const char *target, const char *error,
                         const char *words)
{
    clod_plan plan;
    char with[256];
    load(state, from, target, &plan);
    if (plan.warnings.count != 1 || strstr(plan.warnings.text[0], words) == NULL) {
        fail_msg("%s: %zu warnings: %s", target, plan.warnings.count, plan.warnings.text[0]);
    }
    clod_plan_fini(&plan);
    if (error == NULL) {
        return;
    }
    snprintf(with, sizeof with, "%s, error: %s", target, error);
    load(state, from, with, &plan);
    assert_int_equal(plan.warnings.count, 0);
    clod_plan_fini(&plan);
}

static void one_specimen_is_warned_of(void **state)
{
    static const char *const ONE =
        "lab.csv: one specimen: scatter between specimens not included. Intervals are too "
        "narrow without it";
    lab_write_file(state, "lab.csv", HEAD SPECIMEN("1", "1500"));
    check_warned(state, RING, "locus: lab.csv", "1 kPa", ONE);
    check_warned(state, RING, "locus: lab.csv, number: tau_p", "0.5 kPa", ONE);
    lab_write_file(
        state, "lab.csv",
        "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n20,8,0.1\n10,4,0.1\n5,2,0.1\n");
    check_warned(state, WALL, "locus: lab.csv", "1 deg", ONE);
    lab_write_file(state, "lab.csv", DENSITY);
    check_warned(state, UNIAXIAL, "locus: lab.csv", "10 kg/m3",
                 "lab.csv: one row at each stress: scatter between specimens not included, "
                 "unless rho_b_error has it. Intervals are too narrow without it");
    lab_write_file(state, "lab.csv",
                   "angle_of_repose [deg],angle_of_repose_error [deg]\n30,1\n");
    check_warned(state, PILE, "locus: lab.csv, number: repose.heap.angle_deg", "2 deg",
                 "lab.csv: one heap: scatter between heaps not included");
}

// An error of the plan that is not above all of the table's does not tell how specimens differ.
static void a_smaller_error_of_the_plan_does_not_silence(void **state)
{
    static const char *const ONE =
        "lab.csv: one specimen: scatter between specimens not included";
    lab_write_file(state, "lab.csv", HEAD SPECIMEN("1", "1500"));
    check_warned(state, RING, "locus: lab.csv, error: 1e-6 kPa, discrepancy: 0.1 kPa", NULL,
                 ONE);
    check_warned(state, RING, "locus: lab.csv, error: 0.8 kPa", NULL, ONE);
    check_warned(state, RING, "locus: lab.csv, number: tau_p, error: 0.2 kPa", NULL, ONE);
    check_warned(state, RING, "locus: lab.csv, number: rho_b, error: 4 kg/m3", NULL, ONE);
    lab_write_file(
        state, "lab.csv",
        "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n20,8,0.1\n10,4,0.1\n5,2,0.1\n");
    check_warned(state, WALL, "locus: lab.csv, error: 0.5 deg", NULL, ONE);
    lab_write_file(state, "lab.csv", DENSITY);
    check_warned(state, UNIAXIAL, "locus: lab.csv, error: 8 kg/m3", NULL,
                 "lab.csv: one row at each stress");
    lab_write_file(state, "lab.csv",
                   "angle_of_repose [deg],angle_of_repose_error [deg]\n30,1\n");
    check_warned(state, PILE, "locus: lab.csv, number: repose.heap.angle_deg, error: 0.9 deg",
                 NULL, "lab.csv: one heap");
}

// The row at 54.8 kPa alone is a target, and its 9 kg/m3 are below 10.
static void rows_that_are_no_targets_do_not_count(void **state)
{
    lab_write_file(
        state, "lab.csv",
        "sigma_1 [kPa],rho_b [kg/m3],rho_b_error [kg/m3]\n20,1500,30\n54.8,1600,9\n");
    check_warned(state, UNIAXIAL, "locus: lab.csv, normal_stress: 54.8 kPa", "10 kg/m3",
                 "lab.csv: one row at each stress");
}

static void check_silent(void **state, const char *from, const char *target)
{
    clod_plan plan;
    load(state, from, target, &plan);
    for (size_t k = 0; k < plan.warnings.count; k++) {
        if (strstr(plan.warnings.text[k], "not included") != NULL) {
            fail_msg("%s", plan.warnings.text[k]);
        }
    }
    clod_plan_fini(&plan);
}

static void several_specimens_are_not(void **state)
{
    lab_write_file(state, "lab.csv", HEAD SPECIMEN("1", "1499") SPECIMEN("2", "1500"));
    check_silent(state, RING, "locus: lab.csv");
    lab_write_file(state, "lab.csv",
                   "seed,sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n1,20,8,0.1\n1,10,4,0.1\n"
                   "1,5,2,0.1\n2,20,8.1,0.1\n2,10,4.1,0.1\n2,5,2.1,0.1\n");
    check_silent(state, WALL, "locus: lab.csv");
    lab_write_file(state, "lab.csv", DENSITY "20,1510,9\n54.8,1610,9\n");
    check_silent(state, UNIAXIAL, "locus: lab.csv");
    lab_write_file(state, "lab.csv",
                   "angle_of_repose [deg],angle_of_repose_error [deg]\n30,1\n31,1\n");
    check_silent(state, PILE, "locus: lab.csv, number: repose.heap.angle_deg");
}

#define PRESHEARS                                                                              \
    HEAD "1,54.8,39,0.3,10.96,12.7,0.3,1500,5\n1,54.8,40,0.3,27.4,24.2,0.3,1501,5\n"           \
         "1,54.8,41,0.3,43.84,35.7,0.3,1502,5\n"
#define UNNUMBERED                                                                             \
    "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],tau_sh_error [kPa]\n"           \
    "54.8,39,10.96,12.7,0.3\n54.8,40,27.4,24.2,0.3\n54.8,41,43.84,35.7,0.3\n"

/** Two warnings: of few preshears, which are no specimens, and of one specimen. */
static void check_preshears(void **state, const char *target, const char *words)
{
    clod_plan plan;
    load(state, RING, target, &plan);
    assert_int_equal(plan.warnings.count, 2);
    assert_non_null(
        strstr(plan.warnings.text[0],
               "lab.csv: errors are estimated from 3 preshears, whose scatter at one "
               "stress is uncertain by 50 %. Intervals are wider for it (Student's t); "
               "more preshears make them narrower."));
    assert_non_null(strstr(plan.warnings.text[1], words));
    clod_plan_fini(&plan);
}

// A ring shear tester makes the preshear of each point in the same specimen: they tell nothing of how specimens differ.
static void preshears_are_no_specimens(void **state)
{
    lab_write_file(state, "lab.csv", PRESHEARS);
    check_preshears(
        state, "locus: lab.csv",
        "lab.csv: one specimen: scatter between specimens not included. Intervals are "
        "too narrow without it");
    lab_write_file(state, "lab.csv", UNNUMBERED);
    check_preshears(
        state, "locus: lab.csv",
        "lab.csv: one specimen: scatter between specimens not included, unless each "
        "point has its own, as in a Jenike tester. Intervals are too narrow without it");
}

// What the plan says that specimens differ by counts whole for one, however many preshears it has. Densities of
// 1500, 1501 and 1502 kg/m3 are known to 1/sqrt(3), by their stated errors to 5/sqrt(3).
static void an_error_of_the_plan_is_that_of_a_specimen(void **state)
{
    lab_write_file(state, "lab.csv", PRESHEARS);
    check_errors(state, RING, "locus: lab.csv, number: rho_b", (double[]){5.0 / sqrt(3.0)}, 1);
    check_errors(state, RING, "locus: lab.csv, number: rho_b, error: 6 kg/m3", (double[]){6.0},
                 1);
}

// Two specimens of two preshears each: four stated errors of 5 kg/m3, which are more than the specimens differ by.
static void stated_errors_are_those_of_preshears(void **state)
{
    lab_write_file(
        state, "lab.csv",
        HEAD "1,54.8,39,0.3,10.96,12.7,0.3,1500,5\n1,54.8,40,0.3,43.84,35.7,0.3,1501,5\n"
             "2,54.8,39,0.3,10.96,12.7,0.3,1500,5\n2,54.8,40,0.3,43.84,35.7,0.3,1501,5\n");
    check_errors(state, RING, "locus: lab.csv, number: rho_b", (double[]){2.5}, 1);
}

static void a_table_is_warned_of_once(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", HEAD SPECIMEN("1", "1500"));
    load(state, RING, "locus: lab.csv}, {test: lab, locus: lab.csv, number: rho_b", &plan);
    assert_int_equal(plan.target_count, 4);
    assert_int_equal(plan.warnings.count, 1);
    clod_plan_fini(&plan);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_larger_error_of_plan_and_table_counts),
        TEST(error_of_a_mean),
        TEST(one_specimen_is_warned_of),
        TEST(a_smaller_error_of_the_plan_does_not_silence),
        TEST(rows_that_are_no_targets_do_not_count),
        TEST(several_specimens_are_not),
        TEST(preshears_are_no_specimens),
        TEST(an_error_of_the_plan_is_that_of_a_specimen),
        TEST(stated_errors_are_those_of_preshears),
        TEST(a_table_is_warned_of_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
