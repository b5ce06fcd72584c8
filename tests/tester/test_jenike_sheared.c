// The Jenike cell with real grains through consolidation and preshear: a wall friction test,
// whose outcome is known, and the travel from behind the base ring to before it.

#include <stdio.h>
#include <string.h>

#include "law/law.h"
#include "setup/jenike_cell.h"
#include "step/step.h"
#include "support/case_of.h"
#include "tester/ring_shear.h"

// Soft grains without adhesion that do not roll on the floor: they slide on it, as a block,
// when the floor is much smoother than they are among themselves.
static const char CASE[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3}\n"
    "  side: {}\n"
    "  base: {}\n"
    "  top: {}\n"
    "contacts:\n"
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e6 N/m^1.5, k2: 2.37e7 N/m^1.5,\n"
    "            k_adh: 0 N/m^1.5, restitution: 0.3, friction: 0.6, coulomb: force,\n"
    "            rolling: epsd2, rolling_friction: 0.6}\n"
    "  ore-side: {friction: 0, rolling: none}\n"
    "  ore-base: {friction: 0.15}\n"
    "jenike:\n"
    "  grain_material: ore\n"
    "  side_material: side\n"
    "  base_material: base\n"
    "  lid_material: top\n"
    "  radius: {mean: 2.8 mm, sd: 0.15 mm, min: 2.5 mm, max: 3.1 mm}\n"
    "  diameter: 40 mm\n"
    "  base_height: 10 mm\n"
    "  ring_height: 14 mm\n"
    "  fill_fraction: 0.5\n"
    "  rim: 5 mm\n"
    "  offset: 4 mm\n"
    "  lid_mass: 0.02 kg\n"
    "  preshear_stress: 5 kPa\n"
    "  shear_stresses: [2 kPa, 3 kPa]\n"
    "  speed: 40 mm/s\n"
    "  block_displacement: 0.5 mm\n"
    "  preshear_max: 6 mm\n"
    "  shear_max: 2 mm\n";

typedef struct bed {
    clod_case *from;
    clod_state state;
    clod_laws laws;
    clod_step step;
    clod_ring_shear test;
    double row[CLOD_RING_SHEAR_COLUMNS];
} bed;

static void begin(bed *self, double base_height, double offset)
{
    clod_status status = {0};
    const clod_step_options how = {.threads = 1};
    self->from = case_of(CASE, NULL);
    self->from->jenike.base_height = base_height;
    self->from->jenike.offset = offset;
    if (!clod_setup_jenike_cell(self->from, 1, &self->state, &status) ||
        !clod_laws_init(&self->laws, self->from, &status)) {
        fail_msg("%s", status.text);
    }
    clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    if (!clod_step_init(&self->step, &self->state, &self->laws, &how, &status)) {
        fail_msg("%s", status.text);
    }
    clod_ring_shear_begin(&self->test, self->from, &self->state);
}

static bool look(bed *self)
{
    clod_status status = {0};
    const int64_t steps = clod_ring_shear_plan(&self->test, &self->state);
    if (!clod_step_advance(&self->step, steps, &status)) {
        fail_msg("%s", status.text);
    }
    const bool done = clod_ring_shear_sample(&self->test, &self->state, self->row);
    clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    return done;
}

static void end(bed *self)
{
    clod_step_fini(&self->step);
    clod_laws_fini(&self->laws);
    clod_state_fini(&self->state);
    clod_case_destroy(&self->from);
}

