/** Walls with a load, and walls that oscillate, which come during a simulation. */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/sim_made.h"

#define DT 1e-5     // s
#define RADIUS 2e-3 // m
#define STIFF 1e4   // N/m, of every contact
#define COUNT 30    // grains

/** Grains in a box; no wall of the case moves. */
#define HEAD                                                                                   \
    "materials: {ore: {density: 2500 kg/m3}}\n"                                                \
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}}\n"        \
    "time: {step: 1e-5 s}\n"                                                                   \
    "domain: {min: [-50 mm, -50 mm, -5 mm], max: [50 mm, 50 mm, 200 mm]}\n"                    \
    "stages: [{name: fall, duration: 1 s}]\n"                                                  \
    "grains:\n"                                                                                \
    "  - {material: ore, count: 30, radius: {distribution: uniform, min: 2 mm, max: 2 mm},\n"  \
    "     region: {box: {min: [-10 mm, -10 mm, 4 mm], max: [10 mm, 10 mm, 40 mm]}}}\n"         \
    "walls:\n"                                                                                 \
    "  sides: {material: ore, shapes: [\n"                                                     \
    "    {plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}},\n"                           \
    "    {plane: {point: [-12 mm, 0 mm, 0 mm], normal: [1, 0, 0]}},\n"                         \
    "    {plane: {point: [12 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}},\n"                         \
    "    {plane: {point: [0 mm, -12 mm, 0 mm], normal: [0, 1, 0]}},\n"                         \
    "    {plane: {point: [0 mm, 12 mm, 0 mm], normal: [0, -1, 0]}}]}\n"

/** Turns and moves to and fro, high above the grains. */
#define SHAKER                                                                                 \
    "{material: ore, oscillation: {direction: [3, 0, 4], amplitude: 2 mm, angle: 0.3 rad, "    \
    "frequency: 37 Hz, phase: 50 deg}, shapes: [{box: {center: [0 mm, 0 mm, 150 mm], size: "   \
    "[10 mm, 4 mm, 2 mm]}}]}"

static clod_sim_wall look(clod_sim *sim, const char *name)
{
    clod_sim_wall wall;
    CHECK(clod_sim_wall_look(sim, clod_sim_wall_index(sim, name), &wall, &status));
    return wall;
}

static void add(clod_sim *sim, const char *name, const char *text)
{
    CHECK(clod_sim_add_wall_from_text(sim, name, text, &status));
}

/** Highest point of the grains [m]. */
static double top_of(clod_sim *sim)
{
    const clod_sim_view position = sim_view(sim, "position");
    double top = 0.0;
    for (size_t g = 0; g < position.rows; g++) {
        top = fmax(top, ((const double *)clod_sim_row(&position, g))[2] + RADIUS);
    }
    return top;
}

/** Put a lid of 0.1 kg with a load just above the grains: text of it. */
static void put_lid(clod_sim *sim, const char *load)
{
    char text[512];
    snprintf(text, sizeof text,
             "{material: ore, load: {%s, mass: 0.1 kg}, shapes: [{plane: {point: [0 mm, 0 mm, "
             "%.9f m], normal: [0, 0, -1]}}]}",
             load, top_of(sim) + 1e-4);
    add(sim, "lid", text);
}

/** At rest the grains carry the load, whatever the weight of the lid, and the floor both. */
static void a_lid_ends_with_its_load(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(HEAD, 1);
    CHECK(clod_sim_advance(sim, 30000, &status));
    put_lid(sim, "force: 2 N");
    CHECK(clod_sim_change(sim, &status));
    clod_sim_wall lid = look(sim, "lid");
    assert_true(lid.loaded && lid.load == 2.0 && lid.force[2] == 0.0);
    CHECK(clod_sim_advance(sim, 60000, &status));
    lid = look(sim, "lid");
    check_relative(lid.force[2], 2.0, 2e-3);
    assert_true(lid.position[2] < -1e-4 && fabs(lid.material_velocity[2]) < 1e-3);
    const double weight = COUNT * 2500.0 * 4.0 / 3.0 * M_PI * RADIUS * RADIUS * RADIUS * 9.81;
    check_relative(-look(sim, "sides").force[2], 2.0 + weight, 2e-2);
    CHECK(clod_sim_set_wall_load(sim, clod_sim_wall_index(sim, "lid"), 3.0, &status));
    CHECK(clod_sim_advance(sim, 40000, &status));
    check_relative(look(sim, "lid").force[2], 3.0, 2e-3);
    clod_sim_destroy(&sim);
}

