// A law made ready from a case: hertz by Hertz and Mindlin, hooke, damping, adhesion, pairs.

#include <string.h>

#include "base/memory.h"
#include "support/law_probe.h"

static const clod_case_material GLASS = {
    .density = 2500.0, .youngs_modulus = 70e9, .poissons_ratio = 0.25};
static const clod_case_material RUBBER = {
    .density = 1100.0, .youngs_modulus = 5e6, .poissons_ratio = 0.5};

/** E* of glass on rubber: 1/((1 - nu^2)/E + ...) [Pa]. */
#define E_STAR (1.0 / (0.9375 / 70e9 + 0.75 / 5e6))
/** G*: 1/((2 - nu)/G + ...) with G = E/(2 (1 + nu)) = 28e9 and 5e6/3 Pa. */
#define G_STAR (1.0 / (1.75 / 28e9 + 4.5 / 5e6))

static clod_case_contact contact_hertz(void)
{
    clod_case_contact contact = contact_ore();
    contact.law = CLOD_LAW_HERTZ;
    contact.exponent = 7.0; // not read
    contact.friction = 1e6;
    contact.rolling = CLOD_ROLLING_NONE;
    return contact;
}

/** F = 4/3 E* sqrt(R*) d^1.5, k_t = 8 G* sqrt(R* d). */
static void hertz_is_hertz_and_mindlin(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_hertz();
    const clod_law law = clod_law_make(&contact, &GLASS, &RUBBER);
    const clod_law other = clod_law_make(&contact, &RUBBER, &GLASS);
    assert_memory_equal(&law.k1, &other.k1, sizeof law.k1);
    law_probe probe = {.law = law};
    clod_law_motion m = probe_motion(16e-6);
    m.r_star = 2.25e-3;
    m.velocity.y = 1e-3;
    const clod_law_result r = probe_step(&probe, &m, 1e-6);
    check_relative(r.force.x, 4.0 / 3.0 * E_STAR * sqrt(2.25e-3) * 64e-9, 1e-12);
    check_relative(r.force.y, -8.0 * G_STAR * sqrt(2.25e-3 * 16e-6) * 1e-9, 1e-12);
    check_relative(clod_law_tangent(&law, 16e-6, 2.25e-3), 2.0 * E_STAR * sqrt(3.6e-8), 1e-12);
    m.overlap = 4e-6; // elastic on the way back
    m.velocity.y = 0.0;
    const double back = probe_step(&probe, &m, 1e-6).force.x;
    check_relative(back, 4.0 / 3.0 * E_STAR * sqrt(2.25e-3) * 8e-9, 1e-12);
}

static void hooke_is_a_spring(void **state)
{
    (void)state;
    clod_case_contact contact = contact_ore();
    contact.law = CLOD_LAW_HOOKE;
    contact.k1 = 5e5;
    contact.k2 = 0.0; // not read
    law_probe probe = probe_make(&contact);
    check_relative(probe_press(&probe, 6e-6), 3.0, 1e-12);
    check_relative(probe_press(&probe, 2e-6), 1.0, 1e-12);
    check_relative(clod_law_tangent(&probe.law, 2e-6, 1e-3), 5e5, 1e-12);
    assert_int_equal(probe.law.exponent_kind, CLOD_EXPONENT_ONE);
}

static void tangents_of_mepa(void **state)
{
    (void)state;
    clod_case_contact contact = contact_ore();
    clod_law law = clod_law_make(&contact, &ORE, &ORE);
    check_relative(clod_law_tangent(&law, 4e-6, 1e-3), 1.425e6, 1e-12); // 1.5 4.75e8 2e-3
    assert_int_equal(law.exponent_kind, CLOD_EXPONENT_THREE_HALVES);
    contact.exponent = 2.0;
    law = clod_law_make(&contact, &ORE, &ORE);
    check_relative(clod_law_tangent(&law, 4e-6, 1e-3), 2.0 * 4.75e8 * 4e-6, 1e-12);
    assert_int_equal(law.exponent_kind, CLOD_EXPONENT_ANY);
}

