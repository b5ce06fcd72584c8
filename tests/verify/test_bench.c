// The worst of several: what is no number is the worst of all, wherever it comes.

#include "support/check.h"
#include "verify/bench.h"

static void the_larger_of_two(void **state)
{
    (void)state;
    check_close(clod_verify_larger(1.0, 2.0), 2.0, 0.0);
    check_close(clod_verify_larger(2.0, 1.0), 2.0, 0.0);
    assert_true(isnan(clod_verify_larger(1.0, (double)NAN)));
    assert_true(isnan(clod_verify_larger((double)NAN, 1.0)));
}

// Off by 10 %, 50 % and 20 %.
static void the_worst_point_is_kept(void **state)
{
    (void)state;
    clod_verify_worst worst = CLOD_VERIFY_WORST;
    clod_verify_worst_offer(&worst, 1.0, 10.0, 11.0);
    clod_verify_worst_offer(&worst, 2.0, 10.0, 5.0);
    clod_verify_worst_offer(&worst, 3.0, 10.0, 12.0);
    check_close(worst.at, 2.0, 0.0);
    check_close(worst.got, 5.0, 0.0);
}

static void what_is_no_number_stays_the_worst(void **state)
{
    (void)state;
    for (int first = 0; first < 3; first++) {
        clod_verify_worst worst = CLOD_VERIFY_WORST;
        for (int k = 0; k < 3; k++) {
            clod_verify_worst_offer(&worst, k, 10.0, k == first ? (double)NAN : 20.0);
        }
        check_close(worst.at, first, 0.0);
        assert_true(isnan(worst.got));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_larger_of_two),
        cmocka_unit_test(the_worst_point_is_kept),
        cmocka_unit_test(what_is_no_number_stays_the_worst),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
