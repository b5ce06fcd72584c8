/** The rows of the kinds of shapes: none is forgotten, none contradicts itself. */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "state/shape_kinds.h"

// A shape has one way of closing off space, by the definition in shape_kinds.h; a kind whose
// row is missing has none.
static void every_shape_is_of_one_sort(void **state)
{
    (void)state;
    for (int k = 0; k < CLOD_SHAPE_KINDS; k++) {
        const clod_shape_kind_row *row = clod_shape_kinds_row((clod_shape_kind)k);
        assert_int_equal(row->endless + row->solid + row->faceted + row->flat + row->shell, 1);
        assert_true(row->boxed == (row->solid || row->faceted));
        assert_true(row->shell || !row->straight);
        assert_true(row->faceted || !row->conveyor);
        assert_true((row->make == NULL) == row->faceted);
        assert_true(row->faceted == (row->file + row->conveyor == 1));
        assert_true((row->area == NULL) == (row->endless || row->faceted));
        assert_true((row->form == CLOD_FORM_PLANE) == row->endless);
        assert_true((row->form == CLOD_FORM_BOX) == row->solid);
        assert_true((row->form == CLOD_FORM_MESH) == row->faceted);
        assert_true((row->form == CLOD_FORM_SHELL) == (row->flat || row->shell));
    }
}

static clod_shape_fault fault_of(clod_case_shape shape)
{
    const clod_shape_kind_row *row = clod_shape_kinds_row((clod_shape_kind)shape.kind);
    return row->fault != NULL ? row->fault(&shape) : (clod_shape_fault){0};
}

/** Rings have a width, cones are no cylinders, bars have a length and a direction across it. */
static void keys_that_give_no_shape_are_named(void **state)
{
    (void)state;
    clod_case_shape ring = {
        .kind = CLOD_SHAPE_ANNULUS, .inner_radius = 1.0, .outer_radius = 1.1};
    assert_null(fault_of(ring).key);
    ring.outer_radius = 1.0;
    assert_string_equal(fault_of(ring).key, "annulus.inner_radius");
    clod_case_shape cone = {.kind = CLOD_SHAPE_CONE, .foot_radius = 1.0, .top_radius = 0.0};
    assert_null(fault_of(cone).key);
    cone.top_radius = 1.0;
    assert_string_equal(fault_of(cone).key, "cone.top_radius");
    clod_case_shape bar = {.kind = CLOD_SHAPE_BAR,
                           .from = {1.0, 2.0, 3.0},
                           .to = {2.0, 3.0, 3.0},
                           .up = {1.0, 1.0, 0.1}};
    assert_null(fault_of(bar).key);
    bar.up[2] = 0.0;
    assert_string_equal(fault_of(bar).key, "bar.up");
    memcpy(bar.to, bar.from, sizeof bar.to);
    assert_string_equal(fault_of(bar).key, "bar.to");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_shape_is_of_one_sort),
        cmocka_unit_test(keys_that_give_no_shape_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
