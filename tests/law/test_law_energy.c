// What a contact stores and loses: derivatives, loops around a cycle, closed forms.

#include "law/law_kinds.h"
#include "support/law_ledger.h"

#define DT LEDGER_DT
#define STEPS 4000

static clod_law_stiffness at(const law_probe *probe, double overlap)
{
    return clod_law_stiffness_at(&probe->law, overlap, probe_motion(overlap).r_star);
}

/** On the unloading branch the force is the derivative of the stored energy. */
static void the_force_is_the_derivative_of_what_is_stored(void **state)
{
    (void)state;
    for (int k = 0; k < LEDGER_LAWS; k++) {
        const clod_case_contact c = ledger_law(k);
        law_probe probe = probe_make(&c);
        probe_path(&probe, 0.0, 8e-6, 10);
        const double most = probe.history.plastic[0];
        const double d = 7.6e-6;
        const double h = 1e-9;
        const double force = probe_press(&probe, d);
        check_relative(probe.history.plastic[0], most, 1e-12); // still on that branch
        const double above = clod_law_normal_energy(&probe.law, at(&probe, d + h), most);
        const double below = clod_law_normal_energy(&probe.law, at(&probe, d - h), most);
        check_relative((above - below) / (2.0 * h), force, 1e-6);
    }
}

/** What changing the history costs is the derivative of the stored energy by it. */
static void the_history_force_is_the_other_derivative(void **state)
{
    (void)state;
    for (int k = 0; k < LEDGER_LAWS; k++) {
        const clod_case_contact c = ledger_law(k);
        law_probe probe = probe_make(&c);
        probe_path(&probe, 0.0, 8e-6, 10);
        const double p = probe.history.plastic[0];
        if (p == 0.0 || c.law == CLOD_LAW_LUDING) { // elastic; luding books work
            continue;
        }
        const double h = 1e-4 * p;
        for (double d = 2e-6; d < 9e-6; d += 2e-6) {
            const clod_law_stiffness s = at(&probe, d);
            const double above = clod_law_normal_energy(&probe.law, s, p + h);
            const double below = clod_law_normal_energy(&probe.law, s, p - h);
            const double expected = -(above - below) / (2.0 * h);
            check_close(clod_law_history_force(&probe.law, s, p), expected,
                        1e-6 * fabs(probe.law.k2) * d);
        }
    }
}

/** Move to an overlap in one step along the normal; what it cost. */
static clod_law_dissipation dissipate_to(law_probe *probe, double from, double to)
{
    clod_law_motion now = probe_motion(to);
    now.velocity.x = (from - to) / DT; // i leaves j as the overlap falls
    clod_law_motion before = now;
    before.overlap = from;
    return ledger_step(probe, &before, &now);
}

/** Sum of the plastic loss on the way from one overlap to another. */
static double lose(law_probe *probe, double from, double to, int steps)
{
    double sum = 0.0;
    for (int s = 0; s < steps; s++) {
        const double a = from + (to - from) * s / steps;
        const double b = from + (to - from) * (s + 1) / steps;
        sum += dissipate_to(probe, a, b).plastic;
    }
    return sum;
}

/** Work of the force on the same way, by an independent probe. */
static double work(law_probe *probe, double from, double to, int steps)
{
    double sum = 0.0;
    double force = from > 0.0 ? probe_press(probe, from) : 0.0;
    for (int s = 0; s < steps; s++) {
        const double before = force;
        force = probe_press(probe, from + (to - from) * (s + 1) / steps);
        sum += 0.5 * (before + force) * (to - from) / steps;
    }
    return sum;
}

/**
 * All that a whole cycle takes is lost, and nothing stays stored: for every law. Sums of
 * trapezoids are of second order in the step; luding's force on its adhesive branch is not a
 * function of overlap and history (docs/theory/energy.md), and is of first order.
 */
static void a_cycle_loses_the_work_put_in(void **state)
{
    (void)state;
    const double turns[] = {0.0, 8e-6, 7.4e-6, 9e-6, 3e-6, 5e-6, 0.0};
    for (int k = 0; k < LEDGER_LAWS; k++) {
        const clod_case_contact c = ledger_law(k);
        law_probe one = probe_make(&c);
        law_probe other = one;
        double lost = 0.0;
        double put_in = 0.0;
        for (int t = 0; t < 6; t++) {
            lost += lose(&one, turns[t], turns[t + 1], STEPS);
            put_in += work(&other, turns[t], turns[t + 1], STEPS);
        }
        const double elastic = clod_law_normal_energy(&one.law, at(&one, 9e-6), 0.0);
        check_close(lost, put_in,
                    elastic * (c.law == CLOD_LAW_LUDING ? 1.0 / STEPS : 16.0 / STEPS / STEPS));
        assert_true(lost > 0.0 || clod_law_kinds_row((clod_law_kind)c.law)->elastic);
    }
}

