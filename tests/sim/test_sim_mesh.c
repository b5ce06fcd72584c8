// Grains on meshes, each beside its twin: planes, closed forms, other tessellations.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/sanitized.h"
#include "support/sim_made.h"

#define LAW_PLASTIC                                                                            \
    "law: mepa, exponent: 1.5, k1: 4.75e7 N/m^1.5, k2: 2.37e8 N/m^1.5, k_adh: 2e7 N/m^1.5, "   \
    "restitution: 0.5, friction: 0.3, rolling: epsd2, rolling_friction: 0.05"
#define LAW_LUDING                                                                             \
    "law: luding, k1: 1e5 N/m, k2: 5e5 N/m, k_adh: 1e5 N/m, plasticity_depth: 5 %, "           \
    "restitution: 0.8, friction: 0.5"
#define LAW_EEPA                                                                               \
    "law: eepa, exponent: 1.5, k1: 4.75e7 N/m^1.5, k2: 2.37e8 N/m^1.5, k_adh: 2e7 N/m^1.5, "   \
    "pull_off_force: 0.01 N, restitution: 0.5, friction: 0.4"
#define LAW_ELASTIC "law: hooke, k1: 1e5 N/m, restitution: 1, friction: 0"

/** A case with one wall; grains are added. */
static clod_sim *case_of(const char *law, const char *step, const char *gravity,
                         const char *shapes, int threads)
{
    char text[PATH_MAX + 2048];
    snprintf(text, sizeof text,
             "materials: {ore: {density: 2500 kg/m3%s}}\n"
             "contacts: {default: {%s}}\n"
             "gravity: %s\n"
             "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
             "walls: {wall: {material: ore, shapes: [%s]}}\n"
             "stages: [{name: run, duration: 1 s}]\n"
             "time: {step: %s, design_stress: 10 kPa}\n",
             strstr(law, "hertz") != NULL ? ", youngs_modulus: 5e7 Pa, poissons_ratio: 0.3"
                                          : "",
             law, gravity, shapes, step);
    return sim_made(text, threads);
}

static clod_sim *mesh_case(const char *law, const char *step, const char *gravity,
                           const mesh_file *mesh, int threads)
{
    char shapes[PATH_MAX + 64];
    snprintf(shapes, sizeof shapes, "{mesh: {file: %s, unit: 1 m}}", mesh->path);
    return case_of(law, step, gravity, shapes, threads);
}

static void add(clod_sim *sim, uint64_t id, const double at[3], const double velocity[3],
                double radius)
{
    clod_sim_grain grain = {.id = id, .radius = radius};
    memcpy(grain.position, at, sizeof grain.position);
    memcpy(grain.velocity, velocity, sizeof grain.velocity);
    CHECK(clod_sim_add_grain(sim, &grain, &status));
}

static const double *row(clod_sim *sim, const char *name, uint64_t id)
{
    const clod_sim_view view = sim_view(sim, name);
    const size_t at = clod_sim_row_of_id(sim, id);
    assert_true(at != SIZE_MAX);
    return clod_sim_row(&view, at);
}

#define WEIGHT "[0 m/s2, 0 m/s2, -9.81 m/s2]"
#define NO_WEIGHT "[0 m/s2, 0 m/s2, 0 m/s2]"

/** The square of 0.4 m at z = 0. */
static mesh_file square(const char *folder, int n, int m)
{
    mesh_file file = mesh_file_open(folder, "square");
    mesh_file_sheet(&file, (double[3]){-0.2, -0.2, 0.0}, (double[3]){0.4, 0.0, 0.0},
                    (double[3]){0.0, 0.4, 0.0}, n, m);
    mesh_file_close(&file);
    return file;
}

/** Grains that fall, hop, slide and roll, with plastic, adhesive, sliding and rolling history:
 *  the same bits as on the plane, in any cut and on any number of threads. */
static void a_sheet_is_a_plane_in_any_cut(void **temporary)
{
    enum { GRAINS = 20 };
    static const int CUTS[][2] = {{1, 1}, {10, 10}, {97, 1}};
    double twin[GRAINS][3];
    for (int k = -1; k < 3; k++) {
        const mesh_file file =
            square(*temporary, k < 0 ? 1 : CUTS[k][0], k < 0 ? 1 : CUTS[k][1]);
        clod_sim *sim = k < 0 ? case_of(LAW_PLASTIC, "2e-6 s", WEIGHT,
                                        "{plane: {point: [0 m, 0 m, 0 m]}}", 1)
                              : mesh_case(LAW_PLASTIC, "2e-6 s", WEIGHT, &file, 1 + k % 2);
        for (int g = 0; g < GRAINS; g++) {
            const double at[3] = {0.008 * (g - 10), 0.007 * (g % 5), 0.0031 + 0.0001 * g};
            add(sim, 1 + (uint64_t)g, at, (double[3]){0.2, 0.03 * g, -0.1}, 0.003);
        }
        CHECK(clod_sim_advance(sim, sanitized() ? 10000 : 40000, &status));
        for (int g = 0; g < GRAINS; g++) {
            const double *at = row(sim, "position", 1 + (uint64_t)g);
            if (k < 0) {
                memcpy(twin[g], at, sizeof twin[g]);
            }
            assert_memory_equal(twin[g], at, sizeof twin[g]);
        }
        clod_sim_destroy(&sim);
    }
}

