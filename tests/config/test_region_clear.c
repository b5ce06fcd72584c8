// How fast grains leave the region of an inlet: closed forms beside flights in small steps.

#include "config/region_clear.h"

#include <math.h>

#include "support/check.h"

#define G 9.81
#define STEP 1e-4   ///< s, of a flight
#define PLACES 2000 ///< where flights begin

static const double DOWN[3] = {0.0, 0.0, -G}, NONE[3] = {0.0, 0.0, 0.0};
/** 160 x 120 x 40 mm, beside the origin. */
static const clod_case_region BOX = {
    .kind = CLOD_REGION_BOX, .min = {0.3, -0.2, 0.5}, .max = {0.46, -0.08, 0.54}};

/** Longest time that a grain is in a way of length `way` before it is out, of those that begin at PLACES; the
 *  highest that one rises; and whether one comes back past where it has been, inside. */
static double fly(double v, double g, double way, double *rise)
{
    double longest = 0.0;
    *rise = 0.0;
    for (int k = 0; k <= PLACES; k++) {
        const double begin = way * k / PLACES;
        double t = 0.0, z = begin;
        while (z >= 0.0 && z <= way && t < 1.0) {
            t += STEP;
            z = begin + v * t + 0.5 * g * t * t;
            *rise = z <= way ? fmax(*rise, z - begin) : *rise;
        }
        longest = fmax(longest, t);
    }
    return longest;
}

static void along_gravity_and_against_it(void **state)
{
    (void)state;
    for (int k = -20; k <= 20; k++) {
        const double v[3] = {0.0, 0.0, 0.1 * k}, up = sqrt(2.0 * G * 0.04); // 0.886 m/s
        double rise;
        const double longest = fly(v[2], -G, 0.04, &rise);
        const clod_region_clear found = clod_region_clear_of(&BOX, v, DOWN);
        check_close(found.time, longest, 1.5 * STEP);
        assert_int_equal(found.falls_back, v[2] > 0.0 && v[2] < up);
        if (found.falls_back) {
            check_close(found.rise, rise, 1e-4);
            check_close(found.height, 0.04, 1e-15);
            check_close(found.enough, up, 1e-12);
        }
    }
}

/** By hand: (sqrt(1 + 2 g 0.04) - 1)/g, sqrt(2 0.04/g), (0.5 + sqrt(2 g 0.04))/g, 0.04/0.1. */
static void times_by_hand(void **state)
{
    (void)state;
    const double down[3] = {0.0, 0.0, -1.0}, up[3] = {0.0, 0.0, 0.5}, slow[3] = {0.0, 0.0, 0.1};
    check_close(clod_region_clear_of(&BOX, down, DOWN).time, 0.0342471, 1e-7);
    check_close(clod_region_clear_of(&BOX, NONE, DOWN).time, 0.0903047, 1e-7);
    check_close(clod_region_clear_of(&BOX, up, DOWN).time, 0.1412731, 1e-7);
    check_close(clod_region_clear_of(&BOX, slow, NONE).time, 0.4, 1e-12);
    assert_true(isinf(clod_region_clear_of(&BOX, NONE, NONE).time));
}

/** Through several sides: across 0.16 m and 0.12 m at a steady speed, down as they fall. */
static void sideways_all_sides_add_up(void **state)
{
    (void)state;
    const double v[3] = {1.0, -0.5, 0.0};
    const double rate = 1.0 / 0.16 + 0.5 / 0.12 + 1.0 / 0.0903047;
    check_close(clod_region_clear_of(&BOX, v, DOWN).time, 1.0 / rate, 1e-7);
    // the same as flow over velocity and area across it, where there is no gravity
    check_close(clod_region_clear_of(&BOX, v, NONE).time, 1.0 / (1.0 / 0.16 + 0.5 / 0.12),
                1e-12);
}

/** Thrown aslant, they leave by a side before they turn, or at the top: the speed at which that begins. */
static void a_grain_thrown_aslant_may_leave_by_a_side(void **state)
{
    (void)state;
    for (int narrow = 0; narrow < 2; narrow++) {
        clod_case_region box = BOX;
        box.max[0] = box.min[0] + (narrow == 1 ? 0.01 : 0.16);
        const double v[3] = {0.1, 0.0, 0.5}, speed = sqrt(0.26);
        const clod_region_clear found = clod_region_clear_of(&box, v, DOWN);
        assert_true(found.falls_back);
        // at the top from sqrt(2 g h)/0.98058 on; by a side x wide from sqrt(g x/(0.98058 0.19612)) on
        check_close(found.enough, narrow == 1 ? 0.714226 : 0.903434, 1e-6);
        for (int above = 0; above < 2; above++) {
            const double by = found.enough / speed * (above == 1 ? 1.0001 : 0.9999);
            const double other[3] = {by * v[0], 0.0, by * v[2]};
            assert_int_equal(clod_region_clear_of(&box, other, DOWN).falls_back, above == 0);
        }
    }
}

/** Against a gravity that leads aside, as in a tilted box. */
static void any_axis_can_be_upwards(void **state)
{
    (void)state;
    const double g[3] = {4.0, 0.0, -G}, v[3] = {-0.5, 0.0, 0.0};
    const clod_region_clear found = clod_region_clear_of(&BOX, v, g);
    const double turning = (0.5 + sqrt(2.0 * 4.0 * 0.16)) / 4.0;
    check_close(found.time, 1.0 / (1.0 / turning + 1.0 / 0.0903047), 1e-7);
    assert_false(found.falls_back); // it turns after 0.125 s, and is out below after 0.09 s
    const double still[3] = {-0.3, 0.0, 0.0};
    assert_true(clod_region_clear_of(&BOX, still, g).falls_back); // after 0.075 s
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(along_gravity_and_against_it),
        cmocka_unit_test(times_by_hand),
        cmocka_unit_test(sideways_all_sides_add_up),
        cmocka_unit_test(a_grain_thrown_aslant_may_leave_by_a_side),
        cmocka_unit_test(any_axis_can_be_upwards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
