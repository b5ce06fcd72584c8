/**
 * @file test_runs_table.c
 * Seeds of the runs; runs.csv: a line for each packing, with the reason of every test of it that failed.
 */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

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
    assert_string_equal(
        csv,
        "point,packing,ring: seed,wall: seed,lift: seed,p0 [1],t0 [1],failed\n"
        "0,1,1,1000000001,2000000001,0.25,,\"ring: too soft, \"\"by far\"\"; lift: no memory\"\n"
        "0,2,2,1000000002,2000000002,0.25,7.5,\"lift: it said nothing\"\n");
    clod_memory_free(csv);
}

static int compare(const void *a, const void *b)
{
    const int64_t one = *(const int64_t *)a, other = *(const int64_t *)b;
    return one < other ? -1 : one > other ? 1 : 0;
}

/** Of the largest plan there may be: seed and packings at the ends of their ranges (clod explain), all points. */
static void no_two_runs_of_a_plan_have_one_seed(void **state)
{
    (void)state;
    clod_plan_test tests[TESTS] = {{.name = "ring"}, {.name = "wall"}, {.name = "lift"}};
    plan_made made;
    plan_make(&made, 1, 1);
    made.plan.tests = tests;
    made.plan.test_count = TESTS;
    made.plan.seeds = 20;
    made.plan.seed = 1000000000;
    const size_t rows = clod_runs_row_of(&made.plan, CLOD_PLAN_POINTS, 0, 0);
    int64_t *seeds = clod_memory_alloc(rows, sizeof *seeds);
    assert_non_null(seeds);
    for (size_t row = 0; row < rows; row++) {
        seeds[row] = clod_runs_seed(&made.plan, row);
    }
    qsort(seeds, rows, sizeof *seeds, compare);
    for (size_t row = 1; row < rows; row++) {
        assert_true(seeds[row] > seeds[row - 1]);
    }
    assert_true(seeds[0] == made.plan.seed && seeds[rows - 1] < INT64_C(9000000000000000));
    clod_memory_free(seeds);
}

/** Packings of the first test are those that it has without others: 7 and 8 at the first point, 9 and 10 at the next. */
static void the_first_test_keeps_its_seeds_beside_others(void **state)
{
    (void)state;
    clod_plan_test tests[TESTS] = {{.name = "ring"}, {.name = "wall"}, {.name = "lift"}};
    plan_made made;
    plan_make(&made, 1, 1);
    made.plan.tests = tests;
    made.plan.seed = 7;
    for (made.plan.test_count = 1; made.plan.test_count <= TESTS; made.plan.test_count++) {
        for (size_t k = 0; k < 4; k++) {
            const size_t row = clod_runs_row_of(&made.plan, k / PACKINGS, k % PACKINGS, 0);
            assert_int_equal(clod_runs_seed(&made.plan, row), 7 + k);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_two_runs_of_a_plan_have_one_seed),
        cmocka_unit_test(the_first_test_keeps_its_seeds_beside_others),
        cmocka_unit_test(every_test_of_a_packing_that_failed_has_its_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
