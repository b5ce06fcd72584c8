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

// 54.8 kPa over 2 cos(80 deg)^2 is 908.7 kPa, 16.58 times as much, and 1817 kPa is twice that; 54.8 kPa/(1 - sin(80 deg)) is
// 3607.1 kPa. Pa for kPa is a thousand times.
static void stresses_in_another_unit(void **state)
{
    load(state, RING, "number: c, value: 910 kPa, error: 1 kPa");
    lab_refuse(
        state, RING, "number: c, value: 911 kPa, error: 1 kPa",
        "test lab: c 911 kPa in targets.0 is 16.6 times the preshear stress of the case, 54.8 kPa, where no solid with "
        "phi_sf up to 80 deg has more than 16.6 times: check its unit, or give the test the preshear stress of that c");
    load(state, RING, "number: sigma_c, value: 1818 kPa, error: 1 kPa");
    lab_refuse(state, RING, "number: sigma_c, value: 1820 kPa, error: 1 kPa",
               "has more than 33.2 times: check its unit");
    load(state, RING, "number: sigma_1, value: 3609 kPa, error: 1 kPa");
    lab_refuse(state, RING, "number: sigma_1, value: 3610 kPa, error: 1 kPa",
               "has more than 65.8 times: check its unit");
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

// tau_p 37.4 +- 3 kPa at 54.8 kPa is 34.313 +- 2.140 deg: sigma_1 is 54.8/cos^2 = 80.325 kPa at least, with the slope
// 2 tan/cos^2, 4.095 kPa of the error, and 54.8/(1 - sin) = 125.605 kPa at most, with the slope cos/(1 - sin)^2, 8.881 kPa. Two of
// sqrt(1 + 4.095^2) and sqrt(1 + 8.881^2) away are 71.89 and 143.48 kPa.
static void major_stress_beside_steady_flow(void **state)
{
#define BESIDE(value, other)                                                                   \
    "number: sigma_1, value: " value " kPa, error: 1 kPa}, {test: lab, number: " other
#define TAU_P "tau_p, value: 37.4 kPa, error: 3 kPa"
    load(state, RING, BESIDE("72", TAU_P));
    load(state, RING, BESIDE("143.4", TAU_P));
    lab_refuse(state, RING, BESIDE("71.8", TAU_P),
               "test lab: sigma_1 71.8 kPa in targets.0 does not go with tau_p 37.4 kPa in "
               "targets.1: at the preshear stress");
    lab_refuse(state, RING, BESIDE("143.6", TAU_P), "have 80.32 to 125.6 kPa; check units");
    lab_refuse(state, RING, BESIDE("143.6", "phi_sf, value: 34.313 deg, error: 2.14 deg"),
               "does not go with phi_sf 34.31 deg in targets.1");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(stresses_in_another_unit),        TEST(shear_stress_in_another_unit),
        TEST(angle_in_another_unit),           TEST(strength_far_above_its_consolidation),
        TEST(major_stress_beside_steady_flow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
