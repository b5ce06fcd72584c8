/**
 * @file test_plan_curves.c
 * Bulk densities and flow functions of a plan become targets, and numbers of runs go to their stress:
 * all expected values by hand.
 */

#include "calibrate/number.h"
#include "plan_lab.h"

#define DENSITY_HEAD "sigma_1 [kPa],sigma_1_error [kPa],rho_b [kg/m3],rho_b_error [kg/m3]\n"
#define FLOW_HEAD "sigma_1 [kPa],sigma_c [kPa],sigma_c_error [kPa]\n"
#define FLOW FLOW_HEAD "110,22,1.1\n30,10,0.5\n60,16,0.8\n"
#define SHEAR_HEAD                                                                             \
    "seed,sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"

// 50 kg/m3 over 34.8 kPa: an error of 3 kPa is one of 4.31 kg/m3, beside 8 of the plan or 9 that are stated.
static void densities_of_a_uniaxial_test_are_targets(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", DENSITY_HEAD "54.8,3,1250,9\n20,0,1200,5\n");
    lab_load_good(state, UNIAXIAL, "locus: lab.csv, error: 8 kg/m3, discrepancy: 14 kg/m3",
                  &plan);
    assert_int_equal(plan.target_count, 2);
    lab_check_target(&plan.targets[0], "lab: rho_b at 20 kPa", 20e3, 1200.0, 8.0);
    lab_check_target(&plan.targets[1], "lab: rho_b at 54.8 kPa", 54.8e3, 1250.0,
                     hypot(9.0, 50.0 / 34.8 * 3.0));
    assert_true(fabs(plan.targets[1].discrepancy - 14.0) < 1e-9);
    clod_plan_fini(&plan);
}

static void flow_function_of_a_uniaxial_test_is_targets(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv",
                   "sigma_1 [kPa],f_c [kPa],f_c_error [kPa],rho_b [kg/m3],rho_b_error [kg/m3]\n"
                   "20,6,0.4,1200,9\n54.8,13,0.7,1250,10\n");
    lab_load_good(
        state, UNIAXIAL,
        "locus: lab.csv}, {test: lab, locus: lab.csv, number: rho_b, normal_stress: 54.8 kPa}, "
        "{test: lab, locus: lab.csv, number: rho_inside",
        &plan);
    assert_int_equal(plan.target_count, 5);
    lab_check_target(&plan.targets[3], "lab: rho_inside at 20 kPa", 20e3, 1200.0, 9.0);
    lab_check_target(&plan.targets[4], "lab: rho_inside at 54.8 kPa", 54.8e3, 1250.0, 10.0);
    lab_check_target(&plan.targets[0], "lab: sigma_c at 20 kPa", 20e3, 6e3, 0.4e3);
    lab_check_target(&plan.targets[1], "lab: sigma_c at 54.8 kPa", 54.8e3, 13e3, 0.7e3);
    lab_check_target(&plan.targets[2], "lab: rho_b at 54.8 kPa", 54.8e3, 1250.0, 10.0);
    clod_plan_fini(&plan);
}

// Between 60 and 110 kPa, and beyond, the strength grows by 0.12 kPa a kPa.
static void run_goes_along_the_table_to_the_row_of_the_plan(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", FLOW);
    lab_load_good(state, RING, "locus: lab.csv, normal_stress: 110 kPa", &plan);
    assert_int_equal(plan.target_count, 1);
    const clod_plan_target *target = &plan.targets[0];
    lab_check_target(target, "lab: sigma_c at 110 kPa", 110e3, 22e3, 1.1e3);
    assert_true(fabs(clod_number_moved(target, 18e3, 110e3) - 18e3) < 1e-6);
    assert_true(fabs(clod_number_moved(target, 18e3, 90e3) - 20.4e3) < 1e-6);
    assert_true(fabs(clod_number_moved(target, 18e3, 130e3) - 15.6e3) < 1e-6);
    assert_true(fabs(clod_number_moved(target, 18e3, 30e3) - 30e3) < 1e-6);
    assert_true(isnan(clod_number_moved(target, 18e3, (double)NAN)));
    clod_plan_fini(&plan);
}

