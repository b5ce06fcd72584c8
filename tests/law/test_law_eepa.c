// EEPA: mepa with a constant pull, and with a pull from surface energy and contact patch.

#include "support/dice.h"
#include "support/law_probe.h"

#define R_STAR 1.5e-3 // of probe_motion
#define MICRON 1e-6

static clod_case_contact contact_eepa(double pull_off_force)
{
    clod_case_contact contact = contact_ore();
    contact.law = CLOD_LAW_EEPA;
    contact.pull_off_force = pull_off_force;
    return contact;
}

/**
 * k1 = k2/4, no k_adh, and the surface energy with which a plastic overlap of dp has the pull
 * F = 3/2 pi gamma sqrt(2 R* dp).
 */
static clod_case_contact contact_patch(double exponent, double k2, double dp, double pull)
{
    clod_case_contact contact = contact_eepa(0.0);
    contact.exponent = exponent;
    contact.k1 = 0.25 * k2;
    contact.k2 = k2;
    contact.k_adh = 0.0;
    contact.surface_energy = pull / (1.5 * M_PI * sqrt(2.0 * R_STAR * dp));
    return contact;
}

/** The check values of docs/theory/mepa.md (5 %, n = 3/2) with -0.05 N on all branches. */
static void a_constant_pull_comes_on_top(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_eepa(0.05);
    law_probe probe = probe_make(&contact);
    const struct {
        double overlap, force; ///< um, N
    } row[] = {{0.75, 0.308522}, {1.50, 0.872631},  {3.00, 2.468172},  {2.85, 1.556200},
               {2.70, 0.667921}, {2.10, -1.083375}, {1.80, -0.859723}, {2.10, 0.629195}};
    for (int k = 0; k < 8; k++) {
        const double expected = row[k].force - 0.05; // at 2.1: -3.56e8 (2.1e-6)^1.5
        check_close(probe_press(&probe, row[k].overlap * MICRON), expected, 0.51e-6);
    }
}

/** f0 is there from the first touch to the last, and gone at d = 0. */
static void the_constant_pull_jumps_at_the_touch(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_eepa(0.05);
    law_probe probe = probe_make(&contact);
    check_close(probe_press(&probe, 0.0), 0.0, 0.0);
    check_close(probe_press(&probe, 1e-14), -0.05, 1e-11);
    probe_press(&probe, 3.0 * MICRON);
    check_close(probe_press(&probe, 1e-14), -0.05, 1e-11);
    check_close(probe_press(&probe, -1e-14), 0.0, 0.0);
    check_relative(probe_press(&probe, 1.0 * MICRON), 0.475 - 0.05, 1e-12); // forgotten
}

/** pull_off_force 0 and no surface energy: the bits of mepa, friction and history too. */
static void without_its_pulls_it_is_mepa_to_the_bit(void **state)
{
    (void)state;
    dice roll = {3};
    const double exponent[] = {1.0, 1.2, 1.5, 2.0};
    for (int path = 0; path < 200; path++) {
        clod_case_contact contact = contact_eepa(0.0);
        contact.exponent = exponent[path % 4];
        contact.coulomb = path % 3;
        contact.restitution = 0.5;
        law_probe eepa = probe_make(&contact);
        contact.law = CLOD_LAW_MEPA;
        law_probe mepa = probe_make(&contact);
        double overlap = 0.0;
        for (int s = 0; s < 200; s++) {
            overlap = fmax(overlap + dice_real(&roll, -1.0, 1.0) * MICRON, -1e-7);
            clod_law_motion motion = probe_motion(overlap);
            motion.velocity = (vreal3){dice_real(&roll, -1e-2, 1e-2), 1e-2, -2e-2};
            motion.spin_i = (vreal3){1.0, dice_real(&roll, -9.0, 9.0), 2.0};
            const clod_law_result a = probe_step(&eepa, &motion, 1e-6);
            const clod_law_result b = probe_step(&mepa, &motion, 1e-6);
            assert_memory_equal(&a.force, &b.force, sizeof a.force);
            assert_memory_equal(&a.lever, &b.lever, sizeof a.lever);
            assert_memory_equal(&a.roll, &b.roll, sizeof a.roll);
            assert_memory_equal(&eepa.history, &mepa.history, sizeof eepa.history);
        }
    }
}

