// A law of a softened case is, to the last bit, that of a case with every stiffness divided by
// hand (docs/theory/softening.md); the quotients below are whole numbers.

#include <string.h>

#include "support/law_probe.h"

static const clod_case_material SOFT_ORE = {
    .density = 2481.3, .youngs_modulus = 1.19e9, .poissons_ratio = 0.34};

static clod_law make_softened(clod_case_contact contact)
{
    contact.soften = 100.0;
    return clod_law_make(&contact, &ORE, &ORE);
}

/** With every stiffness over 100 by hand. */
static clod_law make_by_hand(clod_case_contact contact)
{
    contact.k1 = 4.75e6;
    contact.k2 = 2.37e7;
    contact.k_adh = contact.k_adh > 0.0 ? 3.56e6 : 0.0;
    return clod_law_make(&contact, &SOFT_ORE, &SOFT_ORE);
}

static void every_law_has_the_bits_of_divided_stiffnesses(void **state)
{
    (void)state;
    for (int kind = 0; kind < CLOD_LAW_KINDS; kind++) {
        clod_case_contact contact = contact_ore();
        contact.law = kind;
        contact.exponent = kind == CLOD_LAW_LUDING || kind == CLOD_LAW_HOOKE ? 1.0 : 1.5;
        contact.tangential =
            kind == CLOD_LAW_MEPA ? CLOD_TANGENTIAL_LITERAL : CLOD_TANGENTIAL_TANGENT;
        contact.plasticity_depth = 0.05;
        contact.restitution = 0.5;
        if (kind == CLOD_LAW_EEPA) {
            contact.k_adh = 0.0;
            contact.pull_off_force = 2e-3;
            contact.surface_energy = 0.5;
        }
        const clod_law soft = make_softened(contact);
        const clod_law by_hand = make_by_hand(contact);
        const clod_law hard = clod_law_make(&contact, &ORE, &ORE);
        assert_memory_equal(&soft, &by_hand, sizeof soft);
        assert_true(hard.k1 > 90.0 * soft.k1);
        assert_true(hard.touch == soft.touch && hard.patch == soft.patch);
        assert_true(hard.damping == soft.damping && hard.friction == soft.friction);
    }
}

// 1.5 k1 sqrt(d) as literal and tangent give it; k_t literal is the number k1/100 in N/m.
static void tangential_springs_follow(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_ore();
    const clod_law soft = make_softened(contact);
    check_relative(clod_law_tangent(&soft, 4e-6, 1.5e-3), 1.5 * 4.75e6 * 2e-3, 1e-14);
    check_relative(soft.literal_stiffness, 4.75e6, 1e-15);
}

static void without_softening_nothing_changes(void **state)
{
    (void)state;
    clod_case_contact contact = contact_ore();
    const clod_law plain = clod_law_make(&contact, &ORE, &ORE);
    contact.soften = 1.0;
    const clod_law one = clod_law_make(&contact, &ORE, &ORE);
    assert_memory_equal(&plain, &one, sizeof one);
    assert_true(clod_law_soften_material(&ORE, 0.0).youngs_modulus == 119e9);
    assert_true(clod_law_soften_material(&ORE, 7.0).youngs_modulus == 17e9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_law_has_the_bits_of_divided_stiffnesses),
        cmocka_unit_test(tangential_springs_follow),
        cmocka_unit_test(without_softening_nothing_changes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
