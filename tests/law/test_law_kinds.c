// The tables of laws: a row in each for every clod_law_kind, a page of theory, and the
// stiffest tangent of the row against the law's force.

#include "law/law_kinds.h"

#include <stdio.h>
#include <string.h>

#include "config/law_keys.h"
#include "law/law_forms.h"
#include "support/dice.h"
#include "support/law_ledger.h"

#define R_STAR 1.5e-3 // m
#define DEEPEST 3e-5  // m; beyond d* of luding's law in ledger_law, 15 um
#define SPANS 60
#define POINTS 400

static void every_law_has_its_keys(void **state)
{
    (void)state;
    assert_null(CLOD_LAW_NAMES[CLOD_LAW_KINDS]);
    for (int law = 0; law < CLOD_LAW_KINDS; law++) {
        assert_non_null(CLOD_LAW_NAMES[law]);
        const clod_law_keys *keys = clod_law_keys_of(law);
        assert_true(keys->k1 != NULL || keys->elastic_moduli); // it is stiff by something
        assert_true(keys->k1 == NULL || !keys->elastic_moduli);
        assert_true(keys->k1 != NULL || keys->k2 == NULL);
        assert_true(clod_law_keys_exponent(CLOD_LAW_NAMES[law]) == keys->exponent);
        for (int other = 0; other < law; other++) {
            assert_string_not_equal(CLOD_LAW_NAMES[law], CLOD_LAW_NAMES[other]);
        }
    }
    assert_true(clod_law_keys_exponent("no law") == 0.0);
}

static bool is_hertz(const clod_law_keys *law)
{
    return law->elastic_moduli;
}

static bool has_depth(const clod_law_keys *law)
{
    return law->plasticity_depth != NULL;
}

static bool is_cohesive_or_hertz(const clod_law_keys *law)
{
    return has_depth(law) || law->surface_energy || is_hertz(law);
}

static bool is_no_law(const clod_law_keys *law)
{
    (void)law;
    return false;
}

/** Laws that have a key, as messages and help name them. */
static void lists_of_laws_read_well(void **state)
{
    (void)state;
    char text[CLOD_LAW_KEYS_TEXT], about[CLOD_LAW_KEYS_ABOUT];
    assert_int_equal(clod_law_keys_list(is_hertz, text), 1);
    assert_string_equal(text, "law hertz");
    assert_int_equal(clod_law_keys_list(is_cohesive_or_hertz, text), 3);
    assert_string_equal(text, "the laws hertz, luding and eepa");
    assert_int_equal(clod_law_keys_list(is_no_law, text), 0);
    clod_law_keys_about(about);
    assert_non_null(strstr(about, "hooke (linear elastic, k1), luding (linear, k2 rises"));
    for (int law = 0; law < CLOD_LAW_KINDS; law++) {
        assert_non_null(strstr(about, CLOD_LAW_NAMES[law]));
    }
}

static void every_law_has_a_page_of_theory(void **state)
{
    (void)state;
    for (int law = 0; law < CLOD_LAW_KINDS; law++) {
        char path[512];
        snprintf(path, sizeof path, "%s/docs/theory/%s.md", CLOD_SOURCE_DIR,
                 CLOD_LAW_NAMES[law]);
        FILE *page = fopen(path, "r");
        if (page == NULL) {
            fail_msg("law %s has no page %s", CLOD_LAW_NAMES[law], path);
        }
        fclose(page);
    }
}

static void every_law_has_its_numbers(void **state)
{
    (void)state;
    for (int law = 0; law < CLOD_LAW_KINDS; law++) {
        const clod_law_kind_row *row = clod_law_kinds_row((clod_law_kind)law);
        assert_non_null(row->make);
        assert_non_null(row->stiffest);
        assert_non_null(row->unloading);
        assert_non_null(row->pull);
        assert_non_null(row->plastic);
        assert_non_null(row->pressed);
        assert_non_null(row->stiffness_keys);
    }
}

/** What the tables say of a law is the same. */
static void the_tables_agree(void **state)
{
    (void)state;
    bool seen[CLOD_LAW_KINDS] = {false};
    for (int k = 0; k < LEDGER_LAWS; k++) {
        clod_case_contact contact = ledger_law(k);
        const clod_law_keys *keys = clod_law_keys_of(contact.law);
        const clod_law_kind_row *row = clod_law_kinds_row((clod_law_kind)contact.law);
        seen[contact.law] = true;
        const clod_law law = clod_law_make(&contact, &ORE, &ORE);
        if (keys->exponent != 0.0) {
            assert_true(law.exponent == keys->exponent);
        }
        assert_true(row->rayleigh == keys->elastic_moduli);
        assert_true(clod_law_root_radius(&law) == keys->elastic_moduli);
        assert_true(clod_law_rises(&law) == (keys->plasticity_depth != NULL));
        assert_true(clod_law_pulls(&law) == keys->surface_energy);
        assert_true((strcmp(row->stiffness_keys, "youngs_modulus") == 0) ==
                    keys->elastic_moduli);
        assert_true(row->elastic == (keys->k2 == NULL));
        assert_true((row->flow != NULL) == (keys->plasticity_depth != NULL));
        assert_true((law.k_adh > 0.0) == (keys->k_adh && contact.k_adh > 0.0));
    }
    for (int law = 0; law < CLOD_LAW_KINDS; law++) {
        assert_true(seen[law]); // a new law goes into ledger_law too
    }
}

