// Balls dropped on meshes, with numbers that others publish or that follow by hand.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/sim_made.h"

static clod_sim *drop(const mesh_file *mesh, const char *unit, const char *law, double density,
                      const char *gravity, const char *step, const clod_sim_grain *grain)
{
    char text[PATH_MAX + 1024];
    snprintf(
        text, sizeof text,
        "materials: {ball: {density: %g kg/m3, youngs_modulus: 1e8 Pa, poissons_ratio: 0.3}}\n"
        "contacts: {default: {%s}}\n"
        "gravity: %s\n"
        "domain: {min: [-2 m, -2 m, -2 m], max: [2 m, 2 m, 2 m]}\n"
        "walls: {wall: {material: ball, shapes: [{mesh: {file: %s, unit: %s}}]}}\n"
        "stages: [{name: run, duration: 1 s}]\n"
        "time: {step: %s, design_stress: 10 kPa}\n",
        density, law, gravity, mesh->path, unit, step);
    clod_sim *sim = sim_made(text, 1);
    CHECK(clod_sim_add_grain(sim, grain, &status));
    return sim;
}

static const double *row(clod_sim *sim, const char *name)
{
    const clod_sim_view view = sim_view(sim, name);
    return clod_sim_row(&view, 0);
}

#define LETHE_STIFFNESS 505148.775 ///< N/m
#define LETHE_DAMPING 752.88184    ///< N s/m
#define LETHE_RADIUS 0.1           ///< m
#define LETHE_DENSITY 2600.0       ///< kg/m3
#define LETHE_GRAVITY 9.81
#define LETHE_TIME 0.6

/** Height and velocity of Lethe's ball, which falls 0.7 m or so onto a spring k with a dash-pot c
 *  that may pull, by small steps of the two forms of motion (velocity Verlet, 0.1 us). */
static void expect_lethe(double touches, double at[2])
{
    const double mass = LETHE_DENSITY * 4.0 / 3.0 * M_PI * pow(LETHE_RADIUS, 3.0);
    const double dt = 1e-7;
    double z = 0.8, v = 0.0;
    for (long s = 0; s < lround(LETHE_TIME / dt); s++) {
        const double middle = z + 0.5 * dt * v;
        const double overlap = touches - middle;
        double push = 0.0;
        if (overlap > 0.0) {
            push = LETHE_STIFFNESS * overlap - LETHE_DAMPING * v;
        }
        v += dt * (push / mass - LETHE_GRAVITY);
        z = middle + 0.5 * dt * v;
    }
    at[0] = z;
    at[1] = v;
}

/** The ball of Lethe's tests (PR 1746) on the seam of two triangles, or in an upright groove. */
static clod_sim *lethe(const char *folder, double slope)
{
    mesh_file file = mesh_file_open(folder, "two");
    const double left[3] = {-1.0, 0.0, slope}, right[3] = {1.0, 0.0, slope};
    mesh_file_facet(&file, (double[3]){0.0, -1.0, 0.0}, (double[3]){0.0, 1.0, 0.0}, left);
    mesh_file_facet(&file, (double[3]){0.0, 1.0, 0.0}, (double[3]){0.0, -1.0, 0.0}, right);
    mesh_file_close(&file);
    const double mass = LETHE_DENSITY * 4.0 / 3.0 * M_PI * pow(LETHE_RADIUS, 3.0);
    const double zeta = LETHE_DAMPING / (2.0 * sqrt(LETHE_STIFFNESS * mass));
    char law[128];
    snprintf(law, sizeof law, "law: hooke, k1: %.17g N/m, restitution: %.17g, friction: 0",
             LETHE_STIFFNESS, exp(-zeta * M_PI / sqrt(1.0 - zeta * zeta)));
    const clod_sim_grain ball = {.id = 1, .radius = LETHE_RADIUS, .position = {0.0, 0.0, 0.8}};
    clod_sim *sim =
        drop(&file, "1 m", law, LETHE_DENSITY, "[0 m/s2, 0 m/s2, -9.81 m/s2]", "1e-6 s", &ball);
    CHECK(clod_sim_advance(sim, lround(LETHE_TIME * 1e6), &status));
    return sim;
}

/** Counted twice it would be at 0.25285 m; PEERS gives 0.34526 m and 0.16634 m/s. */
static void a_ball_on_a_seam_is_pushed_once(void **temporary)
{
    clod_sim *sim = lethe(*temporary, 0.0);
    double at[2];
    expect_lethe(LETHE_RADIUS, at);
    check_close(at[0], 0.34526, 1e-4); // the two computations agree
    check_close(at[1], 0.16634, 1e-3);
    check_close(row(sim, "position")[2], at[0], 1e-4);
    check_close(row(sim, "velocity")[2], at[1], 1e-3);
    clod_sim_destroy(&sim);
}

