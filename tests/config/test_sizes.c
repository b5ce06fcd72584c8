// Size distributions against closed forms.

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "config/sizes.h"
#include "support/check.h"

#define MIDPOINTS 200000

static clod_sizes normal(double mean, double sd, double min, double max)
{
    clod_sizes sizes;
    clod_status status = {0};
    assert_true(clod_sizes_init_normal(&sizes, mean, sd, min, max, &status));
    return sizes;
}

/** u in the middle of piece k of MIDPOINTS equal pieces of (0, 1). */
static double midpoint(int k)
{
    return (k + 0.5) / MIDPOINTS;
}

// Quantiles of the standard normal distribution from tables (Abramowitz & Stegun, table 26.5,
// and 1.959963984540054); cutting at 9 sd moves P by 1e-19, seen only in the last row.
static void normal_quantiles_match_tables(void **state)
{
    (void)state;
    const clod_sizes s = normal(10.0, 1.0, 1.0, 19.0);
    check_close(clod_sizes_quantile(&s, 0.975), 11.959963984540054, 1e-13);
    check_close(clod_sizes_quantile(&s, 0.025), 10.0 - 1.959963984540054, 1e-13);
    check_close(clod_sizes_quantile(&s, 0.9), 11.2815515655446, 1e-12);
    check_close(clod_sizes_quantile(&s, 0.999), 13.0902323061678, 1e-12);
    check_close(clod_sizes_quantile(&s, 1e-10), 10.0 - 6.36134090240406, 1e-9);
    check_close(clod_sizes_quantile(&s, 0.5), 10.0, 1e-15);
}

// Mean and variance of the doubly truncated normal distribution (Johnson, Kotz: with
// Z = P(b) - P(a): mean + sd (f(a) - f(b))/Z; sd^2 (1 + (a f(a) - b f(b))/Z - (..)^2)).
static void copper_ore_has_the_moments_of_a_truncated_normal(void **state)
{
    (void)state;
    const double mean = 3.175e-3;
    const double sd = 0.16e-3;
    const clod_sizes s = normal(mean, sd, 2.85e-3, 3.49e-3);
    const double a = (2.85e-3 - mean) / sd;
    const double b = (3.49e-3 - mean) / sd;
    const double fa = exp(-0.5 * a * a) / sqrt(2.0 * M_PI);
    const double fb = exp(-0.5 * b * b) / sqrt(2.0 * M_PI);
    const double z = 0.5 * (erf(b / sqrt(2.0)) - erf(a / sqrt(2.0)));
    const double first = (fa - fb) / z;
    double sum = 0.0;
    double squares = 0.0;
    for (int k = 0; k < MIDPOINTS; k++) {
        const double x = (clod_sizes_quantile(&s, midpoint(k)) - mean) / sd;
        assert_true(x >= a - 1e-12 && x <= b + 1e-12);
        sum += x / MIDPOINTS;
        squares += x * x / MIDPOINTS;
    }
    check_close(sum, first, 1e-6);
    check_close(squares - sum * sum, 1.0 + (a * fa - b * fb) / z - first * first, 1e-6);
}

// The distribution function, written with erfc on the side where it is small, gives u back:
// ends far in the upper tail, far in the lower, and on both sides.
static void quantile_is_the_inverse_also_in_tails(void **state)
{
    (void)state;
    const double ends[3][2] = {{5.0, 6.0}, {-6.0, -5.0}, {-0.5, 20.0}};
    for (int e = 0; e < 3; e++) {
        const double sign = ends[e][0] > 0.0 ? -1.0 : 1.0; // look from the small side
        const clod_sizes s = normal(100.0, 1.0, 100.0 + ends[e][0], 100.0 + ends[e][1]);
        const double from = erfc(-sign * ends[e][0] / sqrt(2.0));
        const double to = erfc(-sign * ends[e][1] / sqrt(2.0));
        for (int k = 0; k < 1000; k++) {
            const double u = (k + 0.5) / 1000.0;
            const double x = clod_sizes_quantile(&s, u) - 100.0;
            check_close((erfc(-sign * x / sqrt(2.0)) - from) / (to - from), u, 1e-11);
        }
    }
}

