/**
 * @file test_plan_doubts.c
 * Targets that are possible and hardly meant are warned of, and those that errors allow are not: by hand.
 */

#include "plan_lab.h"

#include <stdlib.h>

#include "base/input.h"
#include "base/memory.h"

/** ring.yaml with 54.8 kPa of preshear, and of the grain material ore, in a file. */
static void write_case(void **state, const char *name, const char *preshear,
                       const char *material)
{
    char *text;
    size_t length;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_input_read(CLOD_SOURCE_DIR "/" RING, SIZE_MAX, &text, &length, &status));
    char *made = malloc(length + 256);
    assert_non_null(made);
    size_t used = 0;
    static const char *const OLD[] = {"54.8", "ore: {", "ore-side", "ore-base",
                                      "grain_material: ore"};
    char words[5][64];
    snprintf(words[0], sizeof words[0], "%s", preshear);
    snprintf(words[1], sizeof words[1], "%s: {", material);
    snprintf(words[2], sizeof words[2], "%s-side", material);
    snprintf(words[3], sizeof words[3], "%s-base", material);
    snprintf(words[4], sizeof words[4], "grain_material: %s", material);
    for (size_t at = 0; at < length;) {
        size_t step = 1;
        const char *by = NULL;
        for (size_t k = 0; k < 5 && by == NULL; k++) {
            if (strncmp(text + at, OLD[k], strlen(OLD[k])) == 0) {
                by = words[k];
                step = strlen(OLD[k]);
            }
        }
        if (by == NULL) {
            made[used++] = text[at];
        } else {
            memcpy(made + used, by, strlen(by));
            used += strlen(by);
        }
        at += step;
    }
    made[used] = '\0';
    lab_write_file(state, name, made);
    free(made);
    clod_memory_free(text);
}

/** A plan of the tests small, 54.8 kPa, and large, 80 kPa, with targets. */
static void load_two(void **state, const char *targets, clod_plan *plan)
{
    char text[2048], path[PATH_MAX];
    clod_status status = {CLOD_OK, ""};
    snprintf(text, sizeof text,
             "points: 5\ntests: {small: {case: small.yaml}, large: {case: large.yaml}}\n"
             "parameters: {p: {key: " ROLLING ", from: 0.1, to: 0.2}}\ntargets: [{test: %s}]\n",
             targets);
    lab_write_file(state, "plan.yaml", text);
    if (!clod_plan_load(temp_path(path, state, "plan.yaml"), NULL, 0, plan, &status)) {
        fail_msg("%s", status.text);
    }
}

static void check_warnings(clod_plan *plan, size_t count, const char *words)
{
    if (plan->warnings.count != count) {
        fail_msg("%zu warnings: %s", plan->warnings.count, plan->warnings.text[0]);
    }
    bool found = count == 0;
    for (size_t k = 0; k < count; k++) {
        found = found || strstr(plan->warnings.text[k], words) != NULL;
    }
    if (!found) {
        fail_msg("%s: not in: %s", words, plan->warnings.text[0]);
    }
    clod_plan_fini(plan);
}

#define TWO(number, small, large, error)                                                       \
    "small, number: " number ", value: " small ", error: " error                               \
    "}, {test: large, number: " number ", value: " large ", error: " error ", held_back: true"

// 2 sqrt(3^2 + 3^2) = 8.49 kPa may be chance; 8.6 kPa are 2.03 standard errors.
static void solid_that_gets_weaker_by_consolidation(void **state)
{
    clod_plan plan;
    write_case(state, "small.yaml", "54.8", "ore");
    write_case(state, "large.yaml", "80", "ore");
    load_two(state, TWO("sigma_c", "30 kPa", "21.6 kPa", "3 kPa"), &plan);
    check_warnings(&plan, 0, "");
    load_two(state, TWO("sigma_c", "30 kPa", "50 kPa", "3 kPa"), &plan);
    check_warnings(&plan, 0, "");
    load_two(state, TWO("sigma_c", "30 kPa", "21.4 kPa", "3 kPa"), &plan);
    check_warnings(
        &plan, 1,
        "sigma_c falls from 30 kPa at 54.8 kPa of consolidation (test small, targets.0) to "
        "21.4 kPa at 80 kPa (test large, targets.1), by 2.0 standard errors");
}