/** Without damping and contact every step adds dt F/m to its speed at its end: after n steps it has
 *  moved by F/m dt^2 n (n - 1)/2. */
static void a_free_wall_is_accelerated(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(HEAD, 1);
    CHECK(clod_sim_advance(sim, 777, &status));
    add(sim, "kite",
        "{material: ore, load: {axis: [0, 2, 0], force: 3 N, mass: 0.5 kg, damping: 0}, "
        "shapes: [{box: {center: [0 mm, 0 mm, 150 mm], size: [4 mm, 4 mm, 2 mm]}}]}");
    const double n = 1000.0;
    CHECK(clod_sim_advance(sim, 1000, &status));
    const clod_sim_wall kite = look(sim, "kite");
    check_relative(kite.position[1], 3.0 / 0.5 * DT * DT * n * (n - 1.0) / 2.0, 1e-12);
    check_relative(kite.material_velocity[1], 3.0 / 0.5 * DT * n, 1e-12);
    assert_true(kite.position[0] == 0.0 && kite.position[2] == 0.0);
    clod_sim_destroy(&sim);
}

/** N s/m by hand (docs/theory/walls.md): z of critical, against a bed of `count` grains under
 *  4 cm2 of which each column has height/(2R) contacts. */
static double damping_by_hand(double z, double mass, double count)
{
    const double area = 4e-4;
    const double volume = count * 4.0 / 3.0 * M_PI * RADIUS * RADIUS * RADIUS;
    const double columns = area / (4.0 * RADIUS * RADIUS);
    const double contacts = volume / (0.6 * area) / (2.0 * RADIUS);
    return 2.0 * z * sqrt(STIFF * columns / contacts * mass);
}

/** A lid without grains at it ends with load over damping; that is of the grains that there are when
 *  it comes, with those that come beside it and without those that go. */
static void its_damping_is_that_of_the_bed(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(HEAD, 1);
    static const char RISER[] =
        "{material: ore, load: {axis: [0, 0, 1], stress: 500 Pa, area: 4 cm2, mass: 20 g, "
        "damping: 2}, shapes: [{box: {center: [0 mm, 0 mm, 100 mm], size: [4 mm, 4 mm, "
        "2 mm]}}]}";
    CHECK(clod_sim_advance(sim, 100, &status));
    add(sim, "first", RISER);
    CHECK(clod_sim_advance(sim, 500, &status)); // m/c is 30 us
    check_relative(look(sim, "first").material_velocity[2],
                   500.0 * 4e-4 / damping_by_hand(2.0, 0.02, COUNT), 1e-9);
    add(sim, "second", RISER);
    for (uint64_t k = 0; k < 20; k++) {
        const clod_sim_grain grain = {.id = 900 - k,
                                      .position = {-7.5e-3 + 5e-3 * (double)(k % 4),
                                                   -1e-2 + 5e-3 * (double)(k / 4), 0.15},
                                      .radius = RADIUS};
        CHECK(clod_sim_add_grain(sim, &grain, &status));
    }
    CHECK(clod_sim_remove_grain(sim, 1, &status));
    CHECK(clod_sim_remove_grain(sim, COUNT, &status));
    CHECK(clod_sim_advance(sim, 500, &status));
    check_relative(look(sim, "second").material_velocity[2],
                   500.0 * 4e-4 / damping_by_hand(2.0, 0.02, COUNT + 18), 1e-9);
    check_relative(look(sim, "first").material_velocity[2],
                   500.0 * 4e-4 / damping_by_hand(2.0, 0.02, COUNT), 1e-9);
    clod_sim_destroy(&sim);
}

/** Where there are no grains nothing damps it, and it moves. */
static void without_grains_there_is_no_damping(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(
        "materials: {ore: {density: 2500 kg/m3}}\n"
        "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}}\n"
        "time: {step: 1e-5 s, design_stress: 1 kPa}\n"
        "domain: {min: [-50 mm, -50 mm, -5 mm], max: [50 mm, 50 mm, 200 mm]}\n"
        "stages: [{name: fall, duration: 1 s}]\n"
        "walls: {press: {material: ore, load: {force: 1 N, mass: 1 kg}, shapes: [{disc: "
        "{center: [0 mm, 0 mm, 100 mm], radius: 1 cm}}]}}\n",
        1);
    add(sim, "lid",
        "{material: ore, load: {force: 1 N, mass: 1 kg}, shapes: [{disc: {center: [0 mm, 0 mm, "
        "50 mm], radius: 1 cm}}]}");
    CHECK(clod_sim_advance(sim, 1000, &status));
    const double fallen = DT * DT * 1000.0 * 999.0 / 2.0;
    check_relative(-look(sim, "lid").position[2], fallen, 1e-12);
    check_relative(-look(sim, "press").position[2], fallen, 1e-12);
    clod_sim_destroy(&sim);
}

