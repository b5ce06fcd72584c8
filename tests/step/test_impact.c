// Which contacts with walls are impacts, against closed forms: grains thrown at known angles,
// bounces, a ball that rolls over seams between shapes and walls, a corner; any number of threads.

#include "base/memory.h"
#include "state/wear.h"
#include "support/bed.h"

#define R 3e-3
#define G 9.81
#define MASS (2481.3 * 4.1887902047863905 * 27e-9)
#define K 2e4
#define DT 1e-5

static clod_case_contact bouncy(double restitution, double friction)
{
    clod_case_contact contact = contact_elastic(1.0, K);
    contact.restitution = restitution;
    contact.friction = friction;
    return contact;
}

/** A wall of boxes side by side along x, [-0.1, 0], [0, 0.1] ..., with their tops at z = 0. */
static clod_wall *plates(scene *s, const char *name, double from, int count)
{
    clod_wall *wall =
        scene_wall(s, name, shape_box((clod_vec3){from + 0.05, 0.0, -0.05}, 0.05, 0.1, 0.05));
    if (count > 1) {
        wall->shapes = clod_memory_grow(wall->shapes, 1, (size_t)count, sizeof *wall->shapes);
        wall->shape_count = count;
        for (int k = 1; k < count; k++) {
            wall->shapes[k] =
                shape_box((clod_vec3){from + 0.05 + 0.1 * k, 0.0, -0.05}, 0.05, 0.1, 0.05);
        }
    }
    assert_true(clod_wear_begin(wall));
    return wall;
}

static const clod_impact_sums *hits(const clod_wall *wall, int face)
{
    return &clod_wear_impacts(wall, face)->all;
}

/** Grains at 5, 15 ... 85 degrees, each with its own speed: one in each class of angles. */
static void thrown_grains_are_in_their_classes(void **state)
{
    (void)state;
    clod_impacts kept[2];
    for (int threads = 1; threads <= 2; threads++) {
        scene s;
        const clod_case_contact contact = bouncy(0.8, 0.3);
        scene_init(&s, 0.1 * DT, &contact);
        double energy[9], angle[9];
        for (int g = 0; g < 9; g++) {
            const double v = 0.2 + 0.1 * g;
            angle[g] = (10.0 * g + 5.0) * M_PI / 180.0;
            energy[g] = 0.5 * MASS * v * v;
            const size_t row = scene_grain(&s, -0.09 + 0.01 * g, 0.0, R + 1e-5, R);
            scene_move(&s, row, v * cos(angle[g]), 0.0, -v * sin(angle[g]));
        }
        clod_wall *wall = plates(&s, "floor", -0.1, 1);
        scene_start_with(&s, (clod_step_options){.threads = threads});
        scene_run(&s, 3000);
        const clod_impacts *all = clod_wear_impacts(wall, 0);
        assert_true(all->all.number == 9.0);
        assert_true(wall->wear[0][CLOD_WEAR_IMPACTS] == 9.0);
        double sum = 0.0, squares = 0.0, into = 0.0;
        for (int g = 0; g < 9; g++) {
            const clod_impact_class of = clod_impacts_at_angle(all, g);
            assert_true(of.number == 1.0);
            check_relative(of.energy, energy[g], 1e-12);
            check_relative(of.normal, energy[g] * pow(sin(angle[g]), 2.0), 1e-12);
            sum += energy[g];
            into += of.normal;
            squares += of.normal * of.normal;
        }
        check_relative(all->all.energy, sum, 1e-12);
        check_relative(all->all.normal2, squares, 1e-12);
        check_relative(all->all.normal, into, 1e-12);
        check_relative(all->all.angle, 9.0 * 0.25 * M_PI, 1e-12);
        check_relative(all->all.speed, 9.0 * 0.6, 1e-12);
        check_relative(wall->wear[0][CLOD_WEAR_ENERGY], into, 1e-12);
        kept[threads - 1] = *all;
        scene_end(&s);
    }
    assert_memory_equal(&kept[0], &kept[1], sizeof kept[0]);
}

/** From h without loss: contacts at sqrt(2 h/g) (1 + 2 k), apart from the time in contact. */
static void each_bounce_is_an_impact(void **state)
{
    (void)state;
    scene s;
    const clod_case_contact contact = bouncy(1.0, 0.0);
    scene_init(&s, DT, &contact);
    s.state.gravity[2] = -G;
    const double h = 0.005;
    scene_grain(&s, -0.05, 0.0, R + h, R);
    clod_wall *wall = plates(&s, "floor", -0.1, 1);
    scene_start(&s);
    // the fifth hit comes at 9 fall times and four times in contact, pi sqrt(m/k)
    const double fall = sqrt(2.0 * h / G), touch = M_PI * sqrt(MASS / K);
    scene_run(&s, (int64_t)((10.0 * fall + 4.5 * touch) / DT));
    assert_true(hits(wall, 0)->number == 5.0);
    check_relative(hits(wall, 0)->energy, 5.0 * MASS * G * h, 0.01);
    scene_end(&s);
}

