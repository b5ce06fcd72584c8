/**
 * Markov chains. Expected: moments of the density that is sampled; effective numbers of an autoregressive
 * series, n (1 - a)/(1 + a); R-hat of constant half chains by hand.
 */

#include "base/random.h"
#include "calibrate/chain.h"
#include "calibrate/population.h"
#include "support/check.h"

#define CHAINS 4
#define KEPT 6000

static const double MEAN[] = {0.4, 0.6};
static const double SD[] = {0.03, 0.08};
#define CORRELATION 0.8

static double gaussian(void *context, const double *u, const size_t *choices)
{
    (void)context;
    (void)choices;
    const double x = (u[0] - MEAN[0]) / SD[0];
    const double y = (u[1] - MEAN[1]) / SD[1];
    const double c = CORRELATION;
    return -0.5 * (x * x - 2.0 * c * x * y + y * y) / (1.0 - c * c);
}

static double samples[CHAINS * KEPT][2];

/** Chains from a population. */
static void run(clod_chain_setup *setup, size_t *chosen, double *accepted)
{
    clod_population population;
    clod_status status;
    assert_true(clod_population_create(setup, 2000, &population, &status));
    setup->population = &population;
    assert_true(clod_chain_run(setup, samples[0], chosen, accepted));
    clod_population_fini(&population);
}

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
    clod_chain_setup setup = {.dimensions = 2,
                              .chains = CHAINS,
                              .warm_up = 2000,
                              .kept = KEPT,
                              .seed = 3,
                              .density = gaussian};
    double accepted;
    run(&setup, NULL, &accepted);
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

static double flat(void *context, const double *u, const size_t *choices)
{
    (void)context;
    (void)choices;
    return u[0] > 0.25 ? 0.0 : -HUGE_VAL;
}

/** Uniform on (1/4, 1): mean 5/8, deviation (3/4)/sqrt(12). */
static void edges_are_kept(void **state)
{
    (void)state;
    clod_chain_setup setup = {.dimensions = 2,
                              .chains = CHAINS,
                              .warm_up = 2000,
                              .kept = KEPT,
                              .seed = 4,
                              .density = flat};
    double accepted;
    run(&setup, NULL, &accepted);
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
static double two_summits(void *context, const double *u, const size_t *choices)
{
    (void)context;
    (void)choices;
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
        run(&setup, NULL, &accepted);
        int low = 0;
        for (int i = 0; i < CHAINS * KEPT; i++) {
            low += samples[i][0] < 0.5 ? 1 : 0;
        }
        assert_true(low <= 5);
    }
}

/** Two summits of the same weight, the second three times as wide. Four chains that never change from one to the other would
 *  all lie at one of them in one of eight seeds, and tell one answer for certain. */
static double two_answers(void *context, const double *u, const size_t *choices)
{
    (void)context;
    (void)choices;
    const double a = (u[0] - 0.2) / 0.015;
    const double b = (u[0] - 0.7) / 0.045;
    return fmax(-0.5 * a * a, -log(3.0) - 0.5 * b * b); // next to nothing where they are alike
}

static void chains_go_from_one_answer_to_the_other(void **state)
{
    (void)state;
    clod_chain_setup setup = {.dimensions = 2,
                              .chains = CHAINS,
                              .warm_up = 2000,
                              .kept = KEPT,
                              .density = two_answers};
    for (setup.seed = 1; setup.seed <= 50; setup.seed++) {
        double accepted;
        run(&setup, NULL, &accepted);
        for (int c = 0; c < CHAINS; c++) {
            double share = 0.0;
            for (int i = 0; i < KEPT; i++) {
                share += samples[c * KEPT + i][0] < 0.45 ? 1.0 / KEPT : 0.0;
            }
            check_close(share, 0.5, 0.15);
        }
        const clod_chain_series series = series_of(0);
        check_at_most(clod_chain_rhat(&series), 1.05);
    }
}

/** A ring of radius 0.3, 0.006 wide: normal steps, which are as wide as all of it, meet it seldom. */
static double ring(void *context, const double *u, const size_t *choices)
{
    (void)context;
    (void)choices;
    const double away = (hypot(u[0] - 0.5, u[1] - 0.5) - 0.3) / 0.006;
    return -0.5 * away * away;
}

