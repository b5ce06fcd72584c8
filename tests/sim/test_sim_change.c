// Grains and walls that come and go through the library's object.

#include <stdint.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/sim_made.h"

static const char CASE[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}}\n"
    "time: {step: 1e-5 s}\n"
    "domain: {min: [-50 mm, -50 mm, -5 mm], max: [50 mm, 50 mm, 200 mm]}\n"
    "stages: [{name: fall, duration: 1 s}]\n"
    "walls:\n"
    "  floor: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, "
    "1]}}]}\n"
    "  sides: {material: ore, shapes: [\n"
    "    {plane: {point: [-12 mm, 0 mm, 0 mm], normal: [1, 0, 0]}},\n"
    "    {plane: {point: [12 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}},\n"
    "    {plane: {point: [0 mm, -12 mm, 0 mm], normal: [0, 1, 0]}},\n"
    "    {plane: {point: [0 mm, 12 mm, 0 mm], normal: [0, -1, 0]}}]}\n"
    "grains:\n"
    "  - {material: ore, count: 30, radius: {distribution: uniform, min: 2 mm, max: 2 mm}, "
    "region: {box: {min: [-10 mm, -10 mm, 4 mm], max: [10 mm, 10 mm, 40 mm]}}}\n";

/** Grains of ore, and a wall of rubber. */
static const char TWO[] =
    "materials: {ore: {density: 2500 kg/m3}, rubber: {density: 1200 kg/m3}}\n"
    "contacts:\n"
    "  ore-ore: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}\n"
    "  ore-rubber: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}\n"
    "time: {step: 1e-5 s}\n"
    "domain: {min: [-50 mm, -50 mm, -5 mm], max: [50 mm, 50 mm, 200 mm]}\n"
    "stages: [{name: fall, duration: 1 s}]\n"
    "walls: {floor: {material: rubber, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}]}}\n"
    "grains:\n"
    "  - {material: ore, count: 2, radius: {distribution: uniform, min: 2 mm, max: 2 mm}, "
    "region: {box: {min: [-10 mm, -10 mm, 4 mm], max: [10 mm, 10 mm, 40 mm]}}}\n";

static clod_sim *make(void)
{
    static char simd[8]; // the caller's: something else when the simulation is there
    memcpy(simd, "scalar", 7);
    const clod_sim_options options = {.threads = 1, .simd = simd};
    clod_sim *sim = clod_sim_create_from_text("case.yaml", CASE, &options, &status);
    CHECK(sim != NULL);
    memcpy(simd, "gone", 5);
    return sim;
}

static double *numbers(clod_sim *sim, const char *name, uint64_t id)
{
    clod_sim_view view;
    CHECK(clod_sim_array(sim, name, &view, &status));
    const size_t row = clod_sim_row_of_id(sim, id);
    assert_true(row != SIZE_MAX);
    return clod_sim_row(&view, row);
}

/** A grain in free flight: z = z0 - g t (t + dt)/2 in velocity Verlet is z0 - g t^2/2. */
static void a_new_grain_flies_as_it_should(void **state)
{
    (void)state;
    clod_sim *sim = make();
    CHECK(clod_sim_advance(sim, 500, &status));
    const clod_sim_grain grain = {.id = 900,
                                  .position = {0.003, 0.003, 0.19},
                                  .radius = 1e-3,
                                  .velocity = {-0.1, 0.0, 0.2}};
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    CHECK(clod_sim_advance(sim, 1000, &status)); // 10 ms
    assert_int_equal(clod_sim_grain_count(sim), 31);
    const double *at = numbers(sim, "position", 900);
    check_relative(at[0], 0.003 - 0.1 * 0.01, 1e-12);
    check_relative(at[2], 0.19 + 0.2 * 0.01 - 0.5 * 9.81 * 1e-4, 1e-12);
    check_relative(*numbers(sim, "mass", 900), 2500.0 * 4.0 / 3.0 * M_PI * 1e-9, 1e-14);
    clod_sim_destroy(&sim);
}

/** Two equal grains, k1 = 1e4 N/m without adhesion: T/pi = 2 sqrt(m/(2 k)) with k the stiffest
 *  tangent. Much smaller ones are refused, and the simulation goes on as if not asked. */