static void uniform_is_linear_and_one_size_is_one_size(void **state)
{
    (void)state;
    const clod_case_grains from = {
        .sizes = CLOD_SIZE_UNIFORM, .radius_min = 2.0, .radius_max = 4.0};
    clod_sizes s;
    clod_status status = {0};
    assert_true(clod_sizes_init(&s, &from, &status));
    check_close(clod_sizes_quantile(&s, 0.25), 2.5, 1e-15);
    const clod_sizes one = normal(3.0, 1.0, 3.0, 3.0);
    assert_true(clod_sizes_quantile(&one, 0.3) == 3.0);
}

static void empty_interval_is_refused(void **state)
{
    (void)state;
    clod_sizes s;
    clod_status status = {0};
    assert_false(clod_sizes_init_normal(&s, 1.0, 1e-3, 2.0, 3.0, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "move the mean between min and max"));
}

/** Mass of all grains finer than a diameter, as a fraction of all mass. */
static double mass_passing(const clod_sizes *s, double size)
{
    double all = 0.0;
    double finer = 0.0;
    for (int k = 0; k < MIDPOINTS; k++) {
        const double d = 2.0 * clod_sizes_quantile(s, midpoint(k));
        all += d * d * d;
        finer += d <= size ? d * d * d : 0.0;
    }
    return finer / all;
}

// The table itself, and, as mass is linear in log D within a class, half of a class's mass
// below the geometric mean of its ends. One class is empty.
static void sieve_table_comes_back_by_mass(void **state)
{
    (void)state;
    clod_case_sieve rows[] = {{1e-3, 0.0}, {2e-3, 0.1}, {3e-3, 0.5}, {4e-3, 0.5}, {8e-3, 1.0}};
    const clod_case_grains from = {.sizes = CLOD_SIZE_SIEVE, .sieve = rows, .sieve_count = 5};
    clod_sizes s;
    clod_status status = {0};
    assert_true(clod_sizes_init(&s, &from, &status));
    for (int r = 0; r < 5; r++) {
        check_close(mass_passing(&s, rows[r].size), rows[r].passing, 1e-3);
    }
    check_close(mass_passing(&s, sqrt(2e-3 * 3e-3)), 0.3, 1e-3);
    check_close(mass_passing(&s, sqrt(4e-3 * 8e-3)), 0.75, 1e-3);
    assert_true(s.min == 0.5e-3 && s.max == 4e-3);
    clod_sizes_fini(&s);
}

