// CSV series: exact numbers, resuming byte for byte, errors.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/random.h"
#include "output/series.h"

#include "temp_folder.h"

static const char *const COLUMNS[] = {"time [s]", "shear_stress [Pa]", "height [m]"};

static clod_series *open_series(void **folder, int64_t resume_bytes, clod_status *status)
{
    char path[PATH_MAX];
    return clod_series_open(temp_path(path, folder, "series.csv"), COLUMNS, 3, resume_bytes,
                            status);
}

static void write_rows(clod_series *series, int first, int last)
{
    clod_status status;
    for (int r = first; r <= last; r++) {
        assert_true(clod_series_row(series, (double[3]){0.1 * r, -1e-300 / r, r}, &status));
    }
}

static void rows_are_in_the_file_at_once(void **folder)
{
    clod_status status;
    size_t size;
    clod_series *series = open_series(folder, -1, &status);
    assert_non_null(series);
    assert_true(clod_series_row(series, (double[3]){0.5, -0.0, 1e-7}, &status));
    assert_true(clod_series_row(series, (double[3]){(double)NAN, -HUGE_VAL, 54800.0}, &status));
    assert_true(clod_series_sync(series, &status));
    char *text = temp_read(folder, "series.csv", &size); // before it is closed
    assert_string_equal(text, "time [s],shear_stress [Pa],height [m]\n0.5,-0,1e-07\n"
                              "nan,-inf,54800\n"); // by hand
    assert_int_equal(clod_series_bytes(series), size);
    clod_memory_free(text);
    clod_series_close(&series);
    assert_null(series);
}

static void numbers_read_back_exactly(void **folder)
{
    clod_status status;
    size_t size;
    clod_series *series = open_series(folder, -1, &status);
    double values[300];
    for (uint64_t v = 0; v < 300; v++) {
        const double mantissa = clod_random_uniform(1, CLOD_RANDOM_TEST, 0, v);
        values[v] = ldexp(mantissa - 0.5, (int)(7 * v) - 1070);
    }
    values[0] = 0.1 + 0.2; // needs 17 digits
    for (int r = 0; r < 100; r++) {
        assert_true(clod_series_row(series, &values[3 * r], &status));
    }
    clod_series_close(&series);
    char *text = temp_read(folder, "series.csv", &size);
    char *next = text + strcspn(text, "\n") + 1;
    for (int v = 0; v < 300; v++, next++) {
        assert_true(strtod(next, &next) == values[v]);
        assert_int_equal(*next, v % 3 < 2 ? ',' : '\n');
    }
    assert_int_equal(*next, '\0');
    clod_memory_free(text);
}

static void resumed_and_uninterrupted_are_the_same_bytes(void **folder)
{
    clod_status status;
    size_t size, size_resumed;
    clod_series *series = open_series(folder, -1, &status);
    write_rows(series, 1, 10);
    const int64_t bytes = clod_series_bytes(series); // the checkpoint
    write_rows(series, 11, 30);
    clod_series_close(&series);
    char *whole = temp_read(folder, "series.csv", &size);
    temp_write(folder, "series.csv", whole, size - 5); // killed within a line
    series = open_series(folder, bytes, &status);
    assert_non_null(series);
    assert_int_equal(clod_series_bytes(series), bytes);
    write_rows(series, 11, 30);
    clod_series_close(&series);
    char *resumed = temp_read(folder, "series.csv", &size_resumed);
    assert_int_equal(size, size_resumed);
    assert_memory_equal(whole, resumed, size);
    clod_memory_free(whole);
    clod_memory_free(resumed);
}

static void a_fresh_series_forgets_the_old_one(void **folder)
{
    clod_status status;
    size_t size;
    temp_write(folder, "series.csv", "something long that was there before, and more", 46);
    clod_series *series = open_series(folder, -1, &status);
    clod_series_close(&series);
    char *text = temp_read(folder, "series.csv", &size);
    assert_string_equal(text, "time [s],shear_stress [Pa],height [m]\n");
    clod_memory_free(text);
}

static void a_file_that_is_not_the_one_left_is_refused(void **folder)
{
    const struct {
        const char *content;
        int64_t bytes;
        const char *fault;
    } cases[] = {
        {"time [s],shear_stress [Pa],height [m]\n1,2,3\n", 60,
         "is shorter than at the checkpoint"},
        {"time [s],shear_stress [kPa],height [m]\n1,2,3\n", 45,
         "has other columns than this run writes"},
        {"time [s]\n1\n", 11, "has other columns than this run writes"},
        {"time [s],shear_stress [Pa],height [m]\n1,2,3\n", 40,
         "was changed since the checkpoint"},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        clod_status status;
        char text[PATH_MAX];
        temp_write(folder, "series.csv", cases[c].content, strlen(cases[c].content));
        assert_null(open_series(folder, cases[c].bytes, &status));
        snprintf(text, sizeof text,
                 "Cannot go on with %s/series.csv: it %s. Start over with --fresh.",
                 (char *)*folder, cases[c].fault);
        assert_string_equal(status.text, text);
        size_t size;
        char *kept = temp_read(folder, "series.csv", &size);
        assert_string_equal(kept, cases[c].content);
        clod_memory_free(kept);
    }
    clod_status status;
    assert_int_equal(unlink(temp_path((char[PATH_MAX]){""}, folder, "series.csv")), 0);
    assert_null(open_series(folder, 40, &status));
}

static void a_full_disk_is_told(void **folder)
{
    (void)folder;
    clod_status status;
    // the header is the first thing written, so opening fails
    assert_null(clod_series_open("/dev/full", COLUMNS, 3, -1, &status));
    assert_string_equal(
        status.text, "Cannot write /dev/full: No space left on device. Free some space, then "
                     "give the same command again: the run goes on from its last checkpoint. "
                     "What was complete before is untouched.");
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(rows_are_in_the_file_at_once),
        FOLDER_TEST(numbers_read_back_exactly),
        FOLDER_TEST(resumed_and_uninterrupted_are_the_same_bytes),
        FOLDER_TEST(a_fresh_series_forgets_the_old_one),
        FOLDER_TEST(a_file_that_is_not_the_one_left_is_refused),
        FOLDER_TEST(a_full_disk_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
