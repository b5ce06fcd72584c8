/**
 * Markov chains. Expected: moments of the density that is sampled; effective numbers of an autoregressive
 * series, n (1 - a)/(1 + a); R-hat of constant half chains by hand.
 */

#include "base/random.h"
#include "calibrate/chain.h"
#include "support/check.h"

#define CHAINS 4
#define KEPT 6000

static const double MEAN[] = {0.4, 0.6};
static const double SD[] = {0.03, 0.08};
#define CORRELATION 0.8

static double gaussian(void *context, const double *u)
{
    (void)context;
    const double x = (u[0] - MEAN[0]) / SD[0];
    const double y = (u[1] - MEAN[1]) / SD[1];
    const double c = CORRELATION;
    return -0.5 * (x * x - 2.0 * c * x * y + y * y) / (1.0 - c * c);
}

static double samples[CHAINS * KEPT][2];

static double mean_of(int k)
{
    double sum = 0.0;
    for (int i = 0; i < CHAINS * KEPT; i++) {
        sum += samples[i][k] / (CHAINS * KEPT);
    }
    return sum;
}

static double product_of(int a, int b)
{
    const double at[] = {mean_of(0), mean_of(1)};
    double sum = 0.0;
    for (int i = 0; i < CHAINS * KEPT; i++) {
        sum += (samples[i][a] - at[a]) * (samples[i][b] - at[b]) / (CHAINS * KEPT);
    }
    return sum;
}

static clod_chain_series series_of(int k)
{
    return (clod_chain_series){&samples[0][k], CHAINS, KEPT, 2};
}

/** Standard errors of mean and deviation go with the effective number; five of them. */
static void a_gaussian_has_its_moments(void **state)
{
    (void)state;
    const clod_chain_setup setup = {.dimensions = 2,
                                    .chains = CHAINS,
                                    .warm_up = 2000,
                                    .kept = KEPT,
                                    .seed = 3,
                                    .density = gaussian};
    double accepted;
    clod_chain_run(&setup, samples[0], &accepted);
    assert_true(accepted > 0.2 && accepted < 0.4);
    for (int k = 0; k < 2; k++) {
        const clod_chain_series series = series_of(k);
        const double effective = clod_chain_effective(&series);
        assert_true(effective > 1000.0 && effective < CHAINS * KEPT);
        check_at_most(clod_chain_rhat(&series), 1.01);
        check_close(mean_of(k), MEAN[k], 5.0 * SD[k] / sqrt(effective));
        check_relative(sqrt(product_of(k, k)), SD[k], 5.0 / sqrt(2.0 * effective));
    }
    check_close(product_of(0, 1) / sqrt(product_of(0, 0) * product_of(1, 1)), CORRELATION,
                0.05);
}

static double flat(void *context, const double *u)
{
    (void)context;
    return u[0] > 0.25 ? 0.0 : -HUGE_VAL;
}

/** Uniform on (1/4, 1): mean 5/8, deviation (3/4)/sqrt(12). */
static void edges_are_kept(void **state)
{
    (void)state;
    const clod_chain_setup setup = {.dimensions = 2,
                                    .chains = CHAINS,
                                    .warm_up = 2000,
                                    .kept = KEPT,
                                    .seed = 4,
                                    .density = flat};
    double accepted;
    clod_chain_run(&setup, samples[0], &accepted);
    for (int i = 0; i < CHAINS * KEPT; i++) {
        assert_true(samples[i][0] > 0.25 && samples[i][0] < 1.0);
        assert_true(samples[i][1] > 0.0 && samples[i][1] < 1.0);
    }
    const clod_chain_series series = series_of(0);
    const double effective = clod_chain_effective(&series);
    check_close(mean_of(0), 0.625, 5.0 * 0.2165 / sqrt(effective));
    check_close(sqrt(product_of(0, 0)), 0.2165, 0.01);
}

/** Two summits, 0.7 apart and 0.01 wide, the second with exp(-12) of the first's weight: in 24 000 samples
 *  0.15 are expected there. A chain that begins near it would stay. */
static double two_summits(void *context, const double *u)
{
    (void)context;
    const double a = (u[0] - 0.85) / 0.01;
    const double b = (u[0] - 0.15) / 0.01;
    return fmax(-0.5 * a * a, -12.0 - 0.5 * b * b);
}

static void no_chain_stays_at_a_lesser_summit(void **state)
{
    (void)state;
    clod_chain_setup setup = {.dimensions = 2,
                              .chains = CHAINS,
                              .warm_up = 2000,
                              .kept = KEPT,
                              .density = two_summits};
    for (setup.seed = 1; setup.seed <= 5; setup.seed++) {
        double accepted;
        clod_chain_run(&setup, samples[0], &accepted);
        int low = 0;
        for (int i = 0; i < CHAINS * KEPT; i++) {
            low += samples[i][0] < 0.5 ? 1 : 0;
        }
        assert_true(low <= 5);
    }
}

/** x = a x + sqrt(1 - a^2) e has n (1 - a)/(1 + a) independent values in n. */
static void effective_number_of_a_known_series(void **state)
{
    (void)state;
    static double x[CHAINS * KEPT];
    const double memory[] = {0.0, 0.5, 0.9};
    for (size_t m = 0; m < 3; m++) {
        for (uint64_t c = 0; c < CHAINS; c++) {
            double now = 0.0;
            for (uint64_t k = 0; k < KEPT; k++) {
                const double dice = clod_random_normal(m, CLOD_RANDOM_TEST, c, 2 * k);
                now = memory[m] * now + sqrt(1.0 - memory[m] * memory[m]) * dice;
                x[c * KEPT + k] = now;
            }
        }
        const clod_chain_series series = {x, CHAINS, KEPT, 1};
        const double expected = CHAINS * KEPT * (1.0 - memory[m]) / (1.0 + memory[m]);
        check_relative(clod_chain_effective(&series), expected, 0.15);
        check_at_most(clod_chain_rhat(&series), 1.01);
    }
}

/** Chains of 8: halves of 1, -1, 1, -1 about 0 and about 3. Within 4/3; means 0, 0, 3, 3 have the variance
 *  3; total (3/4)(4/3) + 3 = 4; R-hat sqrt(4/(4/3)) = sqrt(3). */
static void chains_that_disagree_are_seen(void **state)
{
    (void)state;
    const double x[] = {1, -1, 1, -1, 1, -1, 1, -1, 4, 2, 4, 2, 4, 2, 4, 2};
    const clod_chain_series series = {x, 2, 8, 1};
    check_close(clod_chain_rhat(&series), sqrt(3.0), 1e-14);
}

/** Chains that stand still where they began, together or apart, tell nothing. */
static void chains_that_never_moved_do_not_agree(void **state)
{
    (void)state;
    const double together[16] = {0.0};
    const double apart[16] = {[8] = 1, 1, 1, 1, 1, 1, 1, 1};
    const double *const all[] = {together, apart};
    for (int k = 0; k < 2; k++) {
        const clod_chain_series series = {all[k], 2, 8, 1};
        assert_true(clod_chain_rhat(&series) > 1e300);
        check_close(clod_chain_effective(&series), 0.0, 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gaussian_has_its_moments),
        cmocka_unit_test(edges_are_kept),
        cmocka_unit_test(no_chain_stays_at_a_lesser_summit),
        cmocka_unit_test(effective_number_of_a_known_series),
        cmocka_unit_test(chains_that_disagree_are_seen),
        cmocka_unit_test(chains_that_never_moved_do_not_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
