// Whole files replaced at one stroke, and the hash behind checkpoints.

#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <sys/resource.h>

#include <cmocka.h>

#include "temp_folder.h"

static void a_file_is_made_and_replaced(void **folder)
{
    clod_status status;
    char path[PATH_MAX];
    size_t size;
    temp_path(path, folder, "file");
    assert_true(clod_file_replace(path, "head ", 5, "body", 4, &status));
    assert_true(clod_file_replace(path, "new ", 4, "text", 4, &status));
    char *text = temp_read(folder, "file", &size);
    assert_int_equal(size, 8);
    assert_string_equal(text, "new text");
    clod_memory_free(text);
    assert_false(temp_exists(folder, "file.part"));
}

static void a_failed_write_keeps_the_old_file(void **folder)
{
    clod_status status;
    char path[PATH_MAX];
    size_t size;
    char large[10000] = "";
    temp_path(path, folder, "file");
    assert_true(clod_file_replace(path, "old", 3, NULL, 0, &status));
    struct rlimit before;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    const struct rlimit full = {4096, before.rlim_max}; // stands for a full disk
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &full);
    const bool done = clod_file_replace(path, large, sizeof large, NULL, 0, &status);
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, SIG_DFL);
    assert_false(done);
    assert_int_equal(status.code, CLOD_FAILED);
    char *text = temp_read(folder, "file", &size);
    assert_string_equal(text, "old");
    clod_memory_free(text);
    assert_false(temp_exists(folder, "file.part"));
}

static void a_missing_file_is_told(void **folder)
{
    clod_status status;
    char path[PATH_MAX], text[2 * PATH_MAX];
    void *bytes;
    size_t size;
    temp_path(path, folder, "missing");
    assert_false(clod_file_read(path, &bytes, &size, &status));
    assert_null(bytes);
    snprintf(text, sizeof text, "Cannot read %s: No such file or directory.", path);
    assert_string_equal(status.text, text);
}

static void a_part_is_not_written_through_a_link(void **folder)
{
    clod_status status;
    char path[PATH_MAX], link[PATH_MAX], other[PATH_MAX];
    size_t size;
    temp_write(folder, "other", "mine", 4);
    assert_int_equal(
        symlink(temp_path(other, folder, "other"), temp_path(link, folder, "file.part")), 0);
    assert_false(
        clod_file_replace(temp_path(path, folder, "file"), "new", 3, NULL, 0, &status));
    char *text = temp_read(folder, "other", &size);
    assert_string_equal(text, "mine");
    clod_memory_free(text);
}

static void every_single_bit_changes_the_hash(void **folder)
{
    (void)folder;
    unsigned char bytes[100];
    for (size_t b = 0; b < sizeof bytes; b++) {
        bytes[b] = (unsigned char)(37 * b);
    }
    for (size_t size = 1; size <= sizeof bytes; size += 9) {
        const uint64_t whole = clod_file_hash(CLOD_FILE_HASH_START, bytes, size);
        assert_true(whole != clod_file_hash(CLOD_FILE_HASH_START, bytes, size - 1));
        for (size_t bit = 0; bit < 8 * size; bit++) {
            bytes[bit / 8] ^= (unsigned char)(1 << bit % 8);
            assert_true(whole != clod_file_hash(CLOD_FILE_HASH_START, bytes, size));
            bytes[bit / 8] ^= (unsigned char)(1 << bit % 8);
        }
    }
    // zeros at the end count too
    const unsigned char zeros[16] = {0};
    assert_true(clod_file_hash(CLOD_FILE_HASH_START, zeros, 8) !=
                clod_file_hash(CLOD_FILE_HASH_START, zeros, 9));
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(a_file_is_made_and_replaced),
        FOLDER_TEST(a_failed_write_keeps_the_old_file),
        FOLDER_TEST(a_missing_file_is_told),
        FOLDER_TEST(a_part_is_not_written_through_a_link),
        FOLDER_TEST(every_single_bit_changes_the_hash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
