// Checkpoints that cannot be read or written: an error is told, and not taken for no
// checkpoint.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "output/checkpoint.h"

#include "temp_folder.h"

static bool write_empty(void **folder, clod_status *status)
{
    const clod_state empty = {0};
    return clod_checkpoint_write(temp_folder(folder), "restart", &empty, NULL, NULL, 0, NULL,
                                 status);
}

static void a_removed_folder_is_told(void **folder)
{
    clod_status status;
    char gone[PATH_MAX], text[2 * PATH_MAX];
    temp_path(gone, folder, "gone");
    const clod_state empty = {0};
    assert_int_equal(mkdir(gone, 0777), 0);
    clod_folder *opened = clod_folder_look(gone, &status);
    assert_int_equal(rmdir(gone), 0);
    assert_false(
        clod_checkpoint_write(opened, "restart", &empty, NULL, NULL, 0, NULL, &status));
    snprintf(text, sizeof text,
             "Cannot write %s/restart_a.h5: No such file or directory. Does the folder exist?",
             gone);
    assert_string_equal(status.text, text);
    clod_folder_close(&opened);
}

/** Only ENOENT says that there is none: every other error (a link in circles, here) stops. */
static void an_error_is_not_taken_for_no_checkpoint(void **folder)
{
    for (int f = 0; f < 2; f++) {
        clod_status status;
        char path[PATH_MAX], notice[2048];
        bool exists = false;
        clod_state found = {0};
        assert_true(write_empty(folder, &status));
        assert_true(write_empty(folder, &status));
        temp_path(path, folder, f == 0 ? "restart_a.h5" : "restart_b.h5");
        assert_int_equal(unlink(path), 0);
        assert_int_equal(symlink(path, path), 0);
        assert_true(clod_checkpoint_exists(temp_folder(folder), "restart", &exists, &status));
        assert_true(exists);
        assert_false(clod_checkpoint_read(temp_folder(folder), "restart", &found, NULL, 0, NULL,
                                          notice, sizeof notice, &status));
        assert_non_null(strstr(status.text, "Too many levels of symbolic links"));
        assert_non_null(strstr(status.text, path));
        assert_false(write_empty(folder, &status)); // it may be the good one
        assert_int_equal(unlink(path), 0);
        clod_state_fini(&found);
    }
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(a_removed_folder_is_told),
        FOLDER_TEST(an_error_is_not_taken_for_no_checkpoint),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
