/**
 * @file test_runs_lacks.c
 * Runs that do not define a number are named with what their report says of it, and those in which it counts as 0 are counted.
 */

#include "runs_made.h"

#define PACKINGS 3
#define PILE "cases/calibrate-repose/pile.yaml" // repose: {heap: ...}
#define FLOW                                                                                   \
    "{\"flow_function\": [{\"consolidation_stress_Pa\": 20000, \"sigma_1_Pa\": %g, "           \
    "\"sigma_c_Pa\": %g}]}"

static void write_strength(const runs_made *self, size_t row, double sigma_1, double sigma_c)
{
    char text[256];
    snprintf(text, sizeof text, FLOW, sigma_1, sigma_c);
    runs_write(self, row, "/summary.json", text);
}

static void run_without_the_number_is_told_with_the_words_of_its_report(void **state)
{
    runs_made all;
    char text[CLOD_RUNS_REASON];
    runs_make(&all, state, PILE, PACKINGS,
              "number: repose.heap.angle_deg, value: 34 deg, error: 1 deg");
    runs_write(&all, 0, "/summary.json", "{\"repose\": {\"heap\": {\"angle_deg\": 31.5}}}");
    runs_write(&all, 1, "/summary.json", "{\"repose\": {\"heap\": {\"angle_deg\": null}}}");
    runs_write(
        &all, 1, "/report.txt",
        "time 1 s\n  mixing heap     as long a word\n  repose hea      one\n  repose heaps    another\n"
        "  repose heap     angle of repose none at the end (2 strips)\n  balance\n");
    assert_true(clod_runs_lacks(&all.runs, 0, text));
    assert_string_equal(text, "p000-2-lab: angle of repose none at the end (2 strips)");
    all.rows[1].state = CLOD_RUNS_FAILED; // the third has no files, and is no finished run
    assert_false(clod_runs_lacks(&all.runs, 0, text));
    assert_string_equal(text, "");
    all.rows[1].state = CLOD_RUNS_DONE;
    runs_write(&all, 1, "/report.txt", "time 1 s\n\n  repose\n  repose heap");
    assert_true(clod_runs_lacks(&all.runs, 0, text));
    assert_string_equal(text, "p000-2-lab: "); // nothing behind the name
    runs_write(&all, 1, "/report.txt", "time 1 s\n\n  repose\n");
    assert_true(clod_runs_lacks(&all.runs, 0, text));
    assert_string_equal(text, "p000-2-lab");
    clod_plan_fini(&all.plan);
}

static void check_zeros(runs_made *all, const char *words)
{
    static clod_warning_list list;
    list.count = 0;
    clod_runs_warn_zeros(&all->runs, &list);
    assert_int_equal(list.count, words != NULL ? 1 : 0);
    if (words != NULL && strstr(list.text[0], words) != list.text[0]) {
        fail_msg("%s", list.text[0]);
    }
    clod_plan_fini(&all->plan);
}

#define VALUE "number: sigma_c, normal_stress: 20 kPa, value: 6 kPa, error: 1 kPa"

static void strengths_that_count_as_0_are_told(void **state)
{
    runs_made all;
    runs_make(&all, state, UNIAXIAL, PACKINGS, VALUE);
    write_strength(&all, 0, 2e4, 0.0);
    write_strength(&all, 1, 2e4, 5e3);
    runs_write(&all, 2, "/summary.json", "{}"); // not defined
    check_zeros(&all,
                "lab: sigma_c at 20 kPa counts as 0 in 1 of 2 runs: specimens did not stand.");
}

// From 15 to 20 kPa the table rises by 5 of 34.8 times 7 kPa: what is compared is above 0, the strength is not.
static void strengths_of_0_along_a_table_are_told(void **state)
{
    runs_made all;
    lab_write_file(state, "lab.csv",
                   "sigma_1 [kPa],sigma_c [kPa],sigma_c_error [kPa]\n20,6,0.4\n54.8,13,0.7\n");
    runs_make(&all, state, UNIAXIAL, PACKINGS, "locus: lab.csv, normal_stress: 20 kPa");
    write_strength(&all, 0, 1.5e4, 0.0);
    write_strength(&all, 1, 1.9e4, 0.0);
    write_strength(&all, 2, 1.5e4, 5e3);
    check_zeros(&all,
                "lab: sigma_c at 20 kPa counts as 0 in 2 of 3 runs: specimens did not stand.");
}

static void strengths_above_0_and_angles_are_not_told(void **state)
{
    runs_made all;
    runs_make(&all, state, UNIAXIAL, PACKINGS, VALUE);
    write_strength(&all, 0, 2e4, 1.0);
    check_zeros(&all, NULL);
    runs_make(&all, state, PILE, PACKINGS,
              "number: repose.heap.angle_deg, value: 34 deg, error: 1 deg");
    runs_write(&all, 0, "/summary.json", "{\"repose\": {\"heap\": {\"angle_deg\": 0.0}}}");
    check_zeros(&all, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(
            run_without_the_number_is_told_with_the_words_of_its_report, temp_folder_make,
            temp_folder_remove),
        cmocka_unit_test_setup_teardown(strengths_that_count_as_0_are_told, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(strengths_of_0_along_a_table_are_told, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(strengths_above_0_and_angles_are_not_told,
                                        temp_folder_make, temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
