// Rolling resistance: closed forms of cdt, epsd and epsd2 (docs/theory/rolling.md).

#include "support/law_probe.h"

#define DT 1e-6
#define OVERLAP 4e-6
#define R_STAR 1.5e-3

// At 4 um on the virgin branch: f = 4.75e8 8e-9 = 3.8 N, k_adh d^n = 3.56e8 8e-9 = 2.848 N,
// dk = 1.425e6 N/m.
#define FORCE 3.8
#define ADHESIVE (3.8 + 2.848)
#define TANGENT 1.425e6

static law_probe rolling_probe(clod_rolling rolling)
{
    clod_case_contact contact = contact_ore();
    contact.rolling = (int)rolling;
    contact.rolling_damping = 0.5;
    return probe_make(&contact);
}

/** One step of rolling at a rate about y (i against j), half of it by each grain. */
static clod_law_result roll_on(law_probe *probe, double rate)
{
    clod_law_motion m = probe_motion(OVERLAP);
    m.spin_i.y = 0.5 * rate;
    m.spin_j.y = -0.5 * rate; // equal arms: no slip
    return probe_step(probe, &m, DT);
}

static void none_does_nothing(void **state)
{
    (void)state;
    law_probe probe = rolling_probe(CLOD_ROLLING_NONE);
    const clod_law_result r = roll_on(&probe, 100.0);
    check_close(r.roll.x, 0.0, 0.0);
    check_close(r.roll.y, 0.0, 0.0);
    check_close(r.roll.z, 0.0, 0.0);
    check_close(probe.history.roll[1][0], 0.0, 0.0);
}

/** M = -mu_r N R* w/|w|, whatever the rate; nothing at rest. */
static void cdt_is_constant(void **state)
{
    (void)state;
    law_probe probe = rolling_probe(CLOD_ROLLING_CDT);
    const double cap = 0.3 * ADHESIVE * R_STAR;
    check_relative(roll_on(&probe, 100.0).roll.y, -cap, 1e-12);
    check_relative(roll_on(&probe, 1e-6).roll.y, -cap, 1e-12);
    check_relative(roll_on(&probe, -3.0).roll.y, cap, 1e-12);
    check_close(roll_on(&probe, 0.0).roll.y, 0.0, 0.0);
}

/** N is the measure of the Coulomb limit chosen. */
static void the_cap_takes_the_chosen_normal_measure(void **state)
{
    (void)state;
    const double measure[] = {ADHESIVE, FORCE, FORCE};
    for (int k = 0; k < 3; k++) {
        clod_case_contact contact = contact_ore();
        contact.coulomb = k; // adhesive, force, paper
        contact.rolling = CLOD_ROLLING_CDT;
        law_probe probe = probe_make(&contact);
        check_relative(roll_on(&probe, 5.0).roll.y, -0.3 * measure[k] * R_STAR, 1e-12);
    }
}

/** k_r = k_t R*^2 up to mu_r R* N, then constant; the spring is reset; no dash-pot. */
static void epsd2_is_a_spring_with_a_cap(void **state)
{
    (void)state;
    law_probe probe = rolling_probe(CLOD_ROLLING_EPSD2);
    const double k_r = TANGENT * R_STAR * R_STAR;
    const double cap = 0.3 * ADHESIVE * R_STAR;
    check_relative(roll_on(&probe, 100.0).roll.y, -k_r * 1e-4, 1e-12);
    check_relative(roll_on(&probe, 200.0).roll.y, -k_r * 3e-4, 1e-12);
    check_relative(roll_on(&probe, 0.0).roll.y, -k_r * 3e-4, 1e-12); // holds at rest
    check_relative(roll_on(&probe, 5000.0).roll.y, -cap, 1e-12);
    check_relative(probe.history.roll[1][0], cap / k_r, 1e-12);
    check_relative(roll_on(&probe, -100.0).roll.y, -cap + k_r * 1e-4, 1e-12);
}

static void epsd2_follows_a_literal_stiffness(void **state)
{
    (void)state;
    clod_case_contact contact = contact_ore();
    contact.tangential = CLOD_TANGENTIAL_LITERAL;
    law_probe probe = probe_make(&contact);
    check_relative(roll_on(&probe, 1.0).roll.y, -4.75e8 * R_STAR * R_STAR * 1e-6, 1e-12);
}

