// Lacey's mixing index of samples made by hand and by chance.

#include "measure/mixing.h"

#include <string.h>

#include "support/check.h"
#include "support/dice.h"

#define SAMPLES 200

static void segregated_is_zero(void **unused)
{
    (void)unused;
    const clod_mixing_sample pure[] = {{10, 10}, {0, 0}, {30, 0}, {10, 10}, {20, 0}};
    const clod_mixing of = clod_mixing_of(pure, 5);
    check_close(of.share, 20.0 / 70.0, 1e-15);
    check_close(of.segregated, 2.0 / 7.0 * 5.0 / 7.0, 1e-15);
    check_close(of.variance, of.segregated, 1e-15);
    check_close(of.index, 0.0, 1e-14);
    check_close(of.grains, 17.5, 0.0);                         // the empty one is no sample
    check_close(of.random, of.segregated * 3.0 / 69.0, 1e-15); // (K - 1)/(N - 1)
}

/** By hand: p = 1/2, S^2 = 1/16 of samples with 1/4 and 3/4 of 4 grains. */
static void between(void **unused)
{
    (void)unused;
    const clod_mixing_sample two[] = {{4, 1}, {4, 3}};
    const clod_mixing of = clod_mixing_of(two, 2);
    check_close(of.variance, 1.0 / 16.0, 1e-16);
    check_close(of.random, 0.25 / 7.0, 1e-16);
    check_close(of.index, (0.25 - 0.0625) / (0.25 - 0.25 / 7.0), 1e-15);
    // larger samples count more: 12 grains with 1/4, 4 with 3/4; p = 3/8
    const clod_mixing_sample unequal[] = {{12, 3}, {4, 3}};
    check_close(clod_mixing_of(unequal, 2).variance, (12.0 / 64.0 + 4.0 * 9.0 / 64.0) / 16.0,
                1e-16);
}

/** Draw samples of unequal size from an urn without putting back: mean variance and index over many
 *  mixtures are those of chance, p (1 - p)/n, within four standard errors. */
static void a_random_mixture_is_one(void **unused)
{
    (void)unused;
    enum { MIXTURES = 400, GRAINS = SAMPLES * 15 };
    static uint8_t urn[GRAINS];
    dice roll = {3};
    double sum = 0.0, squares = 0.0, share = 0.0, random = 0.0, variance = 0.0;
    for (int m = 0; m < MIXTURES; m++) {
        clod_mixing_sample samples[SAMPLES] = {{0, 0}};
        for (int g = 0; g < GRAINS; g++) {
            urn[g] = g < GRAINS * 3 / 10;
        }
        for (int g = GRAINS - 1; g > 0; g--) {
            const int other = dice_pick(&roll, g + 1);
            const uint8_t kept = urn[g];
            urn[g] = urn[other];
            urn[other] = kept;
        }
        for (int s = 0, g = 0; s < SAMPLES; s++) {
            const int size = s % 2 == 0 ? 10 : 20;
            for (int k = 0; k < size; k++, g++) {
                samples[s].grains++;
                samples[s].first += urn[g];
            }
        }
        const clod_mixing of = clod_mixing_of(samples, SAMPLES);
        sum += of.index;
        squares += of.index * of.index;
        share = of.share;
        random = of.random;
        variance += of.variance / MIXTURES;
    }
    const double mean = sum / MIXTURES;
    const double error = sqrt((squares / MIXTURES - mean * mean) / MIXTURES);
    check_close(share, 0.3, 1e-15);
    check_relative(random, 0.3 * 0.7 / 15.0, 6e-3); // binomial, of 15 grains a sample
    assert_true(error < 1e-3);
    check_close(mean, 1.0, 4.0 * error);
    check_relative(variance, random, 0.02);
}

