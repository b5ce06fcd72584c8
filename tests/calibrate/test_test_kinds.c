// Every kind of case that a calibration runs has all that it needs of it.
#include "calibrate/test_kinds.h"
#include "config/testers.h"
#include "support/check.h"

/** A case of each kind, by the section that it has. */
static clod_case case_of(clod_case_kind kind)
{
    clod_case from = {0};
    from.ring_shear.present = kind == CLOD_CASE_RING_SHEAR;
    from.jenike.present = kind == CLOD_CASE_JENIKE;
    from.uniaxial.present = kind == CLOD_CASE_UNIAXIAL;
    from.wall_friction.present = kind == CLOD_CASE_WALL_FRICTION;
    return from;
}

static void every_tester_has_its_row(void **state)
{
    (void)state;
    int testers = 0;
    for (int k = 0; k < CLOD_CASE_KINDS; k++) {
        if (!CLOD_CONFIG_TESTER[k].cell) {
            continue;
        }
        clod_case from = case_of((clod_case_kind)k);
        const clod_plan_test test = {.middle = &from};
        assert_int_equal(clod_case_kind_of(&from), k); // case_of knows it
        const clod_test_kind *kind = clod_test_kinds_of(&from);
        assert_true(kind->number_count > 0 && kind->seeds != NULL && kind->read != NULL);
        assert_true((kind->has_stress == NULL) == (kind->without_stress == NULL));
        for (size_t n = 0; n < kind->number_count; n++) {
            const clod_number *number = &kind->numbers[n];
            assert_true(number->key != NULL && number->unit != NULL);
            assert_true(number->least < number->most);
            assert_true(!number->at_stress || kind->has_stress != NULL);
            assert_ptr_equal(clod_number_find(&test, number->key), number);
        }
        testers++;
    }
    assert_true(testers >= 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tester_has_its_row),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
