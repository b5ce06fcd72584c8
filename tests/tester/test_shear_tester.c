// The rows of the shear testers: each is found by its number and by the case that has it.

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tester_is_found_by_number_and_by_case),
        cmocka_unit_test(rows_are_complete),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
