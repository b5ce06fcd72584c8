// The rows of the shear testers: each is found by its number and by the case that has it.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "tester/shear_tester.h"

// Keys from the manual; numbers as checkpoints of format 9 have them: 0 ring, 1 Jenike.
static void a_tester_is_found_by_number_and_by_case(void **state)
{
    (void)state;
    static const char *const KEYS[CLOD_RING_SHEAR_KINDS] = {"ring_shear", "jenike"};
    for (int kind = 0; kind < CLOD_RING_SHEAR_KINDS; kind++) {
        const clod_ring_shear test = {.kind = kind};
        const clod_case from = {.ring_shear.present = kind == 0, .jenike.present = kind == 1};
        const clod_shear_tester *tester = clod_shear_tester_of(&test);
        assert_string_equal(tester->key, KEYS[kind]);
        assert_int_equal(tester->kind, kind);
        assert_ptr_equal(clod_shear_tester_of_case(&from), tester);
    }
}

/** The procedure calls all of a row; only twists may be missing, as then the cell has none. */
static void rows_are_complete(void **state)
{
    (void)state;
    for (int kind = 0; kind < CLOD_RING_SHEAR_KINDS; kind++) {
        const clod_ring_shear test = {.kind = kind};
        const clod_shear_tester *t = clod_shear_tester_of(&test);
        assert_true(t->describe != NULL && t->speed != NULL && t->set_speed != NULL);
        assert_true(t->is_at_speed != NULL && t->shear_plane != NULL && t->read != NULL);
        assert_true(t->is_back != NULL && t->lid_meets != NULL && t->if_no_bed != NULL);
        assert_true(t->if_not_steady != NULL && t->to_reverse != NULL);
        assert_true(t->to_go_further != NULL);
    }
}

// Grains of 1, 2, 4 and 8 kg at 15, 25, 36 and 50 mm; lid at 45 - 5 mm, tips of its bars at 34
// mm. Above the tips 12 kg, above the rings' plane at 20 mm 14 kg; 10 m/s2 on 0.01 m2.
static void solid_above_the_shear_plane_is_counted(void **state)
{
    (void)state;
    double place[4][4] = {{0, 0, 0.015}, {0, 0, 0.025}, {0, 0, 0.036}, {0, 0, 0.050}};
    double motion[4][4] = {{0, 0, 0, 1}, {0, 0, 0, 2}, {0, 0, 0, 4}, {0, 0, 0, 8}};
    clod_wall lid = {.name = "lid", .shift.z = -0.005};
    const clod_state now = {.grains = {.position = place, .velocity = motion, .count = 4},
                            .walls = {.wall = &lid, .count = 1},
                            .gravity = {0.0, 0.0, -10.0}};
    clod_ring_shear test = {
        .area = 0.01, .lid_start = 0.045, .bar_height = 0.006, .base_height = 0.02};
    test.kind = CLOD_RING_SHEAR_RING;
    assert_true(fabs(clod_shear_tester_solid_above(&test, &now) - 12e3) < 1e-9);
    test.kind = CLOD_RING_SHEAR_JENIKE;
    assert_true(fabs(clod_shear_tester_solid_above(&test, &now) - 14e3) < 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tester_is_found_by_number_and_by_case),
        cmocka_unit_test(rows_are_complete),
        cmocka_unit_test(solid_above_the_shear_plane_is_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
