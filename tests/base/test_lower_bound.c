// A binary search finds what counting finds.
#include "base/lower_bound.h"
#include "support/check.h"

#define MOST 40

static size_t search(const int *item, size_t count, int limit)
{
    clod_lower_bound in = {0, count};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        clod_lower_bound_halve(&in, item[middle] < limit);
    }
    return in.low;
}

static void the_first_that_is_not_below(void **state)
{
    (void)state;
    for (int same = 1; same <= 5; same++) { // so many items are equal
        int item[MOST];
        for (int k = 0; k < MOST; k++) {
            item[k] = 2 * (k / same);
        }
        for (size_t count = 0; count <= MOST; count++) {
            for (int limit = -1; limit <= 2 * MOST; limit++) {
                size_t below = 0;
                for (size_t k = 0; k < count; k++) {
                    below += item[k] < limit;
                }
                assert_int_equal(search(item, count, limit), below);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_that_is_not_below),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
