// Impacts by class: bounds, sums, and what an impact is, by hand.

#include "state/impacts.h"
#include "support/check.h"

/** v = 5 m/s of 2 kg, 3 m/s of it into the surface: sin a = 3/5, 25 J and 9 J of it. */
static void an_impact_by_hand(void **unused)
{
    (void)unused;
    const clod_impact impact = clod_impact_of(2.0, 3.0, 25.0);
    check_close(impact.angle, 0.6435011087932844, 1e-15); // asin 0.6
    check_close(impact.speed, 5.0, 1e-15);
    check_close(impact.energy, 25.0, 1e-14);
    check_close(impact.normal, 9.0, 1e-15);
    // normal, where rounding leaves a square that is too small
    const clod_impact head_on = clod_impact_of(2.0, 3.0, nextafter(9.0, 0.0));
    check_close(head_on.angle, 0.5 * M_PI, 1e-15);
    check_close(head_on.energy, head_on.normal, 0.0);
}

/** 1, 2, 5 of each decade, from 1e-12 J to 1e6 J. */
static void bounds_of_energy(void **unused)
{
    (void)unused;
    check_close(clod_impacts_energy_from(0), 0.0, 0.0);
    for (int k = 0; k < CLOD_IMPACT_BOUNDS; k++) {
        const double first[] = {1.0, 2.0, 5.0};
        check_relative(clod_impacts_energy_from(1 + k), first[k % 3] * pow(10.0, k / 3 - 12),
                       1e-15);
    }
    assert_true(clod_impacts_energy_from(CLOD_IMPACT_BOUNDS) == 1e6);
    assert_true(isinf(clod_impacts_energy_from(CLOD_IMPACT_ENERGIES)));
}

static const double DEGREE = M_PI / 180.0;

/** An impact at each 5 degrees off the bounds, with the energies of both sides of each bound. */
static void each_goes_into_its_class(void **unused)
{
    (void)unused;
    static clod_impacts all;
    double number = 0.0, energy = 0.0;
    for (int a = 0; a < CLOD_IMPACT_ANGLES; a++) {
        for (int e = 1; e < CLOD_IMPACT_ENERGIES; e++) {
            const double bound = clod_impacts_energy_from(e);
            const double both[] = {nextafter(bound, 0.0), bound};
            for (int k = 0; k < 2; k++) {
                clod_impacts_add(&all, &(clod_impact){.angle = (10.0 * a + 5.0) * DEGREE,
                                                      .speed = 3.0,
                                                      .energy = 4.0 * both[k],
                                                      .normal = both[k]});
                number += 1.0;
                energy += both[k];
            }
        }
    }
    for (int a = 0; a < CLOD_IMPACT_ANGLES; a++) {
        // the lowest and the highest class have one side of a bound each
        for (int e = 0; e < CLOD_IMPACT_ENERGIES; e++) {
            assert_true(all.of[a][e].number ==
                        (e == 0 || e == CLOD_IMPACT_ENERGIES - 1 ? 1.0 : 2.0));
        }
        assert_true(clod_impacts_at_angle(&all, a).number == 2.0 * CLOD_IMPACT_BOUNDS);
    }
    assert_true(clod_impacts_with_energy(&all, 7).number == 2.0 * CLOD_IMPACT_ANGLES);
    check_relative(clod_impacts_with_energy(&all, 7).energy, 36.0 * (1e-10 + 2e-10), 1e-12);
    check_relative(clod_impacts_with_energy(&all, 7).normal, 9.0 * (1e-10 + 2e-10), 1e-12);
    assert_true(all.all.number == number);
    check_relative(all.all.energy, 4.0 * energy, 1e-12);
    check_relative(all.all.normal, energy, 1e-12);
    check_relative(all.all.speed2, 9.0 * number, 1e-12);
    check_relative(all.all.angle / number, 45.0 * DEGREE, 1e-12);
}

/** Class k is [10 k, 10 (k + 1)) degrees; 90 degrees belong to the last. */
static void angles_at_the_ends(void **unused)
{
    (void)unused;
    static clod_impacts all;
    const double angle[] = {0.0, 9.999 * DEGREE, 10.001 * DEGREE, 79.999 * DEGREE, 0.5 * M_PI};
    for (int k = 0; k < 5; k++) {
        clod_impacts_add(&all, &(clod_impact){.angle = angle[k], .normal = 1.0});
    }
    const double expected[CLOD_IMPACT_ANGLES] = {2.0, 1.0, 0, 0, 0, 0, 0, 1.0, 1.0};
    for (int a = 0; a < CLOD_IMPACT_ANGLES; a++) {
        assert_true(clod_impacts_at_angle(&all, a).number == expected[a]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_impact_by_hand),
        cmocka_unit_test(bounds_of_energy),
        cmocka_unit_test(each_goes_into_its_class),
        cmocka_unit_test(angles_at_the_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
