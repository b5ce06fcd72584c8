// The Runge-Kutta pair, on equations with known solutions.

#include "hopper/ode.h"
#include "support/check.h"

/** a' = b, b' = -a: from (0, 1) sine and cosine. */
static clod_ode_pair turn(const void *context, double x, clod_ode_pair y)
{
    (void)context;
    (void)x;
    return (clod_ode_pair){y.b, -y.a};
}

/** a' = 5 x^4, b' = 4 x^3: of order 5 exact, for they have no more than five derivatives. */
static clod_ode_pair powers(const void *context, double x, clod_ode_pair y)
{
    (void)context;
    (void)y;
    return (clod_ode_pair){5.0 * x * x * x * x, 4.0 * x * x * x};
}

/** a' = 1/(1 - x) reaches its pole at x = 1. */
static clod_ode_pair pole(const void *context, double x, clod_ode_pair y)
{
    (void)context;
    (void)y;
    return (clod_ode_pair){1.0 / ((1.0 - x) * (1.0 - x)), 0.0};
}

static void a_step_is_exact_for_polynomials_of_its_order(void **state)
{
    (void)state;
    const clod_ode ode = {.rates = powers};
    const clod_ode_pair y = clod_ode_try(&ode, 2.0, NULL);
    check_close(y.a, 32.0, 1e-13);
    check_close(y.b, 16.0, 1e-13);
}

/** Of order 5: the error of a step falls with its sixth power, or faster where that term is zero. */
static void the_error_of_a_step_falls_with_its_sixth_power(void **state)
{
    (void)state;
    const clod_ode ode = {.rates = turn, .y = {0.0, 1.0}};
    const double whole = fabs(clod_ode_try(&ode, 0.4, NULL).a - sin(0.4));
    const double half = fabs(clod_ode_try(&ode, 0.2, NULL).a - sin(0.2));
    check_at_least(log2(whole / half), 5.9);
    double told;
    clod_ode_try(&ode, 0.4, &told);
    check_at_least(told, 0.5 * whole); // the pair sees an error of order 5: larger
}

static double end_of_turn(double tolerance)
{
    clod_ode ode = {.rates = turn, .tolerance = tolerance, .y = {0.0, 1.0}, .step = 0.1};
    while (ode.x < 20.0) {
        assert_true(clod_ode_advance(&ode, 20.0));
    }
    assert_true(ode.x == 20.0);
    return ode.y.a;
}

static void errors_follow_the_tolerance(void **state)
{
    (void)state;
    check_close(end_of_turn(1e-6), sin(20.0), 1e-4);
    check_close(end_of_turn(1e-10), sin(20.0), 1e-8);
}

static void a_pole_ends_the_steps(void **state)
{
    (void)state;
    clod_ode ode = {.rates = pole, .tolerance = 1e-8, .step = 0.1};
    int steps = 0;
    while (clod_ode_advance(&ode, 2.0) && steps < 100000) {
        steps++;
    }
    assert_true(steps < 100000);
    check_close(ode.x, 1.0, 1e-3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_is_exact_for_polynomials_of_its_order),
        cmocka_unit_test(the_error_of_a_step_falls_with_its_sixth_power),
        cmocka_unit_test(errors_follow_the_tolerance),
        cmocka_unit_test(a_pole_ends_the_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
