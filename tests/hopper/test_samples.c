// What the samples of a design tell: quantiles by hand, and shares of a spread that are known: exactly
// where the drawn values are orthogonal, and of normal numbers by the relation of Spearman's correlation
// to Pearson's.

#include "hopper/samples.h"

#include <string.h>

#include "base/random.h"
#include "support/check.h"

#define COUNT 8
#define MANY 4000

static void a_quantile_lies_straight_between_neighbours(void **state)
{
    (void)state;
    const double sorted[] = {1.0, 2.0, 4.0, (double)INFINITY};
    assert_true(clod_samples_quantile(sorted, 4, 0.0) == 1.0);
    check_close(clod_samples_quantile(sorted, 4, 0.5), 3.0, 1e-15);
    check_close(clod_samples_quantile(sorted, 4, 2.0 / 3.0), 4.0, 1e-15);
    assert_true(isinf(clod_samples_quantile(sorted, 4, 0.7)));
    assert_true(isinf(clod_samples_quantile(sorted, 4, 1.0)));
}

/** Of 0, 1, ... 400 the median is that of a share known to sqrt(0.25/401), which is 400 times as many of them; of the
 *  5 % the same with sqrt(0.05 x 0.95/401). Beyond an end there is nothing, and infinite ones make it infinite. */
static void an_end_is_known_to_its_share(void **state)
{
    (void)state;
    double sorted[401];
    for (int i = 0; i < 401; i++) {
        sorted[i] = i;
    }
    check_relative(clod_samples_quantile_error(sorted, 401, 0.5), 400.0 * 0.5 / sqrt(401.0),
                   1e-12);
    check_relative(clod_samples_quantile_error(sorted, 401, 0.05), 400.0 * sqrt(0.0475 / 401.0),
                   1e-12);
    check_relative(clod_samples_quantile_error(sorted, 3, 0.05), // from 0 to 2 (0.05 + 0.1258)
                   0.05 + sqrt(0.0475 / 3.0), 1e-12);
    for (int i = 380; i < 401; i++) {
        sorted[i] = (double)INFINITY;
    }
    assert_true(isinf(clod_samples_quantile_error(sorted, 401, 0.95)));
    for (int i = 0; i < 401; i++) {
        sorted[i] = (double)INFINITY;
    }
    assert_true(clod_samples_quantile_error(sorted, 401, 0.95) == 0.0);
}

/** Shares of up to two curves, strength and wall; the values stay as they are. */
static double shares_of(const double *a, const double *b, const double *outlet, size_t count,
                        double share[CLOD_SOLID_CURVES])
{
    static double copy[3][MANY];
    static clod_samples_item room[MANY];
    double *column[CLOD_SOLID_CURVES] = {NULL};
    column[CLOD_SOLID_STRENGTH] = memcpy(copy[0], a, count * sizeof *a);
    if (b != NULL) {
        column[CLOD_SOLID_WALL] = memcpy(copy[1], b, count * sizeof *b);
    }
    memcpy(copy[2], outlet, count * sizeof *outlet);
    return clod_samples_shares(column, copy[2], count, room, share);
}

/**
 * Two-level designs, whose columns are orthogonal, by hand. outlet = 3 + 2 a - b is 6, 4, 2 and 0,
 * twice each: ranks 7.5, 5.5, 3.5 and 1.5 go straight with it, so a has 4/5 and b 1/5.
 * outlet = 3 + 2 a - b + a b is 5 four times, 3 and -1 twice: ranks less their mean 2, -1 and -3,
 * squares 36; times a 16, so 16^2/(8 x 36) = 8/9; times b -4, so 1/18; no sum tells the other 1/18.
 */
static void shares_are_squares_of_correlations_of_ranks(void **state)
{
    (void)state;
    double a[COUNT], b[COUNT], sum[COUNT], outlet[COUNT], fixed[COUNT];
    double share[CLOD_SOLID_CURVES];
    for (int k = 0; k < COUNT; k++) {
        a[k] = k % 2 == 0 ? 1.0 : -1.0;
        b[k] = k % 4 < 2 ? 1.0 : -1.0;
        sum[k] = 3.0 + 2.0 * a[k] - b[k];
        outlet[k] = sum[k] + a[k] * b[k];
        fixed[k] = 1205.3;
    }
    check_close(shares_of(a, b, sum, COUNT, share), 0.0, 1e-14);
    check_close(share[CLOD_SOLID_STRENGTH], 4.0 / 5.0, 1e-14);
    check_close(share[CLOD_SOLID_WALL], 1.0 / 5.0, 1e-14);
    check_close(shares_of(a, b, outlet, COUNT, share), 1.0 / 18.0, 1e-14);
    check_close(share[CLOD_SOLID_STRENGTH], 8.0 / 9.0, 1e-14);
    check_close(share[CLOD_SOLID_WALL], 1.0 / 18.0, 1e-14);
    assert_true(isnan(share[CLOD_SOLID_RHO]));
    check_close(shares_of(a, fixed, outlet, COUNT, share), 1.0 / 9.0, 1e-14);
    assert_true(isnan(share[CLOD_SOLID_WALL])); // it has no errors
}

