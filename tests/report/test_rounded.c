// Values up to the second digit of their errors, and the whole numbers behind them.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/rounded.h"

/** What is written for a value, as text. */
static char *written(double value, double error, double scatter, int digits)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    assert_non_null(out);
    clod_rounded_put(clod_writer_page(out), value, error, scatter, digits, "");
    return clod_text_close(&text);
}

/** By hand: the error has two digits, after it is rounded; the value ends with it. */
static void a_value_ends_with_the_second_digit_of_its_error(void **state)
{
    (void)state;
    static const struct {
        double value, error, scatter;
        const char *wanted;
    } CASES[] = {
        {25.21541, 4.6017, (double)NAN, "25.2 <small>&plusmn; 4.6</small>"},
        {105.859, 14.931, (double)NAN, "106 <small>&plusmn; 15</small>"},
        {2034.7, 123.4, (double)NAN, "2030 <small>&plusmn; 120</small>"},
        {-0.5012, 0.0996, (double)NAN, "-0.50 <small>&plusmn; 0.10</small>"},
        {9.999, 0.0951, 0.2853, "9.999 <small>&plusmn; 0.095</small> <small>(s 0.285)</small>"},
        {-0.0001, 0.4, (double)NAN, "0.00 <small>&plusmn; 0.40</small>"},
        {1.234e-7, 3.04e-8, (double)NAN, "1.23e-7 <small>&plusmn; 0.30e-7</small>"},
        {28.1592657, 7.054e-5, (double)NAN, "28.1593 <small>&plusmn; 0.0001</small>"},
        {0.2999842, 9.8e-7, (double)NAN, "0.299984 <small>&plusmn; 0.000001</small>"},
        {0.0749817, 3.1e-7, 6.2e-7,
         "0.0749817 <small>&plusmn; 0.0000003</small> <small>(s 0.0000006)</small>"},
        {0.0012345, 2.1e-6, (double)NAN, "0.0012345 <small>&plusmn; 0.0000021</small>"},
        {0.00091234, 2.1e-6, (double)NAN, "9.123e-4 <small>&plusmn; 0.021e-4</small>"},
        {28.1592657, 7.054e-9, (double)NAN, "28.159"}, // no error to look at
        {1.0, 20.0, (double)NAN, "1 <small>&plusmn; 20</small>"},
    };
    for (size_t k = 0; k < sizeof CASES / sizeof *CASES; k++) {
        char *text = written(CASES[k].value, CASES[k].error, CASES[k].scatter, 3);
        assert_string_equal(text, CASES[k].wanted);
        clod_memory_free(text);
    }
}

static void a_value_without_an_error_has_its_digits(void **state)
{
    (void)state;
    static const double NONE[] = {(double)NAN, 0.0, (double)INFINITY};
    for (size_t k = 0; k < sizeof NONE / sizeof *NONE; k++) {
        char *text = written(54.8, NONE[k], (double)NAN, 3);
        assert_string_equal(text, "54.800");
        clod_memory_free(text);
    }
    char *text = written(0.000123456, (double)NAN, (double)NAN, CLOD_ROUNDED_SHORT);
    assert_string_equal(text, "0.0001235");
    clod_memory_free(text);
}

static void the_title_has_the_whole_numbers(void **state)
{
    (void)state;
    clod_text text;
    FILE *out = clod_text_open(&text);
    clod_rounded_begin(out, "td", 25215.41904459271, 4601.701631984499, "Pa");
    clod_rounded_begin(out, "b", 0.1, (double)NAN, "");
    clod_rounded_begin(out, "b", (double)NAN, 1.0, "Pa");
    char *told = clod_text_close(&text);
    assert_string_equal(
        told,
        "<td title=\"25215.41904459271 &plusmn; 4601.701631984499 Pa\"><b title=\"0.1\"><b>");
    clod_memory_free(told);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_value_ends_with_the_second_digit_of_its_error),
        cmocka_unit_test(a_value_without_an_error_has_its_digits),
        cmocka_unit_test(the_title_has_the_whole_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
