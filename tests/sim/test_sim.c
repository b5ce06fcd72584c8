// The library's own object: made, advanced, read, changed, written and read again.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/sim_made.h"

#define HEAD                                                                                   \
    "materials:\n"                                                                             \
    "  ore: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}\n"              \
    "contacts:\n"                                                                              \
    "  default: {law: hertz, restitution: 0.5, friction: 0.3}\n"                               \
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 90 mm]}\n"                         \
    "stages: [{name: fall, duration: 1 s}]\n"                                                  \
    "walls:\n"                                                                                 \
    "  box:\n"                                                                                 \
    "    material: ore\n"                                                                      \
    "    shapes:\n"                                                                            \
    "      - plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}\n"                          \
    "      - plane: {point: [0 mm, 0 mm, 0 mm], normal: [1, 0, 0]}\n"                          \
    "      - plane: {point: [20 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}\n"                        \
    "      - plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 1, 0]}\n"                          \
    "      - plane: {point: [0 mm, 20 mm, 0 mm], normal: [0, -1, 0]}\n"                        \
    "  lid: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 60 mm], "                    \
    "normal: [0, 0, -1]}}]}\n"
#define GRAINS(count)                                                                          \
    "grains:\n"                                                                                \
    "  - material: ore\n"                                                                      \
    "    count: " count "\n"                                                                   \
    "    radius: {distribution: uniform, min: 1.8 mm, max: 2 mm}\n"                            \
    "    region: {box: {min: [2 mm, 2 mm, 2 mm], max: [18 mm, 18 mm, 50 mm]}}\n"

static const char BED[] = HEAD GRAINS("60");
static const char ONE[] = HEAD GRAINS("1");

/** Positions, velocities and spins bit for bit, row by row. */
static void assert_same(clod_sim *a, clod_sim *b)
{
    static const char *const NAMES[] = {"position", "velocity", "angular_velocity", "force"};
    assert_int_equal(clod_sim_grain_count(a), clod_sim_grain_count(b));
    for (size_t n = 0; n < sizeof NAMES / sizeof *NAMES; n++) {
        const clod_sim_view x = sim_view(a, NAMES[n]);
        const clod_sim_view y = sim_view(b, NAMES[n]);
        for (size_t g = 0; g < x.rows; g++) {
            assert_memory_equal(clod_sim_row(&x, g), clod_sim_row(&y, g), 3 * sizeof(double));
        }
    }
}

static void calls_and_threads_change_no_bit(void **unused)
{
    (void)unused;
    clod_sim *a = sim_made(BED, 1);
    clod_sim *b = sim_made(BED, 2);
    const clod_sim_contact *contacts;
    size_t count;
    CHECK(clod_sim_advance(a, 3000, &status));
    for (int k = 0; k < 30; k++) {
        CHECK(clod_sim_advance(b, 100, &status));
        CHECK(clod_sim_contacts(b, &contacts, &count, &status));
    }
    assert_int_equal(clod_sim_step(a), 3000);
    assert_true(clod_sim_time(a) == 3000.0 * clod_sim_dt(a));
    assert_true(count > 10);
    assert_same(a, b);
    clod_sim_destroy(&a);
    clod_sim_destroy(&b);
    assert_null(a);
    clod_sim_destroy(&a);
    clod_sim_destroy(NULL);
}