/** Rolling over six facets that meet in a point, as in a test of MercuryDPM: z and velocity stay.
 *  The grain begins in balance, so it is in the case. */
static void rolling_over_seams_feels_nothing(void **temporary)
{
    mesh_file file = mesh_file_open(*temporary, "fan");
    for (int k = 0; k < 6; k++) {
        const double a = M_PI / 3.0 * k, b = M_PI / 3.0 * (k + 1);
        mesh_file_facet(&file, (double[3]){0.0, 0.0, 0.0},
                        (double[3]){0.5 * cos(a), 0.5 * sin(a), 0.0},
                        (double[3]){0.5 * cos(b), 0.5 * sin(b), 0.0});
    }
    mesh_file_close(&file);
    const double weight = 2500.0 * 4.0 / 3.0 * M_PI * 1e-6 * 9.81;
    const double height = 0.01 - weight / 1e5; // k d = m g
    char grains[PATH_MAX], text[2 * PATH_MAX + 1024];
    snprintf(grains, sizeof grains, "%s/grains.csv", (const char *)*temporary);
    FILE *csv = fopen(grains, "w");
    assert_non_null(csv);
    fprintf(csv, "x [m],y [m],z [m],radius [m],vx [m/s],vy [m/s],vz [m/s]\n");
    fprintf(csv, "0.2,0,%.17g,0.01,-1,0,0\n", height);
    fclose(csv);
    snprintf(text, sizeof text,
             "materials: {ore: {density: 2500 kg/m3}}\n"
             "contacts: {default: {" LAW_ELASTIC "}}\n"
             "gravity: " WEIGHT "\n"
             "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
             "walls: {wall: {material: ore, shapes: [{mesh: {file: %s, unit: 1 m}}]}}\n"
             "grains: [{material: ore, file: %s}]\n"
             "stages: [{name: run, duration: 1 s}]\n"
             "time: {step: 1e-5 s}\n",
             file.path, grains);
    clod_sim *sim = sim_made(text, 1);
    for (int k = 0; k < 40; k++) { // through the point where all meet
        CHECK(clod_sim_advance(sim, 1000, &status));
        check_close(row(sim, "position", 1)[2], height, 1e-12);
        check_close(row(sim, "velocity", 1)[0], -1.0, 1e-12);
        check_close(row(sim, "velocity", 1)[1], 0.0, 1e-12);
        check_close(row(sim, "velocity", 1)[2], 0.0, 1e-12);
    }
    check_close(row(sim, "position", 1)[0], -0.2, 1e-12);
    clod_sim_destroy(&sim);
}

/** Two sheets that meet at the y axis at a slope of 45 deg: `side` 1 a V, -1 a ridge. */
static mesh_file roof(const char *folder, double side)
{
    mesh_file file = mesh_file_open(folder, "roof");
    mesh_file_sheet(&file, (double[3]){0.0, -0.2, 0.0}, (double[3]){0.2, 0.0, 0.2 * side},
                    (double[3]){0.0, 0.4, 0.0}, 7, 3);
    mesh_file_sheet(&file, (double[3]){-0.2, -0.2, 0.2 * side},
                    (double[3]){0.2, 0.0, -0.2 * side}, (double[3]){0.0, 0.4, 0.0}, 5, 4);
    mesh_file_close(&file);
    return file;
}

/** A ball dropped into a V: both sides push, as two planes do. */
static void a_groove_is_two_planes(void **temporary)
{
    const mesh_file file = roof(*temporary, 1.0);
    clod_sim *sim[] = {mesh_case(LAW_PLASTIC, "2e-6 s", WEIGHT, &file, 1),
                       case_of(LAW_PLASTIC, "2e-6 s", WEIGHT,
                               "{plane: {point: [0 m, 0 m, 0 m], normal: [-1, 0, 1]}}, "
                               "{plane: {point: [0 m, 0 m, 0 m], normal: [1, 0, 1]}}",
                               1)};
    for (int k = 0; k < 2; k++) {
        add(sim[k], 1, (double[3]){0.001, 0.01, 0.02}, (double[3]){0.0, 0.1, 0.0}, 0.01);
        CHECK(clod_sim_advance(sim[k], 100000, &status));
    }
    for (int a = 0; a < 3; a++) {
        check_close(row(sim[0], "position", 1)[a], row(sim[1], "position", 1)[a], 1e-12);
        check_close(row(sim[0], "velocity", 1)[a], row(sim[1], "velocity", 1)[a], 1e-9);
    }
    clod_sim_destroy(&sim[0]);
    clod_sim_destroy(&sim[1]);
}