static void single_row_has_no_slope(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", FLOW_HEAD "110,22,1.1\n");
    lab_load_good(state, RING, "locus: lab.csv", &plan);
    lab_check_target(&plan.targets[0], "lab: sigma_c at 110 kPa", 110e3, 22e3, 1.1e3);
    assert_true(clod_number_moved(&plan.targets[0], 18e3, 55e3) == 18e3);
    clod_plan_fini(&plan);
}

// Two specimens of one consolidation: the curve goes through their mean, 16 kPa at 60 kPa, with 6/50 beyond.
static void scatter_of_specimens_is_no_slope(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", FLOW_HEAD "58,15,0.8\n62,17,0.8\n110,22,1.1\n");
    lab_load_good(state, RING, "locus: lab.csv, normal_stress: 62 kPa", &plan);
    lab_check_target(&plan.targets[0], "lab: sigma_c at 62 kPa", 62e3, 17e3, 0.8e3);
    assert_true(fabs(clod_number_moved(&plan.targets[0], 10e3, 52e3) - 11.2e3) < 1e-6);
    clod_plan_fini(&plan);
}

// Two rows within 2 %, moved by as much to and fro: the mean is that of the values, with 0.8 kPa/sqrt(2),
// more than what they scatter about the slope, 0.6 kPa 0.14/2.
static void repeats_of_a_row_are_one_target(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", FLOW_HEAD "59.85,15,0.8\n60.45,15,0.8\n110,22,1.1\n");
    lab_load_good(state, RING, "locus: lab.csv, normal_stress: 60 kPa", &plan);
    assert_int_equal(plan.target_count, 1);
    lab_check_target(&plan.targets[0], "lab: sigma_c at 60.15 kPa", 60.15e3, 15e3,
                     0.8e3 / sqrt(2.0));
    clod_plan_fini(&plan);
}

// Mean 1320; squares 400 + 100 + 900, so sqrt(700)/sqrt(3). Points of other preshears are not asked.
static void density_of_shear_points_is_a_target(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv",
                   SHEAR_HEAD "1,54.8,40,12,20,1300\n1,54.8,40,30,30,1300\n"
                              "2,54.8,40,12,20,1310\n2,54.8,40,30,30,1310\n"
                              "3,54.8,40,12,20,1350\n3,54.8,40,30,30,1350\n"
                              "1,20,15,6,8,1100\n1,20,15,12,12,1100\n");
    lab_load_good(state, RING, "locus: lab.csv, number: rho_b, discrepancy: 14 kg/m3", &plan);
    assert_int_equal(plan.target_count, 1);
    const clod_plan_target *target = &plan.targets[0];
    assert_string_equal(target->name, "lab: rho_b");
    assert_true(fabs(target->value - 1320.0) < 1e-9);
    assert_true(fabs(target->error - sqrt(700.0 / 3.0)) < 1e-9);
    assert_true(target->curve == NULL && target->normal_stress == 0.0);
    clod_plan_fini(&plan);

    // the same of the laboratory, beside another of the simulation
    lab_load_good(state, RING, "locus: lab.csv, number: rho_inside, discrepancy: 14 kg/m3",
                  &plan);
    assert_int_equal(plan.target_count, 1);
    assert_string_equal(plan.targets[0].name, "lab: rho_inside");
    assert_string_equal(plan.targets[0].number, "rho_inside");
    assert_true(fabs(plan.targets[0].value - 1320.0) < 1e-9);
    assert_true(fabs(plan.targets[0].error - sqrt(700.0 / 3.0)) < 1e-9);
    clod_plan_fini(&plan);
}

