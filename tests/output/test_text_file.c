// Result files: replaced whole, never over their own input, links and devices left as they are.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "clod/text_file.h"

#include "temp_folder.h"

static void expect_content(void **folder, const char *name, const char *content)
{
    size_t size;
    char *text = temp_read(folder, name, &size);
    assert_non_null(text);
    assert_string_equal(text, content);
    clod_memory_free(text);
}

static void a_file_is_made_and_replaced(void **folder)
{
    clod_status status;
    char path[PATH_MAX], input[PATH_MAX];
    temp_path(path, folder, "out");
    temp_path(input, folder, "in");
    temp_write(folder, "in", "points", 6);
    assert_true(clod_text_file_write(path, input, "a longer one\n", &status));
    expect_content(folder, "out", "a longer one\n");
    assert_true(clod_text_file_write(path, input, "second\n", &status));
    expect_content(folder, "out", "second\n");
    expect_content(folder, "in", "points");
    assert_false(temp_exists(folder, "out.part"));
}

static void the_input_is_refused_by_any_name(void **folder)
{
    clod_status status;
    char input[PATH_MAX], path[PATH_MAX], text[2 * PATH_MAX];
    temp_path(input, folder, "in");
    temp_write(folder, "in", "points", 6);
    assert_int_equal(symlink("in", temp_path(path, folder, "soft")), 0);
    assert_int_equal(link(input, temp_path(path, folder, "hard")), 0);
    const char *const names[] = {"in", "./in", "soft", "hard"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        temp_path(path, folder, names[n]);
        assert_false(clod_text_file_write(path, input, "result", &status));
        assert_int_equal(status.code, CLOD_USAGE);
        snprintf(text, sizeof text,
                 "%s is the file that is read; it would be lost. Give another name with -o.",
                 path);
        assert_string_equal(status.text, text);
        expect_content(folder, names[n], "points");
    }
}

static void a_link_stays_a_link(void **folder)
{
    clod_status status;
    struct stat info;
    char path[PATH_MAX];
    temp_write(folder, "behind", "old", 3);
    assert_int_equal(symlink("behind", temp_path(path, folder, "link")), 0);
    assert_true(clod_text_file_write(path, "none", "new", &status));
    assert_int_equal(lstat(path, &info), 0);
    assert_true(S_ISLNK(info.st_mode));
    expect_content(folder, "behind", "new");
}

static void what_is_no_file_is_written_to(void **folder)
{
    (void)folder;
    clod_status status;
    assert_true(clod_text_file_write("/dev/null", "none", "text", &status));
    assert_false(clod_text_file_write("/dev/full", "none", "text", &status));
    assert_int_equal(status.code, CLOD_FAILED);
    // no run, so no checkpoint to go on from
    assert_string_equal(status.text, "Cannot write /dev/full: No space left on device. Free "
                                     "some space, then give the same command again.");
}

static void a_folder_that_is_missing_is_told(void **folder)
{
    clod_status status;
    char path[PATH_MAX], text[2 * PATH_MAX];
    temp_path(path, folder, "none/out");
    assert_false(clod_text_file_write(path, "none", "text", &status));
    assert_int_equal(status.code, CLOD_FAILED);
    snprintf(text, sizeof text,
             "Cannot write %s: No such file or directory. Does the folder exist?", path);
    assert_string_equal(status.text, text);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_file_is_made_and_replaced),
        TEST(the_input_is_refused_by_any_name),
        TEST(a_link_stays_a_link),
        TEST(what_is_no_file_is_written_to),
        TEST(a_folder_that_is_missing_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
