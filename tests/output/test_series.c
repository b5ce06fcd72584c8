// CSV series: exact numbers, resuming byte for byte, errors.

#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/resource.h>

#include <cmocka.h>

#include "base/random.h"
#include "output/series.h"

#include "temp_folder.h"

static const char *const COLUMNS[] = {"time [s]", "shear_stress [Pa]", "height [m]"};

static clod_series *open_series(void **folder, const clod_series_mark *resume,
                                clod_status *status)
{
    return clod_series_open(temp_folder(folder), "series.csv", COLUMNS, 3, resume, status);
}

static void close_series(clod_series **series)
{
    clod_status status;
    assert_true(clod_series_close(series, &status));
    assert_null(*series);
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
    clod_series *series = open_series(folder, NULL, &status);
    assert_non_null(series);
    assert_true(clod_series_row(series, (double[3]){0.5, -0.0, 1e-7}, &status));
    assert_true(clod_series_row(series, (double[3]){(double)NAN, -HUGE_VAL, 54800.0}, &status));
    assert_true(clod_series_sync(series, &status));
    char *text = temp_read(folder, "series.csv", &size); // before it is closed
    assert_string_equal(text, "time [s],shear_stress [Pa],height [m]\n0.5,-0,1e-07\n"
                              "nan,-inf,54800\n"); // by hand
    const clod_series_mark mark = clod_series_position(series);
    assert_int_equal(mark.bytes, size);
    // python3 -c 'import sys, zlib; print(hex(zlib.crc32(sys.stdin.buffer.read())))'
    assert_int_equal(mark.crc32, 0x2ca63c1u);
    clod_memory_free(text);
    close_series(&series);
}

static void numbers_read_back_exactly(void **folder)
{
    clod_status status;
    size_t size;
    clod_series *series = open_series(folder, NULL, &status);
    double values[300];
    for (uint64_t v = 0; v < 300; v++) {
        const double mantissa = clod_random_uniform(1, CLOD_RANDOM_TEST, 0, v);
        values[v] = ldexp(mantissa - 0.5, (int)(7 * v) - 1070);
    }
    values[0] = 0.1 + 0.2; // needs 17 digits
    for (int r = 0; r < 100; r++) {
        assert_true(clod_series_row(series, &values[3 * r], &status));
    }
    close_series(&series);
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
    clod_series *series = open_series(folder, NULL, &status);
    write_rows(series, 1, 10);
    const clod_series_mark mark = clod_series_position(series); // the checkpoint
    write_rows(series, 11, 30);
    close_series(&series);
    char *whole = temp_read(folder, "series.csv", &size);
    temp_write(folder, "series.csv", whole, size - 5); // killed within a line
    assert_true(clod_series_check(temp_folder(folder), "series.csv", &mark, &status));
    series = open_series(folder, &mark, &status);
    assert_non_null(series);
    assert_int_equal(clod_series_position(series).bytes, mark.bytes);
    write_rows(series, 11, 30);
    close_series(&series);
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
    clod_series *series = open_series(folder, NULL, &status);
    close_series(&series);
    char *text = temp_read(folder, "series.csv", &size);
    assert_string_equal(text, "time [s],shear_stress [Pa],height [m]\n");
    clod_memory_free(text);
}

/** Opening and checking are refused with this text, and the file is as it was. */
static void expect_refused(void **folder, const clod_series_mark *mark, const char *text)
{
    clod_status status;
    size_t before, after;
    char *content = temp_read(folder, "series.csv", &before);
    assert_null(open_series(folder, mark, &status));
    assert_string_equal(status.text, text);
    assert_int_equal(status.code, CLOD_FAILED);
    char *kept = temp_read(folder, "series.csv", &after);
    assert_int_equal(before, after);
    assert_memory_equal(content, kept, before);
    clod_memory_free(content);
    clod_memory_free(kept);
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
        {"time [s],shear_stress [Pa],height [m]\n1,2,3\n", 44,
         "was changed since the checkpoint, or is damaged: its checksum is another one"},
    };
    char text[2 * PATH_MAX];
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        const clod_series_mark mark = {.bytes = cases[c].bytes, .crc32 = 1};
        temp_write(folder, "series.csv", cases[c].content, strlen(cases[c].content));
        snprintf(
            text, sizeof text,
            "Cannot go on with %s/series.csv: it %s. Put back the file as the run left it, "
            "or start over with --fresh.",
            (char *)*folder, cases[c].fault);
        expect_refused(folder, &mark, text);
    }
    clod_status status;
    const clod_series_mark mark = {.bytes = 40};
    assert_int_equal(unlink(temp_path((char[PATH_MAX]){""}, folder, "series.csv")), 0);
    assert_null(open_series(folder, &mark, &status));
    assert_non_null(strstr(status.text, "it is not there any more"));
    assert_false(temp_exists(folder, "series.csv"));
}

static void any_flipped_bit_before_the_checkpoint_is_found(void **folder)
{
    clod_status status;
    size_t size;
    clod_series *series = open_series(folder, NULL, &status);
    write_rows(series, 1, 5);
    const clod_series_mark mark = clod_series_position(series);
    write_rows(series, 6, 7); // after the checkpoint: cut off, whatever it is
    close_series(&series);
    char *text = temp_read(folder, "series.csv", &size);
    for (size_t bit = 0; bit < 8 * size; bit += 5) {
        text[bit / 8] = (char)(text[bit / 8] ^ (1 << bit % 8));
        temp_write(folder, "series.csv", text, size);
        assert_int_equal(clod_series_check(temp_folder(folder), "series.csv", &mark, &status),
                         bit / 8 >= (size_t)mark.bytes);
        text[bit / 8] = (char)(text[bit / 8] ^ (1 << bit % 8));
    }
    clod_memory_free(text);
}

static void a_table_is_not_written_through_a_link(void **folder)
{
    clod_status status;
    char link[PATH_MAX], other[PATH_MAX];
    size_t size;
    temp_write(folder, "other", "mine", 4);
    temp_path(link, folder, "series.csv");
    assert_int_equal(symlink(temp_path(other, folder, "other"), link), 0);
    assert_null(open_series(folder, NULL, &status));
    assert_non_null(strstr(status.text, "clod does not write through symbolic links"));
    char *text = temp_read(folder, "other", &size);
    assert_string_equal(text, "mine");
    clod_memory_free(text);
}

static void a_full_disk_is_told(void **folder)
{
    clod_status status;
    char text[2 * PATH_MAX];
    struct rlimit before;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    const struct rlimit full = {0, before.rlim_max}; // stands for a full disk
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &full);
    clod_series *series =
        open_series(folder, NULL, &status); // the header is the first thing written
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, SIG_DFL);
    assert_null(series);
    snprintf(
        text, sizeof text,
        "Cannot write %s/series.csv: File too large. Free some space, then give the same "
        "command again: the run goes on from its last checkpoint. What was complete before "
        "is untouched.",
        (char *)*folder);
    assert_string_equal(status.text, text);
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
        FOLDER_TEST(any_flipped_bit_before_the_checkpoint_is_found),
        FOLDER_TEST(a_table_is_not_written_through_a_link),
        FOLDER_TEST(a_full_disk_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
