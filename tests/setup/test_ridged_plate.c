// The plate with ridges: where its surface is, by elementary geometry, and what a grain feels that is
// pulled over it without friction, by statics.

#include <math.h>
#include <stdio.h>

#include "geometry/wall_gap.h"
#include "setup/wall_friction_cell.h"
#include "support/cell.h"
#include "support/sanitized.h"
#include "support/sim_made.h"

#define RING                                                                                   \
    "  inner_radius: 30 mm\n  outer_radius: 60 mm\n  bar_count: 6\n  bar_height: 5 mm\n"
#define STRAIGHT "  cell: straight\n  outer_radius: 30 mm\n"

/** Case text of a cell whose solid is elastic and without friction. */
static const char *text_of(const char *cell, const char *ridges)
{
    static char text[2048];
    snprintf(text, sizeof text,
             "materials: {ore: {density: 2500 kg/m3}, side: {}, plate: {}, top: {}}\n"
             "contacts: {default: {law: hooke, k1: 1e5 N/m, restitution: 0.1, friction: 0}}\n"
             "wall_friction:\n"
             "  grain_material: ore\n"
             "  side_material: side\n"
             "  plate_material: plate\n"
             "  lid_material: top\n"
             "  radius: {mean: 2.5 mm, sd: 0.1 mm, min: 2.4999 mm, max: 2.5001 mm}\n"
             "  depth: 25 mm\n"
             "  grain_count: 1\n"
             "  lid_mass: 0.3 kg\n"
             "  wall_stresses: [10 kPa, 50 kPa]\n"
             "  plate_ridges: {%s}\n%s",
             ridges, cell);
    return text;
}

/** The cell as it is set up; owned: cell_end. @param set  another value of a key, or NULL */
static clod_case *begin_cell(const char *cell, const char *ridges, const char *set,
                             clod_state *state)
{
    clod_status failed = {0};
    clod_case *from = case_of(text_of(cell, ridges), set);
    assert_true(clod_setup_wall_friction_cell(from, 1, state, &failed));
    return from;
}

// ---- geometry

/** Distance of a point from the plate [m]: the least of those from its shapes. */
static double plate_distance(const clod_state *state, clod_vec3 p)
{
    const clod_wall *plate = &state->walls.wall[CLOD_WALL_FRICTION_CELL_PLATE];
    double least = INFINITY;
    for (int32_t s = 0; s < plate->shape_count; s++) {
        least = fmin(least, clod_wall_gap(&plate->shapes[s], p).distance);
    }
    return least;
}

/** Distance of (y, z) from the line between two places of a section. */
static double line_distance(double y, double z, const double a[2], const double b[2])
{
    const double u[2] = {b[0] - a[0], b[1] - a[1]};
    const double along = ((y - a[0]) * u[0] + (z - a[1]) * u[1]) / (u[0] * u[0] + u[1] * u[1]);
    const double at = fmin(fmax(along, 0.0), 1.0);
    return hypot(y - a[0] - at * u[0], z - a[1] - at * u[1]);
}

typedef struct section {
    double height, width, crest;
} section;

/** Distance of a place from a ridge whose middle is at y = 0, without the floor. */
static double ridge_distance(const section *of, double y, double z)
{
    const double foot = 0.5 * of->width, top = 0.5 * of->crest;
    const double at[4][2] = {{-foot, 0.0}, {-top, of->height}, {top, of->height}, {foot, 0.0}};
    const double left = line_distance(y, z, at[0], at[1]);
    const double right = line_distance(y, z, at[2], at[3]);
    const double flat = top > 0.0 ? line_distance(y, z, at[1], at[2]) : left;
    return fmin(fmin(left, right), flat);
}

/** Heights and places across that are looked at [m]. */
static const double HEIGHTS[] = {0.3e-3, 1.1e-3, 2.0e-3, 2.6e-3, 4e-3};
enum { ACROSS = 41 };

