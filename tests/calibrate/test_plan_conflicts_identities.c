/**
 * @file test_plan_conflicts_identities.c
 * Targets of a shear test of which one follows from the others: borders of two standard errors, by a program of its own that finds
 * the circle through preshear by bisection and the errors by derivatives. The case preshears at 54.8 kPa.
 */

#include "plan_lab.h"

#define NUMBER(name, value, error) "number: " name ", value: " value ", error: " error
#define AND "}, {test: lab, "
#define C(value, error) NUMBER("c", value " kPa", error " kPa")
#define PHI(value, error) NUMBER("phi_lin", value " deg", error " deg")
#define MAJOR(value, error) NUMBER("sigma_1", value " kPa", error " kPa")
#define MINOR(value, error) NUMBER("sigma_2", value " kPa", error " kPa")
#define PHI_E(value, error) NUMBER("phi_e", value " deg", error " deg")
#define PHI_SF(value, error) NUMBER("phi_sf", value " deg", error " deg")
#define TAU_P(value, error) NUMBER("tau_p", value " kPa", error " kPa")

/** Which values of the number go with the others: below and above the borders on both sides. */
typedef struct borders {
    const char *number, *unit, *error;
    const char *low, *least, *most, *high; ///< refused, good, good, refused
} borders;

static void check(void **state, const char *others, const borders *of, const char *words)
{
    const char *const values[] = {of->low, of->least, of->most, of->high};
    for (size_t k = 0; k < 4; k++) {
        clod_plan plan;
        char target[512];
        snprintf(target, sizeof target,
                 "%s}, {test: lab, number: %s, value: %s %s, error: %s %s", others, of->number,
                 values[k], of->unit, of->error, of->unit);
        if (k == 1 || k == 2) {
            lab_load_good(state, RING, target, &plan);
            clod_plan_fini(&plan);
        } else {
            lab_refuse(state, RING, target, words);
        }
    }
}

// 3.4641 +- 0.4237 kPa: 2.617 to 4.311.
static void strength_of_a_line(void **state)
{
    check(
        state, C("1", "0.1") AND PHI("30", "2"),
        &(borders){"sigma_c", "kPa", "0.2", "2.60", "2.63", "4.29", "4.33"},
        "does not go with c 1 kPa in targets.0 and phi_lin 30 deg in targets.1: with these a straight yield locus has "
        "3.464 kPa (sigma_c = 2 c cos(phi_lin)/(1 - sin(phi_lin))), 2.0 standard errors away");
}

// Angles end at 80 deg: with phi_lin 74 and 80 deg it is 14.2307 and 22.8601 kPa, 5.7529 kPa for 4 deg; 19.0287 +- 5.7569
// kPa: 7.515 and up.
static void angles_that_are_hardly_known(void **state)
{
    clod_plan plan;
    lab_refuse(state, RING,
               C("1", "0.01") AND PHI("78", "4") AND NUMBER("sigma_c", "7.48 kPa", "0.1 kPa"),
               "with these a straight yield locus has 19.03 kPa");
    lab_load_good(
        state, RING,
        C("1", "0.01") AND PHI("78", "4") AND NUMBER("sigma_c", "7.55 kPa", "0.1 kPa"), &plan);
    clod_plan_fini(&plan);
    lab_load_good(state, RING,
                  C("0.2", "0.01") AND PHI("60", "40")
                      AND NUMBER("sigma_c", "0.7 kPa", "0.01 kPa"),
                  &plan);
    clod_plan_fini(&plan);
}

// As strength_of_a_line: 3.4641 +- 1.2286 kPa, 1.007 to 5.921.
static void discrepancies_count(void **state)
{
    check(state, C("1", "0.1") ", discrepancy: 0.3 kPa" AND PHI("30", "2"),
          &(borders){"sigma_c, discrepancy: 0.5 kPa", "kPa", "0.2", "0.99", "1.02", "5.90",
                     "5.94"},
          "does not go with c 1 kPa in targets.0 and phi_lin 30 deg in targets.1");
}

