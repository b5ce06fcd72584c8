// Closed forms of one cycle, by hand and against the law itself.

#include "law/law_cycle.h"
#include "support/law_probe.h"

#define R_STAR 1.5e-3 // of probe_motion

static clod_case_contact contact_of(int law, double exponent, double k1, double k2,
                                    double k_adh)
{
    clod_case_contact contact = contact_ore();
    contact.law = law;
    contact.exponent = exponent;
    contact.k1 = k1;
    contact.k2 = k2;
    contact.k_adh = k_adh;
    return contact;
}

/** d* = 4/3 0.5e-3 2 1.5e-3 = 2 um: then f = 2 N + 4e6 (d - 2 um). */
static clod_case_contact contact_luding(void)
{
    clod_case_contact contact = contact_of(CLOD_LAW_LUDING, 1.0, 1e6, 4e6, 1e6);
    contact.plasticity_depth = 0.5e-3;
    return contact;
}

typedef struct cycle {
    double overlap, force, energy; ///< m, N, J of virgin loading
} cycle;

static void check_cycle(const clod_law *law, const cycle *expected, int count)
{
    for (int k = 0; k < count; k++) {
        const cycle *e = &expected[k];
        check_relative(clod_law_cycle_force(law, R_STAR, e->overlap), e->force, 1e-12);
        check_relative(clod_law_cycle_overlap(law, R_STAR, e->force), e->overlap, 1e-12);
        check_relative(clod_law_cycle_energy(law, R_STAR, e->overlap), e->energy, 1e-12);
        check_relative(clod_law_cycle_impact(law, R_STAR, e->energy), e->overlap, 1e-12);
    }
}

/** luding: triangles and a trapezium; 1 um: 1e6 1e-6, 1/2 um; 3 um: 2 + 4 N, 2 + 1 (2 + 6)/2
 * uJ. */
static void loading_of_luding(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_luding();
    const clod_law law = clod_law_make(&contact, &ORE, &ORE);
    const cycle expected[] = {
        {1e-6, 1.0, 0.5e-6}, {2e-6, 2.0, 2e-6}, {3e-6, 6.0, 6e-6}, {4e-6, 10.0, 14e-6}};
    check_cycle(&law, expected, 4);
}

/** eepa: k1 d^n - 0.5 N and its work; n = 3/2: 4 um 1e9 8e-9, 2/5 8 N 4 um - 0.5 N 4 um. */
static void loading_of_eepa(void **state)
{
    (void)state;
    clod_case_contact contact = contact_of(CLOD_LAW_EEPA, 1.5, 1e9, 4e9, 1e9);
    contact.pull_off_force = 0.5;
    clod_law law = clod_law_make(&contact, &ORE, &ORE);
    const cycle hertzian[] = {{4e-6, 7.5, 12.8e-6 - 2e-6}, {1e-6, 0.5, 0.4e-6 - 0.5e-6}};
    check_cycle(&law, hertzian, 1);
    check_relative(clod_law_cycle_force(&law, R_STAR, 1e-6), hertzian[1].force, 1e-12);
    check_relative(clod_law_cycle_energy(&law, R_STAR, 1e-6), hertzian[1].energy, 1e-12);
    contact = contact_of(CLOD_LAW_EEPA, 1.0, 1e6, 4e6, 1e6);
    contact.pull_off_force = 0.5;
    law = clod_law_make(&contact, &ORE, &ORE);
    const cycle linear[] = {{4e-6, 3.5, 6e-6}, {1.5e-6, 1.0, 0.375e-6}};
    check_cycle(&law, linear, 2);
    // without any speed the pull itself presses to 2 touch/k1
    check_relative(clod_law_cycle_impact(&law, R_STAR, 0.0), 1e-6, 1e-12);
    check_relative(clod_law_cycle_impact(&law, 1e-7, 0.0), 1e-6, 1e-12); // R* does not count
    contact.pull_off_force = 0.01;                                       // however weak it is
    law = clod_law_make(&contact, &ORE, &ORE);
    check_relative(clod_law_cycle_impact(&law, R_STAR, 0.0), 2e-8, 1e-12);
}