static void every_array_has_its_place(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(BED, 1);
    assert_int_equal(clod_sim_array_count(), 10);
    assert_null(clod_sim_array_name(10));
    for (size_t k = 0; k < clod_sim_array_count(); k++) {
        const clod_sim_view view = sim_view(sim, clod_sim_array_name(k));
        assert_string_equal(view.name, clod_sim_array_name(k));
        assert_int_equal(view.rows, 60);
    }
    const clod_sim_view radius = sim_view(sim, "radius");
    const clod_sim_view mass = sim_view(sim, "mass");
    const clod_sim_view inverse = sim_view(sim, "inverse_inertia");
    const clod_sim_view id = sim_view(sim, "id");
    for (size_t g = 0; g < radius.rows; g++) {
        const double r = *clod_sim_row(&radius, g);
        const double m = 4.0 / 3.0 * M_PI * r * r * r * 2500.0; // of a sphere
        uint64_t name;
        memcpy(&name, (const char *)id.data + g * id.stride, sizeof name);
        assert_true(r >= 1.8e-3 && r <= 2e-3);
        assert_true(fabs(*clod_sim_row(&mass, g) / m - 1.0) < 1e-12);
        assert_true(fabs(*clod_sim_row(&inverse, g) * 0.4 * m * r * r - 1.0) < 1e-12);
        assert_int_equal(clod_sim_row_of_id(sim, name), g);
    }
    assert_true(clod_sim_row_of_id(sim, UINT64_MAX) == SIZE_MAX);
    clod_sim_destroy(&sim);
}

/** A grain in free flight falls as if it had begun where it was put: z - g t^2/2 + v t. */
static void a_grain_that_is_moved_flies_on(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(ONE, 1);
    CHECK(clod_sim_advance(sim, 10, &status));
    clod_sim_view view = sim_view(sim, "position");
    double *place = clod_sim_row(&view, 0);
    view = sim_view(sim, "velocity");
    double *speed = clod_sim_row(&view, 0);
    place[0] = place[1] = 0.01;
    place[2] = 0.05;
    speed[0] = speed[1] = 0.0;
    speed[2] = 0.2;
    CHECK(clod_sim_positions_changed(sim, &status));
    const double begin = clod_sim_time(sim);
    CHECK(clod_sim_advance(sim, 1000, &status));
    const double t = clod_sim_time(sim) - begin;
    const clod_sim_view now = sim_view(sim, "position");
    const double expected = 0.05 + 0.2 * t - 0.5 * 9.81 * t * t; // exact for velocity Verlet
    assert_true(fabs(clod_sim_row(&now, 0)[2] - expected) < 1e-12);
    assert_true(fabs(clod_sim_row(&now, 0)[0] - 0.01) < 1e-15);
    clod_sim_destroy(&sim);
}

/** Put onto the floor with an overlap, far from where the lists had it: it is found and pushed
 *  up with Hertz' force 4/3 E* sqrt(R) d^1.5, E* = E/(2 (1 - nu^2)). */
static void a_grain_that_is_moved_meets_the_floor(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(ONE, 1);
    const clod_sim_contact *contacts;
    size_t count;
    clod_sim_view view = sim_view(sim, "position");
    double *place = clod_sim_row(&view, 0);
    const double r = place[3];
    place[0] = place[1] = 0.01;
    place[2] = r - 1e-5;
    CHECK(clod_sim_positions_changed(sim, &status));
    CHECK(clod_sim_advance(sim, 1, &status));
    CHECK(clod_sim_contacts(sim, &contacts, &count, &status));
    assert_int_equal(count, 1);
    assert_int_equal(contacts->wall, clod_sim_wall_index(sim, "box"));
    assert_int_equal(contacts->shape, 0);
    const clod_sim_view force = sim_view(sim, "force");
    const double hertz = 4.0 / 3.0 * 1e7 / (2.0 * (1.0 - 0.09)) * sqrt(r) * pow(1e-5, 1.5);
    const double weight = 4.0 / 3.0 * M_PI * r * r * r * 2500.0 * 9.81;
    assert_true(fabs(clod_sim_row(&force, 0)[2] / (hertz - weight) - 1.0) < 0.03);
    clod_sim_destroy(&sim);
}

/** A whole bed that is moved by a period of nothing: the same positions written again keep
 *  histories, so the bed goes on with forces that agree to rounding. */
