/**
 * Surrogates. Expected: least squares by hand; universal kriging by its Lagrange system, solved here by
 * elimination, which is another way to the same numbers; the noise and the function that were put in.
 */

#include <string.h>

#include "base/random.h"
#include "calibrate/surrogate.h"
#include "support/check.h"

static double uniform(uint64_t item, uint64_t draw)
{
    return clod_random_uniform(7, CLOD_RANDOM_TEST, item, draw);
}

static double normal(uint64_t item)
{
    return clod_random_normal(7, CLOD_RANDOM_TEST, item, 0);
}

static clod_surrogate *create(const clod_surrogate_runs *runs, clod_surrogate_kind kind)
{
    clod_status status = {CLOD_OK, ""};
    clod_surrogate *self = clod_surrogate_create(runs, kind, &status);
    if (self == NULL) {
        print_error("%s\n", status.text);
    }
    assert_non_null(self);
    return self;
}

/** Slope 1, intercept 1/6, squares left 1/6 with one degree of freedom; variance of a further run,
 *  s^2 (1 + 1/3 + (u - 1/2)^2 / (1/2)). */
static void a_line_is_that_of_least_squares(void **state)
{
    (void)state;
    const double u[] = {0.0, 0.5, 1.0};
    const double y[] = {0.0, 1.0, 1.0};
    const clod_surrogate_runs runs = {1, 3, u, y, NULL};
    clod_surrogate *self = create(&runs, CLOD_SURROGATE_LINEAR);
    double room[16];
    assert_true(clod_surrogate_room(self) <= 16);
    for (double at = 0.0; at <= 1.0; at += 0.25) {
        const clod_surrogate_value told = clod_surrogate_at(self, &at, room);
        check_close(told.mean, 1.0 / 6.0 + at, 1e-14);
        check_close(told.variance, (4.0 / 3.0 + 2.0 * (at - 0.5) * (at - 0.5)) / 6.0, 1e-14);
    }
    check_close(clod_surrogate_noise(self, u), sqrt(1.0 / 6.0), 1e-14);
    clod_surrogate_destroy(&self);
}

/** A quadratic in two inputs is met exactly, wherever one looks. */
static void a_quadratic_is_met_exactly(void **state)
{
    (void)state;
    double u[12][2], y[12];
    for (uint64_t i = 0; i < 12; i++) {
        u[i][0] = uniform(i, 0);
        u[i][1] = uniform(i, 1);
        y[i] = 3.0 - u[i][0] + 2.0 * u[i][1] + 4.0 * u[i][0] * u[i][1] - u[i][1] * u[i][1];
    }
    const clod_surrogate_runs runs = {2, 12, u[0], y, NULL};
    clod_surrogate *self = create(&runs, CLOD_SURROGATE_QUADRATIC);
    double room[32];
    const double at[] = {0.3, 0.9};
    check_close(clod_surrogate_at(self, at, room).mean, 3.0 - 0.3 + 1.8 + 1.08 - 0.81, 1e-12);
    clod_surrogate_destroy(&self);
}

#define N 7       ///< runs of the kriging test, three of them at one point
#define M (N + 3) ///< with three coefficients
#define NUGGET 0.2

/** Solve a x = b by elimination with pivots; both are overwritten. */
static void solve(double a[M][M], double b[M])
{
    for (int k = 0; k < M; k++) {
        int pivot = k;
        for (int i = k; i < M; i++) {
            pivot = fabs(a[i][k]) > fabs(a[pivot][k]) ? i : pivot;
        }
        for (int j = 0; j < M; j++) {
            const double held = a[k][j];
            a[k][j] = a[pivot][j];
            a[pivot][j] = held;
        }
        const double held = b[k];
        b[k] = b[pivot];
        b[pivot] = held;
        for (int i = 0; i < M; i++) {
            const double part = i == k ? 0.0 : a[i][k] / a[k][k];
            for (int j = 0; j < M; j++) {
                a[i][j] -= part * a[k][j];
            }
            b[i] -= part * b[k];
        }
    }
    for (int k = 0; k < M; k++) {
        b[k] /= a[k][k];
    }
}

static const clod_surrogate_hyper HYPER = {{0.4, 0.9}, NUGGET, {1.2, -0.7}};

