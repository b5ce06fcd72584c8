// HDF5 files through clod's own descriptor: columns in slabs, errors of the disk with their
// text.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "output/folder_files.h"
#include "output/hdf_look.h"

#include "temp_folder.h"

#define ROWS (2 * CLOD_HDF_SLAB + 5)
#define START 64 // bytes in front of those of HDF5

/** Three numbers of each row among others. */
static double table[ROWS][4];
static double found[ROWS][4];

static const clod_hdf_column WHOLE = {"some/numbers", "m",   CLOD_HDF_F64, 3,
                                      ROWS,           table, sizeof *table};

static void fill_table(void)
{
    for (size_t r = 0; r < ROWS; r++) {
        for (size_t c = 0; c < 4; c++) {
            table[r][c] = (double)(4 * r + c);
        }
    }
    memset(found, 0, sizeof found);
}

static int open_file(void **folder, const char *name)
{
    clod_status status;
    return clod_folder_open_file(temp_folder(folder), name, O_RDWR | O_CREAT, &status);
}

/** Write the table whole, or its rows in slabs, and end; bytes of HDF5. */
static uint64_t write_table(void **folder, const char *name, bool slabs)
{
    clod_status status;
    const clod_hdf_place place = {temp_folder(folder), name, open_file(folder, name), START};
    clod_hdf *hdf = clod_hdf_create(&place, CLOD_HDF_EXACT, &status);
    assert_non_null(hdf);
    if (slabs) {
        clod_hdf_make(hdf, &WHOLE);
        for (size_t first = 0; first < ROWS; first += CLOD_HDF_SLAB) {
            clod_hdf_column some = WHOLE;
            some.data = table[first];
            some.rows = ROWS - first < CLOD_HDF_SLAB ? ROWS - first : CLOD_HDF_SLAB;
            clod_hdf_put_rows(hdf, &some, first);
        }
    } else {
        clod_hdf_put(hdf, &WHOLE);
    }
    uint64_t size;
    assert_true(clod_hdf_finish(&hdf, &size, &status));
    clod_file_close(place.descriptor);
    return size;
}

static void rows_come_back_whole_and_in_slabs(void **folder)
{
    clod_status status;
    fill_table();
    const uint64_t size = write_table(folder, "slabs", true);
    const clod_hdf_place place = {temp_folder(folder), "slabs", open_file(folder, "slabs"),
                                  START};
    clod_hdf *hdf = clod_hdf_open(&place, size, &status);
    assert_non_null(hdf);
    assert_int_equal(clod_hdf_rows(hdf, "some/numbers"), ROWS);
    clod_hdf_column column = WHOLE;
    column.data = found;
    clod_hdf_get(hdf, &column);
    for (size_t r = 0; r < ROWS; r++) {
        assert_memory_equal(found[r], table[r], 3 * sizeof(double));
        assert_true(found[r][3] == 0.0); // what is between the rows is not touched
    }
    memset(found, 0, sizeof found);
    column.rows = 100;
    clod_hdf_get_rows(hdf, &column, CLOD_HDF_SLAB - 50, ROWS);
    for (size_t r = 0; r < 101; r++) {
        const double expected = r < 100 ? table[CLOD_HDF_SLAB - 50 + r][2] : 0.0;
        assert_true(found[r][2] == expected);
    }
    assert_true(clod_hdf_end_reading(&hdf, &status));
    clod_file_close(place.descriptor);
}

static void other_numbers_of_rows_are_refused(void **folder)
{
    clod_status status;
    const uint64_t size = write_table(folder, "whole", false);
    const clod_hdf_place place = {temp_folder(folder), "whole", open_file(folder, "whole"),
                                  START};
    for (size_t rows = ROWS - 1; rows <= ROWS + 1; rows += 2) {
        clod_hdf *hdf = clod_hdf_open(&place, size, &status);
        clod_hdf_column column = WHOLE;
        column.data = found;
        column.rows = 10;
        clod_hdf_get_rows(hdf, &column, 0, rows);
        assert_true(clod_hdf_has_failed(hdf) && !clod_hdf_fails_outside(hdf));
        assert_false(clod_hdf_end_reading(&hdf, &status));
        assert_non_null(strstr(status.text, "some/numbers"));
    }
    clod_file_close(place.descriptor);
}

/** What a file holds is found without knowing it: names in their order, sizes, numbers of another
 *  type; what is not there is none, and no error of the file. */
