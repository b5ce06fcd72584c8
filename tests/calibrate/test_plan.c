/**
 * @file test_plan.c
 * Measured tables of a plan become targets: values, errors and normal stresses by hand.
 */

#include "plan_lab.h"

#define DEGREE 0.017453292519943295
#define WALL "tests/cli/wall_friction.yaml"
#define SHEAR_HEAD                                                                             \
    "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],tau_sh_error [kPa]\n"
#define SEEDS_HEAD "seed," SHEAR_HEAD
#define WALL_HEAD "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa],steady\n"

// Mean tau_p of the three specimens: 40 kPa. Prorated: tau_sh 40 kPa/tau_p, as is its error. The specimens differ by 2 kPa, so
// the mean is known to 2/sqrt(3) kPa, and so are, in proportion, all points.
static void measured_yield_locus_becomes_targets(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    lab_write_file(state, "lab.csv",
                   SHEAR_HEAD "54.8,38,12,20,0.5\n54.8,42,30,30,0.8\n54.8,40,40,35,0\n");
    assert_true(
        lab_load(state, RING, "contacts.default.rolling_friction",
                 "locus: lab.csv, error: 0.7 kPa, discrepancy: 0.2 kPa, held_back: false",
                 &plan, &status));
    assert_int_equal(plan.target_count, 3);
    const double low = 20e3 * 40.0 / 38.0, middle = 30e3 * 40.0 / 42.0;
    const double mean = 2.0 / sqrt(3.0) / 40.0;
    lab_check_target(&plan.targets[0], "lab: tau at 12 kPa", 12e3, low,
                     hypot(0.7e3 * 40.0 / 38.0, low * mean)); // 0.7 kPa of the plan
    lab_check_target(&plan.targets[1], "lab: tau at 30 kPa", 30e3, middle,
                     hypot(0.8e3 * 40.0 / 42.0, middle * mean)); // 0.8 kPa of the table
    lab_check_target(&plan.targets[2], "lab: tau at 40 kPa", 40e3, 35e3,
                     hypot(0.7e3, 35e3 * mean));
    for (size_t t = 0; t < 3; t++) {
        assert_true(fabs(plan.targets[t].discrepancy - 0.2e3) < 1e-9);
    }
    clod_plan_fini(&plan);
}

// Two tables with a stress in common, and one number twice: their places in the plan tell them apart.
static void targets_of_one_number_have_names_of_their_own(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    lab_write_file(state, "lab.csv", SHEAR_HEAD "54.8,40,12,20,0.5\n54.8,40,30,30,0.5\n");
    lab_write_file(state, "other.csv", SHEAR_HEAD "54.8,40,12,21,0.5\n54.8,40,40,36,0.5\n");
    assert_true(
        lab_load(state, RING, "contacts.default.rolling_friction",
                 "number: phi_e, value: 40 deg, error: 1 deg}, {test: lab, locus: lab.csv}, "
                 "{test: lab, locus: other.csv}, "
                 "{test: lab, number: phi_e, value: 41 deg, error: 1 deg, held_back: true",
                 &plan, &status));
    static const char *const NAMES[] = {
        "lab: phi_e (targets.0)", "lab: tau at 12 kPa (targets.1)",
        "lab: tau at 30 kPa",     "lab: tau at 12 kPa (targets.2)",
        "lab: tau at 40 kPa",     "lab: phi_e (targets.3)"};
    assert_int_equal(plan.target_count, 6);
    for (size_t t = 0; t < 6; t++) {
        assert_string_equal(plan.targets[t].name, NAMES[t]);
    }
    clod_plan_fini(&plan);
}

