// The energy ledger closes: what is there, came in and was lost make one sum, up to the error
// of velocity Verlet, which falls with the square of the time step; and it changes nothing.

#include <stdlib.h>

#include "support/bed.h"
#include "support/bits.h"
#include "support/sanitized.h"

#define DT 1e-6

typedef struct outcome {
    double residual; ///< J
    double lost;     ///< J
    clod_ledger ledger;
} outcome;

static outcome close_books(scene *s)
{
    const clod_energies now = clod_step_energies(&s->step);
    const clod_ledger *l = &s->state.ledger;
    return (outcome){clod_ledger_residual(l, &now),
                     l->plastic + l->dash_pot + l->friction + l->rolling, *l};
}

/** 10 ms of colliding grains in a periodic box, one law for all. */
static outcome collide(const clod_case_contact *contact, double dt)
{
    scene s;
    bed_init(&s, BED_CLUSTER, 2);
    for (int l = 0; l < SCENE_LAWS; l++) {
        s.law[l] = clod_law_make(contact, &ORE, &ORE);
    }
    s.state.dt = dt;
    scene_start(&s);
    scene_open_ledger(&s);
    scene_run(&s, (int64_t)round(0.01 / dt));
    const outcome o = close_books(&s);
    scene_end(&s);
    return o;
}

/** The error of the books at dt is a few thousandths of what was lost, and a quarter at dt/2.
 */
static void check_second(const outcome *coarse, const outcome *fine)
{
    check_at_most(fabs(coarse->residual), 5e-3 * coarse->lost);
    check_at_most(fabs(fine->residual), 0.35 * fabs(coarse->residual));
}

static void check_second_order(const clod_case_contact *contact)
{
    const outcome coarse = collide(contact, DT);
    const outcome fine = collide(contact, 0.5 * DT);
    check_second(&coarse, &fine);
}

static void plasticity_and_adhesion_close(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.friction = 0.0;
    c.rolling = CLOD_ROLLING_NONE;
    check_second_order(&c);
    const outcome o = collide(&c, DT);
    assert_true(o.ledger.plastic > 0.0);
    check_close(o.ledger.friction, 0.0, 1e-12 * o.lost);
    check_close(o.ledger.rolling, 0.0, 0.0);
}

/** The other laws with a history; luding's error is of the first order. */
static void luding_and_eepa_close(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.law = CLOD_LAW_EEPA;
    c.pull_off_force = 0.05;
    check_second_order(&c);
    c.pull_off_force = 0.0;
    c.k_adh = 0.0;
    c.surface_energy = 1.0;
    check_second_order(&c);
    c.law = CLOD_LAW_LUDING;
    c.exponent = 1.0;
    c.k1 = 1e6;
    c.k2 = 5e6;
    c.k_adh = 1e6;
    c.plasticity_depth = 0.05;
    const outcome coarse = collide(&c, DT);
    const outcome fine = collide(&c, 0.5 * DT);
    check_at_most(fabs(coarse.residual), 0.05 * coarse.lost);
    check_at_most(fabs(fine.residual), 0.7 * fabs(coarse.residual));
}

static void dash_pots_close(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.friction = 0.0;
    c.rolling = CLOD_ROLLING_NONE;
    c.restitution = 0.5;
    check_second_order(&c);
}

static void friction_and_rolling_resistance_close(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.restitution = 0.5;
    check_second_order(&c); // epsd2
    c.rolling = CLOD_ROLLING_CDT;
    check_second_order(&c);
}

/** The lag is small beside the losses and of first order in the step; losses converge with it.
 */