/** Force at an overlap of a contact with this memory, which stays. */
static double force_at(const clod_law *law, double overlap, double memory)
{
    const clod_law_stiffness s = clod_law_stiffness_at(law, overlap, R_STAR);
    return clod_law_normal_force(law, s, &memory).force;
}

/**
 * Slope df/dd of the force about an overlap of a contact, over the stiffest tangent; the force
 * of a falling branch swings nothing and is not bounded by it.
 */
static double steepness(const clod_law *law, double overlap, double memory)
{
    const double h = 1e-5 * overlap;
    const double here = force_at(law, overlap, memory);
    const double up = (force_at(law, overlap + h, memory) - here) / h;
    const double down = (here - force_at(law, overlap - h, memory)) / h;
    return fmax(up, down) / clod_law_stiffest(law, overlap, R_STAR);
}

/** The largest steepness on a path of loading and unloading, all of it closed. */
static double steepest(const clod_law *law, dice *d)
{
    double worst = 0.0;
    double memory = 0.0;
    double overlap = 1e-8;
    for (int span = 0; span < SPANS; span++) {
        const double to = DEEPEST * pow(10.0, dice_real(d, -2.0, 0.0));
        const double step = (to - overlap) / POINTS;
        for (int p = 0; p < POINTS; p++) {
            overlap += step;
            const clod_law_stiffness s = clod_law_stiffness_at(law, overlap, R_STAR);
            (void)clod_law_normal_force(law, s, &memory);
            worst = fmax(worst, steepness(law, overlap, memory));
        }
    }
    return worst;
}

/** The bound holds, and the law comes up to it: a step from it is not too small either. */
static void the_stiffest_tangent_bounds_the_slope(void **state)
{
    (void)state;
    dice d = {41};
    for (int k = 0; k < LEDGER_LAWS; k++) {
        const clod_case_contact contact = ledger_law(k);
        const clod_law law = clod_law_make(&contact, &ORE, &ORE);
        const double worst = steepest(&law, &d);
        check_at_most(worst, 1.0 + 2e-5); // n >= 1: beyond by up to (n - 1) h/d
        check_at_most(1.0 - worst, 1e-3);
    }
}

/** Overlap at which a contact with this memory has no force but the constant pull, by halving.
 */
static double overlap_without_force(const clod_law *law, double deepest, double memory)
{
    double low = 0.0, high = deepest;
    for (int k = 0; k < 200; k++) {
        const double middle = 0.5 * (low + high);
        if (force_at(law, middle, memory) + law->touch > 0.0) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return high;
}

/** The plastic overlap of a row is where the unloading branch comes to nothing. */
static void plastic_overlap_is_where_unloading_ends(void **state)
{
    (void)state;
    int plastic = 0;
    for (int k = 0; k < LEDGER_LAWS; k++) {
        const clod_case_contact contact = ledger_law(k);
        const clod_law law = clod_law_make(&contact, &ORE, &ORE);
        const clod_law_kind_row *row = clod_law_kinds_row(law.kind);
        check_close(row->plastic(&law, R_STAR, 0.0), 0.0, 0.0);
        for (int share = 1; share <= 3; share++) {
            const double deepest = 0.1 * share * DEEPEST;
            const clod_law_stiffness s = clod_law_stiffness_at(&law, deepest, R_STAR);
            double memory = 0.0;
            (void)clod_law_normal_force(&law, s, &memory);
            if (memory > 0.0) {
                check_relative(row->plastic(&law, R_STAR, memory),
                               overlap_without_force(&law, deepest, memory), 1e-9);
                plastic++;
            }
        }
    }
    assert_true(plastic >= 9); // mepa, luding, eepa
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_law_has_its_keys),
        cmocka_unit_test(lists_of_laws_read_well),
        cmocka_unit_test(every_law_has_a_page_of_theory),
        cmocka_unit_test(every_law_has_its_numbers),
        cmocka_unit_test(the_tables_agree),
        cmocka_unit_test(the_stiffest_tangent_bounds_the_slope),
        cmocka_unit_test(plastic_overlap_is_where_unloading_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
