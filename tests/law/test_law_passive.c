// No contact makes energy in any step: each loss of the ledger is >= 0, whatever the motion
// does; and closed forms of each loss, worked out by hand beside them.

#include "support/dice.h"
#include "support/law_ledger.h"

#define DT LEDGER_DT
#define MOST 9e-6 // m, largest overlap of the walks

// ---- any motion

/** A contact on a walk of its own: velocities of all sizes, jumps, reversals, openings. */
typedef struct walk {
    dice dice;
    law_probe probe;
    clod_law_motion now;
} walk;

/** Of any size within some decades, in any direction. */
static vreal3 any_vector(dice *d, double low, double high)
{
    double to[3];
    dice_direction(d, to);
    const double size = pow(10.0, dice_real(d, low, high));
    return (vreal3){size * to[0], size * to[1], size * to[2]};
}

static double any_overlap(dice *d, double from)
{
    switch (dice_pick(d, 8)) {
    case 0:
        return dice_real(d, -1e-6, MOST);
    case 1:
        return from;
    default:
        return fmin(from + dice_real(d, -3e-7, 3e-7), MOST);
    }
}

/** The next motion, with the velocity along the normal that leads there. */
static clod_law_motion next_motion(walk *w)
{
    clod_law_motion m = w->now;
    m.overlap = any_overlap(&w->dice, w->now.overlap);
    m.arm_i = m.arm_j = 3e-3 - 0.5 * m.overlap;
    const vreal3 tilt = any_vector(&w->dice, -6.0, -3.0);
    const vreal3 tilted = vreal3_add(m.normal, tilt);
    m.normal = vreal3_scale(tilted, 1.0 / sqrt(vreal3_dot(tilted, tilted)));
    if (dice_pick(&w->dice, 3) == 0) { // else it goes on, or comes back
        m.velocity = any_vector(&w->dice, -4.0, 1.0);
        m.spin_i = any_vector(&w->dice, -1.0, 3.0);
        m.spin_j = any_vector(&w->dice, -1.0, 3.0);
    } else if (dice_pick(&w->dice, 3) == 0) {
        m.velocity = vreal3_scale(m.velocity, -1.0);
        m.spin_i = vreal3_scale(m.spin_i, -1.0);
        m.spin_j = vreal3_scale(m.spin_j, -1.0);
    }
    const double across = vreal3_dot(m.velocity, m.normal);
    const double along = (w->now.overlap - m.overlap) / DT;
    m.velocity = vreal3_axpy(m.velocity, along - across, m.normal);
    return m;
}

/** @param scale  J, an energy of the size of those in the contact */
static void check_losses(clod_law_dissipation dissipated, double scale)
{
    const double rounding = 1e-13 * scale;
    check_at_most(-dissipated.plastic, rounding);
    check_at_most(-dissipated.dash_pot, rounding);
    check_at_most(-dissipated.friction, rounding);
    check_at_most(-dissipated.rolling, rounding);
    assert_true(isfinite(dissipated.lag));
}

static void walk_about(const clod_case_contact *c, uint64_t seed, int steps)
{
    walk w = {.dice = {seed}, .probe = probe_make(c), .now = probe_motion(-1e-6)};
    const clod_law_stiffness most = clod_law_stiffness_at(&w.probe.law, MOST, w.now.r_star);
    const double scale = most.power * w.probe.law.k2 * MOST;
    for (int s = 0; s < steps; s++) {
        clod_law_motion before = w.now;
        w.now = next_motion(&w);
        before.normal = w.now.normal; // as the step gives it: in the directions of today
        check_losses(ledger_step(&w.probe, &before, &w.now), scale);
    }
}

static void no_loss_is_below_zero_in_any_step(void **state)
{
    (void)state;
    const double restitution[] = {0.1, 0.5, 0.9, 0.98};
    const double friction[] = {0.05, 0.3, 1.0};
    dice d = {17};
    for (int law = 0; law < LEDGER_LAWS; law++) {
        for (int k = 0; k < 48; k++) { // every rolling model with every measure, four times
            clod_case_contact c = ledger_law(law);
            c.rolling = k % 4;
            c.coulomb = k / 4 % 3;
            c.restitution = restitution[dice_pick(&d, 4)];
            c.friction = friction[dice_pick(&d, 3)];
            c.rolling_friction = friction[dice_pick(&d, 3)];
            c.rolling_damping = 0.3;
            c.tangential =
                dice_pick(&d, 4) == 0 ? CLOD_TANGENTIAL_LITERAL : CLOD_TANGENTIAL_TANGENT;
            walk_about(&c, dice_bits(&d), 400);
        }
    }
}

// ---- the history, in steps as large as they like

