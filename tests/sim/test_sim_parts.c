// Named parts of a mesh: each with its own material and belt, beside planes that have the same.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/sim_made.h"

#define LAW                                                                                    \
    "law: mepa, exponent: 1.5, k1: 4.75e7 N/m^1.5, k2: 2.37e8 N/m^1.5, k_adh: 2e7 N/m^1.5, "   \
    "restitution: 0.5, friction: 0.3, rolling: epsd2, rolling_friction: 0.05"

/** A floor of two solids of an STL that meet at x = 0: `left` and `right`. */
static void write_floor(const char *folder, char path[PATH_MAX])
{
    mesh_file file = mesh_file_open(folder, "floor");
    rewind(file.file);
    fprintf(file.file, "solid left\n");
    mesh_file_sheet(&file, (double[3]){-0.2, -0.2, 0.0}, (double[3]){0.2, 0.0, 0.0},
                    (double[3]){0.0, 0.4, 0.0}, 3, 5);
    fprintf(file.file, "endsolid left\nsolid right\n");
    mesh_file_sheet(&file, (double[3]){0.0, -0.2, 0.0}, (double[3]){0.2, 0.0, 0.0},
                    (double[3]){0.0, 0.4, 0.0}, 2, 4);
    mesh_file_close(&file);
    memcpy(path, file.path, PATH_MAX);
}

static char case_text[3 * PATH_MAX];

/** A case with one wall of one shape. */
static const char *case_of(const char *shape)
{
    snprintf(case_text, sizeof case_text,
             "materials: {ore: {density: 2500 kg/m3}, ice: {density: 900 kg/m3},\n"
             "            rubber: {density: 1200 kg/m3}}\n"
             "contacts: {default: {%s}, ore-ice: {friction: 0}, ore-rubber: {friction: 0.6}}\n"
             "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
             "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
             "walls: {floor: {material: ore, shapes: [%s]}}\n"
             "stages: [{name: run, duration: 1 s}]\n"
             "time: {step: 2e-6 s, design_stress: 10 kPa}\n",
             LAW, shape);
    return case_text;
}

/** Ten grains that fall on x = `at` and beyond, sliding with `speed` along y. */
static clod_sim *rain(const char *shape, int threads, double at, double speed)
{
    clod_sim *sim = sim_made(case_of(shape), threads);
    for (int g = 0; g < 10; g++) {
        clod_sim_grain grain = {.id = 1 + (uint64_t)g,
                                .radius = 0.003,
                                .position = {at + 0.007 * g, -0.01, 0.0031 + 0.0001 * g},
                                .velocity = {0.0, speed, -0.1}};
        CHECK(clod_sim_add_grain(sim, &grain, &status));
    }
    CHECK(clod_sim_advance(sim, 20000, &status));
    return sim;
}

/** Both have the same grains, bit for bit. */
static void check_same(clod_sim **sim, clod_sim **twin)
{
    static const char *const ARRAYS[] = {"position", "velocity", "angular_velocity"};
    for (int k = 0; k < 3; k++) {
        const clod_sim_view a = sim_view(*sim, ARRAYS[k]), b = sim_view(*twin, ARRAYS[k]);
        for (uint64_t id = 1; id <= 10; id++) {
            assert_memory_equal(clod_sim_row(&a, clod_sim_row_of_id(*sim, id)),
                                clod_sim_row(&b, clod_sim_row_of_id(*twin, id)),
                                3 * sizeof(double));
        }
    }
    clod_sim_destroy(sim);
    clod_sim_destroy(twin);
}

static void each_part_has_its_own_material_and_belt(void **temporary)
{
    char path[PATH_MAX], mesh[2 * PATH_MAX];
    write_floor(*temporary, path);
    snprintf(mesh, sizeof mesh,
             "{mesh: {file: %s, unit: 1 m, surface: {material: ice}, "
             "parts: {right: {material: rubber, speed: 0.4 m/s, direction: [1, 1, 1]}}}}",
             path);
    clod_sim *right = rain(mesh, 1, 0.02, 0.2);
    clod_sim *twin = rain("{plane: {point: [0 m, 0 m, 0 m], surface: {material: rubber, "
                          "speed: 0.4 m/s, direction: [1, 1, 1]}}}",
                          2, 0.02, 0.2);
    check_same(&right, &twin);
    clod_sim *left = rain(mesh, 2, -0.12, 0.2); // what is not named has that of the shape
    twin = rain("{plane: {point: [0 m, 0 m, 0 m], surface: {material: ice}}}", 1, -0.12, 0.2);
    check_same(&left, &twin);
}

/** A part without material has that of the shape, else of the wall; its belt is its own. */
static void a_part_without_material_has_that_of_the_shape(void **temporary)
{
    char path[PATH_MAX], mesh[2 * PATH_MAX];
    write_floor(*temporary, path);
    snprintf(
        mesh, sizeof mesh,
        "{mesh: {file: %s, unit: 1 m, surface: {material: rubber, velocity: [1 m/s, 0 m/s, "
        "0 m/s]}, parts: {left: {velocity: [0 m/s, -0.3 m/s, 0 m/s]}}}}",
        path);
    clod_sim *left = rain(mesh, 1, -0.12, 0.2);
    clod_sim *twin = rain("{plane: {point: [0 m, 0 m, 0 m], surface: {material: rubber, "
                          "velocity: [0 m/s, -0.3 m/s, 0 m/s]}}}",
                          1, -0.12, 0.2);
    check_same(&left, &twin);
}

/** Over a seam between parts of one material a grain carries its whole history. */
static void a_seam_between_like_parts_is_not_felt(void **temporary)
{
    char path[PATH_MAX], mesh[2 * PATH_MAX];
    write_floor(*temporary, path);
    const char *belt = "{velocity: [0.5 m/s, 0 m/s, 0 m/s]}"; // grains go over x = 0
    snprintf(mesh, sizeof mesh, "{mesh: {file: %s, unit: 1 m, parts: {left: %s, right: %s}}}",
             path, belt, belt);
    clod_sim *over = rain(mesh, 1, -0.065, 0.0);
    const clod_sim_view position = sim_view(over, "position");
    const double crossed = *clod_sim_row(&position, clod_sim_row_of_id(over, 10));
    assert_true(crossed > 0.001); // it began at x = -2 mm
    char plane[256];
    snprintf(plane, sizeof plane, "{plane: {point: [0 m, 0 m, 0 m], surface: %s}}", belt);
    clod_sim *twin = rain(plane, 1, -0.065, 0.0);
    check_same(&over, &twin);
}

static void a_part_that_is_not_there_is_refused(void **temporary)
{
    char path[PATH_MAX], mesh[2 * PATH_MAX];
    write_floor(*temporary, path);
    snprintf(mesh, sizeof mesh, "{mesh: {file: %s, unit: 1 m, parts: {lip: {speed: 1 m/s}}}}",
             path);
    const clod_sim_options options = {.threads = 1};
    clod_sim *sim = clod_sim_create_from_text("case.yaml", case_of(mesh), &options, &status);
    expect_refused(sim != NULL, "walls.floor.shapes.0.mesh.parts.lip: the mesh ");
    expect_refused(sim != NULL, "has no part of this name; its parts are left, right");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(each_part_has_its_own_material_and_belt,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_part_without_material_has_that_of_the_shape,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_seam_between_like_parts_is_not_felt, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_part_that_is_not_there_is_refused, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
