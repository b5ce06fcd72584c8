/**
 * @file test_plan_repose.c
 * Measured angles of repose of a plan become a target: all expected values by hand.
 */

#include "plan_lab.h"

#define PILE "cases/calibrate-repose/pile.yaml" // repose: {heap: ...}
#define HEAPS "heap,angle_of_repose [deg],angle_of_repose_error [deg]\n"
#define TARGET "locus: lab.csv, number: repose.heap.angle_deg"
#define DEG (M_PI / 180.0)

static void check_target(const clod_plan_target *target, double degrees, double error)
{
    assert_string_equal(target->name, "lab: repose.heap.angle_deg");
    assert_true(target->normal_stress == 0.0);
    assert_true(fabs(target->value / (degrees * DEG) - 1.0) < 1e-9);
    assert_true(fabs(target->error / (error * DEG) - 1.0) < 1e-9);
}

// 30, 34 and 32 deg scatter by 2 deg; 1 deg stated is less, 6 deg in the table or the plan more.
static void the_mean_is_the_target(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", HEAPS "1,30,1\n2,34,1\n3,32,1\n");
    lab_load_good(state, PILE, TARGET ", discrepancy: 0.5 deg", &plan);
    assert_int_equal(plan.target_count, 1);
    check_target(&plan.targets[0], 32.0, 2.0 / sqrt(3.0));
    assert_true(fabs(plan.targets[0].discrepancy / (0.5 * DEG) - 1.0) < 1e-9);
    const clod_plan_repeats *of = &plan.targets[0].repeats;
    static const double OFF[] = {-2.0, 2.0, 0.0};
    assert_true(of->count == 3 && of->estimate);
    for (size_t k = 0; k < 3; k++) {
        assert_int_equal(of->differences[k].specimen, k + 1); // 0 would be no specimen
        assert_true(fabs(of->differences[k].value - OFF[k] * DEG) < 1e-12);
    }
    clod_plan_fini(&plan);
    lab_load_good(state, PILE, TARGET ", error: 6 deg", &plan);
    check_target(&plan.targets[0], 32.0, 6.0 / sqrt(3.0));
    assert_false(plan.targets[0].repeats.estimate);
    clod_plan_fini(&plan);
    lab_write_file(state, "lab.csv", HEAPS "1,30,6\n2,34,6\n3,32,6\n");
    lab_load_good(state, PILE, TARGET, &plan);
    check_target(&plan.targets[0], 32.0, 6.0 / sqrt(3.0));
    clod_plan_fini(&plan);
}

static void the_plan_has_the_error_that_the_table_lacks(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", "angle_of_repose [rad]\n0.5\n");
    lab_load_good(state, PILE, TARGET ", error: 1.5 deg", &plan);
    check_target(&plan.targets[0], 0.5 / DEG, 1.5);
    clod_plan_fini(&plan);
    lab_refuse(state, PILE, TARGET,
               "needs the key error: the table has no angle_of_repose_error");
}

// 30, 34 and 32 deg scatter by 2 deg; 9 deg that one of them states are not those of all.
static void heaps_that_differ_need_no_error(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", "angle_of_repose [deg]\n30\n34\n32\n");
    lab_load_good(state, PILE, TARGET, &plan);
    check_target(&plan.targets[0], 32.0, 2.0 / sqrt(3.0));
    assert_true(plan.targets[0].repeats.estimate);
    clod_plan_fini(&plan);
    lab_write_file(state, "lab.csv", HEAPS "1,30,9\n2,34,\n3,32,9\n");
    lab_load_good(state, PILE, TARGET, &plan);
    check_target(&plan.targets[0], 32.0, 2.0 / sqrt(3.0));
    clod_plan_fini(&plan);
    lab_load_good(state, PILE, TARGET ", error: 6 deg", &plan);
    check_target(&plan.targets[0], 32.0, sqrt(9.0 * 9.0 + 6.0 * 6.0 + 9.0 * 9.0) / 3.0);
    clod_plan_fini(&plan);
}

// The mean of seven angles of 20 deg is off by rounding.
static void what_is_missing_of_heaps_with_one_angle_is_named(void **state)
{
    lab_write_file(state, "lab.csv", "angle_of_repose [deg]\n20\n20\n20\n20\n20\n20\n20\n");
    lab_refuse(
        state, PILE, TARGET,
        "needs the key error: the table has no angle_of_repose_error, and all rows have one value");
    lab_write_file(state, "lab.csv", HEAPS "1,30,1\n2,30,\n3,30,1\n");
    lab_refuse(
        state, PILE, TARGET,
        "needs the key error: 1 of 3 rows have no angle_of_repose_error, and all rows have one value");
}