// One class by hand: D from 1 to 2, 1/D^3 uniform between 1 and 1/8; the median by number has
// 1/D^3 = 9/16.
static void sieve_median_by_number_by_hand(void **state)
{
    (void)state;
    clod_case_sieve rows[] = {{1.0, 0.0}, {2.0, 1.0}};
    const clod_case_grains from = {.sizes = CLOD_SIZE_SIEVE, .sieve = rows, .sieve_count = 2};
    clod_sizes s;
    clod_status status = {0};
    assert_true(clod_sizes_init(&s, &from, &status));
    check_close(clod_sizes_quantile(&s, 0.5), 0.5 * cbrt(16.0 / 9.0), 1e-15);
    clod_sizes_fini(&s);
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

// Kolmogorov and Smirnov: the largest distance from the uniform distribution stays below
// 1.63/sqrt(N) in 99 % of all cases; the seed is fixed.
static void drawn_radii_pass_kolmogorov_smirnov(void **state)
{
    (void)state;
    enum { N = 20000 };
    static double u[N];
    const clod_case_grains from = {
        .sizes = CLOD_SIZE_UNIFORM, .radius_min = 1.0, .radius_max = 2.0};
    clod_sizes s;
    clod_status status = {0};
    assert_true(clod_sizes_init(&s, &from, &status));
    for (uint64_t g = 0; g < N; g++) {
        u[g] = clod_sizes_radius(&s, 5, g + 1) - 1.0;
        assert_true(u[g] == clod_sizes_radius(&s, 5, g + 1) - 1.0);
    }
    assert_true(u[3] != clod_sizes_radius(&s, 6, 4) - 1.0);
    qsort(u, N, sizeof u[0], compare);
    double distance = 0.0;
    for (int k = 0; k < N; k++) {
        distance = fmax(distance, fabs(u[k] - (k + 0.5) / N) + 0.5 / N);
    }
    check_at_most(distance, 1.63 / sqrt(N));
}

// By hand: grains of radius 1 have 4.18879 m3 each; 10.4 m3 is nearer to 2 than to 3 of them,
// 10.6 m3 nearer to 3.
static void count_comes_nearest_to_the_volume(void **state)
{
    (void)state;
    double put;
    const clod_sizes s = normal(1.0, 1.0, 1.0, 1.0);
    assert_int_equal(clod_sizes_count(&s, 1, 1, 10.4, &put), 2);
    check_close(put, 8.37758040957278, 1e-12);
    assert_int_equal(clod_sizes_count(&s, 1, 1, 10.6, &put), 3);
    check_close(put, 12.56637061435917, 1e-12);
    assert_int_equal(clod_sizes_count(&s, 1, 1, 1e-9, &put), 1);
    check_close(put, 4.18879020478639, 1e-12);
}

// Mean volumes by number. Uniform from 1 to 3 by hand: 4/3 pi (81 - 1)/8 = 41.8879. Sieves from
// 1 to 2 by hand: 1/D^3 uniform between 1/8 and 1, so pi/6 ln(8)/(7/8) = 1.24433; a second,
// empty class changes nothing. Normal: E[r^3] = m^3 + 3 m s^2 when nothing is cut off (10 sd).
static void mean_volumes_by_hand(void **state)
{
    (void)state;
    clod_status status = {0};
    clod_case_sieve rows[] = {{1.0, 0.0}, {2.0, 1.0}, {4.0, 1.0}};
    const clod_case_grains sieve = {.sizes = CLOD_SIZE_SIEVE, .sieve = rows, .sieve_count = 3};
    const clod_case_grains uniform = {
        .sizes = CLOD_SIZE_UNIFORM, .radius_min = 1.0, .radius_max = 3.0};
    clod_sizes s;
    assert_true(clod_sizes_init(&s, &uniform, &status));
    check_close(clod_sizes_mean_volume(&s), 41.8879020478639, 1e-12);
    check_close(clod_sizes_largest_volume(&s), 113.0973355292326, 1e-12);
    assert_true(clod_sizes_init(&s, &sieve, &status));
    check_close(clod_sizes_mean_volume(&s), M_PI / 6.0 * log(8.0) / 0.875, 1e-12);
    clod_sizes_fini(&s);
    s = normal(10.0, 1.0, 1e-9, 20.0);
    check_relative(clod_sizes_mean_volume(&s), 4.0 / 3.0 * M_PI * 1030.0, 1e-4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normal_quantiles_match_tables),
        cmocka_unit_test(copper_ore_has_the_moments_of_a_truncated_normal),
        cmocka_unit_test(quantile_is_the_inverse_also_in_tails),
        cmocka_unit_test(uniform_is_linear_and_one_size_is_one_size),
        cmocka_unit_test(empty_interval_is_refused),
        cmocka_unit_test(sieve_table_comes_back_by_mass),
        cmocka_unit_test(sieve_median_by_number_by_hand),
        cmocka_unit_test(drawn_radii_pass_kolmogorov_smirnov),
        cmocka_unit_test(count_comes_nearest_to_the_volume),
        cmocka_unit_test(mean_volumes_by_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
