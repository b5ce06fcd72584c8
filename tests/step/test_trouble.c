// What a run says when physics goes wrong: exact texts, with the grain and the step.

#include <float.h>

#include "support/bed.h"

static void expect(scene *s, int64_t steps, clod_code code, const char *text)
{
    clod_status status = {0};
    assert_false(clod_step_advance(&s->step, steps, &status));
    assert_string_equal(status.text, text);
    assert_int_equal(status.code, code);
}

static void expect_at_start(scene *s, clod_step_options options, clod_code code,
                            const char *text)
{
    clod_status status = {0};
    assert_false(clod_step_init(&s->step, &s->state, &s->laws, &options, &status));
    assert_string_equal(status.text, text);
    assert_int_equal(status.code, code);
    scene_end(s);
}

static void two_grains(scene *s, double apart)
{
    const clod_case_contact contact = contact_ore();
    scene_init(s, 1e-6, &contact);
    scene_grain(s, 0.0, 0.0, 0.0, 3e-3);
    scene_grain(s, apart, 0.0, 0.0, 3e-3);
}

static void an_unknown_instruction_set(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.01);
    expect_at_start(&s, (clod_step_options){.threads = 1, .simd = "mmx"}, CLOD_USAGE,
                    "instruction set 'mmx' is unknown or not in this machine; use scalar, "
                    "avx2, avx512 or neon, or leave it out for the best");
}

/** 4 R + 2 skin, skin 0.3 R, R = 3 mm: 13.8 mm. */
static void a_period_that_is_too_short(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.008);
    s.state.domain.periodic[1] = true;
    s.state.domain.min[1] = 0.0;
    s.state.domain.max[1] = 0.0138;
    expect_at_start(&s, (clod_step_options){.threads = 1}, CLOD_USAGE,
                    "domain: the period along y is 0.0138 m, but a grain would meet its own "
                    "neighbours twice; at least 0.0138 m is needed for these grains");
    two_grains(&s, 0.008);
    s.state.domain.periodic[1] = true;
    s.state.domain.min[1] = 0.0;
    s.state.domain.max[1] = 0.0139;
    scene_start(&s);
    scene_end(&s);
}

static void a_grain_outside_at_the_start(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.01);
    s.state.domain.min[2] = 0.001;
    expect_at_start(&s, (clod_step_options){.threads = 1}, CLOD_FAILED,
                    "step 0: grain 0 has left the domain: z = 0 m, allowed 0.001 to 10 m; "
                    "enlarge domain, close the gap in the walls, take a smaller time step, or "
                    "set domain.open: delete");
}

static void a_position_that_is_not_a_number(void **state)
{
    (void)state;
    for (int periodic = 0; periodic < 2; periodic++) {
        scene s;
        two_grains(&s, 0.01);
        s.state.domain.periodic[0] = periodic == 1;
        s.state.grains.position[1][0] = NAN;
        expect_at_start(
            &s, (clod_step_options){.threads = 1}, CLOD_FAILED,
            "step 0: grain 1 has left the domain: x = nan m, allowed -10 to 10 m; "
            "enlarge domain, close the gap in the walls, take a smaller time step, or "
            "set domain.open: delete");
    }
}

/** The domain is looked at when the grains are sorted: when the wide skin is used up. */
static void a_grain_that_leaves(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 2; threads++) {
        scene s;
        two_grains(&s, 0.01);
        scene_move(&s, 1, 1.0, 0.0, 0.0);
        s.state.domain.max[0] = 0.0103;
        scene_start_with(&s, (clod_step_options){.threads = threads});
        // skin 0.9 mm: rebuilt after more than 0.45 mm, in step 450 or 451 by rounding
        clod_status status = {0};
        assert_false(clod_step_advance(&s.step, 1000, &status));
        assert_non_null(strstr(status.text,
                               "grain 1 has left the domain: x = 0.01045 m, allowed -10 to "
                               "0.0103 m; enlarge domain, close the gap in the walls, take a "
                               "smaller time step, or set domain.open: delete"));
        assert_in_range(s.state.step, 449, 451);
        scene_end(&s);
    }
}

