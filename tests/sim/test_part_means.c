// Means of a part's series, by hand: which rows they are of, blocks, what is not a number, what is no series.

#include "sim/part_means.h"

#include <math.h>

#include "output/folder_files.h"
#include "output/temp_folder.h"
#include "support/check.h"

#define HEADER "time [s],phase [1],displacement [m],linear [1],rare [1]\n"

static void write_series(void **folder, const char *text)
{
    clod_status status;
    assert_true(clod_folder_write(temp_folder(folder), "point-1.csv", text, &status));
}

/**
 * Rows every 0.1 s up to 4 s: of phase 3 up to 0.4 s, of phase 2 up to 1 s, and of phase 3 again. So the last phase
 * begins at 1 s, and its last third at 3 s: 11 rows, in blocks of 0.1 s, the last of which has two.
 */
static void write_phases(void **folder)
{
    char text[8192];
    int used = snprintf(text, sizeof text, HEADER);
    for (int k = 0; k <= 40; k++) {
        const char *rare = k == 32 ? "2" : k == 34 ? "6" : "nan";
        used += snprintf(text + used, sizeof text - (size_t)used, "%.17g,%d,7,%.17g,%s\n",
                         0.1 * k, k <= 4 || k > 10 ? 3 : 2, 0.1 * k, rare);
    }
    write_series(folder, text);
}

static void the_last_third_of_the_last_phase(void **folder)
{
    clod_part_means means;
    clod_status status;
    write_phases(folder);
    assert_true(clod_part_means_read(&means, temp_folder(folder), "point-1", 3, 2, &status));
    assert_int_equal(means.phase, 3);
    assert_int_equal(means.rows, 11);
    check_close(means.steady.since, 3.0, 1e-12);
    check_close(means.mean[0], 3.5, 1e-12); // of 3.0, 3.1 ... 4.0
    // standard deviation of 3.0, 3.1 ... 3.8 and 3.95, by Python's statistics
    check_close(means.deviation[0], 0.3113144176980351, 1e-12);
    check_close(means.mean[1], 4.0, 1e-12); // of 2 and 6
    check_close(means.deviation[1], sqrt(8.0), 1e-12);
    clod_part_means_fini(&means);
    assert_true(clod_part_means_read(&means, temp_folder(folder), "point-1", 3, 0, &status));
    assert_int_equal(means.rows, 11); // of no column: which rows they would be of
    clod_part_means_fini(&means);
}

static void a_single_row_has_no_deviation(void **folder)
{
    clod_part_means means;
    clod_status status;
    write_series(folder, HEADER "0.5,6,0,1.5,nan\n");
    assert_true(clod_part_means_read(&means, temp_folder(folder), "point-1", 3, 2, &status));
    assert_int_equal(means.phase, 6);
    assert_int_equal(means.rows, 1);
    check_close(means.steady.since, 0.5, 0.0);
    check_close(means.mean[0], 1.5, 0.0);
    assert_true(isnan(means.deviation[0]) && isnan(means.mean[1]));
    clod_part_means_fini(&means);
}

static void what_is_no_series_is_refused(void **folder)
{
    static const char *const WRONG[] = {"",
                                        HEADER,
                                        HEADER "0.5,6,0,1.5\n", // a row that was cut
                                        HEADER "0.5,6,0,x,1\n",
                                        HEADER "0.5,-1,0,1,1\n",
                                        HEADER "time,6,0,1,1\n",
                                        HEADER "0.5,6,0,1,1\n\n0.6,6,0,1,1\n", // an empty line
                                        HEADER "0.5,6,0,1,1\n0.6,6,0,1,\n",
                                        HEADER "0.5,6,0,1,1"};
    clod_part_means means;
    clod_status status;
    assert_false(clod_part_means_read(&means, temp_folder(folder), "point-1", 3, 2, &status));
    assert_non_null(strstr(status.text, "/point-1.csv: it is gone"));
    clod_part_means_fini(&means);
    for (size_t k = 0; k < sizeof WRONG / sizeof *WRONG; k++) {
        write_series(folder, WRONG[k]);
        assert_false(
            clod_part_means_read(&means, temp_folder(folder), "point-1", 3, 2, &status));
        assert_int_equal(status.code, CLOD_FAILED);
        assert_non_null(strstr(status.text, "/point-1.csv: it is not the series of a part"));
        clod_part_means_fini(&means);
    }
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_last_third_of_the_last_phase),
        TEST(a_single_row_has_no_deviation),
        TEST(what_is_no_series_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
