/**
 * @file test_plan_doubts_values.c
 * Single values that hardly any solid has are warned of, and those beside them are not: borders by hand.
 */

#include "plan_lab.h"

#define WALL "tests/cli/wall_friction.yaml" // at 5, 10 and 20 kPa

/** Load a plan with one target; it must have a warning in these words, or none with NULL. */
static void check(void **state, const char *from, const char *target, const char *words)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    if (!lab_load(state, from,
                  strcmp(from, WALL) == 0 ? "contacts.ore-plate.friction" : ROLLING, target,
                  &plan, &status)) {
        fail_msg("%s", status.text);
    }
    if (plan.warnings.count != (words == NULL ? 0 : 1) ||
        (words != NULL && strstr(plan.warnings.text[0], words) == NULL)) {
        fail_msg("%s: %zu warnings: %s", target, plan.warnings.count, plan.warnings.text[0]);
    }
    clod_plan_fini(&plan);
}

#define NUMBER(name, value, error) "number: " name ", value: " value ", error: " error
#define AT(stress) ", normal_stress: " stress

static void angles(void **state)
{
    check(state, RING, NUMBER("phi_e", "15.1 deg", "1 deg"), NULL);
    check(
        state, RING, NUMBER("phi_e", "14.9 deg", "1 deg"),
        "targets.0: lab: phi_e, 14.9 deg: hardly any solid has less than 15 deg. Is it in rad?");
    check(state, RING, NUMBER("phi_e", "74.9 deg", "1 deg"), NULL);
    check(state, RING, NUMBER("phi_e", "75.1 deg", "1 deg"),
          "hardly any solid has more than 75 deg. Is it that of another stress?");
    check(state, RING, NUMBER("phi_lin", "59.9 deg", "1 deg"), NULL);
    check(state, RING, NUMBER("phi_lin", "60.1 deg", "1 deg"), "has more than 60 deg");
    check(state, RING, NUMBER("phi_sf", "60.1 deg", "1 deg"), "has more than 60 deg");
    check(state, RING, NUMBER("phi_sf", "14.9 deg", "1 deg"), "has less than 15 deg");
    check(state, WALL, NUMBER("phi_w", "3.1 deg", "1 deg"), NULL);
    check(state, WALL, NUMBER("phi_w", "2.9 deg", "1 deg"),
          "targets.0: lab: phi_w, 2.9 deg: hardly any wall has less than 3 deg");
    check(state, WALL, NUMBER("phi_x", "2.9 deg", "1 deg") AT("20 kPa"), "less than 3 deg");
}

// tan 15 of 27.4 and of 54.8 kPa are 7.342 and 14.684 kPa, tan 60 of 54.8 kPa is 94.916 kPa.
static void shear_stresses(void **state)
{
#define TAU(value) NUMBER("tau", value, "1 kPa") AT("27.4 kPa")
    check(state, RING, TAU("7.4 kPa"), NULL);
    check(state, RING, TAU("7.3 kPa"),
          "targets.0: lab: tau at 27.4 kPa, 7.3 kPa, 14.9 deg of the normal stress: hardly any "
          "solid has less than 15 deg");
    check(state, RING, TAU("94.8 kPa"), NULL);
    check(state, RING, TAU("95 kPa"), "hardly any solid has more than 60 deg");
    check(state, RING, NUMBER("tau_p", "14.7 kPa", "1 kPa"), NULL);
    check(state, RING, NUMBER("tau_p", "14.6 kPa", "1 kPa"), "hardly any solid has less");
    check(state, RING, NUMBER("tau", "5 kPa", "5 kPa") AT("27.4 kPa"),
          NULL); // it tells nothing
}

// A thousandth of 54.8 kPa, two of sigma_c. Up to 60 deg c is 1/(2 cos^2) = 2 times it at most, sigma_c 4 times, sigma_1
// 1/(1 - sin) = 7.464 times: 109.6, 219.2, 409.03 kPa and two of 1 kPa.
static void stresses_of_a_shear_test(void **state)
{
    check(state, RING, NUMBER("c", "56 Pa", "1 Pa"), NULL);
    check(state, RING, NUMBER("c", "54 Pa", "1 Pa"),
          "targets.0: lab: c, 0.054 kPa, is 0.00099 times the preshear stress, 54.8 kPa: next "
          "to none");
    check(state, RING, NUMBER("c", "54 Pa", "28 Pa"), NULL); // 0 within two errors
    check(state, RING, NUMBER("c", "0 Pa", "1 Pa"), NULL);
    check(state, RING, NUMBER("sigma_2", "54 Pa", "1 Pa"), "next to none");
    check(state, RING, NUMBER("sigma_c", "111 Pa", "1 Pa"), NULL);
    check(state, RING, NUMBER("sigma_c", "108 Pa", "1 Pa"), "next to none");
    check(state, RING, NUMBER("c", "111.5 kPa", "1 kPa"), NULL);
    check(state, RING, NUMBER("c", "111.7 kPa", "1 kPa"),
          "hardly any solid or wall has more than 109.6 kPa there");
    check(state, RING, NUMBER("sigma_c", "221.1 kPa", "1 kPa"), NULL);
    check(state, RING, NUMBER("sigma_c", "221.3 kPa", "1 kPa"), "has more than 219.2 kPa");
    check(state, RING, NUMBER("sigma_1", "411 kPa", "1 kPa"), NULL);
    check(state, RING, NUMBER("sigma_1", "411.1 kPa", "1 kPa"), "has more than 409 kPa");
    check(state, RING, NUMBER("sigma_2", "-10 kPa", "1 kPa"), NULL);
    check(state, RING, NUMBER("ffc", "0.81", "0.1"), NULL);
    check(state, RING, NUMBER("ffc", "0.79", "0.1"), "ffc, 0.79, is below 1");
}

