// Plates that move, turn, vibrate, carry a load and have a belt: as mesh and as box.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/sim_made.h"

#define LAW                                                                                    \
    "law: mepa, exponent: 1.5, k1: 4.75e6 N/m^1.5, k2: 2.37e7 N/m^1.5, k_adh: 2e6 N/m^1.5, "   \
    "restitution: 0.5, friction: 0.3, rolling: epsd2, rolling_friction: 0.05"
#define GRAINS 6

/** A plate of 0.4 m about z = 0 that is moved by `motion`, above or below the grains. */
static clod_sim *plate(const char *folder, bool mesh, bool above, const char *motion,
                       const char *belt, int threads)
{
    char shape[2 * PATH_MAX], text[3 * PATH_MAX];
    if (mesh) {
        mesh_file file = mesh_file_open(folder, "plate");
        mesh_file_sheet(&file, (double[3]){-0.2, -0.2, 0.0}, (double[3]){0.4, 0.0, 0.0},
                        (double[3]){0.0, 0.4, 0.0}, 6, 7);
        mesh_file_close(&file);
        snprintf(shape, sizeof shape, "mesh: {file: %s, unit: 1 m%s}", file.path, belt);
    } else { // the side towards the grains at z = 0
        snprintf(shape, sizeof shape,
                 "box: {center: [0 m, 0 m, %s], size: [0.4 m, 0.4 m, 20 mm]%s}",
                 above ? "10 mm" : "-10 mm", belt);
    }
    snprintf(text, sizeof text,
             "materials: {ore: {density: 2500 kg/m3}}\n"
             "contacts: {default: {%s}}\n"
             "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
             "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
             "walls:\n"
             "  plate: {material: ore, shapes: [{%s}], %s}\n"
             "  floor: {material: ore, shapes: [{plane: {point: [0 m, 0 m, %s]}}]}\n"
             "stages: [{name: run, duration: 1 s}]\n"
             "time: {step: 5e-6 s, design_stress: 10 kPa}\n",
             LAW, shape, motion, above ? "-6.5 mm" : "-0.5 m");
    clod_sim *sim = sim_made(text, threads);
    for (int g = 0; g < GRAINS; g++) {
        const clod_sim_grain grain = {
            .id = 1 + (uint64_t)g,
            .radius = 0.003,
            .position = {0.02 * g - 0.05, 0.01 * g - 0.03, above ? -0.0033 : 0.0031},
            .velocity = {0.05 * g, -0.02 * g, 0.0}};
        CHECK(clod_sim_add_grain(sim, &grain, &status));
    }
    return sim;
}

/** After 50 ms grains are where they are with the other wall, and the walls feel the same. */
static void check_twins(const char *folder, bool above, const char *motion, const char *belt)
{
    clod_sim *twin[] = {plate(folder, true, above, motion, belt, 2),
                        plate(folder, false, above, motion, belt, 1)};
    clod_sim_wall wall[2];
    double moved = 0.0;
    for (int k = 0; k < 2; k++) {
        CHECK(clod_sim_advance(twin[k], 10000, &status));
        CHECK(clod_sim_wall_look(twin[k], 0, &wall[k], &status));
    }
    static const char *const ARRAYS[] = {"position", "velocity", "angular_velocity"};
    static const double ALLOWED[] = {1e-11, 1e-9, 1e-7};
    for (int k = 0; k < 3; k++) {
        const clod_sim_view a = sim_view(twin[0], ARRAYS[k]), b = sim_view(twin[1], ARRAYS[k]);
        for (uint64_t id = 1; id <= GRAINS; id++) {
            const double *x = clod_sim_row(&a, clod_sim_row_of_id(twin[0], id));
            const double *y = clod_sim_row(&b, clod_sim_row_of_id(twin[1], id));
            for (int c = 0; c < 3; c++) {
                check_close(x[c], y[c], ALLOWED[k]);
                moved += fabs(x[c]);
            }
        }
    }
    assert_true(moved > 0.1);
    for (int c = 0; c < 3; c++) {
        check_close(wall[0].mean_force[c], wall[1].mean_force[c], 1e-7);
        check_close(wall[0].mean_torque[c], wall[1].mean_torque[c], 1e-8);
        check_close(wall[0].position[c], wall[1].position[c], 1e-11);
    }
    check_close(wall[0].mean_power, wall[1].mean_power, 1e-7);
    assert_true(fabs(wall[0].mean_force[2]) > 1e-4);
    clod_sim_destroy(&twin[0]);
    clod_sim_destroy(&twin[1]);
}

#define BELT ", surface: {speed: 0.3 m/s, direction: [1, 2, 0.5]}"

static void a_plate_moves_and_turns_with_a_belt(void **temporary)
{
    check_twins(*temporary, false,
                "velocity: [0.2 m/s, -0.1 m/s, 0.03 m/s], spin: 0.6 rad/s, spin_axis: [1, 0.5, "
                "3], spin_point: [0.01 m, 0 m, 0 m]",
                BELT);
}

static void a_plate_vibrates_with_a_belt(void **temporary)
{
    check_twins(*temporary, false,
                "oscillation: {direction: [1, 0, 2], amplitude: 0.4 mm, angle: 0.01 rad, "
                "frequency: 60 Hz}, spin_axis: [0, 1, 0]",
                BELT);
}

static void a_plate_carries_a_load_with_a_belt(void **temporary)
{
    check_twins(*temporary, true, "load: {force: 3 N, mass: 0.2 kg}", BELT);
}

static void a_plate_does_all_at_once(void **temporary)
{
    check_twins(
        *temporary, true,
        "velocity: [0.05 m/s, -0.1 m/s, 0 m/s], spin: 0.6 rad/s, spin_point: [0.01 m, 0 "
        "m, 0 m], oscillation: {direction: [1, 0.5, 0], amplitude: 0.4 mm, frequency: 60 "
        "Hz}, load: {force: 3 N, mass: 0.2 kg}, start_up: {at: 0.005 s, duration: 0.01 s}",
        BELT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_plate_moves_and_turns_with_a_belt, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_plate_vibrates_with_a_belt, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_plate_carries_a_load_with_a_belt, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_plate_does_all_at_once, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
