// Grains in a drum that turns and in a hopper that is full, as meshes and as shapes: what a wall
// feels of a bulk solid. clod verify --slow mesh-drum, mesh-hopper, mesh-ring do it at length.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/sim_made.h"

#define BLOCKS 8
#define DRUM 0.03 ///< m, radius
#define SIDES 240
#define ORIFICE 0.01 ///< m, radii of the hopper
#define WIDE 0.03
#define CONE 0.03464 ///< m, height: 30 degrees from the vertical
#define HIGH 0.12

/** A line that turns about z, between (r, z) and (r, z). */
static void turn(mesh_file *file, const double from[2], const double to[2])
{
    for (int s = 0; s < SIDES; s++) {
        const double a = 2.0 * M_PI * s / SIDES, b = 2.0 * M_PI * (s + 1) / SIDES;
        const double p[4][3] = {{from[0] * cos(a), from[0] * sin(a), from[1]},
                                {from[0] * cos(b), from[0] * sin(b), from[1]},
                                {to[0] * cos(b), to[0] * sin(b), to[1]},
                                {to[0] * cos(a), to[0] * sin(a), to[1]}};
        mesh_file_facet(file, p[0], p[1], p[2]);
        mesh_file_facet(file, p[0], p[2], p[3]);
    }
}

static const char CASE[] =
    "gravity: %s\n"
    "materials: {bead: {density: 2500 kg/m3, youngs_modulus: 2 MPa, poissons_ratio: 0.25},\n"
    "            end: {youngs_modulus: 2 MPa, poissons_ratio: 0.25}}\n"
    "contacts: {default: {law: hertz, restitution: 0.5, friction: 0.5, rolling: epsd2,\n"
    "                     rolling_friction: 0.1}, bead-end: {friction: 0, rolling: none}}\n"
    "domain: {min: [-0.04 m, -0.04 m, -0.02 m], max: [0.04 m, 0.04 m, 0.14 m]}\n"
    "grains: [{material: bead, count: %d, radius: {distribution: uniform, min: 2.2 mm, max: 2.8 "
    "mm},\n"
    "          region: {annulus: {center: [0 m, 0 m, %g m], outer_radius: 27 mm, height: %g m}}}]\n"
    "stages: [{name: run, duration: 10 s}]\n"
    "walls:\n"
    "  wall: {material: bead, %s, shapes: [%s]}\n"
    "  ends: {material: end, shapes: [%s]}\n";

static clod_sim *make(const char *gravity, int count, double from, double height,
                      const char *motion, const char *shapes, const char *ends)
{
    char text[3 * PATH_MAX];
    snprintf(text, sizeof text, CASE, gravity, count, from, height, motion, shapes, ends);
    return sim_made(text, 1);
}

/** Mean and its error from blocks. */
typedef struct mean {
    double value, error;
} mean;

static mean mean_of(const double block[BLOCKS])
{
    mean self = {0.0, 0.0};
    for (int b = 0; b < BLOCKS; b++) {
        self.value += block[b] / BLOCKS;
    }
    for (int b = 0; b < BLOCKS; b++) {
        self.error += (block[b] - self.value) * (block[b] - self.value);
    }
    self.error = sqrt(self.error / (BLOCKS - 1) / BLOCKS);
    return self;
}

/** Both agree within 3.4 errors of their difference: 99.5 % of Student's t with 14 degrees. */
static void check_same(const char *what, mean mesh, mean shapes)
{
    const double error = hypot(mesh.error, shapes.error);
    if (fabs(mesh.value - shapes.value) > 3.4 * error) {
        fail_msg("%s: %.5g +- %.2g as mesh, %.5g +- %.2g as shapes", what, mesh.value,
                 mesh.error, shapes.value, shapes.error);
    }
}

/** Angle of the centre of mass from straight down [rad], and torque on the drum [N m]. */
static void run_drum(clod_sim *sim, mean *angle, mean *torque)
{
    double turned[BLOCKS] = {0.0}, felt[BLOCKS] = {0.0};
    const int64_t steps = (int64_t)lround(0.01 / clod_sim_dt(sim));
    CHECK(clod_sim_advance(sim, 60 * steps, &status));
    for (int k = 0; k < 20 * BLOCKS; k++) {
        CHECK(clod_sim_advance(sim, steps, &status));
        const clod_sim_view places = sim_view(sim, "position"), masses = sim_view(sim, "mass");
        double x = 0.0, y = 0.0;
        for (size_t g = 0; g < clod_sim_grain_count(sim); g++) {
            const double *p = clod_sim_row(&places, g), mass = *clod_sim_row(&masses, g);
            x += mass * p[0];
            y += mass * p[1];
        }
        clod_sim_wall wall;
        CHECK(clod_sim_wall_look(sim, 0, &wall, &status));
        turned[k / 20] += atan2(x, -y) / 20.0;
        felt[k / 20] += wall.torque[2] / 20.0;
    }
    *angle = mean_of(turned);
    *torque = mean_of(felt);
    clod_sim_destroy(&sim);
}

