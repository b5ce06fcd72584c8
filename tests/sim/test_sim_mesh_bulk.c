// Bulk solid on meshes, beside its twin of shapes in the same state: a box to the last bit,
// a drum that turns and a hopper within what the facets are off the circle. At length, with
// statistics: clod verify --slow mesh-drum, mesh-hopper, mesh-ring.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/sanitized.h"
#include "support/sim_made.h"

#define DRUM 0.03 ///< m, radius
#define SIDES 7200
#define ORIFICE 0.01 ///< m, radii of the hopper
#define WIDE 0.03
#define CONE 0.03464 ///< m, height: 30 degrees from the vertical

static const char CASE[] =
    "gravity: %s\n"
    "materials: {bead: {density: 2500 kg/m3, youngs_modulus: 2 MPa, poissons_ratio: 0.25},\n"
    "            end: {youngs_modulus: 2 MPa, poissons_ratio: 0.25}}\n"
    "contacts: {default: {law: hertz, restitution: 0.5, friction: 0.5, rolling: epsd2,\n"
    "                     rolling_friction: 0.1}, bead-end: {friction: 0, rolling: none}}\n"
    "domain: {min: [-0.04 m, -0.04 m, -0.02 m], max: [0.04 m, 0.04 m, 0.14 m]}\n"
    "%s"
    "stages: [{name: run, duration: 10 s}]\n"
    "time: {step: 1e-5 s, design_stress: 1 kPa}\n"
    "walls:\n"
    "  wall: {material: bead, %s, shapes: [%s]}\n"
    "%s";

/** What a twin has in common with the others. */
typedef struct scene {
    const char *gravity, *grains, *motion, *others;
} scene;

static clod_sim *make(const scene *self, bool filled, const char *shapes)
{
    char text[3 * PATH_MAX];
    snprintf(text, sizeof text, CASE, self->gravity, filled ? self->grains : "", self->motion,
             shapes, self->others);
    return sim_made(text, 1);
}

static const char *shapes_of(const mesh_file *file)
{
    static char text[PATH_MAX + 64];
    snprintf(text, sizeof text, "{mesh: {file: %s, unit: 1 m}}", file->path);
    return text;
}

/** Grains as they are in another simulation, without their contacts. */
static void copy_grains(clod_sim *to, clod_sim *from)
{
    const clod_sim_view place = sim_view(from, "position"), speed = sim_view(from, "velocity");
    const clod_sim_view spin = sim_view(from, "angular_velocity");
    const clod_sim_view radius = sim_view(from, "radius");
    for (size_t g = 0; g < clod_sim_grain_count(from); g++) {
        clod_sim_grain grain = {.id = 1 + g, .radius = *clod_sim_row(&radius, g)};
        memcpy(grain.position, clod_sim_row(&place, g), sizeof grain.position);
        memcpy(grain.velocity, clod_sim_row(&speed, g), sizeof grain.velocity);
        memcpy(grain.angular_velocity, clod_sim_row(&spin, g), sizeof grain.angular_velocity);
        CHECK(clod_sim_add_grain(to, &grain, &status));
    }
}

/** Mean force [N] and torque about z [N m] on the wall over the steps of 2 ms. */
static void feel(const scene *self, clod_sim *from, const char *shapes, double felt[4])
{
    clod_sim *sim = make(self, false, shapes);
    copy_grains(sim, from);
    memset(felt, 0, 4 * sizeof *felt);
    for (int k = 0; k < 200; k++) {
        clod_sim_wall wall;
        CHECK(clod_sim_advance(sim, 1, &status));
        CHECK(clod_sim_wall_look(sim, 0, &wall, &status));
        for (int c = 0; c < 4; c++) {
            felt[c] += (c < 3 ? wall.force[c] : wall.torque[2]) / 200.0;
        }
    }
    clod_sim_destroy(&sim);
}

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

/**
 * The facets lie between the circle that they are cut from and the one inside, which touches
 * their middles, 3 nm apart: so does the force, as far as it depends on the overlap. And they
 * point by pi/SIDES at most beside the radius: so does each contact's force, of which all
 * together are no more than twice their sum. That is 1e-3 of the force: a contact that counts
 * twice or not at all, or rubs otherwise, is seen.
 */