static void other_numbers_that_consolidation_raises(void **state)
{
    clod_plan plan;
    write_case(state, "small.yaml", "54.8", "ore");
    write_case(state, "large.yaml", "80", "ore");
    load_two(state, TWO("tau_p", "40 kPa", "30 kPa", "1 kPa"), &plan);
    check_warnings(&plan, 1, "tau_p falls from 40 kPa");
    load_two(state, TWO("sigma_1", "120 kPa", "90 kPa", "1 kPa"), &plan);
    check_warnings(&plan, 1, "sigma_1 falls from 120 kPa");
    load_two(state, TWO("rho_b", "1700 kg/m3", "1600 kg/m3", "20 kg/m3"), &plan);
    check_warnings(&plan, 1, "rho_b falls from 1700 kg/m3");
    load_two(state, TWO("phi_e", "50 deg", "40 deg", "1 deg"), &plan); // as of most solids
    check_warnings(&plan, 0, "");
}

// 54.8 tan 50 = 65.31 +- 2.31 kPa: 80 tan 38 = 62.50 +- 2.25 kPa is below it by 0.9 errors, 80 tan 35 = 56.02 +- 2.08 by 3.0.
static void angles_whose_shear_stresses_fall(void **state)
{
    clod_plan plan;
    write_case(state, "small.yaml", "54.8", "ore");
    write_case(state, "large.yaml", "80", "ore");
    load_two(state, TWO("phi_e", "50 deg", "38 deg", "1 deg"), &plan);
    check_warnings(&plan, 0, "");
    load_two(state, TWO("phi_e", "50 deg", "35 deg", "1 deg"), &plan);
    check_warnings(
        &plan, 1,
        "phi_e falls from 50.0 deg at 54.8 kPa of consolidation (test small, targets.0) to 35.0 deg at 80 kPa (test large, "
        "targets.1), so fast that stress times tan(phi_e) falls as well, by 3.0 standard errors");
    load_two(state, TWO("phi_sf", "50 deg", "35 deg", "1 deg"), &plan);
    check_warnings(&plan, 1, "phi_sf falls from 50.0 deg at 54.8 kPa");
}

// Neither another stress nor another solid says anything of the first.
static void tests_that_cannot_be_compared(void **state)
{
    clod_plan plan;
    write_case(state, "small.yaml", "54.8", "ore");
    write_case(state, "large.yaml", "80", "coke");
    load_two(state, TWO("sigma_c", "30 kPa", "10 kPa", "1 kPa"), &plan);
    check_warnings(&plan, 0, "");
    write_case(state, "large.yaml", "55.2", "ore"); // the same stress, within 2 %
    load_two(state, TWO("sigma_c", "30 kPa", "10 kPa", "1 kPa"), &plan);
    check_warnings(&plan, 0, "");
}

// tau = 10 kPa + 0.5 sigma at the stress of 54.8 kPa: sigma_c = 2 10 (0.5 + sqrt(1.25)) = 32.36 kPa,
// since 2 cos/(1 - sin) = 2 (tan + sqrt(1 + tan^2)). At 80 kPa the laboratory has 12 +- 1 kPa.
static void strength_of_a_table_beside_that_of_another_test(void **state)
{
    clod_plan plan;
    write_case(state, "small.yaml", "54.8", "ore");
    write_case(state, "large.yaml", "80", "ore");
    lab_write_file(state, "lab.csv",
                   "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
                   "54.8,37,10.96,15.48\n54.8,37,27.4,23.7\n54.8,37,43.84,31.92\n");
    load_two(
        state,
        "small, locus: lab.csv, error: 0.1 kPa}, {test: large, number: sigma_c, value: 12 kPa, "
        "error: 1 kPa",
        &plan);
    check_warnings(&plan, 1,
                   "sigma_c falls from 32.36 kPa at 54.8 kPa of consolidation (test small, "
                   "targets.0) to 12 kPa at 80 kPa (test large, targets.1)");
}

