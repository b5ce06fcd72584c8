// Deviations behind their values.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "analysis/prose.h"

/** By hand: the last of four digits of 1.007 is worth 0.001, of 27.28 0.01, of 9999.6, which is written 1e+04, 10. */
static void a_deviation_is_as_fine_as_its_value(void **state)
{
    (void)state;
    static const struct {
        double value, deviation;
        const char *text;
    } CASES[] = {
        {1.007, 0.1234, " +- 0.12"},    {1.007, 2.3e-16, " +- <0.001"},
        {1.007, 0.00049, " +- <0.001"}, {1.007, 0.00051, " +- 0.00051"},
        {27.28, 2.3e-7, " +- <0.01"},   {-27.28, 2.3e-7, " +- <0.01"},
        {9999.6, 4.0, " +- <10"},       {9999.4, 4.0, " +- 4"},
        {3.456e-5, 1e-9, " +- <1e-08"}, {123456.0, 60.0, " +- 60"},
        {1.007, 0.0, " +- 0"},          {0.0, 1e-17, " +- 1e-17"},
        {1.007, (double)NAN, ""},       {(double)NAN, 0.5, " +- 0.5"},
    };
    for (size_t k = 0; k < sizeof CASES / sizeof *CASES; k++) {
        char text[32];
        assert_string_equal(clod_prose_deviation(text, CASES[k].value, CASES[k].deviation),
                            CASES[k].text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_deviation_is_as_fine_as_its_value),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
