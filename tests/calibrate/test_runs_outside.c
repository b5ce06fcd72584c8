/**
 * @file test_runs_outside.c
 * Runs that are consolidated beyond a measured table are told, with how far they are: sigma_1 by hand.
 */

#include "runs_made.h"

#define PACKINGS 2
#define FLOW_HEAD "sigma_1 [kPa],sigma_c [kPa],sigma_c_error [kPa]\n"
#define POINTS_HEAD "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"

// tau = 10 kPa + sigma/2 touches the steady circle at preshear: sigma_1 = 54.8 + 37.4/2 + 37.4 sqrt(5)/2
// = 115.3 kPa; at half the preshear stress, tau = 5 kPa + sigma/2 gives half of it, 57.66 kPa.
#define AT_115 POINTS_HEAD "54.8,37.4,12,16\n54.8,37.4,30,25\n"
#define AT_58 POINTS_HEAD "27.4,18.7,6,8\n27.4,18.7,15,12.5\n"

static void make(runs_made *self, void **state, const char *from, const char *table,
                 const char *target)
{
    lab_write_file(state, "lab.csv", table);
    runs_make(self, state, from, PACKINGS, target);
}

static void check(runs_made *self, const char *text)
{
    static clod_warning_list list;
    list.count = 0;
    clod_runs_warn_outside(&self->runs, &list);
    assert_int_equal(list.count, text != NULL ? 1 : 0);
    if (text != NULL) {
        assert_string_equal(list.text[0], text);
    }
    clod_plan_fini(&self->plan);
}

static void runs_beyond_a_table_are_told(void **state)
{
    runs_made all;
    make(&all, state, RING, FLOW_HEAD "200,30,1.5\n", "locus: lab.csv");
    runs_write(&all, 0, "/points.csv", AT_115);
    runs_write(&all, 1, "/points.csv", AT_58);
    check(
        &all,
        "2 runs of test lab had sigma_1 of 57.66 to 115.3 kPa, and the table of target lab: sigma_c at 200 kPa has 200 kPa: they are compared with its one row as if they were there. Add measured rows at such stresses, or consolidate the test at another one.");
}

static void runs_near_a_table_are_not_told(void **state)
{
    runs_made all; // 115.3 kPa is 4.8 % above the last row, and 57.66 kPa 3.9 % below the first
    make(&all, state, RING, FLOW_HEAD "60,16,0.8\n110,22,1.1\n",
         "locus: lab.csv, normal_stress: 60 kPa");
    runs_write(&all, 0, "/points.csv", AT_115);
    runs_write(&all, 1, "/points.csv", AT_58);
    check(&all, NULL);
}

static void failed_and_damaged_runs_are_not_looked_at(void **state)
{
    runs_made all;
    make(&all, state, RING, FLOW_HEAD "200,30,1.5\n", "locus: lab.csv");
    runs_write(&all, 0, "/points.csv", AT_115);
    runs_write(&all, 1, "/points.csv", "damaged\n");
    all.rows[0].state = CLOD_RUNS_FAILED;
    check(&all, NULL);
}

static void uniaxial_runs_below_a_table_are_told(void **state)
{
    runs_made all;
    make(&all, state, UNIAXIAL, FLOW_HEAD "20,6,0.4\n54.8,13,0.7\n", "locus: lab.csv");
    runs_write(&all, 0, "/summary.json",
               "{\"flow_function\": [{\"consolidation_stress_Pa\": 20000, \"sigma_1_Pa\": "
               "15000, \"sigma_c_Pa\": 5000}, {\"consolidation_stress_Pa\": 54800, "
               "\"sigma_1_Pa\": 54000, \"sigma_c_Pa\": 11000}]}");
    runs_write(&all, 1, "/summary.json",
               "{\"flow_function\": [{\"consolidation_stress_Pa\": 20000, \"sigma_1_Pa\": "
               "18500, \"sigma_c_Pa\": 5000}, {\"consolidation_stress_Pa\": 54800, "
               "\"sigma_1_Pa\": 54000, \"sigma_c_Pa\": 11000}]}");
    check(
        &all,
        "1 run of test lab had sigma_1 of 15 kPa, and the table of target lab: sigma_c at 20 kPa has 20 to 54.8 kPa: they are compared by an extrapolation. Add measured rows at such stresses, or consolidate the test at another one.");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(runs_beyond_a_table_are_told, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(runs_near_a_table_are_not_told, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(failed_and_damaged_runs_are_not_looked_at,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(uniaxial_runs_below_a_table_are_told, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