/** Two sides at 45 degrees push together as one spring; once counted it would be at 0.448 m. */
static void a_ball_in_a_groove_is_pushed_by_both_sides(void **temporary)
{
    clod_sim *sim = lethe(*temporary, 1.0);
    double at[2];
    expect_lethe(LETHE_RADIUS * sqrt(2.0), at);
    check_close(at[0], 0.37329, 1e-4);
    check_close(at[1], -0.0119, 1e-3);
    check_close(row(sim, "position")[2], at[0], 1e-4);
    check_close(row(sim, "velocity")[2], at[1], 1e-3);
    check_close(row(sim, "position")[0], 0.0, 1e-9);
    clod_sim_destroy(&sim);
}

/** On a ridge of 90 degrees the edge pushes, once: as a plane at its height does. */
static void a_ball_on_a_ridge_is_pushed_once(void **temporary)
{
    clod_sim *sim = lethe(*temporary, -1.0);
    double at[2];
    expect_lethe(LETHE_RADIUS, at);
    check_close(row(sim, "position")[2], at[0], 1e-4);
    check_close(row(sim, "velocity")[2], at[1], 1e-3);
    check_close(row(sim, "position")[0], 0.0, 1e-9);
    clod_sim_destroy(&sim);
}

/** A ball whose centre falls 0.3 r beside the edge of the ridge leaves as a mirror does, across the
 *  line from the edge to its centre: v - 2 (v n) n with v^2 = 2 g (0.8 m - sqrt(r^2 - b^2)). The
 *  line turns while it touches, by less than overlap / r = 1 %. */
static void a_ball_beside_a_ridge_is_turned_aside(void **temporary)
{
    mesh_file file = mesh_file_open(*temporary, "ridge");
    mesh_file_facet(&file, (double[3]){0.0, -1.0, 0.0}, (double[3]){0.0, 1.0, 0.0},
                    (double[3]){-1.0, 0.0, -1.0});
    mesh_file_facet(&file, (double[3]){0.0, 1.0, 0.0}, (double[3]){0.0, -1.0, 0.0},
                    (double[3]){1.0, 0.0, -1.0});
    mesh_file_close(&file);
    const double beside = 0.3 * LETHE_RADIUS, height = sqrt(0.91) * LETHE_RADIUS;
    const clod_sim_grain ball = {
        .id = 1, .radius = LETHE_RADIUS, .position = {beside, 0.1, 0.8}};
    clod_sim *sim = drop(&file, "1 m", "law: hooke, k1: 2e8 N/m, restitution: 1, friction: 0",
                         LETHE_DENSITY, "[0 m/s2, 0 m/s2, -9.81 m/s2]", "1e-6 s", &ball);
    const double time = 0.4, until = sqrt(2.0 * (0.8 - height) / LETHE_GRAVITY);
    const double speed = LETHE_GRAVITY * until;
    CHECK(clod_sim_advance(sim, lround(time * 1e6), &status));
    check_close(row(sim, "velocity")[0], 2.0 * 0.3 * sqrt(0.91) * speed, 0.01 * speed);
    check_close(row(sim, "velocity")[2],
                (2.0 * 0.91 - 1.0) * speed - LETHE_GRAVITY * (time - until), 0.01 * speed);
    check_close(row(sim, "velocity")[1], 0.0, 1e-12);
    clod_sim_destroy(&sim);
}

/** The box of 50 mm of DEM-Engine's issue 73, in 1200 facets: impact at 0.610557 m/s, half of it
 *  back, straight up. */
static void a_ball_bounces_in_a_box_as_on_a_plane(void **temporary)
{
    mesh_file file = mesh_file_open(*temporary, "box");
    for (int a = 0; a < 3; a++) {
        for (int side = 0; side < 2; side++) {
            double at[3] = {0.0, 0.0, 0.0}, u[3] = {0.0}, v[3] = {0.0};
            at[a] = 50.0 * side;
            u[(a + 1) % 3] = 50.0;
            v[(a + 2) % 3] = 50.0;
            mesh_file_sheet(&file, at, u, v, 10, 10);
        }
    }
    mesh_file_close(&file);
    const clod_sim_grain ball = {.id = 1, .radius = 1e-3, .position = {0.01, 0.02, 0.01}};
    clod_sim *sim = drop(&file, "1 mm", "law: hertz, restitution: 0.5, friction: 0.35", 2600.0,
                         "[0 m/s2, -9.81 m/s2, 0 m/s2]", "1e-6 s", &ball);
    double impact = 0.0, rebound = 0.0;
    for (int k = 0; k < 1300; k++) { // falls for 62.2 ms
        CHECK(clod_sim_advance(sim, 50, &status));
        const double v = row(sim, "velocity")[1];
        impact = fmin(impact, v);
        rebound = fmax(rebound, v);
    }
    check_close(impact, -0.610557, 5e-4); // looked at every 50 us
    check_close(rebound, 0.5 * 0.610557, 5e-3 * 0.610557 + 5e-4);
    check_close(row(sim, "velocity")[0], 0.0, 1e-12);
    check_close(row(sim, "velocity")[2], 0.0, 1e-12);
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_ball_on_a_seam_is_pushed_once, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_ball_in_a_groove_is_pushed_by_both_sides,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_ball_on_a_ridge_is_pushed_once, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_ball_beside_a_ridge_is_turned_aside, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_ball_bounces_in_a_box_as_on_a_plane, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