static void contacts_keep_their_history(void **unused)
{
    (void)unused;
    clod_sim *a = sim_made(BED, 1);
    clod_sim *b = sim_made(BED, 1);
    CHECK(clod_sim_advance(a, 4000, &status));
    CHECK(clod_sim_advance(b, 4000, &status));
    CHECK(clod_sim_positions_changed(b, &status));
    CHECK(clod_sim_advance(a, 1, &status));
    CHECK(clod_sim_advance(b, 1, &status));
    const clod_sim_view id = sim_view(a, "id");
    const clod_sim_view x = sim_view(a, "position");
    const clod_sim_view f = sim_view(a, "force");
    const clod_sim_view y = sim_view(b, "position");
    const clod_sim_view h = sim_view(b, "force");
    for (size_t g = 0; g < x.rows; g++) {
        uint64_t name;
        memcpy(&name, (const char *)id.data + g * id.stride, sizeof name);
        const size_t other = clod_sim_row_of_id(b, name);
        for (int c = 0; c < 3; c++) {
            assert_true(clod_sim_row(&x, g)[c] == clod_sim_row(&y, other)[c]);
            assert_true(fabs(clod_sim_row(&f, g)[c] - clod_sim_row(&h, other)[c]) < 1e-12);
        }
    }
    clod_sim_destroy(&a);
    clod_sim_destroy(&b);
}

static void energies_are_those_of_the_grains(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(ONE, 1);
    clod_sim_energy before, after;
    clod_sim_bed bed;
    CHECK(clod_sim_energies(sim, &before, &status));
    CHECK(clod_sim_advance(sim, 50, &status));
    CHECK(clod_sim_energies(sim, &after, &status));
    CHECK(clod_sim_measure(sim, &bed, &status));
    const clod_sim_view mass = sim_view(sim, "mass");
    const double m = *clod_sim_row(&mass, 0);
    assert_true(fabs(after.translation / (0.5 * m * bed.max_speed * bed.max_speed) - 1.0) <
                1e-12);
    assert_true(fabs(after.translation - (before.potential - after.potential)) <
                1e-9 * after.translation); // free fall
    assert_int_equal(bed.pairs, 0);
    clod_sim_destroy(&sim);
}

static void a_checkpoint_goes_on_with_the_same_bits(void **temporary)
{
    const char *folder = *temporary;
    clod_sim *a = sim_made(BED, 1);
    clod_sim *b = sim_made(BED, 2);
    clod_sim *c = sim_made(ONE, 1);
    CHECK(clod_sim_advance(a, 2500, &status));
    CHECK(clod_sim_write_checkpoint(a, folder, &status));
    CHECK(clod_sim_write_snapshot(a, folder, true, &status));
    CHECK(clod_sim_advance(a, 500, &status));
    CHECK(clod_sim_read_checkpoint(b, folder, NULL, &status));
    assert_int_equal(clod_sim_step(b), 2500);
    CHECK(clod_sim_advance(b, 500, &status));
    assert_same(a, b);
    assert_false(clod_sim_read_checkpoint(c, folder, NULL, &status)); // of another case
    assert_int_equal(status.code, CLOD_USAGE);
    assert_false(clod_sim_read_checkpoint(c, folder, "fill", &status));
    CHECK(clod_sim_advance(c, 10, &status)); // as it was
    clod_sim_destroy(&a);
    clod_sim_destroy(&b);
    clod_sim_destroy(&c);
    assert_true(temp_exists(temporary, "run.hdf.series"));
}

/** The text names function and argument. */
#define NEEDS(call, words)                                                                     \
    do {                                                                                       \
        status = (clod_status){0};                                                             \
        assert_false(call);                                                                    \
        assert_int_equal(status.code, CLOD_USAGE);                                             \
        assert_non_null(strstr(status.text, words));                                           \
    } while (0)

