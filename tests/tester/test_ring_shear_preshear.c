// Where the preshear of a ring shear test ends, and what it says then, on fabricated states.
#include "support/ring_states.h"

static void steady_shear_ends_preshear(void **context)
{
    (void)context;
    go_to_the_end_of_preshear();
    assert_int_equal(now.test.flags, 0);
    assert_true(fabs(now.test.preshear_shear / 6e3 - 1.0) < 1e-12);
    assert_true(fabs(now.test.preshear_dilation) < 1e-12);
    // three blocks of 1 mm, which end at whole millimetres since the limit does, the first of them
    // after the way of the start (0.03 m/s at 3 m/s2: 0.15 mm); samples are of 67 steps, 0.0201 mm
    check_close(now.test.preshear_displacement, 4.0e-3, 0.02e-3);
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
    // 19 whole blocks of 1.005 mm (samples of 67 steps) from 1 mm on
    check_close(now.test.preshear_displacement, 20.095e-3, 0.02e-3);
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
    // the first end of a block behind 8 mm: seven of them, from 1 mm on
    assert_true(now.test.preshear_displacement >= 8e-3);
    assert_true(now.test.preshear_displacement < 8.1e-3);
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

/** Tests of other speeds end alike, though they come to their speed on 0.02 to 6.67 mm. Steps are a whole part of a
 *  sample, as they nearly are with those of real beds. */
static void the_limit_is_where_preshear_ends_whatever_the_speed(void **context)
{
    static const double SPEEDS[] = {0.01, 0.04, 0.08, 0.1, 0.2}; // m/s
    for (size_t k = 0; k < sizeof SPEEDS / sizeof *SPEEDS; k++) {
        make_cell(context);
        now.test.speed = SPEEDS[k];
        now.test.preshear_max = 14.27e-3;
        now.test.preshear_min = 14.27e-3;
        go_to_preshear();
        for (int n = 0; n < 100000 && now.test.phase == CLOD_RING_SHEAR_PRESHEAR; n++) {
            look(PRESHEAR, 1e3 + 4e5 * now.test.displacement);
        }
        assert_int_equal(now.test.flags, CLOD_RING_SHEAR_NOT_STEADY);
        check_close(now.test.preshear_displacement, 14.27e-3, 0.0101e-3); // half a sample
    }
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
        T(steady_shear_ends_preshear),
        T(rising_shear_ends_at_the_limit_and_is_told),
        T(level_shear_goes_on_to_the_least_way),
        T(a_pause_before_the_least_way_does_not_count),
        T(the_limit_is_where_preshear_ends_whatever_the_speed),
        T(short_limit_still_gives_a_mean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
