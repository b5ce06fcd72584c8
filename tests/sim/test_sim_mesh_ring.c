// The ring shear cell of the copper ore at the stiffness of Del Cid & Mustoe, Table 1: grains that
// touch its floor, lid, sides and bars in all ways, beside walls of shapes and of facets.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/mesh_file.h"
#include "support/sim_made.h"

#define INNER 0.05 ///< m, RST-01
#define OUTER 0.1
#define HEIGHT 0.04
#define MEAN (0.5 * (INNER + OUTER))
#define BARS 20
#define BAR_WIDTH 0.003
#define BAR_HEIGHT 0.00635
#define BAR_LENGTH 0.04886
#define SIDES 7200
#define STEPS 400
#define WALLS 3

static const double RADIUS = 3.175e-3; ///< m

static const char CASE[] =
    "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
    "materials: {ore: {density: 2481.3 kg/m3}, side: {}, base: {}}\n"
    "contacts:\n"
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"
    "            k_adh: 5.93e8 N/m^1.5, restitution: 0.3, friction: 0.35, rolling: epsd2,\n"
    "            rolling_friction: 0.3}\n"
    "  ore-side: {friction: 0, rolling: none}\n"
    "  ore-base: {friction: 0.7}\n"
    "domain: {min: [-0.12 m, -0.12 m, -0.02 m], max: [0.12 m, 0.12 m, 0.08 m]}\n"
    "time: {step: 9e-7 s, design_stress: 50 kPa}\n"
    "stages: [{name: run, duration: 1 s}]\n"
    "walls:\n"
    "  trough: {material: base, spin: 1.3 rad/s, spin_axis: [0, 0, 1], shapes: [%s]}\n"
    "  sides: {material: side, spin: 1.3 rad/s, spin_axis: [0, 0, 1], shapes: [%s]}\n"
    "  lid: {material: base, shapes: [%s]}\n";

// ---- the cell

/** Middle of a bar's two long axes, and half of its edges along them. */
static void bar_box(int number, bool up, double at[3], double half[3][3])
{
    const double angle = 2.0 * M_PI * number / BARS, c = cos(angle), s = sin(angle);
    const double z = up ? 0.5 * BAR_HEIGHT : HEIGHT - 0.5 * BAR_HEIGHT;
    const double axes[3][3] = {{0.5 * BAR_LENGTH * c, 0.5 * BAR_LENGTH * s, 0.0},
                               {-0.5 * BAR_WIDTH * s, 0.5 * BAR_WIDTH * c, 0.0},
                               {0.0, 0.0, 0.5 * BAR_HEIGHT}};
    memcpy(at, (const double[3]){MEAN * c, MEAN * s, z}, 3 * sizeof *at);
    memcpy(half, axes, sizeof axes);
}

/** A ring with bars as shapes; owned. */
static char *ring_shapes(bool up)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    fprintf(out,
            "{annulus: {center: [0 m, 0 m, %g m], normal: [0, 0, %d], inner_radius: %g m, "
            "outer_radius: %g m}}",
            up ? 0.0 : HEIGHT, up ? 1 : -1, INNER, OUTER);
    for (int b = 0; b < BARS; b++) {
        double at[3], half[3][3];
        bar_box(b, up, at, half);
        fprintf(out,
                ", {bar: {from: [%.17g m, %.17g m, %.17g m], to: [%.17g m, %.17g m, %.17g m], "
                "width: %g m, height: %g m}}",
                at[0] - half[0][0], at[1] - half[0][1], at[2], at[0] + half[0][0],
                at[1] + half[0][1], at[2], BAR_WIDTH, BAR_HEIGHT);
    }
    fclose(out);
    return text;
}

static void put_bar(mesh_file *file, int number, bool up)
{
    double at[3], half[3][3];
    bar_box(number, up, at, half);
    for (int side = 0; side < 6; side++) {
        const double sign = side < 3 ? -1.0 : 1.0;
        const double *n = half[side % 3], *u = half[(side + 1) % 3], *v = half[(side + 2) % 3];
        double from[3], along[3], across[3];
        for (int a = 0; a < 3; a++) {
            from[a] = at[a] + sign * n[a] - u[a] - v[a];
            along[a] = 2.0 * u[a];
            across[a] = 2.0 * v[a];
        }
        mesh_file_sheet(file, from, along, across, 2, 3);
    }
}

