// The skin of the near list: from the speed of the fastest grain or wall when the list is made.

#include <math.h>

#include "support/scene.h"

#define DT 1e-6
#define RADIUS 2e-3

/** Two grains far apart, one of them moving, or a floor under them that does. */
static void two_grains(scene *s, double speed, bool floor_moves)
{
    const clod_case_contact ore = contact_ore();
    scene_init(s, DT, &ore);
    scene_grain(s, 0.0, 0.0, 0.0, RADIUS);
    const size_t other = scene_grain(s, 0.02, 0.0, 0.0, 3.0 * RADIUS);
    if (floor_moves) {
        scene_wall(s, "floor", shape_floor(-1.0))->velocity.x = speed;
    } else {
        scene_move(s, other, 0.0, speed, 0.0);
    }
    scene_start(s);
}

/** Four times the speed, twice the skin: twice the pairs, and lists twice as often. */
static void it_goes_with_the_root_of_the_speed(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.1, false);
    const double skin = clod_step_thin_skin(&s.step, 0.1);
    check_relative(skin, 3.4641e-5, 1e-5); // sqrt(3 x 2 x 0.1 m/s x 1 us x 2 mm)
    check_relative(clod_step_thin_skin(&s.step, 0.4), 2.0 * skin, 1e-15);
    scene_end(&s);
}

/** At rest a thousandth of the smallest radius, however fast never more than candidates reach.
 */
static void it_has_bounds(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.0, false);
    check_relative(clod_step_thin_skin(&s.step, 0.0), 1e-3 * RADIUS, 1e-15);
    check_relative(s.step.near.skin, 1e-3 * RADIUS, 1e-15);
    assert_true(clod_step_thin_skin(&s.step, 1e6) == s.step.neighbour.skin);
    scene_end(&s);
}

/** The first list knows how fast grains and walls are. */
static void the_first_list_knows_the_speed(void **state)
{
    (void)state;
    for (int wall = 0; wall < 2; wall++) {
        scene s;
        two_grains(&s, 0.1, wall != 0);
        check_relative(s.step.near.skin, 3.4641e-5, 1e-5);
        scene_end(&s);
    }
}

/** So does every later one. */
static void later_lists_know_the_speed(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.0, false);
    scene_move(&s, 0, 0.4, 0.0, 0.0);
    while (s.step.refreshes == 0 && s.state.step < 100) {
        scene_run(&s, 1);
    }
    assert_int_equal(s.step.refreshes, 1);
    check_relative(s.step.near.skin, 6.9282e-5, 1e-5); // twice that of 0.1 m/s
    scene_move(&s, 0, 0.0, 0.1, 0.0);
    scene_run(&s, 400); // 40 um: twice that is beyond the skin
    assert_int_equal(s.step.refreshes, 2);
    check_relative(s.step.near.skin, 3.4641e-5, 1e-5);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_goes_with_the_root_of_the_speed),
        cmocka_unit_test(it_has_bounds),
        cmocka_unit_test(the_first_list_knows_the_speed),
        cmocka_unit_test(later_lists_know_the_speed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