static void check_straight(const char *ridges, section of)
{
    clod_state s;
    clod_case *from = begin_cell(STRAIGHT, ridges, NULL, &s);
    for (int h = 0; h < 5; h++) {
        for (int k = 0; k < ACROSS; k++) {
            // the front is one spacing of 6 mm before the disc of 30 mm, a crest 3 mm behind it
            const double x = -20e-3 + 1.01e-3 * k, z = HEIGHTS[h];
            double expected = INFINITY;
            for (int r = -1; r < 12; r++) {
                const double crest = 33e-3 - 6e-3 * r;
                expected = fmin(expected, ridge_distance(&of, x - crest, z));
                const double floor[2][2] = {{crest + 0.5 * of.width, 0.0},
                                            {crest + 6e-3 - 0.5 * of.width, 0.0}};
                if (of.width < 6e-3) {
                    expected = fmin(expected, line_distance(x, z, floor[0], floor[1]));
                }
            }
            check_close(plate_distance(&s, (clod_vec3){x, 0.4e-3 * k, z}), expected, 2e-8);
        }
    }
    cell_end(from, &s);
}

static void a_straight_plate_has_the_section_of_the_case(void **state)
{
    (void)state;
    check_straight("height: 2 mm, spacing: 6 mm", (section){2e-3, 6e-3, 0.0});
    check_straight("height: 2 mm, spacing: 6 mm, width: 3 mm", (section){2e-3, 3e-3, 0.0});
    check_straight("height: 2 mm, spacing: 6 mm, width: 4 mm, crest: 1 mm",
                   (section){2e-3, 4e-3, 1e-3});
    check_straight("height: 2 mm, spacing: 6 mm, width: 2 mm, crest: 2 mm",
                   (section){2e-3, 2e-3, 2e-3}); // a bar
}

/** 49 ridges (test_wall_ridges.c), the first along x; a floor of wedges between them. */
static void check_ring(const char *ridges, section of)
{
    clod_state s;
    clod_case *from = begin_cell(RING, ridges, NULL, &s);
    for (int h = 0; h < 5; h++) {
        for (int k = 0; k < ACROSS; k++) {
            const double angle = 2.0 * M_PI * k / ACROSS, radius = 40e-3 + 0.2e-3 * k;
            const clod_vec3 p = {radius * cos(angle), radius * sin(angle), HEIGHTS[h]};
            double expected = INFINITY;
            bool over_floor = true;
            for (int r = 0; r < 49; r++) {
                const double turned = angle - 2.0 * M_PI * r / 49.0;
                const double y = radius * sin(turned);
                if (cos(turned) > 0.0) {
                    expected = fmin(expected, ridge_distance(&of, y, p.z));
                    over_floor = over_floor && fabs(y) > 0.5 * of.width;
                }
            }
            expected = over_floor ? fmin(expected, p.z) : expected;
            check_close(plate_distance(&s, p), expected, 2e-8);
        }
    }
    assert_true(s.walls.wall[0].shape_count >= 4 * 3 * 49); // two flanks and a floor
    cell_end(from, &s);
}

static void a_ring_has_radial_ridges_of_one_section(void **state)
{
    (void)state;
    const double room = 60e-3 * sin(M_PI / 49.0);
    check_ring("height: 2 mm, spacing: 6 mm", (section){2e-3, room, 0.0});
    check_ring("height: 2 mm, spacing: 6 mm, width: 3 mm, crest: 1 mm",
               (section){2e-3, 3e-3, 1e-3});
}

static void grains_begin_above_the_crests(void **state)
{
    (void)state;
    const char *const cells[] = {RING, STRAIGHT};
    for (int c = 0; c < 2; c++) {
        clod_state s;
        clod_case *from = begin_cell(cells[c], "height: 2 mm, spacing: 6 mm",
                                     "wall_friction.grain_count=auto", &s);
        assert_true(s.grains.count > 100);
        cell_check_nothing_touches(&s);
        cell_end(from, &s);
    }
}