static void uniaxial_strength_that_falls(void **state)
{
    clod_plan plan;
    lab_load_good(
        state, UNIAXIAL,
        "number: sigma_c, value: 18 kPa, error: 1 kPa, normal_stress: 20 kPa}, "
        "{test: lab, number: sigma_c, value: 11 kPa, error: 1 kPa, normal_stress: 54.8 kPa",
        &plan);
    check_warnings(&plan, 1,
                   "sigma_c falls from 18 kPa at 20 kPa of consolidation (test lab, targets.0) "
                   "to 11 kPa at 54.8 kPa (test lab, targets.1), by 4.9 standard errors");
}

static void error_above_its_value(void **state)
{
    clod_plan plan;
    lab_load_good(state, RING,
                  "number: tau, normal_stress: 27.4 kPa, value: 0.5 kPa, error: 5 kPa", &plan);
    check_warnings(
        &plan, 1,
        "targets.0: the error of lab: tau at 27.4 kPa, 5 kPa, is larger than its value, 0.5 kPa");
    lab_load_good(state, RING,
                  "number: tau, normal_stress: 27.4 kPa, value: 5 kPa, error: 5 kPa", &plan);
    check_warnings(&plan, 0, "");
    lab_load_good(state, RING, "number: c, value: 0 kPa, error: 0.1 kPa", &plan);
    check_warnings(&plan, 0, "");
}

// One warning of a table, not one of each point.
static void error_above_the_values_of_a_table(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n20,1500\n54.8,1600\n");
    lab_load_good(state, UNIAXIAL, "locus: lab.csv, error: 2 g/cm3", &plan);
    check_warnings(
        &plan, 1,
        "targets.0: the error of lab: rho_b at 20 kPa, 2000 kg/m3, is larger than its value, 1500 kg/m3");
    lab_write_file(
        state, "lab.csv",
        "sigma_1 [kPa],rho_b [kg/m3],rho_b_error [kg/m3]\n20,1500,10\n20,1500,10\n54.8,1600,2000\n");
    lab_load_good(state, UNIAXIAL, "locus: lab.csv, error: 10 kg/m3", &plan);
    check_warnings(
        &plan, 1,
        "targets.0: the error of lab: rho_b at 54.8 kPa, 2000 kg/m3, is larger than its value, 1600 kg/m3");
}

// Two of hypot(15, 20) = 25 kg/m3 are 50 kg/m3.
static void density_that_is_smaller_away_from_the_walls(void **state)
{
#define DENSITIES(inside, more)                                                                \
    "number: rho_b, value: 1300 kg/m3, error: 15 kg/m3" more                                   \
    "}, {test: lab, number: rho_inside, value: " inside                                        \
    " kg/m3, error: 20 kg/m3, held_back: true"
    clod_plan plan;
    lab_load_good(state, RING, DENSITIES("1500", ""), &plan);
    check_warnings(&plan, 0, "");
    lab_load_good(state, RING, DENSITIES("1251", ""), &plan);
    check_warnings(&plan, 0, "");
    lab_load_good(state, RING, DENSITIES("1240", ""), &plan);
    check_warnings(
        &plan, 1,
        "test lab: rho_inside 1240 kg/m3 in targets.1 is below rho_b 1300 kg/m3 in targets.0, by 2.4 standard "
        "errors: grains leave gaps at the walls of a cell");
    lab_load_good(state, UNIAXIAL,
                  DENSITIES("1000", ", normal_stress: 54.8 kPa") ", normal_stress: 54.8 kPa",
                  &plan);
    check_warnings(&plan, 1, "rho_inside 1000 kg/m3 in targets.1 is below rho_b 1300 kg/m3");
    lab_load_good(state, UNIAXIAL,
                  DENSITIES("1000", ", normal_stress: 54.8 kPa") ", normal_stress: 20 kPa",
                  &plan);
    check_warnings(&plan, 0, "");
}

