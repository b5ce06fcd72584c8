// Which plane of a grid is shown. Expected by hand, from the rule of field_slice.h.

#include "report/field_slice.h"
#include "support/check.h"

/** What is expected of a grid: axes across, to the right and upwards. */
static void planes(void **state)
{
    (void)state;
    static const struct {
        long cells[3];
        double gravity[3];
        int across, right, up;
        bool in; ///< gravity lies in it
    } CASES[] = {
        {{20, 10, 5}, {0.0, 0.0, -9.81}, 1, 0, 2, true}, // thinnest, but for z
        {{10, 20, 5}, {0.0, 0.0, -9.81}, 0, 1, 2, true},
        {{10, 10, 5}, {0.0, 0.0, -9.81}, 1, 0, 2, true}, // as thin: the x-z plane
        {{20, 10, 5}, {0.0, 0.0, 0.0}, 2, 0, 1, false},  // no gravity: thinnest
        {{10, 10, 10}, {0.0, 0.0, 0.0}, 1, 0, 2, false},
        {{10, 30, 20}, {4.9, 0.0, -8.5}, 1, 0, 2, true},  // a chute: across y alone
        {{10, 30, 20}, {-9.81, 0.0, 0.0}, 2, 1, 0, true}, // x is upwards
        {{10, 30, 40}, {-9.81, 0.0, 0.0}, 1, 2, 0, true},
        {{10, 30, 20}, {1.0, 0.5, -9.0}, 1, 0, 2, false}, // aslant: nearest
        {{50, 50, 1}, {0.0, 0.0, -9.81}, 2, 0, 1, false}, // a flat grid: seen from above
        {{50, 1, 40}, {0.0, 0.0, -9.81}, 1, 0, 2, true},
        {{1, 1, 40}, {0.0, 0.0, -9.81}, 1, 0, 2, true}, // a column
    };
    for (size_t k = 0; k < sizeof CASES / sizeof *CASES; k++) {
        clod_field_slice slice;
        clod_field_slice_choose(&slice, CASES[k].cells, CASES[k].gravity);
        assert_int_equal(slice.across, CASES[k].across);
        assert_int_equal(slice.right, CASES[k].right);
        assert_int_equal(slice.up, CASES[k].up);
        assert_int_equal(slice.gravity, CASES[k].in);
        assert_int_equal(slice.stride, 1);
        assert_int_equal(slice.columns, CASES[k].cells[slice.right]);
        assert_int_equal(slice.rows, CASES[k].cells[slice.up]);
    }
}

/** The middle of an odd number of layers, the lower of two; its centre in space. */
static void the_middle(void **state)
{
    (void)state;
    static const double DOWN[3] = {0.0, 0.0, -9.81};
    clod_field_slice slice;
    clod_field_slice_choose(&slice, (const long[]){9, 5, 9}, DOWN);
    assert_int_equal(slice.layer, 2);
    slice.corner[1] = -0.01;
    slice.cell = 0.004;
    check_close(clod_field_slice_place(&slice), 0.0, 1e-15);
    clod_field_slice_choose(&slice, (const long[]){9, 4, 9}, DOWN);
    assert_int_equal(slice.layer, 1);
}

/** 500 x 200 = 100 000 cells: blocks of 3 x 3, whose middle is shown; 167 x 67 = 11 189, and the last
 *  columns (498, 499) have a middle, as the last rows (198, 199). Of 2 x 2 there would be 25 000. */
static void large_slices_are_thinned(void **state)
{
    (void)state;
    clod_field_slice slice;
    clod_field_slice_choose(&slice, (const long[]){500, 1, 200},
                            (const double[]){0.0, 0.0, -9.81});
    assert_int_equal(slice.stride, 3);
    assert_int_equal(slice.columns, 167);
    assert_int_equal(slice.rows, 67);
    clod_field_slice_choose(&slice, (const long[]){499, 1, 200},
                            (const double[]){0.0, 0.0, -9.81});
    assert_int_equal(slice.columns, 166); // 498 alone has none: its block would begin there
    clod_field_slice_choose(&slice, (const long[]){200, 1, 100},
                            (const double[]){0.0, 0.0, -9.81});
    assert_int_equal(slice.stride, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planes),
        cmocka_unit_test(the_middle),
        cmocka_unit_test(large_slices_are_thinned),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