// A dense specimen may be a strong one: points and density of one table are specimens of one another, and of another
// file, or held back, they are not. Densities 1300, 1310, 1350 about 1320.
static void density_and_points_of_one_table_are_of_the_same_specimens(void **state)
{
    static const char ROWS[] = SHEAR_HEAD "1,54.8,40,12,20,1300\n1,54.8,40,30,30,1300\n"
                                          "2,54.8,40,12,21,1310\n2,54.8,40,30,31,1310\n"
                                          "3,54.8,40,12,22,1350\n3,54.8,40,30,33,\n";
    lab_write_file(state, "lab.csv", ROWS);
    lab_write_file(state, "other.csv", ROWS);
    clod_plan plan;
    lab_load_good(
        state, RING,
        "locus: lab.csv, error: 1 kPa}, {test: lab, locus: lab.csv, number: rho_b, error: 9 "
        "kg/m3}, {test: lab, locus: other.csv, number: rho_b, error: 9 kg/m3",
        &plan);
    assert_int_equal(plan.target_count, 4);
    const clod_plan_target *density = &plan.targets[2];
    assert_string_equal(density->number, "rho_b");
    assert_true(plan.targets[0].table > 0 && plan.targets[1].table == plan.targets[0].table);
    assert_int_equal(density->table, plan.targets[0].table);
    assert_int_not_equal(plan.targets[3].table, plan.targets[0].table);
    assert_int_equal(density->repeats.count, 3);
    for (size_t k = 0; k < 3; k++) {
        static const double DIFFERENCES[] = {-20.0, -10.0, 30.0};
        assert_int_equal(density->repeats.differences[k].specimen, k + 1);
        assert_int_equal(plan.targets[0].repeats.differences[k].specimen, k + 1);
        assert_true(fabs(density->repeats.differences[k].value - DIFFERENCES[k]) < 1e-9);
    }
    clod_plan_fini(&plan);
    lab_load_good(state, RING,
                  "locus: lab.csv, error: 1 kPa}, {test: lab, locus: lab.csv, number: rho_b, "
                  "error: 9 kg/m3, held_back: true",
                  &plan);
    assert_int_equal(plan.target_count, 3);
    assert_int_equal(plan.targets[1].table, plan.targets[0].table);
    assert_int_not_equal(plan.targets[2].table, plan.targets[0].table);
    clod_plan_fini(&plan);
}

// Without rho_b_error each specimen has the plan's error e: of the mean of two e/sqrt(2), or what they scatter by,
// 1/2 of their difference, whichever is larger.
static void density_has_the_error_of_the_plan(void **state)
{
    const char *const rows = SHEAR_HEAD "1,54.8,40,12,20,1300\n1,54.8,40,30,30,1300\n"
                                        "2,54.8,40,12,20,%d\n2,54.8,40,30,30,%d\n";
    const struct {
        int second;
        const char *error;
        double wanted;
    } CASES[] = {{1300, "9", 9.0}, {1301, "100", 100.0}, {1340, "9", 20.0 * sqrt(2.0)}};
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        char text[400], target[80];
        snprintf(text, sizeof text, rows, CASES[k].second, CASES[k].second);
        snprintf(target, sizeof target, "locus: lab.csv, number: rho_b, error: %s kg/m3",
                 CASES[k].error);
        lab_write_file(state, "lab.csv", text);
        clod_plan plan;
        lab_load_good(state, RING, target, &plan);
        assert_true(fabs(plan.targets[0].error - CASES[k].wanted / sqrt(2.0)) < 1e-9);
        clod_plan_fini(&plan);
    }
}

// Of 45 rows the message names the first ones, whole, and that there are more.
static void a_long_table_is_listed_in_part(void **state)
{
    char text[2048];
    size_t used = (size_t)snprintf(text, sizeof text, "%s", FLOW_HEAD);
    for (int k = 0; k < 45; k++) {
        used += (size_t)snprintf(text + used, sizeof text - used, "%.2f,15,0.8\n",
                                 100.0 * pow(1.05, k));
    }
    lab_write_file(state, "lab.csv", text);
    lab_refuse(
        state, RING, "locus: lab.csv",
        "needs the key normal_stress, the sigma_1 of the row that belongs to the preshear "
        "stress of test lab; the table has 100, 105, 110.25, ");
    lab_refuse(state, RING, "locus: lab.csv", " more kPa");
}

