// The mould of the uniaxial test: walls by hand, grains by brute force.

#include "setup/uniaxial_cell.h"
#include "support/cell.h"

static const char CASE[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3}\n"
    "  side: {}\n"
    "  base: {}\n"
    "  top: {}\n"
    "contacts:\n"
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"
    "            k_adh: 3.56e8 N/m^1.5, friction: 0.35}\n"
    "uniaxial:\n"
    "  grain_material: ore\n"
    "  side_material: side\n"
    "  base_material: base\n"
    "  lid_material: top\n"
    "  radius: {mean: 3.175 mm, sd: 0.16 mm, min: 2.85 mm, max: 3.49 mm}\n"
    "  diameter: 60 mm\n"
    "  height: 50 mm\n"
    "  lid_mass: 0.3 kg\n"
    "  consolidation_stresses: [10 kPa, 50 kPa]\n";

static void build(const clod_case *from, clod_state *state)
{
    clod_status status = {0};
    if (!clod_setup_uniaxial_cell(from, 1, state, &status)) {
        fail_msg("%s", status.text);
    }
}

static void walls_stand_in_order_with_their_materials(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, &s);
    const char *names[3] = {"base", "mould", "lid"};
    const char *materials[3] = {"base", "side", "top"};
    const int shapes[3] = {2, 1, 1};
    assert_int_equal(s.walls.count, 3);
    for (int w = 0; w < 3; w++) {
        const clod_wall *wall = &s.walls.wall[w];
        assert_string_equal(wall->name, names[w]);
        assert_int_equal(wall->material, clod_case_material_index(from, materials[w]));
        assert_int_equal(wall->shape_count, shapes[w]);
        assert_true(wall->shapes[0].symmetric);
    }
    const clod_wall *lid = &s.walls.wall[CLOD_UNIAXIAL_CELL_LID];
    assert_int_equal(lid->load, CLOD_LOAD_STRESS);
    assert_true(lid->load_axis.z == -1.0 && lid->mass == 0.3 && lid->load_force == 0.0);
    check_relative(lid->area, 3.14159265358979 * 0.0009, 1e-14); // pi 0.03^2
    assert_true(lid->shapes[0].outer == 0.03 && lid->shapes[0].axis[2].z == -1.0);
    // the mould from the base to the lid; the pan three times as wide, its rim at 50 mm
    const clod_shape *mould = s.walls.wall[CLOD_UNIAXIAL_CELL_MOULD].shapes;
    const clod_shape *base = s.walls.wall[CLOD_UNIAXIAL_CELL_BASE].shapes;
    assert_true(mould->outer == 0.03 && mould->center.z == 0.0);
    assert_int_equal(mould->side, CLOD_SIDE_INSIDE);
    check_close(2.0 * mould->half[2], lid->shapes[0].center.z, 1e-16);
    check_close(base[0].outer, 0.09, 1e-15);
    assert_true(base[0].center.z == 0.0 && base[0].axis[2].z == 1.0);
    check_close(base[1].outer, 0.09, 1e-15);
    check_close(2.0 * base[1].half[2], 0.05, 1e-16);
    cell_end(from, &s);
}

static void grains_are_in_the_mould_and_touch_nothing(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, &s);
    cell_check_nothing_touches(&s);
    const clod_grains *g = &s.grains;
    for (size_t i = 0; i < g->count; i++) {
        const double *p = g->position[i];
        assert_true(hypot(p[0], p[1]) < 0.03);
    }
    // room for rubble on the whole pan
    for (int a = 0; a < 2; a++) {
        assert_true(s.domain.min[a] < -0.09 && s.domain.max[a] > 0.09);
    }
    assert_true(s.domain.max[2] > 2.0 * s.walls.wall[CLOD_UNIAXIAL_CELL_MOULD].shapes->half[2]);
    cell_end(from, &s);
}

// By hand: 0.6 pi 0.03^2 0.05 m3 = 8.4823e-5 m3; a grain has 1.3471e-7 m3 (as in
// test_setup_ring_cell.c): 630 grains, within 3 sd of the sum of the drawn ones, 10.
static void height_gives_the_number_of_grains(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, NULL);
    clod_state s;
    build(from, &s);
    check_close((double)s.grains.count, 630.0, 10.0);
    double volume = 0.0;
    for (size_t i = 0; i < s.grains.count; i++) {
        volume += s.grains.velocity[i][3] / 2481.3;
    }
    check_relative(volume, 8.4823e-5, 1e-3); // half a grain is 8e-4
    cell_end(from, &s);
    from = case_of(CASE, "uniaxial.grain_count=123");
    build(from, &s);
    assert_int_equal(s.grains.count, 123);
    cell_end(from, &s);
}

static void state_is_ready_for_filling(void **state)
{
    (void)state;
    clod_case *from = case_of(CASE, "uniaxial.fill_adhesion=20 %");
    clod_state s;
    build(from, &s);
    assert_true(s.adhesion == 0.2 && s.gravity[2] < -9.8 && s.step == 0);
    assert_true(s.build_motion < 0.0 && s.dt > 0.0);
    const clod_wall *lid = &s.walls.wall[CLOD_UNIAXIAL_CELL_LID];
    assert_true(lid->damping > 0.0);
    check_at_most(lid->damping * s.dt / lid->mass, 0.5);
    cell_end(from, &s);
}

// The step is that of the largest stress: overlaps go with F^(2/3) and the tangent with
// d^(1/2), so the period with stress^(-1/6).
static void the_largest_stress_sets_the_step(void **state)
{
    (void)state;
    double dt[2];
    const char *overrides[2] = {NULL, "uniaxial.consolidation_stresses=[100 kPa, 10 kPa]"};
    for (int k = 0; k < 2; k++) {
        clod_case *from = case_of(CASE, overrides[k]);
        clod_state s;
        build(from, &s);
        dt[k] = s.dt;
        cell_end(from, &s);
    }
    check_relative(dt[0] / dt[1], pow(2.0, 1.0 / 6.0), 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(walls_stand_in_order_with_their_materials),
        cmocka_unit_test(grains_are_in_the_mould_and_touch_nothing),
        cmocka_unit_test(height_gives_the_number_of_grains),
        cmocka_unit_test(state_is_ready_for_filling),
        cmocka_unit_test(the_largest_stress_sets_the_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
