// How many groups of ranks step the parts of a batch.
#include "sim/group.h"

#include "support/check.h"

static bool split(clod_ranks *self, int colour, clod_ranks *part, clod_status *status)
{
    (void)self, (void)colour, (void)part, (void)status;
    return false;
}

static int count(int ranks, int parts)
{
    const clod_ranks all = {.size = ranks, .split = split};
    return clod_group_count(&all, parts);
}

static void nobody_waits_long(void **state)
{
    (void)state;
    assert_int_equal(count(1, 8), 1);
    assert_int_equal(count(8, 1), 1);
    assert_int_equal(count(4, 4), 4);
    assert_int_equal(count(3, 2), 2);  // two ranks for one part, one for the other
    assert_int_equal(count(64, 8), 8); // eight ranks each
    assert_int_equal(count(2, 3), 1);  // one of two would wait for a quarter of 2 x 2 turns
    assert_int_equal(count(2, 4), 2);
    assert_int_equal(count(3, 8), 3); // 3 + 3 + 2: a ninth of the time is nobody's
    assert_int_equal(count(4, 5), 3); // 2 + 2 + 1: a sixth; of 4 groups three would wait half
    for (int ranks = 1; ranks < 40; ranks++) {
        for (int parts = 1; parts < 40; parts++) {
            const int groups = count(ranks, parts);
            const int turns = (parts + groups - 1) / groups;
            assert_true(groups >= 1 && groups <= ranks && groups <= parts);
            assert_true(parts >= 0.8 * groups * turns); // at most a fifth is nobody's
        }
    }
}

static void ranks_that_cannot_be_split_are_one_group(void **state)
{
    (void)state;
    const clod_ranks all = {.size = 4};
    assert_int_equal(clod_group_count(&all, 4), 1);
    assert_int_equal(clod_group_count(NULL, 4), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nobody_waits_long),
        cmocka_unit_test(ranks_that_cannot_be_split_are_one_group),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
