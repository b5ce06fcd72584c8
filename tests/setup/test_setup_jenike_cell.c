// The Jenike cell: walls by hand, grains by brute force.

#include "setup/jenike_cell.h"
#include "support/cell.h"

// All lengths differ, so that none can stand for another.
static const char CASE[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3}\n"
    "  side: {}\n"
    "  base: {}\n"
    "  top: {}\n"
    "contacts:\n"
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"
    "            k_adh: 3.56e8 N/m^1.5, friction: 0.35}\n"
    "jenike:\n"
    "  grain_material: ore\n"
    "  side_material: side\n"
    "  base_material: base\n"
    "  lid_material: top\n"
    "  radius: {mean: 3.175 mm, sd: 0.16 mm, min: 2.85 mm, max: 3.49 mm}\n"
    "  diameter: 80 mm\n"
    "  base_height: 14 mm\n"
    "  ring_height: 21 mm\n"
    "  rim: 5 mm\n"
    "  offset: 4 mm\n"
    "  lid_mass: 0.3 kg\n"
    "  preshear_stress: 50 kPa\n"
    "  shear_stresses: [10 kPa, 30 kPa]\n";

enum { BASE, BASE_RING, SHEAR_RING, LID };

static void build(const clod_case *from, clod_state *state)
{
    clod_status status = {0};
    if (!clod_setup_jenike_cell(from, 1, state, &status)) {
        fail_msg("%s", status.text);
    }
}

static void walls_stand_in_order_with_their_materials(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, &s);
    const char *names[4] = {"base", "base_ring", "shear_ring", "lid"};
    const char *materials[4] = {"base", "side", "side", "top"};
    const int shapes[4] = {1, 2, 2, 1};
    assert_int_equal(s.walls.count, 4);
    for (int w = 0; w < 4; w++) {
        const clod_wall *wall = &s.walls.wall[w];
        assert_string_equal(wall->name, names[w]);
        assert_int_equal(wall->material, clod_case_material_index(from, materials[w]));
        assert_int_equal(wall->shape_count, shapes[w]);
        for (int k = 0; k < shapes[w]; k++) { // none has to be turned in space
            assert_true(wall->shapes[k].symmetric);
            assert_true(wall->shapes[k].center.x == (w < SHEAR_RING ? 0.0 : -0.004));
            assert_true(wall->shapes[k].center.y == 0.0);
        }
        assert_true(wall->velocity.x == 0.0 && wall->spin == 0.0);
    }
    const clod_wall *lid = &s.walls.wall[LID];
    assert_int_equal(lid->load, CLOD_LOAD_STRESS);
    assert_true(lid->load_axis.z == -1.0 && lid->mass == 0.3 && lid->load_force == 0.0);
    check_relative(lid->area, 3.14159265358979 * 0.0016, 1e-14); // pi 0.04^2
    assert_true(lid->spin_point.x == -0.004);                    // twisted about its own axis
    cell_end(from, &s);
}

// Floor at 0; the shear plane at 14 mm, with both rims in it; the shear ring up to the lid.
static void rings_meet_at_the_shear_plane(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, &s);
    const clod_shape *floor = s.walls.wall[BASE].shapes;
    const clod_shape *lower = s.walls.wall[BASE_RING].shapes;
    const clod_shape *upper = s.walls.wall[SHEAR_RING].shapes;
    const clod_shape *lid = s.walls.wall[LID].shapes;
    assert_true(floor->outer == 0.04 && floor->center.z == 0.0 && floor->axis[2].z == 1.0);
    assert_true(lid->outer == 0.04 && lid->axis[2].z == -1.0);
    for (int k = 0; k < 2; k++) {
        const clod_shape *ring = k == 0 ? lower : upper;
        assert_int_equal(ring[0].kind, CLOD_SHAPE_CYLINDER);
        assert_int_equal(ring[0].side, CLOD_SIDE_INSIDE);
        assert_true(ring[0].outer == 0.04);
        assert_int_equal(ring[1].kind, CLOD_SHAPE_ANNULUS);
        assert_true(ring[1].inner == 0.04 && ring[1].center.z == 0.014);
        check_close(ring[1].outer, 0.045, 1e-16);
    }
    assert_true(lower[1].axis[2].z == 1.0 && upper[1].axis[2].z == -1.0);
    assert_true(lower[0].center.z == 0.0 && upper[0].center.z == 0.014);
    check_close(2.0 * lower[0].half[2], 0.014, 1e-16);
    check_close(0.014 + 2.0 * upper[0].half[2], lid->center.z, 1e-15);
    check_at_least(lid->center.z, 0.035);
    cell_end(from, &s);
}