/** One step along the normal; what it cost. */
static clod_law_dissipation press(law_probe *probe, double from, double to)
{
    clod_law_motion now = probe_motion(to);
    now.velocity.x = (from - to) / DT;
    clod_law_motion before = now;
    before.overlap = from;
    return ledger_step(probe, &before, &now);
}

/** n = 1: E on k1 at d is k1^2 d^2/(2 k2), so loading from a to b loses
 * (k1 - k1^2/k2)(b^2 - a^2)/2; and the elastic part of the step costs nothing. */
static void loading_across_the_kink_loses_the_trapezium(void **state)
{
    (void)state;
    const clod_case_contact c = ledger_law(1); // k1 1e6, k2 5e6, k_adh 1e6
    law_probe probe = probe_make(&c);
    const double slope = 1e6 - 1e12 / 5e6;
    check_relative(press(&probe, 0.0, 4e-6).plastic, 0.5 * slope * 16e-12, 1e-12);
    check_close(press(&probe, 4e-6, 3.6e-6).plastic, 0.0, 1e-25);
    check_relative(press(&probe, 3.6e-6, 9e-6).plastic, 0.5 * slope * (81e-12 - 16e-12), 1e-12);
}

/** n = 1, down the adhesive branch: from P = 0.8 * 9e-6 the branch begins at d = P/1.2. There
 * E = (k_adh d)^2/(2 k2), and the step loses what is put in, k_adh d dd, and what E falls by:
 * (k_adh + k_adh^2/k2)(a^2 - b^2)/2. */
static void unloading_across_the_kink_loses_the_trapezium(void **state)
{
    (void)state;
    const clod_case_contact c = ledger_law(1);
    law_probe probe = probe_make(&c);
    press(&probe, 0.0, 9e-6);
    const double begin = 0.8 * 9e-6 / 1.2;
    const double slope = 1e6 + 1e12 / 5e6;
    check_relative(press(&probe, 9e-6, 2e-6).plastic, 0.5 * slope * (begin * begin - 4e-12),
                   1e-12);
    check_relative(press(&probe, 2e-6, -1e-6).plastic, 0.5 * slope * 4e-12, 1e-12); // opens
}

/** eepa's patch, n = 3/2: P on the pull-off line, P = x + F/k2 with F = 3/2 pi gamma
 * sqrt(2 R* dp) at most k2 P/2: where it begins the loss is k2 (d0 - d) of each dP. */
static void check_patch(double surface_energy)
{
    clod_case_contact c = ledger_law(6);
    c.surface_energy = surface_energy;
    law_probe probe = probe_make(&c);
    press(&probe, 0.0, 9e-6);
    const double p = probe.history.plastic[0];
    const double patch = 1.5 * M_PI * c.surface_energy * sqrt(2.0 * 1.5e-3);
    const double pull = fmin(patch * cbrt(p), 0.5 * c.k2 * p); // sqrt(dp) = P^(1/3)
    const double begin = pow(p - pull / c.k2, 2.0 / 3.0);
    check_close(press(&probe, 9e-6, 1.0001 * begin).plastic, 0.0, 1e-25);
    const double small = press(&probe, 1.0001 * begin, 0.9999 * begin).plastic;
    const double change = p - probe.history.plastic[0];
    assert_true(change > 0.0);
    check_relative(small, c.k2 * (cbrt(p * p) - begin) * change, 1e-3);
}

static void the_pull_off_line_of_the_patch_loses_nothing_before_it_is_met(void **state)
{
    (void)state;
    check_patch(0.03);
    check_patch(2.0);
    check_patch(1e5); // its pull is at most k2 P/2
}

/** Luding on k1: work k1 (b^2 - a^2)/2 less the change of E = k1^2 d^2/(2 k2(d)); the mean of
 * both ends is of second order. */
static void luding_loads_with_the_loss_of_its_branch(void **state)
{
    (void)state;
    const clod_case_contact c = ledger_law(7);
    law_probe probe = probe_make(&c);
    press(&probe, 0.0, 4e-6);
    const double h = probe.law.hardening / 1.5e-3;
    double expected = 0.0;
    for (int end = 0; end < 2; end++) {
        const double d = end == 0 ? 4e-6 : 4.04e-6;
        const double stored = 0.5 * 1e12 * d * d / (1e6 + h * d);
        expected += (end == 0 ? -1.0 : 1.0) * (0.5 * 1e6 * d * d - stored);
    }
    check_relative(press(&probe, 4e-6, 4.04e-6).plastic, expected, 1e-4);
}

