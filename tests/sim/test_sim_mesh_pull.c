// The pull with which a grain comes off a mesh: at seams, ridges and corners that of a plane,
// which follows by hand from the largest overlap.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/sim_made.h"

#define RADIUS 0.05
#define SPEED 0.005 ///< m/s, of the wall
#define STEP 1e-6   ///< s
#define PRESS 20000 ///< steps of pressing from the first touch: 0.1 mm

#define K1 4.75e4
#define K2 2.37e5
#define K_ADH 2e4
#define F0 0.001
#define SOFT 1e4 ///< N/m, luding: k1
#define STIFF 5e4
#define DEPTH 0.05

/** A law with its largest pull after an overlap [N]. */
typedef struct law {
    const char *keys;
    double (*pull)(double overlap);
} law;

/** docs/theory/mepa.md: k_adh d_min^n. */
static double pull_mepa(double overlap)
{
    return K_ADH * pow(overlap, 1.5) * (K2 - K1) / (K2 + K_ADH);
}

/** docs/theory/eepa.md: |f0| + k_adh P/(1 + k_adh/k2). */
static double pull_eepa(double overlap)
{
    return F0 + K_ADH * (1.0 - K1 / K2) * pow(overlap, 1.5) / (1.0 + K_ADH / K2);
}

/** docs/theory/luding.md: kc d_min, d_min = (k2 - k1)/(k2 + kc) d_max; R* is R at a wall. */
static double pull_luding(double overlap)
{
    const double limit = STIFF / (STIFF - SOFT) * DEPTH * 2.0 * RADIUS;
    const double k2 = SOFT + (STIFF - SOFT) * overlap / limit;
    return SOFT * (k2 - SOFT) / (k2 + SOFT) * overlap;
}

static const law LAWS[] = {
    {"law: mepa, exponent: 1.5, k1: 4.75e4 N/m^1.5, k2: 2.37e5 N/m^1.5, k_adh: 2e4 N/m^1.5, "
     "restitution: 1",
     pull_mepa},
    {"law: eepa, exponent: 1.5, k1: 4.75e4 N/m^1.5, k2: 2.37e5 N/m^1.5, k_adh: 2e4 N/m^1.5, "
     "pull_off_force: 0.001 N, restitution: 1",
     pull_eepa},
    {"law: luding, k1: 1e4 N/m, k2: 5e4 N/m, k_adh: 1e4 N/m, plasticity_depth: 5 %, "
     "restitution: 1",
     pull_luding},
};

/** Press a mesh against a grain that is too heavy to move, at a place above which it is, and take
 *  it away: the largest pull. */
static double pull_at(const mesh_file *mesh, const law *of, const double place[3],
                      double *overlap)
{
    char text[PATH_MAX + 1024];
    snprintf(text, sizeof text,
             "materials: {ore: {density: 1e7 kg/m3}}\n"
             "contacts: {default: {%s, friction: 0.3}}\n"
             "gravity: [0 m/s2, 0 m/s2, 0 m/s2]\n"
             "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
             "walls: {wall: {material: ore, velocity: [0 m/s, 0 m/s, 0.005 m/s],\n"
             "               shapes: [{mesh: {file: %s, unit: 1 m}}]}}\n"
             "stages: [{name: run, duration: 1 s}]\n"
             "time: {step: 1e-6 s, design_stress: 10 kPa}\n",
             of->keys, mesh->path);
    clod_sim *sim = sim_made(text, 1);
    const clod_sim_grain grain = {
        .id = 1, .radius = RADIUS, .position = {place[0], place[1], place[2] + RADIUS}};
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    CHECK(clod_sim_advance(sim, PRESS, &status));
    *overlap = SPEED * STEP * PRESS; // it has moved the grain by about 1e-8 m
    CHECK(clod_sim_set_wall_velocity(sim, 0, (double[3]){0.0, 0.0, -SPEED}, &status));
    double most = 0.0;
    for (int k = 0; k < PRESS + 10; k++) {
        clod_sim_wall wall;
        CHECK(clod_sim_advance(sim, 1, &status));
        CHECK(clod_sim_wall_look(sim, 0, &wall, &status));
        most = fmax(most, wall.force[2]);
        // corners are where the file has them within 1e-8 m or so
        check_close(wall.force[0], 0.0, 1e-6 * K1 * pow(*overlap, 1.5));
        check_close(wall.force[1], 0.0, 1e-6 * K1 * pow(*overlap, 1.5));
    }
    clod_sim_destroy(&sim);
    return most;
}

/** Everywhere on a mesh: within what the sampling at steps leaves. */
static void check_places(const mesh_file *mesh, const double (*places)[3], size_t count)
{
    for (size_t l = 0; l < sizeof LAWS / sizeof *LAWS; l++) {
        for (size_t p = 0; p < count; p++) {
            double overlap;
            const double pull = pull_at(mesh, &LAWS[l], places[p], &overlap);
            const double expected = LAWS[l].pull(overlap);
            if (fabs(pull - expected) > 1e-3 * expected) {
                fail_msg("law %zu place %zu: a pull of %.9g N, not %.9g", l, p, pull, expected);
            }
        }
    }
}

/** In a facet; on a seam; where six facets meet; on a line with a T-junction. */
static void seams_of_a_plane(void **temporary)
{
    mesh_file file = mesh_file_open(*temporary, "plane");
    mesh_file_sheet(&file, (double[3]){-0.1, -0.1, 0.0}, (double[3]){0.1, 0.0, 0.0},
                    (double[3]){0.0, 0.2, 0.0}, 4, 4);
    mesh_file_sheet(&file, (double[3]){0.0, -0.1, 0.0}, (double[3]){0.1, 0.0, 0.0},
                    (double[3]){0.0, 0.2, 0.0}, 2, 3);
    mesh_file_close(&file);
    static const double PLACES[][3] = {
        {-0.03, 0.01, 0.0}, {-0.05, 0.02, 0.0}, {-0.05, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    check_places(&file, PLACES, 4);
}

/** Ridges of 10 and 90 degrees, the first of which is smooth. */
static void ridges(void **temporary)
{
    static const double SLOPES[] = {0.0875, 1.0};
    static const double PLACES[][3] = {{0.0, 0.013, 0.0}, {0.0, 0.05, 0.0}};
    for (int k = 0; k < 2; k++) {
        const double z = -0.1 * SLOPES[k];
        mesh_file file = mesh_file_open(*temporary, "ridge");
        mesh_file_sheet(&file, (double[3]){0.0, -0.1, 0.0}, (double[3]){0.1, 0.0, z},
                        (double[3]){0.0, 0.2, 0.0}, 3, 4);
        mesh_file_sheet(&file, (double[3]){-0.1, -0.1, z}, (double[3]){0.1, 0.0, -z},
                        (double[3]){0.0, 0.2, 0.0}, 3, 4);
        mesh_file_close(&file);
        check_places(&file, PLACES, 2);
    }
}

/** The tip of a pyramid. */
static void a_corner(void **temporary)
{
    static const double TIP[3] = {0.001, 0.002, 0.003};
    static const double FOOT[4][3] = {
        {-0.05, -0.05, -0.04}, {0.05, -0.05, -0.05}, {0.06, 0.05, -0.04}, {-0.05, 0.06, -0.06}};
    mesh_file file = mesh_file_open(*temporary, "pyramid");
    for (int k = 0; k < 4; k++) {
        mesh_file_facet(&file, TIP, FOOT[k], FOOT[(k + 1) % 4]);
    }
    mesh_file_close(&file);
    check_places(&file, &TIP, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(seams_of_a_plane, temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(ridges, temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_corner, temp_folder_make, temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
