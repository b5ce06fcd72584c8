/**
 * @file test_plan_conflicts_unit.c
 * Values that no solid has at the stress of its test are refused: a wrong unit, by hand.
 */

#include "plan_lab.h"

static void load(void **state, const char *from, const char *target)
{
    clod_plan plan;
    lab_load_good(state, from, target, &plan);
    assert_true(plan.target_count > 0);
    clod_plan_fini(&plan);
}

// 27.4 kPa tan(1 deg) is 0.47827 kPa, and 54.8 kPa tan(80 deg) 310.79 kPa.
static void shear_stress_in_another_unit(void **state)
{
#define TAU(value) "number: tau, normal_stress: 27.4 kPa, value: " value ", error: 0.01 kPa"
    load(state, RING, TAU("479 Pa"));
    lab_refuse(
        state, RING, TAU("477 Pa"),
        "targets.0.value: tau 0.477 kPa at a normal stress of 27.4 kPa and a preshear stress of 54.8 kPa: it must be "
        "0.4783 kPa to 310.8 kPa");
    load(state, RING, TAU("310 kPa"));
    lab_refuse(state, RING, TAU("312 kPa"), "tau 312 kPa at a normal stress of 27.4 kPa");
}

// atan(310/54.8) is 79.97 deg and atan(330/54.8) 80.57; atan(0.97/54.8) is 1.01 deg and atan(0.9/54.8) 0.94.
static void a_tau_p_has_the_limits_of_its_angle(void **state)
{
    load(state, RING, "number: tau_p, value: 310 kPa, error: 3 kPa");
    lab_refuse(
        state, RING, "number: tau_p, value: 330 kPa, error: 3 kPa",
        "test lab: tau_p 330 kPa in targets.0 is a phi_sf of 80.6 deg at the preshear stress of the case, "
        "54.8 kPa; it must be 1 to 80 deg");
    load(state, RING, "number: tau_p, value: 0.97 kPa, error: 0.01 kPa");
    lab_refuse(state, RING, "number: tau_p, value: 0.9 kPa, error: 0.01 kPa",
               "tau_p 0.9 kPa in targets.0 is a phi_sf of 0.9 deg");
}

static void angle_in_another_unit(void **state)
{
    load(state, RING, "number: phi_e, value: 1 deg, error: 0.1 deg");
    lab_refuse(
        state, RING, "number: phi_e, value: 0.83 deg, error: 0.03 deg",
        "targets.0.value: 0.83 deg is impossible; allowed is 1 to 85 deg: check its unit");
}

// Ten times 20 kPa and two of 5 kPa; a tenth less two of 0.01.
static void strength_far_above_its_consolidation(void **state)
{
    load(state, UNIAXIAL,
         "number: sigma_c, normal_stress: 20 kPa, value: 209.9 kPa, error: 5 kPa");
    lab_refuse(
        state, UNIAXIAL,
        "number: sigma_c, normal_stress: 20 kPa, value: 210.1 kPa, error: 5 kPa",
        "test lab: sigma_c 210.1 kPa in targets.0 is 10.5 times the stress that consolidates it, 20 kPa");
    load(state, UNIAXIAL, "number: ffc, normal_stress: 20 kPa, value: 0.081, error: 0.01");
    lab_refuse(
        state, UNIAXIAL, "number: ffc, normal_stress: 20 kPa, value: 0.079, error: 0.01",
        "test lab: ffc 0.079 in targets.0 is a sigma_c of 12.7 times the stress that consolidates it");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(shear_stress_in_another_unit),
        TEST(a_tau_p_has_the_limits_of_its_angle),
        TEST(angle_in_another_unit),
        TEST(strength_far_above_its_consolidation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