// phi_x = atan(tau_w/sigma_w); its error is that of tau_w over sigma_w (1 + (tau_w/sigma_w)^2), 0.28 deg at 20 kPa and 1.62 deg
// at 5 kPa, or the plan's 0.5 deg where that is larger.
static void measured_wall_yield_locus_becomes_angles(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    lab_write_file(state, "lab.csv", WALL_HEAD "20,4,0.1,1\n10,2.5,0,1\n5,1,0.15,1\n");
    assert_true(lab_load(state, WALL, "contacts.ore-plate.friction",
                         "locus: lab.csv, error: 0.5 deg", &plan, &status));
    assert_int_equal(plan.target_count, 3);
    lab_check_target(&plan.targets[0], "lab: phi_x at 20 kPa", 20e3, atan(0.2), 0.5 * DEGREE);
    lab_check_target(&plan.targets[1], "lab: phi_x at 10 kPa", 10e3, atan(0.25), 0.5 * DEGREE);
    lab_check_target(&plan.targets[2], "lab: phi_x at 5 kPa", 5e3, atan(0.2),
                     0.15 / 5.0 / (1.0 + 0.2 * 0.2));
    clod_plan_fini(&plan);
}

// A table of clod has the stress that was asked for beside the one that was reached.
static void point_stands_at_the_stress_that_was_asked_for(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    lab_write_file(state, "lab.csv",
                   "wall_stress [kPa],sigma_w [kPa],tau_w [kPa]\n20,19,4\n10,9,2.5\n5,4.5,1\n");
    assert_true(lab_load(state, WALL, "contacts.ore-plate.friction",
                         "locus: lab.csv, error: 0.5 deg, normal_stress: 10 kPa", &plan,
                         &status));
    assert_int_equal(plan.target_count, 1);
    lab_check_target(&plan.targets[0], "lab: phi_x at 10 kPa", 10e3, atan(2.5 / 9.0),
                     0.5 * DEGREE);
    clod_plan_fini(&plan);
}

// tau_p is 40 kPa in all, so tau_sh is prorated already. 30 kPa: 30, 30.3, 30.6, s^2 0.09 kPa^2; 12 kPa: 19, 20,
// 24, squares 4 + 1 + 9, s^2 7 kPa^2. Coefficient of variation of both: its square is the mean of 0.09/30.3^2 and
// 7/21^2, 0.089298^2, so 1.5622 and 1.0827 kPa of the means. Stated 0.6, 0.6 and the plan's 0.7 are less,
// sqrt(1.21)/3, and so is 0.7/sqrt(3).
static void specimens_at_one_stress_are_one_target(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    lab_write_file(state, "lab.csv",
                   SEEDS_HEAD "1,54.8,40,30,30,0.6\n1,54.8,40,12,19,0\n"
                              "2,54.8,40,30,30.3,0.6\n2,54.8,40,12,20,0\n"
                              "3,54.8,40,30,30.6,0\n3,54.8,40,12,24,0\n");
    assert_true(lab_load(state, RING, "contacts.default.rolling_friction",
                         "locus: lab.csv, error: 0.7 kPa", &plan, &status));
    assert_int_equal(plan.target_count, 2);
    const double share = sqrt(0.5 * (0.09 / (30.3 * 30.3) + 7.0 / (21.0 * 21.0)) / 3.0);
    lab_check_target(&plan.targets[0], "lab: tau at 30 kPa", 30e3, 30.3e3, share * 30.3e3);
    lab_check_target(&plan.targets[1], "lab: tau at 12 kPa", 12e3, 21e3, share * 21e3);
    static const double OFF[2][3] = {{-0.3e3, 0.0, 0.3e3}, {-2e3, -1e3, 3e3}};
    for (size_t t = 0; t < 2; t++) {
        const clod_plan_repeats *of = &plan.targets[t].repeats;
        assert_true(of->count == 3 && of->estimate && plan.targets[t].table == 1);
        for (size_t k = 0; k < 3; k++) {
            assert_int_equal(of->differences[k].specimen, k + 1);
            assert_true(fabs(of->differences[k].value - OFF[t][k]) < 1e-6);
        }
    }
    assert_int_equal(plan.warnings.count > 0, 1);
    assert_non_null(strstr(
        plan.warnings.text[0],
        "errors are estimated from 3 specimens, whose scatter at one stress is uncertain by 50 %"));
    clod_plan_fini(&plan);
}