/** A sample of `first` grains of the first kind among `grains`, each of mass m of its kind. */
static clod_mixing_weighed weighed(int64_t grains, int64_t first, double m0, double m1)
{
    const double n0 = (double)first, n1 = (double)(grains - first);
    return (clod_mixing_weighed){grains, {n0 * m0, n1 * m1}, {n0 * m0 * m0, n1 * m1 * m1}};
}

/** With one mass for all, in any unit, all numbers are those by number. */
static void equal_masses_are_numbers(void **unused)
{
    (void)unused;
    const clod_mixing_sample counted[] = {{12, 3}, {4, 3}, {0, 0}, {25, 1}, {7, 7}};
    clod_mixing_weighed samples[5];
    for (int k = 0; k < 5; k++) {
        samples[k] = weighed(counted[k].grains, counted[k].first, 3e-7, 3e-7);
    }
    const clod_mixing mass = clod_mixing_of_mass(samples, 5),
                      number = clod_mixing_of(counted, 5);
    check_close(mass.share, number.share, 1e-15);
    check_close(mass.variance, number.variance, 1e-15);
    check_close(mass.segregated, number.segregated, 1e-15);
    check_close(mass.random, number.random, 1e-15);
    check_close(mass.index, number.index, 1e-14);
    check_close(mass.grains, number.grains, 0.0);
}

/** By hand: one grain of 4 g with four of 1 g, and eight of 1 g: p = 4/16 and 1/2, 0 in two samples of
 *  8 g each; S^2 = 1/16, Sr^2 = 13/12 (9/16 16 + 1/16 12)/256. Pure samples of any masses: 0. */
static void weighed_by_hand(void **unused)
{
    (void)unused;
    const clod_mixing_weighed two[] = {weighed(5, 1, 4e-3, 1e-3), weighed(8, 0, 4e-3, 1e-3)};
    const clod_mixing of = clod_mixing_of_mass(two, 2);
    check_close(of.share, 0.25, 1e-15);
    check_close(of.variance, 1.0 / 16.0, 1e-15);
    check_close(of.segregated, 3.0 / 16.0, 1e-15);
    check_close(of.random, 13.0 / 12.0 * 9.75 / 256.0, 1e-15);
    check_close(of.index, (3.0 / 16.0 - 1.0 / 16.0) / (3.0 / 16.0 - 13.0 / 12.0 * 9.75 / 256.0),
                1e-14);
    check_close(of.grains, 6.5, 0.0);
    const clod_mixing_weighed pure[] = {weighed(10, 10, 8.0, 1.0), weighed(0, 0, 8.0, 1.0),
                                        weighed(300, 0, 8.0, 1.0), weighed(20, 20, 8.0, 1.0)};
    const clod_mixing apart = clod_mixing_of_mass(pure, 4);
    check_close(apart.share, 240.0 / 540.0, 1e-15);
    check_close(apart.variance, apart.segregated, 1e-15);
    check_close(apart.index, 0.0, 1e-14);
}

/** Masses of grains, the first 3 of 10 of the first kind. */
enum { FILLED = 50, ALL = FILLED * 120 };

/** Fill samples one after the other with grains in random order, a grain counting where its middle is:
 *  all have about the same mass. */
static void fill_samples(const double *mass, dice *roll, clod_mixing_weighed *samples)
{
    static int order[ALL];
    double total = 0.0, before = 0.0;
    for (int g = 0; g < ALL; g++) {
        order[g] = g;
        total += mass[g];
    }
    for (int g = ALL - 1; g > 0; g--) {
        const int other = dice_pick(roll, g + 1), kept = order[g];
        order[g] = order[other];
        order[other] = kept;
    }
    memset(samples, 0, FILLED * sizeof *samples);
    for (int k = 0; k < ALL; k++) {
        const double m = mass[order[k]];
        const int kind = order[k] < ALL * 3 / 10 ? 0 : 1;
        clod_mixing_weighed *of = &samples[(int)((before + 0.5 * m) / total * FILLED)];
        of->grains++;
        of->mass[kind] += m;
        of->square[kind] += m * m;
        before += m;
    }
}

