// How far grains may go by the near list, or leave their courses, from their speeds when it is made,
// and the skin of the candidates, from the fastest speed.

#include <math.h>
#include <string.h>

#include "base/random.h"
#include "step/near_skins.h"
#include "support/sanitized.h"
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

/** How far a grain may go by the list there is [m]. */
static double skin_of(const scene *s, size_t row)
{
    return (double)s->step.near.course[row][3];
}

/** Row of the faster of two grains. */
static size_t faster_of(const scene *s)
{
    const double(*v)[4] = (const double(*)[4])s->state.grains.velocity;
    return fabs(v[0][1]) > fabs(v[1][1]) ? 0 : 1;
}

/** Four times the speed, twice the skins: twice the pairs, and lists twice as often. */
static void they_go_with_the_root_of_the_speed(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        scene s;
        two_grains(&s, k == 0 ? 0.1 : 0.4, false);
        // sqrt(47 x 2 grains x 1 us x 0.3 x 6 mm / (2 x (0.05 + 0.2 x 0.1) m/s x 1 pair)); no
        // candidate counts as one
        const double time = k == 0 ? 1.09935e-3 : 0.5 * 1.09935e-3;
        const double speed = k == 0 ? 0.1 : 0.4;
        const clod_near_skins skins = clod_step_skins(&s.step, speed);
        check_relative(skins.time, time, 1e-5);
        check_relative(skins.least, 0.2 * speed * time, 1e-5);
        const size_t fast = faster_of(&s);
        check_relative(skin_of(&s, fast), 1.2 * speed * time, 1e-5); // the first list knows it
        check_relative(skin_of(&s, 1 - fast), 0.2 * speed * time, 1e-5);
        scene_end(&s);
    }
}

/** At rest a two-thousandth of the smallest radius, however fast never more than half of what
 *  candidates reach. */
static void they_have_bounds(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.0, false);
    check_relative(skin_of(&s, 0), 5e-4 * RADIUS, 6e-8); // it is a float
    check_relative(s.step.near.wall_skin, 5e-4 * RADIUS, 1e-15);
    check_relative(clod_step_skins(&s.step, 1e6).least, 0.5 * s.step.neighbour.skin, 1e-15);
    assert_true(clod_step_skins(&s.step, 1e6).most == 0.5 * s.step.neighbour.skin);
    scene_end(&s);
}

/** A wall that moves has a skin of its own. */
static void the_first_list_knows_the_speed_of_walls(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.1, true);
    // 1.3 x 0.1 m/s x sqrt(47 x 2 x 1 us x 1.8 mm / (2 x 0.02 m/s))
    check_relative(s.step.near.wall_skin, 2.67370e-4, 1e-5);
    scene_run(&s, 2600);
    assert_int_equal(s.step.refreshes, 0);
    scene_run(&s, 100);
    assert_int_equal(s.step.refreshes, 1);
    scene_end(&s);
}

/** A list lasts until a grain has moved by more than its skin, and no longer. Grains that have gone
 *  straight on are expected to: then until one leaves its course, or until the list ends. */
static void a_list_lasts_for_the_skin(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.1, false);
    scene_run(&s, 1318); // 1.2 x 1099.35 steps
    assert_int_equal(s.step.refreshes, 0);
    assert_false(s.step.near.follow);
    scene_run(&s, 2);
    assert_int_equal(s.step.refreshes, 1);
    assert_true(s.step.near.follow);
    // sqrt(47 x 2 grains x 1 us x 1.8 mm / (2 x (0.3 x 0.05 + 0.05 x 0.1) m/s x 1 pair))
    check_relative(s.step.near.horizon, 2.05670e-3, 1e-5);
    const size_t fast = faster_of(&s);
    check_relative(skin_of(&s, fast), (0.3 + 0.05) * 0.1 * 2.05670e-3, 1e-5);
    check_relative(skin_of(&s, 1 - fast), 0.05 * 0.1 * 2.05670e-3, 1e-5);
    scene_run(&s, 2055);
    assert_int_equal(s.step.refreshes, 1);
    scene_run(&s, 2);
    assert_int_equal(s.step.refreshes, 2);
    scene_move(&s, 1 - fast, 0.0, 0.0, 0.2);
    scene_run(&s, 50); // 51.4 steps
    assert_int_equal(s.step.refreshes, 2);
    scene_run(&s, 3);
    assert_int_equal(s.step.refreshes, 3);
    scene_end(&s);
}

/** Twice the candidates, and the skins are thinner by the root of two. */
static void they_are_shorter_among_many_candidates(void **state)
{
    (void)state;
    double time[2];
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
        time[k] = clod_step_skins(&s.step, 0.01).time;
        scene_end(&s);
    }
    check_relative(time[1], time[0] / sqrt(2.0), 1e-15); // none counts as one
}

