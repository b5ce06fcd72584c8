/**
 * How far measured values are from surrogates. Expected: normal densities and Student's t in closed form,
 * correlations by hand.
 */

#include "calibrate/misfit.h"

#include <math.h>

#include "plan_made.h"
#include "support/check.h"

#define MOST 4
#define POINTS 5

static double room[400];

typedef struct made {
    plan_made plan;
    clod_surrogate *surrogates[MOST];
    clod_misfit *misfit;
    clod_surrogate_value told[MOST];
} made;

/** Two runs at each of five points: lines, with packings off by `noise` and its negative. */
static void make(made *self, size_t targets)
{
    static const double NOISE[POINTS] = {1, 2, -1, 3, -2};
    static double results[POINTS][2][MOST], inputs[2 * POINTS], values[2 * POINTS];
    for (size_t t = 0; t < targets; t++) {
        for (size_t i = 0; i < 2 * POINTS; i++) {
            const double noise = NOISE[i / 2] * (i % 2 == 0 ? 0.1 : -0.1);
            inputs[i] = 0.25 * (double)(i / 2);
            values[i] = 1.0 + inputs[i] * (double)t + noise * (double)(t + 1);
            (&results[0][0][0])[i * targets + t] = values[i];
        }
        const clod_surrogate_runs runs = {1, 2 * POINTS, inputs, values, NULL};
        clod_status status = {CLOD_OK, ""};
        self->surrogates[t] = clod_surrogate_create(&runs, CLOD_SURROGATE_LINEAR, &status);
        assert_non_null(self->surrogates[t]);
        self->plan.targets[t].value = 1.0;
        self->told[t] = (clod_surrogate_value){1.0, 0.0};
    }
    const clod_misfit_runs of = {&self->plan.plan, POINTS, &results[0][0][0],
                                 (const clod_surrogate *const *)self->surrogates};
    self->misfit = clod_misfit_create(&of);
    assert_non_null(self->misfit);
    assert_true(clod_misfit_room(self->misfit) <= sizeof room / sizeof room[0]);
}

static void drop(made *self)
{
    for (size_t t = 0; t < MOST; t++) {
        clod_surrogate_destroy(&self->surrogates[t]);
    }
    clod_misfit_destroy(&self->misfit);
}

static double density(made *self)
{
    return clod_misfit_density(self->misfit, self->told, room);
}

/** Log of a normal density of two numbers, without constants: v = (a c; c b). */
static double normal(double a, double b, double c, double x, double y)
{
    const double determinant = a * b - c * c;
    return -0.5 * ((b * x * x - 2.0 * c * x * y + a * y * y) / determinant + log(determinant));
}

/** Residuals of both numbers are the same but for a factor, r = 1, with 10 runs - 2 coefficients = 8 degrees:
 *  c = 8/9, and (8 + 2 8/9)/10 = 0.97778. The given errors have nothing in common. */
static void what_surrogates_do_not_know_is_common(void **state)
{
    (void)state;
    made all = {.misfit = NULL};
    plan_make(&all.plan, 1, 2);
    all.plan.targets[0].error = 0.3;
    all.plan.targets[1].error = 0.4;
    all.plan.targets[1].discrepancy = 0.2;
    make(&all, 2);
    double runs, laboratory;
    clod_misfit_correlation(all.misfit, 0, 1, &runs, &laboratory);
    check_close(runs, 0.97777777777, 1e-9);
    check_close(laboratory, 0.0, 0.0);
    all.told[0] = (clod_surrogate_value){0.7, 0.25};
    all.told[1] = (clod_surrogate_value){1.5, 0.36};
    check_close(density(&all),
                normal(0.09 + 0.25, 0.16 + 0.04 + 0.36, 0.97777777777 * 0.5 * 0.6, 0.3, -0.5),
                1e-8);
    drop(&all);
}

static void targets_of_two_tests_have_nothing_in_common(void **state)
{
    (void)state;
    made all = {.misfit = NULL};
    plan_make(&all.plan, 1, 2);
    all.plan.targets[0].error = all.plan.targets[1].error = 0.5;
    all.plan.targets[1].test = 1;
    make(&all, 2);
    double runs, laboratory;
    clod_misfit_correlation(all.misfit, 0, 1, &runs, &laboratory);
    check_close(runs, 0.0, 0.0);
    all.told[0] = all.told[1] = (clod_surrogate_value){0.5, 0.25};
    check_close(density(&all), normal(0.5, 0.5, 0.0, 0.5, 0.5), 1e-12);
    drop(&all);
}

/** Specimens of a target, by the differences of three. */
static void put_specimens(clod_plan_target *to, const double *differences)
{
    to->table = 1;
    to->repeats.count = 3;
    for (int k = 0; k < 3; k++) {
        to->repeats.differences[k] = (clod_plan_difference){101 + k, differences[k]};
    }
}