/** Luding over d* in one step: the loss ends with the history at d*. d* = flow R*, k2 there. */
static void luding_loses_no_more_beyond_its_largest_history(void **state)
{
    (void)state;
    const clod_case_contact c = ledger_law(7);
    law_probe probe = probe_make(&c);
    const double most = probe.law.flow * 1.5e-3;
    press(&probe, 0.0, 0.99 * most);
    const double h = probe.law.hardening / 1.5e-3;
    double expected = 0.0;
    for (int end = 0; end < 2; end++) {
        const double d = end == 0 ? 0.99 * most : most;
        const double stored = 0.5 * 1e12 * d * d / (1e6 + h * d);
        expected += (end == 0 ? -1.0 : 1.0) * (0.5 * 1e6 * d * d - stored);
    }
    check_relative(press(&probe, 0.99 * most, 1.3 * most).plastic, expected, 1e-4);
}

// ---- springs

/** A sticking contact at an overlap, its spring stretched along y; k_t = dk = 1.5 k1 sqrt(d).
 */
static law_probe stretched(double overlap, double stretch, int rolling)
{
    clod_case_contact c = contact_elastic(1.5, 4.75e8);
    c.friction = 1e3;
    c.rolling_friction = 1e3;
    c.rolling = rolling;
    law_probe probe = probe_make(&c);
    press(&probe, overlap, overlap);
    probe.history.spring[1][0] = stretch;
    probe.history.roll[1][0] = rolling == CLOD_ROLLING_NONE ? 0.0 : stretch / 1.5e-3;
    return probe;
}

/** The force stays and the stiffness doubles: half of the energy is lost (ADR 0004); twice the
 * stiffness is four times the overlap. */
static void a_growing_stiffness_loses_half_when_it_doubles(void **state)
{
    (void)state;
    law_probe probe = stretched(2e-6, 1e-7, CLOD_ROLLING_EPSD2);
    const double stored = 0.5 * 1.5 * 4.75e8 * sqrt(2e-6) * 1e-14;
    const clod_law_dissipation dissipated = press(&probe, 2e-6, 8e-6);
    check_relative(dissipated.friction, 0.5 * stored, 1e-9);
    check_relative(dissipated.rolling, 0.5 * stored, 1e-9); // k_r = k_t R*^2
    check_close(dissipated.lag, 0.0, 1e-12 * stored);
}

/** The spring stays and the stiffness halves: so does its energy. */
static void a_shrinking_stiffness_loses_half_when_it_halves(void **state)
{
    (void)state;
    law_probe probe = stretched(8e-6, 1e-7, CLOD_ROLLING_EPSD2);
    const double stored = 0.5 * 1.5 * 4.75e8 * sqrt(8e-6) * 1e-14;
    const clod_law_dissipation dissipated = press(&probe, 8e-6, 2e-6);
    check_relative(dissipated.friction, 0.5 * stored, 1e-9);
    check_relative(dissipated.rolling, 0.5 * stored, 1e-9);
    check_close(dissipated.lag, 0.0, 1e-12 * stored);
}

/** What springs hold when their contact opens is lost. */
static void an_opening_contact_loses_its_springs(void **state)
{
    (void)state;
    law_probe probe = stretched(8e-6, 1e-7, CLOD_ROLLING_EPSD2);
    const double stored = 0.5 * 1.5 * 4.75e8 * sqrt(8e-6) * 1e-14;
    const clod_law_dissipation dissipated = press(&probe, 8e-6, -1e-6);
    check_relative(dissipated.friction, stored, 1e-9);
    check_relative(dissipated.rolling, stored, 1e-9);
}

/** hooke: the limit halves with the overlap while nothing slips, and with the spring at its
 * limit three quarters of its energy are lost. */
static void a_falling_limit_loses_three_quarters_when_it_halves(void **state)
{
    (void)state;
    clod_case_contact c = contact_elastic(1.0, 1e6);
    c.friction = 0.5;
    c.coulomb = CLOD_COULOMB_FORCE;
    law_probe probe = probe_make(&c);
    press(&probe, 8e-6, 8e-6);
    probe.history.spring[1][0] = 0.5 * 8e-6; // mu N/k_t
    const double stored = 0.5 * 1e6 * 16e-12;
    const clod_law_dissipation dissipated = press(&probe, 8e-6, 4e-6);
    check_relative(dissipated.friction, 0.75 * stored, 1e-9);
    check_close(dissipated.lag, 0.0, 1e-12 * stored);
}

/** Slip turned by a right angle: k (1 + cos) (|xi + s| - |xi|) |xi|/2 is taken and k |xi| times
 * the shortening lost; what differs is (1 - cos) of it. */
static void a_turning_slide_loses_what_the_spring_is_shortened_by(void **state)
{
    (void)state;
    clod_case_contact c = contact_elastic(1.0, 1e6);
    c.friction = 0.5;
    c.coulomb = CLOD_COULOMB_FORCE;
    law_probe probe = probe_make(&c);
    press(&probe, 8e-6, 8e-6);
    const double spring = 0.5 * 8e-6;
    const double slip = 1e-6;
    probe.history.spring[1][0] = spring;
    clod_law_motion m = probe_motion(8e-6);
    m.velocity.z = slip / DT;
    const double beyond = hypot(spring, slip) - spring;
    const clod_law_dissipation dissipated = ledger_step(&probe, &m, &m);
    check_relative(dissipated.friction, 1e6 * spring * beyond, 1e-9);
    const double cosine = spring / hypot(spring, slip);
    check_relative(dissipated.lag, -0.5 * (1.0 - cosine) * 1e6 * spring * beyond, 1e-6);
}

