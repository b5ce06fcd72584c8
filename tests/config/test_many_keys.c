/**
 * Case files with very many wrong keys are answered in a time that grows with their length, not
 * with its square.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "clod/case.h"
#include "config/arena.h"
#include "config/index.h"
#include "support/sanitized.h"

enum { FEW = 3000, TIMES = 16 };

/** Sixteen times the lines; the square would be 256 times the work. */
#define LARGEST_RATIO (4.0 * TIMES)

/** A file of `count` lines between a head and nothing. */
static char *make_text(const char *head, const char *format, int count)
{
    const size_t size = strlen(head) + (size_t)count * (strlen(format) + 8) + 1;
    char *text = malloc(size);
    assert_non_null(text);
    size_t used = (size_t)snprintf(text, size, "%s", head);
    for (int i = 0; i < count; i++) {
        used += (size_t)snprintf(text + used, size - used, format, i);
    }
    return text;
}

/** Processor seconds that a refusal takes. */
static double seconds(const char *head, const char *format, int count)
{
    char *text = make_text(head, format, count);
    clod_status status = {CLOD_OK, ""};
    const clock_t start = clock();
    const clod_case *self = clod_case_parse("many.yaml", text, strlen(text), NULL, 0, &status);
    const clock_t end = clock();
    assert_null(self);
    assert_int_equal(status.code, CLOD_USAGE);
    free(text);
    return (double)(end - start) / CLOCKS_PER_SEC;
}

static void check_growth(const char *head, const char *format)
{
    seconds(head, format, FEW); // what is done once
    if (sanitized()) {
        return; // how long it takes is a matter of the normal tree
    }
    const double few = seconds(head, format, FEW);
    const double many = seconds(head, format, FEW * TIMES);
    print_message("%s%s: %.4f s, %.4f s\n", head, format, few, many);
    assert_true(many < LARGEST_RATIO * few);
}

static void errors_take_linear_time(void **state)
{
    (void)state;
    check_growth("", "k%05d: 1\n");                        // unknown keys
    check_growth("materials:\n  ore:\n", "   k%05d: 1\n"); // in a section
    check_growth("materials:\n", "  m%05d: 1\n");          // named sections
    check_growth("walls:\n", "  w%05d: {}\n");
    check_growth("contacts:\n", "  a%05d-b: {}\n");
    check_growth("grains:\n", "  - {count: %d}\n"); // elements
    check_growth("stages:\n", "  - {name: s%d}\n");
    check_growth("", "same: %d\n"); // one key again and again
}

/** Every one of many texts is found with its number, and no other. */
static void an_index_finds_all(void **state)
{
    (void)state;
    enum { COUNT = 5000 };
    static char texts[COUNT][8];
    clod_arena arena = {0};
    clod_index index = {0};
    assert_false(clod_index_find(&index, "", 0, NULL));
    for (size_t i = 0; i < COUNT; i++) {
        const int length = snprintf(texts[i], sizeof texts[i], "%zx", 7 * i);
        assert_true(clod_index_add(&index, &arena, texts[i], (size_t)length, i));
        assert_true(clod_index_add(&index, &arena, texts[i], (size_t)length, 0)); // keeps i
    }
    assert_int_equal(index.count, COUNT);
    for (size_t i = 0; i < 7 * COUNT; i++) {
        char text[8];
        size_t value = COUNT;
        const int length = snprintf(text, sizeof text, "%zx", i);
        assert_int_equal(clod_index_find(&index, text, (size_t)length, &value), i % 7 == 0);
        assert_int_equal(value, i % 7 == 0 ? i / 7 : COUNT);
    }
    clod_arena_fini(&arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_take_linear_time),
        cmocka_unit_test(an_index_finds_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
