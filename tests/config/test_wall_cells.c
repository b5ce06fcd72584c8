// The table of the cells of the wall friction test. Expected by hand: an annulus of 30 mm to
// 50 mm is 20 mm wide with pi (25 - 9) 1e-4 m2; a disc of 50 mm radius is 100 mm wide with
// pi 25e-4 m2, and what the case says of inner radius and bars does not count there.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "config/wall_cells.h"
#include "support/check.h"

#define PI 3.14159265358979323846

static clod_case_wall_friction cell_of(int kind)
{
    return (clod_case_wall_friction){
        .cell = kind, .inner_radius = 0.03, .outer_radius = 0.05, .bar_count = 20};
}

static void a_ring_is_an_annulus_with_bars(void **state)
{
    (void)state;
    const clod_case_wall_friction ring = cell_of(CLOD_CASE_CELL_RING);
    assert_string_equal(CLOD_WALL_CELL_NAMES[CLOD_CASE_CELL_RING], "ring");
    assert_true(clod_wall_cell_of(&ring)->turns);
    check_relative(clod_wall_cell_inner(&ring), 0.03, 0.0);
    check_relative(clod_wall_cell_width(&ring), 0.02, 1e-15);
    check_relative(clod_wall_cell_area(&ring), PI * 16e-4, 1e-14);
    assert_int_equal(clod_wall_cell_bars(&ring), 20);
}

static void a_straight_cell_is_a_disc_without_bars(void **state)
{
    (void)state;
    const clod_case_wall_friction disc = cell_of(CLOD_CASE_CELL_STRAIGHT);
    assert_string_equal(CLOD_WALL_CELL_NAMES[CLOD_CASE_CELL_STRAIGHT], "straight");
    assert_null(CLOD_WALL_CELL_NAMES[CLOD_CASE_CELL_STRAIGHT + 1]);
    assert_false(clod_wall_cell_of(&disc)->turns);
    assert_true(clod_wall_cell_inner(&disc) == 0.0);
    check_relative(clod_wall_cell_width(&disc), 0.1, 1e-15);
    check_relative(clod_wall_cell_area(&disc), PI * 25e-4, 1e-14);
    assert_int_equal(clod_wall_cell_bars(&disc), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ring_is_an_annulus_with_bars),
        cmocka_unit_test(a_straight_cell_is_a_disc_without_bars),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
