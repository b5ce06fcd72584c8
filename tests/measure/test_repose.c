// Angles of cones and slopes that are made of grains.

#include "measure/repose.h"

#include <string.h>

#include "support/check.h"

#define R 1e-3 ///< m, of a grain
#define DEGREE (180.0 / M_PI)

static clod_status status;
static const double NONE[3] = {0.0, 0.0, 0.0};
static const clod_outlet BOX = {.low = {-0.096, -0.096, 0.0}, .high = {0.096, 0.096, 0.1}};

static void add(clod_state *state, double x, double y, double z)
{
    const double position[4] = {x, y, z, R};
    assert_true(clod_grains_add(&state->grains, position, NONE, NONE, 2500.0, 0,
                                state->grains.count + 1, &status));
}

/** Fill with grains on a fine lattice what lies below a surface; tops touch it. */
static void fill(clod_state *state, double (*surface)(double x, double y, double slope),
                 double slope)
{
    for (int i = -95; i <= 95; i++) {
        for (int j = -95; j <= 95; j++) {
            const double x = i * R, y = j * R, top = surface(x, y, slope);
            if (top > 2.0 * R) {
                add(state, x, y, top - R);
            }
            if (top > 8.0 * R) {
                add(state, x, y, 0.5 * top); // within: no part of the surface
            }
        }
    }
}

static double cone(double x, double y, double slope)
{
    return 0.05 - slope * hypot(x - 0.012, y + 0.007);
}

static double plane(double x, double y, double slope)
{
    (void)y;
    return 0.045 - slope * (x + 0.05);
}

static clod_repose_angle find(const clod_state *state, clod_repose self)
{
    clod_repose_angle found;
    self.region = BOX;
    self.from = 0.1;
    self.to = self.to > 0.0 ? self.to : 0.75;
    assert_true(clod_repose_find(&self, state, &found, &status));
    return found;
}

static void cones(void **unused)
{
    (void)unused;
    static const double ANGLE[] = {20.0, 30.0, 40.0};
    for (int k = 0; k < 3; k++) {
        clod_state state = {.dt = 1e-3};
        fill(&state, cone, tan(ANGLE[k] / DEGREE));
        double center[2];
        if (k == 2) { // which lies within the box
            assert_true(clod_repose_center(&BOX, &state, center));
            check_close(center[0], 0.012, 1e-4);
            check_close(center[1], -0.007, 1e-4);
        }
        for (int cell = 2; cell <= 6; cell += 2) {
            const clod_repose_angle found =
                find(&state, (clod_repose){.cell = cell * R, .center = {0.012, -0.007}});
            check_close(found.angle * DEGREE, ANGLE[k], 1.0);
            check_close(found.height, 0.05, cell * R);
            check_at_most(found.error * DEGREE, 0.7);
            assert_true(found.strips > 4);
        }
        clod_state_fini(&state);
    }
}

/** Along its direction a slope falls, against it it rises; across it is level. */
static void slopes(void **unused)
{
    (void)unused;
    clod_state state = {.dt = 1e-3};
    fill(&state, plane, tan(25.0 / DEGREE));
    clod_repose self = {.cell = 2.0 * R, .slope = true, .direction = {1.0, 0.0}};
    check_close(find(&state, self).angle * DEGREE, 25.0, 0.3);
    self.direction[0] = -1.0;
    check_close(find(&state, self).angle * DEGREE, -25.0, 0.3);
    self.direction[0] = 0.0;
    self.direction[1] = 1.0;
    self.to = 1.0; // all strips are as high
    check_close(find(&state, self).angle * DEGREE, 0.0, 0.1);
    clod_state_fini(&state);
}

static void no_heap_no_angle(void **unused)
{
    (void)unused;
    clod_state state = {.dt = 1e-3};
    double center[2];
    const clod_repose round = {.cell = 2.0 * R};
    assert_true(isnan(find(&state, round).angle) && isnan(find(&state, round).height));
    assert_false(clod_repose_center(&BOX, &state, center));
    for (int k = 0; k < 40; k++) { // a pillar: no ring between the heights
        add(&state, 0.0, 0.0, R + k * 2.0 * R);
    }
    check_close(find(&state, round).height, 0.08 / 3.0, 1e-9); // in one of three cells
    assert_true(isnan(find(&state, round).angle));
    assert_int_equal(find(&state, round).strips, 0);
    clod_state_fini(&state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cones),
        cmocka_unit_test(slopes),
        cmocka_unit_test(no_heap_no_angle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
