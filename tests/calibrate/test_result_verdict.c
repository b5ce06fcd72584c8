/**
 * What is told of a card and its targets: met, missed, or untold where surrogates know too little; and that no amount is
 * predicted below 0.
 */

#include <string.h>

#include "calibrate/result.h"
#include "plan_made.h"
#include "support/check.h"

#define CASE(path) CLOD_SOURCE_DIR "/" path
#define UNIAXIAL "cases/copper-ore-uniaxial/case.yaml"
#define RING "cases/calibrate-kadh/ring.yaml"
#define WALL "tests/cli/wall_friction.yaml"

/** Whether a surrogate that is unsure by this at the card tells a target with an error of 3 and a discrepancy of 4: 5. */
static bool tells(double unsure, double q2, double scatter)
{
    const clod_plan_target target = {.error = 3.0, .discrepancy = 4.0};
    const clod_posterior_target of = {
        .unsure = unsure, .checked = true, .check = {.q2 = q2, .scatter = scatter}};
    return clod_result_tells(&target, &of);
}

// Half the variance of runs that scatter by 20 is that of sqrt(200) = 14.1.
static void surrogate_tells_to_within_the_laboratory_or_half_the_runs_variance(void **state)
{
    (void)state;
    assert_true(tells(4.9, 0.0, 1.0));
    assert_false(tells(5.1, 0.0, 1.0));
    assert_false(tells(5.1, 0.49, 20.0));
    assert_true(tells(5.1, 0.51, 20.0));
    assert_true(tells(14.0, 0.9, 20.0));
    assert_false(tells(14.3, 0.9, 20.0));
    const clod_plan_target exact = {.error = 1.0};
    const clod_posterior_target unchecked = {.unsure = 2.0,
                                             .check = {.q2 = 0.9, .scatter = 20.0}};
    assert_false(clod_result_tells(&exact, &unchecked));
}

// However wide the ranges are: runs that scatter by 200 leave 141 of half their variance, and three errors are 15.
static void surrogate_tells_no_target_by_more_than_three_errors(void **state)
{
    (void)state;
    assert_true(tells(14.9, 0.9, 200.0));
    assert_false(tells(15.1, 0.9, 200.0));
    // 1.0 +- 0.2 kPa, of a surrogate that is unsure by 4 kPa
    const clod_plan_target strength = {.error = 200.0};
    const clod_posterior_target wide = {
        .unsure = 4000.0, .checked = true, .check = {.q2 = 0.6, .scatter = 9000.0}};
    assert_false(clod_result_tells(&strength, &wide));
}

static clod_surrogate *something(void)
{
    static char any;
    return (clod_surrogate *)&any; // only asked whether it is there
}

/** The verdict of the used target, of p and of how unsure its surrogate is, or of the one that is held back: 7 measured, 4 to
 *  `high` predicted; and whether there is a warning that begins with these words. */
static const char *verdict(bool held_back, double p, double unsure, double high,
                           const char *words)
{
    static clod_warning_list list;
    plan_made made;
    plan_make(&made, 1, 2);
    made.targets[1].held_back = true;
    clod_posterior_target targets[2] = {{.surrogate = something(), .unsure = unsure},
                                        {.surrogate = something(), .unsure = unsure}};
    for (int t = 0; t < 2; t++) {
        made.targets[t].value = 7.0;
        made.targets[t].error = 1.0;
        targets[t].low = 4.0;
        targets[t].high = high;
        targets[t].at_card = 5.0;
    }
    targets[1].held_back = true;
    clod_posterior posterior = {.target_count = 2, .targets = targets, .p_value = p};
    const clod_study study = {.posterior = &posterior};
    const clod_result self = {.plan = &made.plan, .study = &study};
    clod_result_verdict found;
    assert_true(clod_result_verdict_of(&self, held_back, &found));
    list.count = 0;
    clod_result_verdict_warn(&self, &list);
    bool said = words == NULL;
    for (size_t k = 0; k < list.count; k++) {
        said = said || strstr(list.text[k], words) == list.text[k];
    }
    assert_true(said);
    assert_true(words != NULL || list.count == 0);
    return CLOD_RESULT_VERDICT_NAMES[found];
}

static void p_tells_where_surrogates_do(void **state)
{
    (void)state;
    const char *used =
        "Whether the card meets its targets is not told (targets: untold): p cannot "
        "tell it where surrogates are less sure than the laboratory, and at the "
        "card's values they give t0 5.000 +- 1.100  (measured 7.000 +- 1.000).";
    const char *held = "Whether the card predicts what was held back is not told (held_back: "
                       "untold): ";
    assert_string_equal(verdict(false, 0.051, 0.9, 8.0, NULL), "met");
    assert_string_equal(verdict(false, 0.051, 1.1, 8.0, used), "untold");
    assert_string_equal(verdict(false, 0.049, 0.9, 8.0, NULL), "missed");
    assert_string_equal(verdict(false, 0.049, 1.1, 6.0, NULL), "missed");
    assert_string_equal(verdict(true, 0.5, 0.9, 8.0, NULL), "met");
    assert_string_equal(verdict(true, 0.5, 1.1, 8.0, held), "untold");
    assert_string_equal(verdict(true, 0.5, 0.9, 6.0, NULL), "missed");
    assert_string_equal(verdict(true, 0.5, 1.1, 6.0, used), "missed");
}