/** f_n = f_hys - gamma_n v_n: z = 0.2154524... for e = 0.5 (ln 0.5 = -0.693147...). */
static void damping_is_that_of_the_restitution(void **state)
{
    (void)state;
    const double z = 0.6931471805599453 / sqrt(0.4804530139182014 + 9.869604401089358);
    const double exponent[] = {1.0, 1.5, 2.0, 3.0};
    const double factor[] = {1.0, sqrt(5.0 / 6.0), sqrt(0.75), sqrt(4.0 / 6.0)};
    for (int k = 0; k < 4; k++) {
        clod_case_contact contact = contact_ore();
        contact.exponent = exponent[k];
        contact.restitution = 0.5;
        law_probe probe = probe_make(&contact);
        clod_law_motion m = probe_motion(4e-6);
        const double rest = probe_step(&probe, &m, 0.0).force.x;
        m.velocity.x = -0.25; // coming closer: the dash-pot pushes apart
        const double moving = probe_step(&probe, &m, 0.0).force.x;
        const double dk = exponent[k] * 4.75e8 * exp((exponent[k] - 1.0) * log(4e-6));
        const double gamma = 2.0 * z * factor[k] * sqrt(0.5e-3 * dk);
        check_relative(moving - rest, 0.25 * gamma, 1e-10);
    }
}

static void adhesion_is_a_fraction_of_its_final_value(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_ore();
    clod_law law = clod_law_make(&contact, &ORE, &ORE);
    check_close(law.k_adh, 3.56e8, 0.0);
    clod_law_set_adhesion(&law, 0.25);
    check_relative(law.k_adh, 0.89e8, 1e-15);
    check_relative(law.pull_off, 1.0 + 0.89e8 / 2.37e9, 1e-15);
    clod_law_set_adhesion(&law, 1.0);
    check_close(law.k_adh, 3.56e8, 0.0);
    clod_case_contact hooke = contact;
    hooke.law = CLOD_LAW_HOOKE;
    check_close(clod_law_make(&hooke, &ORE, &ORE).k_adh, 0.0, 0.0);
}

/** Every unordered pair has a row of its own. */
static void pairs_have_rows_of_their_own(void **state)
{
    (void)state;
    for (int32_t materials = 1; materials < 9; materials++) {
        const clod_laws laws = {.materials = materials};
        bool taken[64] = {false};
        for (int32_t a = 0; a < materials; a++) {
            for (int32_t b = a; b < materials; b++) {
                const int32_t row = clod_laws_index(&laws, a, b);
                assert_int_equal(row, clod_laws_index(&laws, b, a));
                assert_in_range(row, 0, materials * (materials + 1) / 2 - 1);
                assert_false(taken[row]);
                taken[row] = true;
            }
        }
    }
}

static void a_case_gives_the_laws_of_all_pairs(void **state)
{
    (void)state;
    clod_status status;
    clod_case_material materials[3] = {ORE, GLASS, RUBBER};
    clod_case_contact pairs[9];
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
            pairs[3 * a + b] = contact_ore();
            pairs[3 * a + b].friction = 0.1 * (a * b + a + b);
        }
    }
    const clod_case from = {.materials = materials, .material_count = 3, .pairs = pairs};
    clod_laws laws;
    assert_true(clod_laws_init(&laws, &from, &status));
    assert_int_equal(laws.count, 6);
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
            const clod_law *law = &laws.law[clod_laws_index(&laws, a, b)];
            check_relative(law->friction, 0.1 * (a * b + a + b), 1e-15);
        }
    }
    clod_laws_set_adhesion(&laws, 0.5);
    for (int32_t l = 0; l < 6; l++) {
        check_relative(laws.law[l].k_adh, 1.78e8, 1e-15);
    }
    clod_laws_fini(&laws);
    assert_null(laws.law);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hertz_is_hertz_and_mindlin),
        cmocka_unit_test(hooke_is_a_spring),
        cmocka_unit_test(tangents_of_mepa),
        cmocka_unit_test(damping_is_that_of_the_restitution),
        cmocka_unit_test(adhesion_is_a_fraction_of_its_final_value),
        cmocka_unit_test(pairs_have_rows_of_their_own),
        cmocka_unit_test(a_case_gives_the_laws_of_all_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