/** A grain lies where it was set down: it hits once, and is in contact from then on. */
static void lasting_contact_is_one_impact(void **state)
{
    (void)state;
    scene s;
    const clod_case_contact contact = bouncy(0.05, 0.3);
    scene_init(&s, DT, &contact);
    s.state.gravity[2] = -G;
    scene_grain(&s, -0.05, 0.0, R + 1e-9, R);
    clod_wall *wall = plates(&s, "floor", -0.1, 1);
    scene_start(&s);
    scene_run(&s, 5000);
    assert_true(hits(wall, 0)->number == 1.0);
    check_relative(wall->wear[0][CLOD_WEAR_PRESS], MASS * G * 0.05, 0.02);
    scene_end(&s);
}

/** A ball comes down on the first of three plates and rolls over the seams: one impact. */
static void rolling_over_seams_is_none(void **state)
{
    (void)state;
    scene s;
    const clod_case_contact contact = bouncy(0.05, 0.5);
    scene_init(&s, DT, &contact);
    s.state.gravity[2] = -G;
    const double v = 1.0;
    scene_grain(&s, -0.02, 0.0, R + 1e-9, R);
    scene_move(&s, 0, v, 0.0, 0.0);
    scene_turn(&s, 0, 0.0, v / R, 0.0);
    clod_wall *two = plates(&s, "two", -0.1, 2);
    clod_wall *far = plates(&s, "far", 0.1, 1);
    two = &s.state.walls.wall[0];
    scene_start(&s);
    scene_run(&s, 15000); // 0.15 m
    check_at_least(s.state.grains.position[0][0], 0.12);
    assert_true(hits(two, 0)->number == 1.0);
    assert_true(hits(two, 1)->number == 0.0);
    assert_true(hits(far, 0)->number == 0.0);
    check_at_least(two->wear[1][CLOD_WEAR_PRESS], 0.9 * MASS * G * 0.1); // it was there
    check_at_least(far->wear[0][CLOD_WEAR_PRESS], 0.9 * MASS * G * 0.02);
    scene_end(&s);
}

/** Straight down onto the seam of two plates, which it meets in the same step: one impact. */
static void a_hit_on_a_seam_is_one(void **state)
{
    (void)state;
    scene s;
    const clod_case_contact contact = bouncy(1.0, 0.0);
    scene_init(&s, 0.1 * DT, &contact);
    scene_grain(&s, 0.0, 0.0, R + 1e-5, R);
    scene_move(&s, 0, 0.0, 0.0, -0.3);
    clod_wall *wall = plates(&s, "two", -0.1, 2);
    scene_start(&s);
    scene_run(&s, 2000);
    check_at_least(s.state.grains.velocity[0][2], 0.2); // it is gone
    assert_true(hits(wall, 0)->number + hits(wall, 1)->number == 1.0);
    check_relative(hits(wall, 0)->energy + hits(wall, 1)->energy, 0.5 * MASS * 0.09, 1e-12);
    scene_end(&s);
}

/** A grain that is pressed in when the run begins, and on its way out, does not hit. */
static void a_grain_that_leaves_does_not_hit(void **state)
{
    (void)state;
    scene s;
    const clod_case_contact contact = bouncy(1.0, 0.0);
    scene_init(&s, 0.1 * DT, &contact);
    scene_grain(&s, -0.05, 0.0, R - 1e-6, R);
    scene_move(&s, 0, 0.0, 0.0, 0.1);
    clod_wall *wall = plates(&s, "floor", -0.1, 1);
    scene_start(&s);
    scene_run(&s, 100);
    check_at_least(wall->wear[0][CLOD_WEAR_PRESS], 1e-9); // it touched
    assert_true(hits(wall, 0)->number == 0.0);
    assert_true(wall->wear[0][CLOD_WEAR_IMPACTS] == 0.0);
    scene_end(&s);
}

/** A grain that lies on a plate and slides against an upright one hits that, head on. */
static void a_corner_is_hit(void **state)
{
    (void)state;
    scene s;
    const clod_case_contact contact = bouncy(0.05, 0.0);
    scene_init(&s, DT, &contact);
    s.state.gravity[2] = -G;
    scene_grain(&s, -0.02, 0.0, R + 1e-9, R);
    scene_move(&s, 0, 0.5, 0.0, 0.0);
    plates(&s, "floor", -0.1, 1);
    clod_wall *end =
        scene_wall(&s, "end", shape_box((clod_vec3){0.05, 0.0, 0.1}, 0.05, 0.1, 0.1));
    assert_true(clod_wear_begin(end));
    scene_start(&s);
    scene_run(&s, 5000);
    assert_true(hits(end, 0)->number == 1.0);
    check_relative(hits(end, 0)->energy, 0.5 * MASS * 0.25, 1e-3);
    check_relative(hits(end, 0)->angle, 0.5 * M_PI, 1e-2);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thrown_grains_are_in_their_classes),
        cmocka_unit_test(each_bounce_is_an_impact),
        cmocka_unit_test(lasting_contact_is_one_impact),
        cmocka_unit_test(rolling_over_seams_is_none),
        cmocka_unit_test(a_hit_on_a_seam_is_one),
        cmocka_unit_test(a_grain_that_leaves_does_not_hit),
        cmocka_unit_test(a_corner_is_hit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
