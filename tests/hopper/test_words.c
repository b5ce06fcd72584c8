// Headlines of shapes whose samples contradict the means.

#include <string.h>

#include "hopper/words.h"
#include "support/check.h"

static clod_hopper_found found_of(clod_hopper_outcome outcome, double outlet)
{
    return (clod_hopper_found){
        .design = {.outcome = outcome, .outlet = outlet, .built = outlet}};
}

static void check_begins(const clod_hopper_found *found, const char *words)
{
    char text[CLOD_WORDS_MOST];
    clod_words_verdict(found, text);
    assert_true(strncmp(text, words, strlen(words)) == 0);
}

/** Samples in funnel flow and those not known to be mass flow have none; half of them is not most. */
static void mass_flow_yields_where_most_samples_have_none(void **state)
{
    (void)state;
    clod_hopper_found found = found_of(CLOD_HOPPER_FLOWS, 0.2);
    found.share[CLOD_HOPPER_FLOWS] = 0.5;
    found.share[CLOD_HOPPER_FUNNEL] = 0.5;
    check_begins(&found,
                 "Mass flow, and no cohesive arch above the critical outlet. But 50.0 % ");
    found.share[CLOD_HOPPER_FLOWS] = 0.458;
    found.share[CLOD_HOPPER_FUNNEL] = 0.342;
    found.share[CLOD_HOPPER_UNPROVEN] = 0.2;
    check_begins(&found,
                 "Mass flow is less likely than not: 54.2 % of the samples have none. As "
                 "measured, without errors, it is mass flow, and no cohesive arch stands "
                 "above the critical outlet: see the warnings.");
    found.design.sticks = true; // the critical outlet is the wall's
    check_begins(&found, "Mass flow is less likely than not: 54.2 % ");
}

static void without_an_arch_too(void **state)
{
    (void)state;
    clod_hopper_found found = found_of(CLOD_HOPPER_NO_ARCH, 0.0);
    found.share[CLOD_HOPPER_NO_ARCH] = 0.1;
    found.share[CLOD_HOPPER_FLOWS] = 0.2; // samples with an arch
    found.share[CLOD_HOPPER_FUNNEL] = 0.7;
    check_begins(&found,
                 "Mass flow is less likely than not: 70.0 % of the samples have none. As "
                 "measured, without errors, it is mass flow, and no cohesive arch stands "
                 "at any outlet: see the warnings.");
}

/** What is funnel flow as measured is not made mass flow by samples. */
static void funnel_flow_stays(void **state)
{
    (void)state;
    clod_hopper_found found = found_of(CLOD_HOPPER_FUNNEL, 0.0);
    found.share[CLOD_HOPPER_FUNNEL] = 0.9;
    found.wish.shape = CLOD_RADIAL_CONE;
    check_begins(&found, "Funnel flow: the solid does not slide along this wall.");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mass_flow_yields_where_most_samples_have_none),
        cmocka_unit_test(without_an_arch_too),
        cmocka_unit_test(funnel_flow_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