static void grains_are_in_the_cell_and_touch_nothing(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, &s);
    cell_check_nothing_touches(&s);
    const clod_grains *g = &s.grains;
    for (size_t i = 0; i < g->count; i++) {
        const double *p = g->position[i];
        // inside both cylinders and between floor and lid
        check_at_most(hypot(p[0], p[1]) + p[3], 0.04);
        check_at_most(hypot(p[0] + 0.004, p[1]) + p[3], 0.04);
        assert_true(p[2] > 0.0 && p[2] < s.walls.wall[LID].shapes[0].center.z);
    }
    cell_end(from, &s);
}

// A shell is thin and has two sides: a grain that would leave between the rings meets a rim, at
// the start and wherever the travel ends. Points of the shear plane that a grain could reach
// from a cell's inside and that no rim covers must be inside the other ring.
static void no_way_leads_out_between_the_rings(void **state)
{
    (void)state;
    static const double MOVED[] = {0.0, 0.004, 0.0085}; // behind, aligned, 4.5 mm before
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, &s);
    for (size_t m = 0; m < 3; m++) {
        for (int k = 0; k < 3600; k++) {
            const double angle = 2.0 * M_PI * k / 3600.0;
            const double x = 0.0399999 * cos(angle);
            const double y = 0.0399999 * sin(angle);
            const double at[2] = {x - (-0.004 + MOVED[m]), x + (-0.004 + MOVED[m])};
            for (int ring = 0; ring < 2; ring++) { // from the lower one up, and down again
                check_at_most(hypot(at[ring], y), s.walls.wall[SHEAR_RING].shapes[1].outer);
            }
        }
    }
    cell_end(from, &s);
}

// By hand: 0.6 pi 0.04^2 (0.014 + 0.021) m3 = 1.05558e-4 m3; a grain has 1.3471e-7 m3 (as in
// test_setup_ring_cell.c): 784 grains, within 3 sd of the sum of the drawn ones, 11.
static void heights_give_the_number_of_grains(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, &s);
    check_close((double)s.grains.count, 784.0, 11.0);
    double volume = 0.0;
    for (size_t i = 0; i < s.grains.count; i++) {
        volume += s.grains.velocity[i][3] / 2481.3;
    }
    check_relative(volume, 1.05558e-4, 1e-3); // half a grain is 6e-4
    cell_end(from, &s);
    from = case_of(CASE, "jenike.grain_count=123");
    build(from, &s);
    assert_int_equal(s.grains.count, 123);
    cell_end(from, &s);
}

static void state_is_ready_for_filling(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, "jenike.fill_adhesion=20 %");
    clod_state s;
    build(from, &s);
    assert_true(s.adhesion == 0.2 && s.gravity[2] < -9.8 && s.step == 0);
    assert_true(s.build_motion < 0.0 && s.dt > 0.0);
    // room for the shear ring's whole travel, from 4 mm behind to 5 mm before
    for (int a = 0; a < 2; a++) {
        assert_true(s.domain.min[a] < -0.049 && s.domain.max[a] > 0.05);
    }
    const clod_wall *lid = &s.walls.wall[LID];
    assert_true(lid->damping > 0.0);
    check_at_most(lid->damping * s.dt / lid->mass, 0.5);
    cell_end(from, &s);
}

// Few grains: the shear ring is as high as it is all the same.
static void lid_begins_at_the_top_of_the_ring_at_least(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, "jenike.grain_count=5");
    clod_state s;
    build(from, &s);
    check_relative(s.walls.wall[LID].shapes[0].center.z, 0.035, 1e-14);
    cell_end(from, &s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_stand_in_order_with_their_materials),
        cmocka_unit_test(rings_meet_at_the_shear_plane),
        cmocka_unit_test(grains_are_in_the_cell_and_touch_nothing),
        cmocka_unit_test(no_way_leads_out_between_the_rings),
        cmocka_unit_test(heights_give_the_number_of_grains),
        cmocka_unit_test(state_is_ready_for_filling),
        cmocka_unit_test(lid_begins_at_the_top_of_the_ring_at_least),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