/** n = 1: loading to d loses k1 d^2/2 less what the branch k2 gives back. */
static void linear_loading_loses_the_triangle(void **state)
{
    (void)state;
    const clod_case_contact c = ledger_law(1);
    law_probe probe = probe_make(&c);
    const double d = 8e-6;
    const double elastic = d * 1e6 / 5e6; // d - d0
    check_relative(lose(&probe, 0.0, d, 100), 0.5 * 1e6 * d * d - 0.5 * 5e6 * elastic * elastic,
                   1e-9);
}

/** One step of the probe at a motion that does not change; what it cost. */
static clod_law_dissipation dissipate_still(law_probe *probe, const clod_law_motion *m)
{
    return ledger_step(probe, m, m);
}

/** A sliding contact loses mu N a way; one that sticks loses nothing. */
static void sliding_loses_friction_times_way(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.rolling = CLOD_ROLLING_NONE;
    law_probe probe = probe_make(&c);
    clod_law_motion m = probe_motion(4e-6);
    const double limit = 0.35 * (3.8 + 2.848); // tests/law/test_law_rolling.c has the numbers
    const double stick = limit / 1.425e6;      // length of the spring when it is cut
    double lost = 0.0;
    m.velocity.y = 0.1;
    for (int s = 0; s < 1000; s++) {
        const double step = dissipate_still(&probe, &m).friction;
        if (0.1 * DT * (s + 1) < stick) {
            check_close(step, 0.0, 1e-9 * limit * stick);
        }
        lost += step;
    }
    check_relative(lost, limit * (0.1 * 1000 * DT - stick), 1e-6);
}

/** Dash-pots: gamma v^2 dt, normal and tangential; nothing else is lost. */
static void dash_pots_lose_gamma_v_squared(void **state)
{
    (void)state;
    clod_case_contact c = contact_elastic(1.0, 1e6);
    c.restitution = 0.4;
    c.friction = 1e3; // sticks
    law_probe probe = probe_make(&c);
    clod_law_motion m = probe_motion(4e-6);
    m.velocity = (vreal3){0.01, 0.02, 0.0};
    probe.history.tangent[0] = 1e6;
    const double gamma = probe.law.damping * sqrt(m.m_star * 1e6); // k_t = k_n here
    const clod_law_dissipation dissipated = dissipate_still(&probe, &m);
    check_relative(dissipated.dash_pot, gamma * (1e-4 + 4e-4) * DT, 1e-9);
    check_close(dissipated.plastic, 0.0, 0.0);
    check_close(dissipated.friction, 0.0, 1e-9 * dissipated.dash_pot);
    check_close(dissipated.rolling, 0.0, 0.0);
}

/** Rolling with the constant torque: cap times angle. */
static void rolling_loses_cap_times_angle(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.rolling = CLOD_ROLLING_CDT;
    law_probe probe = probe_make(&c);
    clod_law_motion m = probe_motion(4e-6);
    m.spin_i.y = 5.0;
    m.spin_j.y = -5.0;
    dissipate_still(&probe, &m); // closed from now on
    const clod_law_dissipation dissipated = dissipate_still(&probe, &m);
    check_relative(dissipated.rolling, 0.3 * (3.8 + 2.848) * 1.5e-3 * 10.0 * DT, 1e-9);
}

/** Slip made of spins alone: the same loss as slip made of velocity. */
static void spins_slide_as_well(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.rolling = CLOD_ROLLING_NONE;
    law_probe probe = probe_make(&c);
    clod_law_motion m = probe_motion(4e-6);
    m.spin_i.z = m.spin_j.z = 20.0;
    const double slip = 20.0 * (m.arm_i + m.arm_j) * DT;
    for (int s = 0; s < 300; s++) {
        dissipate_still(&probe, &m); // until it slides
    }
    const clod_law_dissipation dissipated = dissipate_still(&probe, &m);
    check_relative(dissipated.friction, 0.35 * (3.8 + 2.848) * slip, 1e-9);
}

