// The table of testers: a full row for each clod_case_kind, and which of them a case is.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

#include "config/testers.h"

/** A free run has no section; what makes a cell has all that a cell needs. */
static void every_kind_has_its_row(void **state)
{
    (void)state;
    for (int k = 0; k < CLOD_CASE_KINDS; k++) {
        const clod_config_tester *row = &CLOD_CONFIG_TESTER[k];
        assert_true((row->key == NULL) == (k == CLOD_CASE_FREE));
        assert_true((row->present != NULL) == (row->key != NULL));
        assert_true((row->materials != NULL) == (row->key != NULL));
        assert_true((row->check != NULL) == (row->key != NULL));
        assert_true((row->stress != NULL) == row->cell);
        assert_true((row->lid_damping != NULL) == row->cell);
        assert_true(row->programme == NULL || row->cell);
        for (int other = 0; row->key != NULL && other < k; other++) {
            const char *key = CLOD_CONFIG_TESTER[other].key;
            assert_true(key == NULL || strcmp(key, row->key) != 0);
        }
    }
}

/** A tester goes before all; grains go before the bench, which is a kind only when alone. */
static void a_case_is_of_one_kind(void **state)
{
    (void)state;
    clod_case from = {0};
    assert_int_equal(clod_case_kind_of(&from), CLOD_CASE_FREE);
    assert_false(clod_case_has(&from, CLOD_CASE_FREE));
    from.contact_bench.present = true;
    assert_int_equal(clod_case_kind_of(&from), CLOD_CASE_CONTACT_BENCH);
    assert_null(clod_case_tester(&from)); // it makes no grains
    assert_true(clod_case_tester_stress(&from) == 0.0);
    from.grains_count = 1;
    assert_int_equal(clod_case_kind_of(&from), CLOD_CASE_FREE);
    assert_true(clod_case_has(&from, CLOD_CASE_FREE));
    assert_true(clod_case_has(&from, CLOD_CASE_CONTACT_BENCH));
    from.grains_count = 0;
    from.uniaxial.present = true;
    assert_int_equal(clod_case_kind_of(&from), CLOD_CASE_UNIAXIAL);
    assert_string_equal(clod_case_tester(&from), "uniaxial");
    assert_true(clod_case_has(&from, CLOD_CASE_CONTACT_BENCH));
    assert_false(clod_case_has(&from, CLOD_CASE_JENIKE));
}

/** What the messages say, for one who has mistyped. */
static void the_list_names_what_makes_a_cell(void **state)
{
    (void)state;
    char text[CLOD_CONFIG_TESTER_KEYS];
    clod_config_tester_keys(text);
    assert_string_equal(text, "ring_shear, jenike, uniaxial, wall_friction");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_has_its_row),
        cmocka_unit_test(a_case_is_of_one_kind),
        cmocka_unit_test(the_list_names_what_makes_a_cell),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