static void a_grain_too_small_for_the_step_is_refused(void **state)
{
    (void)state;
    clod_sim *sim = make();
    const double mass = 2500.0 * 4.0 / 3.0 * M_PI * 1e-12; // radius 0.1 mm
    const double longest = 2.0 * sqrt(0.5 * mass / 1e4);   // s, of the normal spring: 1.4 us
    clod_sim_grain grain = {.id = 900, .position = {0.0, 0.0, 0.15}, .radius = 1e-4};
    assert_true(longest < clod_sim_dt(sim));
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    expect_refused(clod_sim_change(sim, &status),
                   "with grain 900 (radius 0.1 mm) the time step of 1e-05 s is beyond");
    grain.id = 901;
    grain.radius = 1e-3; // 45 us
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    CHECK(clod_sim_advance(sim, 10, &status));
    assert_int_equal(clod_sim_grain_count(sim), 31);
    assert_true(clod_sim_row_of_id(sim, 900) == SIZE_MAX);
    clod_sim_destroy(&sim);
    sim = clod_sim_create_from_text("two.yaml", TWO, NULL, &status);
    CHECK(sim != NULL);
    grain.material = 1; // of rubber, and there is no law between rubber and rubber
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    expect_refused(clod_sim_change(sim, &status),
                   "no contact law for grains of 'rubber' with grains of 'rubber'");
    clod_sim_destroy(&sim);
}

static void a_grain_that_went_is_gone(void **state)
{
    (void)state;
    clod_sim *sim = make();
    CHECK(clod_sim_advance(sim, 30000, &status));
    clod_sim_view id;
    CHECK(clod_sim_array(sim, "id", &id, &status));
    const uint64_t first = *(const uint64_t *)id.data;
    CHECK(clod_sim_remove_grain(sim, first, &status));
    CHECK(clod_sim_change(sim, &status));
    assert_int_equal(clod_sim_grain_count(sim), 29);
    assert_true(clod_sim_row_of_id(sim, first) == SIZE_MAX);
    const clod_sim_contact *contacts;
    size_t count;
    CHECK(clod_sim_contacts(sim, &contacts, &count, &status));
    assert_true(count > 5);
    for (size_t k = 0; k < count; k++) {
        assert_true(contacts[k].id_1 != first &&
                    (contacts[k].wall >= 0 || contacts[k].id_2 != first));
    }
    CHECK(clod_sim_advance(sim, 100, &status));
    clod_sim_destroy(&sim);
}

/** All that rests on the floor falls when it goes, and rests on the one that comes. */
static void walls_come_and_go(void **state)
{
    (void)state;
    clod_sim *sim = make();
    CHECK(clod_sim_advance(sim, 30000, &status));
    CHECK(clod_sim_remove_wall(sim, "floor", &status));
    clod_case_shape plane = {.kind = CLOD_SHAPE_PLANE, .normal = {0.0, 0.0, 1.0}};
    plane.point[2] = -0.001;
    const clod_case_wall lower = {
        .name = "lower", .material = "ore", .shapes = &plane, .shape_count = 1};
    CHECK(clod_sim_add_wall(sim, &lower, &status));
    CHECK(clod_sim_advance(sim, 1, &status));
    assert_int_equal(clod_sim_wall_count(sim), 2);
    assert_int_equal(clod_sim_wall_index(sim, "floor"), -1);
    clod_sim_wall wall;
    const int32_t lowest = clod_sim_wall_index(sim, "lower");
    CHECK(clod_sim_wall_look(sim, lowest, &wall, &status));
    assert_string_equal(wall.name, "lower");
    assert_true(wall.force[2] == 0.0); // 1 mm below
    CHECK(clod_sim_advance(sim, 40000, &status));
    CHECK(clod_sim_wall_look(sim, lowest, &wall, &status));
    const double weight = 30.0 * 2500.0 * 4.0 / 3.0 * M_PI * 8e-9 * 9.81;
    check_relative(-wall.force[2], weight, 0.02); // at rest but for a little
    clod_sim_destroy(&sim);
}