/** Phase and time are those of the simulation: a wall that comes late is where the same wall of
 *  the case is, to the bits, on x = a sin(2 pi f t + phase). */
static void an_oscillation_is_that_of_the_case(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(HEAD, 1), *other = sim_made(HEAD "  shaker: " SHAKER "\n", 1);
    CHECK(clod_sim_advance(sim, 12345, &status));
    CHECK(clod_sim_advance(other, 12345, &status));
    add(sim, "shaker", SHAKER);
    CHECK(clod_sim_change(sim, &status));
    for (int k = 0; k < 5; k++) {
        const double x = sin(2.0 * M_PI * 37.0 * clod_sim_time(sim) + 50.0 * M_PI / 180.0);
        const clod_sim_wall here = look(sim, "shaker"), there = look(other, "shaker");
        check_close(here.position[0], 0.6 * 2e-3 * x, 1e-15);
        check_close(here.position[2], 0.8 * 2e-3 * x, 1e-15);
        check_close(here.angle, 0.3 * x, 1e-12);
        assert_memory_equal(here.position, there.position, sizeof here.position);
        assert_memory_equal(here.material_velocity, there.material_velocity,
                            sizeof here.material_velocity);
        assert_true(here.angle == there.angle && here.material_spin == there.material_spin);
        CHECK(clod_sim_advance(sim, 1111, &status));
        CHECK(clod_sim_advance(other, 1111, &status));
    }
    clod_sim_destroy(&sim);
    clod_sim_destroy(&other);
}

/** A lid on the bed, and a base below it that shakes it sideways. */
static void shake(clod_sim *sim)
{
    put_lid(sim, "force: 1 N, damping: 0.1");
    add(sim, "shaker",
        "{material: ore, oscillation: {direction: [1, 0, 0], amplitude: 1 mm, frequency: "
        "100 Hz}, shapes: [{disc: {center: [0 mm, 0 mm, 0.01 mm], radius: 16 mm}}]}");
}

static void check_same(clod_sim *sim, clod_sim *other)
{
    const clod_sim_view a = sim_view(sim, "position"), b = sim_view(other, "position");
    for (uint64_t id = 1; id <= COUNT; id++) {
        assert_memory_equal(clod_sim_row(&a, clod_sim_row_of_id(sim, id)),
                            clod_sim_row(&b, clod_sim_row_of_id(other, id)), 24);
    }
    const char *const names[] = {"lid", "shaker", "sides"};
    for (int k = 0; k < 3; k++) {
        const clod_sim_wall x = look(sim, names[k]), y = look(other, names[k]);
        assert_memory_equal(x.force, y.force, sizeof x.force);
        assert_memory_equal(x.position, y.position, sizeof x.position);
        assert_memory_equal(x.material_velocity, y.material_velocity,
                            sizeof x.material_velocity);
        assert_true(x.load == y.load && x.mean_force[2] != 0.0);
    }
}

/** Three ways to the same bits: on one thread; on two from a checkpoint before the walls come, in which
 *  the grains have other rows; from one after it. */
static void they_go_through_checkpoints(void **temporary)
{
    const char *folder = *temporary;
    clod_sim *sim = sim_made(HEAD, 1), *before = sim_made(HEAD, 2), *after = sim_made(HEAD, 1);
    CHECK(clod_sim_advance(sim, 20000, &status));
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    CHECK(clod_sim_read_checkpoint(before, folder, NULL, &status));
    shake(sim);
    shake(before);
    CHECK(clod_sim_advance(sim, 4000, &status));
    CHECK(clod_sim_advance(before, 4000, &status));
    check_same(sim, before);
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    CHECK(clod_sim_read_checkpoint(after, folder, NULL, &status));
    CHECK(clod_sim_advance(sim, 3000, &status));
    CHECK(clod_sim_advance(after, 3000, &status));
    check_same(sim, after);
    clod_sim_destroy(&sim);
    clod_sim_destroy(&before);
    clod_sim_destroy(&after);
}

