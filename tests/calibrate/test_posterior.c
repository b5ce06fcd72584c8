/**
 * Posteriors. Expected: of a linear model without noise the normal distribution that the measured value
 * and its error give; p values of targets that agree and of such that cannot.
 */

#include "calibrate/posterior.h"
#include "plan_made.h"
#include "support/check.h"

#define POINTS 12

static double places[POINTS], results[POINTS][2][2];

/** Two targets, 10 + 20 u and 5 - 4 u. */
static clod_posterior *make(plan_made *made)
{
    for (int i = 0; i < POINTS; i++) {
        places[i] = ((double)i + 0.5) / POINTS;
        for (int s = 0; s < 2; s++) {
            results[i][s][0] = 10.0 + 20.0 * places[i];
            results[i][s][1] = 5.0 - 4.0 * places[i];
        }
    }
    const clod_posterior_runs runs = {&made->plan, POINTS, places, &results[0][0][0], NULL};
    clod_status status = {CLOD_OK, ""};
    clod_posterior *self = clod_posterior_create(&runs, &status);
    if (self == NULL) {
        print_error("%s\n", status.text);
    }
    assert_non_null(self);
    return self;
}

/** One target of 18 +- 1: u = 0.4 +- 0.05; 90 % within 1.645 deviations. The other one is predicted as
 *  5 - 4 u = 3.4 +- 0.2, and measured with an error of 0.3: 90 % within 1.645 hypot(0.2, 0.3). */
static void a_line_gives_a_normal_posterior(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 2);
    made.targets[0].value = 18.0;
    made.targets[0].error = 1.0;
    made.targets[1].value = 3.0;
    made.targets[1].error = 0.3;
    made.targets[1].held_back = true;
    clod_posterior *self = make(&made);
    const clod_posterior_parameter *u = &self->parameters[0];
    assert_true(u->effective > 1000.0);
    check_at_most(u->rhat, 1.01);
    check_close(u->mean, 0.4, 0.005);
    check_relative(u->deviation, 0.05, 0.05);
    check_close(u->low, 0.4 - 1.645 * 0.05, 0.008);
    check_close(u->high, 0.4 + 1.645 * 0.05, 0.008);
    check_relative(u->width, 2.0 * 1.645 * 0.05 / 0.9, 0.06);
    assert_true(self->used == 1);
    check_close(self->targets[1].mean, 3.4, 0.02);
    check_close(self->targets[1].high - self->targets[1].low, 2.0 * 1.645 * hypot(0.2, 0.3),
                0.08);
    check_close(self->targets[1].off, -0.4 / hypot(0.2, 0.3), 0.08);
    assert_true(self->p_value > 0.2);
    clod_posterior_destroy(&self);
}

/** Four runs on a line, 0.1 off 5 - 4 u by signs + - - + that a line cannot follow: s^2 = 0.04/2, and a prediction at 0.4
 *  is off by s sqrt(1 + 1/4 + 0.1^2/0.3125) = 0.16, times 2.92 to either side by Student's t of two degrees at 90 %, where
 *  a variance that is known would have 1.645. The quantile of 64 draws scatters by a tenth. */
static void a_line_of_few_runs_predicts_by_students_t(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 2);
    made.plan.seeds = 1;
    made.targets[0].value = 18.0;
    made.targets[0].error = 1e-3;
    made.targets[1].error = 1e-3;
    made.targets[1].held_back = true;
    static const double U[] = {0.125, 0.375, 0.625, 0.875};
    double y[4][2];
    for (int i = 0; i < 4; i++) {
        y[i][0] = 10.0 + 20.0 * U[i];
        y[i][1] = 5.0 - 4.0 * U[i] + (i % 3 == 0 ? 0.1 : -0.1);
    }
    const clod_posterior_runs runs = {&made.plan, 4, U, &y[0][0], NULL};
    clod_status status = {CLOD_OK, ""};
    clod_posterior *self = clod_posterior_create(&runs, &status);
    assert_non_null(self);
    const clod_posterior_target *held = &self->targets[1];
    check_close(held->mean, 3.4, 0.01);
    check_relative(0.5 * (held->high - held->low), 2.92 * 0.16, 0.25);
    clod_posterior_destroy(&self);
}