static void check_between(const double mesh[4], const double outer[4], const double inner[4])
{
    double square = 0.0, off = 0.0, size = 0.0;
    for (int c = 0; c < 3; c++) {
        square += (inner[c] - outer[c]) * (inner[c] - outer[c]);
        off += (mesh[c] - outer[c]) * (mesh[c] - outer[c]);
        size += outer[c] * outer[c];
    }
    const double most = sqrt(square) + M_PI / SIDES * 2.0 * sqrt(size);
    check_at_most(most, 1.2e-3 * sqrt(size));
    check_at_most(sqrt(off), most);
    check_at_most(fabs(mesh[3] - outer[3]), most * WIDE);
}

#define DOWN_Y "[0 m/s2, -9.81 m/s2, 0 m/s2]"
#define DOWN_Z "[0 m/s2, 0 m/s2, -9.81 m/s2]"

/** Text of a shape about z, with radii in it; two are kept. */
static const char *round_shape(const char *format, double first, double second)
{
    static char text[2][256];
    static int k;
    k = 1 - k;
    snprintf(text[k], sizeof text[k], format, first, second);
    return text[k];
}

#define INNER cos(M_PI / SIDES)
#define DRUM_SHAPE "{cylinder: {foot: [0 m, 0 m, -5 mm], radius: %.17g m, length: 30 mm}}"

static void a_drum_of_facets_is_a_cylinder(void **temporary)
{
    mesh_file file = mesh_file_open(*temporary, "drum");
    turn(&file, (double[2]){DRUM, -0.005}, (double[2]){DRUM, 0.025});
    mesh_file_close(&file);
    const scene drum = {
        DOWN_Y,
        "grains: [{material: bead, count: 200, radius: {distribution: uniform, min: 2.2 mm, "
        "max: 2.8 mm},\n"
        "          region: {annulus: {center: [0 m, 0 m, 0 m], outer_radius: 27 mm, height: 20 "
        "mm}}}]\n",
        "spin: 4 rad/s",
        "  ends: {material: end, shapes: [{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}, "
        "{plane: {point: [0 m, 0 m, 20 mm], normal: [0, 0, -1]}}]}\n"};
    clod_sim *sim = make(&drum, true, round_shape(DRUM_SHAPE, DRUM, 0.0));
    for (int k = 0; k < (sanitized() ? 1 : 5); k++) {
        double mesh[4], outer[4], inner[4];
        CHECK(clod_sim_advance(sim, 10000, &status));
        feel(&drum, sim, shapes_of(&file), mesh);
        feel(&drum, sim, round_shape(DRUM_SHAPE, DRUM, 0.0), outer);
        feel(&drum, sim, round_shape(DRUM_SHAPE, DRUM * INNER, 0.0), inner);
        check_between(mesh, outer, inner);
    }
    clod_sim_destroy(&sim);
}

#define HOPPER_SHAPE                                                                           \
    "{cone: {foot: [0 m, 0 m, 0 m], foot_radius: %.17g m, top_radius: 30 mm, length: 34.64 mm}}"

/** Under a bed that comes to rest in it; its cylinder stays what it is. */
static void a_hopper_of_facets_is_a_cone(void **temporary)
{
    mesh_file file = mesh_file_open(*temporary, "hopper");
    turn(&file, (double[2]){ORIFICE, 0.0}, (double[2]){WIDE, CONE});
    mesh_file_close(&file);
    const scene hopper = {
        DOWN_Z,
        "grains: [{material: bead, count: 600, radius: {distribution: uniform, min: 2.2 mm, "
        "max: 2.8 mm},\n"
        "          region: {annulus: {center: [0 m, 0 m, 35 mm], outer_radius: 27 mm, height: "
        "80 mm}}}]\n",
        "spin: 0 rad/s",
        "  ends: {material: bead, shapes: [{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}, "
        "{cylinder: {foot: [0 m, 0 m, 34.64 mm], radius: 30 mm, length: 85 mm}}]}\n"};
    clod_sim *sim = make(&hopper, true, round_shape(HOPPER_SHAPE, ORIFICE, WIDE));
    for (int k = 0; k < (sanitized() ? 1 : 3); k++) {
        double mesh[4], outer[4], inner[4];
        CHECK(clod_sim_advance(sim, 10000, &status));
        feel(&hopper, sim, shapes_of(&file), mesh);
        feel(&hopper, sim, round_shape(HOPPER_SHAPE, ORIFICE, WIDE), outer);
        feel(&hopper, sim, round_shape(HOPPER_SHAPE, ORIFICE * INNER, WIDE * INNER), inner);
        check_between(mesh, outer, inner);
    }
    clod_sim_destroy(&sim);
}