#define DOWN_Y "[0 m/s2, -9.81 m/s2, 0 m/s2]"
#define ENDS                                                                                    \
    "{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}, {plane: {point: [0 m, 0 m, 20 mm], " \
    "normal: [0, 0, -1]}}"

static void a_drum_of_facets_turns_as_a_cylinder(void **temporary)
{
    mesh_file file = mesh_file_open(*temporary, "drum");
    turn(&file, (double[2]){DRUM, -0.005}, (double[2]){DRUM, 0.025});
    mesh_file_close(&file);
    char shapes[PATH_MAX + 64];
    snprintf(shapes, sizeof shapes, "{mesh: {file: %s, unit: 1 m}}", file.path);
    mean angle[2], torque[2];
    run_drum(make(DOWN_Y, 200, 0.0, 0.02, "spin: 4 rad/s", shapes, ENDS), &angle[0],
             &torque[0]);
    run_drum(make(DOWN_Y, 200, 0.0, 0.02, "spin: 4 rad/s",
                  "{cylinder: {foot: [0 m, 0 m, -5 mm], radius: 30 mm, length: 30 mm}}", ENDS),
             &angle[1], &torque[1]);
    check_same("angle of the centre of mass", angle[0], angle[1]);
    check_same("torque", torque[0], torque[1]);
    assert_true(angle[1].value > 0.3 && torque[1].value < 0.0); // it does turn them
}

/** Force of grains at rest on the hopper, down [N]; with that on the floor it is their weight. */
static double run_hopper(clod_sim *sim)
{
    clod_sim_wall hopper, floor;
    CHECK(clod_sim_advance(sim, (int64_t)lround(0.6 / clod_sim_dt(sim)), &status));
    CHECK(clod_sim_wall_look(sim, 0, &hopper, &status));
    CHECK(clod_sim_wall_look(sim, 1, &floor, &status));
    const clod_sim_view masses = sim_view(sim, "mass");
    double weight = 0.0;
    for (size_t g = 0; g < clod_sim_grain_count(sim); g++) {
        weight += 9.81 * *clod_sim_row(&masses, g);
    }
    check_relative(-hopper.force[2] - floor.force[2], weight, 2e-3); // the last creep a little
    check_close(hopper.force[0], 0.0, 2e-3 * weight);
    check_close(hopper.force[1], 0.0, 2e-3 * weight);
    clod_sim_destroy(&sim);
    return -hopper.force[2] / weight;
}

/** A cone carries nearly all; its mesh as much, within the scatter of packings. */
static void a_hopper_of_facets_carries_what_a_cone_does(void **temporary)
{
    static const char FLOOR[] = "{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}";
    mesh_file file = mesh_file_open(*temporary, "hopper");
    turn(&file, (double[2]){ORIFICE, 0.0}, (double[2]){WIDE, CONE});
    turn(&file, (double[2]){WIDE, CONE}, (double[2]){WIDE, HIGH});
    mesh_file_close(&file);
    char shapes[PATH_MAX + 64];
    snprintf(shapes, sizeof shapes, "{mesh: {file: %s, unit: 1 m}}", file.path);
    const char *down = "[0 m/s2, 0 m/s2, -9.81 m/s2]", *still = "spin: 0 rad/s";
    const double mesh = run_hopper(make(down, 600, 0.035, 0.08, still, shapes, FLOOR));
    const double cone = run_hopper(
        make(down, 600, 0.035, 0.08, still,
             "{cone: {foot: [0 m, 0 m, 0 m], foot_radius: 10 mm, top_radius: 30 mm, "
             "length: 34.64 mm}}, {cylinder: {foot: [0 m, 0 m, 34.64 mm], radius: 30 "
             "mm, length: 85 mm}}",
             FLOOR));
    assert_true(cone > 0.7);
    check_relative(mesh, cone, 0.05);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_drum_of_facets_turns_as_a_cylinder, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_hopper_of_facets_carries_what_a_cone_does,
                                        temp_folder_make, temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