// Both specimens have tau = 10 kPa + sigma/2, and their stresses are not quite the same: no scatter.
// Targets are in the order of the table.
static void specimens_at_almost_one_stress_scatter_about_the_locus(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    lab_write_file(state, "lab.csv",
                   SEEDS_HEAD
                   "1,54.8,40,12,16,0.02\n1,54.8,40,29.8,24.9,0.02\n1,54.8,40,20,20,0.02\n"
                   "2,54.8,40,12,16,0.02\n2,54.8,40,30.2,25.1,0.02\n2,54.8,40,20,20,0.02\n");
    assert_true(lab_load(state, RING, "contacts.default.rolling_friction", "locus: lab.csv",
                         &plan, &status));
    assert_int_equal(plan.target_count, 3);
    lab_check_target(&plan.targets[0], "lab: tau at 12 kPa", 12e3, 16e3, 20.0 / sqrt(2.0));
    lab_check_target(&plan.targets[1], "lab: tau at 30 kPa", 30e3, 25e3, 20.0 / sqrt(2.0));
    lab_check_target(&plan.targets[2], "lab: tau at 20 kPa", 20e3, 20e3, 20.0 / sqrt(2.0));
    clod_plan_fini(&plan);
}

// Rows of one stress without seeds. The mean of two angles a and b is known to |a - b|/2, more than 0.5 deg/sqrt(2); one
// of them, and so the one angle at the other stress, to sqrt(2) times as much of its value, more than 0.5 deg.
static void repeats_at_one_wall_stress_are_one_target(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    lab_write_file(state, "lab.csv", WALL_HEAD "20,4,0,1\n10,2.5,0,1\n20,4.4,0,1\n");
    assert_true(lab_load(state, WALL, "contacts.ore-plate.friction",
                         "locus: lab.csv, error: 0.5 deg", &plan, &status));
    assert_int_equal(plan.target_count, 2);
    const double mean = 0.5 * (atan(0.2) + atan(0.22)), half = 0.5 * (atan(0.22) - atan(0.2));
    lab_check_target(&plan.targets[0], "lab: phi_x at 20 kPa", 20e3, mean, half);
    lab_check_target(&plan.targets[1], "lab: phi_x at 10 kPa", 10e3, atan(0.25),
                     sqrt(2.0) * half / mean * atan(0.25));
    assert_true(plan.targets[0].repeats.pooled && plan.targets[1].repeats.estimate);
    assert_non_null(strstr(plan.warnings.text[0], "the rows of one stress have one seed"));
    clod_plan_fini(&plan);
}

// A shear stress of 0 has no coefficient of variation: each point keeps its own scatter, 0 and 2 kPa of the mean, or what
// the table states.
static void points_beside_one_of_0_keep_their_own_scatter(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    lab_write_file(state, "lab.csv",
                   SEEDS_HEAD
                   "1,54.8,40,12,0,0.1\n2,54.8,40,12,0,0.1\n"
                   "1,54.8,40,20,18,0.1\n2,54.8,40,20,22,0.1\n1,54.8,40,30,30,0.1\n");
    assert_true(lab_load(state, RING, "contacts.default.rolling_friction", "locus: lab.csv",
                         &plan, &status));
    assert_int_equal(plan.target_count, 3);
    assert_true(plan.targets[0].value == 0.0);
    assert_true(fabs(plan.targets[0].error - 0.1e3 / sqrt(2.0)) < 1e-9);
    lab_check_target(&plan.targets[1], "lab: tau at 20 kPa", 20e3, 20e3, 2e3);
    lab_check_target(&plan.targets[2], "lab: tau at 30 kPa", 30e3, 30e3, 0.1e3);
    assert_true(plan.targets[1].repeats.estimate && !plan.targets[1].repeats.pooled);
    clod_plan_fini(&plan);
}

static void refuse(void **state, const char *target, const char *words)
{
    lab_refuse_of(state, WALL, "contacts.ore-plate.friction", target, words);
}

static void table_of_another_test_is_refused(void **state)
{
    lab_write_file(state, "lab.csv", WALL_HEAD "20,4,0.1,1\n10,2.5,0.1,1\n");
    lab_refuse_of(
        state, "cases/copper-ore-uniaxial/case.yaml", "contacts.default.rolling_friction",
        "locus: lab.csv",
        "targets.0.locus: has sigma_w or tau_w in its header, as a wall yield locus (sigma_w, tau_w), and of "
        "tables test lab takes bulk densities (sigma_1, rho_b), a flow function (sigma_1, sigma_c)");
}

