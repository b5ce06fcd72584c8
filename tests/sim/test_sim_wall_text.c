// A wall that comes as a text: it is the wall that the same text makes in a case.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "support/sim_made.h"

#define HEAD                                                                                   \
    "materials: {ore: {density: 2500 kg/m3}, rubber: {}, wood: {}}\n"                          \
    "contacts:\n"                                                                              \
    "  ore-ore: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}\n"                  \
    "  ore-rubber: {law: hooke, k1: 1e4 N/m, restitution: 0.3, friction: 0.8}\n"               \
    "time: {step: 1e-5 s}\n"                                                                   \
    "domain: {min: [-50 mm, -50 mm, -50 mm], max: [50 mm, 50 mm, 200 mm]}\n"                   \
    "stages: [{name: fall, duration: 1 s}]\n"                                                  \
    "grains:\n"                                                                                \
    "  - {material: ore, count: 20, radius: {distribution: uniform, min: 2 mm, max: 2 mm},\n"  \
    "     region: {box: {min: [-9 mm, -9 mm, 40 mm], max: [9 mm, 9 mm, 60 mm]}}}\n"            \
    "walls:\n"                                                                                 \
    "  floor: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, -20 mm]}}]}\n"

static clod_sim_wall wall_of(clod_sim *sim)
{
    clod_sim_wall wall;
    CHECK(clod_sim_wall_look(sim, clod_sim_wall_index(sim, "slope"), &wall, &status));
    return wall;
}

/** Walls below the grains, of every shape, with all that a wall may have. */
static const char *const WALLS[] = {
    "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 20 mm], normal: [0.2, 0, 1]}}]}",
    "{material: ore, velocity: [0 m/s, 0 m/s, 0.02 m/s], shapes: [{disc: {center: [0 mm, 0 mm, "
    "20 mm], radius: 30 mm, surface: {material: rubber, speed: 0.2 m/s, direction: [0, 1, "
    "0]}}}]}",
    "{material: ore, spin: 20 rpm, shapes: [{annulus: {center: [0 mm, 0 mm, 20 mm], "
    "inner_radius: 1 mm, outer_radius: 20 mm}}]}",
    "{material: rubber, shapes: [{cylinder: {foot: [-30 mm, 0 mm, 20 mm], axis: [1, 0, 0], "
    "radius: 8 mm, length: 60 mm, side: outside}}], surface_velocity: [0.1 m/s, 0 m/s, 0 m/s]}",
    "{material: ore, shapes: [{cone: {foot: [0 mm, 0 mm, 10 mm], foot_radius: 1 mm, "
    "top_radius: 25 mm, length: 20 mm}}]}",
    "{material: ore, shapes: [{box: {center: [0 mm, 0 mm, 20 mm], size: [40 mm, 40 mm, 3 mm]}}],"
    " rotate: {axis: [0, 1, 0], angle: 20 deg, point: [0 mm, 0 mm, 20 mm]}, move: [1 mm, 0 mm, "
    "-1 mm]}",
    "material: ore\nshapes:\n  - bar: {from: [-30 mm, 0 mm, 20 mm], to: [30 mm, 1 mm, 20 mm], "
    "width: 20 mm, height: 3 mm}\n",
    "{material: ore, load: {axis: [0, 0, 1], force: 0.5 N, mass: 100 g}, shapes: [{disc: "
    "{center: [0 mm, 0 mm, 20 mm], radius: 30 mm}}]}",
    "{material: ore, oscillation: {direction: [1, 0, 1], amplitude: 2 mm, angle: 5 deg, "
    "frequency: 80 Hz, phase: 1 rad}, shapes: [{box: {center: [0 mm, 0 mm, 20 mm], size: [40 "
    "mm, 40 mm, 3 mm]}}]}",
    "{\"material\": \"rubber\", \"shapes\": [{\"box\": {\"center\": \"0 0 20 mm\", \"size\": "
    "[\"40 mm\", \"40 mm\", \"3 mm\"]}}]}", // JSON
};

/** The text of a case whose last wall this is. */
static void write_case(const char *wall, char *text, size_t size)
{
    if (wall[0] == '{') {
        snprintf(text, size, HEAD "  slope: %s\n", wall);
        return;
    }
    snprintf(text, size,
             HEAD
             "  slope:\n    material: ore\n    shapes:\n      - bar: {from: [-30 mm, 0 mm, "
             "20 mm], to: [30 mm, 1 mm, 20 mm], width: 20 mm, height: 3 mm}\n");
}

static void it_is_the_wall_of_a_case(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof WALLS / sizeof *WALLS; k++) {
        char text[4096];
        write_case(WALLS[k], text, sizeof text);
        clod_sim *given = sim_made(text, 1), *added = sim_made(HEAD, 1);
        CHECK(clod_sim_add_wall_from_text(added, "slope", WALLS[k], &status));
        CHECK(clod_sim_advance(given, 12000, &status));
        CHECK(clod_sim_advance(added, 12000, &status));
        const clod_sim_view x = sim_view(given, "position"), y = sim_view(added, "position");
        assert_int_equal(x.rows, 20);
        for (size_t g = 0; g < x.rows; g++) {
            assert_memory_equal(clod_sim_row(&x, g), clod_sim_row(&y, g), 24);
        }
        const clod_sim_wall a = wall_of(given), b = wall_of(added);
        assert_memory_equal(a.mean_force, b.mean_force, sizeof a.mean_force);
        assert_memory_equal(a.position, b.position, sizeof a.position);
        assert_true(a.mean_force[2] < 0.0 && a.angle == b.angle &&
                    a.mean_power == b.mean_power);
        clod_sim_destroy(&given);
        clod_sim_destroy(&added);
    }
}

