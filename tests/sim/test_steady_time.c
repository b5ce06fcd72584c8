// The steady time: its default, its moment in steps, what of an interval is in it.

#include "sim/steady_time.h"

#include <math.h>

#include "support/check.h"

static clod_case make_case(clod_case_stage *stages)
{
    stages[0].duration = 4.0;
    stages[1].duration = 5.0;
    return (clod_case){.stages = stages, .stage_count = 2};
}

/** 9 s: the last third begins 6 s after the run does, wherever that was. */
static void without_a_key_it_is_the_last_third(void **unused)
{
    (void)unused;
    clod_case_stage stages[2] = {0};
    clod_case from = make_case(stages);
    clod_steady_time steady = clod_steady_time_of(&from, 100.0, 0.5e-3);
    check_close(steady.since, 106.0, 1e-12);
    check_close(steady.block, 0.3, 1e-12);
    from.output.has_steady_since = true;
    from.output.steady_since = 4.0;
    steady = clod_steady_time_of(&from, 100.0, 0.5e-3);
    check_close(steady.since, 104.0, 1e-12);
    check_close(steady.block, 0.5, 1e-12);
}

/** A stage ends with the step nearest to its end, here up to 49 us before it or behind it. */
static void the_last_step_ends_the_last_block(void **unused)
{
    (void)unused;
    static const double DT[] = {1.0e-4, 1.4998e-4, 7.777e-5, 2.62155684892191e-6};
    clod_case_stage stages[2] = {{.duration = 1.0003}, {.duration = 1.99973}};
    clod_case from = {.stages = stages, .stage_count = 2};
    from.output.has_steady_since = true;
    from.output.steady_since = 2.0;
    for (size_t k = 0; k < sizeof DT / sizeof *DT; k++) {
        const double dt = DT[k];
        const int64_t last = (int64_t)(round(1.0003 / dt) + round(1.99973 / dt));
        const clod_steady_time steady = clod_steady_time_of(&from, 100.0, dt);
        assert_int_equal(clod_steady_time_edges(&steady, 100.0 + (double)last * dt),
                         CLOD_STEADY_BLOCKS + 1);
        assert_int_equal(clod_steady_time_edges(&steady, 100.0 + (double)(last - 1) * dt),
                         CLOD_STEADY_BLOCKS);
        assert_int_equal(clod_steady_time_steps(steady.since + 10.0 * steady.block, 100.0, dt),
                         last);
    }
}

/** Steps of 0.7 s in 1 s: one, which ends at 0.7 s; the steady time of 0.9 s never begins. */
static void no_block_is_over_before_it_begins(void **unused)
{
    (void)unused;
    clod_case_stage stage = {.duration = 1.0};
    clod_case from = {.stages = &stage, .stage_count = 1};
    from.output.has_steady_since = true;
    from.output.steady_since = 0.9;
    const clod_steady_time steady = clod_steady_time_of(&from, 0.0, 0.7);
    assert_true(steady.block > 0.0);
    assert_int_equal(clod_steady_time_edges(&steady, 0.0), 0);
    assert_int_equal(clod_steady_time_edges(&steady, 0.7), 0);
    assert_int_equal(clod_steady_time_block(&steady, 0.7), -1);
}

static void steps_until_a_moment_are_0_once(void **unused)
{
    (void)unused;
    const double dt = 1e-3;
    int at = 0;
    for (int k = 0; k < 1000; k++) {
        const int64_t steps = clod_steady_time_steps(0.3, k * dt, dt);
        assert_int_equal(steps, 300 - k);
        at += steps == 0;
    }
    assert_int_equal(at, 1);
    assert_int_equal(clod_steady_time_steps(0.3001, 0.3, dt),
                     1); // between two steps: the later
    assert_int_equal(clod_steady_time_steps(0.3001, 0.301, dt), 0);
    assert_true(clod_steady_time_steps(1e300, 0.0, dt) > 0);
}

static void an_interval_counts_from_the_moment_on(void **unused)
{
    (void)unused;
    const clod_steady_time steady = {.since = 2.0, .block = 0.1};
    check_close(clod_steady_time_within(&steady, 0.5, 1.5), 0.0, 0.0);
    check_close(clod_steady_time_within(&steady, 1.5, 2.5), 0.5, 1e-15);
    check_close(clod_steady_time_within(&steady, 2.5, 3.5), 1.0, 1e-15);
}

static void blocks_begin_at_the_moment(void **unused)
{
    (void)unused;
    const clod_steady_time steady = {.since = 2.0, .block = 0.1};
    assert_int_equal(clod_steady_time_block(&steady, 1.999), -1);
    assert_int_equal(clod_steady_time_block(&steady, 2.0), 0);
    assert_int_equal(clod_steady_time_block(&steady, 2.95), 9);
    assert_int_equal(clod_steady_time_block(&steady, 3.0), 9); // the end is of the last
    assert_int_equal(clod_steady_time_edges(&steady, 3.0), CLOD_STEADY_BLOCKS + 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_key_it_is_the_last_third),
        cmocka_unit_test(the_last_step_ends_the_last_block),
        cmocka_unit_test(no_block_is_over_before_it_begins),
        cmocka_unit_test(steps_until_a_moment_are_0_once),
        cmocka_unit_test(an_interval_counts_from_the_moment_on),
        cmocka_unit_test(blocks_begin_at_the_moment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