/** What load and oscillation put in is in the books, which close to less than the load's part. */
static void their_work_is_in_the_ledger(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(HEAD, 1);
    CHECK(clod_sim_advance(sim, 20000, &status));
    CHECK(clod_sim_open_ledger(sim, &status));
    shake(sim);
    CHECK(clod_sim_advance(sim, 20000, &status));
    clod_sim_ledger ledger;
    CHECK(clod_sim_ledger_look(sim, &ledger, &status));
    const clod_sim_wall lid = look(sim, "lid"), shaker = look(sim, "shaker");
    const double time = DT * (double)lid.mean_steps;
    assert_true(lid.mean_steps == 20000);
    assert_true(time * lid.mean_power > 5e-3 * ledger.wall_work);
    assert_true(time * shaker.mean_power > 0.9 * ledger.wall_work);
    assert_true(fabs(ledger.residual) < 1e-3 * ledger.wall_work);
    clod_sim_destroy(&sim);
}

/** A load may be so large that the time step is too long for its contacts. */
static void a_load_is_held_to_the_critical_step(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(
        "materials: {ore: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}}\n"
        "contacts: {default: {law: hertz, restitution: 0.5, friction: 0.3}}\n"
        "time: {step: 20 us}\n"
        "domain: {min: [-50 mm, -50 mm, -5 mm], max: [50 mm, 50 mm, 200 mm]}\n"
        "stages: [{name: fall, duration: 1 s}]\n"
        "grains:\n"
        "  - {material: ore, count: 30, radius: {distribution: uniform, min: 2 mm, max: 2 mm},\n"
        "     region: {box: {min: [-10 mm, -10 mm, 4 mm], max: [10 mm, 10 mm, 40 mm]}}}\n"
        "walls: {floor: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}]}}\n",
        1);
    CHECK(clod_sim_advance(sim, 10, &status));
    put_lid(sim, "force: 1 N");
    CHECK(clod_sim_change(sim, &status));
    const int32_t lid = clod_sim_wall_index(sim, "lid");
    expect_refused(clod_sim_set_wall_load(sim, lid, 1e6, &status),
                   "with a load of 1e+06 N on 'lid' the time step of 2e-05 s is beyond");
    expect_refused(
        clod_sim_set_wall_load(sim, lid, -1e-3, &status),
        "clod_sim_set_wall_load: the load of 'lid' is -0.001 N; give a finite number");
    assert_true(look(sim, "lid").load == 1.0);
    CHECK(clod_sim_set_wall_load(sim, lid, 2.0, &status));
    CHECK(clod_sim_set_wall_load(sim, lid, 0.0, &status));
    CHECK(clod_sim_remove_wall(sim, "lid", &status));
    CHECK(clod_sim_change(sim, &status));
    put_lid(sim, "force: 1e6 N");
    expect_refused(clod_sim_change(sim, &status),
                   "with wall 'lid' the time step of 2e-05 s is beyond the critical one");
    assert_int_equal(clod_sim_wall_count(sim), 1);
    CHECK(clod_sim_advance(sim, 10, &status));
    clod_sim_destroy(&sim);
}

/** Shape of the walls that programs add below. */
static clod_case_shape disc = {.kind = CLOD_SHAPE_DISC,
                               .point = {0.0, 0.0, 0.1},
                               .normal = {0.0, 0.0, -1.0},
                               .radius = 0.01};

/** A struct that would not be a case is refused, by what is wrong. */
static void wrong_structs_are_refused(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(HEAD, 1);
    clod_case_shape box = {
        .kind = CLOD_SHAPE_BOX, .point = {0.0, 0.0, 0.1}, .size = {0.01, 0.01, 0.01}};
    const clod_case_wall good = {.name = "lid",
                                 .material = "ore",
                                 .shapes = &disc,
                                 .shape_count = 1,
                                 .load = CLOD_LOAD_STRESS,
                                 .stress = 1000.0,
                                 .mass = 0.1,
                                 .damping = 1.0};
    clod_case_wall wall = good;
    wall.mass = 0.0;
    expect_refused(
        clod_sim_add_wall(sim, &wall, &status),
        "clod_sim_add_wall: the wall 'lid': load.mass has 0 kg, which is out of range; "
        "allowed is above 0 kg and at most 1e+06 kg");
    wall = good;
    wall.stress = (double)NAN;
    expect_refused(clod_sim_add_wall(sim, &wall, &status), "load.stress has nan Pa");
    wall = good;
    wall.load = 7;
    expect_refused(clod_sim_add_wall(sim, &wall, &status), "a load of kind 7");
    wall = good;
    wall.load_axis[1] = (double)INFINITY;
    expect_refused(clod_sim_add_wall(sim, &wall, &status), "load.axis has inf, which");
    wall = good;
    wall.shapes = &box;
    expect_refused(clod_sim_add_wall(sim, &wall, &status), "a stress as its load, which needs");
    wall = good;
    wall.oscillation.frequency = 50.0;
    expect_refused(clod_sim_add_wall(sim, &wall, &status),
                   "'lid' oscillates with 50 Hz, but has neither");
    wall.oscillation.amplitude = 1e-3; // along z, as the load
    expect_refused(clod_sim_add_wall(sim, &wall, &status), "along the axis of its load");
    wall.oscillation.direction[0] = 1.0;
    wall.oscillation.frequency = 2100.0;
    expect_refused(clod_sim_add_wall(sim, &wall, &status),
                   "2100 Hz is too fast for the time step of 1e-05 s");
    assert_int_equal(clod_sim_wall_count(sim), 1);
    wall.oscillation.frequency = 50.0;
    CHECK(clod_sim_add_wall(sim, &wall, &status));
    CHECK(clod_sim_change(sim, &status));
    check_relative(look(sim, "lid").load, 1000.0 * M_PI * 1e-4, 1e-12); // of its disc
    clod_sim_destroy(&sim);
}