static void a_file_tells_what_it_holds(void **folder)
{
    clod_status status;
    const clod_hdf_place place = {temp_folder(folder), "told", open_file(folder, "told"), 0};
    const int32_t whole[] = {3, -4};
    const clod_hdf_column small = {"some/integers", NULL, CLOD_HDF_I32, 1, 2, whole, 4};
    uint64_t size;
    clod_hdf *hdf = clod_hdf_create(&place, CLOD_HDF_PICTURE, &status);
    fill_table();
    clod_hdf_put(hdf, &WHOLE);
    clod_hdf_put(hdf, &small);
    clod_hdf_put_real(hdf, "/", "time_s", 2.5);
    assert_true(clod_hdf_finish(&hdf, &size, &status));
    hdf = clod_hdf_open(&place, size, &status);
    char name[16], tiny[8];
    assert_int_equal(clod_hdf_members(hdf, "some"), 2);
    assert_int_equal(clod_hdf_members(hdf, "none"), 0);
    assert_true(clod_hdf_member(hdf, "some", 0, name, sizeof name));
    assert_string_equal(name, "integers");
    assert_true(clod_hdf_member(hdf, "some", 1, name, sizeof name));
    assert_string_equal(name, "numbers");
    assert_false(clod_hdf_member(hdf, "some", 1, tiny, 7)); // no room for its end
    size_t rows, components;
    assert_true(clod_hdf_size(hdf, "some/numbers", &rows, &components));
    assert_int_equal(rows, ROWS);
    assert_int_equal(components, 3);
    assert_false(clod_hdf_size(hdf, "some/others", &rows, &components));
    assert_false(clod_hdf_size(hdf, "some", &rows, &components));
    double value, two[2];
    assert_true(clod_hdf_get_real(hdf, "/", "time_s", &value) && value == 2.5);
    assert_false(clod_hdf_get_real(hdf, "/", "time", &value));
    assert_true(clod_hdf_get_text(hdf, "some/numbers", "units", tiny, sizeof tiny));
    assert_string_equal(tiny, "m");
    assert_false(clod_hdf_get_text(hdf, "some/integers", "units", tiny, sizeof tiny));
    assert_true(clod_hdf_read(hdf, "some/integers", CLOD_HDF_F64, 2, two));
    assert_true(two[0] == 3.0 && two[1] == -4.0);
    assert_false(clod_hdf_read(hdf, "some/integers", CLOD_HDF_F64, 1, two));
    assert_true(clod_hdf_end_reading(&hdf, &status));
    clod_file_close(place.descriptor);
}

/** Nothing in front of HDF5's bytes is touched, and slabs or not, the data are the same. */
static void the_file_is_what_was_asked_for(void **folder)
{
    size_t one, two;
    write_table(folder, "one", false);
    write_table(folder, "two", false);
    char *first = temp_read(folder, "one", &one), *second = temp_read(folder, "two", &two);
    assert_int_equal(one, two);
    assert_memory_equal(first, second, one);
    const char nothing[START] = {0};
    assert_memory_equal(first, nothing, START);
    assert_memory_equal(first + START, "\x89HDF", 4);
    clod_memory_free(first);
    clod_memory_free(second);
}

static void a_file_that_became_shorter_is_an_error_of_the_disk(void **folder)
{
    clod_status status;
    char text[2 * PATH_MAX];
    const uint64_t size = write_table(folder, "short", false);
    const clod_hdf_place place = {temp_folder(folder), "short", open_file(folder, "short"),
                                  START};
    clod_hdf *hdf = clod_hdf_open(&place, size, &status);
    assert_non_null(hdf);
    assert_int_equal(clod_file_truncate(place.descriptor, START + size / 2), 0);
    clod_hdf_column column = WHOLE;
    column.data = found;
    clod_hdf_get(hdf, &column);
    assert_true(clod_hdf_fails_outside(hdf));
    assert_false(clod_hdf_end_reading(&hdf, &status));
    snprintf(text, sizeof text, "Cannot read %s/short: Input/output error.", (char *)*folder);
    assert_string_equal(status.text, text);
    clod_file_close(place.descriptor);
}

/** A descriptor that cannot be written to stands for a disk that fails from the first byte. */
static void a_file_that_cannot_be_written_is_told_by_its_name(void **folder)
{
    clod_status status;
    char text[2 * PATH_MAX];
    clod_file_close(open_file(folder, "locked"));
    const int descriptor = clod_file_open(temp_folder(folder)->descriptor, "locked", O_RDONLY);
    const clod_hdf_place place = {temp_folder(folder), "locked", descriptor, START};
    for (int again = 0; again < 3; again++) { // HDF5 is as before after a failure
        uint64_t size;
        clod_hdf *hdf = clod_hdf_create(&place, CLOD_HDF_PICTURE, &status);
        if (hdf != NULL) {
            clod_hdf_put(hdf, &WHOLE);
            assert_false(clod_hdf_finish(&hdf, &size, &status));
        }
        snprintf(text, sizeof text, "Cannot write %s/locked: Bad file descriptor.",
                 (char *)*folder);
        assert_string_equal(status.text, text);
    }
    clod_file_close(descriptor);
    rows_come_back_whole_and_in_slabs(folder);
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(rows_come_back_whole_and_in_slabs),
        FOLDER_TEST(other_numbers_of_rows_are_refused),
        FOLDER_TEST(a_file_tells_what_it_holds),
        FOLDER_TEST(the_file_is_what_was_asked_for),
        FOLDER_TEST(a_file_that_became_shorter_is_an_error_of_the_disk),
        FOLDER_TEST(a_file_that_cannot_be_written_is_told_by_its_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