typedef struct point {
    double overlap, force; ///< m, N
} point;

static void follow(const clod_case_contact *contact, const point *path, int count)
{
    law_probe probe = probe_make(contact);
    for (int k = 0; k < count; k++) {
        check_close(probe_press(&probe, path[k].overlap), path[k].force, 2e-13);
    }
}

/**
 * n = 1, k2 = 4e6 N/m, F = 2 N for dp = 3 um, that is for d_max = 4 um. By hand: largest pull
 * at dp - F/k2 = 2.5 um. Further out the patch shrinks with dp: a quarter of dp has half the
 * pull, 1 N at 0.75 - 0.25 um. From there reloading climbs k2 from dp = 0.75 um, back to k1 at
 * 1 um. Far out the pull is at most k2 dp/2: dp = 3/64 um has 2/8 N, but k2 dp/2 = 3/32 N, at
 * dp/2.
 */
static void the_pull_follows_the_patch(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_patch(1.0, 4e6, 3e-6, 2.0);
    const point path[] = {{4e-6, 4.0},    {3.5e-6, 2.0},  {2.75e-6, -1.0},
                          {2.5e-6, -2.0}, {0.5e-6, -1.0}, {0.6e-6, -0.6},
                          {1e-6, 1.0},    {1.2e-6, 1.2},  {1.5e-6 / 64.0, -3.0 / 32.0}};
    follow(&contact, path, 9);
    const point around[] = {{4e-6, 4.0}, {2.49e-6, -1.9964}};
    law_probe probe = probe_make(&contact);
    probe_press(&probe, around[0].overlap);
    check_at_least(probe_press(&probe, around[1].overlap), -2.0 + 1e-4); // the lowest point
    const clod_case_contact weak = contact_patch(1.0, 4e6, 3e-6, 1e-5);
    const point hardly[] = {{4e-6, 4.0}, {3e-6 - 2.5e-12, -1e-5}};
    follow(&weak, hardly, 2);
}

/**
 * n = 3/2, k2 = 1e9, F = 2 N for dp = 4 um, P = 8e-9: largest pull at x = 8e-9 - 2e-9. dp =
 * 2.25 um has 3/4 of the radius, 1.5 N, and P = 3.375e-9: at x = 1.875e-9. dp = 0.04 um has 0.2
 * N, but k2 P/2 = 4e-3 N, at P/2 = 4e-12.
 */
static void the_patch_with_the_exponent_of_hertz(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_patch(1.5, 1e9, 4e-6, 2.0);
    const double most = cbrt(pow(8e-9 / 0.75, 2.0));
    const point path[] = {{most, 8.0 / 3.0},
                          {4e-6, 0.0},
                          {cbrt(36e-18), -2.0},
                          {cbrt(pow(1.875e-9, 2.0)), -1.5},
                          {cbrt(16e-24), -4e-3}};
    follow(&contact, path, 5);
}

/** n = 2, k2 = 5e11: dp = 4 um, F 2 N, P 16e-12; dp = 3.24 um has 1.8 N, P 10.4976e-12. */
static void the_patch_with_any_exponent(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_patch(2.0, 5e11, 4e-6, 2.0);
    const point path[] = {
        {sqrt(16e-12 / 0.75), 8.0 / 3.0}, {sqrt(12e-12), -2.0}, {sqrt(6.8976e-12), -1.8}};
    follow(&contact, path, 3);
}

/** A contact that was never flattened has no patch: k1 = k2 is elastic but for f0. */
static void without_flattening_only_the_constant_pull_is_left(void **state)
{
    (void)state;
    clod_case_contact contact = contact_patch(1.0, 4e6, 3e-6, 2.0);
    contact.k1 = contact.k2;
    contact.pull_off_force = 0.25;
    const point path[] = {{3e-6, 11.75}, {1e-6, 3.75}, {1e-8, -0.21}};
    follow(&contact, path, 3);
}

