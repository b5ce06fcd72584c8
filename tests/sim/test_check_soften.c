// What the preflight says of contacts.soften, by hand (docs/theory/softening.md).

#include <math.h>
#include <stdio.h>

#include "support/preflight.h"

#define GRAINS(speed, stress)                                                                  \
    "materials: {ore: {density: 2481.3 kg/m3}}\n"                                              \
    "gravity: [0, 0, 0]\n"                                                                     \
    "grains:\n"                                                                                \
    "  - {material: ore, count: 100, velocity: [" speed ", 0 m/s, 0 m/s],\n"                   \
    "     radius: {distribution: uniform, min: 2.9999 mm, max: 3.0001 mm},\n"                  \
    "     region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 60 mm]}}}\n"             \
    "domain: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 60 mm],\n"                          \
    "  periodic: [true, true, true]}\n"                                                        \
    "time: {design_stress: " stress "}\n"                                                      \
    "stages: [{name: one, duration: 1 ms}]\n"
#define MEPA                                                                                   \
    "contacts: {default: {law: mepa, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"                \
    "  k_adh: 3.56e8 N/m^1.5, friction: 0}}\n"

static const char ORE[] = GRAINS("2 m/s", "50 kPa") MEPA;

static double mass(void)
{
    return 4.0 / 3.0 * M_PI * 27e-9 * 2481.3;
}

static bool notes(const char *words)
{
    bool found = false;
    for (size_t n = 0; n < report.note_count; n++) {
        found = found || strstr(report.note[n], words) != NULL;
    }
    return found;
}

// 1.8 N: d = (F/k1)^(2/3). Impact of 2 m/s: 2/5 k1 d^(5/2) = m v^2/4.
static void numbers_of_both_stiffnesses(void **state)
{
    (void)state;
    preflight(ORE, "contacts.soften=32");
    const double pull = 3.56 / 4.75 * (23.7 - 4.75) / (23.7 + 3.56);
    const double speed = 2.0;
    for (int s = 0; s < 2; s++) {
        const clod_check_contact *c = s == 0 ? &report.hard : &report.soft;
        const double k1 = s == 0 ? 4.75e8 : 4.75e8 / 32.0;
        const double rest = pow(1.8 / k1, 2.0 / 3.0);
        const double deep = pow(2.5 / k1 * 0.25 * mass() * speed * speed, 0.4);
        const double k2 = k1 * 23.7 / 4.75;
        check_relative(c->overlap_ratio, rest / 3e-3, 1e-3);
        check_relative(c->pull_off, 1.8 * pull, 1e-3);
        check_relative(c->automatic, 0.2 * sqrt(0.5 * mass() / (1.5 * k2 * sqrt(rest))), 1e-3);
        check_relative(c->wave_speed, 6e-3 * sqrt(1.5 * k2 * sqrt(rest) / mass()), 1e-3);
        check_relative(c->impact_ratio, deep / 3e-3, 1e-3);
        check_relative(c->impact_force, k1 * pow(deep, 1.5), 1e-3);
        check_relative(c->impact_pull, pull * k1 * pow(deep, 1.5), 1e-3);
        check_relative(c->impact_time, 1.47163 * deep / speed * (1.0 + sqrt(4.75 / 23.7)),
                       1e-3);
    }
    check_relative(report.impact_speed, speed, 1e-9);
    check_relative(report.soft.impact_pull / report.hard.impact_pull, 0.25, 1e-9); // 32^(-2/5)
    check_relative(report.soft.impact_time / report.hard.impact_time, 4.0, 1e-9);
    check_relative(report.soft.automatic / report.hard.automatic, cbrt(32.0), 1e-9);
    assert_true(report.step == report.soft.automatic);
}

static void text_and_json_tell_them(void **state)
{
    (void)state;
    static char text[CLOD_CHECK_TEXT];
    preflight(ORE, "contacts.soften=32");
    clod_check_report_text(&report, text);
    assert_non_null(strstr(text, "every stiffness divided by 32"));
    assert_non_null(strstr(text, "3.17 times as long"));
    assert_non_null(strstr(text, "pull-off after the same press of 50 kPa"));
    assert_true(clod_check_report_json(&report, text));
    assert_non_null(strstr(text, "\"softened_impact_pull_off_N\""));
    assert_non_null(strstr(text, "\"unsoftened_step_auto_s\""));
    preflight(ORE, NULL);
    clod_check_report_text(&report, text);
    assert_null(strstr(text, "softening"));
    assert_true(clod_check_report_json(&report, text));
    assert_null(strstr(text, "soften"));
}

// 50 m/s: 15.8 % and 632 times as soft beyond 5 % (2/5 k1 d^(5/2) = m v^2/4 at 0.15 mm gives
// soften 3.96 at 5 m/s).
static void deep_impacts_are_warned_of(void **state)
{
    (void)state;
    static const char FAST[] = GRAINS("5 m/s", "1 kPa") MEPA;
    const double most = 0.4 * 4.75e8 * pow(0.15e-3, 2.5) / (0.25 * mass() * 25.0);
    char words[64];
    snprintf(words, sizeof words, "contacts.soften: %.2g keeps them there", most);
    assert_true(preflight_warns(FAST, "contacts.soften=50", words));
    assert_false(preflight_warns(FAST, "contacts.soften=2", "impacts at"));
    assert_false(preflight_warns(FAST, NULL, "impacts at"));
    static const char FASTER[] = GRAINS("50 m/s", "1 kPa") MEPA;
    assert_true(preflight_warns(FASTER, "contacts.soften=50", "beyond time.overlap_limit"));
    assert_true(preflight_warns(FASTER, "contacts.soften=50", "the stiffness as given has"));
    assert_true(preflight_warns(ORE, "contacts.soften=1000", "Lower contacts.soften"));
}

static void scales_of_a_law_are_noted(void **state)
{
    (void)state;
    static const char LUDING[] =
        GRAINS("0 m/s", "1 kPa") "contacts: {soften: 16, default: {law: luding, k1: 1e6 N/m, "
                                 "k2: 4e6 N/m, plasticity_depth: 0.05}}\n";
    static const char EEPA[] =
        GRAINS("0 m/s", "1 kPa") "contacts: {soften: 16, default: {law: eepa, exponent: 1, "
                                 "k1: 1e6 N/m, k2: 4e6 N/m, pull_off_force: 2 mN, "
                                 "surface_energy: 0.5 J/m2}}\n";
    preflight(LUDING, NULL);
    assert_true(notes("plasticity_depth is a length"));
    preflight(EEPA, NULL);
    assert_true(notes("its pull grows with the plastic patch: 4 times")); // 16^(1/2)
    assert_true(notes("pull_off_force is not divided"));
    preflight(EEPA, "contacts.soften=1");
    assert_false(notes("pull_off_force is not divided"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_of_both_stiffnesses),
        cmocka_unit_test(text_and_json_tell_them),
        cmocka_unit_test(deep_impacts_are_warned_of),
        cmocka_unit_test(scales_of_a_law_are_noted),
    };
    return cmocka_run_group_tests(tests, NULL, preflight_end);
}