/** The surface between two circles about z. */
static void put_lathe(mesh_file *file, const double from[2], const double to[2], int sides)
{
    for (int s = 0; s < sides; s++) {
        const double a = 2.0 * M_PI * s / sides, b = 2.0 * M_PI * (s + 1) / sides;
        const double p[4][3] = {{from[0] * cos(a), from[0] * sin(a), from[1]},
                                {from[0] * cos(b), from[0] * sin(b), from[1]},
                                {to[0] * cos(b), to[0] * sin(b), to[1]},
                                {to[0] * cos(a), to[0] * sin(a), to[1]}};
        mesh_file_facet(file, p[0], p[1], p[2]);
        mesh_file_facet(file, p[0], p[2], p[3]);
    }
}

static clod_sim *cell_of_facets(const char *folder)
{
    char text[sizeof CASE + 3 * (PATH_MAX + 64)], shapes[WALLS][PATH_MAX + 48];
    mesh_file file[WALLS] = {mesh_file_open(folder, "trough"), mesh_file_open(folder, "sides"),
                             mesh_file_open(folder, "lid")};
    for (int k = 0; k < WALLS; k += 2) {
        const double z =
            k == 0 ? 0.0 : HEIGHT; // wider than the ring: a grain at the side is not at a rim
        put_lathe(&file[k], (double[2]){INNER - 0.01, z}, (double[2]){OUTER + 0.01, z}, 120);
        for (int b = 0; b < BARS; b++) {
            put_bar(&file[k], b, k == 0);
        }
    }
    put_lathe(&file[1], (double[2]){INNER, -0.01}, (double[2]){INNER, HEIGHT + 0.01}, SIDES);
    put_lathe(&file[1], (double[2]){OUTER, -0.01}, (double[2]){OUTER, HEIGHT + 0.01}, SIDES);
    for (int k = 0; k < WALLS; k++) {
        mesh_file_close(&file[k]);
        snprintf(shapes[k], sizeof shapes[k], "{mesh: {file: %.4000s, unit: 1 m}}",
                 file[k].path);
    }
    snprintf(text, sizeof text, CASE, shapes[0], shapes[1], shapes[2]);
    return sim_made(text, 1);
}

static clod_sim *cell_of_shapes(void)
{
    static char text[sizeof CASE + 64000];
    char *trough = ring_shapes(true), *lid = ring_shapes(false), sides[512];
    snprintf(sides, sizeof sides,
             "{cylinder: {foot: [0 m, 0 m, -10 mm], axis: [0, 0, 1], radius: %g m, length: 60 "
             "mm, side: outside}}, {cylinder: {foot: [0 m, 0 m, -10 mm], axis: [0, 0, 1], "
             "radius: %g m, length: 60 mm, side: inside}}",
             INNER, OUTER);
    assert_true(snprintf(text, sizeof text, CASE, trough, sides, lid) < (int)sizeof text);
    free(trough);
    free(lid);
    return sim_made(text, 1);
}

// ---- the grains

/** A grain at a place of a frame that is turned about z: radius, aside, height. */
static void put_grain(clod_sim *sim, uint64_t id, double turned, const double place[3],
                      const double to[3])
{
    const double c = cos(turned), s = sin(turned);
    clod_sim_grain grain = {
        .id = id,
        .radius = RADIUS,
        .position = {c * place[0] - s * place[1], s * place[0] + c * place[1], place[2]},
        .velocity = {c * to[0] - s * to[1], s * to[0] + c * to[1], to[2]},
        .angular_velocity = {3.0, -2.0, 5.0}};
    CHECK(clod_sim_add_grain(sim, &grain, &status));
}

