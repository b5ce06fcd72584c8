// The table of kinds of case in src/sim: each row is full, and says the same as those of
// src/config.

#include "sim/testers.h"

#include <string.h>

#include "config/testers.h"
#include "support/check.h"

static void what_runs_can_be_tried_and_estimated(void **state)
{
    (void)state;
    for (int k = 0; k < CLOD_CASE_KINDS; k++) {
        const clod_tester_row *row = clod_testers_row((clod_case_kind)k);
        const bool runs = k != CLOD_CASE_CONTACT_BENCH; // clod contact runs it
        assert_true((row->run != NULL) == runs);
        assert_true((row->try_origin != NULL) == runs);
        assert_true((row->first != NULL) == runs);
        assert_true((row->batches != NULL) == runs);
        if (runs) {
            assert_true(row->first->procedure.size > 0);
            assert_non_null(row->first->procedure.plan);
            assert_non_null(row->first->procedure.sample);
            assert_non_null(row->first->begin);
        }
    }
}

/** What makes a cell is a test of several parts, with a text of its own in the preflight. */
static void a_tester_has_its_preflight(void **state)
{
    (void)state;
    for (int k = 0; k < CLOD_CASE_KINDS; k++) {
        const clod_tester_row *row = clod_testers_row((clod_case_kind)k);
        const clod_config_tester *section = &CLOD_CONFIG_TESTER[k];
        assert_true((row->look != NULL) == section->cell);
        assert_true((row->warn != NULL) == section->cell);
        assert_true((row->stress != NULL) == section->cell);
        assert_true((row->write != NULL) == section->cell);
        assert_true((row->put != NULL) == section->cell);
        assert_true((row->cell != NULL) == (section->programme != NULL));
        if (section->cell) {
            assert_non_null(row->first->adopt);
            assert_non_null(row->first->procedure.columns);
        }
    }
}

/** By hand: bars are the ring's, twists the Jenike cell's: 3 of 10 degrees to each side and
 *  back, of an edge 30 mm from the axis at 1 mm/s. */
static void a_cell_is_that_of_the_case(void **state)
{
    (void)state;
    clod_case from = {.ring_shear = {.present = true,
                                     .grain_material = "ore",
                                     .inner_radius = 0.03,
                                     .outer_radius = 0.05,
                                     .depth = 0.02,
                                     .bar_count = 20,
                                     .bar_height = 0.004}};
    clod_shear_cell cell = clod_shear_cell_of(&from);
    assert_string_equal(cell.key, "ring_shear");
    assert_string_equal(cell.grain_material, "ore");
    assert_ptr_equal(cell.programme, &from.ring_shear.programme);
    assert_int_equal(cell.bar_count, 20);
    assert_true(cell.bar_height == 0.004 && cell.twisting == 0.0);
    check_relative(cell.width, 0.02, 1e-14);
    from.ring_shear = (clod_case_ring_shear){0};
    from.jenike = (clod_case_jenike){.present = true,
                                     .grain_material = "lime",
                                     .diameter = 0.06,
                                     .base_height = 0.019,
                                     .ring_height = 0.021,
                                     .twists = 3,
                                     .twist_angle = 10.0 * M_PI / 180.0,
                                     .programme = {.speed = 1e-3}};
    cell = clod_shear_cell_of(&from);
    assert_string_equal(cell.key, "jenike");
    assert_string_equal(cell.grain_material, "lime");
    assert_ptr_equal(cell.programme, &from.jenike.programme);
    assert_int_equal(cell.bar_count, 0);
    check_relative(cell.height, 0.04, 1e-14);
    check_relative(cell.twisting, 12.0 * 10.0 * M_PI / 180.0 * 30.0, 1e-14);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_runs_can_be_tried_and_estimated),
        cmocka_unit_test(a_tester_has_its_preflight),
        cmocka_unit_test(a_cell_is_that_of_the_case),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
