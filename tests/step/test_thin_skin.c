// The skins of both lists: from the speed of the fastest grain or wall when a list is made.

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
    // sqrt(47 x 2 grains / 1 pair x 2 x 0.1 m/s x 1 us x 0.3 x 6 mm): no candidate counts as one
    check_relative(skin, 1.83957e-4, 1e-5);
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
        check_relative(s.step.near.skin, 1.83957e-4, 1e-5);
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
    check_relative(s.step.near.skin, 3.67913e-4, 1e-5); // twice that of 0.1 m/s
    scene_move(&s, 0, 0.0, 0.1, 0.0);
    scene_run(&s, 2000); // 200 um: twice that is beyond the skin
    assert_int_equal(s.step.refreshes, 2);
    check_relative(s.step.near.skin, 1.83957e-4, 1e-5);
    scene_end(&s);
}

/** Twice the candidates, and the list is thinner by the root of two. */
static void it_is_thinner_among_many_candidates(void **state)
{
    (void)state;
    double skin[2];
    for (int k = 0; k < 2; k++) {
        scene s;
        const clod_case_contact ore = contact_ore();
        scene_init(&s, DT, &ore);
        for (int g = 0; g < 4; g++) { // each pair of grains is one candidate
            const double x = 0.1 * (k == 0 ? (double)g : (double)(g / 2));
            scene_grain(&s, x + (g % 2 == 0 ? 0.0 : 2.1 * RADIUS), 0.0, 0.0, RADIUS);
        }
        scene_start(&s);
        assert_int_equal(s.step.neighbour.pairs.count, k == 0 ? 0 : 2);
        skin[k] = clod_step_thin_skin(&s.step, 0.01);
        scene_end(&s);
    }
    check_relative(skin[1], skin[0] / sqrt(2.0), 1e-15); // none counts as one
}

/** The skin of the candidates: 0.3 of the largest radius, more for fast grains, at most one. */
static void the_wide_skin_goes_with_the_root_of_the_speed(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.1, false);
    assert_true(s.step.neighbour.skin == 0.3 * 3.0 * RADIUS);
    clod_neighbour *search = &s.step.neighbour;
    clod_neighbour_choose_skin(search, &s.state, 10.0);
    check_relative(search->skin, 2.68328e-3, 1e-5); // sqrt(60 x 2 x 10 m/s x 1 us x 6 mm)
    clod_neighbour_choose_skin(search, &s.state, 1e6);
    assert_true(search->skin == 3.0 * RADIUS);
    // half a period of 28 mm is what two grains of 6 mm and a skin may reach
    s.state.domain.periodic[1] = true;
    s.state.domain.max[1] = s.state.domain.min[1] + 0.028;
    clod_neighbour_choose_skin(search, &s.state, 10.0);
    check_relative(search->skin, 2.0e-3, 1e-12); // 14 mm less 12 mm
    scene_end(&s);
}

/** A run that goes on rebuilds at the same step: the skin is that of the last rebuild. */
static void the_wide_skin_is_part_of_the_state(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 10.0, false);
    clod_status status;
    const double skin = s.step.neighbour.skin;
    check_relative(skin, 2.68328e-3, 1e-5);
    scene_move(&s, 1, 0.0, 0.0, 0.0);
    assert_true(clod_step_export(&s.step, &status));
    clod_step_fini(&s.step);
    const clod_step_options options = {.threads = 1};
    assert_true(clod_step_init(&s.step, &s.state, &s.laws, &options, &status));
    assert_true(s.step.neighbour.skin == skin);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_goes_with_the_root_of_the_speed),
        cmocka_unit_test(it_has_bounds),
        cmocka_unit_test(the_first_list_knows_the_speed),
        cmocka_unit_test(later_lists_know_the_speed),
        cmocka_unit_test(it_is_thinner_among_many_candidates),
        cmocka_unit_test(the_wide_skin_goes_with_the_root_of_the_speed),
        cmocka_unit_test(the_wide_skin_is_part_of_the_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