// A tenth of 30 kPa is 3 kPa, more than two of hypot(1, 1) kPa and less than two of hypot(2, 1) = 2.236 kPa. atan(30/54.8) is
// 28.698 deg, and 1 deg of it 1.243 kPa: two of hypot(1, 1.243) kPa are 3.19 kPa.
static void peak_above_preshear(void **state)
{
#define PEAK(value, error, preshear)                                                           \
    "number: tau, normal_stress: 27.4 kPa, value: " value " kPa, error: " error " kPa"         \
    "}, {test: lab, " preshear
#define TAU_P "number: tau_p, value: 30 kPa, error: 1 kPa"
    clod_plan plan;
    lab_load_good(state, RING, PEAK("32.9", "1", TAU_P), &plan);
    check_warnings(&plan, 0, "");
    lab_load_good(state, RING, PEAK("33.1", "1", TAU_P), &plan);
    check_warnings(
        &plan, 1,
        "targets.0: lab: tau at 27.4 kPa, 33.1 kPa, is above the shear stress of preshear, 30 kPa (tau_p in targets.1)");
    lab_load_good(state, RING, PEAK("34.4", "2", TAU_P), &plan);
    check_warnings(&plan, 0, "");
    lab_load_good(state, RING, PEAK("34.6", "2", TAU_P), &plan);
    check_warnings(&plan, 1, "is above the shear stress of preshear");
    lab_load_good(
        state, RING,
        PEAK("33.3", "1", "number: phi_sf, value: 28.698 deg, error: 1 deg, held_back: true"),
        &plan);
    check_warnings(&plan, 1, "30 kPa (phi_sf in targets.1)");
    lab_write_file(state, "lab.csv",
                   "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"
                   "54.8,30,10.96,12.7,1500\n54.8,30,20,16.7,1501\n54.8,30,43.84,27.3,1502\n");
    lab_load_good(state, RING, PEAK("33.1", "1", "locus: lab.csv, error: 1 kPa"), &plan);
    check_warnings(&plan, 1, "30 kPa (tau_p in targets.1)");
}

static void a_target_that_is_there_twice(void **state)
{
#define AGAIN(more) "number: phi_lin, value: 30 deg, error: 1 deg}, {test: lab, " more
    clod_plan plan;
    lab_load_good(state, RING, AGAIN("number: phi_lin, value: 30 deg, error: 1 deg"), &plan);
    check_warnings(
        &plan, 1,
        "targets.1: lab: phi_lin (targets.1) has the value and the error of targets.0 to the last digit, and counts as a "
        "second measurement");
    lab_load_good(state, RING, AGAIN("number: phi_lin, value: 30.1 deg, error: 1 deg"), &plan);
    check_warnings(&plan, 0, "");
    lab_load_good(state, RING, AGAIN("number: phi_lin, value: 30 deg, error: 1.1 deg"), &plan);
    check_warnings(&plan, 0, "");
    lab_load_good(state, RING, AGAIN("number: phi_sf, value: 30 deg, error: 1 deg"), &plan);
    check_warnings(&plan, 0, "");
    lab_load_good(state, RING,
                  AGAIN("number: phi_lin, value: 30 deg, error: 1 deg, held_back: true"),
                  &plan);
    check_warnings(&plan, 0, "");
    static const char *const TABLE = "sigma_1 [kPa],rho_b [kg/m3]\n20,1500\n54.8,1600\n";
    lab_write_file(state, "lab.csv", TABLE);
    lab_write_file(state, "copy.csv", TABLE);
    lab_load_good(
        state, UNIAXIAL,
        "locus: lab.csv, error: 9 kg/m3}, {test: lab, locus: copy.csv, error: 9 kg/m3", &plan);
    check_warnings(&plan, 1, "targets.1: lab: rho_b at 20 kPa (targets.1) has the value");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(solid_that_gets_weaker_by_consolidation),
        TEST(other_numbers_that_consolidation_raises),
        TEST(angles_whose_shear_stresses_fall),
        TEST(tests_that_cannot_be_compared),
        TEST(strength_of_a_table_beside_that_of_another_test),
        TEST(uniaxial_strength_that_falls),
        TEST(error_above_its_value),
        TEST(error_above_the_values_of_a_table),
        TEST(density_that_is_smaller_away_from_the_walls),
        TEST(peak_above_preshear),
        TEST(a_target_that_is_there_twice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
