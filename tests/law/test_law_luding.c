// Luding's law (2008): its branches by hand, MercuryDPM's published collisions, and its limits.

#include "law/law_kinds.h"
#include "support/law_probe.h"

/**
 * k1 100, k2 500, k_adh 100 N/m, phi_f 0.05 between grains of R 0.5 m (R* 0.25 m), as in
 * MercuryDPM's PlasticForceUnitTest. By hand: d* = 500/400 0.05 2 0.25 = 0.03125 m, so that
 * k2 - k1 of a contact is 400 d_max/d* = 12800 d_max; d0 of the limit branch = 0.025 m.
 */
static clod_case_contact contact_luding(void)
{
    return (clod_case_contact){.law = CLOD_LAW_LUDING,
                               .exponent = 1.0,
                               .k1 = 100.0,
                               .k2 = 500.0,
                               .k_adh = 100.0,
                               .plasticity_depth = 0.05,
                               .restitution = 1.0,
                               .tangential_ratio = 1.0};
}

#define FLOW 0.03125

/** Force on a grain of R 0.5 m and 1 kg at rest against its twin. */
static double press(law_probe *probe, double overlap)
{
    const clod_law_motion motion = {.overlap = overlap,
                                    .normal = {1.0, 0.0, 0.0},
                                    .arm_i = 0.5 - 0.5 * overlap,
                                    .arm_j = 0.5 - 0.5 * overlap,
                                    .m_star = 0.5,
                                    .r_star = 0.25};
    return probe_step(probe, &motion, 0.0).force.x;
}

typedef struct point {
    double overlap, force;
} point;

/** One step for each point of a path. */
static void follow(const clod_case_contact *contact, const point *path, int count)
{
    law_probe probe = {.law = clod_law_make(contact, &ORE, &ORE)};
    for (int k = 0; k < count; k++) {
        check_close(press(&probe, path[k].overlap), path[k].force, 1e-13);
    }
}

/** Below d*: d_max 0.01 gives k2 = 228, f = 1 - 228 (0.01 - d); on k1 again beyond 0.01. */
static void a_light_contact_unloads_on_its_own_line(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    const point path[] = {{0.005, 0.5},   {0.01, 1.0},          {0.008, 0.544},
                          {0.009, 0.772}, {0.006, 0.088},       {0.01, 1.0},
                          {0.02, 2.0},    {0.019, 2.0 - 0.356}, {0.03125, 3.125}};
    follow(&contact, path, 9);
}

/** By hand: k2 of a contact is 100 + 12800 d_max, and 500 from d* on; so falls the force. */
static void a_contact_is_unloaded_with_its_own_k2(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    const double deepest[] = {0.01, 0.02, FLOW, 0.04};
    const double by_hand[] = {228.0, 356.0, 500.0, 500.0};
    for (int k = 0; k < 4; k++) {
        law_probe probe = {.law = clod_law_make(&contact, &ORE, &ORE)};
        const double before = press(&probe, deepest[k]);
        const double after = press(&probe, deepest[k] - 1e-4);
        check_close((before - after) / 1e-4, by_hand[k], 1e-8);
        const double told =
            clod_law_kinds_row(CLOD_LAW_LUDING)
                ->unloading(&probe.law, deepest[k], 0.25, probe.history.plastic[0]);
        check_close(told, by_hand[k], 1e-9);
    }
}

/** Beyond d*: f = 500 (d - 0.025), up and down the same line, whatever the largest overlap. */
static void a_heavy_contact_has_the_limit_branch(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    const point path[] = {{0.05, 12.5},  {0.04, 7.5},      {0.06, 17.5}, {0.025, 0.0},
                          {0.024, -0.5}, {0.03125, 3.125}, {0.05, 12.5}};
    follow(&contact, path, 7);
}

/**
 * From the limit branch to 0.02: f = -100 0.02, d_max = (500 + 100)/400 0.02 = 0.03, and so
 * k2 = 100 + 12800 0.03 = 484: reloaded to 0.025, 3 - 484 0.005; to k1 at 0.03. Down to 0.01:
 * k2 484 makes it (484 + 100)/384 0.01 = 0.73/48, k2 = 100 + 12800 0.73/48 = 884/3, and at
 * 0.012 f = 73/48 - 884/3 (0.73/48 - 0.012); without the past at last: 0.005 is virgin.
 */
static void the_adhesive_branch_forgets(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    const double most = 0.73 / 48.0;
    const point path[] = {{0.05, 12.5},  {0.02, -2.0},
                          {0.025, 0.58}, {0.03, 3.0},
                          {0.01, -1.0},  {0.012, 100.0 * most - 884.0 / 3.0 * (most - 0.012)},
                          {0.02, 2.0},   {-0.001, 0.0},
                          {0.005, 0.5},  {0.004, 0.5 - 164.0 * 0.001}};
    follow(&contact, path, 10);
}

