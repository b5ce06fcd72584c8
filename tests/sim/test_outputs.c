// When a run writes: every output of every interval once, at the step nearest to its time.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "sim/outputs.h"

/** What comes of walking from output to output, and of asking every step. */
static void expect(double interval, double dt, int64_t steps, int64_t outputs)
{
    int64_t walked = 0, asked = 0;
    for (int64_t s = clod_outputs_next(interval, dt, 0); s <= steps;
         s = clod_outputs_next(interval, dt, s)) {
        walked++;
        const double late = (double)s * dt - (double)walked * interval;
        assert_true(late <= 0.5000001 * dt && late >= -0.5000001 * dt);
        assert_int_equal(clod_outputs_count(interval, dt, s), walked);
        assert_int_equal(clod_outputs_count(interval, dt, s - 1), walked - 1);
    }
    for (int64_t s = 0; s <= steps; s++) {
        asked += clod_outputs_are_due(interval, dt, s) ? 1 : 0;
    }
    assert_int_equal(walked, outputs);
    assert_int_equal(asked, outputs);
    assert_int_equal(clod_outputs_count(interval, dt, steps), outputs);
}

static void every_output_comes_once(void **state)
{
    (void)state;
    expect(1e-3, 1e-5, 10000, 100);   // a whole number of steps
    expect(1e-3, 3e-6, 33333, 100);   // 333.33 steps
    expect(0.1, 0.1 / 3.0, 300, 100); // three, but for rounding
    expect(1e-3, 0.7e-3, 143, 100);   // 1.43 steps
    expect(1e-3, 1e-3, 100, 100);     // every step
    expect(2.5e-3, 1e-3, 250, 100);   // halves: 3, 5, 8, 10 (rounded away from zero)
    expect(1e-3, 5.9523809e-8, 1680000, 100);
}

static void an_interval_shorter_than_a_step_is_a_step(void **state)
{
    (void)state;
    for (int64_t s = 0; s < 10; s++) {
        assert_int_equal(clod_outputs_next(1e-9, 1e-6, s), s + 1);
    }
    assert_int_equal(clod_outputs_count(1e-9, 1e-6, 7), 7);
}

static void no_interval_no_output(void **state)
{
    (void)state;
    assert_false(clod_outputs_are_due(0.0, 1e-6, 1000));
    assert_int_equal(clod_outputs_count(0.0, 1e-6, 1000), 0);
}

static void nothing_drifts_far_from_the_beginning(void **state)
{
    (void)state;
    const double interval = 1e-3, dt = 3e-9; // an hour: 1.2e12 steps
    const int64_t first = (int64_t)(3600.0 / dt);
    const int64_t next = clod_outputs_next(interval, dt, first);
    assert_true((double)next * dt >= 3600.0 && (double)next * dt < 3600.0011);
    assert_int_equal(clod_outputs_count(interval, dt, next),
                     clod_outputs_count(interval, dt, first) + 1);
    assert_true(clod_outputs_next(1e6, 1e-300, 0) > 1000000000000); // and within 64 bits
}

static void a_free_run_is_counted(void **state)
{
    (void)state;
    clod_case_stage stages[2] = {{.duration = 0.1}, {.duration = 0.0105}};
    clod_case from = {.stages = stages, .stage_count = 2};
    from.output.series_interval = 1e-3;
    from.output.snapshot_interval = 1e-3;
    clod_outputs all = clod_outputs_of(&from, 1e-5);
    assert_int_equal(all.steps, 11050);
    assert_int_equal(all.rows, 100 + 11); // the last row is that of the end
    assert_int_equal(all.snapshots, 110 + 1);
    from.output.series_interval = 1e-2; // each interval on its own
    all = clod_outputs_of(&from, 1e-5);
    assert_int_equal(all.rows, 10 + 2);
    assert_int_equal(all.snapshots, 110 + 1);
    from.output.snapshot_interval = 0.0; // the ends of the stages
    assert_int_equal(clod_outputs_of(&from, 1e-5).snapshots, 2);
}

static void a_short_interval_is_told(void **state)
{
    (void)state;
    char text[256] = "";
    clod_case from = {0};
    from.output.series_interval = 1e-3;
    assert_false(clod_outputs_say_short(&from, 1e-4, text, sizeof text));
    from.output.snapshot_interval = 1e-5;
    assert_true(clod_outputs_say_short(&from, 1e-4, text, sizeof text));
    assert_non_null(strstr(text, "output.snapshot_interval"));
    from.output.snapshot_interval = 1.0;
    assert_true(clod_outputs_say_short(&from, 1e-2, text, sizeof text));
    assert_non_null(strstr(text, "output.series_interval"));
    from.uniaxial.present = true; // writes a row at each look
    assert_false(clod_outputs_say_short(&from, 1e-2, text, sizeof text));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_output_comes_once),
        cmocka_unit_test(an_interval_shorter_than_a_step_is_a_step),
        cmocka_unit_test(no_interval_no_output),
        cmocka_unit_test(nothing_drifts_far_from_the_beginning),
        cmocka_unit_test(a_free_run_is_counted),
        cmocka_unit_test(a_short_interval_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
