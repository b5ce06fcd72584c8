// The ring shear cell of the copper ore, with its bars: as shapes, and as meshes.
#include <math.h>

#include "verify/facets.h"
#include "verify/suite.h"
#include "verify/twin.h"

#define INNER 0.05 ///< m, RST-01 as in the case of the copper ore
#define OUTER 0.1
#define BARS 20
#define BAR_WIDTH 0.003
#define BAR_HEIGHT 0.00635
#define BAR_LENGTH (OUTER - INNER - 0.2 * 2.85e-3)
#define LID 0.1 ///< m, height of the lid before it comes down
#define SIDES 120
#define GRAINS 4000
#define STRESS 3.87e3                                 ///< Pa
#define SHEAR 0.1                                     ///< m/s at the mean radius
#define AREA (M_PI * (OUTER * OUTER - INNER * INNER)) ///< m2

static const char *const QUANTITIES[] = {
    "shear stress from the lid's torque [Pa]", "shear stress from the trough's torque [Pa]",
    "normal stress on the lid [Pa]", "height of the specimen [m]"};

/** Places of a bar's ends along its radius. */
static void bar_ends(int number, double radius[2], double *angle)
{
    const double middle = 0.5 * (INNER + OUTER);
    radius[0] = middle - 0.5 * BAR_LENGTH;
    radius[1] = middle + 0.5 * BAR_LENGTH;
    *angle = 2.0 * M_PI * number / BARS;
}

/** A ring with bars: facing up at 0, or down at LID. */
static void put_ring(FILE *out, bool up)
{
    const double height = up ? 0.0 : LID, bar = height + (up ? 0.5 : -0.5) * BAR_HEIGHT;
    fprintf(
        out,
        "    shapes:\n"
        "      - annulus: {center: [0 m, 0 m, %g m], normal: [0, 0, %d], inner_radius: %g m, "
        "outer_radius: %g m}\n",
        height, up ? 1 : -1, INNER, OUTER);
    for (int b = 0; b < BARS; b++) {
        double r[2], angle;
        bar_ends(b, r, &angle);
        fprintf(out,
                "      - bar: {from: [%.9g m, %.9g m, %.9g m], to: [%.9g m, %.9g m, %.9g m], "
                "width: %g m, height: %g m}\n",
                r[0] * cos(angle), r[0] * sin(angle), bar, r[1] * cos(angle), r[1] * sin(angle),
                bar, BAR_WIDTH, BAR_HEIGHT);
    }
}

static void put_walls(FILE *out, bool mesh)
{
    static const char *const TURNS = "    spin_axis: [0, 0, 1]\n";
    fprintf(out, "walls:\n  trough:\n    material: base\n%s", TURNS);
    if (mesh) {
        fprintf(out, "    shapes: [{mesh: {file: trough.stl, unit: 1 m}}]\n");
    } else {
        put_ring(out, true);
    }
    fprintf(out, "  sides:\n    material: side\n%s", TURNS);
    if (mesh) {
        fprintf(out, "    shapes: [{mesh: {file: sides.stl, unit: 1 m}}]\n");
    } else {
        fprintf(out,
                "    shapes:\n"
                "      - cylinder: {foot: [0 m, 0 m, 0 m], axis: [0, 0, 1], radius: %g m, "
                "length: %g m, side: outside}\n"
                "      - cylinder: {foot: [0 m, 0 m, 0 m], axis: [0, 0, 1], radius: %g m, "
                "length: %g m, side: inside}\n",
                INNER, LID, OUTER, LID);
    }
    fprintf(
        out,
        "  lid:\n"
        "    material: base\n"
        "    load: {stress: 200 Pa, area: %.9g m2, axis: [0, 0, -1], mass: 1 kg, damping: 0.15}\n%s",
        AREA, TURNS);
    if (mesh) {
        fprintf(out, "    shapes: [{mesh: {file: lid.stl, unit: 1 m}}]\n");
    } else {
        put_ring(out, false);
    }
}

/** A tenth of the stress of the ore's preshear, and stiffnesses that are a thousandth of its: overlaps
 *  are those of stiffnesses 100 times softer, and steps are long (docs/theory/mepa.md). */
