// What a case measures: fields, mixing indices, angles of repose.

#include "clod/case.h"

#include <string.h>

#include "support/case_of.h"

#define EVERYTHING CLOD_SOURCE_DIR "/tests/config/good/everything.yaml"

static void same(double found, double expected)
{
    check_relative(found, expected, 1e-12);
}

static void fields(void **unused)
{
    (void)unused;
    clod_case *made = case_in(EVERYTHING, NULL, 0);
    assert_int_equal(made->field_count, 2);
    same(made->fields[0].cell, 0.01);
    same(made->fields[0].width, 0.025);
    same(made->fields[0].interval, 2e-3);
    same(made->fields[1].cell, 0.0); // one mean
    same(made->fields[1].width, 0.0);
    same(made->fields[1].interval, 0.01);
    same(made->fields[1].region.inner_radius, 0.01);
    clod_case_destroy(&made);
}

static void mixing_and_repose(void **unused)
{
    (void)unused;
    clod_case *made = case_in(EVERYTHING, NULL, 0);
    assert_int_equal(made->mixing_count, 2);
    same(made->mixings[0].above, 3e-3);
    assert_null(made->mixings[0].material);
    assert_string_equal(made->mixings[1].material, "ore");
    assert_int_equal(made->mixings[0].by, CLOD_MIXING_BY_NUMBER);
    assert_int_equal(made->mixings[1].by, CLOD_MIXING_BY_MASS);
    assert_int_equal(made->repose_count, 2);
    const clod_case_repose *heap = &made->reposes[0], *slope = &made->reposes[1];
    assert_true(heap->has_center && !heap->has_direction);
    assert_true(slope->has_direction && !slope->has_center);
    same(heap->center[1], 0.02);
    same(heap->from, 0.1);
    same(heap->to, 0.8);
    same(slope->direction[1], -2.0);
    same(slope->to, 0.75);
    clod_case_destroy(&made);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fields),
        cmocka_unit_test(mixing_and_repose),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