// ---- statics

#define RADIUS 2.5e-3
#define SPEED 0.01 ///< m/s of the plate
#define LOOK 12e-6 ///< m of its way from look to look
#define WEIGHT (2500.0 * 4.0 / 3.0 * M_PI * RADIUS * RADIUS * RADIUS * 9.81)

enum { PLATE, SIDES };

/** Mean forces of a grain on plate and side since the last look [N], and where it is [m]. */
typedef struct look {
    double drag, weight, side, x, height;
} look;

static look look_at(clod_sim *sim)
{
    clod_sim_wall plate, side;
    CHECK(clod_sim_wall_look(sim, PLATE, &plate, &status));
    CHECK(clod_sim_wall_look(sim, SIDES, &side, &status));
    clod_sim_reset_wall_means(sim);
    const clod_sim_view at = sim_view(sim, "position");
    const double *p = clod_sim_row(&at, 0);
    return (look){-plate.mean_force[0], -plate.mean_force[2], side.mean_force[0], p[0], p[2]};
}

/** A grain against the side wall, on a plate that moves towards it, slow as nothing. */
static clod_sim *pulled(const char *ridges)
{
    clod_sim *sim = sim_made(text_of(STRAIGHT, ridges), 1);
    const clod_sim_view at = sim_view(sim, "position");
    double *place = clod_sim_row(&at, 0);
    place[0] = 30e-3 - RADIUS;
    place[1] = 0.0;
    place[2] = 6e-3;
    CHECK(clod_sim_positions_changed(sim, &status));
    CHECK(clod_sim_set_wall_velocity(sim, PLATE, (double[]){SPEED, 0.0, 0.0}, &status));
    return sim;
}

/** While a flank lifts the grain, drag/weight is the slope of the flank: N sin a and N cos a. */
static void check_flank(const char *ridges, double slope, double crests)
{
    clod_sim *sim = pulled(ridges);
    int lifted = 0, steadily = 0;
    double top = 0.0, before = 1.0;
    for (int k = 0; k < 600; k++) { // over a spacing, and more
        CHECK(clod_sim_advance(sim, (int64_t)(LOOK / SPEED / clod_sim_dt(sim)), &status));
        const look now = look_at(sim);
        // where on the flank it touches: between foot and crest, and on its way up
        const double touches = now.height - RADIUS / hypot(1.0, slope);
        const bool on_flank = touches > 0.2 * crests && touches < 0.8 * crests;
        const bool held = now.x > 30e-3 - RADIUS; // it does not slide to and fro in the groove
        steadily = held && on_flank && now.height > before ? steadily + 1 : 0;
        top = k > 100 ? fmax(top, now.height) : 0.0; // it has fallen by then
        if (steadily > 5) {                          // after the blow at the foot
            check_relative(now.weight, WEIGHT, 0.01);
            check_relative(now.drag / now.weight, slope, 1e-3);
            check_relative(now.side / now.weight, slope, 1e-3);
            lifted++;
        }
        before = now.height;
    }
    assert_true(lifted > 20);
    check_close(top, crests + RADIUS, 0.01e-3); // over the crest, not through it
    clod_sim_destroy(&sim);
}

static void drag_over_weight_is_the_slope_of_the_flank(void **state)
{
    (void)state;
    if (!sanitized()) {
        check_flank("height: 1 mm, spacing: 5 mm", 0.4, 1e-3);
    }
    check_flank("height: 1 mm, spacing: 6 mm, width: 4 mm, crest: 1 mm", 2.0 / 3.0, 1e-3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_plate_has_the_section_of_the_case),
        cmocka_unit_test(a_ring_has_radial_ridges_of_one_section),
        cmocka_unit_test(grains_begin_above_the_crests),
        cmocka_unit_test(drag_over_weight_is_the_slope_of_the_flank),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
