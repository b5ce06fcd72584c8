// The tables of springs: stiffnesses of each model by hand (docs/theory/tangential.md,
// rolling.md), the same bits as the kernels' (law_tangential.h), and which keys each has.

#include "law/law_springs.h"

#include "support/law_probe.h"

#define LOADING 1.5e6 // N/m
#define R_STAR 1.5e-3 // m
#define RATIO 0.75

/** Copper ore (k1 = 4.75e8 N/m^1.5, mu_r = 0.3) with these models. */
static clod_law law_of(clod_tangential tangential, clod_rolling rolling)
{
    clod_case_contact contact = contact_ore();
    contact.tangential = (int)tangential;
    contact.tangential_ratio = RATIO;
    contact.rolling = (int)rolling;
    contact.rolling_damping = 0.5;
    return clod_law_make(&contact, &ORE, &ORE);
}

/** tangent: 0.75 x 1.5e6 N/m; literal: the number k1. */
static void tangential_stiffness_by_hand(void **state)
{
    (void)state;
    const clod_law tangent = law_of(CLOD_TANGENTIAL_TANGENT, CLOD_ROLLING_NONE);
    const clod_law literal = law_of(CLOD_TANGENTIAL_LITERAL, CLOD_ROLLING_NONE);
    check_relative(clod_law_springs_tangential(&tangent, LOADING), 1.125e6, 1e-15);
    check_relative(clod_law_springs_tangential(&literal, LOADING), 4.75e8, 1e-15);
}

/** epsd: 2.25 x 0.3^2 x 1.5e6 N/m; epsd2: k_t; none and cdt have no spring. */
static void rolling_stiffness_by_hand(void **state)
{
    (void)state;
    static const double EXPECTED[][2] = {[CLOD_ROLLING_NONE] = {0.0, 0.0},
                                         [CLOD_ROLLING_CDT] = {0.0, 0.0},
                                         [CLOD_ROLLING_EPSD] = {303750.0, 303750.0},
                                         [CLOD_ROLLING_EPSD2] = {1.125e6, 4.75e8}};
    for (int r = CLOD_ROLLING_NONE; r <= CLOD_ROLLING_EPSD2; r++) {
        for (int t = CLOD_TANGENTIAL_TANGENT; t <= CLOD_TANGENTIAL_LITERAL; t++) {
            const clod_law law = law_of((clod_tangential)t, (clod_rolling)r);
            check_close(clod_law_springs_rolling(&law, LOADING), EXPECTED[r][t],
                        1e-15 * EXPECTED[r][t]);
        }
    }
}

/** What setup and messages compute is what the kernels compute. */
static void springs_are_those_of_the_kernels(void **state)
{
    (void)state;
    for (int r = CLOD_ROLLING_NONE; r <= CLOD_ROLLING_EPSD2; r++) {
        for (int t = CLOD_TANGENTIAL_TANGENT; t <= CLOD_TANGENTIAL_LITERAL; t++) {
            const clod_law law = law_of((clod_tangential)t, (clod_rolling)r);
            const double k_r = clod_law_springs_rolling(&law, LOADING) * (R_STAR * R_STAR);
            assert_true(clod_law_springs_tangential(&law, LOADING) ==
                        clod_law_tangential_stiffness(&law, LOADING));
            assert_true(clod_law_rolling_springs(&law) ==
                        (clod_law_springs_rolling_row_of(r)->stiffness != NULL));
            if (clod_law_rolling_springs(&law)) {
                assert_true(k_r == clod_law_rolling_stiffness(&law, LOADING, R_STAR));
            }
        }
    }
}

/** Ai et al. 2011: epsd alone has a dash-pot; whatever resists has rolling friction. */
static void models_have_their_keys(void **state)
{
    (void)state;
    for (int r = CLOD_ROLLING_NONE; r <= CLOD_ROLLING_EPSD2; r++) {
        const clod_law_springs_rolling_row *row = clod_law_springs_rolling_row_of(r);
        assert_non_null(CLOD_LAW_SPRINGS_ROLLING[r]);
        assert_true(row->resists == (r != CLOD_ROLLING_NONE));
        assert_true(row->dash_pot == (r == CLOD_ROLLING_EPSD));
    }
    assert_null(CLOD_LAW_SPRINGS_ROLLING[CLOD_ROLLING_EPSD2 + 1]);
    assert_false(clod_law_springs_tangential_row_of(CLOD_TANGENTIAL_TANGENT)->takes_k1);
    assert_true(clod_law_springs_tangential_row_of(CLOD_TANGENTIAL_LITERAL)->takes_k1);
    assert_null(CLOD_LAW_SPRINGS_TANGENTIAL[CLOD_TANGENTIAL_LITERAL + 1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tangential_stiffness_by_hand),
        cmocka_unit_test(rolling_stiffness_by_hand),
        cmocka_unit_test(springs_are_those_of_the_kernels),
        cmocka_unit_test(models_have_their_keys),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
