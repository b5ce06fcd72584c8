// What the keys of the plate's ridges come to. Expected by hand, as told at each test.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "config/wall_ridges.h"
#include "support/check.h"

#define PI 3.14159265358979323846

static clod_case_wall_friction ring_of(clod_case_ridges ridges)
{
    return (clod_case_wall_friction){.cell = CLOD_CASE_CELL_RING,
                                     .inner_radius = 0.03,
                                     .outer_radius = 0.06,
                                     .plate_ridges = ridges};
}

/** Two stresses of 10 mm each at 40 mm/s, blocks of 1 mm. */
static clod_case_wall_friction disc_of(clod_case_ridges ridges, double shear_max)
{
    return (clod_case_wall_friction){.cell = CLOD_CASE_CELL_STRAIGHT,
                                     .inner_radius = 0.05, // has no meaning
                                     .outer_radius = 0.03,
                                     .plate_ridges = ridges,
                                     .wall_stress_count = 2,
                                     .speed = 0.04,
                                     .block_displacement = 1e-3,
                                     .shear_max = shear_max};
}

static void without_a_height_there_are_none(void **state)
{
    (void)state;
    const clod_case_wall_friction ring = ring_of((clod_case_ridges){0});
    const clod_wall_ridges none = clod_wall_ridges_of(&ring);
    assert_true(none.count == 0 && none.volume == 0.0 && none.height == 0.0);
}

// r_m = 2/3 (60^3 - 30^3)/(60^2 - 30^2) mm = 140/3 mm, round it 293.2153 mm: 48.87 times 6 mm, so
// 49 ridges; they meet on a circle of 30 mm, chords of which are 60 mm sin(pi/49) = 3.844215 mm.
// Volume: 49 triangles of 2 mm by that, 30 mm long in the middle; beside it longer by
// y^2/2 (1/30 - 1/60) mm, where y^2 is w^2/24 on average: 1.000171 times as much.
static void a_ring_has_a_whole_number_that_meet_at_its_inner_wall(void **state)
{
    (void)state;
    const clod_case_wall_friction ring =
        ring_of((clod_case_ridges){.height = 2e-3, .spacing = 6e-3});
    const clod_wall_ridges r = clod_wall_ridges_of(&ring);
    assert_int_equal(r.count, 49);
    check_relative(r.spacing, 293.2153143e-3 / 49.0, 1e-9);
    check_relative(r.room, 60e-3 * sin(PI / 49.0), 1e-14);
    assert_true(r.width == r.room);
    check_relative(r.from, 30e-3 * cos(PI / 49.0), 1e-14);
    check_relative(tan(r.flank), 4.0 / (60.0 * sin(PI / 49.0)), 1e-12);
    check_relative(r.volume, 49.0 * 0.5 * 2e-3 * r.width * 30e-3 * 1.000171, 1e-6);
}

static void narrower_ridges_begin_at_the_inner_wall(void **state)
{
    (void)state;
    const clod_case_wall_friction ring = ring_of(
        (clod_case_ridges){.height = 2e-3, .spacing = 6e-3, .width = 2e-3, .crest = 2e-3});
    const clod_wall_ridges r = clod_wall_ridges_of(&ring);
    check_relative(r.from, sqrt(900.0 - 1.0) * 1e-3, 1e-14);
    check_relative(r.flank, 0.5 * PI, 1e-14); // an upright bar
    check_relative(r.volume, 49.0 * 2e-3 * 2e-3 * 30e-3, 1e-3);
}

// The plate reaches one spacing before the disc and behind it, and one or more whole diameters of
// 60 mm further behind: 60 mm for a way of 29.1 mm, 120 mm for one of 109.1 mm.
static void a_straight_plate_is_as_long_as_it_moves(void **state)
{
    (void)state;
    const clod_case_ridges ridges = {.height = 1e-3, .spacing = 5e-3};
    const clod_case_wall_friction near = disc_of(ridges, 0.010), far = disc_of(ridges, 0.050);
    check_close(clod_wall_ridges_way(&near), 29.07e-3, 0.01e-3);
    check_close(clod_wall_ridges_way(&far), 109.07e-3, 0.01e-3);
    const clod_wall_ridges a = clod_wall_ridges_of(&near), b = clod_wall_ridges_of(&far);
    assert_int_equal(a.count, (70 + 60) / 5);
    assert_int_equal(b.count, (70 + 120) / 5);
    check_relative(a.to, 35e-3, 1e-14);
    assert_true(a.to == b.to);
    check_relative(a.from, -95e-3, 1e-12);
    assert_true(a.spacing == 5e-3 && a.width == 5e-3);
    check_relative(a.volume, PI * 9e-4 * 0.5e-3, 1e-12); // half of the height, everywhere
    check_relative(tan(a.flank), 0.4, 1e-12);
}

// Flanks 1 mm high over 2.5 mm: all of the height within 5 mm, 0.4 mm within 1 mm.
static void roughness_is_that_within_a_grains_diameter(void **state)
{
    (void)state;
    const clod_case_wall_friction disc =
        disc_of((clod_case_ridges){.height = 1e-3, .spacing = 5e-3}, 0.01);
    const clod_wall_ridges r = clod_wall_ridges_of(&disc);
    check_relative(clod_wall_ridges_roughness(&r, 5e-3), 0.2, 1e-12);
    check_relative(clod_wall_ridges_roughness(&r, 1e-3), 0.4, 1e-12);
}

// Flanks of tan a = 0.4: the centre is r/cos a = r sqrt(1.16) above the line where they meet, so a
// ball of 5 mm sinks 1 mm + 5 mm (1 - sqrt(1.16)) = 0.61484 mm, one of 2 mm 0.84593 mm. Between bars
// with 5 mm in the clear one of 5 mm hangs on two edges, 5 mm - sqrt(25 - 2.5^2) mm = 0.66987 mm deep,
// and one of 2 mm lies on the floor.
static void what_a_grain_feels_is_how_deep_it_sinks(void **state)
{
    (void)state;
    const clod_case_wall_friction edges =
        disc_of((clod_case_ridges){.height = 1e-3, .spacing = 5e-3}, 0.01);
    const clod_case_wall_friction bars = disc_of(
        (clod_case_ridges){.height = 1e-3, .spacing = 7e-3, .width = 2e-3, .crest = 2e-3},
        0.01);
    const clod_wall_ridges a = clod_wall_ridges_of(&edges), b = clod_wall_ridges_of(&bars);
    check_close(clod_wall_ridges_sink_depth(&a, 5e-3), 0.61484e-3, 1e-8);
    check_close(clod_wall_ridges_sink_depth(&a, 2e-3), 0.84593e-3, 1e-8);
    check_close(clod_wall_ridges_sink_depth(&b, 5e-3), 0.66987e-3, 1e-8);
    check_close(clod_wall_ridges_sink_depth(&b, 2e-3), 1e-3, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_height_there_are_none),
        cmocka_unit_test(a_ring_has_a_whole_number_that_meet_at_its_inner_wall),
        cmocka_unit_test(narrower_ridges_begin_at_the_inner_wall),
        cmocka_unit_test(a_straight_plate_is_as_long_as_it_moves),
        cmocka_unit_test(roughness_is_that_within_a_grains_diameter),
        cmocka_unit_test(what_a_grain_feels_is_how_deep_it_sinks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
