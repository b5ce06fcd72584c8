// What a contact remembers, as forces: printed check values and closed forms by hand.

#include "law/law_cycle.h"
#include "support/law_probe.h"

#define R_STAR 1.5e-3
#define DEEPEST 3e-6 // m

/** P on the virgin branch and on the pull-off line. */
static double loaded(const clod_law *law, double overlap)
{
    return (1.0 - law->k1 / law->k2) * pow(overlap, law->exponent);
}

static double slid(const clod_law *law, double overlap)
{
    return (1.0 + law->k_adh / law->k2) * pow(overlap, law->exponent);
}

static double pull_off(const clod_law *law, double memory)
{
    return clod_law_cycle_pull(law, R_STAR, clod_law_cycle_pressed(law, memory)).force;
}

static double pressed(const clod_law *law, double memory)
{
    return clod_law_cycle_force(law, R_STAR, clod_law_cycle_pressed(law, memory));
}

/** Check values of docs/theory/mepa.md, printed to seven digits. */
static void pull_off_of_the_ore(void **state)
{
    (void)state;
    static const double K_ADH[2] = {3.56e8, 5.93e8};
    static const double LEAST[2] = {-1.285924, -1.970671};
    static const double AT_60[2] = {-0.859723, -1.432067};
    for (int k = 0; k < 2; k++) {
        clod_case_contact contact = contact_ore();
        contact.k_adh = K_ADH[k];
        const clod_law law = clod_law_make(&contact, &ORE, &ORE);
        const double memory = loaded(&law, DEEPEST);
        check_close(pull_off(&law, memory), -LEAST[k], 5e-7);
        check_close(pressed(&law, memory), 2.468172, 5e-7);
        check_relative(clod_law_cycle_pressed(&law, memory), DEEPEST, 1e-12);
        // slid down to 0.6: it forgot what it was, and pulls with what it carries there
        check_close(pull_off(&law, slid(&law, 0.6 * DEEPEST)), -AT_60[k], 5e-7);
        assert_true(pull_off(&law, 0.0) == 0.0 && pressed(&law, 0.0) == 0.0);
    }
}

/** n = 1, 1 um: f_max 475 N, f_min of the same page. */
static void pull_off_of_the_linear_ore(void **state)
{
    (void)state;
    clod_case_contact contact = contact_ore();
    contact.exponent = 1.0;
    const clod_law law = clod_law_make(&contact, &ORE, &ORE);
    check_close(pull_off(&law, loaded(&law, 1e-6)), 247.47616, 5e-6);
    check_relative(pressed(&law, loaded(&law, 1e-6)), 475.0, 1e-12);
}

/** k_adh is what it is now: a tenth of it pulls with k_adh/10 (k2 - k1)/(k2 + k_adh/10) x. */
static void pull_off_follows_adhesion(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_ore();
    clod_law law = clod_law_make(&contact, &ORE, &ORE);
    clod_law_set_adhesion(&law, 0.1);
    const double x = pow(DEEPEST, 1.5);
    const double expected = 3.56e7 * (2.37e9 - 4.75e8) / (2.37e9 + 3.56e7) * x;
    check_relative(pull_off(&law, loaded(&law, DEEPEST)), expected, 1e-12);
    clod_law_set_adhesion(&law, 0.0);
    assert_true(pull_off(&law, loaded(&law, DEEPEST)) == 0.0);
}

/** d* = 2 um; at d_max = 1 um k2 is 2.5e6 N/m, d0 0.6 um, and the branches meet at 3/7 um. */
static void pull_off_of_luding(void **state)
{
    (void)state;
    clod_case_contact contact = contact_ore();
    contact.law = CLOD_LAW_LUDING;
    contact.exponent = 1.0;
    contact.k1 = contact.k_adh = 1e6;
    contact.k2 = 4e6;
    contact.plasticity_depth = 0.5e-3;
    const clod_law law = clod_law_make(&contact, &ORE, &ORE);
    check_relative(pull_off(&law, 1e-6), 3.0 / 7.0, 1e-12);
    check_relative(pressed(&law, 1e-6), 1.0, 1e-12);
}

/** -f0 = 0.5 N pulls at any contact; 4 um: P = 3 um, x = 2.4 um, 2.4 N and 0.5 N. */
static void pull_off_of_eepa(void **state)
{
    (void)state;
    clod_case_contact contact = contact_ore();
    contact.law = CLOD_LAW_EEPA;
    contact.exponent = 1.0;
    contact.k1 = contact.k_adh = 1e6;
    contact.k2 = 4e6;
    contact.pull_off_force = 0.5;
    const clod_law law = clod_law_make(&contact, &ORE, &ORE);
    check_relative(pull_off(&law, 0.0), 0.5, 1e-12);
    check_relative(pull_off(&law, 3e-6), 2.9, 1e-12);
    check_relative(pressed(&law, 3e-6), 3.5, 1e-12);
}

/** Elastic laws remember nothing and do not pull. */
static void elastic_laws_have_none(void **state)
{
    (void)state;
    clod_case_contact contact = contact_ore();
    for (int kind = 0; kind < 3; kind++) {
        contact.law = kind == 0 ? CLOD_LAW_HERTZ : kind == 1 ? CLOD_LAW_HOOKE : CLOD_LAW_MEPA;
        contact.exponent = kind == 1 ? 1.0 : 1.5;
        contact.k2 = contact.k1;
        const clod_law law = clod_law_make(&contact, &ORE, &ORE);
        assert_true(clod_law_cycle_pressed(&law, 0.0) == 0.0);
        assert_true(pull_off(&law, 0.0) == 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pull_off_of_the_ore),
        cmocka_unit_test(pull_off_of_the_linear_ore),
        cmocka_unit_test(pull_off_follows_adhesion),
        cmocka_unit_test(pull_off_of_luding),
        cmocka_unit_test(pull_off_of_eepa),
        cmocka_unit_test(elastic_laws_have_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
