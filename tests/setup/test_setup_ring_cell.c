// The ring shear cell: walls by hand, grains by brute force.

#include <string.h>

#include "setup/ring_cell.h"
#include "support/cell.h"

static const char CASE[] =
    "title: cell\n"
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3, youngs_modulus: 119 GPa, poissons_ratio: 0.34}\n"
    "  side: {}\n"
    "  base: {}\n"
    "  top: {}\n"
    "contacts:\n"
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"
    "            k_adh: 3.56e8 N/m^1.5, friction: 0.35, rolling: epsd2, rolling_friction: "
    "0.3}\n"
    "ring_shear:\n"
    "  grain_material: ore\n"
    "  side_material: side\n"
    "  base_material: base\n"
    "  lid_material: top\n"
    "  radius: {mean: 3.175 mm, sd: 0.16 mm, min: 2.85 mm, max: 3.49 mm}\n"
    "  inner_radius: 50 mm\n"
    "  outer_radius: 100 mm\n"
    "  depth: 40 mm\n"
    "  bar_count: 20\n"
    "  bar_height: 6.35 mm\n"
    "  bar_width: 3 mm\n"
    "  lid_mass: 1 kg\n"
    "  fill_adhesion: 10 %\n"
    "  preshear_stress: 54.8 kPa\n"
    "  shear_stresses: [10.96 kPa, 43.84 kPa]\n";

static void build(const clod_case *from, int64_t seed, clod_state *state)
{
    clod_status status = {0};
    if (!clod_setup_ring_cell(from, seed, state, &status)) {
        fail_msg("%s", status.text);
    }
}

static void walls_stand_in_order_with_their_materials(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, 1, &s);
    assert_int_equal(s.walls.count, 3);
    const char *names[3] = {"trough", "sides", "lid"};
    const char *materials[3] = {"base", "side", "top"};
    const int shapes[3] = {21, 2, 21};
    for (int w = 0; w < 3; w++) {
        const clod_wall *wall = &s.walls.wall[w];
        assert_string_equal(wall->name, names[w]);
        assert_int_equal(wall->material, clod_case_material_index(from, materials[w]));
        assert_int_equal(wall->shape_count, shapes[w]);
        assert_true(wall->spin == 0.0 && wall->spin_axis.z == 1.0);
    }
    const clod_wall *lid = &s.walls.wall[CLOD_RING_CELL_LID];
    assert_int_equal(lid->load, CLOD_LOAD_STRESS);
    assert_true(lid->load_axis.z == -1.0 && lid->mass == 1.0 && lid->load_force == 0.0);
    check_relative(lid->area, 3.14159265358979 * 0.0075, 1e-14); // pi (0.1^2 - 0.05^2)
    cell_end(from, &s);
}

// By hand: bar 0 lies along x between 50 and 100 mm less 0.285 mm at both ends, its middle at
// 75 mm; bar 5 of 20 lies along y. Bars stand on the base and hang from the lid.
static void bars_are_radial_boxes_on_base_and_lid(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, 1, &s);
    const clod_shape *base = s.walls.wall[CLOD_RING_CELL_TROUGH].shapes;
    const clod_shape *lid = s.walls.wall[CLOD_RING_CELL_LID].shapes;
    assert_true(base[0].symmetric && lid[0].symmetric && !base[1].symmetric);
    assert_true(base[0].axis[2].z == 1.0 && lid[0].axis[2].z == -1.0);
    assert_true(base[0].center.z == 0.0 && base[0].inner == 0.05 && base[0].outer == 0.1);
    check_close(base[1].center.x, 0.075, 1e-16);
    check_close(base[1].center.z, 3.175e-3, 1e-17);
    check_close(base[1].half[0], 0.025 - 0.285e-3, 1e-16);
    check_close(base[1].half[1], 1.5e-3, 1e-17);
    check_close(base[1].half[2], 3.175e-3, 1e-17);
    check_close(base[6].center.x, 0.0, 1e-16);
    check_close(base[6].center.y, 0.075, 1e-16);
    check_close(base[6].axis[0].y, 1.0, 1e-15);
    check_close(lid[1].center.z, lid[0].center.z - 3.175e-3, 1e-16);
    const clod_shape *side = s.walls.wall[CLOD_RING_CELL_SIDES].shapes;
    assert_true(side[0].outer == 0.05 && side[0].side == CLOD_SIDE_OUTSIDE);
    assert_true(side[1].outer == 0.1 && side[1].side == CLOD_SIDE_INSIDE);
    assert_true(side[0].symmetric && side[1].symmetric);
    check_close(2.0 * side[0].half[2], lid[0].center.z, 1e-16);
    cell_end(from, &s);
}

