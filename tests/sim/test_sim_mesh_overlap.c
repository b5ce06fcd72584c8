// Grains on sheets whose facets lie over each other: the bits of the plane on them, and nothing
// beside them.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/rolling_grains.h"
#include "support/sim_made.h"

#define STIFF "{law: hooke, k1: 1000 N/m, restitution: 1, friction: 0}"
#define STICKY                                                                                 \
    "{law: mepa, exponent: 1.5, k1: 4.75e7 N/m^1.5, k2: 2.37e8 N/m^1.5, k_adh: 2e7 N/m^1.5, "  \
    "restitution: 0.5, friction: 0.3, rolling: epsd2, rolling_friction: 0.05}"

static clod_sim *case_of(const char *law, const char *gravity, const char *shape, int threads)
{
    char text[PATH_MAX + 2048];
    snprintf(text, sizeof text,
             "materials: {ore: {density: 2500 kg/m3}}\n"
             "contacts: {default: %s}\n"
             "gravity: [0 m/s2, 0 m/s2, %s]\n"
             "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
             "walls: {wall: {material: ore, shapes: [%s]}}\n"
             "stages: [{name: run, duration: 1 s}]\n"
             "time: {step: 2e-6 s, design_stress: 10 kPa}\n",
             law, gravity, shape);
    return sim_made(text, threads);
}

/** Facets of the rectangle from x0 to x1, 0.4 m wide, both diagonals if `both`. */
static void rectangle(mesh_file *file, double x0, double x1, bool both)
{
    const double p[4][3] = {{x0, -0.2, 0}, {x1, -0.2, 0}, {x1, 0.2, 0}, {x0, 0.2, 0}};
    mesh_file_facet(file, p[0], p[1], p[2]);
    mesh_file_facet(file, p[0], p[2], p[3]);
    if (both) {
        mesh_file_facet(file, p[1], p[3], p[2]);
        mesh_file_facet(file, p[1], p[0], p[3]);
    }
}

/** A sheet of two sides from -0.2 to 0 over one of plates that overlap, to 0.2 m. */
static const char *sheet(const char *folder)
{
    static char shape[PATH_MAX + 128];
    mesh_file file = mesh_file_open(folder, "sheet");
    rectangle(&file, -0.2, 0.0, true);
    rectangle(&file, -0.05, 0.15, false);
    rectangle(&file, 0.01, 0.2, true);
    mesh_file_close(&file);
    snprintf(shape, sizeof shape, "{mesh: {file: %s, unit: 1 m}}", file.path);
    return shape;
}

static void grains_on_it_have_the_bits_of_the_plane(void **temporary)
{
    static double twin[ROLLING_GRAINS][3], found[ROLLING_GRAINS][3];
    const char *shape = sheet(*temporary);
    roll_over(case_of(STICKY, "-9.81 m/s2", "{plane: {point: [0 m, 0 m, 0 m]}}", 1), twin);
    for (int g = 0; g < ROLLING_GRAINS; g++) {
        assert_true(twin[g][0] < -0.0005 && twin[g][2] < 0.003); // went over the seam on it
    }
    for (int threads = 1; threads <= 2; threads++) {
        roll_over(case_of(STICKY, "-9.81 m/s2", shape, threads), found);
        assert_memory_equal(found, twin, sizeof twin);
    }
}

/** A grain on it carries its weight with the overlap of one spring, m g/k; counted twice it would be half. */
static void the_overlap_is_that_of_one_spring(void **temporary)
{
    clod_sim *sim = case_of(STIFF, "-9.81 m/s2", sheet(*temporary), 1);
    const double radius = 0.01, mass = 2500.0 * 4.0 / 3.0 * M_PI * radius * radius * radius;
    const double rest = mass * 9.81 / 1000.0;
    const clod_sim_grain grain = {
        .id = 1, .radius = radius, .position = {0.07, 0.03, radius - rest}};
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    CHECK(clod_sim_advance(sim, 5000, &status)); // two periods
    const clod_sim_view view = sim_view(sim, "position");
    // it swings by g dt/2 over the frequency, 3e-8 m, as no force was there before the first step
    check_close(((const double *)clod_sim_row(&view, 0))[2], radius - rest, 1e-7);
    clod_sim_destroy(&sim);
}

/** A grain that passes the edge nearer to the plane than its radius, and farther from the edge, goes
 *  straight on: beside a sheet there is no plane. */
static void beside_it_there_is_nothing(void **temporary)
{
    clod_sim *sim = case_of(STIFF, "0 m/s2", sheet(*temporary), 1);
    const double beside[2] = {-0.2 - 0.0066, 0.2 + 0.0066}; // 0.0101 m from the edge
    for (int g = 0; g < 2; g++) {
        const clod_sim_grain grain = {.id = 1 + (uint64_t)g,
                                      .radius = 0.01,
                                      .position = {beside[g], 0.0, 0.00765},
                                      .velocity = {0.0, 0.5, 0.0}};
        CHECK(clod_sim_add_grain(sim, &grain, &status));
    }
    CHECK(clod_sim_advance(sim, 20000, &status));
    const clod_sim_view view = sim_view(sim, "position");
    for (int g = 0; g < 2; g++) {
        const double *at = clod_sim_row(&view, clod_sim_row_of_id(sim, 1 + (uint64_t)g));
        assert_true(at[0] == beside[g] && at[2] == 0.00765);
        check_close(at[1], 0.02, 1e-12);
    }
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grains_on_it_have_the_bits_of_the_plane),
        cmocka_unit_test(the_overlap_is_that_of_one_spring),
        cmocka_unit_test(beside_it_there_is_nothing),
    };
    return cmocka_run_group_tests(tests, temp_folder_make, temp_folder_remove);
}
