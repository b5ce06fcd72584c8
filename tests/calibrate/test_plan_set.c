/**
 * @file test_plan_set.c
 * What a plan changes in the cases: keys of a test, several keys of a parameter, ratios. Values by hand.
 */

#include "plan_lab.h"

#include "clod/case.h"
#include "config/testers.h"

#define LAB CLOD_SOURCE_DIR "/cases/lab-to-outlet/"

static bool load(void **state, const char *text, clod_plan *plan, clod_status *status)
{
    char path[PATH_MAX];
    *status = (clod_status){CLOD_OK, ""};
    lab_write_file(state, "plan.yaml", text);
    return clod_plan_load(temp_path(path, state, "plan.yaml"), NULL, 0, plan, status);
}

static void refuse(void **state, const char *text, const char *words)
{
    clod_plan plan;
    clod_status status;
    assert_false(load(state, text, &plan, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    if (strstr(status.text, words) == NULL) {
        fail_msg("%s: not in: %s", words, status.text);
    }
    clod_plan_fini(&plan);
}

#define FRICTION "parameters: {p: {key: contacts.default.friction, from: 0.2, to: 0.6}}\n"
#define TARGET "targets: [{test: a, number: phi_e, value: 40 deg, error: 1 deg}]\n"
#define OTHER "- {test: b, number: phi_e, value: 41 deg, error: 1 deg}\n"
#define TEST(set) "points: 9\ntests:\n  a: {case: " LAB "ring.yaml, set: {" set "}}\n"

// A budget of the file and points by a setting, and the reverse; two settings, or both in the file, are one too many.
static void points_and_budget_replace_each_other(void **state)
{
    static const char *const POINTS[] = {"points=12"};
    static const char *const BUDGET[] = {"budget=2 h"};
    static const char *const BOTH[] = {"points=12", "budget=2 h"};
    static const char REST[] = "tests: {a: {case: " LAB "ring.yaml}}\n" FRICTION TARGET;
    char path[PATH_MAX], text[1024];
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    snprintf(text, sizeof text, "budget: 10 h\n%s", REST);
    lab_write_file(state, "plan.yaml", text);
    temp_path(path, state, "plan.yaml");
    assert_true(clod_plan_load(path, POINTS, 1, &plan, &status));
    assert_true(plan.points == 12 && plan.budget == 0.0);
    clod_plan_fini(&plan);
    assert_false(clod_plan_load(path, BOTH, 2, &plan, &status));
    assert_non_null(strstr(status.text, "points: has a budget beside it; keep one of them"));
    clod_plan_fini(&plan);
    snprintf(text, sizeof text, "points: 9\n%s", REST);
    lab_write_file(state, "plan.yaml", text);
    assert_true(clod_plan_load(path, BUDGET, 1, &plan, &status));
    assert_true(plan.points == 0 && plan.budget == 7200.0);
    clod_plan_fini(&plan);
}

// Sections are gone into, lists stay whole; the other test has what the case has, 1.2 kPa.
static void a_test_has_its_own_values(void **state)
{
    clod_plan plan;
    clod_status status;
    const char *text =
        "points: 9\ntests:\n"
        "  a: {case: " LAB "ring.yaml, set: {ring_shear: {preshear_stress: 0.6 kPa, "
        "shear_stresses: [0.24 kPa, 0.42 kPa]}, title: 'a \"b\": c'}}\n"
        "  b: {case: " LAB "ring.yaml}\n" FRICTION
        "targets:\n- {test: a, number: phi_e, value: 40 deg, error: 1 deg}\n" OTHER;
    if (!load(state, text, &plan, &status)) {
        fail_msg("%s", status.text);
    }
    const clod_case_programme *low = clod_case_shear(plan.tests[0].middle);
    const clod_case_programme *high = clod_case_shear(plan.tests[1].middle);
    assert_true(fabs(low->preshear_stress - 600.0) < 1e-9 && low->shear_stress_count == 2);
    assert_true(fabs(low->shear_stresses[1] - 420.0) < 1e-9);
    assert_true(fabs(high->preshear_stress - 1200.0) < 1e-9 && high->shear_stress_count == 3);
    assert_string_equal(plan.tests[0].middle->title, "a \"b\": c");
    clod_plan_settings all;
    const double place[] = {0.25}; // 0.2 + 0.25 0.4
    assert_true(clod_plan_settings_at(&plan, &plan.tests[0], place, &all));
    static const char *const WANTED[] = {
        "ring_shear.preshear_stress=0.6 kPa", "ring_shear.shear_stresses=[0.24 kPa, 0.42 kPa]",
        "title=\"a \\\"b\\\": c\"", "contacts.default.friction=0.3"};
    assert_int_equal(all.count, 4);
    for (size_t k = 0; k < 4; k++) {
        assert_string_equal(all.items[k], WANTED[k]);
    }
    clod_plan_settings_fini(&all);
    clod_plan_fini(&plan);
}

// As --set of clod run tells them, at their place in the plan.
static void wrong_settings_are_told_where_they_stand(void **state)
{
    refuse(state, TEST("ring_shear.preshear_stres: 0.6 kPa") FRICTION TARGET, "plan.yaml:3:");
    refuse(state, TEST("ring_shear.preshear_stres: 0.6 kPa") FRICTION TARGET,
           ": tests.a.set.ring_shear.preshear_stres: this key is not known; did you mean "
           "preshear_stress?");
    refuse(state, TEST("ring_shear: {speed: 3 kPa}") FRICTION TARGET,
           "tests.a.set.ring_shear.speed: 3 kPa is not a speed");
    refuse(state, TEST("include: none.yaml") FRICTION TARGET,
           "tests.a.set.include: " LAB "none.yaml: cannot be opened");
    refuse(state, TEST("seed: 3") FRICTION TARGET,
           "tests.a.set.seed: every packing gets a seed of its own");
    refuse(state, TEST("contacts.default.friction: 0.3") FRICTION TARGET,
           "tests.a.set.contacts.default.friction: is a key of the parameter p");
    refuse(state, TEST("ring_shear.speed: ''") FRICTION TARGET,
           "tests.a.set.ring_shear.speed: has no value");
    refuse(state, TEST("") FRICTION TARGET, "tests.a.set: must be keys with values");
}

#define K1 "contacts.default.k1, from: 2e6 N/m^1.5, to: 6e6 N/m^1.5"
#define PLAIN "points: 9\ntests: {a: {case: " LAB "ring.yaml}}\nparameters:\n"

// At the places 0.25 and 0.5: k1 is 3e6, k2 3 times that, the friction of base and lid 1.75 times 0.3.
static void a_parameter_moves_several_keys(void **state)
{
    clod_plan plan;
    clod_status status;
    const char *text =
        PLAIN "  k1: {key: " K1 "}\n"
              "  k2: {key: contacts.default.k2, times: k1, from: 2, to: 4}\n"
              "  mu: {key: contacts.default.friction, from: 0.2, to: 0.6, multiples: "
              "{contacts.fines-rough.friction: 1.75}}\n" TARGET;
    if (!load(state, text, &plan, &status)) {
        fail_msg("%s", status.text);
    }
    const double place[] = {0.25, 0.5, 0.25};
    assert_true(fabs(clod_plan_key_value(&plan, 0, 0, place) / 3e6 - 1.0) < 1e-12);
    assert_true(fabs(clod_plan_key_value(&plan, 1, 0, place) / 9e6 - 1.0) < 1e-12);
    assert_true(fabs(clod_plan_key_value(&plan, 2, 1, place) / 0.525 - 1.0) < 1e-12);
    assert_string_equal(clod_plan_key_unit(&plan.parameters[1]), "N/m^1.5");
    clod_case *found = clod_plan_case(&plan, &plan.tests[0], place, &status);
    assert_non_null(found);
    const int fines = clod_case_material_index(found, "fines");
    const int rough = clod_case_material_index(found, "rough");
    assert_true(fabs(clod_case_pair(found, fines, fines)->k2 / 9e6 - 1.0) < 1e-8);
    assert_true(fabs(clod_case_pair(found, fines, fines)->friction - 0.3) < 1e-8);
    assert_true(fabs(clod_case_pair(found, fines, rough)->friction - 0.525) < 1e-8);
    clod_case_destroy(&found);
    clod_plan_fini(&plan);
}

static void wrong_multiples_and_ratios_are_refused(void **state)
{
#define WITH(more)                                                                             \
    PLAIN "  k1: {key: " K1 "}\n  q: {key: contacts.default.k2, " more "}\n" TARGET
    refuse(state, WITH("from: 1.5, to: 4, times: k2"),
           "plan.yaml:5:58: parameters.q.times: there is no parameter k2");
    refuse(state, WITH("from: 1.5, to: 4, times: q"),
           "parameters.q.times: q is this parameter itself");
    refuse(state, WITH("from: 7e6 N/m^1.5, to: 9e6 N/m^1.5, times: k1"),
           "parameters.q.from: has the unit \"N/m^1.5\", but with times");
    refuse(
        state,
        WITH("from: 7e6 N/m^1.5, to: 9e6 N/m^1.5, multiples: {contacts.default.friction: 0}"),
        "parameters.q.multiples.contacts.default.friction: 0 is no factor");
    refuse(state,
           WITH("from: 7e6 N/m^1.5, to: 9e6 N/m^1.5, multiples: {contacts.default.k1: 2}"),
           "k1 and q have the same key, contacts.default.k1");
    refuse(state,
           WITH("from: 7e6 N/m^1.5, to: 9e6 N/m^1.5, multiples: {contacts.default.k2: 2}"),
           "q and q have the same key, contacts.default.k2");
    refuse(state,
           WITH("from: 7e6 N/m^1.5, to: 9e6 N/m^1.5, multiples: {contacts.default.kadh: 2}"),
           "parameters.q.multiples.contacts.default.kadh: test a refuses it");
    refuse(state, WITH("from: 7e6 N/m^1.5, to: 9e6 N/m^1.5, multiples: {seed: 2}"),
           "parameters.q.multiples.seed: seed is no parameter");
}

#define TWO(more)                                                                              \
    "points: 9\ntests:\n  a: {case: " LAB "ring.yaml}\n"                                       \
    "  b: {case: " LAB "ring.yaml, set: {ring_shear.preshear_stress: 0.6 kPa, "                \
    "ring_shear.shear_stresses: [0.24 kPa, 0.42 kPa]}}\n" FRICTION                             \
    "targets:\n- {test: a, locus: lab.csv, error: 10 Pa}\n"                                    \
    "- {test: b, locus: lab.csv, error: 10 Pa" more "}\n"

static const char *warning_of(void **state, const char *table, const char *text,
                              clod_plan *plan)
{
    clod_status status;
    lab_write_file(state, "lab.csv", table);
    if (!load(state, text, plan, &status)) {
        fail_msg("%s", status.text);
    }
    for (size_t k = 0; k < plan->warnings.count; k++) {
        if (strstr(plan->warnings.text[k], "serve targets of the tests") != NULL) {
            return plan->warnings.text[k];
        }
    }
    return NULL;
}

// Specimen 2 alone is at both stresses.
static void specimens_of_two_tests_are_warned_of(void **state)
{
    static const char HEAD[] = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n";
    static const char HIGH_ROWS[] = "1.2,0.8,0.48,0.5\n1.2,0.8,0.84,0.7\n";
    static const char LOW_ROWS[] = "0.6,0.4,0.24,0.25\n0.6,0.4,0.42,0.35\n";
    static const char SEEDS[] =
        "seed,sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]\n"
        "1,1.2,0.8,0.48,0.5\n1,1.2,0.8,0.84,0.7\n"
        "2,1.2,0.8,0.48,0.5\n2,1.2,0.8,0.84,0.7\n"
        "2,0.6,0.4,0.24,0.25\n2,0.6,0.4,0.42,0.35\n"
        "3,0.6,0.4,0.24,0.25\n3,0.6,0.4,0.42,0.35\n";
    char plain[512];
    snprintf(plain, sizeof plain, "%s%s%s", HEAD, HIGH_ROWS, LOW_ROWS);
    clod_plan plan;
    const char *told = warning_of(state, SEEDS, TWO(""), &plan);
    assert_non_null(told);
    assert_non_null(
        strstr(told, "specimens 2 of this table serve targets of the tests a and b"));
    clod_plan_fini(&plan);
    assert_null(warning_of(state, SEEDS, TWO(", held_back: true"), &plan));
    clod_plan_fini(&plan);
    assert_null(warning_of(state, plain, TWO(""), &plan)); // nothing tells specimens apart
    clod_plan_fini(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(points_and_budget_replace_each_other, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_test_has_its_own_values, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(wrong_settings_are_told_where_they_stand,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_parameter_moves_several_keys, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(wrong_multiples_and_ratios_are_refused,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(specimens_of_two_tests_are_warned_of, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
