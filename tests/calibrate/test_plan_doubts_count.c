/**
 * @file test_plan_doubts_count.c
 * Fewer independent used targets than parameters are warned of: counted by hand.
 */

#include "plan_lab.h"

#define WALL "tests/cli/wall_friction.yaml"     // at 5, 10 and 20 kPa
#define PILE "cases/calibrate-repose/pile.yaml" // repose: {heap: ...}
#define AT(stress) ", normal_stress: " stress "}"
#define NUMBER(name, value, error)                                                             \
    "{test: lab, number: " name ", value: " value ", error: " error
#define HELD_BACK ", held_back: true}"

/** What a plan of three parameters of a case says of the number of its targets; NULL: nothing. Its other warnings are
 *  none of these tests'. */
static void check(void **state, const char *from, const char *const *keys, const char *targets,
                  const char *words)
{
    char text[2048], path[PATH_MAX];
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    const char *found = NULL;
    snprintf(
        text, sizeof text,
        "points: 20\ntests: {lab: {case: %s/%s}}\n"
        "parameters: {a: {key: %s, from: 0.1, to: 0.2}, b: {key: %s, from: 0.1, to: 0.2}, c: "
        "{key: %s, from: 0.1, to: 0.2}}\ntargets: [%s]\n",
        CLOD_SOURCE_DIR, from, keys[0], keys[1], keys[2], targets);
    lab_write_file(state, "plan.yaml", text);
    if (!clod_plan_load(temp_path(path, state, "plan.yaml"), NULL, 0, &plan, &status)) {
        fail_msg("%s", status.text);
    }
    for (size_t k = 0; k < plan.warnings.count; k++) {
        if (strstr(plan.warnings.text[k], "are free, and the used targets") != NULL) {
            found = plan.warnings.text[k];
        }
    }
    if (words == NULL) {
        assert_null(found);
    } else {
        assert_non_null(found);
        assert_non_null(strstr(found, words));
    }
    clod_plan_fini(&plan);
}

static const char *const SOLID[] = {ROLLING, "contacts.default.friction",
                                    "contacts.default.restitution"};

#define SIGMA_C NUMBER("sigma_c", "6 kPa", "1 kPa")
#define RHO_B NUMBER("rho_b", "1500 kg/m3", "30 kg/m3")

static void numbers_of_a_uniaxial_test(void **state)
{
    check(
        state, UNIAXIAL, SOLID, SIGMA_C AT("20 kPa"),
        "parameters: 3 are free, and the used targets are 1 independent number at most (points "
        "of one line count as two): probably 2 combinations of the parameters will stay "
        "unknown, whatever the budget. ");
    check(state, UNIAXIAL, SOLID, SIGMA_C AT("20 kPa") ", " RHO_B AT("20 kPa"),
          "are 2 independent numbers at most");
    check(state, UNIAXIAL, SOLID,
          SIGMA_C AT("20 kPa") ", " RHO_B AT("20 kPa") ", " RHO_B AT("54.8 kPa"), NULL);
    // ffc is sigma_1/sigma_c, and rho_inside hardly another density
    check(state, UNIAXIAL, SOLID,
          SIGMA_C AT("20 kPa") ", " NUMBER("ffc", "3.3", "1") AT("20 kPa") ", " RHO_B AT(
              "20 kPa") ", " NUMBER("rho_inside", "1550 kg/m3", "30 kg/m3") AT("20 kPa"),
          "are 2 independent numbers at most");
    check(state, UNIAXIAL, SOLID,
          SIGMA_C AT("20 kPa") ", " RHO_B AT("20 kPa") ", " NUMBER(
              "rho_b", "1550 kg/m3", "30 kg/m3") ", normal_stress: 54.8 kPa" HELD_BACK,
          "are 2 independent numbers at most");
}

// They lie on no line by definition: three of either tell as much as three numbers.
static void strengths_and_densities_at_three_stresses(void **state)
{
#define THREE(number) number AT("20 kPa") ", " number AT("54.8 kPa") ", " number AT("90 kPa")
#define STRESSES UNIAXIAL ", set: {uniaxial.consolidation_stresses: [20 kPa, 54.8 kPa, 90 kPa]}"
    check(state, STRESSES, SOLID, THREE(SIGMA_C), NULL);
    check(state, STRESSES, SOLID, THREE(RHO_B), NULL);
    check(state, STRESSES, SOLID, SIGMA_C AT("20 kPa") ", " SIGMA_C AT("90 kPa"),
          "are 2 independent numbers at most");
}

// Of a line that no other number of the test goes with: four points are a level and a slope.
static void numbers_of_a_shear_test(void **state)
{
    lab_write_file(
        state, "lab.csv",
        "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n54.8,46,28,30.6\n"
        "54.8,46,32,33.4\n54.8,46,36,36.2\n54.8,46,40,39\n");
#define POINTS "{test: lab, locus: lab.csv, error: 1 kPa}"
#define RHO NUMBER("rho_b", "1700 kg/m3", "30 kg/m3") "}"
    check(state, RING, SOLID, POINTS, "are 2 independent numbers at most");
    check(state, RING, SOLID, POINTS ", " NUMBER("c", "11 kPa", "1 kPa") "}",
          "are 2 independent numbers at most");
    check(state, RING, SOLID, POINTS ", " NUMBER("tau_p", "46 kPa", "1 kPa") "}", NULL);
    check(state, RING, SOLID, POINTS ", " RHO, NULL);
    check(state, RING, SOLID, NUMBER("phi_e", "45 deg", "1 deg") "}, " RHO,
          "are 2 independent numbers at most");
}

static void numbers_at_a_wall(void **state)
{
    static const char *const KEYS[] = {"contacts.ore-plate.friction",
                                       "contacts.ore-plate.restitution", ROLLING};
#define PHI_X(value) NUMBER("phi_x", value, "1 deg")
    check(state, WALL, KEYS,
          PHI_X("20 deg") AT("5 kPa") ", " PHI_X("20.1 deg") AT("10 kPa") ", " PHI_X("20.2 deg")
              AT("20 kPa"),
          "are 2 independent numbers at most");
}

static void numbers_of_a_free_run(void **state)
{
    static const char *const KEYS[] = {ROLLING, "contacts.default.friction",
                                       "contacts.default.restitution"};
#define HEIGHT NUMBER("repose.heap.height_m", "40 mm", "2 mm") "}"
    check(state, PILE, KEYS, HEIGHT ", " NUMBER("repose.heap.angle_deg", "30", "2") "}",
          "are 2 independent numbers at most");
    check(state, PILE, KEYS,
          HEIGHT ", " NUMBER("repose.heap.angle_deg", "30",
                             "2") "}, " NUMBER("kinetic_energy_J", "1e-3", "1e-4") "}",
          NULL);
    check(state, PILE, KEYS, HEIGHT ", " HEIGHT, "are 1 independent number at most");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(numbers_of_a_uniaxial_test, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(strengths_and_densities_at_three_stresses,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(numbers_of_a_shear_test, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(numbers_at_a_wall, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(numbers_of_a_free_run, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