/** A box whose grains fly about and into a corner, of six planes or of six sheets of 70 facets: the
 *  same bits, with edges and corners, sliding and rolling history, and 200 grains that knock each
 *  other about. */
static void a_box_of_facets_is_one_of_planes(void **temporary)
{
    enum { L = 64 }; // 1/64 m and 1/16 m are what they are in files of any precision
    static const double w = 2.0 / L, h = 4.0 / L, e = 1.0 / L;
    const double SIDE[6][3][3] = {
        {{-e, -e, 0.0}, {w, 0.0, 0.0}, {0.0, w, 0.0}},
        {{-e, -e, 0.0}, {0.0, w, 0.0}, {0.0, 0.0, h}},
        {{e, -e, 0.0}, {0.0, 0.0, h}, {0.0, w, 0.0}},
        {{-e, -e, 0.0}, {0.0, 0.0, h}, {w, 0.0, 0.0}},
        {{-e, e, 0.0}, {w, 0.0, 0.0}, {0.0, 0.0, h}},
        {{-e, -e, h}, {0.0, w, 0.0}, {w, 0.0, 0.0}},
    };
    static const char PLANES[] =
        "{plane: {point: [0 m, 0 m, 0 m], normal: [0, 0, 1]}}, "
        "{plane: {point: [-0.015625 m, 0 m, 0 m], normal: [1, 0, 0]}}, "
        "{plane: {point: [0.015625 m, 0 m, 0 m], normal: [-1, 0, 0]}}, "
        "{plane: {point: [0 m, -0.015625 m, 0 m], normal: [0, 1, 0]}}, "
        "{plane: {point: [0 m, 0.015625 m, 0 m], normal: [0, -1, 0]}}, "
        "{plane: {point: [0 m, 0 m, 0.0625 m], normal: [0, 0, -1]}}";
    mesh_file file = mesh_file_open(*temporary, "box");
    for (int f = 0; f < 6; f++) {
        mesh_file_sheet(&file, SIDE[f][0], SIDE[f][1], SIDE[f][2], 7, 5);
    }
    mesh_file_close(&file);
    const scene box = {
        "[-6 m/s2, 4 m/s2, -7 m/s2]",
        "grains: [{material: bead, count: 200, radius: {distribution: uniform, min: 2.2 mm, "
        "max: 2.8 mm},\n"
        "          region: {box: {min: [-15 mm, -15 mm, 0 mm], max: [15 mm, 15 mm, 60 mm]}}, velocity: [0.4 m/s, -0.2 m/s, 0.2 m/s]}]\n",
        "spin: 0 rad/s", ""};
    clod_sim *planes = make(&box, true, PLANES);
    clod_sim *facets = make(&box, true, shapes_of(&file));
    for (int k = 0; k < (sanitized() ? 4 : 10); k++) { // all lie in the corner after 0.1 s
        CHECK(clod_sim_advance(planes, 3000, &status));
        CHECK(clod_sim_advance(facets, 3000, &status));
        for (uint64_t id = 1; id <= clod_sim_grain_count(planes); id++) {
            const clod_sim_view a = sim_view(planes, "position"),
                                b = sim_view(facets, "position");
            assert_memory_equal(clod_sim_row(&a, clod_sim_row_of_id(planes, id)),
                                clod_sim_row(&b, clod_sim_row_of_id(facets, id)),
                                3 * sizeof(double));
        }
    }
    clod_sim_destroy(&planes);
    clod_sim_destroy(&facets);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_box_of_facets_is_one_of_planes, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_drum_of_facets_is_a_cylinder, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_hopper_of_facets_is_a_cone, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