static void densities_over_the_preshear_stress_are_refused(void **state)
{
    lab_write_file(state, "lab.csv", "sigma_pre [kPa],rho_b [kg/m3]\n20,1400\n54.8,1500\n");
    lab_refuse_of(
        state, RING, "contacts.default.rolling_friction", "locus: lab.csv",
        "lab.csv: is a table of bulk densities over the preshear stress (sigma_pre, rho_b). A table of bulk "
        "densities needs sigma_1");
}

// By hand: tau = 5 kPa + 0.5 sigma has 32.4 kPa at 54.8 kPa; 12 kPa are 0.37 of it.
static void preshear_far_below_its_line_is_refused(void **state)
{
    lab_write_file(state, "lab.csv", SHEAR_HEAD "54.8,12,12,11,0.1\n54.8,12,30,20,0.1\n");
    lab_refuse_of(
        state, RING, "contacts.default.rolling_friction", "locus: lab.csv",
        "lab.csv:2, 3: the yield locus at a preshear stress of 54.800 kPa has tau_pre = 12.000 kPa, 0.370 of the "
        "32.400 kPa");
}

static void wall_table_that_is_no_target_is_refused(void **state)
{
    lab_write_file(state, "lab.csv", WALL_HEAD "20,4,0.1,1\n10,2.5,0,0\n");
    refuse(state, "locus: lab.csv, error: 0.5 deg",
           "targets.0.locus: was not steady at 10 kPa");
    lab_write_file(state, "lab.csv", WALL_HEAD "20,4,0.1,1\n10,2.5,0,1\n7,1,0,1\n");
    refuse(state, "locus: lab.csv",
           "needs the key error: the table has no tau_w_error at 10 kPa");
    lab_write_file(state, "lab.csv", WALL_HEAD "20,4,0.1,1\n20,4.4,0,1\n10,2.5,0.1,1\n");
    refuse(state, "locus: lab.csv",
           "needs the key error: 1 of 2 rows have no tau_w_error at 20 kPa");
    lab_write_file(state, "lab.csv", WALL_HEAD "20,4,0.1,1\n10,2.5,0,1\n7,1,0,1\n");
    refuse(state, "locus: lab.csv, error: 0.5 deg",
           "targets.0.locus: 7 kPa is not among the wall_stresses of test lab");
    refuse(state, "locus: lab.csv, error: 0.5 deg, normal_stress: 5 kPa",
           "targets.0.normal_stress: 5 kPa: the table has no point there");
    refuse(state, "locus: lab.csv, value: 12 deg, error: 0.5 deg",
           "targets.0.locus: has value beside it");
    refuse(
        state, "locus: lab.csv, number: phi_w, error: 0.5 deg",
        "targets.0.number: phi_w is none of a wall yield locus (sigma_w, tau_w); of such a table it is phi_x");
    lab_write_file(state, "lab.csv", WALL_HEAD "20,4,0.1,1\n10,0,0.1,1\n");
    refuse(state, "locus: lab.csv", "has a phi_x of 0 deg at 10 kPa; allowed is 1 to 85 deg");
    lab_write_file(state, "lab.csv", WALL_HEAD "20,2,0.1,1\n10,2.5,0.1,1\n"); // atan(-0.05)
    refuse(
        state, "locus: lab.csv",
        "targets.0.locus: the wall yield locus falls: its line has phi_w = -2.9 deg. No wall");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(targets_of_one_number_have_names_of_their_own,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(measured_yield_locus_becomes_targets, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(measured_wall_yield_locus_becomes_angles,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(point_stands_at_the_stress_that_was_asked_for,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(specimens_at_one_stress_are_one_target,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(specimens_at_almost_one_stress_scatter_about_the_locus,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(points_beside_one_of_0_keep_their_own_scatter,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(repeats_at_one_wall_stress_are_one_target,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(wall_table_that_is_no_target_is_refused,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(densities_over_the_preshear_stress_are_refused,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(preshear_far_below_its_line_is_refused,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(table_of_another_test_is_refused, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
