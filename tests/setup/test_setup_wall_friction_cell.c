// The cell of the wall friction test: walls by hand, grains by brute force.

#include "setup/wall_friction_cell.h"

#include <stdio.h>

#include "support/cell.h"

static const char CASE[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3}\n"
    "  side: {}\n"
    "  plate: {}\n"
    "  top: {}\n"
    "contacts:\n"
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"
    "            k_adh: 3.56e8 N/m^1.5, friction: 0.35}\n"
    "wall_friction:\n"
    "  grain_material: ore\n"
    "  side_material: side\n"
    "  plate_material: plate\n"
    "  lid_material: top\n"
    "  radius: {mean: 3.175 mm, sd: 0.16 mm, min: 2.85 mm, max: 3.49 mm}\n"
    "  outer_radius: 60 mm\n"
    "  depth: 20 mm\n"
    "  lid_mass: 0.3 kg\n"
    "  wall_stresses: [10 kPa, 50 kPa]\n";
static const char RING[] = "  inner_radius: 30 mm\n  bar_count: 6\n";
static const char STRAIGHT[] = "  cell: straight\n";

static clod_case *build(const char *more, clod_state *state)
{
    char text[2048];
    clod_status status = {0};
    snprintf(text, sizeof text, "%s%s", CASE, more);
    clod_case *from = case_of(text, NULL);
    if (!clod_setup_wall_friction_cell(from, 1, state, &status)) {
        fail_msg("%s", status.text);
    }
    return from;
}

static void check_walls(const clod_case *from, const clod_state *s, const int shapes[3])
{
    const char *names[3] = {"plate", "sides", "lid"};
    const char *materials[3] = {"plate", "side", "top"};
    assert_int_equal(s->walls.count, 3);
    for (int w = 0; w < 3; w++) {
        const clod_wall *wall = &s->walls.wall[w];
        assert_string_equal(wall->name, names[w]);
        assert_int_equal(wall->material, clod_case_material_index(from, materials[w]));
        assert_int_equal(wall->shape_count, shapes[w]);
        assert_true(wall->shapes[0].symmetric);
        assert_true(wall->spin == 0.0 && wall->velocity.x == 0.0);
    }
    const clod_wall *lid = &s->walls.wall[CLOD_WALL_FRICTION_CELL_LID];
    const clod_shape *sides = s->walls.wall[CLOD_WALL_FRICTION_CELL_SIDES].shapes;
    assert_int_equal(lid->load, CLOD_LOAD_STRESS);
    assert_true(lid->mass == 0.3 && lid->load_force == 0.0);
    assert_true(sides[0].outer == 0.06 && sides[0].side == CLOD_SIDE_INSIDE);
    check_close(2.0 * sides[0].half[2], lid->shapes[0].center.z, 1e-16);
    assert_true(s->walls.wall[CLOD_WALL_FRICTION_CELL_PLATE].shapes[0].center.z == 0.0);
}

static void a_ring_has_bars_on_its_lid_alone(void **state)
{
    (void)state;
    clod_state s;
    clod_case *from = build(RING, &s);
    check_walls(from, &s, (const int[3]){1, 2, 7});
    const clod_wall *lid = &s.walls.wall[CLOD_WALL_FRICTION_CELL_LID];
    const clod_shape *plate = s.walls.wall[CLOD_WALL_FRICTION_CELL_PLATE].shapes;
    check_relative(lid->area, 3.14159265358979 * 0.0027, 1e-14); // pi (0.06^2 - 0.03^2)
    assert_true(plate->kind == CLOD_SHAPE_ANNULUS && plate->inner == 0.03);
    // bars of 6.35 mm hang from the lid, free of the grains below
    check_close(lid->shapes[1].center.z, lid->shapes[0].center.z - 0.5 * 6.35e-3, 1e-15);
    assert_int_equal(lid->shapes[1].kind, CLOD_SHAPE_BAR);
    cell_end(from, &s);
}

static void a_straight_cell_has_an_endless_plate(void **state)
{
    (void)state;
    clod_state s;
    clod_case *from = build(STRAIGHT, &s);
    check_walls(from, &s, (const int[3]){1, 1, 1});
    const clod_wall *lid = &s.walls.wall[CLOD_WALL_FRICTION_CELL_LID];
    check_relative(lid->area, 3.14159265358979 * 0.0036, 1e-14);
    assert_true(lid->shapes[0].inner == 0.0);
    assert_int_equal(s.walls.wall[CLOD_WALL_FRICTION_CELL_PLATE].shapes[0].kind,
                     CLOD_SHAPE_PLANE);
    cell_end(from, &s);
}

static void grains_are_in_the_cell_and_touch_nothing(void **state)
{
    (void)state;
    const char *const cells[] = {RING, STRAIGHT};
    for (int c = 0; c < 2; c++) {
        clod_state s;
        clod_case *from = build(cells[c], &s);
        cell_check_nothing_touches(&s);
        for (size_t i = 0; i < s.grains.count; i++) {
            const double *p = s.grains.position[i];
            assert_true(hypot(p[0], p[1]) < 0.06 && (c > 0 || hypot(p[0], p[1]) > 0.03));
        }
        cell_end(from, &s);
    }
}

// By hand: straight 0.6 pi 0.06^2 0.02 m3 = 1.35717e-4 m3; a grain has 1.3471e-7 m3 (as in
// test_setup_ring_cell.c): 1007 grains. Ring: 0.6 (pi 0.0027 0.02 m3 - 6 bars of 29.43 mm by 3 mm
// by 6.35 mm) = 9.9770e-5 m3: 741 grains. Within 3 sd of the sum of the drawn ones, 13.
static void auto_fills_the_depth(void **state)
{
    (void)state;
    const char *const cells[] = {RING, STRAIGHT};
    const double counts[] = {741.0, 1007.0};
    for (int c = 0; c < 2; c++) {
        clod_state s;
        clod_case *from = build(cells[c], &s);
        check_close((double)s.grains.count, counts[c], 13.0);
        cell_end(from, &s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ring_has_bars_on_its_lid_alone),
        cmocka_unit_test(a_straight_cell_has_an_endless_plate),
        cmocka_unit_test(grains_are_in_the_cell_and_touch_nothing),
        cmocka_unit_test(auto_fills_the_depth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