/** Variance of the noise over that in the middle. */
static double growth(const double *a)
{
    return exp(1.2 * (a[0] - 0.5) - 0.7 * (a[1] - 0.5));
}

static double matern(const double *a, const double *b)
{
    const double x = (a[0] - b[0]) / HYPER.lengths[0];
    const double y = (a[1] - b[1]) / HYPER.lengths[1];
    const double r = sqrt(x * x + y * y);
    return (1.0 + sqrt(5.0) * r + 5.0 / 3.0 * r * r) * exp(-sqrt(5.0) * r);
}

static void fill(double a[M][M], double u[N][2])
{
    memset(a, 0, M * sizeof *a);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            a[i][j] = matern(u[i], u[j]) + (i == j ? NUGGET * growth(u[i]) : 0.0);
        }
        const double terms[] = {1.0, u[i][0], u[i][1]};
        for (int k = 0; k < 3; k++) {
            a[i][N + k] = a[N + k][i] = terms[k];
        }
    }
}

static void a_process_is_universal_kriging(void **state)
{
    (void)state;
    double u[N][2] = {{0.1, 0.2}, {0.6, 0.6}, {0.5, 0.8}, {0.2, 0.9},
                      {0.7, 0.1}, {0.6, 0.6}, {0.6, 0.6}};
    const double y[N] = {1.0, 3.0, 2.5, 0.5, 4.0, 2.0, 2.6};
    double a[M][M], b[M] = {0.0};
    fill(a, u);
    memcpy(b, y, sizeof y);
    solve(a, b); // V^-1 (y - H beta), then beta
    double variance = 0.0;
    for (int i = 0; i < N; i++) {
        variance += y[i] * b[i] / (N - 3);
    }
    // the determinant of the bordered matrix is that of V times that of H' V^-1 H; slopes of deviation 1.5/sqrt 2
    double likelihood =
        -0.5 * (N - 3) * log(variance) - 0.5 * (1.2 * 1.2 + 0.7 * 0.7) / (1.5 * 1.5 / 2.0);
    for (int k = 0; k < M; k++) {
        likelihood -= 0.5 * log(fabs(a[k][k]));
    }
    const double first = y[0] - b[N] - b[N + 1] * u[0][0] - b[N + 2] * u[0][1];
    const double at[] = {0.35, 0.45};
    const double right[M - N] = {1.0, at[0], at[1]};
    double w[M], r[N];
    for (int i = 0; i < N; i++) {
        w[i] = r[i] = matern(u[i], at);
    }
    memcpy(w + N, right, sizeof right);
    fill(a, u);
    solve(a, w); // weights, then multipliers
    double mean = 0.0, left = 1.0;
    for (int i = 0; i < N; i++) {
        mean += w[i] * y[i];
        left -= w[i] * r[i];
    }
    for (int k = 0; k < 3; k++) {
        left -= w[N + k] * right[k];
    }
    const clod_surrogate_runs runs = {2, N, u[0], y, NULL};
    clod_status status = {CLOD_OK, ""};
    clod_surrogate *self =
        clod_surrogate_create_at(&runs, CLOD_SURROGATE_GAUSSIAN, &HYPER, &status);
    assert_non_null(self);
    double room[32];
    const clod_surrogate_value told = clod_surrogate_at(self, at, room);
    check_close(told.mean, mean, 1e-12);
    check_close(told.variance, variance * left, 1e-12);
    check_close(clod_surrogate_noise(self, at), sqrt(variance * NUGGET * growth(at)), 1e-12);
    check_close(clod_surrogate_likelihood(self), likelihood, 1e-12);
    double off[N], squares = 0.0;
    assert_true(clod_surrogate_residuals(self, off));
    for (int i = 0; i < N; i++) {
        squares += off[i] * off[i];
    }
    check_close(off[0], first / sqrt(1.0 + NUGGET * growth(u[0])), 1e-12);
    check_close(squares, variance * (N - 3), 1e-12);
    clod_surrogate_destroy(&self);
}

#define POINTS 30
#define PACKINGS 3
#define NOISE 0.3

static double wave(double u)
{
    return 2.0 * sin(5.0 * u) + 3.0 * u;
}