/** Springs of rolling: nothing is lost below the cap, cap times angle beyond it. */
static void rolling_springs_lose_beyond_the_cap(void **state)
{
    (void)state;
    const double cap = 0.3 * (3.8 + 2.848) * 1.5e-3;
    const double r2 = 1.5e-3 * 1.5e-3;
    for (int kind = 0; kind < 2; kind++) {
        clod_case_contact c = contact_ore();
        c.rolling = kind == 0 ? CLOD_ROLLING_EPSD2 : CLOD_ROLLING_EPSD;
        law_probe probe = probe_make(&c);
        const double stiffness = 1.425e6 * r2 * (kind == 0 ? 1.0 : 2.25 * 0.3 * 0.3);
        const double give = cap / stiffness; // angle at which the spring is cut
        const double rate = 0.013 * give / DT;
        clod_law_motion m = probe_motion(4e-6);
        m.spin_i.y = 0.5 * rate;
        m.spin_j.y = -0.5 * rate;
        double lost = 0.0;
        for (int s = 0; s < 200; s++) {
            const double step = dissipate_still(&probe, &m).rolling;
            if (0.013 * (s + 1) < 1.0) {
                check_close(step, 0.0, 1e-3 * cap * 0.013 * give);
            }
            lost += step;
        }
        check_relative(lost, cap * give * (0.013 * 200 - 1.0), 1e-3);
        const clod_law_memory memory = clod_law_memory_load(&probe.history, 0);
        const clod_law_stored stored =
            clod_law_stored_energy(&probe.law, 4e-6, m.r_star, &memory);
        check_relative(stored.rolling, 0.5 * cap * give, 1e-9);
    }
}

/** epsd's dash-pot counts as rolling loss below the cap; at the cap the loss is that of the
 * cap. */
static void the_dash_pot_of_epsd_is_a_rolling_loss(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.rolling = CLOD_ROLLING_EPSD;
    c.rolling_damping = 0.02; // half of the cap
    law_probe probe = probe_make(&c);
    const double cap = 0.3 * (3.8 + 2.848) * 1.5e-3;
    const double stiffness = 1.425e6 * 1.5e-3 * 1.5e-3 * 2.25 * 0.09;
    const double rate = 0.013 * cap / stiffness / DT;
    clod_law_motion m = probe_motion(4e-6);
    m.spin_i.y = 0.5 * rate;
    m.spin_j.y = -0.5 * rate;
    const double dash_pot = 2.0 * 0.02 * sqrt(m.roll_inertia * stiffness) * rate;
    dissipate_still(&probe, &m);
    check_relative(dissipate_still(&probe, &m).rolling, dash_pot * rate * DT, 1e-3);
    for (int s = 0; s < 100; s++) {
        dissipate_still(&probe, &m);
    }
    for (int s = 0; s < 100; s++) { // whichever way the last bit of the spring was rounded
        m.overlap = 4e-6 * (1.0 + 1e-7 * s);
        check_relative(dissipate_still(&probe, &m).rolling, cap * rate * DT, 1e-3);
    }
}

/** What is stored is told of closed contacts only. */
static void stored_energy_is_that_of_the_closed_contact(void **state)
{
    (void)state;
    const clod_case_contact c = contact_ore();
    law_probe probe = probe_make(&c);
    probe_path(&probe, 0.0, 8e-6, 10);
    probe.history.spring[1][0] = 1e-7;
    const clod_law_memory memory = clod_law_memory_load(&probe.history, 0);
    clod_law_stored stored = clod_law_stored_energy(&probe.law, 8e-6, 1.5e-3, &memory);
    check_relative(stored.normal,
                   clod_law_normal_energy(&probe.law, at(&probe, 8e-6), memory.plastic), 1e-12);
    check_relative(stored.sliding, 0.5 * memory.tangent * 1e-14, 1e-12);
    stored = clod_law_stored_energy(&probe.law, -1e-9, 1.5e-3, &memory);
    check_close(stored.normal, 0.0, 0.0);
    check_close(stored.sliding, 0.0, 0.0);
    check_close(stored.rolling, 0.0, 0.0);
}

/** The step in which a contact opens loses what its history still held. */
static void opening_loses_what_was_held(void **state)
{
    (void)state;
    const clod_case_contact c = contact_ore();
    law_probe probe = probe_make(&c);
    probe_path(&probe, 0.0, 8e-6, 10);
    const double d = 4e-6;
    probe_press(&probe, d);
    const double p = probe.history.plastic[0];
    const double pull = 2.37e9 * (d - pow(p, 2.0 / 3.0));
    check_relative(dissipate_to(&probe, d, -1e-6).plastic, -0.5 * pull * p, 1e-9);
}