/** In each of the sectors between two bars: overlaps are those under the ore's preshear, 1 to 3 um. */
static void fill(clod_sim *sim)
{
    uint64_t id = 1;
    for (int b = 0; b < BARS; b++) {
        const double in = (1.0 + 0.1 * b) * 1e-6, r = RADIUS - in;
        const double bar = 2.0 * M_PI * b / BARS, between = bar + M_PI / BARS;
        const double slow = 0.02, side = 0.5 * BAR_WIDTH + r, top = BAR_HEIGHT + r;
        const double edge = 0.5 * BAR_WIDTH + r * sqrt(0.5), over = BAR_HEIGHT + r * sqrt(0.5);
        const bool odd = b % 2 != 0;
        // in the grooves of floor or lid with the sides
        put_grain(sim, id++, between, (double[3]){INNER + r, 0.0, r},
                  (double[3]){-slow, slow, -slow});
        put_grain(sim, id++, between, (double[3]){OUTER - r, 0.0, r},
                  (double[3]){slow, -slow, -slow});
        put_grain(sim, id++, between, (double[3]){INNER + r, 0.0, HEIGHT - r},
                  (double[3]){-slow, 0.0, slow});
        put_grain(sim, id++, between, (double[3]){OUTER - r, 0.0, HEIGHT - r},
                  (double[3]){slow, 0.0, slow});
        // beside a bar, on it, or on its edge; the lid's bars alike
        const double upon[2] = {odd ? 0.0 : edge, odd ? top : over};
        put_grain(sim, id++, bar, (double[3]){MEAN - 0.01, side, r},
                  (double[3]){slow, -slow, -slow});
        put_grain(sim, id++, bar, (double[3]){MEAN + 0.01, upon[0], upon[1]},
                  (double[3]){slow, odd ? slow : -slow, -slow});
        put_grain(sim, id++, bar, (double[3]){MEAN - 0.01, -side, HEIGHT - r},
                  (double[3]){slow, slow, slow});
        put_grain(sim, id++, bar, (double[3]){MEAN + 0.01, -upon[0], HEIGHT - upon[1]},
                  (double[3]){slow, slow, slow});
    }
}

/** Mean force [N] and torque about z [N m] on each wall. */
static void run(clod_sim *sim, double felt[WALLS][4])
{
    memset(felt, 0, WALLS * sizeof *felt);
    for (int k = 0; k < STEPS; k++) {
        CHECK(clod_sim_advance(sim, 1, &status));
        for (int32_t w = 0; w < WALLS; w++) {
            clod_sim_wall wall;
            CHECK(clod_sim_wall_look(sim, w, &wall, &status));
            for (int c = 0; c < 4; c++) {
                felt[w][c] += (c < 3 ? wall.force[c] : wall.torque[2]) / STEPS;
            }
        }
    }
}

/** The largest distance in a direction between grains of the same id. */
static double apart(clod_sim *one, clod_sim *other)
{
    const clod_sim_view a = sim_view(one, "position"), b = sim_view(other, "position");
    double most = 0.0;
    for (uint64_t id = 1; id <= clod_sim_grain_count(one); id++) {
        const double *p = clod_sim_row(&a, clod_sim_row_of_id(one, id));
        const double *q = clod_sim_row(&b, clod_sim_row_of_id(other, id));
        for (int c = 0; c < 3; c++) {
            most = fmax(most, fabs(p[c] - q[c]));
        }
    }
    return most;
}

/**
 * The facets lie off their shapes by as much as a polygon lies inside its circle and as a file of
 * single precision rounds: so far off are the grains, and overlaps of 1 um and more by that fraction,
 * forces by 3/2 of it. Floor and lid are exact in a file, so forces along z are nearer.
 */
static void facets_do_what_the_shapes_do(void **temporary)
{
    static const double LEAST = 1e-6;                       // m, overlap
    const double rounding = 0.1 * 0x1p-24 + 0.01 * 0x1p-24; // m, of one coordinate
    const double off = OUTER * (1.0 - cos(M_PI / SIDES)) + sqrt(2.0) * rounding;
    clod_sim *shapes = cell_of_shapes(), *facets = cell_of_facets(*temporary);
    double a[WALLS][4], b[WALLS][4];
    fill(shapes);
    fill(facets);
    run(shapes, a);
    run(facets, b);
    for (int w = 0; w < WALLS; w++) {
        const double size = sqrt(a[w][0] * a[w][0] + a[w][1] * a[w][1] + a[w][2] * a[w][2]);
        for (int c = 0; c < 3; c++) {
            check_at_most(fabs(b[w][c] - a[w][c]), 1.5 * off / LEAST * size);
        }
        check_at_most(fabs(b[w][2] - a[w][2]), 1e-4 * size);
        check_at_most(fabs(b[w][3] - a[w][3]), 1.5 * off / LEAST * size * MEAN);
    }
    check_at_most(apart(shapes, facets), 2.0 * off);
    clod_sim_destroy(&shapes);
    clod_sim_destroy(&facets);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(facets_do_what_the_shapes_do, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
