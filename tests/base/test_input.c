// Files read whole: any size, pipes, and what is said of those that cannot be read.

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/input.h"
#include "base/memory.h"
#include "support/check.h"

static void write_file(const char *path, const char *text, size_t length)
{
    FILE *out = fopen(path, "wb");
    assert_non_null(out);
    assert_int_equal(fwrite(text, 1, length, out), length);
    assert_int_equal(fclose(out), 0);
}

// Around the first room of 64 KiB, where the room grows, and with nothing in it.
static void every_size_comes_back(void **state)
{
    (void)state;
    static const size_t SIZES[] = {0, 1, 65534, 65535, 65536, 65537, 131072, 300000};
    char path[] = "/tmp/clod-input-XXXXXX";
    const int made = mkstemp(path);
    assert_true(made >= 0);
    close(made);
    for (size_t s = 0; s < sizeof SIZES / sizeof *SIZES; s++) {
        char *text = malloc(SIZES[s] + 1);
        assert_non_null(text);
        for (size_t i = 0; i < SIZES[s]; i++) {
            text[i] = (char)('a' + i % 23);
        }
        write_file(path, text, SIZES[s]);
        clod_status status = {0};
        char *found;
        size_t length;
        assert_true(clod_input_read(path, SIZE_MAX, &found, &length, &status));
        assert_int_equal(length, SIZES[s]);
        assert_memory_equal(found, text, length);
        assert_int_equal(found[length], 0);
        clod_memory_free(found);
        assert_true(clod_input_read(path, 100, &found, &length, &status));
        assert_int_equal(length, SIZES[s] < 100 ? SIZES[s] : 100);
        assert_int_equal(found[length], 0);
        clod_memory_free(found);
        free(text);
    }
    unlink(path);
}

static void expect_refused(const char *path, const char *message)
{
    clod_status status = {0};
    char *text;
    size_t length;
    assert_false(clod_input_read(path, SIZE_MAX, &text, &length, &status));
    assert_null(text);
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(status.text, message);
}

static void what_cannot_be_read_is_told(void **state)
{
    (void)state;
    expect_refused("no/such", "no/such: cannot be opened: No such file or directory");
    expect_refused("/", "/: cannot be read: Is a directory; name a file in it");
    expect_refused("/dev/null/x", "/dev/null/x: cannot be opened: Not a directory");
}

// A regular file of at most so many bytes; a pipe that nobody writes to does not hold it up.
static void only_regular_files_of_a_size_are_read(void **state)
{
    (void)state;
    char path[] = "/tmp/clod-input-XXXXXX", pipe[] = "/tmp/clod-input-pipe-XXXXXX";
    clod_status status = {0};
    char *text;
    size_t length;
    const int made = mkstemp(path);
    assert_true(made >= 0);
    assert_int_equal(ftruncate(made, 5000000000), 0); // no blocks on the disk
    assert_false(clod_input_read_regular(path, 2000000000, &text, &length, &status));
    assert_null(text);
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, ": the file has 5 GB; 2 GB are read at most"));
    assert_int_equal(ftruncate(made, 0), 0);
    assert_int_equal(write(made, "ab\0cd", 5), 5);
    close(made);
    assert_true(clod_input_read_regular(path, 5, &text, &length, &status));
    assert_int_equal(length, 5);
    assert_memory_equal(text, "ab\0cd", 6);
    clod_memory_free(text);
    assert_false(clod_input_read_regular(path, 4, &text, &length, &status));
    unlink(path);
    close(mkstemp(pipe));
    unlink(pipe);
    assert_int_equal(mkfifo(pipe, 0600), 0);
    const char *const others[] = {pipe, "/dev/zero"};
    for (int k = 0; k < 2; k++) {
        assert_false(clod_input_read_regular(others[k], 100, &text, &length, &status));
        assert_int_equal(status.code, CLOD_USAGE);
        assert_non_null(strstr(status.text, ": it is no regular file"));
    }
    unlink(pipe);
    assert_false(clod_input_read_regular("/", 100, &text, &length, &status));
    assert_string_equal(status.text, "/: cannot be read: Is a directory; name a file in it");
}

static void the_byte_order_mark_is_found(void **state)
{
    (void)state;
    assert_int_equal(clod_input_mark("\xEF\xBB\xBFx"), 3);
    assert_int_equal(clod_input_mark("\xEF\xBB"), 0);
    assert_int_equal(clod_input_mark("x\xEF\xBB\xBF"), 0);
    assert_int_equal(clod_input_mark(""), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_size_comes_back),
        cmocka_unit_test(what_cannot_be_read_is_told),
        cmocka_unit_test(only_regular_files_of_a_size_are_read),
        cmocka_unit_test(the_byte_order_mark_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
