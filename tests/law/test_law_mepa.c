// Normal force: the check values of docs/theory/mepa.md, the family, and random paths against
// the three branches of the paper.

#include "support/dice.h"
#include "support/law_probe.h"
#include "support/law_reference.h"

#define MICRON 1e-6

static clod_case_contact ore_with(double exponent, double k_adh)
{
    clod_case_contact contact = contact_ore();
    contact.exponent = exponent;
    contact.k_adh = k_adh;
    return contact;
}

/** The paper's branches along the same path, in long double. */
typedef struct branches {
    ref_law law;
    quad most;
} branches;

static branches branches_make(const clod_case_contact *c)
{
    return (branches){{.n = c->exponent, .k1 = c->k1, .k2 = c->k2, .k_adh = c->k_adh}, 0.0L};
}

static double branches_press(branches *self, double overlap)
{
    return (double)ref_normal(&self->law, powl((quad)overlap, self->law.n), &self->most);
}

typedef struct checkpoint {
    double overlap; ///< as a fraction of d_max
    double force;   ///< N, printed in docs/theory/mepa.md
    double digit;   ///< N, one unit of the last printed digit
} checkpoint;

/** Drive to each overlap in turn; compare with what is printed and with the branches. */
static void follow(const clod_case_contact *contact, double most, const checkpoint *at,
                   int count)
{
    law_probe probe = probe_make(contact);
    branches reference = branches_make(contact);
    double from = 0.0;
    for (int k = 0; k < count; k++) {
        const double to = at[k].overlap * most;
        const double force = probe_path(&probe, from, to, 400);
        double expected = 0.0;
        for (int s = 1; s <= 400; s++) {
            expected =
                branches_press(&reference, s == 400 ? to : from + s / 400.0 * (to - from));
        }
        check_close(force, at[k].force, 0.5001 * at[k].digit);
        check_close(force, expected, 1e-12 * contact->k1 * pow(most, contact->exponent));
        from = to;
    }
}

static void check_values_at_5_percent(void **state)
{
    (void)state;
    const clod_case_contact contact = ore_with(1.5, 3.56e8);
    const checkpoint path[] = {
        {0.25, 0.308522, 1e-6},  {0.50, 0.872631, 1e-6}, {0.75, 1.603125, 1e-6},
        {1.00, 2.468172, 1e-6},  {0.95, 1.556200, 1e-6}, {0.90, 0.667921, 1e-6},
        {0.60, -0.859723, 1e-6}, {0.70, 0.629195, 1e-6}, {1.10, 2.84751, 1e-5},
    };
    follow(&contact, 3.0 * MICRON, path, 9);
    const checkpoint down[] = {{1.00, 2.468172, 1e-6}, {0.50, -0.654014, 1e-6}};
    follow(&contact, 3.0 * MICRON, down, 2);
}

static void check_values_at_8_percent(void **state)
{
    (void)state;
    const clod_case_contact contact = ore_with(1.5, 5.93e8);
    const checkpoint path[] = {
        {1.00, 2.468172, 1e-6},  {0.95, 1.556200, 1e-6},  {0.90, 0.667921, 1e-6},
        {0.60, -1.432067, 1e-6}, {0.70, 0.0568512, 1e-7}, {1.10, 2.84751, 1e-5},
    };
    follow(&contact, 3.0 * MICRON, path, 6);
    const checkpoint down[] = {{1.00, 2.468172, 1e-6}, {0.50, -1.089411, 1e-6}};
    follow(&contact, 3.0 * MICRON, down, 2);
}

static void check_values_of_the_linear_law(void **state)
{
    (void)state;
    const clod_case_contact wet = ore_with(1.0, 3.56e8);
    const checkpoint path[] = {{1.0, 475.0, 0.1}, {0.6, -213.6, 0.1}, {0.7, 23.4, 0.1}};
    follow(&wet, MICRON, path, 3); // -213.6 = -k_adh 0.6e-6
    const clod_case_contact wetter = ore_with(1.0, 5.93e8);
    const checkpoint path8[] = {{1.0, 475.0, 0.1}, {0.6, -355.8, 0.1}, {0.7, -118.8, 0.1}};
    follow(&wetter, MICRON, path8, 3);
}