// Of one NAME under repose: angle_deg error_deg mean_deg deviation_deg.
static void a_table_is_of_an_angle_of_repose(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", HEAPS "1,30,1\n2,34,1\n");
    lab_load_good(state, PILE, "locus: lab.csv, number: repose.heap.mean_deg", &plan);
    assert_true(fabs(plan.targets[0].value / (32.0 * DEG) - 1.0) < 1e-9);
    clod_plan_fini(&plan);
    lab_refuse(
        state, PILE, "locus: lab.csv, number: repose.heap.error_deg",
        "repose.heap.error_deg is no angle of repose, which the table has; it is repose.NAME.angle_deg");
    lab_refuse(state, PILE, "locus: lab.csv, number: repose.heap.deviation_deg",
               "repose.heap.deviation_deg is no angle of repose");
}

static void what_cannot_be_is_told(void **state)
{
    lab_write_file(state, "lab.csv", HEAPS "1,30,1\n2,34,1\n");
    lab_refuse(state, PILE, "locus: lab.csv",
               "needs the key number: which angle of test lab it is, repose.NAME.angle_deg");
    lab_refuse(state, PILE, "locus: lab.csv, number: repose.heap.height_m",
               "repose.heap.height_m is no angle of repose, which the table has");
    lab_refuse(state, PILE, "locus: lab.csv, number: repose.pile.angle_deg",
               "test lab has no number repose.pile.angle_deg; behind repose it has heap");
    lab_refuse(state, PILE, TARGET ", value: 30 deg", "has value or normal_stress beside it");
    lab_refuse(
        state, RING, "locus: lab.csv",
        "has angle_of_repose in its header, as angles of repose (angle_of_repose), and of "
        "tables test lab takes shear points");
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n1,1000\n");
    lab_refuse(state, PILE, TARGET,
               "of tables test lab takes angles of repose (angle_of_repose)");
    lab_write_file(state, "lab.csv", HEAPS "1,0.5,0.1\n");
    lab_refuse(state, PILE, TARGET, "0.5 deg is below 5 deg");
    lab_write_file(state, "lab.csv", "slope [deg]\n30\n");
    lab_refuse(state, PILE, TARGET,
               "none of the columns sigma_sh, sigma_w, sigma_1 and angle_of_repose");
}

// 4.9 and 90.1 deg are beyond what a table may have, 0.66 and 38 rad (2177 deg) of the wrong unit.
static void a_value_is_possible(void **state)
{
    clod_plan plan;
#define VALUE(name, value) "number: repose.heap." name ", value: " value ", error: 1 deg"
    static const char *const IMPOSSIBLE[] = {
        VALUE("angle_deg", "98 deg"), VALUE("angle_deg", "-38 deg"),
        VALUE("angle_deg", "38 rad"), VALUE("angle_deg", "0.66"),
        VALUE("mean_deg", "90.1"),    VALUE("mean_deg", "4.9 deg")};
    for (size_t k = 0; k < sizeof IMPOSSIBLE / sizeof *IMPOSSIBLE; k++) {
        lab_refuse(state, PILE, IMPOSSIBLE[k], "targets.0.value: ");
        lab_refuse(state, PILE, IMPOSSIBLE[k], "is impossible; allowed is 5 to 90 deg");
    }
    lab_refuse(
        state, PILE, VALUE("angle_deg", "0.66"),
        "0.66 is impossible; allowed is 5 to 90 deg: check its unit, which is that of the "
        "name where none is written");
    lab_refuse(state, PILE, "number: repose.heap.angle_deg, value: 38, error: 98",
               "98 is more than all that is possible, 5 to 90 deg");
    static const char *const POSSIBLE[] = {VALUE("angle_deg", "0.66 rad"),
                                           VALUE("angle_deg", "5.1"),
                                           VALUE("mean_deg", "89.9 deg")};
    for (size_t k = 0; k < sizeof POSSIBLE / sizeof *POSSIBLE; k++) {
        lab_load_good(state, PILE, POSSIBLE[k], &plan);
        clod_plan_fini(&plan);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_value_is_possible, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(the_mean_is_the_target, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(the_plan_has_the_error_that_the_table_lacks,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(heaps_that_differ_need_no_error, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(what_is_missing_of_heaps_with_one_angle_is_named,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_table_is_of_an_angle_of_repose, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(what_cannot_be_is_told, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