static void stresses_of_other_tests(void **state)
{
    check(state, UNIAXIAL, NUMBER("sigma_c", "21.9 kPa", "1 kPa") AT("20 kPa"), NULL);
    check(state, UNIAXIAL, NUMBER("sigma_c", "22.1 kPa", "1 kPa") AT("20 kPa"),
          "sigma_c at 20 kPa, 22.1 kPa, is 1.1 times the consolidation stress, 20 kPa");
    check(state, UNIAXIAL, NUMBER("sigma_c", "41 Pa", "1 Pa") AT("20 kPa"), NULL);
    check(state, UNIAXIAL, NUMBER("sigma_c", "39 Pa", "1 Pa") AT("20 kPa"), "next to none");
    check(state, UNIAXIAL, NUMBER("ffc", "0.81", "0.1") AT("20 kPa"), NULL);
    check(state, UNIAXIAL, NUMBER("ffc", "0.79", "0.1") AT("20 kPa"),
          "targets.0: lab: ffc at 20 kPa, 0.79, is below 1");
    check(state, WALL, NUMBER("tau_ad", "21 Pa", "1 Pa"), NULL);
    check(state, WALL, NUMBER("tau_ad", "19 Pa", "1 Pa"),
          "is 0.00095 times the largest wall stress, 20 kPa");
    check(state, WALL, NUMBER("tau_ad", "21.9 kPa", "1 kPa"), NULL);
    check(state, WALL, NUMBER("tau_ad", "22.1 kPa", "1 kPa"), "has more than 20 kPa there");
}

// A third of 2481.3 kg/m3 is 827.1; of 2400 kg/m3, the lower end of a range, 800.
static void densities(void **state)
{
    check(state, RING, NUMBER("rho_b", "828 kg/m3", "9 kg/m3"), NULL);
    check(state, RING, NUMBER("rho_b", "826 kg/m3", "9 kg/m3"),
          "targets.0: lab: rho_b, 826 kg/m3, is below a third of the density of the grains, "
          "2481 kg/m3");
    check(state, RING, NUMBER("rho_inside", "826 kg/m3", "9 kg/m3"), "is below a third");
    for (int k = 0; k < 2; k++) {
        clod_plan plan;
        clod_status status = {CLOD_OK, ""};
        assert_true(lab_load_range(state, RING, "materials.ore.density", "2400 kg/m3",
                                   "2600 kg/m3",
                                   k == 0 ? NUMBER("rho_b", "801 kg/m3", "9 kg/m3")
                                          : NUMBER("rho_b", "799 kg/m3", "9 kg/m3"),
                                   &plan, &status));
        assert_int_equal(plan.warnings.count, (size_t)k);
        clod_plan_fini(&plan);
    }
}

static void errors(void **state)
{
    check(state, RING, NUMBER("phi_e", "40 deg", "0.041 deg"), NULL);
    check(state, RING, NUMBER("phi_e", "40 deg", "0.039 deg"),
          "targets.0: the error of lab: phi_e, 0.039 deg, is 0.00098 of its value");
    check(state, RING, NUMBER("phi_e", "40 deg", "1e-6 deg"), "is 2.5e-08 of its value");
    check(state, RING, NUMBER("phi_e", "40 deg", "1e-6 deg, discrepancy: 0.5 deg"), NULL);
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n20,1500\n54.8,1600\n");
    check(state, UNIAXIAL, "locus: lab.csv, error: 1 kg/m3",
          NULL); // densities are known better
    check(state, UNIAXIAL, "locus: lab.csv, error: 0.1 kg/m3", "is 6.7e-05 of its value");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(angles),
        TEST(shear_stresses),
        TEST(stresses_of_a_shear_test),
        TEST(stresses_of_other_tests),
        TEST(densities),
        TEST(errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