static void what_is_missing_is_named(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(ONE, 1);
    clod_sim_view view;
    const clod_sim_contact *contacts;
    size_t count;
    NEEDS(clod_sim_create(NULL, NULL, &status), "clod_sim_create: from is NULL");
    NEEDS(clod_sim_create_from_file(NULL, NULL, &status), "path is NULL");
    NEEDS(clod_sim_create_from_text("x", NULL, NULL, &status), "text is NULL");
    NEEDS(clod_sim_create_from_text("x", "grains: 3", NULL, &status), "x:1");
    NEEDS(clod_sim_advance(NULL, 1, &status), "clod_sim_advance: self is NULL");
    NEEDS(clod_sim_advance(sim, -1, &status), "-1 steps");
    NEEDS(clod_sim_array(sim, NULL, &view, &status), "name is NULL");
    NEEDS(clod_sim_array(sim, "mass", NULL, &status), "view is NULL");
    NEEDS(clod_sim_array(sim, "colour", &view, &status), "angular_velocity");
    NEEDS(clod_sim_contacts(sim, NULL, &count, &status), "contacts is NULL");
    NEEDS(clod_sim_contacts(sim, &contacts, NULL, &status), "count is NULL");
    NEEDS(clod_sim_energies(sim, NULL, &status), "energy is NULL");
    NEEDS(clod_sim_measure(sim, NULL, &status), "bed is NULL");
    NEEDS(clod_sim_write_checkpoint(sim, NULL, &status), "folder is NULL");
    NEEDS(clod_sim_read_checkpoint(sim, NULL, NULL, &status), "folder is NULL");
    NEEDS(clod_sim_write_snapshot(sim, NULL, false, &status), "folder is NULL");
    NEEDS(clod_sim_set_adhesion(sim, 1.5, &status), "1.5");
    view = sim_view(sim, "position");
    clod_sim_row(&view, 0)[1] = NAN;
    NEEDS(clod_sim_positions_changed(sim, &status), "position of grain");
    clod_sim_destroy(&sim);
}

/** A wall at a given speed is where it should be, and feels what it meets. */
static void walls_are_driven(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(BED, 1);
    const int32_t lid = clod_sim_wall_index(sim, "lid");
    clod_sim_wall view;
    assert_int_equal(clod_sim_wall_count(sim), 2);
    assert_int_equal(clod_sim_wall_index(sim, "roof"), -1);
    CHECK(clod_sim_set_wall_velocity(sim, lid, (double[3]){0.0, 0.0, -0.1}, &status));
    CHECK(clod_sim_advance(sim, 100, &status));
    CHECK(clod_sim_wall_look(sim, lid, &view, &status));
    assert_string_equal(view.name, "lid");
    assert_true(fabs(view.position[2] + 0.1 * clod_sim_time(sim)) < 1e-15);
    assert_true(view.velocity[2] == -0.1);
    assert_int_equal(view.mean_steps, 100);
    CHECK(clod_sim_set_wall_velocity(sim, lid, (double[3]){0.0, 0.0, 0.0}, &status));
    CHECK(clod_sim_set_wall_position(sim, lid, (double[3]){0.0, 0.0, -0.01}, &status));
    CHECK(clod_sim_advance(sim, 100, &status));
    CHECK(clod_sim_wall_look(sim, lid, &view, &status));
    assert_true(view.position[2] == -0.01);
    clod_sim_reset_wall_means(sim);
    CHECK(clod_sim_wall_look(sim, lid, &view, &status));
    assert_int_equal(view.mean_steps, 0);
    assert_true(view.mean_force[2] == 0.0);
    NEEDS(clod_sim_set_wall_spin(sim, clod_sim_wall_index(sim, "box"), 1.0, &status), "plane");
    NEEDS(clod_sim_set_wall_load(sim, lid, 1.0, &status), "no load");
    NEEDS(clod_sim_set_wall_velocity(sim, 2, (double[3]){0.0}, &status), "no wall 2");
    NEEDS(clod_sim_set_wall_velocity(sim, lid, NULL, &status), "velocity is NULL");
    NEEDS(clod_sim_set_wall_velocity(sim, lid, (double[3]){NAN, 0.0, 0.0}, &status), "finite");
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(calls_and_threads_change_no_bit),
        cmocka_unit_test(every_array_has_its_place),
        cmocka_unit_test(a_grain_that_is_moved_flies_on),
        cmocka_unit_test(a_grain_that_is_moved_meets_the_floor),
        cmocka_unit_test(contacts_keep_their_history),
        cmocka_unit_test(energies_are_those_of_the_grains),
        cmocka_unit_test_setup_teardown(a_checkpoint_goes_on_with_the_same_bits,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test(what_is_missing_is_named),
        cmocka_unit_test(walls_are_driven),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
