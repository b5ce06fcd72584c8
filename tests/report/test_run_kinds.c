// Every kind of case with grains has all that pages and comparisons need of it.
#include <stdio.h>

#include "config/testers.h"
#include "report/run_kinds.h"
#include "support/check.h"

static const clod_run_kind *row_of(const char *key)
{
    char complete[128];
    snprintf(complete, sizeof complete, "title: x\n%s:\n  depth: 1\n", key);
    return clod_run_kinds_of(complete);
}

static void every_tester_has_its_row(void **state)
{
    (void)state;
    const clod_run_kind *free_run = row_of("stages");
    for (int k = 0; k < CLOD_CASE_KINDS; k++) {
        const clod_config_tester *tester = &CLOD_CONFIG_TESTER[k];
        if (tester->cell) {
            const clod_run_kind *kind = row_of(tester->key);
            assert_ptr_not_equal(kind, free_run);
            assert_true(kind->text != NULL && kind->cards != NULL && kind->put != NULL);
            assert_true(kind->results != NULL && kind->figures != NULL);
            assert_true(kind->checked);
        }
    }
    assert_true(free_run->text != NULL && free_run->cards != NULL && free_run->put != NULL);
    assert_true(free_run->results != NULL && free_run->figures != NULL);
    assert_null(free_run->lab); // no yield locus
}

/** Only at the beginning of a line, and whole. */
static void a_word_elsewhere_is_no_section(void **state)
{
    (void)state;
    assert_ptr_equal(clod_run_kinds_of("title: ring_shear:\n"), row_of("stages"));
    assert_ptr_equal(clod_run_kinds_of("a: b\nring_shear_x:\n"), row_of("stages"));
    assert_ptr_equal(clod_run_kinds_of("a: b\n  ring_shear:\n"), row_of("stages"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tester_has_its_row),
        cmocka_unit_test(a_word_elsewhere_is_no_section),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