/** A discrepancy is added to the error in squares: hypot(0.6, 0.8) = 1. */
static void a_discrepancy_widens(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 2);
    made.targets[0].value = 18.0;
    made.targets[0].error = 0.6;
    made.targets[0].discrepancy = 0.8;
    made.targets[1].error = 1.0;
    made.targets[1].held_back = true;
    clod_posterior *self = make(&made);
    check_relative(self->parameters[0].deviation, 0.05, 0.05);
    clod_posterior_destroy(&self);
}

/** Targets that want u = 0.2 and u = 0.8 within 0.02: nothing between suits both. */
static void targets_that_contradict_each_other_are_seen(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 2);
    made.targets[0].value = 14.0;
    made.targets[0].error = 0.4;
    made.targets[1].value = 1.8;
    made.targets[1].error = 0.08;
    clod_posterior *self = make(&made);
    check_at_most(self->p_value, 1e-6);
    check_close(self->parameters[0].mean, 0.5, 0.01);
    made.targets[0].value = 26.0; // u = 0.8, as the other
    clod_posterior_destroy(&self);
    self = make(&made);
    assert_true(self->p_value > 0.2);
    check_close(self->parameters[0].mean, 0.8, 0.005);
    check_relative(self->parameters[0].deviation, 0.02 / sqrt(2.0), 0.06);
    clod_posterior_destroy(&self);
}

/** A target out of reach pushes the parameter to its end. */
static void an_end_of_the_range_is_seen(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 2);
    made.targets[0].value = 34.0;
    made.targets[0].error = 1.0;
    made.targets[1].error = 1.0;
    made.targets[1].held_back = true;
    clod_posterior *self = make(&made);
    assert_true(self->parameters[0].above > 0.5 && self->parameters[0].below < 0.01);
    check_at_most(self->p_value, 0.01); // at least 4 deviations: 30 at most
    clod_posterior_destroy(&self);
}

/** A target that is held back and in no run takes nothing from the others. */
static void a_held_back_target_without_runs_is_dropped(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 2);
    made.targets[0].value = 18.0;
    made.targets[0].error = 1.0;
    made.targets[1].error = 1.0;
    made.targets[1].held_back = true;
    double u[POINTS], y[POINTS][2];
    for (int i = 0; i < POINTS; i++) {
        u[i] = ((double)i + 0.5) / POINTS;
        y[i][0] = 10.0 + 20.0 * u[i];
        y[i][1] = (double)NAN;
    }
    made.plan.seeds = 1;
    const clod_posterior_runs runs = {&made.plan, POINTS, u, &y[0][0], NULL};
    clod_status status = {CLOD_OK, ""};
    clod_posterior *self = clod_posterior_create(&runs, &status);
    assert_non_null(self);
    check_close(self->parameters[0].mean, 0.4, 0.005);
    assert_null(self->targets[1].surrogate);
    assert_true(self->targets[1].runs == 0 && self->targets[1].why[0] != '\0');
    assert_true(isnan(self->targets[1].mean) && isnan(self->targets[1].low));
    clod_posterior_destroy(&self);
    made.targets[1].held_back = false; // used, it is needed
    assert_null(clod_posterior_create(&runs, &status));
    assert_non_null(strstr(status.text, "Target t1: 0 of 12 runs have this number."));
}