/** d_min/d_max = ((k2-k1)/(k2+k_adh))^(1/n); |f_min|/f_max = (k_adh/k1)(k2-k1)/(k2+k_adh). */
static void pull_off_matches_the_closed_form(void **state)
{
    (void)state;
    const double exponent[] = {1.0, 1.2, 1.5, 2.0};
    const double k_adh[] = {3.56e8, 5.93e8};
    for (int e = 0; e < 8; e++) {
        const double n = exponent[e / 2];
        const clod_case_contact contact = ore_with(n, k_adh[e % 2]);
        const double ratio = (2.37e9 - 4.75e8) / (2.37e9 + contact.k_adh);
        const double most = 2.5 * MICRON;
        const double least = most * exp(log(ratio) / n);
        law_probe probe = probe_make(&contact);
        const double f_max = probe_path(&probe, 0.0, most, 10);
        check_relative(f_max, 4.75e8 * exp(n * log(most)), 1e-12);
        const double f_min = probe_path(&probe, most, least, 10);
        check_relative(f_min, -contact.k_adh / 4.75e8 * ratio * f_max, 1e-12);
        // the lowest point: to both sides of it the force is higher
        law_probe other = probe;
        check_at_least(probe_press(&probe, 1.001 * least), f_min + 1e-6 * f_max);
        check_at_least(probe_press(&other, 0.999 * least), f_min + 1e-6 * f_max * n);
    }
}

static void pull_off_values_are_the_printed_ones(void **state)
{
    (void)state;
    const struct {
        double n, k_adh, most, d_min, f_min;
    } row[] = {{1.5, 3.56e8, 3.0 * MICRON, 2.354201e-6, -1.285924},
               {1.5, 5.93e8, 3.0 * MICRON, 2.226929e-6, -1.970671},
               {1.0, 3.56e8, 1.0 * MICRON, 0.0, -247.47616},
               {1.0, 5.93e8, 1.0 * MICRON, 0.0, -379.25582}};
    for (int k = 0; k < 4; k++) {
        const clod_case_contact contact = ore_with(row[k].n, row[k].k_adh);
        law_probe probe = probe_make(&contact);
        probe_press(&probe, row[k].most);
        double low = 0.0;
        double at = 0.0;
        for (int s = 1000000; s > 500000; s--) {
            const double d = 1e-6 * s * row[k].most;
            const double force = probe_press(&probe, d);
            at = force < low ? d : at;
            low = fmin(force, low);
        }
        check_relative(low, row[k].f_min, 2e-6);
        if (row[k].d_min > 0.0) {
            check_relative(at, row[k].d_min, 2e-6);
        }
    }
}

static void plastic_overlap_is_the_printed_one(void **state)
{
    (void)state;
    const clod_case_contact contact = ore_with(1.5, 3.56e8);
    law_probe probe = probe_make(&contact);
    probe_press(&probe, 3.0 * MICRON);
    check_close(cbrt(pow(probe.history.plastic[0], 2.0)), 2.584413e-6, 0.5001e-12);
    check_close(probe_press(&probe, 2.584413e-6), 0.0, 3e-6); // f2(dp) = 0, to half a digit
}