static const struct {
    const char *name, *text, *words;
} WRONG[] = {
    {"a", "", "wall 'a':1:1: is empty"},
    {"a", "{material: ore, shapes: [{plane: {pint: [0 mm, 0 mm, 0 mm]}}]}",
     "wall 'a':1:35: walls.a.shapes.0.plane.pint: this key is not known"},
    {"a", "{material: ore, shapes: [{plane: {point: [1, 0, 0]}}]}", "unit"},
    {"a", "{material: stone, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}]}",
     "walls.a.material: there is no material stone"},
    {"a",
     "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], surface: {material: tin}}}]}",
     "there is no material tin"},
    {"a",
     "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], surface: {velocity: [1 m/s, "
     "0 m/s, 0 m/s], spin_axis: [1, 0, 0]}}}]}",
     "without spin nothing turns about it"},
    {"a", "{material: ore}", "needs the key shapes"},
    {"a", "{material: ore, shapes: []}", "has no elements"},
    {"a", "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]",
     "wall 'a':2:1: not YAML"},
    {"a", "ore", "must be a section with keys"},
    {"a", "{material: ore, shapes: [{disc: {center: [0 mm, 0 mm, 0 mm], radius: -1 mm}}]}",
     "out of range"},
    {"a",
     "{material: ore, shapes: [{bar: {from: [0 mm, 0 mm, 0 mm], to: [0 mm, 0 mm, 0 mm], width: "
     "1 mm, height: 1 mm}}]}",
     "the bar has no length"},
    {"a b", "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}]}", "is not a name"},
    {"a",
     "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}], load: {axis: [0, 0, -1], "
     "mass: 1 kg}}",
     "wall 'a':1:65: walls.a.load: must have exactly one of force, stress"},
    {"a",
     "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}], load: {force: 1 N, mass: 1 "
     "kg}, oscillation: {amplitude: 1 mm, frequency: 50 Hz}}",
     "is not across the axis of the load"},
    {"a",
     "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}], oscillation: {amplitude: "
     "1 mm, frequency: 2.1 kHz}}",
     "walls.a.oscillation.frequency: 2100 Hz is too fast for the time step"},
    {"a", "{material: wood, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}]}",
     "no contact law for grains of 'ore' with a wall of 'wood'; add the section ore-wood"},
    {"a",
     "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], surface: {material: "
     "wood}}}]}",
     "no contact law for grains of 'ore' with a wall of 'wood'"},
};

static void what_is_wrong_is_told_as_in_a_case(void **state)
{
    (void)state;
    clod_sim *sim = sim_made(HEAD, 1);
    for (size_t k = 0; k < sizeof WRONG / sizeof *WRONG; k++) {
        status = (clod_status){0};
        expect_refused(
            clod_sim_add_wall_from_text(sim, WRONG[k].name, WRONG[k].text, &status) &&
                clod_sim_change(sim, &status),
            WRONG[k].words);
    }
    assert_false(clod_sim_add_wall_from_text(sim, NULL, "", &status));
    assert_non_null(strstr(status.text, "clod_sim_add_wall_from_text: name is NULL"));
    assert_false(clod_sim_add_wall_from_text(sim, "a", NULL, &status));
    assert_non_null(strstr(status.text, "text is NULL"));
    CHECK(clod_sim_add_wall_from_text(sim, "floor", WALLS[0], &status)); // told when it is done
    assert_false(clod_sim_change(sim, &status));
    assert_non_null(strstr(status.text, "another one has this name"));
    assert_int_equal(clod_sim_wall_count(sim), 1);
    CHECK(clod_sim_advance(sim, 10, &status));
    clod_sim_destroy(&sim);
}

/** As a struct: a material of a shape that the case does not have. */
static void a_struct_with_an_unknown_surface_is_refused(void **state)
{
    (void)state;
    clod_sim *sim = sim_made(HEAD, 1);
    char tin[] = "tin";
    clod_case_shape plane = {
        .kind = CLOD_SHAPE_PLANE, .normal = {0.0, 0.0, 1.0}, .surface = {.material = tin}};
    const clod_case_wall wall = {
        .name = "lower", .material = "ore", .shapes = &plane, .shape_count = 1};
    assert_false(clod_sim_add_wall(sim, &wall, &status));
    assert_non_null(strstr(status.text, "clod_sim_add_wall: the case has no material 'tin'"));
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_the_wall_of_a_case),
        cmocka_unit_test(what_is_wrong_is_told_as_in_a_case),
        cmocka_unit_test(a_struct_with_an_unknown_surface_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
