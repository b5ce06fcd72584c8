/**
 * @file test_json.c
 * Files of JSON: read whole, and what is said of damaged ones.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "base/json.h"
#include "output/temp_folder.h"

static void write_file(void **state, const char *text)
{
    char path[PATH_MAX];
    FILE *out = fopen(temp_path(path, state, "one.json"), "w");
    assert_non_null(out);
    fputs(text, out);
    assert_int_equal(fclose(out), 0);
}

static void file_is_read(void **state)
{
    clod_status status = {CLOD_OK, ""};
    write_file(state, "{\n\"grains\": 12\n}\n");
    json_t *found = clod_json_read(*state, "one.json", &status);
    assert_int_equal(json_integer_value(json_object_get(found, "grains")), 12);
    json_decref(found);
}

static void damaged_file_is_told_with_its_line(void **state)
{
    clod_status status = {CLOD_OK, ""};
    write_file(state, "{\n\"grains\": }\n");
    assert_null(clod_json_read(*state, "one.json", &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "/one.json:2: damaged: "));
}

static void file_that_is_not_there_is_told(void **state)
{
    clod_status status = {CLOD_OK, ""};
    assert_null(clod_json_read(*state, "none.json", &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "/none.json: cannot be opened"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(file_is_read, temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(damaged_file_is_told_with_its_line, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(file_that_is_not_there_is_told, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