/** 10 m/s against 3 mm: an overlap of 20 % of 3 mm is reached at 0.6 mm. */
static void an_overlap_beyond_the_laws(void **state)
{
    (void)state;
    for (int k = 0; k < 2 * 2; k++) {
        const int threads = 1 + k / 2;
        scene s;
        two_grains(&s, 0.0061);
        for (int l = 0; l < SCENE_LAWS; l++) {
            s.law[l].k1 = s.law[l].k2 = 1.0; // nothing holds it back
        }
        scene_move(&s, 1, -10.0, 0.0, 0.0);
        scene_start_with(&s, (clod_step_options){.threads = threads});
        // 0.1 mm free, then 0.6 mm: beyond after 0.7 mm, 71 steps of 10 um; it stops one step
        // later, in one call or in a call for each step
        clod_status status = {0};
        while (clod_step_advance(&s.step, k % 2 == 0 ? 1000 : 1, &status)) {
            assert_true(s.state.step < 71);
        }
        assert_in_range(s.state.step, 71, 72);
        const int beyond = (int)s.state.step - 1;
        char text[600];
        // nothing holds it back: k1 d^1.5 = (0.6 mm)^1.5 = 1.47e-5 N (1.51e-5 at 0.61 mm), and
        // a critical step of 0.066 s (3.5 times 1.5 d^0.5 on half the mass of the ore, 1.4e-4
        // kg)
        snprintf(
            text, sizeof text,
            "step %d: grain 0 overlaps grain 1 by %s %% of the radius of the smaller one; "
            "time.overlap_limit is 20 %%. The time step is not the reason (%s of the "
            "critical step of this contact): it is too soft for its load, some %s N. Raise "
            "its k1 (and k2), lower the load or the speed, or, if so deep a contact is "
            "meant, raise time.overlap_limit",
            beyond, beyond == 70 ? "20.0" : "20.3", "1.5e-05",
            beyond == 70 ? "1.47e-05" : "1.51e-05");
        assert_string_equal(status.text, text);
        scene_end(&s);
    }
}

/** Of 3 mm and 1 mm, or of 1 mm and a wall, the smaller radius counts, in every set. */
static void the_limit_is_of_the_smaller_radius(void **state)
{
    (void)state;
    static const char *const SETS[] = {"scalar", "avx2", "avx512", "neon"};
    const double limits[] = {0.0, 0.1, 0.4, 0.9}; // 0: 20 %
    for (int k = 0; k < 4 * 4 * 2 * 2; k++) {
        const char *set = SETS[k / 16];
        const double limit = limits[k / 4 % 4];
        const bool beyond = k / 2 % 2 == 1, wall = k % 2 == 1;
        const double overlap = 1e-3 * ((limit > 0.0 ? limit : 0.2) + (beyond ? 0.01 : -0.01));
        if (clod_kernel_choose(set) == NULL) {
            continue;
        }
        const clod_case_contact contact = contact_ore();
        scene s;
        clod_status status = {0};
        scene_init(&s, 1e-6, &contact);
        scene_grain(&s, 0.0, 0.0, 0.0, 1e-3);
        scene_grain(&s, wall ? 0.01 : 4e-3 - overlap, 0.0, 0.0, 3e-3);
        if (wall) {
            scene_wall(&s, "the floor", shape_floor(overlap - 1e-3));
        }
        const clod_step_options options = {.threads = 1, .simd = set, .overlap_limit = limit};
        s.state.grains.position[1][2] = wall ? 0.01 : 0.0;
        assert_int_equal(clod_step_init(&s.step, &s.state, &s.laws, &options, &status),
                         !beyond);
        char share[32];
        snprintf(share, sizeof share, "by %.1f %% of the radius", 1e5 * overlap);
        assert_true(!beyond || strstr(status.text, share) != NULL);
        scene_end(&s);
    }
}

// By hand: 1 mm a step, so 0.3 mm apart becomes 0.7 mm deep at once. Critical there: 2
// sqrt(m*/k) with m* = 1.40314e-4 kg and k = 1.5 * 2.37e9 sqrt(0.7e-3) = 9.4057e7 N/m: 2.44e-6
// s.
static void a_step_that_is_too_large_is_told(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.0063);
    s.state.dt = 1e-4;
    scene_move(&s, 1, -10.0, 0.0, 0.0);
    scene_start(&s);
    expect(&s, 1000, CLOD_FAILED,
           "step 1: grain 0 overlaps grain 1 by 23.3 % of the radius of the smaller one; "
           "time.overlap_limit is 20 %. The time step, 0.0001 s, is too large: 41 of the "
           "critical step of this contact as deep as it is, 2.44e-06 s. Take time.step: auto, "
           "or at most 2.4e-07 s; when it is auto, time.design_stress for the load that comes");
    scene_end(&s);
}