// ---- dash-pots

/** The velocity turns about within a step: the dash-pots lose gamma v^2 dt with that of the
 * step, and the rest is lag. */
static void a_reversal_loses_by_the_velocity_of_the_step(void **state)
{
    (void)state;
    clod_case_contact c = contact_elastic(1.0, 1e6);
    c.restitution = 0.4;
    c.friction = 1e3; // sticks
    law_probe probe = probe_make(&c);
    clod_law_motion before = probe_motion(4e-6);
    probe.history.tangent[0] = 1e6;
    clod_law_motion now = before;
    before.velocity = (vreal3){-0.03, -0.05, 0.0};
    now.velocity = (vreal3){0.01, 0.02, 0.0};
    const double gamma = probe.law.damping * sqrt(now.m_star * 1e6); // k_t = k_n here
    const clod_law_dissipation dissipated = ledger_step(&probe, &before, &now);
    check_relative(dissipated.dash_pot, gamma * (1e-4 + 4e-4) * DT, 1e-9);
    check_relative(dissipated.lag, 0.5 * gamma * (-0.04 * 0.01 - 0.07 * 0.02) * DT, 1e-6);
    check_close(dissipated.friction, 0.0, 1e-9 * dissipated.dash_pot);
}

/** At the limit spring and dash-pot share the cut force: what is not the spring's is lost by
 * the dash-pot, and the spring goes on. */
static void a_cut_force_is_shared_by_spring_and_dash_pot(void **state)
{
    (void)state;
    clod_case_contact c = contact_elastic(1.0, 1e6);
    c.restitution = 0.1;
    c.friction = 0.1;
    c.coulomb = CLOD_COULOMB_FORCE;
    law_probe probe = probe_make(&c);
    clod_law_motion m = probe_motion(4e-6);
    press(&probe, 4e-6, 4e-6);
    const double limit = 0.1 * 4.0;
    m.velocity.y = 1.0;
    assert_true(probe.law.damping * sqrt(m.m_star * 1e6) > limit); // gamma v is beyond it
    const double way = DT;
    const clod_law_dissipation dissipated = ledger_step(&probe, &m, &m);
    check_relative(dissipated.dash_pot, 0.5 * (limit + limit - 1e6 * way) * way, 1e-9);
    check_close(dissipated.friction, 0.0, 1e-12 * limit * way);
    check_relative(probe.history.spring[1][0], way, 1e-12);
}

/** cdt while the rolling turns about: cap times angle of the step, and no less. */
static void cdt_loses_by_the_rolling_of_the_step(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.rolling = CLOD_ROLLING_CDT;
    law_probe probe = probe_make(&c);
    press(&probe, 4e-6, 4e-6);
    clod_law_motion before = probe_motion(4e-6);
    clod_law_motion now = before;
    before.spin_i.y = -5.0;
    now.spin_i.y = 5.0;
    const double taken = 0.3 * (3.8 + 2.848) * 1.5e-3 * 5.0 * DT; // as in test_law_energy.c
    const clod_law_dissipation dissipated = ledger_step(&probe, &before, &now);
    check_relative(dissipated.rolling, taken, 1e-9);
    check_relative(dissipated.lag, -taken, 1e-6); // the torque of then pushed
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loading_across_the_kink_loses_the_trapezium),
        cmocka_unit_test(unloading_across_the_kink_loses_the_trapezium),
        cmocka_unit_test(the_pull_off_line_of_the_patch_loses_nothing_before_it_is_met),
        cmocka_unit_test(luding_loads_with_the_loss_of_its_branch),
        cmocka_unit_test(luding_loses_no_more_beyond_its_largest_history),
        cmocka_unit_test(a_growing_stiffness_loses_half_when_it_doubles),
        cmocka_unit_test(a_shrinking_stiffness_loses_half_when_it_halves),
        cmocka_unit_test(an_opening_contact_loses_its_springs),
        cmocka_unit_test(a_falling_limit_loses_three_quarters_when_it_halves),
        cmocka_unit_test(a_turning_slide_loses_what_the_spring_is_shortened_by),
        cmocka_unit_test(a_reversal_loses_by_the_velocity_of_the_step),
        cmocka_unit_test(a_cut_force_is_shared_by_spring_and_dash_pot),
        cmocka_unit_test(cdt_loses_by_the_rolling_of_the_step),
        cmocka_unit_test(no_loss_is_below_zero_in_any_step), // the longest
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
