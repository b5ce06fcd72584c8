// A drum that turns, as a cylinder and as a polygon of facets.
#include <math.h>

#include "verify/facets.h"
#include "verify/suite.h"
#include "verify/twin.h"

#define RADIUS 0.06 ///< m, of the drum, about z; gravity points along -y
#define LENGTH 0.03 ///< m
#define SPIN 3.0    ///< rad/s
#define SIDES 480
#define GRAINS 1000
#define STEADY 1.0 ///< s, from here on it is measured
#define END 3.0    ///< s

static const char *const QUANTITIES[] = {"angle of the centre of mass from straight down [deg]",
                                         "torque on the drum [N m]"};

static void put_case(FILE *out, bool mesh, int seed)
{
    fprintf(out,
            "# Written by clod verify.\n"
            "title: Rotating drum\n"
            "seed: %d\n"
            "gravity: [0 m/s2, -9.81 m/s2, 0 m/s2]\n"
            "materials: {bead: {density: 2500 kg/m3, youngs_modulus: 2 MPa, "
            "poissons_ratio: 0.25}, end: {youngs_modulus: 2 MPa, poissons_ratio: 0.25}}\n"
            "contacts:\n"
            "  default: {law: hertz, restitution: 0.6, friction: 0.5, rolling: epsd2, "
            "rolling_friction: 0.05}\n"
            "  bead-end: {friction: 0, rolling: none}\n"
            "domain: {min: [-0.07 m, -0.07 m, -0.01 m], max: [0.07 m, 0.07 m, 0.04 m]}\n"
            "grains:\n"
            "  - material: bead\n"
            "    count: %d\n"
            "    radius: {distribution: uniform, min: 2.25 mm, max: 2.75 mm}\n"
            "    region: {annulus: {center: [0 m, 0 m, 0 m], outer_radius: 55 mm, "
            "height: 30 mm}}\n"
            "walls:\n"
            "  drum:\n"
            "    material: bead\n"
            "    spin: %g rad/s\n"
            "    spin_axis: [0, 0, 1]\n",
            seed, GRAINS, SPIN);
    if (mesh) {
        fprintf(out, "    shapes: [{mesh: {file: drum.stl, unit: 1 m}}]\n");
    } else {
        fprintf(out,
                "    shapes: [{cylinder: {foot: [0 m, 0 m, -0.005 m], axis: [0, 0, 1], radius: "
                "%g m, length: 0.04 m, side: inside}}]\n",
                RADIUS);
    }
    fprintf(out,
            "  ends:\n"
            "    material: end\n"
            "    shapes:\n"
            "      - plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}\n"
            "      - plane: {point: [0 m, 0 m, %g m], normal: [0, 0, -1]}\n"
            "stages: [{name: turn, duration: %g s}]\n"
            "output: {series_interval: 5 ms}\n",
            LENGTH, END);
}

static bool put_meshes(const char *folder, clod_status *status)
{
    clod_verify_facets drum;
    static const double LINE[][2] = {{RADIUS, -0.005}, {RADIUS, 0.035}};
    if (!clod_verify_facets_open(&drum, folder, "drum", status)) {
        return false;
    }
    clod_verify_facets_lathe(&drum, LINE, 2, SIDES);
    return clod_verify_facets_close(&drum, status);
}

static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    (void)status;
    const clod_grains *grains = &now->state.grains;
    const clod_wall *drum = &now->state.walls.wall[0];
    double x = 0.0, y = 0.0;
    if (now->state.time < STEADY) {
        return true;
    }
    for (size_t g = 0; g < grains->count; g++) {
        x += grains->velocity[g][3] * grains->position[g][0];
        y += grains->velocity[g][3] * grains->position[g][1];
    }
    clod_verify_twin_add(context, 0, atan2(x, -y) * 180.0 / M_PI);
    clod_verify_twin_add(context, 1, drum->sum_torque.z / (double)drum->sum_steps);
    return true;
}

bool clod_verify_mesh_drum(const clod_verify_bench *bench, clod_status *status)
{
    const clod_verify_twin twin = {.name = "mesh-drum",
                                   .quantities = QUANTITIES,
                                   .count = 2,
                                   .put_case = put_case,
                                   .put_meshes = put_meshes,
                                   .look = look};
    return clod_verify_twin_compare(&twin, bench, status);
}