// ---- numbers of runs

// tau = 10 kPa + sigma/2, so the sine of phi is 1/sqrt(5) and the cosine 2/sqrt(5). The steady circle touches
// it at preshear: centre 54.8 + 37.4/2, radius 37.4 sqrt(5)/2. sigma_c = 2 c cos/(1 - sin). Beyond 60 kPa the
// table has 0.12 kPa a kPa.
static void shear_test_is_read_at_the_stress_of_the_table(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    char folder[PATH_MAX];
    lab_write_file(state, "lab.csv", FLOW);
    lab_write_file(
        state, "points.csv",
        "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3],rho_inside [kg/m3]\n"
        "54.8,37.4,12,16,1200,1380\n54.8,37.4,30,25,1200,1380\n");
    lab_load_good(
        state, RING,
        "number: sigma_1, value: 90 kPa, error: 1 kPa}, "
        "{test: lab, number: sigma_c, value: 20 kPa, error: 5 kPa}, "
        "{test: lab, number: tau, normal_stress: 20 kPa, value: 20 kPa, error: 5 kPa}, "
        "{test: lab, number: rho_inside, value: 1400 kg/m3, error: 20 kg/m3}, "
        "{test: lab, locus: lab.csv, normal_stress: 110 kPa",
        &plan);
    double values[5];
    temp_path(folder, state, "");
    assert_true(clod_number_read(&plan, 0, folder, values, NULL, &status));
    const double sigma_1 = 73.5e3 + 37.4e3 * sqrt(5.0) / 2.0;
    const double sigma_c = 40e3 / (sqrt(5.0) - 1.0);
    assert_true(fabs(values[0] / sigma_1 - 1.0) < 1e-9);
    assert_true(fabs(values[1] / sigma_c - 1.0) < 1e-9);
    assert_true(fabs(values[2] / 20e3 - 1.0) < 1e-9);
    assert_true(fabs(values[3] / 1380.0 - 1.0) < 1e-9);
    assert_true(fabs(values[4] / (sigma_c + 0.12 * (110e3 - sigma_1)) - 1.0) < 1e-9);
    clod_plan_fini(&plan);
}

// Lid at 54.8 kPa, of which 50 kPa reached it: 0.2 kPa a kPa and 50/34.8 kg/m3 a kPa are missing.
static void uniaxial_test_is_read_at_the_stress_of_the_table(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    char folder[PATH_MAX];
    lab_write_file(state, "lab.csv",
                   "sigma_1 [kPa],sigma_c [kPa],rho_b [kg/m3]\n20,6,1200\n54.8,12.96,1250\n");
    lab_write_file(
        state, "summary.json",
        "{\"flow_function\": [{\"consolidation_stress_Pa\": 20000, \"sigma_1_Pa\": 20000, "
        "\"sigma_c_Pa\": 5000, \"bulk_density_kg_m3\": 1100}, "
        "{\"consolidation_stress_Pa\": 54800, \"sigma_1_Pa\": 50000, "
        "\"sigma_c_Pa\": 11000, \"bulk_density_kg_m3\": 1210, \"inside_density_kg_m3\": 1300}]}");
    lab_load_good(
        state, UNIAXIAL,
        "locus: lab.csv, error: 1 kPa}, "
        "{test: lab, locus: lab.csv, number: rho_b, error: 9 kg/m3}, "
        "{test: lab, number: sigma_c, normal_stress: 54.8 kPa, value: 12 kPa, error: 1 kPa}, "
        "{test: lab, number: rho_inside, normal_stress: 54.8 kPa, value: 1320 kg/m3, error: 9 kg/m3",
        &plan);
    static const double EXPECTED[] = {
        5000.0, 11000.0 + 0.2 * 4800.0, 1100.0, 1210.0 + 50.0 / 34.8 * 4.8, 11000.0, 1300.0};
    double values[6];
    temp_path(folder, state, "");
    assert_int_equal(plan.target_count, 6);
    assert_true(clod_number_read(&plan, 0, folder, values, NULL, &status));
    for (size_t t = 0; t < 6; t++) {
        assert_true(fabs(values[t] / EXPECTED[t] - 1.0) < 1e-9);
    }
    clod_plan_fini(&plan);
}

