// Janssen's law and its fit, on points made up here.

#include "support/check.h"
#include "verify/saturation.h"

#define POINTS 12

/** 1 - 1/e = 0.632120558828557672 of saturation after one saturated mass (tables). */
static void the_law_has_its_values_by_hand(void **state)
{
    (void)state;
    check_relative(clod_verify_saturation_at(3.0, 3.0), 3.0 * 0.63212055882855767, 1e-15);
    check_relative(clod_verify_saturation_at(1e-6, 1e3), 1e-6, 1e-8); // shallow: hydrostatic
    check_relative(clod_verify_saturation_at(100.0, 2.0), 2.0, 1e-15);
}

/** Points of the law with a saturated mass of 0.7, written out by its ordinary formula. */
static void make_points(double *filled, double *apparent)
{
    for (int i = 0; i < POINTS; i++) {
        filled[i] = 0.25 * (i + 1);
        apparent[i] = 0.7 * (1.0 - exp(-filled[i] / 0.7));
    }
}

static void a_fit_finds_the_mass_it_was_made_with(void **state)
{
    (void)state;
    double filled[POINTS];
    double apparent[POINTS];
    make_points(filled, apparent);
    check_relative(clod_verify_saturation_fit(filled, apparent, POINTS), 0.7, 1e-7);
    // only shallow points, where law and hydrostatics differ by a few per cent
    check_relative(clod_verify_saturation_fit(filled, apparent, 1), 0.7, 1e-6);
}

/**
 * Scatter e_i that the law cannot follow leaves the fit where it was: to first order the shift
 * is sum(e s)/sum(s^2), s = d apparent/d saturated, so e is made orthogonal to s.
 */
static void a_fit_minimises_the_squares(void **state)
{
    (void)state;
    double filled[POINTS];
    double apparent[POINTS];
    double slope[POINTS];
    double along = 0.0;
    double square = 0.0;
    make_points(filled, apparent);
    for (int i = 0; i < POINTS; i++) {
        const double u = filled[i] / 0.7;
        slope[i] = 1.0 - exp(-u) - u * exp(-u);
        along += (i % 2 == 0 ? 1e-3 : -1e-3) * slope[i];
        square += slope[i] * slope[i];
    }
    for (int i = 0; i < POINTS; i++) {
        apparent[i] += (i % 2 == 0 ? 1e-3 : -1e-3) - along / square * slope[i];
    }
    check_relative(clod_verify_saturation_fit(filled, apparent, POINTS), 0.7, 1e-5);
}

/** All of it on the floor: the largest mass that is looked at. */
static void hydrostatic_points_do_not_saturate(void **state)
{
    (void)state;
    const double filled[] = {1.0, 2.0, 3.0};
    assert_true(clod_verify_saturation_fit(filled, filled, 3) > 2e3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_law_has_its_values_by_hand),
        cmocka_unit_test(a_fit_finds_the_mass_it_was_made_with),
        cmocka_unit_test(a_fit_minimises_the_squares),
        cmocka_unit_test(hydrostatic_points_do_not_saturate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