/** A wrong request does not make clod forget that positions were written. */
static void moved_grains_are_seen_after_a_wrong_request(void **state)
{
    (void)state;
    clod_sim *sim = make();
    CHECK(clod_sim_advance(sim, 10, &status)); // all of them fall freely, above 4 mm
    numbers(sim, "position", 7)[2] = 0.0019;   // 0.1 mm into the floor
    CHECK(clod_sim_positions_changed(sim, &status));
    CHECK(clod_sim_remove_grain(sim, 999, &status));
    assert_false(clod_sim_advance(sim, 1, &status));
    CHECK(clod_sim_advance(sim, 1, &status));
    assert_true(numbers(sim, "force", 7)[2] > 0.5 * 1e4 * 1e-4); // k1 times overlap: 1 N
    clod_sim_destroy(&sim);
}

/** A checkpoint knows the walls that came and went: going on from it changes no bit. */
static void changed_walls_are_in_checkpoints(void **temporary)
{
    const char *folder = *temporary;
    clod_sim *sim = make();
    CHECK(clod_sim_advance(sim, 20000, &status));
    CHECK(clod_sim_remove_wall(sim, "floor", &status));
    clod_case_shape disc = {.kind = CLOD_SHAPE_DISC,
                            .point = {0.0, 0.0, -0.002},
                            .normal = {0.05, 0.0, 1.0},
                            .radius = 0.03,
                            .surface = {.velocity = {0.01, 0.0, 0.0}}};
    const clod_case_wall slope = {
        .name = "slope", .material = "ore", .shapes = &disc, .shape_count = 1};
    CHECK(clod_sim_add_wall(sim, &slope, &status));
    CHECK(clod_sim_advance(sim, 3000, &status));
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    clod_sim *again = make();
    CHECK(clod_sim_read_checkpoint(again, folder, NULL, &status));
    assert_int_equal(clod_sim_wall_count(again), 2);
    assert_int_equal(clod_sim_wall_index(again, "floor"), -1);
    CHECK(clod_sim_advance(sim, 2000, &status));
    CHECK(clod_sim_advance(again, 2000, &status));
    clod_sim_wall view, other;
    CHECK(clod_sim_wall_look(sim, clod_sim_wall_index(sim, "slope"), &view, &status));
    CHECK(clod_sim_wall_look(again, clod_sim_wall_index(again, "slope"), &other, &status));
    assert_true(view.force[2] < 0.0);
    assert_memory_equal(view.force, other.force, sizeof view.force);
    for (uint64_t id = 1; id <= 30; id++) {
        assert_memory_equal(numbers(sim, "position", id), numbers(again, "position", id), 24);
    }
    clod_sim_destroy(&sim);
    clod_sim_destroy(&again);
}

static void wrong_requests_are_refused(void **state)
{
    (void)state;
    clod_sim *sim = make();
    clod_sim_grain grain = {.id = 900, .position = {0.0, 0.0, 0.1}, .radius = 1e-3};
    expect_refused(clod_sim_add_grain(sim, NULL, &status), "clod_sim_add_grain: grain is NULL");
    expect_refused(clod_sim_remove_wall(sim, NULL, &status), "name is NULL");
    grain.material = 1;
    expect_refused(clod_sim_add_grain(sim, &grain, &status), "the case has 1");
    grain.material = 0;
    grain.position[0] = 1.0;
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    expect_refused(clod_sim_change(sim, &status), "outside of the domain");
    CHECK(clod_sim_remove_grain(sim, 12345, &status));
    expect_refused(clod_sim_advance(sim, 1, &status), "there is none with this id");
    clod_case_shape plane = {.kind = CLOD_SHAPE_PLANE, .normal = {0.0, 0.0, 1.0}};
    clod_case_wall wall = {
        .name = "lower", .material = "wood", .shapes = &plane, .shape_count = 1};
    expect_refused(clod_sim_add_wall(sim, &wall, &status), "no material 'wood'");
    wall.material = "ore";
    wall.name = "floor";
    CHECK(clod_sim_add_wall(sim, &wall, &status));
    expect_refused(clod_sim_change(sim, &status), "another one has this name");
    assert_int_equal(clod_sim_grain_count(sim), 30);
    CHECK(clod_sim_advance(sim, 10, &status)); // and it goes on
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_new_grain_flies_as_it_should),
        cmocka_unit_test(a_grain_too_small_for_the_step_is_refused),
        cmocka_unit_test(a_grain_that_went_is_gone),
        cmocka_unit_test(walls_come_and_go),
        cmocka_unit_test(moved_grains_are_seen_after_a_wrong_request),
        cmocka_unit_test_setup_teardown(changed_walls_are_in_checkpoints, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test(wrong_requests_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
