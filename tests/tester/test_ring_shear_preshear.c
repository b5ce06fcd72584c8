// Where the preshear of a ring shear test ends, and what it says then, on fabricated states.
#include "support/ring_states.h"

static void steady_shear_ends_preshear(void **context)
{
    (void)context;
    go_to_the_end_of_preshear();
    assert_int_equal(now.test.flags, 0);
    assert_true(fabs(now.test.preshear_shear / 6e3 - 1.0) < 1e-12);
    assert_true(fabs(now.test.preshear_dilation) < 1e-12);
    // three blocks of 1 mm, after the way of the start (0.03 m/s at 3 m/s2: 0.15 mm)
    assert_true(now.test.preshear_displacement > 3.0e-3);
    assert_true(now.test.preshear_displacement < 3.4e-3);
    assert_int_equal(clod_ring_shear_plan(&now.test, &now.state), 0);
    assert_true(clod_ring_shear_progress(&now.test) == 1.0);
}

static void rising_shear_ends_at_the_limit_and_is_told(void **context)
{
    (void)context;
    go_to_preshear();
    for (int k = 0; k < 100000 && now.test.phase == CLOD_RING_SHEAR_PRESHEAR; k++) {
        look(PRESHEAR, 1e3 + 4e5 * now.test.displacement);
    }
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_DONE);
    assert_int_equal(now.test.flags, CLOD_RING_SHEAR_NOT_STEADY);
    // 19 whole blocks of 1 mm after the way of the start, 0.15 mm: a 20th would be beyond 20 mm
    assert_true(now.test.preshear_displacement > 19.1e-3);
    assert_true(now.test.preshear_displacement < 19.4e-3);
    // where it ended, 1 kPa + 0.4 kPa/mm of it, not 1.5 mm before as the mean of three blocks;
    // a look sees the stress of the look before, 0.02 mm or 8 Pa back, in the mean half of that
    const double end = 1e3 + 4e5 * now.test.preshear_displacement;
    assert_true(fabs(now.test.preshear_shear - end) < 13.0);
    assert_true(now.test.preshear_error >= 0.0 && now.test.preshear_error < 1.0);
    // a fiftieth of a block is 67 steps of 0.3 um, so a block 1.005 mm
    assert_true(fabs(now.test.preshear_rate / (1.005 * 4e5) - 1.0) < 1e-6);
    assert_true(now.test.preshear_rate_error < 1e-3 * 4e5);
}

static void level_shear_goes_on_to_the_least_way(void **context)
{
    (void)context;
    now.test.preshear_min = 8e-3;
    go_to_the_end_of_preshear();
    assert_int_equal(now.test.flags, 0);
    // the first end of a block of 1 mm behind 8 mm: 0.15 mm and eight blocks
    assert_true(now.test.preshear_displacement >= 8e-3);
    assert_true(now.test.preshear_displacement < 8.4e-3);
    assert_true(fabs(now.test.preshear_rate) < 1.0); // Pa/m
}

/** Level for 6 mm, then rising by 2 kPa/mm: a pause before the least way is not steady shear.
 */
static void a_pause_before_the_least_way_does_not_count(void **context)
{
    (void)context;
    now.test.preshear_min = 12e-3;
    go_to_preshear();
    for (int k = 0; k < 100000 && now.test.phase == CLOD_RING_SHEAR_PRESHEAR; k++) {
        look(PRESHEAR, 4e3 + 2e6 * fmax(now.test.displacement - 6e-3, 0.0));
    }
    assert_int_equal(now.test.flags, CLOD_RING_SHEAR_NOT_STEADY);
    assert_true(now.test.preshear_displacement > 19e-3);
}

static void short_limit_still_gives_a_mean(void **context)
{
    (void)context;
    now.test.preshear_max = 1e-6;
    go_to_preshear();
    for (int k = 0; k < 100000 && now.test.phase == CLOD_RING_SHEAR_PRESHEAR; k++) {
        look(PRESHEAR, 1e3 + 4e5 * now.test.displacement);
    }
    assert_true(isfinite(now.test.preshear_shear) && isfinite(now.test.preshear_error));
    assert_true(isfinite(now.test.preshear_density) && isfinite(now.test.preshear_dilation));
}

int main(void)
{
#define T(name) cmocka_unit_test_setup(name, make_cell)
    const struct CMUnitTest tests[] = {
        T(steady_shear_ends_preshear),           T(rising_shear_ends_at_the_limit_and_is_told),
        T(level_shear_goes_on_to_the_least_way), T(a_pause_before_the_least_way_does_not_count),
        T(short_limit_still_gives_a_mean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