/** Every number of a speed or spin, in every set, of an early and a late grain. */
static void every_number_that_is_not_finite_is_seen(void **state)
{
    (void)state;
    static const char *const SETS[] = {"scalar", "avx2", "avx512", "neon"};
    const double bad[] = {NAN, INFINITY, -INFINITY, 1e31};
    for (int k = 0; k < 4 * 2 * 2 * 3 * 4; k++) {
        const char *set = SETS[k / 48];
        const size_t grain = (size_t)(k / 24 % 2);
        const int spin = k / 12 % 2, axis = k / 4 % 3;
        if (clod_kernel_choose(set) == NULL) {
            continue;
        }
        scene s;
        two_grains(&s, 0.01);
        scene_start_with(&s, (clod_step_options){.threads = 1, .simd = set});
        scene_run(&s, 1); // nothing is wrong yet
        double *row =
            spin ? s.state.grains.angular_velocity[grain] : s.state.grains.velocity[grain];
        row[axis] = bad[k % 4];
        clod_status status = {0};
        assert_false(clod_step_advance(&s.step, 1, &status));
        assert_int_equal(status.code, CLOD_FAILED);
        scene_end(&s);
    }
}

static void an_overlap_with_a_wall_at_the_start(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.01);
    scene_wall(&s, "the floor", shape_floor(-0.00225));
    expect_at_start(
        &s, (clod_step_options){.threads = 1}, CLOD_FAILED,
        "step 0: grain 0 overlaps wall 'the floor' by 25.0 % of the radius; "
        "time.overlap_limit is 20 %. They are put so: move them apart. If so deep a "
        "contact is meant, raise time.overlap_limit");
}

/** A state of another run, whose forces are found anew, is one that was put so. */
static void an_overlap_at_the_start_of_a_later_run(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.01);
    scene_wall(&s, "the floor", shape_floor(-0.00225));
    s.state.step = 41;
    expect_at_start(
        &s, (clod_step_options){.threads = 1}, CLOD_FAILED,
        "step 41: grain 0 overlaps wall 'the floor' by 25.0 % of the radius; "
        "time.overlap_limit is 20 %. They are put so: move them apart. If so deep a "
        "contact is meant, raise time.overlap_limit");
}

/** Without a direction between them, and still named. */
static void two_grains_in_one_place(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.0);
    expect_at_start(&s, (clod_step_options){.threads = 1}, CLOD_FAILED,
                    "step 0: grain 0 overlaps grain 1 by 200.0 % of the radius of the smaller "
                    "one; time.overlap_limit is 20 %. They are put so: move them apart");
}

// The key goes up to 90 %: of a radius of 3 mm, 2.7 mm.
static void a_limit_is_named_only_where_it_can_be_raised_so_far(void **state)
{
    (void)state;
    for (int beyond = 0; beyond < 2; beyond++) {
        scene s;
        clod_status status = {0};
        two_grains(&s, 6e-3 - (beyond ? 2.73e-3 : 2.67e-3));
        const clod_step_options options = {.threads = 1};
        assert_false(clod_step_init(&s.step, &s.state, &s.laws, &options, &status));
        assert_non_null(strstr(status.text, beyond ? "by 91.0 %" : "by 89.0 %"));
        assert_int_equal(strstr(status.text, "raise time.overlap_limit") != NULL, !beyond);
        scene_end(&s);
    }
}

/** As above, 10 m/s against what nothing holds back, but stopped by the highest limit. */
static void the_highest_limit_is_not_to_be_raised(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.0061);
    for (int l = 0; l < SCENE_LAWS; l++) {
        s.law[l].k1 = s.law[l].k2 = 1.0;
    }
    scene_move(&s, 1, -10.0, 0.0, 0.0);
    scene_start_with(&s, (clod_step_options){.threads = 1, .overlap_limit = 0.9});
    clod_status status = {0};
    assert_false(clod_step_advance(&s.step, 1000, &status));
    assert_in_range(s.state.step, 281,
                    282); // 0.1 mm free, then 2.7 mm, 10 um a step, and one more
    assert_non_null(strstr(status.text, "time.overlap_limit is 90 %. The time step is not"));
    const char *end = strstr(status.text, "Raise its k1");
    assert_non_null(end);
    assert_string_equal(end, "Raise its k1 (and k2), lower the load or the speed");
    scene_end(&s);
}

