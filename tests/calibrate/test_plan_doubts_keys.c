/**
 * @file test_plan_doubts_keys.c
 * Parameters that set keys of a tester are warned of, and those of the material are not.
 */

#include "plan_lab.h"

#define TARGET "number: phi_e, value: 40 deg, error: 1 deg"

/** Load a plan with this parameter; its warning about keys must have these words, or none be there. */
static void check(void **state, const char *key, const char *low, const char *high,
                  const char *words)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    const char *found = NULL;
    if (!lab_load_range(state, RING, key, low, high, TARGET, &plan, &status)) {
        fail_msg("%s", status.text);
    }
    for (size_t k = 0; k < plan.warnings.count; k++) {
        if (strstr(plan.warnings.text[k], "is no property of a material") != NULL) {
            found = plan.warnings.text[k];
        }
    }
    if (words == NULL) {
        assert_null(found);
    } else {
        assert_non_null(found);
        assert_non_null(strstr(found, words));
    }
    clod_plan_fini(&plan);
}

static void keys_of_a_tester(void **state)
{
    check(state, "ring_shear.preshear_stress", "50 kPa", "60 kPa",
          "parameters.p: ring_shear.preshear_stress is no property of a material");
    check(state, "ring_shear.speed", "15 mm/s", "30 mm/s",
          "parameters.p: ring_shear.speed is no");
    check(state, "time.safety", "0.1", "0.2", "parameters.p: time.safety is no");
    check(state, "ring_shear.outer_radius", "100 mm", "110 mm",
          "parameters.p: ring_shear.outer_radius is no");
}

static void softening(void **state)
{
    check(state, "contacts.soften", "1", "2",
          "parameters.p: contacts.soften is no property of a material: it divides stiffnesses");
}

static void keys_of_the_material(void **state)
{
    check(state, "materials.ore.density", "2400 kg/m3", "2600 kg/m3", NULL);
    check(state, ROLLING, "0.1", "0.2", NULL);
    check(state, "contacts.ore-base.friction", "0.5", "0.6", NULL);
    check(state, "ring_shear.radius.mean", "3.1 mm", "3.2 mm", NULL);
}

static void multiples_of_a_parameter(void **state)
{
    check(state, ROLLING ", multiples: {ring_shear.fill_adhesion: 1}", "0.1", "0.2",
          "parameters.p: ring_shear.fill_adhesion is no");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(keys_of_a_tester),
        TEST(softening),
        TEST(keys_of_the_material),
        TEST(multiples_of_a_parameter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