static void grains_touch_nothing(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, 1, &s);
    cell_check_nothing_touches(&s);
    const clod_grains *g = &s.grains;
    for (size_t i = 0; i < g->count; i++) {
        const double *p = g->position[i];
        for (int a = 0; a < 3; a++) {
            assert_true(p[a] > s.domain.min[a] && p[a] < s.domain.max[a]);
        }
        const double rho = hypot(p[0], p[1]);
        assert_true(rho > 0.05 && rho < 0.1 && p[2] > 0.0);
    }
    cell_end(from, &s);
}

// By hand: 0.6 (pi 0.0075 m2 * 0.04 m - 40 bars * 49.43 mm * 3 mm * 6.35 mm) = 5.4289e-4 m3.
// The truncated normal has mean m = 3.1745 mm and spread s = 0.1407 mm, so a grain has 4/3 pi
// (m^3 + 3 m s^2) = 1.3471e-7 m3: 4030 grains, drawn ones within 3 sd of their sum, 25.
static void depth_and_bars_give_the_number_of_grains(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_status status = {0};
    const size_t count = clod_ring_cell_count(from, 1, &status);
    check_close((double)count, 4030.0, 30.0);
    clod_state s;
    build(from, 1, &s);
    assert_int_equal(s.grains.count, count);
    double volume = 0.0;
    for (size_t i = 0; i < count; i++) {
        volume += s.grains.velocity[i][3] / 2481.3;
    }
    check_relative(volume, 5.42887e-4, 1.5e-4); // half a grain is 1.2e-4
    cell_end(from, &s);
    from = case_of(CASE, "ring_shear.grain_count=321");
    build(from, 1, &s);
    assert_int_equal(s.grains.count, 321);
    cell_end(from, &s);
}

// docs/theory/time-step.md: near 1e-6 s. Damping by hand from the step's own stiffness is
// tested with the walls; here it must be there and the lid must stay stable: c dt/m < 2.
static void state_is_ready_for_filling(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, 1, &s);
    check_close(s.dt, 1e-6, 0.2e-6);
    assert_true(s.adhesion == 0.1 && s.gravity[2] < -9.8 && s.time == 0.0 && s.step == 0);
    assert_true(s.build_motion < 0.0);
    const clod_wall *lid = &s.walls.wall[CLOD_RING_CELL_LID];
    assert_true(lid->damping > 0.0);
    check_at_most(lid->damping * s.dt / lid->mass, 0.5);
    cell_end(from, &s);
}

static void seed_decides_every_bit(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, "ring_shear.grain_count=500");
    clod_state s[3];
    for (int k = 0; k < 3; k++) {
        build(from, k < 2 ? 3 : 4, &s[k]);
    }
    const size_t bytes = 500 * sizeof *s[0].grains.position;
    assert_memory_equal(s[0].grains.position, s[1].grains.position, bytes);
    assert_true(memcmp(s[0].grains.position, s[2].grains.position, bytes) != 0);
    for (int k = 0; k < 3; k++) {
        clod_state_fini(&s[k]);
    }
    clod_case_destroy(&from);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_stand_in_order_with_their_materials),
        cmocka_unit_test(bars_are_radial_boxes_on_base_and_lid),
        cmocka_unit_test(grains_touch_nothing),
        cmocka_unit_test(depth_and_bars_give_the_number_of_grains),
        cmocka_unit_test(state_is_ready_for_filling),
        cmocka_unit_test(seed_decides_every_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