/** How many warnings have words. */
static size_t count_warnings(const clod_plan *plan, const char *words)
{
    size_t count = 0;
    for (size_t k = 0; k < plan->warnings.count; k++) {
        count += strstr(plan->warnings.text[k], words) != NULL ? 1 : 0;
    }
    return count;
}

// tau = C (sigma/T + 1)^(1/1.35), C = 0.24, T = 0.35, preshear (1.2, 0.97 tau(1.2)): circles that touch it, by a program of
// its own; stresses times 54.8/1.2, errors of 2 %. c is the shear stress at 0, phi_lin of the line that touches both circles.
#define CURVE                                                                                  \
    TAU_P("32.01", "0.64")                                                                     \
    AND MAJOR("90.01", "1.8") AND NUMBER("sigma_c", "34.66 kPa", "0.69 kPa")                   \
        AND PHI("21.45", "0.43")
static void curved_loci_are_possible(void **state)
{
    static const char *const WORDS = "does not go with";
    clod_plan plan;
    lab_refuse(
        state, RING, CURVE AND C("10.96", "0.22"),
        "standard errors away; c or phi_lin of a curved locus? Then leave it out, hold it back, or state a "
        "discrepancy; else correct one of them");
    lab_load_good(state, RING, CURVE AND C("10.96", "0.22") ", held_back: true", &plan);
    assert_int_equal(count_warnings(&plan, WORDS), 1);
    assert_int_equal(
        count_warnings(
            &plan, "No parameters give all of them, so what is held back will likely be missed "
                   "(c or phi_lin of a curved locus?)."),
        1);
    clod_plan_fini(&plan);
    lab_load_good(state, RING,
                  CURVE ", discrepancy: 2 deg" AND C("10.96", "0.22") ", discrepancy: 2 kPa",
                  &plan);
    assert_int_equal(count_warnings(&plan, WORDS), 0);
    clod_plan_fini(&plan);
}

// sigma_c is held back, and sigma_2 (30 kPa) is not.
static void what_is_used_is_refused_beside_what_is_held_back(void **state)
{
    lab_refuse(state, RING,
               C("1", "0.1") AND PHI("30", "2")
                   AND NUMBER("sigma_c", "9 kPa", "0.2 kPa, held_back: true")
                       AND MAJOR("90", "3") AND PHI_E("30", "3") AND MINOR("45", "2"),
               "sigma_2 45 kPa in targets.5 does not go with");
}

// 25.8194 +- 1.9043 kPa: 22.011 to 29.628.
static void points_of_a_line(void **state)
{
    check(
        state, C("10", "1") AND PHI("30", "2"),
        &(borders){"tau, normal_stress: 27.4 kPa", "kPa", "1", "21.9", "22.1", "29.5", "29.7"},
        "a straight yield locus has 25.82 kPa (tau = c + sigma tan(phi_lin))");
}

// 103.923 +- 7.238 kPa: 89.447 to 118.399.
static void flowability_of_a_line(void **state)
{
    check(
        state, NUMBER("ffc", "3", "0.1") AND C("10", "0.5") AND PHI("30", "1"),
        &(borders){"sigma_1", "kPa", "3", "89.2", "89.7", "118.1", "118.7"},
        "does not go with ffc 3 in targets.0, c 10 kPa in targets.1 and phi_lin 30 deg in targets.2");
}

// 30 +- 4.2614 kPa: 21.477 to 38.523.
static void principal_stresses_of_an_effective_angle(void **state)
{
    check(
        state, MAJOR("90", "3") AND PHI_E("30", "3"),
        &(borders){"sigma_2", "kPa", "2", "21.4", "21.6", "38.4", "38.6"},
        "a straight yield locus has 30 kPa (sin(phi_e) = (sigma_1 - sigma_2)/(sigma_1 + sigma_2))");
}