/** Three specimens, r = -1 with 2 degrees; five pairs of packings, r = 1 with 5: (-2 + 5)/7 = 3/7. With 7
 *  degrees c = 3/7 7/8 = 3/8, and (7 3/7 + 2 3/8)/9 = 5/12. Errors are stated, so known. */
static void errors_of_specimens_that_recur_are_common(void **state)
{
    (void)state;
    made all = {.misfit = NULL};
    plan_make(&all.plan, 1, 3);
    put_specimens(&all.plan.targets[0], (const double[]){1, -1, 0});
    put_specimens(&all.plan.targets[1], (const double[]){-2, 2, 0});
    all.plan.targets[0].error = all.plan.targets[1].error = 1.0;
    all.plan.targets[2].error = 1.0; // of no table
    make(&all, 3);
    double runs, laboratory;
    clod_misfit_correlation(all.misfit, 0, 1, &runs, &laboratory);
    check_close(laboratory, 5.0 / 12.0, 1e-12);
    assert_true(isinf(clod_misfit_degrees(all.misfit, 0)));
    clod_misfit_correlation(all.misfit, 0, 2, &runs, &laboratory);
    check_close(laboratory, 0.0, 0.0);
    all.told[0].mean = 0.2;
    all.told[1].mean = 0.6;
    check_close(density(&all), normal(1.0, 1.0, 5.0 / 12.0, 0.8, 0.4), 1e-12);
    drop(&all);
}

/** The same specimens, whose errors have a part in common by the preshears that prorated them: of 0.5, a correlation of
 *  1/4, it is part of the 5/12 that the specimens tell; of 0.8, 16/25, more than they tell. */
static void errors_of_preshears_are_common_once(void **state)
{
    (void)state;
    static const double PART[] = {0.5, 0.8}, EXPECTED[] = {5.0 / 12.0, 0.64};
    for (int k = 0; k < 2; k++) {
        made all = {.misfit = NULL};
        plan_make(&all.plan, 1, 2);
        put_specimens(&all.plan.targets[0], (const double[]){1, -1, 0});
        put_specimens(&all.plan.targets[1], (const double[]){-2, 2, 0});
        for (int t = 0; t < 2; t++) {
            all.plan.targets[t].error = 1.0;
            all.plan.targets[t].common = (clod_plan_common){PART[k], 5.0};
        }
        make(&all, 2);
        double runs, laboratory, variances[2];
        clod_misfit_correlation(all.misfit, 0, 1, &runs, &laboratory);
        check_close(laboratory, EXPECTED[k], 1e-12);
        check_close(clod_misfit_degrees(all.misfit, 0), 5.0, 0.0);
        // the estimated part alone is uncertain: 5 over the 1/32 quantile of chi-square of 5 degrees, 0.92009
        (void)clod_misfit_draw(all.misfit, all.told, (const double[]){0.0}, variances, room);
        check_relative(variances[0], 1.0 + PART[k] * PART[k] * (5.0 / 0.92009 - 1.0), 1e-4);
        drop(&all);
    }
}

/** Three stresses of three specimens, r = 1 with 2 degrees, and one of the first specimen alone, at which its packings
 *  tell r = 1; with T = 4 and 2 + 5 degrees c = 7/8, (7 + 4 7/8)/11 = 21/22. One specimen of three is 1/sqrt(3) of
 *  a mean. Four numbers that were one have 2 degrees; r = 21/22 of three pooled ones: 2 9/(3 + 6 r^2). */
static void a_stress_of_one_specimen_leaves_the_others_together(void **state)
{
    (void)state;
    made all = {.misfit = NULL};
    plan_make(&all.plan, 1, MOST);
    for (size_t t = 0; t < MOST; t++) {
        clod_plan_target *of = &all.plan.targets[t];
        put_specimens(of, (const double[]){1, -1, 0});
        of->error = 1.0;
        of->repeats.estimate = of->repeats.pooled = true;
    }
    all.plan.targets[3].repeats.count = 1;
    make(&all, MOST);
    double runs, laboratory;
    clod_misfit_correlation(all.misfit, 0, 1, &runs, &laboratory);
    check_close(laboratory, 21.0 / 22.0, 1e-12);
    clod_misfit_correlation(all.misfit, 2, 3, &runs, &laboratory);
    check_close(laboratory, 21.0 / 22.0 / sqrt(3.0), 1e-12);
    check_close(clod_misfit_degrees(all.misfit, 0), 18.0 / (3.0 + 6.0 * 441.0 / 484.0), 1e-12);
    drop(&all);
}

/** Of three specimens at one stress and of two others at another: nothing is in common but the degrees, of errors
 *  that are not pooled the fewest. */
