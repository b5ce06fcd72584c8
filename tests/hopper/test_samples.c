// What the samples of a design tell: quantiles by hand, and shares of a variance that are known
// exactly because the drawn values are orthogonal.

#include "hopper/samples.h"
#include "support/check.h"

#define COUNT 8

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

/** outlet = 3 + 2 a - b + a b: the columns of a two-level design are orthogonal and of variance 1,
 *  so of the variance 4 + 1 + 1 the value a explains 4/6, b 1/6, and 1/6 is of second order. */
static void shares_are_squares_of_correlations(void **state)
{
    (void)state;
    double a[COUNT], b[COUNT], outlet[COUNT], fixed[COUNT];
    for (int k = 0; k < COUNT; k++) {
        a[k] = k % 2 == 0 ? 1.0 : -1.0;
        b[k] = k % 4 < 2 ? 1.0 : -1.0;
        outlet[k] = 3.0 + 2.0 * a[k] - b[k] + a[k] * b[k];
        fixed[k] = 1205.3;
    }
    check_close(clod_samples_share(a, outlet, COUNT), 4.0 / 6.0, 1e-14);
    check_close(clod_samples_share(b, outlet, COUNT), 1.0 / 6.0, 1e-14);
    assert_true(clod_samples_share(fixed, outlet, COUNT) == 0.0);
}

/** The same with rows of no arch that stands at no size, or of no known state, between them. */
static void samples_without_an_outlet_are_left_out(void **state)
{
    (void)state;
    const double a[] = {1.0, 5.0, 2.0, 7.0, 3.0, 4.0};
    const double outlet[] = {2.0, (double)INFINITY, 4.0, (double)NAN, 6.0, 8.0};
    check_close(clod_samples_share(a, outlet, 6), 1.0, 1e-14);
    assert_true(isnan(clod_samples_share(a, outlet, 4)));                         // two outlets
    assert_true(isnan(clod_samples_share(a, (double[]){2.0, 2.0, 2.0, 2.0}, 4))); // no variance
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
        cmocka_unit_test(shares_are_squares_of_correlations),
        cmocka_unit_test(samples_without_an_outlet_are_left_out),
        cmocka_unit_test(the_wall_is_looked_up_at_its_own_stress),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
