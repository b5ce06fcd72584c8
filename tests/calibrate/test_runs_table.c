/**
 * @file test_runs_table.c
 * runs.csv: a line for each packing, with the reason of every test of it that failed.
 */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/memory.h"
#include "calibrate/runs.h"
#include "plan_made.h"

#define TESTS 3
#define PACKINGS 2

static void every_test_of_a_packing_that_failed_has_its_reason(void **state)
{
    (void)state;
    clod_plan_test tests[TESTS] = {{.name = "ring"}, {.name = "wall"}, {.name = "lift"}};
    clod_runs_row rows[PACKINGS * TESTS] = {
        {.state = CLOD_RUNS_FAILED, .why = "too soft, \"by far\""},
        {.state = CLOD_RUNS_DONE},
        {.state = CLOD_RUNS_FAILED, .why = "no memory"},
        {.state = CLOD_RUNS_DONE},
        {.state = CLOD_RUNS_DONE},
        {.state = CLOD_RUNS_FAILED}};
    const double places[] = {0.25};
    const double results[PACKINGS] = {(double)NAN, 7.5};
    plan_made made;
    plan_make(&made, 1, 1);
    made.plan.tests = tests;
    made.plan.test_count = TESTS;
    const clod_runs runs = {.plan = &made.plan, .rows = rows, .points = 1};
    char *csv = clod_runs_csv(&runs, 1, places, results);
    assert_string_equal(csv, "point,packing,seed,p0 [1],t0 [1],failed\n"
                             "0,1,1,0.25,,\"ring: too soft, \"\"by far\"\"; lift: no memory\"\n"
                             "0,2,2,0.25,7.5,\"lift: it said nothing\"\n");
    clod_memory_free(csv);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_test_of_a_packing_that_failed_has_its_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