/** k_r = 2.25 k_n mu_r^2 R*^2 with a dash-pot 2 eta sqrt(I_r k_r); their sum has the cap. */
static void epsd_is_a_spring_with_a_dash_pot_within_the_cap(void **state)
{
    (void)state;
    law_probe probe = rolling_probe(CLOD_ROLLING_EPSD);
    const double k_r = 2.25 * 0.09 * TANGENT * R_STAR * R_STAR;
    const double inertia = 0.5 * (1.4 * 1e-3 * 9e-6); // as in probe_motion
    const double c_r = 2.0 * 0.5 * sqrt(inertia * k_r);
    const double cap = 0.3 * ADHESIVE * R_STAR;
    check_relative(roll_on(&probe, 10.0).roll.y, -k_r * 1e-5 - c_r * 10.0, 1e-12);
    check_relative(roll_on(&probe, 20.0).roll.y, -k_r * 3e-5 - c_r * 20.0, 1e-12);
    check_relative(roll_on(&probe, 20000.0).roll.y, -cap, 1e-12);
    check_relative(probe.history.roll[1][0], cap / k_r, 1e-12);
    check_relative(roll_on(&probe, -10.0).roll.y, -cap + k_r * 1e-5 + c_r * 10.0, 1e-12);
}

/** epsd's dash-pot alone beyond the cap: the spring has the angle of the step and no more. */
static void a_dash_pot_beyond_the_cap_does_not_load_the_spring(void **state)
{
    (void)state;
    law_probe probe = rolling_probe(CLOD_ROLLING_EPSD);
    clod_law_motion m = probe_motion(OVERLAP);
    m.spin_i.y = 500.0; // c_r w = 0.04 N m, the cap is 0.003
    m.spin_j.y = -500.0;
    check_relative(probe_step(&probe, &m, 1e-9).roll.y, -0.3 * ADHESIVE * R_STAR, 1e-12);
    check_relative(probe.history.roll[1][0], 1e-6, 1e-12);
}

/** Twist about the normal is not rolling. */
static void twist_meets_no_resistance(void **state)
{
    (void)state;
    const clod_rolling kinds[] = {CLOD_ROLLING_CDT, CLOD_ROLLING_EPSD, CLOD_ROLLING_EPSD2};
    for (int k = 0; k < 3; k++) {
        law_probe probe = rolling_probe(kinds[k]);
        clod_law_motion m = probe_motion(OVERLAP);
        m.spin_i.x = 50.0;
        m.spin_j.x = -30.0;
        const clod_law_result r = probe_step(&probe, &m, DT);
        check_close(r.roll.x, 0.0, 0.0);
        check_close(r.roll.y, 0.0, 0.0);
        check_close(r.force.y, 0.0, 0.0);
    }
}

/** A growing k_r keeps the torque, a shrinking one lowers it in proportion. */
static void torque_never_rises_with_the_stiffness(void **state)
{
    (void)state;
    const clod_rolling kinds[] = {CLOD_ROLLING_EPSD, CLOD_ROLLING_EPSD2};
    for (int k = 0; k < 2; k++) {
        clod_case_contact contact = contact_ore();
        contact.rolling = (int)kinds[k];
        law_probe probe = probe_make(&contact);
        const double torque = roll_on(&probe, 20.0).roll.y;
        clod_law_motion m = probe_motion(4.0 * OVERLAP); // dk doubles
        check_relative(probe_step(&probe, &m, DT).roll.y, torque, 1e-12);
        m = probe_motion(3.9 * OVERLAP);
        const double lower = probe_step(&probe, &m, DT).roll.y;
        check_relative(lower, torque * sqrt(3.9 / 4.0), 1e-12);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(none_does_nothing),
        cmocka_unit_test(cdt_is_constant),
        cmocka_unit_test(the_cap_takes_the_chosen_normal_measure),
        cmocka_unit_test(epsd2_is_a_spring_with_a_cap),
        cmocka_unit_test(epsd2_follows_a_literal_stiffness),
        cmocka_unit_test(epsd_is_a_spring_with_a_dash_pot_within_the_cap),
        cmocka_unit_test(a_dash_pot_beyond_the_cap_does_not_load_the_spring),
        cmocka_unit_test(twist_meets_no_resistance),
        cmocka_unit_test(torque_never_rises_with_the_stiffness),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
