/**
 * @file test_plan_conflicts.c
 * Targets that cannot be true together are refused, and those that errors allow are not: by hand.
 */

#include "plan_lab.h"

// 54.8 kPa, known to 2 %, over 11 kPa is 4.98. 11 (6.5 - 4.98) = 16.7 kPa is 3.5 of
// sqrt((0.3 11)^2 + (6.5 0.5)^2 + 1.096^2) = 4.76 kPa. That of 20 kPa is another consolidation.
static void ffc_beside_the_strength_of_its_consolidation(void **state)
{
#define OF(ffc, stress)                                                                        \
    "number: sigma_c, value: 11 kPa, error: 0.5 kPa, normal_stress: 54.8 kPa}, "               \
    "{test: lab, number: ffc, value: " ffc ", error: 0.3, normal_stress: " stress
    clod_plan plan;
    lab_load_good(state, UNIAXIAL, OF("5.2", "54.8 kPa"), &plan);
    clod_plan_fini(&plan);
    lab_load_good(state, UNIAXIAL, OF("6.5", "20 kPa"), &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, UNIAXIAL, OF("6.5", "54.8 kPa"),
        "test lab: ffc 6.5 in targets.1 is not sigma_1/sigma_c = 54.8 kPa/11 kPa, of the consolidation stress "
        "and sigma_c in targets.0, by 3.5 standard errors");
}

#define LINE_LAB                                                                               \
    "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"                \
    "54.8,37,10.96,15.48,1500\n54.8,37,27.4,23.7,1510\n54.8,37,43.84,31.92,1505\n"
#define AGAIN "}, {test: lab, "

// Its densities are another measurement than its shear stresses.
static void shear_points_of_one_table_twice(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", LINE_LAB);
    lab_write_file(state, "other.csv", LINE_LAB);
    lab_load_good(state, RING,
                  "locus: lab.csv, error: 0.5 kPa" AGAIN
                  "locus: lab.csv, number: rho_b, error: 15 kg/m3",
                  &plan);
    clod_plan_fini(&plan);
    lab_load_good(state, RING,
                  "locus: lab.csv, error: 0.5 kPa" AGAIN "locus: other.csv, error: 0.5 kPa",
                  &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, RING, "locus: lab.csv, error: 0.5 kPa" AGAIN "locus: lab.csv, error: 0.5 kPa",
        "targets.1.locus: is the table of targets.0, and lab: tau at 10.96 kPa is in both: one measurement "
        "would count as two");
    lab_refuse(
        state, RING,
        "locus: lab.csv, error: 0.5 kPa" AGAIN
        "locus: ./lab.csv, number: tau, error: 1 kPa, held_back: true",
        "targets.1.locus: is the table of targets.0, and lab: tau at 10.96 kPa is in both");
}

static void rows_of_one_table_twice(void **state)
{
#define ROW(stress) "locus: lab.csv, error: 15 kg/m3, normal_stress: " stress " kPa"
    clod_plan plan;
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n20,1500\n54.8,1600\n");
    lab_load_good(state, UNIAXIAL, ROW("20") AGAIN ROW("54.8"), &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, UNIAXIAL, ROW("20") AGAIN ROW("20"),
        "targets.1.locus: is the table of targets.0, and lab: rho_b at 20 kPa is in both");
    lab_refuse(
        state, UNIAXIAL, ROW("54.8") AGAIN "locus: lab.csv, error: 15 kg/m3",
        "targets.1.locus: is the table of targets.0, and lab: rho_b at 54.8 kPa is in both");
}

// The ore of both cases has 2481.3 kg/m3.
static void bulk_density_above_that_of_the_grains(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    static const char *const DENSE = "number: rho_b, value: 2500 kg/m3, error: 15 kg/m3";
    static const char *const WORDS =
        "test lab: rho_b 2500 kg/m3 in targets.0 is above the density of its grains, 2481 kg/m3, which no "
        "packing of them reaches";
    lab_refuse(state, RING, DENSE, WORDS);
    lab_refuse(
        state, RING, "number: rho_inside, value: 2500 kg/m3, error: 15 kg/m3",
        "test lab: rho_inside 2500 kg/m3 in targets.0 is above the density of its grains");
    lab_load_good(state, RING, "number: rho_b, value: 2450 kg/m3, error: 15 kg/m3", &plan);
    clod_plan_fini(&plan);
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n54.8,2500\n");
    lab_refuse(state, UNIAXIAL, "locus: lab.csv, error: 15 kg/m3", WORDS);

    // grains that may be as dense as 2600 kg/m3
    assert_true(lab_load_range(state, RING, "materials.ore.density", "2400 kg/m3", "2600 kg/m3",
                               DENSE, &plan, &status));
    clod_plan_fini(&plan);
    assert_false(lab_load_range(state, RING, "materials.ore.density", "2400 kg/m3",
                                "2490 kg/m3", DENSE, &plan, &status));
    assert_non_null(strstr(status.text, "above the density of its grains, 2490 kg/m3"));
    clod_plan_fini(&plan);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(ffc_beside_the_strength_of_its_consolidation),
        TEST(shear_points_of_one_table_twice),
        TEST(rows_of_one_table_twice),
        TEST(bulk_density_above_that_of_the_grains),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
