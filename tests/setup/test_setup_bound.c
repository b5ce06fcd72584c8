/**
 * What comes through the queue of a state is held to time step and laws, whoever fills it: an
 * inlet, a program that knows the state, the library (tests/sim/test_sim_change.c).
 */

#include <string.h>

#include "law/law.h"
#include "setup/bound.h"
#include "setup/state.h"
#include "setup/walls.h"
#include "step/step.h"
#include "support/case_of.h"
#include "support/sim_made.h"

/** Grains of ore of 2 mm on rubber; there is no law between rubber and rubber. */
static const char TEXT[] =
    "materials: {ore: {density: 2500 kg/m3}, rubber: {density: 1200 kg/m3}}\n"
    "contacts:\n"
    "  ore-ore: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0}\n"
    "  ore-rubber: {law: hooke, k1: 4e4 N/m, restitution: 0.5, friction: 0}\n"
    "time: {step: 1e-5 s, design_stress: 1 kPa}\n"
    "domain: {min: [-50 mm, -50 mm, -5 mm], max: [50 mm, 50 mm, 200 mm]}\n"
    "stages: [{name: fall, duration: 1 s}]\n"
    "grains:\n"
    "  - {material: ore, count: 2, radius: {distribution: uniform, min: 2 mm, max: 2 mm}, "
    "region: {box: {min: [-10 mm, -10 mm, 4 mm], max: [10 mm, 10 mm, 40 mm]}}}\n";

typedef struct made {
    clod_case *from;
    clod_state state;
    clod_laws laws;
    clod_step step;
} made;

static void make(made *self)
{
    *self = (made){0};
    self->from = case_of(TEXT, NULL);
    const clod_step_options options = {
        .threads = 1, .accepts = clod_setup_bound_accepts, .context = self->from};
    CHECK(clod_setup_state(self->from, 1, &self->state, &status));
    CHECK(clod_laws_init(&self->laws, self->from, &status));
    CHECK(clod_step_init(&self->step, &self->state, &self->laws, &options, &status));
}

static void destroy(made *self)
{
    clod_step_fini(&self->step);
    clod_laws_fini(&self->laws);
    clod_state_fini(&self->state);
    clod_case_destroy(&self->from);
}

/** Ask for a grain, without any library in between. */
static void ask(made *self, uint64_t id, double radius, uint16_t material)
{
    const clod_new_grain grain = {.id = id,
                                  .position = {0.01 * ((double)id - 900.0), 0.0, 0.1, radius},
                                  .density = material == 0 ? 2500.0 : 1200.0,
                                  .material = material};
    clod_changes_add_grain(&self->state.changes, &grain);
}

static double mass(double radius)
{
    return 2500.0 * 4.0 / 3.0 * M_PI * radius * radius * radius;
}

/**
 * The spring of two grains of this radius swings with T/pi = 2 sqrt(m/(2 k)): a radius for which
 * that is 1 % above the step is let in, one for which it is 1 % below is not.
 */
static void grains_are_held_to_the_critical_step(void **unused)
{
    (void)unused;
    made self;
    make(&self);
    const double step = self.state.dt;                           // 10 us
    const double r0 = cbrt(0.5 * step * step * 1e4 / mass(1.0)); // 2 sqrt(m/(2 k)) = step
    ask(&self, 900, 1.01 * r0, 0);                               // the time goes with r^1.5
    ask(&self, 901, 0.001, 0);
    CHECK(clod_step_change(&self.step, &status));
    assert_int_equal(self.state.grains.count, 4);
    ask(&self, 902, 0.99 * r0, 0);
    ask(&self, 903, 0.001, 0);
    expect_refused(clod_step_advance(&self.step, 1, &status), "with grain 902 (radius");
    assert_int_equal(self.state.grains.count, 4); // neither of the two
    assert_int_equal(self.state.step, 0);
    CHECK(clod_step_advance(&self.step, 1, &status)); // and it goes on
    destroy(&self);
}

/** A wall of rubber is four times as stiff: T/pi = 2 sqrt(m/k) for the grain's own mass m. */
static void walls_are_held_to_the_critical_step(void **unused)
{
    (void)unused;
    made self;
    make(&self);
    const double step = self.state.dt;
    const double r_wall = cbrt(0.25 * step * step * 4e4 / mass(1.0)); // 2 sqrt(m/k) = step
    clod_case_shape plane = {.kind = CLOD_SHAPE_PLANE, .normal = {0.0, 0.0, 1.0}};
    const clod_case_wall given = {.name = "floor",
                                  .material = "rubber",
                                  .shapes = &plane,
                                  .shape_count = 1,
                                  .spin_axis = {0.0, 0.0, 1.0}};
    ask(&self, 900, 0.995 * r_wall, 0); // two of these: 2 sqrt(m/(2 1e4)) is 1.4 times longer
    CHECK(clod_step_change(&self.step, &status));
    clod_wall wall = {0};
    CHECK(clod_setup_wall(self.from, &given, &wall, &status));
    clod_changes_add_wall(&self.state.changes, &wall);
    expect_refused(clod_step_change(&self.step, &status), "with wall 'floor' the time step");
    assert_int_equal(self.state.walls.count, 0);
    clod_changes_remove_grain(&self.state.changes, 900);
    CHECK(clod_step_change(&self.step, &status));
    CHECK(clod_setup_wall(self.from, &given, &wall, &status));
    clod_changes_add_wall(&self.state.changes, &wall);
    CHECK(clod_step_change(&self.step, &status)); // for grains of 2 mm it is short enough
    assert_int_equal(self.state.walls.count, 1);
    destroy(&self);
}

static void grains_need_laws(void **unused)
{
    (void)unused;
    made self;
    make(&self);
    ask(&self, 900, 0.002, 1);
    expect_refused(clod_step_change(&self.step, &status),
                   "no contact law for grains of 'rubber' with grains of 'rubber'");
    assert_int_equal(self.state.grains.count, 2);
    destroy(&self);
}

/** Grains from an inlet as the queue's: rubber meets its like, ore meets ore; and 1e-3 s is beyond
 *  pi sqrt(m/(2 k)) = 0.13 ms of two grains of 2 mm. */
static void streams_are_held_to_laws_and_the_critical_step(void **unused)
{
    (void)unused;
    made self;
    make(&self);
    self.from->grains[0].comes = true;
    const clod_survey survey = clod_survey_of(&self.state, NULL);
    CHECK(clod_setup_bound_streams(self.from, &survey, &status));
    self.state.dt = 1e-3;
    expect_refused(clod_setup_bound_streams(self.from, &survey, &status),
                   "with the grains that come in the time step of 0.001 s is beyond");
    self.state.dt = 1e-5;
    char *ore = self.from->grains[0].material, rubber[] = "rubber";
    self.from->grains[0].material = rubber;
    expect_refused(clod_setup_bound_streams(self.from, &survey, &status),
                   "no contact law for grains of 'rubber' with grains of 'rubber'");
    self.from->grains[0].material = ore;
    destroy(&self);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grains_are_held_to_the_critical_step),
        cmocka_unit_test(walls_are_held_to_the_critical_step),
        cmocka_unit_test(grains_need_laws),
        cmocka_unit_test(streams_are_held_to_laws_and_the_critical_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
