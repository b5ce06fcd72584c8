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
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segregated_is_zero),
        cmocka_unit_test(between),
        cmocka_unit_test(a_random_mixture_is_one),
        cmocka_unit_test(nothing_to_mix),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