// ---- what is refused

static void rows_that_a_shear_test_cannot_choose_are_refused(void **state)
{
    lab_write_file(state, "lab.csv", FLOW);
    lab_refuse(
        state, RING, "locus: lab.csv",
        "targets.0: needs the key normal_stress, the sigma_1 of the row that belongs to the preshear stress of "
        "test lab; the table has 30, 60, 110 kPa");
    lab_refuse(
        state, RING, "locus: lab.csv, normal_stress: 90 kPa",
        "targets.0.normal_stress: 90 kPa: the table has no such sigma_1; it has 30, 60, 110 kPa");
    lab_refuse(state, RING,
               "locus: lab.csv, number: rho_b, error: 9 kg/m3, normal_stress: 60 kPa",
               "targets.0.number: rho_b: the table has no column with values of it");
    lab_refuse(
        state, RING, "locus: lab.csv, number: phi_e, error: 1 deg, normal_stress: 60 kPa",
        "phi_e is none of a flow function (sigma_1, sigma_c); of such a table it is sigma_c or rho_b");
    lab_refuse(state, UNIAXIAL, "locus: lab.csv",
               "targets.0.locus: 30 kPa is not among the consolidation_stresses of test lab");
}

// Presheared at 54.8 kPa, so sigma_1 is above that, and up to 6 54.8 = 328.8 kPa: MPa for kPa, Pa for kPa.
static void table_of_another_consolidation_is_refused(void **state)
{
    lab_write_file(state, "lab.csv", FLOW_HEAD "10,5,0.3\n50,15,0.8\n");
    lab_refuse(
        state, RING, "locus: lab.csv, normal_stress: 50 kPa",
        "targets.0.locus: ends at sigma_1 of 50 kPa, and test lab is presheared at 54.8 kPa: its own "
        "sigma_1 is above that. Is the unit right?");
    lab_write_file(state, "lab.csv", FLOW_HEAD "330,100,5\n600,150,8\n");
    lab_refuse(
        state, RING, "locus: lab.csv, normal_stress: 330 kPa",
        "targets.0.locus: begins at sigma_1 of 330 kPa, and test lab is presheared at 54.8 kPa: its own "
        "sigma_1 is a few times that, not more than six.");
    clod_plan plan;
    lab_write_file(state, "lab.csv", FLOW_HEAD "320,100,5\n600,150,8\n");
    lab_load_good(state, RING, "locus: lab.csv, normal_stress: 320 kPa", &plan);
    clod_plan_fini(&plan);
}

