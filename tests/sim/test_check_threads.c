// What the preflight says of threads, also where other programs have the processors.

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "clod/check.h"
#include "parallel/threads.h"
#include "support/case_of.h"

static const char BED[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3, youngs_modulus: 1 GPa, poissons_ratio: 0.34}\n"
    "contacts: {default: {law: hertz}}\n"
    "grains:\n"
    "  - material: ore\n"
    "    count: 900\n"
    "    radius: {distribution: uniform, min: 2.85 mm, max: 2.8501 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [200 mm, 200 mm, 200 mm]}}\n"
    "stages: [{name: one, duration: 1 ms}]\n";

/** The report of BED, or of BED with a change, for so many threads; 0: as many as pay. */
static void look(const char *change, int threads, clod_check_report *report)
{
    clod_status status = {CLOD_OK, ""};
    const clod_check_options options = {.threads = threads, .directory = "."};
    clod_case *from = case_of(BED, change);
    if (!clod_check_report_make(from, &options, report, &status)) {
        fail_msg("%s", status.text);
    }
    // the report borrows texts from the case, which are not looked at
    clod_case_destroy(&from);
}

static bool warns(const clod_check_report *report, const char *words)
{
    bool told = false;
    for (size_t w = 0; w < report->warning_count; w++) {
        told = told || strstr(report->warning[w], words) != NULL;
    }
    return told;
}

static void too_many_threads_are_told(void **state)
{
    (void)state;
    static clod_check_report report;
    look(NULL, clod_threads_available() + 1, &report);
    assert_true(warns(&report, "processors slow each other down"));
    assert_int_equal(report.threads, clod_threads_available());
}

static void few_grains_take_one_thread(void **state)
{
    (void)state;
    static clod_check_report report;
    look(NULL, 0, &report);
    assert_int_equal(report.threads, 1);
    assert_false(warns(&report, "threads wait for each other"));
    look("grains.0.count=1000", 0, &report);
    assert_int_equal(report.threads, clod_threads_available() > 1 ? 2 : 1);
}

static void few_grains_for_each_of_the_threads_are_told(void **state)
{
    (void)state;
    static clod_check_report report;
    if (clod_threads_available() < 2) {
        skip();
    }
    look(NULL, 2, &report);
    assert_int_equal(report.threads, 2);
    assert_true(warns(&report, "--threads 1 is likely as fast"));
}

static atomic_bool busy;

static void *keep_busy(void *unused)
{
    while (atomic_load(&busy)) {
    }
    return unused;
}

/** Beside other programs two threads may do less than one alone: that is not the estimate. */
static void a_busy_machine_is_not_taken_for_a_slow_one(void **state)
{
    (void)state;
    static clod_check_report report;
    pthread_t other[4];
    atomic_store(&busy, true);
    for (int k = 0; k < 4; k++) {
        assert_int_equal(pthread_create(&other[k], NULL, keep_busy, NULL), 0);
    }
    look("grains.0.count=8000", 2, &report);
    atomic_store(&busy, false);
    for (int k = 0; k < 4; k++) {
        assert_int_equal(pthread_join(other[k], NULL), 0);
    }
    assert_true(report.threads == 1 || report.rate > report.rate_one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(too_many_threads_are_told),
        cmocka_unit_test(few_grains_take_one_thread),
        cmocka_unit_test(few_grains_for_each_of_the_threads_are_told),
        cmocka_unit_test(a_busy_machine_is_not_taken_for_a_slow_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