/** mepa and hertz: k1 d^n, for hertz k1 = 4/3 E* sqrt(R*), E* = 119e9/(2 (1 - 0.34^2)). */
static void loading_of_the_others(void **state)
{
    (void)state;
    clod_case_contact contact = contact_of(CLOD_LAW_MEPA, 1.5, 1e9, 4e9, 1e9);
    clod_law law = clod_law_make(&contact, &ORE, &ORE);
    const cycle mepa[] = {{4e-6, 8.0, 12.8e-6}};
    check_cycle(&law, mepa, 1);
    check_relative(clod_law_cycle_virgin(&law, R_STAR), 1e9, 1e-15);
    contact.law = CLOD_LAW_HERTZ;
    law = clod_law_make(&contact, &ORE, &ORE);
    const double k1 = 4.0 / 3.0 * 119e9 / (2.0 * (1.0 - 0.1156)) * sqrt(R_STAR);
    const cycle hertz[] = {{4e-6, 8e-9 * k1, 12.8e-15 * k1}};
    check_cycle(&law, hertz, 1);
    check_relative(clod_law_cycle_virgin(&law, R_STAR), k1, 1e-12);
    check_close(clod_law_cycle_pull(&law, R_STAR, 4e-6).force, 0.0, 0.0);
}

/** The pull is the lowest force of a fine path down from the overlap. */
static void check_pull(const clod_case_contact *contact, double overlap, clod_law_pull expected)
{
    law_probe probe = probe_make(contact);
    const clod_law_pull pull = clod_law_cycle_pull(&probe.law, R_STAR, overlap);
    check_relative(pull.overlap, expected.overlap, 1e-12);
    check_relative(pull.force, expected.force, 1e-12);
    double low = 0.0, at = 0.0;
    probe_press(&probe, overlap);
    for (int s = 10000; s > 0; s--) {
        const double d = 1e-4 * s * overlap;
        const double force = probe_press(&probe, d);
        at = force < low ? d : at;
        low = fmin(low, force);
    }
    check_close(-low, pull.force, 1e-3 * pull.force);
    check_close(at, pull.overlap, 2e-4 * overlap);
}

/** By hand: where k2 (d - d0) meets the pull-off line. */
static void the_largest_pull_of_each_law(void **state)
{
    (void)state;
    clod_case_contact contact = contact_of(CLOD_LAW_MEPA, 1.0, 1e6, 4e6, 1e6);
    check_pull(&contact, 5e-6, (clod_law_pull){3e-6, 3.0}); // (4-1)/(4+1) 5 um
    contact = contact_luding();
    check_pull(&contact, 3e-6, (clod_law_pull){1.2e-6, 1.2});             // 3/5 d*
    check_pull(&contact, 1e-6, (clod_law_pull){1.5e-6 / 3.5, 1.5 / 3.5}); // k2 2.5e6
    contact = contact_of(CLOD_LAW_EEPA, 1.5, 1e9, 4e9, 1e9);
    contact.pull_off_force = 0.5; // x = 3/5 125e-9 = 75e-9
    check_pull(&contact, 25e-6, (clod_law_pull){cbrt(5625e-18), 75.5});
    contact = contact_of(CLOD_LAW_EEPA, 1.0, 1e6, 4e6, 0.0);
    contact.surface_energy = 2.0 / (1.5 * M_PI * sqrt(2.0 * R_STAR * 3e-6));
    check_pull(&contact, 4e-6, (clod_law_pull){2.5e-6, 2.0}); // dp 3 um, F 2 N
    contact.surface_energy *= 16.0; // 32 N are more than k2 dp/2 = 6 N
    check_pull(&contact, 4e-6, (clod_law_pull){1.5e-6, 6.0});
    contact.surface_energy *= 1e-5 / 32.0;
    const clod_law weak = clod_law_make(&contact, &ORE, &ORE);
    check_relative(clod_law_cycle_pull(&weak, R_STAR, 4e-6).force, 1e-5, 1e-12);
    contact = contact_of(CLOD_LAW_EEPA, 1.5, 1e9, 4e9, 0.0); // P = 3/4 8e-9, dp^1.5 = 6e-9
    const double dp = cbrt(36e-18);
    contact.surface_energy = 4.0 / (1.5 * M_PI * sqrt(2.0 * R_STAR * dp));
    check_pull(&contact, 4e-6, (clod_law_pull){cbrt(25e-18), 4.0}); // x = 6e-9 - 1e-9
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loading_of_luding),
        cmocka_unit_test(loading_of_eepa),
        cmocka_unit_test(loading_of_the_others),
        cmocka_unit_test(the_largest_pull_of_each_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