/** Each number of a wall has the limits that docs/manual.md gives its key, and not more. */
static void numbers_beyond_the_limits_of_a_case_are_refused(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(HEAD, 1);
    clod_case_wall wall = {
        .name = "lid",
        .material = "ore",
        .shapes = &disc,
        .shape_count = 1,
        .load = CLOD_LOAD_STRESS,
        .stress = 1000.0,
        .area = 1e-3,
        .mass = 0.1,
        .oscillation = {.direction = {1.0, 0.0, 0.0}, .amplitude = 1e-3, .frequency = 50.0}};
    const struct {
        double *number;
        double most;
        const char *key;
    } limits[] = {
        {&wall.mass, 1e6, "load.mass"},
        {&wall.damping, 100.0, "load.damping"},
        {&wall.stress, 1e9, "load.stress"},
        {&wall.area, 1e6, "load.area"},
        {&wall.oscillation.amplitude, 1e4, "oscillation.amplitude"},
        {&wall.oscillation.angle, 2.0 * M_PI, "oscillation.angle"},
        {&wall.oscillation.phase, 2.0 * M_PI, "oscillation.phase"},
        {&wall.velocity[2], 1e3, "velocity"},
        {&wall.spin_point[1], 1e4, "spin_point"},
    };
    for (size_t k = 0; k < sizeof limits / sizeof *limits; k++) {
        const double good = *limits[k].number;
        *limits[k].number = limits[k].most * (1.0 + 1e-9);
        expect_refused(clod_sim_add_wall(sim, &wall, &status), limits[k].key);
        *limits[k].number = -1.1 * limits[k].most;
        expect_refused(clod_sim_add_wall(sim, &wall, &status), limits[k].key);
        *limits[k].number = limits[k].most;
        CHECK(clod_sim_add_wall(sim, &wall, &status));
        *limits[k].number = good;
    }
    wall.oscillation.frequency = -1.0;
    expect_refused(clod_sim_add_wall(sim, &wall, &status), "oscillation.frequency has -1 Hz");
    wall.oscillation.frequency = 1.1e6;
    expect_refused(clod_sim_add_wall(sim, &wall, &status), "at most 1e+06 Hz");
    wall.oscillation.frequency = 50.0;
    wall.load = CLOD_LOAD_FORCE; // its stress is not looked at
    wall.stress = -1.0;
    wall.force = 1.1e9;
    expect_refused(clod_sim_add_wall(sim, &wall, &status), "load.force has 1.1e+09 N");
    wall.force = 0.0; // a load may come later
    CHECK(clod_sim_add_wall(sim, &wall, &status));
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_lid_ends_with_its_load),
        cmocka_unit_test(a_free_wall_is_accelerated),
        cmocka_unit_test(its_damping_is_that_of_the_bed),
        cmocka_unit_test(without_grains_there_is_no_damping),
        cmocka_unit_test(an_oscillation_is_that_of_the_case),
        cmocka_unit_test_setup_teardown(they_go_through_checkpoints, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test(their_work_is_in_the_ledger),
        cmocka_unit_test(a_load_is_held_to_the_critical_step),
        cmocka_unit_test(wrong_structs_are_refused),
        cmocka_unit_test(numbers_beyond_the_limits_of_a_case_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
