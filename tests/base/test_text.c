/**
 * Texts written piece by piece: whole, and of any length.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "base/text.h"

static void an_empty_text(void **state)
{
    (void)state;
    clod_text text;
    assert_non_null(clod_text_open(&text));
    char *whole = clod_text_close(&text);
    assert_string_equal(whole, "");
    clod_memory_free(whole);
}

/** Longer than any buffer on the way; expected: what snprintf writes. */
static void a_long_text(void **state)
{
    (void)state;
    enum { LINES = 20000, WIDTH = 12 };
    clod_text text;
    FILE *out = clod_text_open(&text);
    assert_non_null(out);
    for (int i = 0; i < LINES; i++) {
        assert_int_equal(fprintf(out, "%11d\n", i), WIDTH);
    }
    char *whole = clod_text_close(&text);
    assert_non_null(whole);
    assert_int_equal(strlen(whole), LINES * WIDTH);
    for (int i = 0; i < LINES; i++) {
        char line[WIDTH + 1];
        snprintf(line, sizeof line, "%11d\n", i);
        assert_memory_equal(whole + (size_t)i * WIDTH, line, WIDTH);
    }
    clod_memory_free(whole);
}

/** Every length about the first room: the 0 at the end fits always (under the sanitizers). */
static void every_length(void **state)
{
    (void)state;
    for (size_t length = 1000; length < 1100; length++) {
        clod_text text;
        FILE *out = clod_text_open(&text);
        assert_non_null(out);
        for (size_t i = 0; i < length; i++) {
            fputc('x', out);
        }
        char *whole = clod_text_close(&text);
        assert_int_equal(strlen(whole), length);
        clod_memory_free(whole);
    }
}

/** Unicode, table 3-7: sequences that are well formed stay; of others, and of controls, each byte is a ?. */
static void what_is_no_text_is_replaced(void **state)
{
    (void)state;
    static const char *const CASES[][2] = {
        {"", ""},
        {"plate 1", "plate 1"},
        {"Bl\xC3\xA4tter \xE2\x82\xAC \xF0\x9F\x98\x80",
         "Bl\xC3\xA4tter \xE2\x82\xAC \xF0\x9F\x98\x80"},
        {"\x1B[31m\t\x7F", "?[31m??"},
        {"Bl\xE4tter", "Bl?tter"},                     // Latin-1
        {"\xC2\x9B\xC2\xA0", "??\xC2\xA0"},            // a control of Unicode, no-break space
        {"\xC0\xAF|\xE0\x80\xAF", "??|???"},           // overlong
        {"\xED\xA0\x80|\xF4\x90\x80\x80", "???|????"}, // surrogate, beyond U+10FFFF
        {"a\xE2\x82", "a??"},                          // cut off
    };
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        char text[32];
        snprintf(text, sizeof text, "%s", CASES[k][0]);
        clod_text_printable(text);
        assert_string_equal(text, CASES[k][1]);
    }
}

/** Whole where it has room; else of 20 bytes or 20 characters a third and the end, and no half character. */
static void a_text_that_is_too_long_keeps_its_end(void **state)
{
    (void)state;
#define A "\xC3\xA4"
#define E "\xE2\x82\xAC"
    static const struct {
        size_t size, most;
        const char *from, *to;
    } CASES[] = {
        {21, 99, "", ""},
        {21, 99, "abcdefghijklmnopqrst", "abcdefghijklmnopqrst"},
        {21, 99, "abcdefghijklmnopqrstu", "abcdef...klmnopqrstu"},
        {99, 20, "abcdefghijklmnopqrstu", "abcdef...klmnopqrstu"},
        {21, 99, A A A A A A A A A A, A A A A A A A A A A},
        {21, 99, "a" A A A A A A A A A A, "a" A A "..." A A A A A A}, // 5 and 12 bytes
        {99, 8, A A A A A A A A "a", A A "..." A A "a"},
        {21, 99, E E E E E E E, E E "..." E E E},
    };
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        char text[100];
        clod_text_fit(text, CASES[k].size, CASES[k].most, CASES[k].from, strlen(CASES[k].from));
        assert_string_equal(text, CASES[k].to);
    }
    assert_int_equal(clod_text_characters("a" A E), 3);
}

static void names_that_have_no_room_are_counted(void **state)
{
    (void)state;
    static const char *const NAMES[] = {"one", "a name of 18 bytes", "two", "three"};
    static const struct {
        size_t size, count;
        const char *text;
    } CASES[] = {
        {64, 0, ""},
        {64, 1, "one"},
        {64, 4, "one, a name of 18 bytes, two and 1 more"}, // 28 bytes, 35 with ", three"
        {56, 4, "one, a name of 18 bytes and 2 more"},      // 23 bytes and the zero
        {55, 4, "one and 3 more"},
        {35, 4, "4 more"}};
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        char text[64];
        clod_text_names names = clod_text_names_begin(text, CASES[k].size);
        for (size_t n = 0; n < CASES[k].count; n++) {
            clod_text_names_add(&names, NAMES[n]);
        }
        clod_text_names_end(&names);
        assert_string_equal(text, CASES[k].text);
    }
}

static void texts_that_differ_in_numbers_alone(void **state)
{
    (void)state;
    static const struct {
        const char *one, *other;
        bool alike;
    } CASES[] = {
        {"at 0.600 kPa: 27.8 +- 4.5 deg", "at 1.2 kPa: 22 +- 13.8 deg", true},
        {"5 of 12.", "117 of 3.", true},
        {"1e-06 kg", "0.25 kg", true},
        {"", "", true},
        {"the same", "the same", true},
        {"5 of 12.", "5 of 12", false},
        {"5 of 12", "5 of 12 more", false},
        {"5 kPa", "-5 kPa", false},
        {"5 kPa", "none kPa", false},
        {"Cone: 5", "Wedge: 5", false},
        {"12e", "12", false},
    };
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        const char *one = CASES[k].one, *other = CASES[k].other;
        assert_int_equal(clod_text_alike(one, strlen(one), other, strlen(other)),
                         CASES[k].alike);
        assert_int_equal(clod_text_alike(other, strlen(other), one, strlen(one)),
                         CASES[k].alike);
    }
    assert_true(clod_text_alike("123", 1, "4.5", 3)); // no further than the length
    assert_true(clod_text_alike("1.5", 2, "2.", 2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_empty_text),
        cmocka_unit_test(a_long_text),
        cmocka_unit_test(every_length),
        cmocka_unit_test(what_is_no_text_is_replaced),
        cmocka_unit_test(a_text_that_is_too_long_keeps_its_end),
        cmocka_unit_test(names_that_have_no_room_are_counted),
        cmocka_unit_test(texts_that_differ_in_numbers_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
