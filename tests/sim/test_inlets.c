// Places of grains that come during a run: in their region, clear of each other and of walls.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "setup/state.h"
#include "sim/inlets.h"
#include "support/case_of.h"
#include "support/sim_made.h"

/** The run begins with these grains. */
static void begin(clod_inlets *self, const clod_case *from, const clod_state *state)
{
    const clod_free_start bed = clod_free_start_of(state);
    CLOD_MEASURE_INLETS.begin(self, from, state, &bed);
}

/** Two inlets that share a part of their space, beside the plate of a floor. */
static const char *const TEXT =
    "materials: {ore: {density: 2000 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}\n"
    "time: {step: 1e-4 s, design_stress: 100 Pa}\n"
    "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
    "grains:\n"
    "  - material: ore\n"
    "    radius: {distribution: uniform, min: 4 mm, max: 6 mm}\n"
    "    inlet: {number_flow: 1e5 1/s}\n"
    "    count: 120\n"
    "    region: {box: {min: [-50 mm, -50 mm, 0 mm], max: [50 mm, 50 mm, 60 mm]}}\n"
    "  - material: ore\n"
    "    radius: {distribution: uniform, min: 3 mm, max: 4 mm}\n"
    "    inlet: {number_flow: 1e5 1/s}\n"
    "    count: 80\n"
    "    region: {annulus: {center: [40 mm, 0 mm, 0 mm], outer_radius: 50 mm, height: 60 mm}}\n"
    "walls:\n"
    "  floor: {material: ore, shapes: [{box: {center: [0 m, 0 m, 5 mm], size: [60 mm, 60 mm, 20 mm]}}]}\n"
    "stages: [{name: run, duration: 1 s}]\n";

static void made(clod_case **from, clod_state *state)
{
    *from = case_of(TEXT, NULL);
    CHECK(clod_setup_state(*from, 1, state, &status));
    assert_int_equal(state->grains.count, 0);
}

static bool act(clod_inlets *inlets, const clod_case *from, clod_state *state)
{
    const clod_survey survey = clod_survey_of(state, NULL);
    const clod_free_moment now = {.from = from, .state = state, .survey = &survey};
    return CLOD_MEASURE_INLETS.act(inlets, &now, &status);
}

static void grains_come_clear_of_all(void **unused)
{
    (void)unused;
    clod_case *from;
    clod_state state;
    clod_inlets inlets;
    made(&from, &state);
    begin(&inlets, from, &state);
    inlets.next = state.step = 1000; // 0.1 s: all of both groups are due
    CHECK(act(&inlets, from, &state));
    const clod_changes *queue = &state.changes;
    assert_int_equal(queue->new_grains, 200);
    for (size_t k = 0; k < queue->new_grains; k++) {
        const double *p = queue->new_grain[k].position, r = p[3];
        assert_int_equal(queue->new_grain[k].id, k + 1);
        if (k >= 160 || k % 2 == 0) { // they take turns, until one has all of its grains
            assert_true(fabs(p[0]) <= 0.05 - r && fabs(p[1]) <= 0.05 - r);
            assert_true(r >= 0.004 && r <= 0.006);
        } else {
            assert_true(hypot(p[0] - 0.04, p[1]) <= 0.05 - r);
            assert_true(r >= 0.003 && r <= 0.004);
        }
        assert_true(p[2] >= r && p[2] <= 0.06 - r);
        const double beside = hypot(fmax(0.0, fabs(p[0]) - 0.03), fmax(0.0, fabs(p[1]) - 0.03));
        assert_true(hypot(beside, fmax(0.0, p[2] - 0.015)) >= r); // the floor
        for (size_t j = 0; j < k; j++) {
            const double *q = queue->new_grain[j].position;
            const double apart = hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
            assert_true(apart >= r + q[3]);
        }
    }
    // once for a step
    CHECK(act(&inlets, from, &state));
    assert_int_equal(queue->new_grains, 200);
    clod_state_fini(&state);
    clod_case_destroy(&from);
}

/** Places are those of seed, id and step alone: what is in a checkpoint. */
static void the_same_state_gives_the_same_grains(void **unused)
{
    (void)unused;
    clod_new_grain first[200];
    for (int k = 0; k < 2; k++) {
        clod_case *from;
        clod_state state;
        clod_inlets inlets;
        made(&from, &state);
        begin(&inlets, from, &state);
        inlets.next = state.step = 1000;
        CHECK(act(&inlets, from, &state));
        for (size_t g = 0; k == 1 && g < 200; g++) {
            assert_memory_equal(first[g].position, state.changes.new_grain[g].position,
                                sizeof first[g].position);
        }
        memcpy(first, state.changes.new_grain, sizeof first);
        clod_state_fini(&state);
        clod_case_destroy(&from);
    }
}

/** Faces askew: how far a centre is before the face, and how far from its middle along two
 *  directions in it, by the numbers of the case. */
static void grains_come_whole_before_a_face(void **unused)
{
    (void)unused;
    static const char *const FACES[2] = {
        "{disc: {center: [10 mm, 0 mm, 5 mm], radius: 40 mm, normal: [3, 0, -4]}}",
        "{rectangle: {center: [10 mm, 0 mm, 5 mm], edge_1: [0 mm, 60 mm, 0 mm], "
        "edge_2: [64 mm, 0 mm, 48 mm]}}"};
    for (int face = 0; face < 2; face++) {
        char text[1200];
        snprintf(text, sizeof text,
                 "materials: {ore: {density: 2500 kg/m3}}\n"
                 "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5}}\n"
                 "time: {step: 5e-5 s, design_stress: 100 Pa}\n"
                 "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
                 "grains:\n"
                 "  - {material: ore, radius: {distribution: uniform, min: 2 mm, max: 3 mm},\n"
                 "     inlet: {number_flow: 1000 1/s}, velocity: [5 m/s, 1 m/s, -5 m/s],\n"
                 "     region: %s}\n"
                 "stages: [{name: run, duration: 1 s}]\n",
                 FACES[face]);
        clod_case *from = case_of(text, NULL);
        clod_state state;
        clod_inlets inlets;
        CHECK(clod_setup_state(from, 1, &state, &status));
        begin(&inlets, from, &state);
        inlets.next = state.step = 400; // 20 grains are due
        CHECK(act(&inlets, from, &state));
        assert_int_equal(state.changes.new_grains, 20);
        double most = 0.0;
        for (size_t k = 0; k < state.changes.new_grains; k++) {
            const double *p = state.changes.new_grain[k].position, r = p[3];
            const double x = p[0] - 0.01, y = p[1], z = p[2] - 0.005;
            const double before = 0.6 * x - 0.8 * z, along = 0.8 * x + 0.6 * z;
            // 7 m/s along the normal, in 1 ms
            assert_true(before >= r - 1e-15 && before <= r + 0.007 + 1e-15);
            assert_true(face == 0
                            ? hypot(along, y) <= 0.04 - r + 1e-15
                            : fabs(y) <= 0.03 - r + 1e-15 && fabs(along) <= 0.04 - r + 1e-15);
            most = fmax(most, before - r);
        }
        assert_true(most > 0.0035); // not all at the face itself
        clod_state_fini(&state);
        clod_case_destroy(&from);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grains_come_clear_of_all),
        cmocka_unit_test(the_same_state_gives_the_same_grains),
        cmocka_unit_test(grains_come_whole_before_a_face),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