static void the_lag_is_of_first_order(void **state)
{
    (void)state;
    clod_case_contact c = contact_ore();
    c.restitution = 0.5;
    c.rolling = CLOD_ROLLING_EPSD;
    c.rolling_damping = 0.3;
    const outcome coarse = collide(&c, DT);
    const outcome fine = collide(&c, 0.5 * DT);
    check_at_most(fabs(coarse.ledger.lag), 0.05 * coarse.lost);
    check_at_most(fabs(fine.ledger.lag), 0.6 * fabs(coarse.ledger.lag));
    assert_true(fine.ledger.lag != 0.0);
    check_second(&coarse, &fine); // the residual does not see it
}

/** No law loses where there is nothing to lose: the drift of Verlet alone, and it is small. */
static void elastic_grains_lose_nothing(void **state)
{
    (void)state;
    const clod_case_contact c = contact_elastic(1.5, 1e9);
    const outcome o = collide(&c, DT);
    check_close(o.lost, 0.0, 1e-12 * o.ledger.start);
    check_close(o.residual, 0.0, 1e-4 * o.ledger.start);
}

/** Six laws at once, with turning, moving, loaded, shaking and belt walls. */
static void beds_with_walls_close(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene s;
        bed_init(&s, (bed_kind)kind, 2);
        scene_start(&s);
        scene_open_ledger(&s);
        scene_run(&s, 10000);
        const outcome o = close_books(&s);
        assert_true(o.ledger.plastic > 0.0 && o.ledger.dash_pot > 0.0 &&
                    o.ledger.friction > 0.0 && o.ledger.rolling > 0.0);
        assert_true(kind == BED_CLUSTER || fabs(o.ledger.wall_work) > 1e-3);
        check_at_most(fabs(o.residual), 1e-2 * o.lost);
        scene_end(&s);
    }
}

/** A floor that begins to rise throws its grain up to its speed v: m v^2, and lifts it: m g h.
 */
static void a_lifted_grain_takes_momentum_and_weight(void **state)
{
    (void)state;
    const double speed = 0.01;
    const double time = 200000 * DT;
    scene s;
    clod_case_contact c = contact_elastic(1.5, 1e8);
    c.restitution = 0.1;
    scene_init(&s, DT, &c);
    s.state.gravity[2] = -9.81;
    const size_t g = scene_grain(&s, 0.0, 0.0, 3e-3, 3e-3);
    const double mass = s.state.grains.velocity[g][3];
    clod_wall *floor = scene_wall(&s, "floor", shape_floor(0.0));
    scene_start(&s);
    scene_open_ledger(&s);
    scene_run(&s, 20000); // comes to rest
    floor->velocity.z = speed;
    scene_run(&s, 200000);
    check_relative(s.state.ledger.wall_work, mass * speed * (speed + 9.81 * time), 1e-5);
    scene_end(&s);
}

/** With the ledger grains, walls and contacts have the very bits they have without. */
static void the_ledger_changes_no_bit(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        clod_status status = {0};
        scene with, without;
        bed_init(&with, (bed_kind)kind, 3);
        bed_init(&without, (bed_kind)kind, 3);
        scene_start(&with);
        scene_start(&without);
        scene_open_ledger(&with);
        scene_run(&with, 3000);
        scene_run(&without, 3000);
        assert_true(clod_step_export(&with.step, &status));
        assert_true(clod_step_export(&without.step, &status));
        without.state.ledger = with.state.ledger; // the only thing that differs
        check_same_bits(&with.state, &without.state);
        scene_end(&with);
        scene_end(&without);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plasticity_and_adhesion_close),
        cmocka_unit_test(luding_and_eepa_close),
        cmocka_unit_test(dash_pots_close),
        cmocka_unit_test(friction_and_rolling_resistance_close),
        cmocka_unit_test(the_lag_is_of_first_order),
        cmocka_unit_test(elastic_grains_lose_nothing),
        cmocka_unit_test(beds_with_walls_close),
        cmocka_unit_test(a_lifted_grain_takes_momentum_and_weight),
        cmocka_unit_test(the_ledger_changes_no_bit),
    };
    if (sanitized()) {
        cmocka_set_skip_filter("*_close"); // their sums; the same code runs in the others
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
