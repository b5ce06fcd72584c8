/** The rows of the kinds of shapes: none is forgotten, none contradicts itself. */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

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
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_shape_is_of_one_sort),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
