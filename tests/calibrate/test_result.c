/**
 * When a parameter counts as identified: borders of the width, a surrogate that predicts and one that moves, targets that
 * are met; what is said of Markov chains that lie apart; and when a calibration warns of few independent draws.
 */

#include <string.h>

#include "base/memory.h"
#include "calibrate/result.h"
#include "plan_made.h"
#include "support/check.h"

static const char *name_of(double width, bool predictive, double moved, double p)
{
    clod_posterior_parameter one = {.width = width, .moved = moved};
    const clod_posterior of = {
        .parameters = &one, .dimensions = 1, .predictive = predictive, .p_value = p};
    return CLOD_RESULT_IDENTIFIED_NAMES[clod_result_identified_of(&of, 0)];
}

static const char *name(double width, bool predictive)
{
    return name_of(width, predictive, 10.0, 0.5);
}

static void what_moves_no_target_is_not_identified(void **state)
{
    (void)state;
    assert_string_equal(name_of(0.06, true, 2.1, 0.5), "yes");
    assert_string_equal(name_of(0.06, true, 1.9, 0.5), "no");
    assert_string_equal(name_of(0.30, true, 1.9, 0.5), "no");
}

static void targets_that_are_missed_identify_nothing(void **state)
{
    (void)state;
    assert_string_equal(name_of(0.06, true, 10.0, 0.051), "yes");
    assert_string_equal(name_of(0.06, true, 10.0, 0.049), "missed");
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

/** Whether a calibration of this parameter is warned of in these words. */
static bool warns(clod_posterior_parameter parameter, double p, bool card_is_mean,
                  const char *words)
{
    plan_made made;
    plan_make(&made, 1, 1);
    double correlation = 1.0;
    clod_posterior_target target = {.held_back = true};
    const clod_posterior posterior = {.dimensions = 1,
                                      .target_count = 1,
                                      .targets = &target,
                                      .parameters = &parameter,
                                      .correlation = &correlation,
                                      .p_value = p,
                                      .card_is_mean = card_is_mean,
                                      .used = 1};
    const clod_study study = {.posterior = (clod_posterior *)&posterior};
    const clod_runs runs = {.plan = &made.plan};
    clod_result self = {.plan = &made.plan, .study = &study, .runs = &runs};
    clod_result_warn(&self);
    for (size_t k = 0; k < self.warnings.count; k++) {
        if (strstr(self.warnings.text[k], words) != NULL) {
            return true;
        }
    }
    return false;
}

// A width of 1.08 is that of an interval at both ends of the range, wider than what the range alone has.
static void width_is_told_by_that_of_the_range_alone(void **state)
{
    (void)state;
    const char *words =
        "hardly narrow p0: its 90 % interval is 108 % as wide as if nothing were measured.";
    clod_posterior_parameter wide = {
        .rhat = 1.0, .effective = 1e4, .moved = 10.0, .width = 1.08};
    assert_true(warns(wide, 0.5, true, words));
    wide.width = 0.59;
    assert_false(warns(wide, 0.5, true, "hardly narrow"));
}

/** What one is warned of whose chains have this R-hat and so many independent samples. */
static bool warns_of_chains(double rhat, double effective, const char *words)
{
    return warns(
        (clod_posterior_parameter){.rhat = rhat, .effective = effective, .moved = 10.0}, 0.5,
        false, words);
}

// An end of the range, or targets out of reach, are the reason themselves; 30 % of the samples in the last 5 % are the border.
static void means_that_miss_are_told_where_nothing_else_says_why(void **state)
{
    (void)state;
    const char *words = "The means of the parameters together miss the targets";
    const clod_posterior_parameter inside = {.rhat = 1.0, .effective = 1e4, .moved = 10.0};
    clod_posterior_parameter low = inside, high = inside;
    assert_true(warns(inside, 0.5, false, words));
    assert_false(warns(inside, 0.5, true, words));
    assert_true(warns(inside, 0.051, false, words));
    assert_false(warns(inside, 0.049, false, words));
    low.below = high.above = 0.29;
    assert_true(warns(low, 0.5, false, words));
    assert_true(warns(high, 0.5, false, words));
    low.below = high.above = 0.31;
    assert_false(warns(low, 0.5, false, words));
    assert_false(warns(high, 0.5, false, words));
    assert_true(warns(high, 0.5, false, "wants to go beyond the upper end of its range"));
}

static void few_samples_are_told_from_chains_that_disagree(void **state)
{
    (void)state;
    const char *apart = "do not agree about p0 (R-hat";
    const char *few = "Only 366 samples of p0 are independent (400 wanted): give more";
    assert_true(warns_of_chains(1.014, 366.0, few));
    assert_false(warns_of_chains(1.014, 366.0, apart));
    assert_true(warns_of_chains(1.06, 366.0, apart));
    assert_false(warns_of_chains(1.06, 366.0, few));
    assert_false(warns_of_chains(1.014, 401.0, "independent"));
}

/** Posterior of 9 points on u (1 - u) with a measured value and an error: 0.16 is there at u = 0.2 and at 0.8; 0.35, which
 *  nothing gives, is nearest in the middle. @param samples of each chain: halves of two have no scatter of their
 *  own, and R-hat is infinite where they differ */
static clod_posterior *of_a_parabola(plan_made *made, double value, int samples, bool *apart)
{
    plan_make(made, 1, 1);
    made->plan.sampling.samples = samples;
    made->plan.seeds = 1;
    made->targets[0].value = value;
    made->targets[0].error = 0.002;
    double places[9], results[9];
    for (int i = 0; i < 9; i++) {
        places[i] = i / 8.0;
        results[i] = places[i] * (1.0 - places[i]);
    }
    const clod_posterior_runs runs = {&made->plan, 9, places, results, NULL};
    clod_status status = {CLOD_OK, ""};
    clod_posterior *self = clod_posterior_create(&runs, &status);
    assert_non_null(self);
    *apart = self->apart;
    return self;
}

/** All files of a calibration of that parabola; owned. */
static void tell(plan_made *made, clod_posterior *posterior, char *texts[4])
{
    clod_status status = {CLOD_OK, ""};
    clod_case *from =
        clod_case_load(CLOD_SOURCE_DIR "/cases/calibrate-kadh/ring.yaml", NULL, 0, &status);
    assert_non_null(from);
    clod_plan_test test = {.name = made->names[0], .path = made->names[0], .middle = from};
    made->plan.tests = &test;
    made->plan.test_count = 1;
    const clod_study study = {.posterior = posterior, .points = 9, .designed = 9};
    const clod_runs runs = {.plan = &made->plan};
    clod_result self = {.plan = &made->plan, .study = &study, .runs = &runs};
    clod_result_warn(&self);
    texts[0] = clod_result_table(&self);
    texts[1] = clod_result_card(&self);
    texts[2] = clod_result_json(&self);
    texts[3] = clod_result_samples(&self);
    for (int k = 0; k < 4; k++) {
        assert_non_null(texts[k]);
    }
    clod_case_destroy(&from);
}

static void chains_that_lie_apart_have_no_result(void **state)
{
    (void)state;
    plan_made made;
    bool apart;
    char *texts[4];
    clod_posterior *self = of_a_parabola(&made, 0.16, 2, &apart);
    assert_true(apart);
    assert_true(self->parameters[0].rhat > 1.5);
    assert_true(isnan(self->parameters[0].mean) && isnan(self->parameters[0].low));
    assert_true(isnan(self->targets[0].mean) && isnan(self->targets[0].high));
    assert_string_equal(CLOD_RESULT_IDENTIFIED_NAMES[clod_result_identified_of(self, 0)],
                        "apart");
    tell(&made, self, texts);
    assert_true(strncmp(texts[0], "NO RESULT: the Markov chains lie apart", 38) == 0);
    assert_non_null(strstr(texts[0], "Several separate answers"));
    assert_null(strstr(texts[0], "do not tell"));
    assert_null(strstr(texts[0], "sampling.samples"));
    assert_null(strstr(texts[0], "nan"));
    assert_non_null(strstr(texts[1], "# NO RESULT"));
    assert_null(strstr(texts[1], "p0:")); // every line is a comment
    assert_null(strstr(texts[1], "calibrated_with"));
    assert_non_null(strstr(texts[2], "\"chains_apart\": true"));
    assert_non_null(strstr(texts[2], "\"mean\": null"));
    assert_string_equal(texts[3], "p0 [1]\n");
    for (int k = 0; k < 4; k++) {
        clod_memory_free(texts[k]);
    }
    clod_posterior_destroy(&self);
}

static void chains_that_agree_have_one(void **state)
{
    (void)state;
    plan_made made;
    bool apart;
    char *texts[4];
    clod_posterior *self = of_a_parabola(&made, 0.35, 2000, &apart);
    assert_false(apart);
    check_close(self->parameters[0].mean, 0.5, 0.02);
    tell(&made, self, texts);
    assert_non_null(strstr(texts[0], " missed "));
    assert_non_null(strstr(texts[1], "p0: 0.5"));
    assert_non_null(strstr(texts[1], "calibrated_with:"));
    assert_non_null(strstr(texts[1], "; not identified: the targets are missed"));
    assert_non_null(strstr(texts[2], "\"identified\": \"missed\""));
    for (int k = 0; k < 4; k++) {
        clod_memory_free(texts[k]);
    }
    clod_posterior_destroy(&self);
}

// The used line tells u = 0.5, and twice that line is held back: 1 is predicted, as measured or not.
static void card_says_whether_its_targets_are_met(void **state)
{
    (void)state;
    static const struct {
        double used, held;
        const char *words;
    } ROWS[] = {{0.5, 1.0, "  targets: met\n  held_back: met\n"},
                {0.5, 3.0, "  targets: met\n  held_back: missed\n"},
                {2.0, 2.0, "  targets: missed\n"}};
    for (int k = 0; k < 3; k++) {
        plan_made made;
        plan_make(&made, 1, 2);
        made.plan.seeds = 1;
        double places[9], results[9][2];
        for (int i = 0; i < 9; i++) {
            places[i] = i / 8.0;
            results[i][0] = places[i];
            results[i][1] = 2.0 * places[i];
        }
        made.targets[0].value = ROWS[k].used;
        made.targets[1].value = ROWS[k].held;
        made.targets[0].error = made.targets[1].error = 0.02;
        made.targets[1].held_back = true;
        const clod_posterior_runs runs = {&made.plan, 9, places, &results[0][0], NULL};
        clod_status status = {CLOD_OK, ""};
        clod_posterior *self = clod_posterior_create(&runs, &status);
        assert_non_null(self);
        char *texts[4];
        tell(&made, self, texts);
        if (strstr(texts[1], ROWS[k].words) == NULL) {
            fail_msg("%s", texts[1]);
        }
        for (int m = 0; m < 4; m++) {
            clod_memory_free(texts[m]);
        }
        clod_posterior_destroy(&self);
    }
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
        cmocka_unit_test(width_is_told_by_that_of_the_range_alone),
        cmocka_unit_test(what_moves_no_target_is_not_identified),
        cmocka_unit_test(targets_that_are_missed_identify_nothing),
        cmocka_unit_test(means_that_miss_are_told_where_nothing_else_says_why),
        cmocka_unit_test(few_samples_are_told_from_chains_that_disagree),
        cmocka_unit_test(chains_that_lie_apart_have_no_result),
        cmocka_unit_test(card_says_whether_its_targets_are_met),
        cmocka_unit_test(chains_that_agree_have_one),
        cmocka_unit_test(one_used_target_must_follow_the_parameters),
        cmocka_unit_test(few_independent_draws_are_warned_of),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