static void errors_that_are_not_pooled_have_their_own_degrees(void **state)
{
    (void)state;
    made all = {.misfit = NULL};
    plan_make(&all.plan, 1, 2);
    for (size_t t = 0; t < 2; t++) {
        put_specimens(&all.plan.targets[t], (const double[]){1, -1, 0});
        all.plan.targets[t].error = 1.0;
        all.plan.targets[t].repeats.estimate = true;
    }
    for (int k = 0; k < 3; k++) {
        all.plan.targets[1].repeats.differences[k].specimen = 201 + k;
    }
    make(&all, 2);
    check_close(clod_misfit_degrees(all.misfit, 0), 2.0, 1e-12);
    drop(&all);
    for (size_t t = 0; t < 2; t++) {
        all.plan.targets[t].repeats.pooled = true;
    }
    make(&all, 2);
    check_close(clod_misfit_degrees(all.misfit, 0), 4.0, 1e-12);
    drop(&all);
}

/** Two measurements of one specimen at one stress: which belongs to which at the other, nobody knows. */
static void specimens_that_cannot_be_told_apart_are_independent(void **state)
{
    (void)state;
    made all = {.misfit = NULL};
    plan_make(&all.plan, 1, 2);
    put_specimens(&all.plan.targets[0], (const double[]){1, -1, 0});
    put_specimens(&all.plan.targets[1], (const double[]){1, -1, 0});
    all.plan.targets[0].repeats.differences[1].specimen = 101;
    all.plan.targets[0].error = all.plan.targets[1].error = 1.0;
    make(&all, 2);
    double runs, laboratory;
    clod_misfit_correlation(all.misfit, 0, 1, &runs, &laboratory);
    check_close(laboratory, 0.0, 0.0);
    drop(&all);
}

/** One error from three specimens: Student's t of 2 degrees, log p = -3/2 log(1 + x^2/2), within what 16 nodes
 *  make of it: a hundredth at the centre, more where the tails begin. */
static void an_estimated_error_is_a_student_t(void **state)
{
    (void)state;
    made all = {.misfit = NULL};
    plan_make(&all.plan, 1, 1);
    put_specimens(&all.plan.targets[0], (const double[]){1, -1, 0});
    all.plan.targets[0].error = 0.5;
    all.plan.targets[0].repeats.estimate = true;
    make(&all, 1);
    check_close(clod_misfit_degrees(all.misfit, 0), 2.0, 1e-12);
    const double centre = density(&all);
    for (double x = 0.5; x < 4.0; x += 0.5) {
        all.told[0].mean = 1.0 + 0.5 * x;
        check_close(density(&all) - centre, -1.5 * log1p(0.5 * x * x), 0.02 + 0.03 * x);
    }
    all.told[0].mean = 1.0 - 0.5 * 3.0; // a known one would have lost 4.5
    assert_true(density(&all) - centre > -3.0);
    drop(&all);
}

/** Nothing is known of the error of a held-back value: chi-square of 2 degrees is exponential, so its quantile
 *  at p is -2 log(1 - p), and the variance e^2/(-log(1 - p)). A used one that is far off has the larger errors. */
static void errors_are_drawn(void **state)
{
    (void)state;
    made all = {.misfit = NULL};
    plan_make(&all.plan, 1, 2);
    for (int t = 0; t < 2; t++) {
        put_specimens(&all.plan.targets[t], (const double[]){1, -1, 0});
        all.plan.targets[t].error = 0.5;
        all.plan.targets[t].repeats.estimate = true;
    }
    all.plan.targets[1].held_back = true;
    make(&all, 2);
    assert_int_equal(clod_misfit_count(all.misfit), 2);
    double near = 0.0, far = 0.0;
    for (int k = 0; k < 16; k++) {
        const double die = (k + 0.5) / 16.0;
        const double dice[] = {die, die};
        double variances[2];
        all.told[0].mean = 1.0;
        check_close(clod_misfit_draw(all.misfit, all.told, dice, variances, room), 0.0, 0.0);
        check_relative(variances[1], 0.25 / -log1p(-die), 1e-6);
        near += variances[0];
        all.told[0].mean = 3.0;
        const double chi = clod_misfit_draw(all.misfit, all.told, dice, variances, room);
        check_relative(chi, 4.0 / variances[0], 1e-9);
        far += variances[0];
    }
    assert_true(far > 4.0 * near);
    drop(&all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_surrogates_do_not_know_is_common),
        cmocka_unit_test(targets_of_two_tests_have_nothing_in_common),
        cmocka_unit_test(errors_of_specimens_that_recur_are_common),
        cmocka_unit_test(errors_of_preshears_are_common_once),
        cmocka_unit_test(specimens_that_cannot_be_told_apart_are_independent),
        cmocka_unit_test(a_stress_of_one_specimen_leaves_the_others_together),
        cmocka_unit_test(errors_that_are_not_pooled_have_their_own_degrees),
        cmocka_unit_test(an_estimated_error_is_a_student_t),
        cmocka_unit_test(errors_are_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