// Five targets whose names have the room that is there, or less: what is said behind them is whole.
static void many_long_names_leave_room_for_what_to_do(void **state)
{
    (void)state;
    static clod_warning_list list;
    for (int length = 20; length < 100; length++) {
        plan_made made;
        plan_make(&made, 1, 5);
        clod_posterior_target targets[5];
        for (int t = 0; t < 5; t++) {
            snprintf(made.targets[t].name, sizeof made.targets[t].name, "%0*d", length, t);
            made.targets[t].error = 1.0;
            targets[t] = (clod_posterior_target){.surrogate = something(), .unsure = 2.0};
        }
        clod_posterior posterior = {.target_count = 5, .targets = targets, .p_value = 0.5};
        const clod_study study = {.posterior = &posterior};
        const clod_result self = {.plan = &made.plan, .study = &study};
        list.count = 0;
        clod_result_verdict_warn(&self, &list);
        assert_int_equal(list.count, 1);
        const char *end = " more. Run the tests with the card (report.txt says how), or give "
                          "more points, packings or narrower ranges.";
        assert_true(strlen(list.text[0]) > strlen(end));
        assert_string_equal(list.text[0] + strlen(list.text[0]) - strlen(end), end);
    }
}

static void what_is_not_there_has_no_verdict(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 1);
    made.targets[0].held_back = true;
    clod_posterior_target target = {.held_back = true, .unsure = 9.0};
    clod_posterior posterior = {.target_count = 1, .targets = &target, .p_value = 0.5};
    const clod_study study = {.posterior = &posterior};
    const clod_result self = {.plan = &made.plan, .study = &study};
    clod_result_verdict found;
    assert_false(clod_result_verdict_of(&self, true, &found)); // it has no surrogate
    assert_false(clod_result_verdict_of(&self, false, &found));
}

/** Nine points of u - 0.5, measured at 0 with an error of 0.1: about u = 0.5, and a laboratory would measure -0.16 to 0.16
 *  and more. @param kind  number of a test of this case, or NULL: of no test */
static void predict(const char *path, const char *kind, double *low, double *high)
{
    plan_made made;
    plan_make(&made, 1, 1);
    clod_status status = {CLOD_OK, ""};
    clod_plan_test test = {.middle = clod_case_load(path, NULL, 0, &status)};
    assert_non_null(test.middle);
    made.plan.tests = &test;
    made.plan.test_count = kind != NULL ? 1 : 0;
    made.plan.seeds = 1;
    snprintf(made.targets[0].number, sizeof made.targets[0].number, "%s",
             kind != NULL ? kind : "");
    made.targets[0].error = 0.1;
    double places[9], results[9];
    for (int i = 0; i < 9; i++) {
        places[i] = i / 8.0;
        results[i] = places[i] - 0.5;
    }
    const clod_posterior_runs runs = {&made.plan, 9, places, results, NULL};
    clod_posterior *self = clod_posterior_create(&runs, &status);
    assert_non_null(self);
    *low = self->targets[0].low;
    *high = self->targets[0].high;
    assert_true(self->targets[0].unsure < 0.05);
    assert_true(*low < 0.0 ||
                (self->targets[0].mean >= 0.0 && self->targets[0].at_card >= 0.0));
    clod_posterior_destroy(&self);
    clod_case_destroy(&test.middle);
}

static void amounts_are_predicted_from_0_on(void **state)
{
    (void)state;
    double low, high;
    predict(CASE(UNIAXIAL), NULL, &low, &high);
    assert_true(low < -0.16 && high > 0.16);
    predict(CASE(UNIAXIAL), "sigma_c", &low, &high);
    assert_true(low == 0.0 && high > 0.16);
    predict(CASE(RING), "sigma_c", &low, &high);
    assert_true(low == 0.0 && high > 0.16);
}

// sigma_2 of steady flow that reaches into tension; c and tau of a yield locus and tau_ad of a wall yield locus are on fitted
// lines.
static void stresses_of_lines_and_of_tension_are_predicted_below_0(void **state)
{
    (void)state;
    static const char *const NUMBERS[][2] = {{CASE(RING), "sigma_2"},
                                             {CASE(RING), "c"},
                                             {CASE(RING), "tau"},
                                             {CASE(WALL), "tau_ad"}};
    for (size_t k = 0; k < sizeof NUMBERS / sizeof NUMBERS[0]; k++) {
        double low, high;
        predict(NUMBERS[k][0], NUMBERS[k][1], &low, &high);
        assert_true(low < -0.16 && high > 0.16);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(surrogate_tells_to_within_the_laboratory_or_half_the_runs_variance),
        cmocka_unit_test(surrogate_tells_no_target_by_more_than_three_errors),
        cmocka_unit_test(p_tells_where_surrogates_do),
        cmocka_unit_test(many_long_names_leave_room_for_what_to_do),
        cmocka_unit_test(what_is_not_there_has_no_verdict),
        cmocka_unit_test(amounts_are_predicted_from_0_on),
        cmocka_unit_test(stresses_of_lines_and_of_tension_are_predicted_below_0),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