static void put_case(FILE *out, bool mesh, int seed)
{
    fprintf(
        out,
        "# Written by clod verify: copper ore, 8 %% moisture, 1000 times softer.\n"
        "title: Ring shear cell\n"
        "seed: %d\n"
        "materials: {ore: {density: 2481.3 kg/m3}, side: {}, base: {}}\n"
        "contacts:\n"
        "  default: {law: mepa, exponent: 1.5, k1: 4.75e5 N/m^1.5, k2: 2.37e6 N/m^1.5, "
        "k_adh: 5.93e5 N/m^1.5,\n"
        "            restitution: 0.3, friction: 0.35, rolling: epsd2, rolling_friction: "
        "0.3}\n"
        "  ore-side: {friction: 0, rolling: none}\n"
        "  ore-base: {friction: 0.7}\n"
        "domain: {min: [-0.12 m, -0.12 m, -0.02 m], max: [0.12 m, 0.12 m, 0.12 m]}\n"
        "time: {design_stress: 5 kPa, overlap_limit: 40 %%} # bars meet single grains first\n"
        "grains:\n"
        "  - material: ore\n"
        "    count: %d\n"
        "    radius: {mean: 3.175 mm, sd: 0.16 mm, min: 2.85 mm, max: 3.49 mm}\n"
        "    region: {annulus: {center: [0 m, 0 m, 0 m], inner_radius: %g m, outer_radius: "
        "%g m, height: %g m}}\n",
        seed, GRAINS, INNER, OUTER, LID - BAR_HEIGHT);
    put_walls(out, mesh);
    const double spin = SHEAR / (0.5 * (INNER + OUTER));
    fprintf(
        out,
        "stages:\n"
        "  - {name: fill, duration: 0.2 s, adhesion: 10 %%}\n"
        "  - {name: press, duration: 0.28 s, walls: {lid: {stress: %g Pa}}}\n"
        "  - {name: begin, duration: 0.15 s, walls: {trough: {spin: %g rad/s}, sides: {spin: "
        "%g rad/s}}}\n"
        "  - {name: shear, duration: 0.15 s}\n"
        "output: {series_interval: 1 ms}\n",
        STRESS, spin, spin);
}

/** Half edges of a bar along its axes. */
static void put_bar(clod_verify_facets *mesh, int number, double height)
{
    double r[2], angle;
    bar_ends(number, r, &angle);
    const clod_vec3 radial = {cos(angle), sin(angle), 0.0};
    const clod_vec3 half[3] = {clod_vec3_scale(radial, 0.5 * BAR_LENGTH),
                               {-0.5 * BAR_WIDTH * radial.y, 0.5 * BAR_WIDTH * radial.x, 0.0},
                               {0.0, 0.0, 0.5 * BAR_HEIGHT}};
    const double middle = 0.5 * (INNER + OUTER);
    clod_verify_facets_box(mesh, (clod_vec3){middle * radial.x, middle * radial.y, height},
                           half);
}

static bool put_ring_mesh(const char *folder, const char *name, bool up, clod_status *status)
{
    const double height = up ? 0.0 : LID;
    const double line[][2] = {{INNER, height}, {OUTER, height}};
    clod_verify_facets mesh;
    if (!clod_verify_facets_open(&mesh, folder, name, status)) {
        return false;
    }
    clod_verify_facets_lathe(&mesh, line, 2, SIDES);
    for (int b = 0; b < BARS; b++) {
        put_bar(&mesh, b, height + (up ? 0.5 : -0.5) * BAR_HEIGHT);
    }
    return clod_verify_facets_close(&mesh, status);
}

static bool put_meshes(const char *folder, clod_status *status)
{
    static const double IN[][2] = {{INNER, 0.0}, {INNER, 0.5 * LID}, {INNER, LID}};
    static const double OUT[][2] = {{OUTER, 0.0}, {OUTER, 0.5 * LID}, {OUTER, LID}};
    clod_verify_facets sides;
    if (!clod_verify_facets_open(&sides, folder, "sides", status)) {
        return false;
    }
    clod_verify_facets_lathe(&sides, IN, 3, SIDES);
    clod_verify_facets_lathe(&sides, OUT, 3, SIDES);
    return clod_verify_facets_close(&sides, status) &&
           put_ring_mesh(folder, "trough", true, status) &&
           put_ring_mesh(folder, "lid", false, status);
}

/** Torque of a stress that is the same all over the ring, over that stress [m3]. */
static double lever(void)
{
    return 2.0 / 3.0 * M_PI * (OUTER * OUTER * OUTER - INNER * INNER * INNER);
}

static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    (void)status;
    const clod_wall *trough = &now->state.walls.wall[0], *lid = &now->state.walls.wall[2];
    if (!clod_verify_bed_is_in(now, "shear")) {
        return true;
    }
    clod_verify_twin_add(context, 0, lid->sum_torque.z / (double)lid->sum_steps / lever());
    clod_verify_twin_add(context, 1,
                         -trough->sum_torque.z / (double)trough->sum_steps / lever());
    clod_verify_twin_add(context, 2, lid->sum_force.z / (double)lid->sum_steps / AREA);
    clod_verify_twin_add(context, 3, LID + lid->shift.z);
    return true;
}

bool clod_verify_mesh_ring(const clod_verify_bench *bench, clod_status *status)
{
    const clod_verify_twin twin = {.name = "mesh-ring",
                                   .quantities = QUANTITIES,
                                   .count = 4,
                                   .put_case = put_case,
                                   .put_meshes = put_meshes,
                                   .look = look};
    return clod_verify_twin_compare(&twin, bench, status);
}
