// A simulation that begins without grains, which the program adds.

#include <string.h>

#include "output/temp_folder.h"
#include "support/sim_made.h"

#define CASE_HEAD                                                                              \
    "materials: {ore: {density: 2500 kg/m3}, steel: {}}\n"                                     \
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}}\n"        \
    "domain: {min: [-50 mm, -50 mm, -5 mm], max: [50 mm, 50 mm, 200 mm]}\n"                    \
    "walls: {floor: {material: steel, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}]}}\n"      \
    "stages: [{name: fall, duration: 1 s}]\n"

static const char EMPTY[] = CASE_HEAD "time: {step: 1e-5 s, design_stress: 1 kPa}\n";

static double place_of(clod_sim *sim, uint64_t id, int axis)
{
    const clod_sim_view position = sim_view(sim, "position");
    const size_t row = clod_sim_row_of_id(sim, id);
    assert_true(row != SIZE_MAX);
    return clod_sim_row(&position, row)[axis];
}

static void add(clod_sim *sim, uint64_t id, double x)
{
    const clod_sim_grain grain = {.id = id, .position = {x, 0.0, 0.02}, .radius = 2e-3};
    CHECK(clod_sim_add_grain(sim, &grain, &status));
}

/** Free fall from 20 mm to the floor takes sqrt(2 h/g) for h = 18 mm: 60.6 ms; then it rests. */
static void grains_fall_into_an_empty_domain(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 3; threads += 2) {
        clod_sim *sim = sim_made(EMPTY, threads);
        assert_int_equal(clod_sim_grain_count(sim), 0);
        CHECK(clod_sim_advance(sim, 100, &status)); // nothing happens
        add(sim, 7, 0.0);
        CHECK(clod_sim_advance(sim, 3000, &status)); // 30 ms
        check_relative(place_of(sim, 7, 2), 0.02 - 0.5 * 9.81 * 9e-4, 1e-12);
        add(sim, 8, 0.01);
        CHECK(clod_sim_advance(sim, 40000, &status));
        assert_int_equal(clod_sim_grain_count(sim), 2);
        const double weight = 2500.0 * 4.0 / 3.0 * M_PI * 8e-9 * 9.81;
        check_relative(place_of(sim, 7, 2), 2e-3 - weight / 1e4, 1e-6);
        check_relative(place_of(sim, 8, 2), 2e-3 - weight / 1e4, 1e-6);
        clod_sim_destroy(&sim);
    }
}

/** It goes on from a checkpoint written while it was empty, and when emptied again. */
static void an_empty_state_is_kept_in_a_checkpoint(void **state)
{
    char folder[PATH_MAX];
    snprintf(folder, sizeof folder, "%s/run", (const char *)*state);
    clod_sim *sim = sim_made(EMPTY, 1);
    CHECK(clod_sim_advance(sim, 10, &status));
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    clod_sim *later = sim_made(EMPTY, 1);
    CHECK(clod_sim_read_checkpoint(later, folder, NULL, &status));
    assert_int_equal(clod_sim_grain_count(later), 0);
    clod_sim *both[] = {sim, later};
    for (int k = 0; k < 2; k++) {
        add(both[k], 1, 0.0);
        CHECK(clod_sim_advance(both[k], 10000, &status));
    }
    assert_true(place_of(sim, 1, 2) == place_of(later, 1, 2));
    CHECK(clod_sim_remove_grain(sim, 1, &status));
    CHECK(clod_sim_advance(sim, 10, &status));
    assert_int_equal(clod_sim_grain_count(sim), 0);
    clod_sim_destroy(&sim);
    clod_sim_destroy(&later);
}

/** Nothing tells the load before grains are there; and a grain too light for the step is refused. */
static void what_an_empty_case_must_say(void **state)
{
    (void)state;
    static const char *const WRONG[] = {"time: {step: 1e-5 s}\n",
                                        "time: {design_stress: 1 kPa}\n"};
    for (size_t k = 0; k < 2; k++) {
        char text[1024];
        snprintf(text, sizeof text, "%s%s", CASE_HEAD, WRONG[k]);
        expect_refused(clod_sim_create_from_text("case.yaml", text, NULL, &status) != NULL,
                       "give domain, time.step and time.design_stress");
    }
    clod_sim *sim = sim_made(EMPTY, 1);
    const clod_sim_grain dust = {.id = 1, .position = {0.0, 0.0, 0.1}, .radius = 1e-5};
    CHECK(clod_sim_add_grain(sim, &dust, &status));
    expect_refused(clod_sim_change(sim, &status), "the run would blow up");
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grains_fall_into_an_empty_domain),
        cmocka_unit_test_setup_teardown(an_empty_state_is_kept_in_a_checkpoint,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test(what_an_empty_case_must_say),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