static void columns_that_are_wrong_are_told(void **state)
{
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rhob [kg/m3]\n20,1200\n54.8,1250\n");
    lab_refuse(
        state, UNIAXIAL, "locus: lab.csv",
        "there is no column \"rhob\"; did you mean rho_b? Known are sigma_1, sigma_c (or f_c),");
    lab_write_file(state, "lab.csv", "sigma1 [kPa],rho_b [kg/m3]\n20,1200\n54.8,1250\n");
    lab_refuse(
        state, RING, "locus: lab.csv",
        "targets.0.locus: has none of the columns sigma_sh, sigma_w, sigma_1 and angle_of_repose in its header, and "
        "of tables test lab takes shear points (sigma_sh, tau_sh), bulk densities (sigma_1, rho_b), a flow "
        "function (sigma_1, sigma_c)");
    lab_write_file(state, "lab.csv", SHEAR_HEAD "1,54.8,40,12,20,1300\n1,54.8,40,30,30,1300\n");
    lab_refuse(
        state, UNIAXIAL, "locus: lab.csv",
        "has sigma_sh or tau_sh in its header, as shear points (sigma_sh, tau_sh), and of tables test lab "
        "takes bulk densities");
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kPa]\n20,1200\n54.8,1250\n");
    lab_refuse(state, UNIAXIAL, "locus: lab.csv", "column rho_b [kPa]:");
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n20,1.2\n54.8,1.25\n");
    lab_refuse(state, UNIAXIAL, "locus: lab.csv", "rho_b: 1.2 kg/m3");
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n20,1200\n54.8,1250\n");
    lab_refuse(state, UNIAXIAL, "locus: lab.csv",
               "needs the key error: the table has no rho_b_error at 20 kPa");
    lab_refuse_of(
        state, "tests/cli/wall_friction.yaml", "contacts.ore-plate.friction", "locus: lab.csv",
        "targets.0.locus: has sigma_1 in its header, as bulk densities (sigma_1, rho_b), and of tables "
        "test lab takes a wall yield locus (sigma_w, tau_w)");
    lab_refuse_of(state, "tests/calibrate/bounce.yaml", "contacts.default.restitution",
                  "locus: lab.csv", "and of tables test lab takes angles of repose");
    lab_write_file(state, "lab.csv", SHEAR_HEAD "1,54.8,40,12,20,\n1,54.8,40,30,30,\n");
    lab_refuse(state, RING, "locus: lab.csv, number: rho_b, error: 9 kg/m3",
               "targets.0.locus: has no rho_b at the preshear stress of test lab");
    lab_write_file(state, "lab.csv", SHEAR_HEAD "1,54.8,40,12,20,1300\n1,54.8,40,30,30,1300\n");
    lab_refuse(state, RING, "locus: lab.csv, number: rho_b",
               "needs the key error: the table has no rho_b_error");
}

static bool warns(const clod_plan *plan, const char *words)
{
    bool found = false;
    for (size_t k = 0; k < plan->warnings.count; k++) {
        found = found || strstr(plan->warnings.text[k], words) != NULL;
    }
    return found;
}

static void densities_in_pounds_are_told(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n20,95\n54.8,105\n");
    lab_load_good(state, UNIAXIAL, "locus: lab.csv, error: 9 kg/m3", &plan);
    assert_true(warns(&plan, "lab.csv: rho_b is 95.0 kg/m3, as light as perlite"));
    clod_plan_fini(&plan);
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n20,101\n54.8,105\n");
    lab_load_good(state, UNIAXIAL, "locus: lab.csv, error: 9 kg/m3", &plan);
    assert_false(warns(&plan, "perlite"));
    clod_plan_fini(&plan);
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],sigma_c [Pa]\n20,95\n54.8,105\n");
    lab_load_good(state, UNIAXIAL, "locus: lab.csv, error: 9 Pa", &plan);
    assert_false(warns(&plan, "perlite"));
    clod_plan_fini(&plan);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(densities_of_a_uniaxial_test_are_targets),
        TEST(flow_function_of_a_uniaxial_test_is_targets),
        TEST(run_goes_along_the_table_to_the_row_of_the_plan),
        TEST(single_row_has_no_slope),
        TEST(scatter_of_specimens_is_no_slope),
        TEST(repeats_of_a_row_are_one_target),
        TEST(density_of_shear_points_is_a_target),
        TEST(density_and_points_of_one_table_are_of_the_same_specimens),
        TEST(density_has_the_error_of_the_plan),
        TEST(a_long_table_is_listed_in_part),
        TEST(shear_test_is_read_at_the_stress_of_the_table),
        TEST(uniaxial_test_is_read_at_the_stress_of_the_table),
        TEST(rows_that_a_shear_test_cannot_choose_are_refused),
        TEST(table_of_another_consolidation_is_refused),
        TEST(columns_that_are_wrong_are_told),
        TEST(densities_in_pounds_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
