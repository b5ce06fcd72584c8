// A wall of two mesh files with a crack between them, beside the plane for which they stand.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/rolling_grains.h"
#include "support/sim_made.h"

/** A wall of these shapes; grains are added. */
static clod_sim *case_of(const char *shapes, int threads)
{
    char text[2 * PATH_MAX + 2048];
    snprintf(text, sizeof text,
             "materials: {ore: {density: 2500 kg/m3}}\n"
             "contacts: {default: {law: mepa, exponent: 1.5, k1: 4.75e7 N/m^1.5, "
             "k2: 2.37e8 N/m^1.5, k_adh: 2e7 N/m^1.5, restitution: 0.5, friction: 0.3, "
             "rolling: epsd2, rolling_friction: 0.05}}\n"
             "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
             "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
             "walls: {wall: {material: ore, shapes: [%s]}}\n"
             "stages: [{name: run, duration: 1 s}]\n"
             "time: {step: 2e-6 s, design_stress: 10 kPa}\n",
             shapes);
    return sim_made(text, threads);
}

/** Two sheets at z = 0 that meet at x = 0 but for a crack. */
static clod_sim *two_files(const char *folder, double crack, int threads)
{
    char shapes[2 * PATH_MAX + 128];
    mesh_file left = mesh_file_open(folder, "left"), right = mesh_file_open(folder, "right");
    mesh_file_sheet(&left, (double[3]){-0.2, -0.2, 0.0}, (double[3]){0.2 - 0.5 * crack, 0, 0},
                    (double[3]){0, 0.4, 0}, 3, 7);
    mesh_file_sheet(&right, (double[3]){0.5 * crack, -0.2, 0.0},
                    (double[3]){0.2 - 0.5 * crack, 0, 0}, (double[3]){0, 0.4, 0}, 4, 5);
    mesh_file_close(&left);
    mesh_file_close(&right);
    snprintf(shapes, sizeof shapes,
             "{mesh: {file: %s, unit: 1 m}}, {mesh: {file: %s, unit: 1 m}}", left.path,
             right.path);
    return case_of(shapes, threads);
}

static double twin[ROLLING_GRAINS][3], found[ROLLING_GRAINS][3];

static int setup(void **temporary)
{
    roll_over(case_of("{plane: {point: [0 m, 0 m, 0 m]}}", 1), twin);
    for (int g = 0; g < ROLLING_GRAINS; g++) {
        assert_true(twin[g][0] < -0.0005); // all went over the crack
    }
    return temp_folder_make(temporary);
}

static void files_that_meet_are_one_plane(void **temporary)
{
    for (int threads = 1; threads <= 2; threads++) {
        roll_over(two_files(*temporary, 0.0, threads), found);
        assert_memory_equal(found, twin, sizeof twin);
    }
}

// A crack of width g lets a grain of radius r sink by g^2 / (8 r) at most, 4e-8 m here, and pushes
// it aside by as much force as it brings it back: paths differ by the order of g.
static void a_crack_is_hardly_felt(void **temporary)
{
    static const double CRACKS[] = {1e-7, 1e-6, 1e-5, 3e-5};
    for (size_t c = 0; c < 4; c++) {
        roll_over(two_files(*temporary, CRACKS[c], 1), found);
        double most = 0.0;
        for (int g = 0; g < ROLLING_GRAINS; g++) {
            check_close(found[g][2], twin[g][2], 1e-7);
            most = fmax(most, hypot(found[g][0] - twin[g][0], found[g][1] - twin[g][1]));
        }
        check_at_most(most, 2.0 * CRACKS[c]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_that_meet_are_one_plane),
        cmocka_unit_test(a_crack_is_hardly_felt),
    };
    return cmocka_run_group_tests(tests, setup, temp_folder_remove);
}