static void a_bent_ridge_is_walked_along(void **state)
{
    (void)state;
    clod_chain_setup setup = {.dimensions = 2,
                              .chains = CHAINS,
                              .warm_up = 2000,
                              .kept = KEPT,
                              .seed = 7,
                              .density = ring};
    double accepted;
    run(&setup, NULL, &accepted);
    for (int k = 0; k < 2; k++) {
        const clod_chain_series series = series_of(k);
        assert_true(clod_chain_effective(&series) > 400.0);
        check_at_most(clod_chain_rhat(&series), 1.05);
        check_close(mean_of(k), 0.5, 0.05);
        check_relative(product_of(k, k), 0.045, 0.1);
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

// ---- whole numbers beside the point

#define CHOICES 3
#define OPTIONS 4

/** The second number says where a normal density of the point lies, and its option k has the weight k + 1; the
 *  first has the weights too, and the third none. */
static double where_chosen(void *context, const double *u, const size_t *choices)
{
    (void)context;
    const double x = (u[0] - 0.2 * (double)(choices[1] + 1)) / 0.08;
    const double y = (u[1] - 0.5) / 0.05;
    return -0.5 * (x * x + y * y) + log((double)(choices[0] + 1)) +
           log((double)(choices[1] + 1));
}

static size_t chosen[CHAINS * KEPT][CHOICES];

/** Shares are weights over their sum, 1 to 4 of 10 or 1 of 4, and the mean of the point is 0.2 (1 + 4 + 9 + 16)/10 = 0.6.
 *  A choice is drawn every third step; from share to share the chains scatter by 0.01. */
static void choices_are_as_frequent_as_their_weights(void **state)
{
    (void)state;
    clod_chain_setup setup = {.dimensions = 2,
                              .chains = CHAINS,
                              .warm_up = 2000,
                              .kept = KEPT,
                              .choices = CHOICES,
                              .options = OPTIONS,
                              .seed = 5,
                              .density = where_chosen};
    double accepted;
    run(&setup, chosen[0], &accepted);
    double share[CHOICES][OPTIONS] = {{0.0}};
    for (int i = 0; i < CHAINS * KEPT; i++) {
        for (int k = 0; k < CHOICES; k++) {
            assert_in_range(chosen[i][k], 0, OPTIONS - 1);
            share[k][chosen[i][k]] += 1.0 / (CHAINS * KEPT);
        }
    }
    for (int m = 0; m < OPTIONS; m++) {
        check_close(share[0][m], 0.1 * (m + 1), 0.03);
        check_close(share[1][m], 0.1 * (m + 1), 0.05);
        check_close(share[2][m], 0.25, 0.03);
    }
    check_close(mean_of(0), 0.6, 0.02);
    check_close(mean_of(1), 0.5, 0.01);
}

/** Started where it is told, and without warm-up a chain's first sample is not further than a few of its steps. */
static void a_chain_begins_where_it_is_told(void **state)
{
    (void)state;
    const double start[] = {0.9, 0.1};
    const clod_chain_setup setup = {
        .dimensions = 2, .chains = 1, .kept = 1, .start = start, .seed = 3, .density = flat};
    double accepted;
    assert_true(clod_chain_run(&setup, samples[0], NULL, &accepted));
    check_close(samples[0][0], 0.9, 0.1);
    check_close(samples[0][1], 0.1, 0.1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_gaussian_has_its_moments),
        cmocka_unit_test(edges_are_kept),
        cmocka_unit_test(no_chain_stays_at_a_lesser_summit),
        cmocka_unit_test(chains_go_from_one_answer_to_the_other),
        cmocka_unit_test(a_bent_ridge_is_walked_along),
        cmocka_unit_test(effective_number_of_a_known_series),
        cmocka_unit_test(chains_that_disagree_are_seen),
        cmocka_unit_test(chains_that_never_moved_do_not_agree),
        cmocka_unit_test(choices_are_as_frequent_as_their_weights),
        cmocka_unit_test(a_chain_begins_where_it_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