/** Curves of one yield locus move together: each tells what the other does, and it counts once. */
static void what_two_curves_tell_counts_once(void **state)
{
    (void)state;
    const double a[] = {1.0, 2.0, 3.0, 4.0, 5.0};
    const double twice[] = {10.0, 8.0, 6.0, 4.0, 2.0};
    double share[CLOD_SOLID_CURVES];
    check_close(shares_of(a, twice, a, 5, share), 0.0, 1e-14);
    check_close(share[CLOD_SOLID_STRENGTH], 1.0, 1e-14);
    check_close(share[CLOD_SOLID_WALL], 1.0, 1e-14);
}

/**
 * outlet = sqrt(0.8) x + sqrt(0.2) y of normal x and y, whose shares of the variance are 0.8 and 0.2,
 * told by heavy tails: x^9 rises with x, so that its ranks are those of x, but its correlation with
 * the outlet is small. E(x x^9) = 945, E(x^18) = 34 459 425: 0.8 x 945^2/34 459 425 = 0.021. Spearman's
 * correlation of normal numbers is 6/pi asin(r/2) (Pearson 1907): 0.784 and 0.185.
 * 4000 samples tell a correlation to 0.016.
 */
static void heavy_tails_do_not_hide_a_curve(void **state)
{
    (void)state;
    static double x[MANY], y[MANY], outlet[MANY];
    double share[CLOD_SOLID_CURVES], xx = 0.0, xo = 0.0, oo = 0.0;
    for (uint64_t k = 0; k < MANY; k++) {
        const double z = clod_random_normal(3, CLOD_RANDOM_MEASURED, k, 0);
        y[k] = clod_random_normal(3, CLOD_RANDOM_MEASURED, k, 2);
        outlet[k] = sqrt(0.8) * z + sqrt(0.2) * y[k];
        x[k] = pow(z, 9.0);
        xx += x[k] * x[k];
        xo += x[k] * outlet[k];
        oo += outlet[k] * outlet[k];
    }
    assert_true(xo * xo / (xx * oo) < 0.2); // what a straight line would tell of x
    const double rest = shares_of(x, y, outlet, MANY, share);
    check_close(share[CLOD_SOLID_STRENGTH], pow(6.0 / M_PI * asin(sqrt(0.8) / 2.0), 2.0), 0.03);
    check_close(share[CLOD_SOLID_WALL], pow(6.0 / M_PI * asin(sqrt(0.2) / 2.0), 2.0), 0.03);
    check_close(share[CLOD_SOLID_STRENGTH] + share[CLOD_SOLID_WALL] + rest, 1.0, 0.03);
}

/** No outlet large enough is the largest of all; without an outlet that differs nothing is known. */
static void an_infinite_outlet_is_the_largest(void **state)
{
    (void)state;
    const double a[] = {1.0, 5.0, 2.0, 4.0};
    const double outlet[] = {2.0, (double)INFINITY, 4.0, 6.0};
    double share[CLOD_SOLID_CURVES];
    check_close(shares_of(a, NULL, outlet, 4, share), 0.0, 1e-14);
    check_close(share[CLOD_SOLID_STRENGTH], 1.0, 1e-14);
    assert_true(isnan(shares_of(a, NULL, outlet, 2, share))); // two outlets
    assert_true(isnan(share[CLOD_SOLID_STRENGTH]));
    assert_true(isnan(shares_of(a, NULL, (double[]){2.0, 2.0, 2.0, 2.0}, 4, share)));
    assert_true(isnan(share[CLOD_SOLID_STRENGTH]));
}

/** Curves through (1, 1) and (3, 5): 3 at sigma_1 = 2, and on the wall 4 at sigma_w = 2.5. */
static void the_wall_is_looked_up_at_its_own_stress(void **state)
{
    (void)state;
    clod_curve_point points[] = {{.x = 1.0, .y = 1.0}, {.x = 3.0, .y = 5.0}};
    clod_solid solid = {0};
    double value[CLOD_SOLID_CURVES];
    for (int k = 0; k < CLOD_SOLID_CURVES; k++) {
        solid.curves[k] = (clod_curve){.points = points, .count = 2};
    }
    solid.phi_t.count = 0;
    clod_samples_values(&solid, &(clod_solid_state){.sigma_1 = 2.0, .sigma_w = 2.5}, value);
    check_close(value[CLOD_SOLID_STRENGTH], 3.0, 1e-15);
    check_close(value[CLOD_SOLID_PHI_E], 3.0, 1e-15);
    check_close(value[CLOD_SOLID_RHO], 3.0, 1e-15);
    check_close(value[CLOD_SOLID_WALL], 4.0, 1e-15);
    assert_true(isnan(value[CLOD_SOLID_PHI_T]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_quantile_lies_straight_between_neighbours),
        cmocka_unit_test(an_end_is_known_to_its_share),
        cmocka_unit_test(shares_are_squares_of_correlations_of_ranks),
        cmocka_unit_test(what_two_curves_tell_counts_once),
        cmocka_unit_test(heavy_tails_do_not_hide_a_curve),
        cmocka_unit_test(an_infinite_outlet_is_the_largest),
        cmocka_unit_test(the_wall_is_looked_up_at_its_own_stress),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