/** d_min = (k2 - k1) d_max/(k2 + k_adh): 128 0.01/328; 0.1 % to both sides the pull is less. */
static void the_largest_pull_is_where_the_lines_meet(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    const double least = 1.28 / 328.0;
    const point path[] = {{0.01, 1.0},
                          {1.001 * least, -100.0 * least + 0.001 * 228.0 * least},
                          {least, -100.0 * least},
                          {0.999 * least, -99.9 * least}};
    follow(&contact, path, 4);
}

/** Without adhesion the force is never below zero, and at d0 the contact is as if new there. */
static void a_dry_contact_does_not_pull(void **state)
{
    (void)state;
    clod_case_contact contact = contact_luding();
    contact.k_adh = 0.0;
    // 0.004 < d0 = 1.28/228: d_max = 228/128 0.004 = 0.007125, k2 = 191.2
    const point path[] = {
        {0.01, 1.0}, {0.004, 0.0}, {0.005, 0.7125 - 191.2 * 0.002125}, {0.02, 2.0}};
    follow(&contact, path, 4);
}

/**
 * On the adhesive branch in small steps d_max follows d_max = (k2 + k_adh)/(k2 - k1) d with its
 * own k2: d_max^2 - d d_max - (k1 + k_adh)/12800 d = 0.
 */
static void small_steps_forget_along_a_curve(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    law_probe probe = {.law = clod_law_make(&contact, &ORE, &ORE)};
    press(&probe, FLOW);
    for (int s = 21000; s >= 2000; s--) { // d_min is 0.0208
        const double d = 1e-6 * s;
        press(&probe, d);
        if (s <= 20000 && s % 1000 == 0) {
            const double most = 0.5 * (d + sqrt(d * d + 4.0 * 200.0 / 12800.0 * d));
            check_relative(probe.history.plastic[0], most, 2e-4);
        }
    }
}

/** At a wall R* is R: d* = 500/400 0.05 2 0.5 = 0.0625 m. */
static void a_larger_r_star_flows_later(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    law_probe probe = {.law = clod_law_make(&contact, &ORE, &ORE)};
    clod_law_motion motion = {
        .overlap = 0.0625, .normal = {1.0, 0.0, 0.0}, .m_star = 1.0, .r_star = 0.5};
    check_close(probe_step(&probe, &motion, 0.0).force.x, 6.25, 1e-13);
    motion.overlap = 0.0725;
    check_close(probe_step(&probe, &motion, 0.0).force.x, 11.25, 1e-13);
    motion.overlap = 0.05;
    check_close(probe_step(&probe, &motion, 0.0).force.x, 0.0, 1e-13);
}

/** Pressed to d* or more and once pulled apart, the law is mepa with n = 1 and k2. */
static void one_cycle_from_the_limit_is_mepa(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    clod_case_contact other = contact;
    other.law = CLOD_LAW_MEPA;
    law_probe luding = {.law = clod_law_make(&contact, &ORE, &ORE)};
    law_probe mepa = {.law = clod_law_make(&other, &ORE, &ORE)};
    check_close(press(&luding, FLOW), press(&mepa, FLOW), 1e-13);
    for (int s = 312; s >= 0; s--) {
        const double d = 1e-4 * s;
        check_close(press(&luding, d), press(&mepa, d), 1e-13);
    }
}

/** phi_f -> 0: k2 from the first touch, elastic; phi_f large: k1 for ever, elastic too. */
static void the_depth_leads_from_k2_to_k1(void **state)
{
    (void)state;
    clod_case_contact contact = contact_luding();
    const double stiffness[] = {500.0, 100.0};
    for (int k = 0; k < 2; k++) {
        contact.plasticity_depth = k == 0 ? 1e-14 : 1e12;
        law_probe probe = {.law = clod_law_make(&contact, &ORE, &ORE)};
        const double path[] = {0.01, 0.005, 0.02, 0.001};
        for (int s = 0; s < 4; s++) {
            check_relative(press(&probe, path[s]), stiffness[k] * path[s], 1e-9);
        }
    }
}

