// How fast a contact gains strength: by hand on the virgin branch, and summed up along a path against
// what the law's own contact remembers at its end.

#include "law/law_cycle.h"
#include "support/law_probe.h"

#define R_STAR 1.5e-3
#define DEEPEST 3e-6 // m
#define STEPS 2000
#define APPROACH 0.2 // m/s

static double memory_of(const law_probe *probe)
{
    return probe->history.plastic[0];
}

static clod_law_gain gain_at(const law_probe *probe, double overlap, double approach)
{
    return clod_law_cycle_gain(&probe->law, R_STAR, overlap, memory_of(probe), approach);
}

static void check_nothing(const law_probe *probe, double overlap, double approach)
{
    const clod_law_gain gain = gain_at(probe, overlap, approach);
    assert_true(gain.pressed == 0.0 && gain.pull == 0.0);
}

/** n = 3/2: d/dt k1 d^n = n k1 sqrt(d) v, and of k_adh x with x = (1 - k1/k2) d^n/(1 + k_adh/k2). */
static void the_ore_gains_by_hand(void **unused)
{
    (void)unused;
    const clod_case_contact ore = contact_ore();
    law_probe probe = probe_make(&ore);
    probe_path(&probe, 0.0, DEEPEST, STEPS);
    const clod_law_gain gain = gain_at(&probe, DEEPEST, APPROACH);
    const double rise = 1.5 * sqrt(DEEPEST) * APPROACH;
    check_relative(gain.pressed, ore.k1 * rise, 1e-5);
    check_relative(gain.pull,
                   ore.k_adh * (1.0 - ore.k1 / ore.k2) / (1.0 + ore.k_adh / ore.k2) * rise,
                   1e-5);
}

/** Press, let off, press deeper: what is gained in all is what is remembered at the end. */
static void check_path(const clod_case_contact *contact, double deepest, double flow)
{
    law_probe probe = probe_make(contact);
    const double stations[] = {0.5 * deepest, 0.45 * deepest, deepest};
    double from = 0.0, pressed = 0.0, pull = 0.0;
    for (int leg = 0; leg < 3; leg++) {
        const double way = stations[leg] - from, part = way / STEPS;
        for (int s = 0; s < STEPS; s++) {
            const double middle = from + ((double)s + 0.5) * part;
            probe_press(&probe, middle);
            const clod_law_gain gain = gain_at(&probe, middle, part); // in a time of 1
            const bool deeper = leg == 0 || (leg == 2 && middle > stations[0]);
            assert_true((gain.pull > 0.0) == (deeper && middle < flow));
            const double force = clod_law_cycle_force(&probe.law, R_STAR, middle);
            assert_true((gain.pressed > 0.0) == (deeper && middle < flow && force > 0.0));
            pressed += gain.pressed;
            pull += gain.pull;
        }
        probe_press(&probe, from = stations[leg]);
    }
    const double overlap = clod_law_cycle_pressed(&probe.law, memory_of(&probe));
    check_relative(overlap, fmin(deepest, flow), 1e-9);
    const double touch = clod_law_cycle_pull(&probe.law, R_STAR, 0.0).force; // of a first touch
    check_relative(pressed, clod_law_cycle_force(&probe.law, R_STAR, overlap), 1e-3);
    check_relative(touch + pull, clod_law_cycle_pull(&probe.law, R_STAR, overlap).force, 1e-3);
}

static void gains_add_up_to_what_is_remembered(void **unused)
{
    (void)unused;
    clod_case_contact contact = contact_ore();
    check_path(&contact, DEEPEST, HUGE_VAL);
    contact.exponent = 1.0;
    contact.k1 = 4.75e5;
    contact.k2 = 2.37e6;
    contact.k_adh = 3.56e5;
    check_path(&contact, DEEPEST, HUGE_VAL);
    contact.law = CLOD_LAW_EEPA;
    contact.pull_off_force = 0.3; // at the touch; k1 d is more from 0.6 um on
    check_path(&contact, DEEPEST, HUGE_VAL);
    contact.pull_off_force = 0.0;
    contact.law = CLOD_LAW_LUDING;
    contact.plasticity_depth = 0.05;
    check_path(&contact, DEEPEST, HUGE_VAL);
    const clod_law law = clod_law_make(&contact, &ORE, &ORE);
    const double flow = contact.plasticity_depth * 2.0 * R_STAR * law.k2 / (law.k2 - law.k1);
    check_path(&contact, 1.3 * flow, flow); // beyond d* nothing more is remembered
}

static void what_remembers_nothing_gains_nothing(void **unused)
{
    (void)unused;
    clod_case_contact contact = contact_ore();
    contact.law = CLOD_LAW_HERTZ;
    law_probe probe = probe_make(&contact);
    probe_path(&probe, 0.0, DEEPEST, STEPS);
    check_nothing(&probe, DEEPEST, APPROACH);
}

static void what_parts_gains_nothing(void **unused)
{
    (void)unused;
    const clod_case_contact ore = contact_ore();
    law_probe probe = probe_make(&ore);
    probe_path(&probe, 0.0, DEEPEST, STEPS);
    check_nothing(&probe, DEEPEST, 0.0);
    check_nothing(&probe, DEEPEST, -APPROACH);
    probe_press(&probe, 0.99 * DEEPEST);
    check_nothing(&probe, 0.99 * DEEPEST, APPROACH); // on k2
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ore_gains_by_hand),
        cmocka_unit_test(gains_add_up_to_what_is_remembered),
        cmocka_unit_test(what_remembers_nothing_gains_nothing),
        cmocka_unit_test(what_parts_gains_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