// With the shear plane at the floor the whole specimen stands in the shear ring and slides over
// a plate: the wall friction test of ASTM D6128. The rings have no friction, so tau = 0.15
// sigma on the floor, but for grains that come loose for a moment and roll.
static void a_block_on_a_plate_is_held_by_its_friction(void **state)
{
    (void)state;
    bed b;
    double tau = 0.0, tau_base = 0.0, sigma_base = 0.0, sigma = 0.0;
    int samples = 0;
    begin(&b, 0.0, 0.0);
    while (!look(&b)) {
        if (b.test.phase == CLOD_RING_SHEAR_PRESHEAR && b.test.displacement > 1.5e-3) {
            tau += b.row[CLOD_RING_SHEAR_SHEAR_STRESS];
            tau_base += b.row[CLOD_RING_SHEAR_SHEAR_STRESS_BASE];
            sigma += b.row[CLOD_RING_SHEAR_NORMAL_STRESS];
            sigma_base += b.row[CLOD_RING_SHEAR_NORMAL_STRESS_BASE];
            samples++;
        }
    }
    assert_true(samples > 50);
    check_relative(tau / sigma, 0.15, 0.01);
    check_relative(tau_base / sigma_base, 0.15, 0.01);
    check_relative(sigma / samples, 5e3, 0.005); // what was asked for, at the shear plane
    end(&b);
}

/**
 * The overlap of one grain that carries the whole load of the lid, all at one contact of the
 * softest branch: d = (sigma A/k1)^(2/3) = (5 kPa pi (20 mm)^2/4.75e6 N/m^1.5)^(2/3) = 0.12 mm.
 */
static const double DEEPEST = 0.1205e-3;

/**
 * How far a grain of one ring reaches into the other ring's wall or rim [m]; the grain's centre
 * is `height` above or below the plane where they meet and `from_axis` from the other's axis.
 */
static double into_the_other(double height, double from_axis, double radius)
{
    return radius - hypot(fmax(20e-3 - from_axis, 0.0), height);
}

/** Is every grain inside floor, lid and both rings, whose walls and rims it only touches? */
static void check_inside(const bed *b)
{
    const clod_wall *ring = &b->state.walls.wall[CLOD_JENIKE_CELL_SHEAR_RING];
    const clod_wall *lid = &b->state.walls.wall[CLOD_JENIKE_CELL_LID];
    const double top = lid->shapes[0].center.z + lid->shift.z;
    assert_true(lid->shift.x == ring->shift.x);
    for (size_t g = 0; g < b->state.grains.count; g++) {
        const double *p = b->state.grains.position[g];
        const double height = p[2] - 10e-3; // above the shear plane
        const double in_base = hypot(p[0], p[1]);
        const double in_ring = hypot(p[0] + 4e-3 - ring->shift.x, p[1]);
        check_at_most((height > 0.0 ? in_ring : in_base) + p[3], 20e-3 + DEEPEST);
        check_at_most(into_the_other(height, height > 0.0 ? in_base : in_ring, p[3]), DEEPEST);
        check_at_most(p[3] - p[2], DEEPEST);
        check_at_most(p[2] + p[3] - top, DEEPEST);
    }
}

// From 4 mm behind the base ring to 2 mm before it, back until the shear stress is gone, and on
// to the end of the point.
static void no_grain_leaves_the_cell(void **state)
{
    (void)state;
    bed b;
    begin(&b, 10e-3, 4e-3);
    const clod_wall *ring = &b.state.walls.wall[CLOD_JENIKE_CELL_SHEAR_RING];
    b.test.steady.tolerance = 1e-9; // sheared to the end of the way
    while (!look(&b)) {
        check_inside(&b);
    }
    check_inside(&b);
    // whole blocks, each of 0.5 mm, within 6 mm
    check_close(ring->shift.x, 5.75e-3, 0.25e-3);
    double farthest = 0.0;
    clod_ring_shear_reverse(&b.test, &b.state);
    while (!look(&b)) {
        check_inside(&b);
        farthest = fmax(farthest, ring->shift.x);
    }
    assert_int_equal(b.test.flags, 0);
    assert_true(farthest - ring->shift.x > 0.1e-3);
    clod_ring_shear_branch(&b.test, 2e3, &b.state);
    while (!look(&b)) {
        check_inside(&b);
    }
    check_inside(&b);
    // past alignment the rims add to the resistance (docs/theory/jenike.md): no peak is asked
    // for
    assert_int_equal(b.test.flags & ~CLOD_RING_SHEAR_NO_PEAK, 0);
    assert_true(ring->shift.x > 6.1e-3); // farther than before
    end(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_block_on_a_plate_is_held_by_its_friction),
        cmocka_unit_test(no_grain_leaves_the_cell),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
