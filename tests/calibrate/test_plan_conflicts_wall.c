/**
 * @file test_plan_conflicts_wall.c
 * Targets of a wall friction test that cannot be true together are refused, and those that errors allow are not: by hand.
 */

#include "plan_lab.h"

#define WALL "tests/cli/wall_friction.yaml" // at 5, 10 and 20 kPa
#define PLATE "contacts.ore-plate.friction"
#define AND "}, {test: lab, "
#define PHI_X(stress, value)                                                                   \
    "number: phi_x, normal_stress: " stress " kPa, value: " value " deg, error: 1 deg"

static void load(void **state, const char *target)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    if (!lab_load(state, WALL, PLATE, target, &plan, &status)) {
        fail_msg("%s", status.text);
    }
    assert_true(plan.target_count > 0);
    clod_plan_fini(&plan);
}

// tan 20 = 0.363970: 7.27940 kPa at 20 kPa, 1.81985 kPa at 5 kPa, and at 10 kPa between these. About their mean of 35/3 kPa
// the stresses have the slope (5 tau_20 - tau_10 - 4 tau_5)/70: 0.31197 to 0.38997, 17.33 to 21.30 deg. 1 deg of phi_x are
// 0.39531 and 0.09883 kPa: errors of 4 e_20/70 and 4 e_5/70, so 0.02328, and of 5 e_20/70 and 5 e_5/70, so 0.02911; and 1 deg of phi_w
// is (1 + tan^2) pi/180. Two of both together are reached at 14.166 and 24.795 deg, and with a discrepancy of 0.5 deg beside it,
// 1.118 deg, 0.07510 above 0.38997, tan 24.9 = 0.46419 is not beyond.
static void slope_of_a_line_through_the_points(void **state)
{
#define POINTS PHI_X("20", "20") AND PHI_X("5", "20") AND
    load(state, POINTS "number: phi_w, value: 24.7 deg, error: 1 deg");
    load(state, POINTS "number: phi_w, value: 14.2 deg, error: 1 deg");
    load(state, POINTS "number: phi_w, value: 24.9 deg, error: 1 deg, discrepancy: 0.5 deg");
    lab_refuse_of(
        state, WALL, PLATE, POINTS "number: phi_w, value: 24.9 deg, error: 1 deg",
        "targets.2.value: phi_w 24.9 deg contradicts phi_x in targets.0, targets.1: with these, and shear stresses that rise "
        "with the normal stress, the line through the points at the wall_stresses of test lab has a phi_w of 17.33 to "
        "21.3 deg. Correct or leave out one of them");
    lab_refuse_of(state, WALL, PLATE, POINTS "number: phi_w, value: 14.1 deg, error: 1 deg",
                  "targets.2.value: phi_w 14.1 deg contradicts phi_x");
}

// It ends at tau_5 + (tau_10 - tau_20)/2: 1.81985 kPa at most, 0.09883 kPa of it from the error at 5 kPa, and that at 20 kPa
// cancels; below 0 there is no adhesion. Two of sqrt(0.09883^2 + 0.05^2) kPa are 0.2215 kPa.
static void adhesion_of_a_line_through_the_points(void **state)
{
    load(state, POINTS "number: tau_ad, value: 2.04 kPa, error: 0.05 kPa");
    load(state, POINTS "number: tau_ad, value: 0 kPa, error: 0.05 kPa");
    lab_refuse_of(state, WALL, PLATE, POINTS "number: tau_ad, value: 2.05 kPa, error: 0.05 kPa",
                  "targets.2.value: tau_ad 2.05 kPa contradicts phi_x in targets.0, targets.1");
    lab_refuse_of(state, WALL, PLATE, POINTS "number: tau_ad, value: 2.05 kPa, error: 0.05 kPa",
                  "has a tau_ad of 0 to 1.82 kPa");
}

// Without a phi_x below it the shear stress may be 0 there, and without one above it up to 80 deg: with tan 12 = 0.21256 at
// 20 kPa alone the slope is 5 4.2511/70 = 0.30365 at most, 16.9 deg.
static void one_angle_beside_a_slope(void **state)
{
    load(state, PHI_X("20", "12") AND "number: phi_w, value: 17 deg, error: 1 deg");
    lab_refuse_of(state, WALL, PLATE,
                  PHI_X("20", "12") AND "number: phi_w, value: 40 deg, error: 1 deg",
                  "has a phi_w of 0 to 16.89 deg");
    load(state, "number: phi_w, value: 40 deg, error: 1 deg"); // nothing beside it
}

static void points_of_a_table_beside_a_slope(void **state)
{
#define TABLE "locus: lab.csv" AND
    lab_write_file(state, "lab.csv",
                   "sigma_w [kPa],tau_w [kPa],tau_w_error [kPa]\n5,1.25,0.01\n10,2.5,0.01\n"
                   "20,5,0.01\n");
    load(state, TABLE "number: phi_w, value: 14 deg, error: 1 deg"); // tan 14.036 = 1/4
    lab_refuse_of(state, WALL, PLATE, TABLE "number: phi_w, value: 17 deg, error: 1 deg",
                  "targets.1.value: phi_w 17 deg contradicts phi_x in targets.0: ");
}

// 1.81985 kPa at 5 kPa; tan 8.5 and tan 7 are 1.4945 and 1.2278 kPa at 10 kPa. Two of sqrt(0.0988^2 + 0.1784^2) = 0.2039
// and of sqrt(0.0988^2 + 0.1772^2) = 0.2029 kPa are 0.408 and 0.406.
static void shear_stresses_that_fall(void **state)
{
    load(state, PHI_X("10", "8.5") AND PHI_X("5", "20"));
    load(state, PHI_X("5", "20") AND PHI_X("10", "8.5"));
    lab_refuse_of(
        state, WALL, PLATE, PHI_X("5", "20") AND PHI_X("10", "7"),
        "test lab: the shear stress falls from 1.82 kPa (phi_x 20.0 deg at 5 kPa in targets.0) to 1.228 kPa (phi_x 7.0 deg "
        "at 10 kPa in targets.1), and that of a wall rises with the normal stress");
}

static void angles_that_no_wall_has(void **state)
{
    load(state, PHI_X("20", "1"));
    lab_refuse_of(state, WALL, PLATE, PHI_X("20", "0.9"),
                  "targets.0.value: 0.9 deg is impossible; allowed is 1 to 85 deg");
    load(state, "number: phi_w, value: 1 deg, error: 1 deg");
    lab_refuse_of(state, WALL, PLATE, "number: phi_w, value: 0.9 deg, error: 1 deg",
                  "0.9 deg is impossible; allowed is 1 to 80 deg");
    lab_refuse_of(state, WALL, PLATE, "number: phi_w, value: 81 deg, error: 1 deg",
                  "81 deg is impossible");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(slope_of_a_line_through_the_points), TEST(adhesion_of_a_line_through_the_points),
        TEST(one_angle_beside_a_slope),           TEST(points_of_a_table_beside_a_slope),
        TEST(shear_stresses_that_fall),           TEST(angles_that_no_wall_has),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
