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
        cmocka_unit_test(the_byte_order_mark_is_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