/** Every pair that touches, and every grain at a wall, is on the list. */
static void check_complete(const scene *s, int *touching)
{
    const clod_neighbour *search = &s->step.neighbour;
    for (size_t i = 0; i < s->state.grains.count; i++) {
        const double *a = s->state.grains.position[i];
        size_t k = search->pairs.start[i];
        for (size_t j = i + 1; j < s->state.grains.count; j++) {
            const double *b = s->state.grains.position[j];
            const clod_domain *domain = &s->state.domain;
            const clod_vec3 apart = {clod_domain_separation(domain, 0, a[0], b[0]),
                                     clod_domain_separation(domain, 1, a[1], b[1]),
                                     clod_domain_separation(domain, 2, a[2], b[2])};
            for (; k < search->pairs.start[i + 1] && search->pairs.item[k].j < j; k++) {
            }
            const bool listed = k < search->pairs.start[i + 1] &&
                                search->pairs.item[k].j == j && search->pairs.item[k].near != 0;
            const bool touches = clod_vec3_length(apart) < a[3] + b[3];
            assert_true(listed || !touches);
            *touching += touches;
        }
        const bool at_wall = a[2] - s->state.walls.wall[0].shift.z < a[3];
        bool listed = false;
        for (size_t c = 0; c < search->walls.count; c++) {
            listed |= (size_t)search->walls.item[c].i == i && search->walls.item[c].near != 0;
        }
        assert_true(listed || !at_wall);
        *touching += at_wall;
    }
}

/** Grains that are kicked at random, over a floor that goes up and down: whatever touches has
 *  been on the list before. */
static void what_touches_is_on_the_list(void **state)
{
    (void)state;
    const int every = sanitized() ? 10 : 1; // looks between steps are code of this file
    for (int threads = sanitized() ? 2 : 1; threads <= 2; threads++) {
        const clod_case_contact ore = contact_ore();
        scene s;
        uint64_t draw = 0;
        scene_init(&s, 2.0 * DT, &ore);
        for (int g = 0; g < 64; g++) {
            const double gap = 2.3 * RADIUS;
            const int line = g / 4 % 4, layer = g / 16;
            scene_grain(&s, gap * (g % 4), gap * line, RADIUS + gap * layer, RADIUS);
        }
        clod_wall *floor = scene_wall(&s, "floor", shape_floor(0.0));
        scene_start_with(&s, (clod_step_options){.threads = threads});
        int touching = 0;
        for (int k = 0; k < 1000; k++) {
            for (int kick = 0; kick < 2; kick++) {
                double v[4];
                for (int a = 0; a < 4; a++) {
                    v[a] = clod_random_uniform(7, CLOD_RANDOM_TEST, (uint64_t)threads, draw++);
                }
                const size_t row = (size_t)(64.0 * v[3]);
                scene_move(&s, row, 2.0 * v[0] - 1.0, 2.0 * v[1] - 1.0, 2.0 * v[2] - 1.0);
            }
            floor->velocity.z = k / 100 % 2 == 0 ? 0.3 : -0.3;
            scene_run(&s, 5);
            if (k % every == 0) {
                check_complete(&s, &touching);
            }
        }
        assert_true(touching > 1000 / every);
        assert_true(s.step.refreshes > 10 && s.step.rebuilds > 3);
        assert_true(s.step.refreshes + s.step.rebuilds < 800);
        scene_end(&s);
    }
}

/** Layers of edge x edge grains that meet, in free flight and then in collisions: they follow their
 *  courses, and whatever touches has been on the list before. */
static void check_meeting(int edge, int layers, int threads, bool periodic)
{
    const clod_case_contact ore = contact_ore();
    const double gap = 2.3 * RADIUS;
    scene s;
    scene_init(&s, 2.0 * DT, &ore);
    for (int g = 0; g < edge * edge * layers; g++) {
        scene_grain(&s, gap * (g % edge), gap * (g / edge % edge),
                    RADIUS + 2.0 * gap * (g / (edge * edge)), RADIUS);
    }
    if (periodic) { // the way of 40 ms at 1 m/s is more than a period of 32 mm
        s.state.domain.periodic[0] = true;
        s.state.domain.min[0] = -0.5 * gap;
        s.state.domain.max[0] = (edge - 0.5) * gap;
    }
    scene_wall(&s, "floor", shape_floor(0.0));
    for (size_t g = 0; g < s.state.grains.count; g++) {
        const double z = s.state.grains.position[g][2];
        scene_move(&s, g, 1.0, 0.05 * clod_random_uniform(3, CLOD_RANDOM_TEST, g, 0),
                   -20.0 * z);
    }
    scene_start_with(&s, (clod_step_options){.threads = threads});
    const int every = sanitized() ? 10 : 1;
    int touching = 0, followed = 0;
    for (int k = 0; k < 1000; k++) {
        scene_run(&s, 20);
        followed += s.step.near.follow;
        if (k % every == 0) {
            check_complete(&s, &touching);
        }
    }
    assert_true(touching > 1000 / every && followed > 500);
    assert_true(s.step.refreshes > 10 && s.step.refreshes < 800);
    scene_end(&s);
}