/** Both pulls: the constant one comes on top of the patch's. */
static void both_pulls_add(void **state)
{
    (void)state;
    clod_case_contact contact = contact_patch(1.0, 4e6, 3e-6, 2.0);
    contact.pull_off_force = 0.25;
    const point path[] = {{4e-6, 3.75}, {2.5e-6, -2.25}, {0.5e-6, -1.25}};
    follow(&contact, path, 3);
}

static double friction(const clod_case_contact *contact, double before, double overlap)
{
    law_probe probe = probe_make(contact);
    probe_press(&probe, before);
    clod_law_motion motion = probe_motion(overlap);
    motion.velocity.y = -1.0;
    return probe_step(&probe, &motion, 1.0).force.y;
}

/** Thakur eq. (13): mu (f - f0 + k_adh d^n); at 1 um on k1: 4.75e8 1e-9 and 3.56e8 1e-9. */
static void friction_counts_from_the_pull_off_line(void **state)
{
    (void)state;
    clod_case_contact contact = contact_eepa(0.05);
    contact.rolling = CLOD_ROLLING_NONE;
    check_relative(friction(&contact, 0.5e-6, 1e-6), 0.35 * (0.475 + 0.356), 1e-12);
    check_close(friction(&contact, 3e-6, 1e-6), 0.0, 1e-12);
    contact.coulomb = CLOD_COULOMB_FORCE;
    check_relative(friction(&contact, 0.5e-6, 1e-6), 0.35 * 0.425, 1e-12);
    check_relative(friction(&contact, 3e-6, 1e-6), 0.35 * 0.406, 1e-12);
    contact.coulomb = CLOD_COULOMB_PAPER;
    check_relative(friction(&contact, 0.5e-6, 1e-6), 0.35 * 0.425, 1e-12);
    check_close(friction(&contact, 3e-6, 1e-6), 0.0, 0.0);
    // with a patch: at 0.5 um on k1, f = 0.5 N less f0; the pull-off line there is 1 N
    contact = contact_patch(1.0, 4e6, 3e-6, 2.0);
    contact.rolling = CLOD_ROLLING_NONE;
    contact.pull_off_force = 0.25;
    check_relative(friction(&contact, 0.4e-6, 0.5e-6), 0.35 * 1.5, 1e-11);
    check_close(friction(&contact, 4e-6, 0.5e-6), 0.0, 1e-11);
}

/** Filling with less adhesion: f0, k_adh and the surface energy all at the fraction. */
static void adhesion_is_a_fraction_of_its_final_value(void **state)
{
    (void)state;
    clod_case_contact contact = contact_eepa(0.05);
    law_probe probe = probe_make(&contact);
    clod_law_set_adhesion(&probe.law, 0.5);
    probe_press(&probe, 3.0 * MICRON);
    check_relative(probe_press(&probe, 1.0 * MICRON), -0.178 - 0.025, 1e-12);
    contact = contact_patch(1.0, 4e6, 3e-6, 4.0); // half of 4 N is as above
    probe = probe_make(&contact);
    clod_law_set_adhesion(&probe.law, 0.5);
    probe_press(&probe, 4.0 * MICRON);
    check_relative(probe_press(&probe, 2.5 * MICRON), -2.0, 1e-12);
    check_relative(probe_press(&probe, 0.5 * MICRON), -1.0, 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_constant_pull_comes_on_top),
        cmocka_unit_test(the_constant_pull_jumps_at_the_touch),
        cmocka_unit_test(without_its_pulls_it_is_mepa_to_the_bit),
        cmocka_unit_test(the_pull_follows_the_patch),
        cmocka_unit_test(the_patch_with_the_exponent_of_hertz),
        cmocka_unit_test(the_patch_with_any_exponent),
        cmocka_unit_test(without_flattening_only_the_constant_pull_is_left),
        cmocka_unit_test(both_pulls_add),
        cmocka_unit_test(friction_counts_from_the_pull_off_line),
        cmocka_unit_test(adhesion_is_a_fraction_of_its_final_value),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
