// Points of specimens that rested between preshear and shear.

#include "locus_helpers.h"

static bool seem_stored(const clod_locus_point *points)
{
    clod_locus locus = evaluate(points, 4);
    const bool found =
        has_warning(&locus, "Shear at 7.500 kPa has a higher peak than preshear.");
    clod_locus_fini(&locus);
    return found;
}

// Twice the stated errors of both, 2 sqrt(2) 0.3 = 0.85 kPa, or a tenth of preshear without: 8.2 kPa at 7.5 kPa.
static void peaks_above_preshear(void **state)
{
    (void)state;
    clod_locus_point points[4];
    good_points(points); // preshear 7.6 kPa
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_s += 8.2e3 - 1e3 - 7.5e3 * tan(35.0 * DEG);
    }
    assert_false(seem_stored(points));
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_p = 7.4e3;
    }
    assert_true(seem_stored(points));
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_s_error = points[i].tau_p_error = 300.0;
    }
    assert_false(seem_stored(points));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(peaks_above_preshear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