/** A box of 40 mm about the origin, each side in pieces. */
static mesh_file cube(const char *folder)
{
    mesh_file file = mesh_file_open(folder, "cube");
    for (int a = 0; a < 3; a++) {
        for (int side = -1; side <= 1; side += 2) {
            double at[3] = {-0.02, -0.02, -0.02}, u[3] = {0.0}, v[3] = {0.0};
            at[a] = 0.02 * side;
            u[(a + (side > 0 ? 1 : 2)) % 3] = 0.04; // normals point out
            v[(a + (side > 0 ? 2 : 1)) % 3] = 0.04;
            mesh_file_sheet(&file, at, u, v, 4, 4);
        }
    }
    mesh_file_close(&file);
    return file;
}

static double kinetic(clod_sim *sim)
{
    const double *v = row(sim, "velocity", 1);
    const double *w = row(sim, "angular_velocity", 1);
    const double mass = *row(sim, "mass", 1), r = *row(sim, "radius", 1);
    return 0.5 * mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) +
           0.2 * mass * r * r * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
}

/** Impacts on faces, edges and corners of a box, from straight to grazing: energy is never won,
 *  and without damping and friction none is lost. */
static void no_impact_wins_energy(void **temporary)
{
    static const char *const LAWS[] = {
        LAW_ELASTIC, LAW_PLASTIC, "law: hertz, restitution: 0.6, friction: 0.5",
        LAW_LUDING,  LAW_EEPA,
    };
    const mesh_file file = cube(*temporary);
    static const double TARGETS[][3] = {
        {0.003, 0.0011, 0.02}, {0.02, 0.0017, 0.02}, {0.02, 0.02, 0.02}, {0.0199, 0.01, 0.02}};
    static const int ANGLES[] = {0,  12, 24, 36, 48, 60,
                                 68, 76, 82, 86, 88, 89}; // from straight
    for (size_t l = 0; l < sizeof LAWS / sizeof *LAWS; l++) {
        int hits = 0;
        clod_sim *sim = mesh_case(LAWS[l], "5e-7 s", NO_WEIGHT, &file, 1);
        for (size_t t = 0; t < 4; t++) {
            for (size_t k = 0; k < sizeof ANGLES / sizeof *ANGLES; k++) {
                const double a = ANGLES[k] * M_PI / 180.0, turn = 0.3 + ANGLES[k];
                const double along[3] = {sin(a) * cos(turn), sin(a) * sin(turn), -cos(a)};
                const double back = fmax(0.003, 0.0003 / cos(a)); // it begins clear of the box
                double from[3], velocity[3];
                for (int d = 0; d < 3; d++) {
                    velocity[d] = 0.5 * along[d];
                    from[d] = TARGETS[t][d] + (d == 2 ? 0.0049 : 0.0) - back * along[d];
                }
                add(sim, 1, from, velocity, 0.005);
                CHECK(clod_sim_change(sim, &status));
                const double before = kinetic(sim);
                CHECK(clod_sim_advance(sim, lround((back + 0.002) / 0.5 / 5e-7), &status));
                const double after = kinetic(sim);
                hits += row(sim, "velocity", 1)[2] > velocity[2] + 0.2 * cos(a);
                if (after > before * (1.0 + 1e-5)) {
                    fail_msg("law %zu target %zu angle %d: %.12g J became %.12g J", l, t,
                             ANGLES[k], before, after);
                }
                if (l == 0) {
                    check_relative(after, before, 1e-4);
                }
                CHECK(clod_sim_remove_grain(sim, 1, &status));
            }
        }
        assert_true(hits > 30);
        clod_sim_destroy(&sim);
    }
}

/** A run that goes on from a checkpoint has the bits of one that was never interrupted. */
static void meshes_go_on_from_checkpoints(void **temporary)
{
    char folder[PATH_MAX];
    snprintf(folder, sizeof folder, "%s/run", (const char *)*temporary);
    const mesh_file file = roof(*temporary, 1.0);
    clod_sim *sim = mesh_case(LAW_PLASTIC, "2e-6 s", WEIGHT, &file, 1);
    for (int g = 0; g < 30; g++) {
        add(sim, 1 + (uint64_t)g,
            (double[3]){0.001 * (g % 3), 0.006 * (g - 15), 0.012 + 0.001 * g},
            (double[3]){0.05, 0.0, -0.2}, 0.003);
    }
    CHECK(clod_sim_advance(sim, 15000, &status));
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    clod_sim *again = mesh_case(LAW_PLASTIC, "2e-6 s", WEIGHT, &file, 2);
    CHECK(clod_sim_read_checkpoint(again, folder, NULL, &status));
    CHECK(clod_sim_advance(sim, 15000, &status));
    CHECK(clod_sim_advance(again, 15000, &status));
    for (uint64_t id = 1; id <= 30; id++) {
        assert_memory_equal(row(sim, "position", id), row(again, "position", id), 24);
        assert_memory_equal(row(sim, "angular_velocity", id),
                            row(again, "angular_velocity", id), 24);
    }
    clod_sim_destroy(&sim);
    clod_sim_destroy(&again);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_sheet_is_a_plane_in_any_cut, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(rolling_over_seams_feels_nothing, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_groove_is_two_planes, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(no_impact_wins_energy, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(meshes_go_on_from_checkpoints, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
