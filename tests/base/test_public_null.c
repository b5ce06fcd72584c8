/**
 * What the public headers say about things that are empty, and NULL where it is fine. NULL for
 * every argument: tests/python/test_null.py.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "clod/case.h"
#include "clod/locus.h"
#include "clod/run.h"
#include "clod/schema.h"
#include "verify/verify.h"

#define POINTS CLOD_SOURCE_DIR "/tests/analysis/seeds/two_groups.csv"

static void points_are_read_without_defaults(void **state)
{
    (void)state;
    clod_status status = {CLOD_OK, ""};
    clod_locus_point *points;
    size_t count;
    assert_true(clod_locus_read(POINTS, NULL, &points, &count, &status));
    assert_int_equal(count, 7); // rows of the file
    clod_locus_free(points);
    // a column that is missing is told; the options of clod locus only to one who has defaults
    static const char TEXT[] = "sigma_sh [kPa],tau_sh [kPa]\n1,2\n";
    const clod_locus_defaults none = {NULL, NULL};
    clod_status other = {CLOD_OK, ""};
    assert_false(clod_locus_parse("a.csv", TEXT, strlen(TEXT), NULL, &points, &count, &status));
    assert_false(clod_locus_parse("a.csv", TEXT, strlen(TEXT), &none, &points, &count, &other));
    assert_string_equal(status.text, "a.csv:1: the header has no column sigma_pre; add it.");
    assert_non_null(strstr(other.text, "add the column, or give --sigma-pre."));
    assert_null(points);
}

static void nothing_can_be_freed(void **state)
{
    (void)state;
    clod_case *no_case = NULL;
    clod_locus_study *no_study = NULL;
    clod_locus empty_locus = {0};
    clod_verify_report empty_report = {0};
    clod_case_destroy(NULL);
    clod_case_destroy(&no_case);
    clod_locus_study_destroy(NULL);
    clod_locus_study_destroy(&no_study);
    clod_locus_fini(&empty_locus);
    clod_locus_free(NULL);
    clod_run_free(NULL);
    clod_schema_free(NULL);
    clod_verify_fini(&empty_report);
    assert_null(no_case);
    assert_null(no_study);
}

static void no_overrides_and_no_points(void **state)
{
    (void)state;
    clod_status status = {CLOD_OK, ""};
    clod_case *from =
        clod_case_load(CLOD_SOURCE_DIR "/cases/free-run/case.yaml", NULL, 0, &status);
    assert_non_null(from);
    assert_int_equal(clod_case_material_index(from, "no such material"), -1);
    assert_null(clod_case_tester(from));
    assert_null(clod_case_shear(from));
    assert_true(clod_case_tester_stress(from) == 0.0);
    clod_case_destroy(&from);
    assert_null(from);
    const char *const changes[] = {"seed=7", NULL};
    assert_null(
        clod_case_load(CLOD_SOURCE_DIR "/cases/free-run/case.yaml", changes, 2, &status));
    assert_string_equal(status.text, "clod_case_load: one of overrides is NULL");
    assert_null(clod_locus_study_create(NULL, 0, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    clod_locus locus;
    assert_false(clod_locus_evaluate(NULL, 0, &locus, &status));
    char *keys = clod_schema_explain(NULL, NULL, &status);
    assert_non_null(keys);
    clod_schema_free(keys);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_read_without_defaults),
        cmocka_unit_test(nothing_can_be_freed),
        cmocka_unit_test(no_overrides_and_no_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