/** Noise from 60 differences between packings: its relative standard error is 1/sqrt(120), 9 %. */
static void noise_and_function_are_found(void **state)
{
    (void)state;
    double u[POINTS * PACKINGS], y[POINTS * PACKINGS];
    for (int i = 0; i < POINTS * PACKINGS; i++) {
        u[i] = ((double)(i / PACKINGS) + 0.5) / POINTS;
        y[i] = wave(u[i]) + NOISE * normal((uint64_t)i);
    }
    const clod_surrogate_runs runs = {1, POINTS * PACKINGS, u, y, NULL};
    assert_int_equal(clod_surrogate_points(&runs), POINTS);
    clod_surrogate *self = create(&runs, CLOD_SURROGATE_GAUSSIAN);
    const double middle = 0.5;
    check_relative(clod_surrogate_noise(self, &middle), NOISE, 0.27);
    double room[256];
    int inside = 0;
    for (int i = 0; i < 100; i++) {
        const double at = ((double)i + 0.5) / 100.0;
        const clod_surrogate_value told = clod_surrogate_at(self, &at, room);
        check_close(told.mean, wave(at), NOISE);
        inside += fabs(told.mean - wave(at)) <= 2.0 * sqrt(told.variance) ? 1 : 0;
    }
    assert_true(inside >= 80); // 95 are expected; neighbours err alike
    clod_surrogate_check check;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_surrogate_leave_one_out(self, NULL, &check, &status));
    assert_int_equal(check.points, POINTS);
    assert_true(check.q2 > 0.9 && check.q2 < 1.0);
    assert_true(check.covered > 0.8);
    // packings' noise over sqrt(3), and the error of the prediction
    assert_true(check.error > 0.5 * NOISE / sqrt(3.0) && check.error < 2.0 * NOISE / sqrt(3.0));
    clod_surrogate_destroy(&self);
}

/** No hyperparameters of a grid are likelier than those that were found. */
static void the_likelihood_is_the_greatest(void **state)
{
    (void)state;
    double u[12][2], y[12];
    for (uint64_t i = 0; i < 12; i++) {
        u[i][0] = uniform(i, 2);
        u[i][1] = uniform(i, 3);
        y[i] = wave(u[i][0]) + u[i][1] + 0.1 * normal(100 + i);
    }
    const clod_surrogate_runs runs = {2, 12, u[0], y, NULL};
    clod_surrogate *best = create(&runs, CLOD_SURROGATE_GAUSSIAN);
    for (int k = 0; k < 6 * 6 * 6 * 5 * 5; k++) {
        const clod_surrogate_hyper hyper = {
            {0.1 * pow(100.0, (k % 6) / 5.0), 0.1 * pow(100.0, (k / 6 % 6) / 5.0)},
            1e-6 * pow(1e10, (k / 36 % 6) / 5.0),
            {1.5 * (k / 216 % 5 - 2), 1.5 * (k / 1080 - 2)}};
        clod_status status = {CLOD_OK, ""};
        clod_surrogate *other =
            clod_surrogate_create_at(&runs, CLOD_SURROGATE_GAUSSIAN, &hyper, &status);
        if (other != NULL) {
            check_at_most(clod_surrogate_likelihood(other),
                          clod_surrogate_likelihood(best) + 1e-3);
        }
        clod_surrogate_destroy(&other);
    }
    clod_surrogate_destroy(&best);
}

static void too_few_points_are_refused(void **state)
{
    (void)state;
    const double u[] = {0.1, 0.1, 0.1, 0.1};
    const double y[] = {1.0, 2.0, 3.0, 4.0};
    const clod_surrogate_runs runs = {1, 4, u, y, NULL};
    clod_status status = {CLOD_OK, ""};
    assert_null(clod_surrogate_create(&runs, CLOD_SURROGATE_LINEAR, &status));
    assert_non_null(strstr(status.text, "4 runs at 1 different points are too few"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_is_that_of_least_squares),
        cmocka_unit_test(a_quadratic_is_met_exactly),
        cmocka_unit_test(a_process_is_universal_kriging),
        cmocka_unit_test(noise_and_function_are_found),
        cmocka_unit_test(the_likelihood_is_the_greatest),
        cmocka_unit_test(too_few_points_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