/** The overlap of the step before comes from the history, where that depends on it. */
static void the_history_remembers_the_overlap(void **state)
{
    (void)state;
    const double d = 5e-6;
    for (int k = 0; k < LEDGER_LAWS; k++) {
        const clod_case_contact c = ledger_law(k);
        law_probe probe = probe_make(&c);
        clod_law_motion guess = probe_motion(1.3 * d);
        clod_law_memory memory = clod_law_memory_load(&probe.history, 0);
        assert_true(clod_law_overlap_before(&probe.law, &guess, &memory) < 0.0); // was open
        probe_press(&probe, d);
        memory = clod_law_memory_load(&probe.history, 0);
        const double expected = probe.law.exponent == 1.0 ? 1.3 * d : d;
        check_relative(clod_law_overlap_before(&probe.law, &guess, &memory), expected, 1e-12);
        guess.overlap = -0.01; // its wall was taken away since
        assert_true(clod_law_overlap_before(&probe.law, &guess, &memory) < 0.0);
    }
}

/** So a bad guess of it does no harm. */
static void a_bad_guess_of_the_overlap_does_no_harm(void **state)
{
    (void)state;
    const clod_case_contact c = contact_ore();
    law_probe probe = probe_make(&c);
    probe_press(&probe, 4e-6);
    law_probe same = probe;
    const double right = dissipate_to(&probe, 4e-6, 5e-6).plastic;
    clod_law_motion now = probe_motion(5e-6);
    clod_law_motion before = probe_motion(4.5e-6);
    const clod_law_dissipation dissipated = ledger_step(&same, &before, &now);
    check_relative(dissipated.plastic, right, 1e-9);
}

/** Neither friction nor lag of a contact that slips depends on that guess. */
static void a_bad_guess_does_no_harm_to_friction(void **state)
{
    (void)state;
    const clod_case_contact c = contact_ore();
    law_probe probe = probe_make(&c);
    clod_law_motion now = probe_motion(4e-6);
    now.velocity.y = 2.0;
    probe_step(&probe, &now, DT); // its spring pulls
    now.overlap = 5e-6;
    const clod_law_memory memory = clod_law_memory_load(&probe.history, 0);
    clod_law_memory after = memory;
    const clod_law_result result = clod_law_contact(&probe.law, &now, DT, &after);
    clod_law_motion before = now;
    double lag[2], friction[2];
    for (int k = 0; k < 2; k++) {
        before.overlap = k == 0 ? 4e-6 : 2e-6;
        const clod_law_dissipation dissipated =
            clod_law_dissipate(&probe.law, &now, &result, &after, &before, &memory, DT);
        lag[k] = dissipated.lag;
        friction[k] = dissipated.friction;
    }
    assert_true(fabs(lag[0]) > 0.0);
    check_relative(lag[1], lag[0], 1e-9);
    check_relative(friction[1], friction[0], 1e-9);
}

/** Contacts that are open before and after lose nothing, whatever their past says. */
static void open_contacts_lose_nothing(void **state)
{
    (void)state;
    const clod_case_contact c = contact_ore();
    law_probe probe = probe_make(&c);
    const clod_law_dissipation dissipated = dissipate_to(&probe, -3e-6, -2e-6);
    check_close(dissipated.plastic, 0.0, 0.0);
    check_close(dissipated.dash_pot, 0.0, 0.0);
    check_close(dissipated.friction, 0.0, 0.0);
    check_close(dissipated.rolling, 0.0, 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_force_is_the_derivative_of_what_is_stored),
        cmocka_unit_test(the_history_force_is_the_other_derivative),
        cmocka_unit_test(linear_loading_loses_the_triangle),
        cmocka_unit_test(sliding_loses_friction_times_way),
        cmocka_unit_test(dash_pots_lose_gamma_v_squared),
        cmocka_unit_test(rolling_loses_cap_times_angle),
        cmocka_unit_test(spins_slide_as_well),
        cmocka_unit_test(rolling_springs_lose_beyond_the_cap),
        cmocka_unit_test(the_dash_pot_of_epsd_is_a_rolling_loss),
        cmocka_unit_test(stored_energy_is_that_of_the_closed_contact),
        cmocka_unit_test(opening_loses_what_was_held),
        cmocka_unit_test(the_history_remembers_the_overlap),
        cmocka_unit_test(a_bad_guess_of_the_overlap_does_no_harm),
        cmocka_unit_test(a_bad_guess_does_no_harm_to_friction),
        cmocka_unit_test(open_contacts_lose_nothing),
        cmocka_unit_test(a_cycle_loses_the_work_put_in), // the longest
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