static void what_meets_is_on_the_list(void **state)
{
    (void)state;
    if (!sanitized()) {
        check_meeting(4, 4, 1, false);
    }
    check_meeting(7, 6, 3, true); // 294 grains: several watches in each thread's part
}

/** What shakes in its place is expected to stay there. */
static void grains_that_shake_have_no_course(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.1, false);
    const size_t fast = faster_of(&s);
    for (int k = 0; k < 1200; k++) { // 1.2e-3 m of paths
        scene_move(&s, fast, 0.0, k % 2 == 0 ? 0.1 : -0.1, 0.0);
        scene_run(&s, 10);
        assert_false(s.step.near.follow);
    }
    assert_int_equal(s.step.refreshes, 0);
    assert_int_equal(s.step.rebuilds, 1); // by the sum of speeds
    scene_end(&s);
}

/** 64 grains, each with a velocity of its own. */
static void grains_that_go(scene *s)
{
    const clod_case_contact ore = contact_ore();
    scene_init(s, DT, &ore);
    for (int g = 0; g < 64; g++) {
        const double gap = 3.0 * RADIUS;
        const int line = g / 4 % 4, layer = g / 16;
        scene_grain(s, gap * (g % 4), gap * line, gap * layer, RADIUS);
    }
    for (size_t g = 0; g < 64; g++) {
        double v[3];
        for (uint64_t a = 0; a < 3; a++) {
            v[a] = clod_random_uniform(11, CLOD_RANDOM_TEST, g, a) - 0.5;
        }
        scene_move(s, g, v[0], v[1], v[2]);
    }
    scene_start(s);
}

/** Positions, courses and skins are kept in float. What is said to be left of them is never more than
 *  what is, by the positions in double, and less by no more than a millionth of the skin. */
static void never_more_is_left_than_is(void **state)
{
    (void)state;
    scene s;
    grains_that_go(&s);
    double from[64][4];
    int64_t lists = 0, checks[2] = {0, 0}, began = 0;
    const size_t size = sizeof from;
    memcpy(from, s.state.grains.position, size);
    for (int k = 0; k < 4000; k++) {
        scene_run(&s, 1);
        if (s.step.refreshes + s.step.rebuilds > lists) {
            lists = s.step.refreshes + s.step.rebuilds;
            memcpy(from, s.state.grains.position, size);
            began = s.state.step;
        }
        const double age = (double)(s.state.step - began) * DT;
        for (size_t g = 0; g < 64; g++) {
            const clod_vec3 now = clod_vec3_of(s.state.grains.position[g]);
            const float *u = s.step.near.course[g];
            const clod_vec3 course = {(double)u[0], (double)u[1], (double)u[2]};
            const clod_vec3 expected = clod_vec3_add(
                clod_vec3_of(from[g]), clod_vec3_scale(course, s.step.near.follow ? age : 0.0));
            const double off = clod_vec3_length(clod_vec3_sub(now, expected));
            const double left = skin_of(&s, g) - off;
            const clod_near_seen seen = clod_near_look(&s.step.near, &s.state, age, g, g + 1);
            assert_true(seen.left < left);
            assert_true(seen.left > left - 1e-6 * s.step.neighbour.skin);
            check_relative(seen.fastest, s.step.near.follow ? clod_vec3_length(course) : 0.0,
                           1e-15);
            checks[s.step.near.follow]++;
        }
    }
    assert_true(s.step.refreshes > 1 && s.step.rebuilds > 0);
    assert_true(checks[0] > 1000 && checks[1] > 1000);
    scene_end(&s);
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
        cmocka_unit_test(they_go_with_the_root_of_the_speed),
        cmocka_unit_test(they_have_bounds),
        cmocka_unit_test(the_first_list_knows_the_speed_of_walls),
        cmocka_unit_test(a_list_lasts_for_the_skin),
        cmocka_unit_test(they_are_shorter_among_many_candidates),
        cmocka_unit_test(what_touches_is_on_the_list),
        cmocka_unit_test(what_meets_is_on_the_list),
        cmocka_unit_test(grains_that_shake_have_no_course),
        cmocka_unit_test(never_more_is_left_than_is),
        cmocka_unit_test(the_wide_skin_goes_with_the_root_of_the_speed),
        cmocka_unit_test(the_wide_skin_is_part_of_the_state),
    };
    if (looks_for_races()) {
        cmocka_set_test_filter("what_*_is_on_the_list"); // the others have one thread
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