/** Coulomb's limit: mu (f + k_adh d), 0.5 (2.5 + 3) at 0.03 on the limit branch. */
static void friction_counts_from_the_pull_off_line(void **state)
{
    (void)state;
    clod_case_contact contact = contact_luding();
    contact.friction = 0.5;
    const struct {
        clod_coulomb coulomb;
        double overlap, limit;
    } row[] = {{CLOD_COULOMB_ADHESIVE, 0.03, 2.75}, {CLOD_COULOMB_ADHESIVE, 0.02, 0.0},
               {CLOD_COULOMB_FORCE, 0.02, 1.0},     {CLOD_COULOMB_FORCE, 0.03, 1.25},
               {CLOD_COULOMB_PAPER, 0.02, 0.0},     {CLOD_COULOMB_PAPER, 0.03, 1.25}};
    for (int k = 0; k < 6; k++) {
        contact.coulomb = (int)row[k].coulomb;
        law_probe probe = {.law = clod_law_make(&contact, &ORE, &ORE)};
        press(&probe, 0.05);
        const clod_law_motion motion = {.overlap = row[k].overlap,
                                        .normal = {1.0, 0.0, 0.0},
                                        .velocity = {0.0, 1.0, 0.0},
                                        .m_star = 0.5,
                                        .r_star = 0.25};
        check_close(probe_step(&probe, &motion, 1.0).force.y, -row[k].limit, 1e-12);
    }
}

/** Filling with less adhesion: k_adh counts in the branch and in what is forgotten. */
static void adhesion_is_a_fraction_of_its_final_value(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    law_probe probe = {.law = clod_law_make(&contact, &ORE, &ORE)};
    clod_law_set_adhesion(&probe.law, 0.5);
    press(&probe, 0.05);
    check_close(press(&probe, 0.02), -1.0, 1e-13);
    check_close(probe.history.plastic[0], 550.0 / 400.0 * 0.02, 1e-15);
}

/** Velocity Verlet of two grains that meet; place and speed of the left one after 100 steps. */
static void collide(double chi, double *place, double *speed)
{
    const clod_case_contact contact = contact_luding();
    law_probe probe = {.law = clod_law_make(&contact, &ORE, &ORE)};
    const double dt = 2.0 * 0.02 * M_PI / sqrt(500.0 / 0.5);
    double x[2] = {1.0, 2.0};
    double v[2] = {0.5 * chi * FLOW * sqrt(200.0), -0.5 * chi * FLOW * sqrt(200.0)};
    double force = 0.0; // they just touch
    for (int step = 0; step < 100; step++) {
        for (int g = 0; g < 2; g++) { // the force pushes the left grain to the left
            v[g] += 0.5 * dt * (g == 0 ? -force : force);
            x[g] += dt * v[g];
        }
        force = press(&probe, 1.0 - (x[1] - x[0]));
        for (int g = 0; g < 2; g++) {
            v[g] += 0.5 * dt * (g == 0 ? -force : force);
        }
    }
    *place = x[0];
    *speed = v[0];
}

/**
 * MercuryDPM, Drivers/UnitTests/PlasticForceUnitTest.cpp (Luding 2008): two grains of R 0.5 m
 * and 1 kg, relative speed chi sqrt(2 k1) d*. The numbers and their tolerance are that file's:
 * rebound, sticking on k2 < k2max, sticking on the limit branch, rebound from it.
 */
static void collisions_are_those_of_mercury_dpm(void **state)
{
    (void)state;
    const struct {
        double chi, place, speed;
    } published[] = {{0.34, 0.995546292935715, -0.032721738352012},
                     {0.69, 1.00695193269955, -0.0138683231953154},
                     {1.1, 1.00840467123501, -0.0204655358555405},
                     {1.37, 0.969386085767181, -0.163049415300304}};
    for (int k = 0; k < 4; k++) {
        double place, speed;
        collide(published[k].chi, &place, &speed);
        check_close(place, published[k].place, 1e-10);
        check_close(speed, published[k].speed, 1e-10);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_light_contact_unloads_on_its_own_line),
        cmocka_unit_test(a_contact_is_unloaded_with_its_own_k2),
        cmocka_unit_test(a_heavy_contact_has_the_limit_branch),
        cmocka_unit_test(the_adhesive_branch_forgets),
        cmocka_unit_test(the_largest_pull_is_where_the_lines_meet),
        cmocka_unit_test(a_dry_contact_does_not_pull),
        cmocka_unit_test(small_steps_forget_along_a_curve),
        cmocka_unit_test(a_larger_r_star_flows_later),
        cmocka_unit_test(one_cycle_from_the_limit_is_mepa),
        cmocka_unit_test(the_depth_leads_from_k2_to_k1),
        cmocka_unit_test(friction_counts_from_the_pull_off_line),
        cmocka_unit_test(adhesion_is_a_fraction_of_its_final_value),
        cmocka_unit_test(collisions_are_those_of_mercury_dpm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
