/**
 * @file test_runs_warnings.c
 * What finished runs warn of reaches the report, counted by test and text.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "calibrate/runs.h"
#include "output/temp_folder.h"
#include "plan_made.h"

#define TESTS 2
#define PACKINGS 3

/** A calibration of one point: ring and wall, with three packings each. */
typedef struct made {
    plan_made plan;
    clod_plan_test tests[TESTS];
    clod_runs_row rows[PACKINGS * TESTS];
    clod_runs runs;
} made;

static void make(made *self, void **state)
{
    static clod_folder folder;
    *self = (made){.tests = {{.name = "ring"}, {.name = "wall"}}};
    plan_make(&self->plan, 1, 1);
    self->plan.plan.tests = self->tests;
    self->plan.plan.test_count = TESTS;
    self->plan.plan.seeds = PACKINGS;
    for (size_t k = 0; k < PACKINGS * TESTS; k++) {
        self->rows[k].state = CLOD_RUNS_DONE;
    }
    folder = (clod_folder){.path = *state};
    self->runs = (clod_runs){
        .plan = &self->plan.plan, .folder = &folder, .rows = self->rows, .points = 1};
    char path[PATH_MAX];
    assert_int_equal(mkdir(temp_path(path, state, "runs"), 0777), 0);
}

static void write_summary(const made *self, size_t row, const char *text)
{
    char path[PATH_MAX];
    clod_runs_path(&self->runs, row, "", path);
    assert_int_equal(mkdir(path, 0777), 0);
    clod_runs_path(&self->runs, row, "/summary.json", path);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs(text, out);
    assert_int_equal(fclose(out), 0);
}

static void each_text_of_a_test_is_counted_once_a_run(void **state)
{
    made all;
    static clod_warning_list list;
    list.count = 0;
    make(&all, state);
    write_summary(&all, 0, "{\"warnings\": [\"stress-1: overlap 1.2e-05 is 3 times\"]}");
    write_summary(&all, 1,
                  "{\"wall_locus\": {\"warnings\": [\"Steep: 4 deg\"]}, \"warnings\": []}");
    write_summary(
        &all, 2,
        "{\"locus\": {\"warnings\": [], \"loci\": [{\"warnings\": [\"Steep: 9.25 deg\"]}]}}");
    write_summary(&all, 3, "{\"warnings\": [\"Steep: -4 deg\"]}");
    write_summary(
        &all, 4,
        "{\"warnings\": [\"stress-1: overlap 17 is 3. times\", \"stress-1: overlap 2 is 3 "
        "times\", \"stress-2: overlap 0.5 is 11 times\"]}");
    all.rows[5].state = CLOD_RUNS_FAILED; // it has no summary
    clod_runs_warn(&all.runs, &list);
    assert_int_equal(list.count, 5);
    assert_string_equal(list.text[0],
                        "2 runs of test ring warn, the first of them p000-1-ring: "
                        "stress-1: overlap 1.2e-05 is 3 times");
    assert_string_equal(
        list.text[1], "1 run of test wall warns, the first of them p000-1-wall: Steep: 4 deg");
    assert_string_equal(
        list.text[2],
        "1 run of test ring warns, the first of them p000-2-ring: Steep: 9.25 deg");
    assert_string_equal(list.text[3],
                        "1 run of test wall warns, the first of them p000-2-wall: "
                        "Steep: -4 deg");
    assert_string_equal(list.text[4],
                        "1 run of test ring warns, the first of them p000-3-ring: "
                        "stress-1: overlap 17 is 3. times");
}

static void summary_that_is_gone_is_told(void **state)
{
    made all;
    static clod_warning_list list;
    list.count = 0;
    make(&all, state);
    for (size_t row = 1; row < PACKINGS * TESTS; row++) {
        write_summary(&all, row, "{\"warnings\": []}");
    }
    clod_runs_warn(&all.runs, &list);
    assert_int_equal(list.count, 1);
    assert_string_equal(list.text[0],
                        "1 finished run has no summary.json that can be read: what it "
                        "warned of is not known.");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(each_text_of_a_test_is_counted_once_a_run,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(summary_that_is_gone_is_told, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
