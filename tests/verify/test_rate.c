// Rates and exponents of made-up discharges, against numbers by hand.

#include "support/check.h"
#include "verify/rate.h"

#define COUNT 81

static void a_steady_discharge_has_its_rate_and_no_error(void **state)
{
    (void)state;
    double time[COUNT];
    double mass[COUNT];
    double error;
    for (int k = 0; k < COUNT; k++) {
        time[k] = 0.5 + 0.25 * k;
        mass[k] = 7.0 + 3.0 * time[k];
    }
    check_relative(clod_verify_rate_of(time, mass, COUNT, &error), 3.0, 1e-13);
    check_close(error, 0.0, 1e-12);
}

/**
 * 1 kg/s before and 3 kg/s after the middle: the line has (1/3 + 3/3)/(2/3) = 2; of eight
 * blocks four have 1 and four have 3, so their variance is 8/7 and the error of the mean
 * sqrt(1/7).
 */
static void the_error_is_the_scatter_of_the_blocks(void **state)
{
    (void)state;
    double time[COUNT];
    double mass[COUNT];
    double error;
    for (int k = 0; k < COUNT; k++) {
        time[k] = (k - 40) / 40.0;
        mass[k] = time[k] * (time[k] < 0.0 ? 1.0 : 3.0);
    }
    check_relative(clod_verify_rate_of(time, mass, COUNT, &error), 2.0, 1e-13);
    check_relative(error, sqrt(1.0 / 7.0), 1e-12);
}

/** Orifices whose ln(D/d - 1.4) is 0, 1, 2: the sum of squares about the mean is 2. */
static void law_of_exponent(double exponent, clod_verify_rate rates[3])
{
    for (int r = 0; r < 3; r++) {
        rates[r] = (clod_verify_rate){1.4 + exp(r), 0.7 * exp(exponent * r), 0.0};
    }
}

static void the_exponent_is_that_of_the_law(void **state)
{
    (void)state;
    double error;
    clod_verify_rate rates[3];
    law_of_exponent(2.5, rates);
    check_relative(clod_verify_rate_exponent(rates, 3, 1.4, &error), 2.5, 1e-12);
    check_close(error, 0.0, 1e-12);
    assert_true(clod_verify_rate_exponent(rates, 3, 1.9, &error) < 2.4); // another k, another n
}

/** 1 % on each rate: n is off by 0.01/sqrt(2). */
static void errors_of_the_rates_are_handed_on(void **state)
{
    (void)state;
    double error;
    clod_verify_rate rates[3];
    law_of_exponent(2.5, rates);
    for (int r = 0; r < 3; r++) {
        rates[r].error = 0.01 * rates[r].value;
    }
    clod_verify_rate_exponent(rates, 3, 1.4, &error);
    check_relative(error, 0.01 / sqrt(2.0), 1e-9);
}

/** The middle 3 e above the others: residuals -e, 2 e, -e, variance of n 6 e^2/1/2. */
static void scatter_about_the_line_counts_when_it_is_larger(void **state)
{
    (void)state;
    double error;
    const double e = 0.02;
    clod_verify_rate rates[3];
    law_of_exponent(2.5, rates);
    rates[1].value *= exp(3.0 * e);
    check_relative(clod_verify_rate_exponent(rates, 3, 1.4, &error), 2.5, 1e-12);
    check_relative(error, sqrt(3.0) * e, 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_steady_discharge_has_its_rate_and_no_error),
        cmocka_unit_test(the_error_is_the_scatter_of_the_blocks),
        cmocka_unit_test(the_exponent_is_that_of_the_law),
        cmocka_unit_test(errors_of_the_rates_are_handed_on),
        cmocka_unit_test(scatter_about_the_line_counts_when_it_is_larger),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
