// When a run with a time limit stops: early enough to write its checkpoints.
#include "sim/time_limit.h"

#include "support/check.h"

/** From 100 s on the clock it has 1000 s: 20 s of them are spare. Turns of 3 s and checkpoints of
 *  40 s, of two jobs, need twice (3 + 2 40) = 166 s: it stops 186 s before the end. */
static void it_stops_before_its_time_is_over(void **state)
{
    (void)state;
    const clod_time_limit limit = {100.0, 1000.0};
    const clod_time_spent spent = {.turn = 3.0, .checkpoint = 40.0};
    assert_false(clod_time_limit_is_near(&limit, &spent, 2, 913.9));
    assert_true(clod_time_limit_is_near(&limit, &spent, 2, 914.1));
    assert_false(clod_time_limit_is_near(&limit, &spent, 1, 993.9)); // 86 + 20 s
    assert_true(clod_time_limit_is_near(&limit, &spent, 1, 994.1));
}

static void without_a_limit_it_never_stops(void **state)
{
    (void)state;
    const clod_time_limit none = {0};
    const clod_time_spent spent = {.turn = 3.0, .checkpoint = 40.0};
    assert_false(clod_time_limit_is_near(&none, &spent, 1, 1e9));
    assert_false(clod_time_limit_asks(&none, &(clod_time_spent){0}, 1e9));
}

static void a_checkpoint_is_timed_in_the_first_half(void **state)
{
    (void)state;
    const clod_time_limit limit = {100.0, 1000.0};
    assert_false(clod_time_limit_asks(&limit, &(clod_time_spent){.turn = 3.0}, 599.0));
    assert_true(clod_time_limit_asks(&limit, &(clod_time_spent){.turn = 3.0}, 601.0));
    assert_false(clod_time_limit_asks(&limit, &(clod_time_spent){.checkpoint = 1.0}, 601.0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_stops_before_its_time_is_over),
        cmocka_unit_test(without_a_limit_it_never_stops),
        cmocka_unit_test(a_checkpoint_is_timed_in_the_first_half),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
