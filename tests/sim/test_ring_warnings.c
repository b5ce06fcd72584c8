// The warning box of a shear test: texts with their remedies, from fabricated results.
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "sim/ring_warnings.h"
#include "tester/ring_shear.h"

#define PARTS 2 ///< preshear and the shear back

typedef struct box {
    clod_case from;
    clod_case_material ore;
    clod_part part[PARTS];
    clod_ring_shear test[PARTS];
} box;

static box now;

/** A ring 50 mm wide and 40 mm deep of grains of 2 mm, and nothing to warn of. */
static int make_box(void **state)
{
    (void)state;
    memset(&now, 0, sizeof now);
    now.ore = (clod_case_material){.name = "ore", .density = 2500.0};
    now.from.materials = &now.ore;
    now.from.material_count = 1;
    now.from.ring_shear = (clod_case_ring_shear){.present = true,
                                                 .grain_material = "ore",
                                                 .inner_radius = 0.05,
                                                 .outer_radius = 0.1,
                                                 .depth = 0.04,
                                                 .radius_mean = 1e-3};
    now.from.jenike = (clod_case_jenike){.grain_material = "ore",
                                         .diameter = 0.05,
                                         .base_height = 0.02,
                                         .ring_height = 0.02,
                                         .radius_mean = 1e-3};
    for (int p = 0; p < PARTS; p++) {
        now.part[p].point = p == 0 ? -1 : CLOD_RING_REVERSE;
        strcpy(now.part[p].name, p == 0 ? "preshear" : "reverse");
        now.part[p].test = &now.test[p];
        now.test[p] = (clod_ring_shear){.preshear_stress = 10e3,
                                        .preshear_normal = 10e3,
                                        .preshear_height = 0.04,
                                        .speed = 1e-3};
    }
    return 0;
}

/** The one warning there is; NULL when there is none. */
static const char *only_warning(json_t **list)
{
    *list = clod_ring_warnings(&now.from, now.part, PARTS);
    assert_true(json_array_size(*list) <= 1);
    return json_string_value(json_array_get(*list, 0));
}

static void nothing_is_wrong(void **state)
{
    (void)state;
    json_t *list;
    assert_null(only_warning(&list));
    json_decref(list);
}

/** A pause is no steady state: the slope stands beside the word, with its error. 1 kPa/mm is 1e6 Pa/m. */
static void a_steady_preshear_has_its_slope(void **state)
{
    (void)state;
    char words[CLOD_RING_WORDS_SIZE];
    now.test[0].preshear_displacement = 12.5e-3;
    now.test[0].preshear_rate = -0.034e6;
    now.test[0].preshear_rate_error = 0.08e6;
    assert_string_equal(clod_ring_preshear_words(&now.test[0], words),
                        "steady after 12.5 mm of shear, its slope -0.034 ± 0.08 kPa/mm");
    now.test[0].flags = CLOD_RING_SHEAR_NOT_STEADY;
    now.test[0].preshear_rate = 0.34e6;
    assert_string_equal(clod_ring_preshear_words(&now.test[0], words),
                        "still rising by 0.34 ± 0.08 kPa/mm after 12.5 mm of shear");
}

/** In a Jenike cell the rims may be what ends the way back. */
static void a_shear_stress_that_stays_has_a_remedy(void **state)
{
    (void)state;
    for (int straight = 0; straight < 2; straight++) {
        json_t *list;
        now.from.ring_shear.present = straight == 0;
        now.from.jenike.present = straight == 1;
        now.test[1].kind = straight ? CLOD_RING_SHEAR_JENIKE : CLOD_RING_SHEAR_RING;
        now.test[1].flags = CLOD_RING_SHEAR_NO_REVERSAL;
        const char *text = only_warning(&list);
        assert_non_null(strstr(text, "reverse: the shear stress did not fall to zero"));
        assert_non_null(strstr(text, "Look at reverse.csv"));
        assert_non_null(strstr(text, "raise the stiffness"));
        assert_non_null(strstr(text, "use a larger cell or smaller grains"));
        assert_int_equal(strstr(text, "jenike.rim") != NULL, straight);
        json_decref(list);
    }
}

/** The way of a Jenike cell is that of its offset and rim. */
static void a_longer_way_has_a_remedy(void **state)
{
    (void)state;
    for (int kind = 0; kind < CLOD_RING_SHEAR_KINDS; kind++) {
        const bool jenike = kind == CLOD_RING_SHEAR_JENIKE;
        json_t *list;
        now.from.ring_shear.present = !jenike;
        now.from.jenike.present = jenike;
        now.test[0].kind = now.test[1].kind = kind;
        now.test[0].preshear_dilation = 0.02;
        const char *end = strstr(only_warning(&list), "to go further");
        assert_string_equal(end,
                            jenike ? "to go further, with offset and rim" : "to go further");
        json_decref(list);
        now.test[0].preshear_dilation = 0.0;
        now.test[1].flags = CLOD_RING_SHEAR_NO_PEAK;
        end = strstr(only_warning(&list), "shear_max");
        assert_string_equal(end, jenike ? "shear_max with offset and rim" : "shear_max");
        json_decref(list);
        now.test[1].flags = 0;
    }
}

// 40 mm of height over grains of 10 mm: 4.
static void a_cell_that_is_too_small_has_a_remedy(void **state)
{
    (void)state;
    json_t *list;
    now.from.ring_shear.radius_mean = 5e-3;
    assert_string_equal(only_warning(&list),
                        "only 4.0 grain diameters across the specimen; 5 are wanted. Use a "
                        "larger cell or smaller grains");
    json_decref(list);
}

/** Nine tenths of the largest stable step are taken without a word, and a step that is not known
 *  to be too large. */
static void a_step_near_the_largest_stable_one_has_a_remedy(void **state)
{
    (void)state;
    static const struct {
        double dt, stable;
        const char *text;
    } STEPS[] = {
        {0.89e-6, 1e-6, NULL},
        {1e-6, 0.0, NULL},
        {1.5e-6, 1.2e-6,
         "reverse: the time step, 1.5e-06 s, is 1.2 of the largest stable one of the bed at its "
         "end, 1.2e-06 s: lower time.safety or time.step"},
    };
    for (size_t k = 0; k < sizeof STEPS / sizeof *STEPS; k++) {
        json_t *list;
        now.part[1].dt = STEPS[k].dt;
        now.part[1].stable_step = STEPS[k].stable;
        const char *found = only_warning(&list);
        if (STEPS[k].text == NULL) {
            assert_null(found);
        } else {
            assert_string_equal(found, STEPS[k].text);
        }
        json_decref(list);
    }
}

int main(void)
{
#define T(name) cmocka_unit_test_setup(name, make_box)
    const struct CMUnitTest tests[] = {
        T(nothing_is_wrong),
        T(a_steady_preshear_has_its_slope),
        T(a_shear_stress_that_stays_has_a_remedy),
        T(a_longer_way_has_a_remedy),
        T(a_cell_that_is_too_small_has_a_remedy),
        T(a_step_near_the_largest_stable_one_has_a_remedy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
