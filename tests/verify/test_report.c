// The verdict on a row and the table, with results made up here.

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "clod/version.h"
#include "support/check.h"
#include "verify/report.h"

static clod_verify_row row_of(double expected, double got, double tolerance, bool relative)
{
    return (clod_verify_row){.test = "made-up",
                             .quantity = "peak force [N]",
                             .source = "nowhere",
                             .expected = expected,
                             .got = got,
                             .tolerance = tolerance,
                             .relative = relative};
}

/** Misses of a report with this one row. */
static size_t misses_of(clod_verify_row row)
{
    clod_verify_report report = {0};
    clod_status status;
    assert_true(clod_verify_report_add(&report, &row, &status));
    assert_int_equal(report.count, 1);
    assert_int_equal(report.known, 0);
    assert_int_equal(report.rows[0].passed, report.misses == 0);
    const size_t misses = report.misses;
    clod_verify_fini(&report);
    return misses;
}

static void a_row_passes_within_its_tolerance_only(void **state)
{
    (void)state;
    assert_int_equal(misses_of(row_of(2.0, 2.25, 0.25, false)), 0); // exact in binary
    assert_int_equal(misses_of(row_of(2.0, 1.75, 0.25, false)), 0);
    assert_int_equal(misses_of(row_of(2.0, 2.26, 0.25, false)), 1);
    assert_int_equal(misses_of(row_of(2.0, 1.74, 0.25, false)), 1);
    assert_int_equal(misses_of(row_of(-4.0, -5.0, 0.25, true)), 0); // a quarter of 4
    assert_int_equal(misses_of(row_of(-4.0, -5.01, 0.25, true)), 1);
    assert_int_equal(misses_of(row_of(0.0, 0.0, 0.0, false)), 0);
    assert_int_equal(misses_of(row_of(0.0, 1e-300, 0.0, false)), 1);
}

static void what_is_no_number_is_a_miss(void **state)
{
    (void)state;
    assert_int_equal(misses_of(row_of(1.0, NAN, HUGE_VAL, false)), 1);
    assert_int_equal(misses_of(row_of(NAN, 1.0, 1e9, false)), 1);
    assert_int_equal(misses_of(row_of(1.0, INFINITY, 1e9, true)), 1);
}

// A recorded miss is none as long as it misses; when it passes somebody must look at it.
static void a_recorded_miss_must_miss(void **state)
{
    (void)state;
    const double got[] = {2.5, 2.0, NAN};
    const size_t misses[] = {0, 1, 0};
    const char *const cells[] = {
        "| 2.5 | 0.25 | **MISS**, recorded: read off a plot |\n",
        "| 2 | 0.25 | yes, **but recorded as a miss**: read off a plot |\n",
        "| nan | 0.25 | **MISS**, recorded: read off a plot |\n"};
    for (int k = 0; k < 3; k++) {
        clod_verify_report report = {0};
        clod_status status;
        const clod_verify_row row = row_of(2.0, got[k], 0.25, false);
        assert_true(clod_verify_report_add(&report, &row, &status));
        clod_verify_report_record_miss(&report, "read off a plot");
        assert_int_equal(report.misses, misses[k]);
        assert_int_equal(report.known, 1 - misses[k]);
        char *text = clod_verify_report_text(&report);
        assert_non_null(strstr(text, cells[k]));
        assert_non_null(strstr(text, misses[k] == 0
                                         ? "1 quantities, 0 missed; 1 recorded misses."
                                         : "1 quantities, 1 missed; 0 recorded misses."));
        clod_memory_free(text);
        clod_verify_fini(&report);
    }
}

// A bed is one draw of a chaotic process: what misses today may pass with other last bits.
static void a_recorded_miss_of_a_bed_may_pass(void **state)
{
    (void)state;
    const double got[] = {2.5, 2.0};
    for (int k = 0; k < 2; k++) {
        clod_verify_report report = {.slow = true};
        clod_status status;
        const clod_verify_row row = row_of(2.0, got[k], 0.25, false);
        assert_true(clod_verify_report_add(&report, &row, &status));
        clod_verify_report_record_miss(&report, "few grains");
        assert_int_equal(report.misses, 0);
        assert_int_equal(report.known, k == 0);
        char *text = clod_verify_report_text(&report);
        assert_non_null(
            strstr(text, k == 0 ? "**MISS**, recorded: few grains |\n" : "| yes |\n"));
        assert_non_null(strstr(text, k == 0 ? "1 quantities, 0 missed; 1 recorded misses."
                                            : "1 quantities, 0 missed; 0 recorded misses."));
        clod_memory_free(text);
        clod_verify_fini(&report);
    }
}

static void the_table_counts_and_marks_a_miss(void **state)
{
    (void)state;
    clod_verify_report report = {0};
    clod_status status;
    for (int k = 0; k < 100; k++) { // beyond the first memory
        const clod_verify_row row = row_of(10.0, k == 70 ? 10.02 : 10.0, 1e-3, true);
        assert_true(clod_verify_report_add(&report, &row, &status));
    }
    assert_int_equal(report.misses, 1);
    char *text = clod_verify_report_text(&report);
    assert_non_null(text);
    assert_non_null(strstr(text, "100 quantities, 1 missed;"));
    assert_non_null(strstr(text, "| made-up | peak force [N] | 10 | nowhere | 10.02 | 0.1 % | "
                                 "**MISS** |\n"));
    assert_non_null(strstr(text, "| 10 | nowhere | 10 | 0.1 % | yes |\n"));
    clod_memory_free(text);
    clod_verify_fini(&report);
}

// Slow tests are run one by one: each section counts its own rows and names the program.
static void a_slow_report_has_a_section_for_each_test(void **state)
{
    (void)state;
    clod_verify_report report = {.slow = true};
    clod_status status;
    char section[256];
    for (int k = 0; k < 5; k++) {
        clod_verify_row row = row_of(10.0, k == 1 ? 12.0 : 10.0, 1e-3, true);
        memcpy(row.test, k < 3 ? "silo" : "heap", 5);
        assert_true(clod_verify_report_add(&report, &row, &status));
    }
    char *text = clod_verify_report_text(&report);
    for (int k = 0; k < 2; k++) {
        const char *name = k == 0 ? "silo" : "heap";
        snprintf(section, sizeof section, "\n\n## %s\n\n`clod verify --slow %s` of %s: %s",
                 name, name, clod_version_text(),
                 k == 0 ? "3 quantities, 1 missed;" : "2 quantities, 0 missed;");
        const char *found = strstr(text, section);
        assert_non_null(found);
        assert_non_null(strstr(found, k == 0 ? "\n| silo | " : "\n| heap | "));
    }
    assert_null(strstr(strstr(text, "## heap"), "| silo |"));
    clod_memory_free(text);
    clod_verify_fini(&report);
}

static void an_empty_report_has_no_misses(void **state)
{
    (void)state;
    clod_verify_report report = {0};
    char *text = clod_verify_report_text(&report);
    assert_non_null(strstr(text, "0 quantities, 0 missed;"));
    clod_memory_free(text);
    clod_verify_fini(&report);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_row_passes_within_its_tolerance_only),
        cmocka_unit_test(what_is_no_number_is_a_miss),
        cmocka_unit_test(a_recorded_miss_must_miss),
        cmocka_unit_test(a_recorded_miss_of_a_bed_may_pass),
        cmocka_unit_test(the_table_counts_and_marks_a_miss),
        cmocka_unit_test(a_slow_report_has_a_section_for_each_test),
        cmocka_unit_test(an_empty_report_has_no_misses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