/** A lid comes down to 4.8 mm above a floor: 20 % of 3 mm on both sides, whatever the stiffness. */
static void a_grain_between_two_walls(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_ore();
    scene s;
    clod_status status = {0};
    scene_init(&s, 5e-7, &contact);
    scene_grain(&s, 0.0, 0.0, 0.0, 3e-3);
    scene_wall(&s, "floor", shape_floor(-3e-3));
    clod_wall *lid = scene_wall(
        &s, "lid", shape_plane((clod_vec3){0.0, 0.0, 3e-3}, (clod_vec3){0.0, 0.0, -1.0}));
    lid->velocity.z = -0.1;
    scene_start(&s);
    assert_false(clod_step_advance(&s.step, 30000, &status));
    assert_in_range(s.state.step, 23500, 24100); // 1.2 mm at 0.05 um a step
    assert_non_null(strstr(status.text, "It is caught between walls '"));
    assert_non_null(strstr(status.text, "'floor'"));
    assert_non_null(strstr(status.text, "'lid'"));
    assert_non_null(strstr(status.text, "change how they move. If so deep a contact is meant"));
    scene_end(&s);
}

static void a_velocity_that_is_not_a_number(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 2; threads++) {
        scene s;
        two_grains(&s, 0.01);
        s.state.grains.velocity[1][2] = NAN;
        s.state.step = 41;
        scene_start_with(&s, (clod_step_options){.threads = threads});
        expect(
            &s, 1000, CLOD_FAILED,
            "step 42: position, velocity or spin of grain 1 is not a finite number; the time "
            "step (1e-06 s) is most likely too large, see clod check");
        scene_end(&s);
    }
}

static void a_spin_without_bounds(void **state)
{
    (void)state;
    scene s;
    two_grains(&s, 0.01);
    scene_turn(&s, 0, 0.0, DBL_MAX, 0.0);
    scene_start(&s);
    expect(&s, 1000, CLOD_FAILED,
           "step 1: position, velocity or spin of grain 0 is not a finite number; the time "
           "step (1e-06 s) is most likely too large, see clod check");
    scene_end(&s);
}

/** A time step far too long must end in one of the texts, never in silence or a crash. */
static void a_time_step_far_too_long_is_found_out(void **state)
{
    (void)state;
    const double steps[] = {1e-4, 1e-3, 1e-2, 1.0};
    for (int kind = 0; kind < BED_KINDS; kind++) {
        for (int k = 0; k < 4; k++) {
            scene s;
            clod_status status = {0};
            bed_init(&s, (bed_kind)kind, 4);
            s.state.dt = steps[k];
            scene_start_with(&s, (clod_step_options){.threads = 1 + k % 2});
            assert_false(clod_step_advance(&s.step, 20000, &status));
            assert_int_equal(status.code, CLOD_FAILED);
            assert_int_equal(strncmp(status.text, "step ", 5), 0);
            scene_end(&s);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_unknown_instruction_set),
        cmocka_unit_test(a_period_that_is_too_short),
        cmocka_unit_test(a_grain_outside_at_the_start),
        cmocka_unit_test(a_position_that_is_not_a_number),
        cmocka_unit_test(a_grain_that_leaves),
        cmocka_unit_test(an_overlap_beyond_the_laws),
        cmocka_unit_test(the_limit_is_of_the_smaller_radius),
        cmocka_unit_test(a_step_that_is_too_large_is_told),
        cmocka_unit_test(every_number_that_is_not_finite_is_seen),
        cmocka_unit_test(an_overlap_with_a_wall_at_the_start),
        cmocka_unit_test(an_overlap_at_the_start_of_a_later_run),
        cmocka_unit_test(two_grains_in_one_place),
        cmocka_unit_test(a_limit_is_named_only_where_it_can_be_raised_so_far),
        cmocka_unit_test(the_highest_limit_is_not_to_be_raised),
        cmocka_unit_test(a_grain_between_two_walls),
        cmocka_unit_test(a_velocity_that_is_not_a_number),
        cmocka_unit_test(a_spin_without_bounds),
        cmocka_unit_test(a_time_step_far_too_long_is_found_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