/** 1499 samples of 4 chains: 2000 of 5996 looked at must reach into the last chain. */
static void samples_of_all_chains_are_looked_at(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 2);
    made.plan.sampling.samples = 1499;
    made.targets[0].value = 18.0;
    made.targets[0].error = made.targets[1].error = 1.0;
    clod_posterior *self = make(&made);
    assert_true(self->count == 5996);
    size_t of_chain[4] = {0};
    for (size_t i = 0; i < 2000; i++) {
        const double *place = clod_posterior_sample(self, i, 2000);
        of_chain[(size_t)(place - self->samples) / 1499]++;
    }
    for (int c = 0; c < 4; c++) {
        check_close((double)of_chain[c], 500.0, 1.0);
    }
    clod_posterior_destroy(&self);
}

/**
 * A normal posterior of mean 0.6 and deviation 0.02, all runs ten deviations away or more. Of one point the mean distance
 * is least at the median. With that, a second one at a distance c is as far from its own median as P(z > c) is half of
 * P(z > c/2): c = 1.03 deviations; the third stands on the other side.
 */
static void further_points_stand_for_the_posterior(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 1);
    made.plan.seeds = 1;
    made.targets[0].value = 22.0;
    made.targets[0].error = 0.4;
    double u[11] = {0.0, 0.1, 0.2, 0.3, 0.4, 0.8, 0.9, 1.0}, y[8];
    for (int i = 0; i < 8; i++) {
        y[i] = 10.0 + 20.0 * u[i];
    }
    const clod_posterior_runs runs = {&made.plan, 8, u, y, NULL};
    clod_status status = {CLOD_OK, ""};
    clod_posterior *self = clod_posterior_create(&runs, &status);
    assert_non_null(self);
    assert_true(clod_posterior_refine(self, u, 8, 3, NULL, &status));
    check_close(u[8], 0.6, 0.004);
    check_close(fabs(u[9] - u[8]), 1.03 * 0.02, 0.25 * 0.02);
    check_close(fabs(u[10] - u[8]), 1.03 * 0.02, 0.25 * 0.02);
    assert_true((u[9] - u[8]) * (u[10] - u[8]) < 0.0);
    clod_posterior_destroy(&self);
}

/**
 * Two parameters, each told by a target of its own: normal about (0.6, 0.3) with deviations of 0.02. The first point
 * stands at the medians of both, the second about a deviation away, in whichever direction, and none where another is.
 */
static void further_points_stand_for_two_parameters(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 2, 2);
    made.plan.seeds = 1;
    made.targets[0].value = 22.0;
    made.targets[1].value = 16.0;
    made.targets[0].error = made.targets[1].error = 0.4;
    double u[18][2], y[16][2];
    for (int i = 0; i < 16; i++) {
        u[i][0] = (i % 4) / 3.0; // (0.667, 0.333), the nearest, is three deviations away
        u[i][1] = (i / 4) / 3.0;
        y[i][0] = 10.0 + 20.0 * u[i][0];
        y[i][1] = 10.0 + 20.0 * u[i][1];
    }
    const clod_posterior_runs runs = {&made.plan, 16, &u[0][0], &y[0][0], NULL};
    clod_status status = {CLOD_OK, ""};
    clod_posterior *self = clod_posterior_create(&runs, &status);
    assert_non_null(self);
    assert_true(clod_posterior_refine(self, &u[0][0], 16, 2, NULL, &status));
    check_close(u[16][0], 0.6, 0.015);
    check_close(u[16][1], 0.3, 0.015);
    const double apart = hypot(u[17][0] - u[16][0], u[17][1] - u[16][1]);
    assert_true(apart > 0.01 && apart < 0.05);
    clod_posterior_destroy(&self);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_gives_a_normal_posterior),
        cmocka_unit_test(a_line_of_few_runs_predicts_by_students_t),
        cmocka_unit_test(a_discrepancy_widens),
        cmocka_unit_test(targets_that_contradict_each_other_are_seen),
        cmocka_unit_test(an_end_of_the_range_is_seen),
        cmocka_unit_test(a_held_back_target_without_runs_is_dropped),
        cmocka_unit_test(samples_of_all_chains_are_looked_at),
        cmocka_unit_test(further_points_stand_for_the_posterior),
        cmocka_unit_test(further_points_stand_for_two_parameters),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
