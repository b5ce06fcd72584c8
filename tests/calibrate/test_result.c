/**
 * When a parameter counts as identified: borders of the width, and a surrogate that predicts; and when a calibration
 * warns of few independent draws.
 */

#include <string.h>

#include "calibrate/result.h"
#include "plan_made.h"
#include "support/check.h"

static const char *name(double width, bool predictive)
{
    clod_posterior_parameter one = {.width = width};
    const clod_posterior of = {.parameters = &one, .dimensions = 1, .predictive = predictive};
    return CLOD_RESULT_IDENTIFIED_NAMES[clod_result_identified_of(&of, 0)];
}

static void widths_have_their_names(void **state)
{
    (void)state;
    assert_string_equal(name(0.24, true), "yes");
    assert_string_equal(name(0.26, true), "weakly");
    assert_string_equal(name(0.59, true), "weakly");
    assert_string_equal(name(0.61, true), "no");
    assert_string_equal(name(0.05, false), "weakly");
    assert_string_equal(name(0.61, false), "no");
}

/** Nine points of one packing: a line from 1 to 2 with noise of a hundredth, or up and down by `noise`. */
static bool predicts(double slope, double noise, bool held_back)
{
    plan_made made;
    plan_make(&made, 1, 2);
    made.plan.seeds = 1;
    made.plan.sampling.samples = 100;
    double places[9], results[9][2];
    for (int i = 0; i < 9; i++) {
        places[i] = i / 8.0;
        results[i][0] = 1.0 + (i % 2 == 0 ? noise : -noise);
        results[i][1] = 1.0 + slope * places[i] + (i % 2 == 0 ? noise : -noise);
    }
    for (int t = 0; t < 2; t++) {
        made.targets[t].value = 1.2;
        made.targets[t].error = 0.1;
    }
    made.targets[1].held_back = held_back;
    const clod_posterior_runs runs = {&made.plan, 9, places, &results[0][0], NULL};
    clod_status status = {CLOD_OK, ""};
    clod_posterior *self = clod_posterior_create(&runs, &status);
    assert_non_null(self);
    const bool told = self->predictive;
    clod_posterior_destroy(&self);
    return told;
}

static void one_used_target_must_follow_the_parameters(void **state)
{
    (void)state;
    assert_true(predicts(1.0, 0.01, false));
    assert_false(predicts(1.0, 0.01, true)); // what is held back tells nothing
    assert_false(predicts(0.1, 0.3, false)); // Q2 of noise is below 0
}

/** Whether a calibration warns of the draws of a target, of which so many are independent. */
static bool warns_of_draws(size_t draws, double independent, bool held_back, const char *words)
{
    plan_made made;
    plan_make(&made, 1, 1);
    made.targets[0].held_back = held_back;
    clod_posterior_parameter parameter = {.rhat = 1.0, .effective = 1e4};
    double correlation = 1.0;
    clod_surrogate *anything = (clod_surrogate *)&made; // only asked whether it is there
    clod_posterior_target target = {.surrogate = anything, .held_back = held_back};
    target.independent = independent;
    clod_posterior posterior = {.dimensions = 1,
                                .target_count = 1,
                                .draws = draws,
                                .targets = &target,
                                .parameters = &parameter,
                                .correlation = &correlation,
                                .p_value = 0.5,
                                .used = 1};
    const clod_study study = {.posterior = &posterior};
    const clod_runs runs = {.plan = &made.plan};
    clod_result self = {.plan = &made.plan, .study = &study, .runs = &runs};
    clod_result_warn(&self);
    for (size_t k = 0; k < self.warnings.count; k++) {
        if (strstr(self.warnings.text[k], "are independent: ") != NULL &&
            strstr(self.warnings.text[k], words) != NULL) {
            return true;
        }
    }
    return false;
}

static void few_independent_draws_are_warned_of(void **state)
{
    (void)state;
    const char *used = "or hold this target back", *held = "its predicted interval";
    assert_true(warns_of_draws(64, 15.9, false, used));
    assert_false(warns_of_draws(64, 16.0, false, ""));
    assert_true(warns_of_draws(64, 15.9, true, held)); // the posterior does not rest on it
    assert_false(warns_of_draws(64, 16.0, true, ""));
    assert_true(warns_of_draws(64, 0.0, false, used)); // a chain that never moved
    assert_false(warns_of_draws(8, 8.0, false, ""));   // many runs have few draws, well drawn
    assert_true(warns_of_draws(8, 1.9, false, used));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(widths_have_their_names),
        cmocka_unit_test(one_used_target_must_follow_the_parameters),
        cmocka_unit_test(few_independent_draws_are_warned_of),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
