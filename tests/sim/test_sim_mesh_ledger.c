// The energy ledger of a ball that bounces off a mesh is that of one that bounces off a plane.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/sim_made.h"

/** Steps are long: what the last one does, which ends in the air, is a large part of a bounce. */
#define CASE                                                                                   \
    "materials: {ore: {density: 2500 kg/m3}}\n"                                                \
    "contacts: {default: {law: mepa, exponent: 1.5, k1: 1e6 N/m^1.5, k2: 5e6 N/m^1.5,\n"       \
    "  k_adh: 1e5 N/m^1.5, restitution: 0.7, friction: 0.5}}\n"                                \
    "gravity: [0 m/s2, 0 m/s2, 0 m/s2]\n"                                                      \
    "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"                                \
    "time: {step: 1e-5 s, design_stress: 1 kPa}\n"                                             \
    "stages: [{name: run, duration: 1 s}]\n"                                                   \
    "walls: {wall: {material: ore, shapes: [%s]}}\n"

#define RADIUS 4e-3

/** A ball with its centre over (x, 0) meets the wall at 1 m/s, aslant, and has left it at the end. */
static clod_sim_ledger bounce(const char *shape, double x)
{
    char text[2048];
    snprintf(text, sizeof text, CASE, shape);
    clod_sim *sim = sim_made(text, 1);
    const clod_sim_grain ball = {.id = 1,
                                 .radius = RADIUS,
                                 .position = {x, 0.0, RADIUS + 1e-5},
                                 .velocity = {0.0, 0.3, -1.0}};
    clod_sim_ledger ledger;
    CHECK(clod_sim_add_grain(sim, &ball, &status));
    CHECK(clod_sim_open_ledger(sim, &status));
    CHECK(clod_sim_advance(sim, 1000, &status));
    CHECK(clod_sim_ledger_look(sim, &ledger, &status));
    clod_sim_energy energy;
    CHECK(clod_sim_energies(sim, &energy, &status));
    assert_true(energy.normal == 0.0); // it has not stuck
    clod_sim_destroy(&sim);
    return ledger;
}

/** A slab of a metre's width with its corner's edge along y at x = 0: in the middle nothing but the plane is
 *  near; beside the edge its side face, and what the lists have of it, is too. */
static void slab(const char *folder, char shape[PATH_MAX + 64])
{
    mesh_file file = mesh_file_open(folder, "slab");
    mesh_file_sheet(&file, (double[3]){0.0, -0.5, 0.0}, (double[3]){0.5, 0.0, 0.0},
                    (double[3]){0.0, 1.0, 0.0}, 2, 2);
    mesh_file_sheet(&file, (double[3]){0.0, -0.5, -0.1}, (double[3]){0.0, 0.0, 0.1},
                    (double[3]){0.0, 1.0, 0.0}, 1, 1);
    mesh_file_close(&file);
    snprintf(shape, PATH_MAX + 64, "{mesh: {file: %s, unit: 1 m}}", file.path);
}

static void a_bounce_off_a_mesh_loses_what_one_off_a_plane_does(void **temporary)
{
    char mesh[PATH_MAX + 64];
    slab(*temporary, mesh);
    const clod_sim_ledger plane =
        bounce("{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}", 0.1);
    assert_true(plane.dash_pot > 0.0 && plane.plastic > 0.0 && plane.friction > 0.0);
    // in the middle; beside the edge, farther than the ball touches; over it
    static const double PLACE[] = {0.1, 1.0001 * RADIUS, 0.5 * RADIUS, 1e-5};
    for (size_t k = 0; k < sizeof PLACE / sizeof *PLACE; k++) {
        const clod_sim_ledger on = bounce(mesh, PLACE[k]);
        check_relative(on.dash_pot, plane.dash_pot, 1e-12);
        check_relative(on.plastic, plane.plastic, 1e-12);
        check_relative(on.friction, plane.friction, 1e-12);
        check_relative(on.residual, plane.residual, 1e-9);
    }
}

/** A sheet whose rim lies along an axis, and a ball that meets the rim from beside it: the edge of a box. */
static void a_bounce_off_a_rim_loses_what_one_off_a_box_does(void **temporary)
{
    mesh_file file = mesh_file_open(*temporary, "sheet");
    mesh_file_sheet(&file, (double[3]){0.0, -0.5, 0.0}, (double[3]){0.5, 0.0, 0.0},
                    (double[3]){0.0, 1.0, 0.0}, 2, 2);
    mesh_file_close(&file);
    char sheet[PATH_MAX + 64], corner[PATH_MAX + 64];
    snprintf(sheet, sizeof sheet, "{mesh: {file: %s, unit: 1 m}}", file.path);
    slab(*temporary, corner);
    for (int k = 0; k < 10; k++) {
        const double x = -0.097 * k * RADIUS; // no step ends just at the first touch
        const clod_sim_ledger box =
            bounce("{box: {center: [0.25 m, 0 m, -0.05 m], size: [0.5 m, 1 m, 0.1 m]}}", x);
        const char *const shape[] = {sheet, corner};
        assert_true(box.dash_pot > 0.0 && box.plastic > 0.0);
        for (int m = 0; m < 2; m++) {
            const clod_sim_ledger on = bounce(shape[m], x);
            check_relative(on.dash_pot, box.dash_pot, 1e-10);
            check_relative(on.plastic, box.plastic, 1e-10);
            check_relative(on.friction, box.friction, 1e-10);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_bounce_off_a_mesh_loses_what_one_off_a_plane_does,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_bounce_off_a_rim_loses_what_one_off_a_box_does,
                                        temp_folder_make, temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