/** Random mixtures of grains of these masses: the mean index is 1 within four standard errors, and by the
 *  binomial variance of so many grains it would not be. */
static void check_random(const double *mass, double numbers_off)
{
    enum { MIXTURES = 400 };
    static clod_mixing_weighed samples[FILLED];
    dice roll = {5};
    double sum = 0.0, squares = 0.0, binomial = 0.0;
    for (int m = 0; m < MIXTURES; m++) {
        fill_samples(mass, &roll, samples);
        const clod_mixing of = clod_mixing_of_mass(samples, FILLED);
        const double random = of.segregated / of.grains;
        sum += of.index;
        squares += of.index * of.index;
        binomial += (of.segregated - of.variance) / (of.segregated - random) / MIXTURES;
    }
    const double mean = sum / MIXTURES;
    const double error = sqrt((squares / MIXTURES - mean * mean) / MIXTURES);
    assert_true(error < 2e-4);
    check_close(mean, 1.0, 4.0 * error);
    check_at_least(fabs(binomial - 1.0), numbers_off * error);
}

static void random_mixtures_weighed(void **unused)
{
    (void)unused;
    static double mass[ALL];
    dice roll = {9};
    for (int g = 0; g < ALL; g++) { // the first kind has twice the radius, then half of it
        mass[g] = g < ALL * 3 / 10 ? 8.0 : 1.0;
    }
    check_random(mass, 8.0);
    for (int g = 0; g < ALL; g++) {
        mass[g] = g < ALL * 3 / 10 ? 1.0 : 8.0;
    }
    check_random(mass, 8.0);
    for (int g = 0; g < ALL; g++) { // radii of both kinds from 0.5 to 1.5
        mass[g] = pow(0.5 + 1e-3 * dice_pick(&roll, 1001), 3.0);
    }
    check_random(mass, 8.0);
}

static void nothing_to_mix(void **unused)
{
    (void)unused;
    const clod_mixing_sample one_kind[] = {{5, 5}, {3, 3}}, one_sample[] = {{5, 2}, {0, 0}};
    const clod_mixing_sample none[] = {{0, 0}}, single[] = {{1, 0}, {1, 1}};
    assert_true(isnan(clod_mixing_of(one_kind, 2).index));
    assert_true(isnan(clod_mixing_of(one_sample, 2).index));
    assert_true(isnan(clod_mixing_of(none, 1).index));
    assert_true(isnan(clod_mixing_of(single, 2).index)); // a grain is pure
    check_close(clod_mixing_of(one_kind, 2).variance, 0.0, 0.0);
    const clod_mixing_weighed ore = weighed(5, 5, 2.0, 1.0), empty = weighed(0, 0, 1.0, 1.0);
    assert_true(isnan(clod_mixing_of_mass((clod_mixing_weighed[]){ore, ore}, 2).index));
    assert_true(isnan(clod_mixing_of_mass((clod_mixing_weighed[]){ore, empty}, 2).index));
    assert_true(isnan(clod_mixing_of_mass(&empty, 1).share));
    // 31 grains alone, one of 10 times the mass: p = 1/2, Sr^2 = 31 (110 + 20)/4/40^2 = 0.63
    clod_mixing_weighed alone[31];
    for (int k = 0; k < 31; k++) {
        alone[k] = weighed(1, k < 11, k == 0 ? 10.0 : 1.0, 1.0);
    }
    check_close(clod_mixing_of_mass(alone, 31).random, 31.0 * 130.0 / 6400.0, 1e-14);
    assert_true(isnan(clod_mixing_of_mass(alone, 31).index));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segregated_is_zero),      cmocka_unit_test(between),
        cmocka_unit_test(a_random_mixture_is_one), cmocka_unit_test(equal_masses_are_numbers),
        cmocka_unit_test(weighed_by_hand),         cmocka_unit_test(random_mixtures_weighed),
        cmocka_unit_test(nothing_to_mix),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