// Through (54.8, tau_p): 34.9994 +- 2.0581 kPa, 30.883 to 39.116; 32.5654 +- 1.6687 deg, 29.228 to 35.903. With 40 deg for
// sigma_2: 35.2151 +- 1.7816 kPa, 31.652 to 38.778; 32.7252 +- 1.4800 deg, 29.765 to 35.685.
static void preshear_on_the_circle(void **state)
{
    static const char *const WORDS = "(sigma_1 - sp)(sp - sigma_2) = tau_p^2";
    check(state, MAJOR("90", "3") AND MINOR("20", "2"),
          &(borders){"tau_p", "kPa", "1", "30.8", "31.0", "39.0", "39.2"}, WORDS);
    check(state, MAJOR("90", "3") AND MINOR("20", "2"),
          &(borders){"phi_sf", "deg", "1", "29.1", "29.3", "35.8", "36.0"}, WORDS);
    check(state, MAJOR("90", "3") AND PHI_E("40", "2"),
          &(borders){"tau_p", "kPa", "1", "31.5", "31.8", "38.6", "38.9"}, WORDS);
    check(state, MAJOR("90", "3") AND PHI_E("40", "2"),
          &(borders){"phi_sf", "deg", "1", "29.6", "29.9", "35.6", "35.8"}, WORDS);
}

// 118.359 +- 2.726 kPa, 112.91 to 123.81, and 44.647 +- 0.738 deg, 43.17 to 46.12; with phi_sf 118.363 +- 2.841 kPa, 112.68
// to 124.05, and 44.646 +- 0.742 deg, 43.16 to 46.13.
static void circle_that_touches_the_line(void **state)
{
#define LINE C("10.96", "0.2") AND PHI("35", "0.3")
    static const char *const WORDS = "(its circle through preshear)";
    check(state, LINE AND TAU_P("46.58", "0.2"),
          &(borders){"sigma_1", "kPa", "2", "112.8", "113.0", "123.7", "123.9"}, WORDS);
    check(state, LINE AND TAU_P("46.58", "0.2"),
          &(borders){"phi_e", "deg", "0.5", "43.1", "43.2", "46.1", "46.2"}, WORDS);
    check(state, LINE AND PHI_SF("40.365", "0.15"),
          &(borders){"sigma_1", "kPa", "2", "112.5", "112.8", "123.9", "124.2"}, WORDS);
    check(state, LINE AND PHI_SF("40.365", "0.15"),
          &(borders){"phi_e", "deg", "0.5", "43.1", "43.2", "46.1", "46.2"}, WORDS);
}

// docs/theory/yield-locus.md: c = 2 kPa, phi_lin = 35 deg, preshear (10, 8.5) kPa; its stresses times 5.48.
static void numbers_of_one_locus_go_together(void **state)
{
    clod_plan plan;
    lab_load_good(state, RING,
                  C("10.96", "0.01") AND PHI("35", "0.04") AND TAU_P("46.58", "0.05")
                      AND PHI_SF("40.365", "0.04") AND PHI_E("44.647", "0.05")
                          AND MAJOR("118.359", "0.12") AND MINOR("20.663", "0.03")
                              AND NUMBER("sigma_c", "42.108 kPa", "0.05 kPa")
                                  AND NUMBER("ffc", "2.8108", "0.003") AND NUMBER(
                                      "tau", "30.146 kPa", "0.04 kPa, normal_stress: 27.4 kPa"),
                  &plan);
    clod_plan_fini(&plan);
}

// Steady flow through (54.8, 45) kPa that touches 40 kPa + sigma tan(10 deg) begins below 0, so it has no phi_e.
static void tension_has_no_effective_angle(void **state)
{
    clod_plan plan;
    lab_load_good(
        state, RING,
        C("40", "0.5") AND PHI("10", "0.5") AND TAU_P("45", "0.5") AND PHI_E("60", "1"), &plan);
    clod_plan_fini(&plan);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(strength_of_a_line),
        TEST(angles_that_are_hardly_known),
        TEST(discrepancies_count),
        TEST(curved_loci_are_possible),
        TEST(what_is_used_is_refused_beside_what_is_held_back),
        TEST(points_of_a_line),
        TEST(flowability_of_a_line),
        TEST(principal_stresses_of_an_effective_angle),
        TEST(preshear_on_the_circle),
        TEST(circle_that_touches_the_line),
        TEST(numbers_of_one_locus_go_together),
        TEST(tension_has_no_effective_angle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