/** Random paths with separations; k_adh changes on the way and leaves P alone. */
static void random_paths_follow_the_branches(void **state)
{
    (void)state;
    const double exponent[] = {1.0, 1.2, 1.5, 2.0};
    dice roll = {1};
    for (int path = 0; path < 400; path++) {
        const double n = exponent[path % 4];
        clod_case_contact contact = ore_with(n, dice_real(&roll, 0.0, 3e9));
        contact.k2 = contact.k1 * dice_real(&roll, 1.0, 8.0);
        law_probe probe = probe_make(&contact);
        branches reference = branches_make(&contact);
        double overlap = 0.0;
        for (int s = 0; s < 200; s++) {
            overlap += dice_real(&roll, -1.0, 1.0) * MICRON;
            if (s % 40 == 39) { // docs/theory/copper-ore.md: raised after filling, P stays
                const double fraction = dice_real(&roll, 0.0, 1.0);
                const double plastic = probe.history.plastic[0];
                clod_law_set_adhesion(&probe.law, fraction);
                reference.law.k_adh = fraction * (quad)contact.k_adh;
                check_close(probe.history.plastic[0], plastic, 0.0);
            }
            const double force = probe_press(&probe, overlap);
            if (overlap <= 0.0) { // open: no force, nothing remembered
                check_close(force, 0.0, 0.0);
                check_close(probe.history.plastic[0], 0.0, 0.0);
                check_close(probe.history.tangent[0], 0.0, 0.0);
                reference.most = 0.0L;
                overlap = 0.0;
                continue;
            }
            const double scale = (contact.k2 + contact.k_adh) * pow(overlap, n);
            check_close(force, branches_press(&reference, overlap), 1e-12 * scale);
        }
    }
}

/** docs/theory/mepa.md: scaling k1, k2, k_adh by s and d^n by 1/s leaves every force. */
static void the_law_has_no_force_scale(void **state)
{
    (void)state;
    clod_case_contact contact = ore_with(1.5, 3.56e8);
    law_probe stiff = probe_make(&contact);
    contact.k1 /= 8.0;
    contact.k2 /= 8.0;
    contact.k_adh /= 8.0;
    law_probe soft = probe_make(&contact);
    const double path[] = {3.0, 2.5, 2.9, 2.0, 1.0, 1.5, 4.0};
    for (int s = 0; s < 7; s++) { // 8^(2/3) = 4
        const double force = probe_press(&stiff, path[s] * MICRON);
        check_close(probe_press(&soft, 4.0 * path[s] * MICRON), force, 1e-12 * 10.0);
    }
}

/** k1 = k2: elastic, whatever k_adh (docs/theory/mepa.md). */
static void equal_stiffnesses_are_elastic(void **state)
{
    (void)state;
    clod_case_contact contact = ore_with(1.5, 3.56e8);
    contact.k2 = contact.k1;
    law_probe probe = probe_make(&contact);
    probe_press(&probe, 3.0 * MICRON);
    for (int s = 30; s > 0; s--) {
        const double d = 0.1 * s * MICRON;
        check_relative(probe_press(&probe, d), 4.75e8 * d * sqrt(d), 1e-12);
    }
}

/** A contact that has opened starts again on the virgin line. */
static void a_contact_that_opens_forgets(void **state)
{
    (void)state;
    const clod_case_contact contact = ore_with(1.5, 3.56e8);
    law_probe probe = probe_make(&contact);
    probe_press(&probe, 3.0 * MICRON);
    check_close(probe_press(&probe, -1.0 * MICRON), 0.0, 0.0);
    check_relative(probe_press(&probe, 1.0 * MICRON), 4.75e8 * 1e-9, 1e-12);
    probe_press(&probe, 3.0 * MICRON);
    check_close(probe_press(&probe, 0.0), 0.0, 0.0);
    check_relative(probe_press(&probe, 1.0 * MICRON), 4.75e8 * 1e-9, 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(check_values_at_5_percent),
        cmocka_unit_test(check_values_at_8_percent),
        cmocka_unit_test(check_values_of_the_linear_law),
        cmocka_unit_test(pull_off_matches_the_closed_form),
        cmocka_unit_test(plastic_overlap_is_the_printed_one),
        cmocka_unit_test(random_paths_follow_the_branches),
        cmocka_unit_test(the_law_has_no_force_scale),
        cmocka_unit_test(equal_stiffnesses_are_elastic),
        cmocka_unit_test(a_contact_that_opens_forgets),
        cmocka_unit_test(pull_off_values_are_the_printed_ones), // the longest
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
