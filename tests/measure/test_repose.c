// Angles of cones and slopes cut out of a packing of grains that do not overlap.

#include "measure/repose.h"

#include <string.h>

#include "support/check.h"
#include "support/dice.h"

#define R 2e-3     ///< m, of a grain
#define LOOSE 0.05 ///< R, by which grains of the packing are moved at random
#define WIDE 0.096 ///< m, half width of the packing
#define DEGREE (180.0 / M_PI)

static clod_status status;
static const double NONE[3] = {0.0, 0.0, 0.0};
static const clod_outlet BOX = {.low = {-WIDE, -WIDE, 0.0}, .high = {WIDE, WIDE, 0.1}};

static void add(clod_state *state, double x, double y, double z)
{
    const double position[4] = {x, y, z, R};
    assert_true(clod_grains_add(&state->grains, position, NONE, NONE, 2500.0, 0,
                                state->grains.count + 1, &status));
}

/** Matrix of the rotation by a unit quaternion. */
static void rotation(const double q[4], double to[3][3])
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double m[3][3] = {
        {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)},
        {2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)},
        {2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)}};
    memcpy(to, m, sizeof m);
}

/**
 * Cut a packing along a surface. A face-centred cubic lattice that stands askew, its grains
 * 2 R (1 + LOOSE) apart and each moved by R LOOSE in a random direction: none overlap, solid
 * fraction 0.64.
 */
static void fill(clod_state *state, double (*surface)(double x, double y, double slope),
                 double slope)
{
    static const double TURN[4] = {0.8, 0.36, -0.28, 0.3898717737923585}; // unit
    const double edge = sqrt(2.0) * R * (1.0 + LOOSE);                    // half a cube's
    double axes[3][3];
    dice chance = {5};
    rotation(TURN, axes);
    const int reach = 52; // of the box's farthest corner
    for (int i = -reach; i <= reach; i++) {
        for (int j = -reach; j <= reach; j++) {
            for (int k = -reach + (i + j + reach) % 2; k <= reach; k += 2) {
                double way[3], p[3];
                dice_direction(&chance, way);
                for (int a = 0; a < 3; a++) {
                    p[a] = edge * (axes[a][0] * i + axes[a][1] * j + axes[a][2] * k) +
                           LOOSE * R * way[a];
                }
                if (fabs(p[0]) < WIDE && fabs(p[1]) < WIDE && p[2] > R &&
                    p[2] + R < surface(p[0], p[1], slope)) {
                    add(state, p[0], p[1], p[2]);
                }
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
    const clod_survey survey = clod_survey_of(state, NULL);
    assert_true(clod_repose_find(&self, &survey, &found, &status));
    return found;
}

/** Within half a degree, for cells much smaller than a grain too: discs cover them. */
static void cones(void **unused)
{
    (void)unused;
    static const double ANGLE[] = {20.0, 30.0, 38.0},
                        CELL[] = {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0};
    for (int k = 0; k < 3; k++) {
        clod_state state = {.dt = 1e-3};
        fill(&state, cone, tan(ANGLE[k] / DEGREE));
        double center[2];
        if (k == 2) { // which lies within the box
            const clod_survey survey = clod_survey_of(&state, NULL);
            assert_true(clod_repose_center(&BOX, &survey, center, &status));
            check_close(center[0], 0.012, 5e-4);
            check_close(center[1], -0.007, 5e-4);
        }
        for (size_t c = 0; c < sizeof CELL / sizeof *CELL; c++) {
            const clod_repose_angle found =
                find(&state, (clod_repose){.cell = CELL[c] * R, .center = {0.012, -0.007}});
            check_close(found.angle * DEGREE, ANGLE[k], 0.5);
            check_close(found.height, 0.05, 2.0 * R);
            check_at_most(found.error * DEGREE, 0.4);
            assert_true(found.strips > 2);
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
    for (int c = 1; c <= 4; c *= 2) {
        clod_repose self = {.cell = c * R, .slope = true, .direction = {1.0, 0.0}};
        check_close(find(&state, self).angle * DEGREE, 25.0, 0.3);
        self.direction[0] = -1.0;
        check_close(find(&state, self).angle * DEGREE, -25.0, 0.3);
        self.direction[0] = 0.0;
        self.direction[1] = 1.0;
        self.to = 1.0; // all strips are as high
        check_close(find(&state, self).angle * DEGREE, 0.0, 0.3);
    }
    clod_state_fini(&state);
}

static void no_heap_no_angle(void **unused)
{
    (void)unused;
    clod_state state = {.dt = 1e-3};
    double center[2];
    const clod_repose round = {.cell = 2.2 * R}; // middles beside the disc
    assert_true(isnan(find(&state, round).angle) && isnan(find(&state, round).height));
    const clod_survey survey = clod_survey_of(&state, NULL);
    assert_true(clod_repose_center(&BOX, &survey, center, &status));
    assert_true(center[0] == 0.0 && center[1] == 0.0);
    for (int k = 0; k < 20; k++) { // a pillar: no ring between the heights
        add(&state, 0.0, 0.0, R + k * 2.0 * R);
    }
    check_close(find(&state, round).height, 0.08 / 3.0, 1e-9); // in one of three cells
    assert_true(isnan(find(&state, round).angle));
    assert_int_equal(find(&state, round).strips, 0);
    clod_state_fini(&state);
}

/** The sphere's height over the middles of cells, in rings and in strips. */
static void a_disc_covers_cells(void **unused)
{
    (void)unused;
    clod_state state = {.dt = 1e-3};
    add(&state, 0.0, 0.0, 0.05);
    clod_repose self = {.cell =
                            R}; // middles R/2 off the axis, those of the next ring beside it
    check_close(find(&state, self).height, 0.05 + R * (1.0 + sqrt(3.0)) / 3.0, 1e-12);
    self = (clod_repose){.cell = 4.0 * R, .slope = true, .direction = {1.0, 0.0}};
    // 24 cells of 4 R in 24 strips: the centre is in a corner, and no middle under the disc
    check_close(find(&state, self).height, (0.05 + R) / 24.0, 1e-12);
    self.cell = 0.8 * R; // 120 strips: +-0.4 R twice in the first two, +-1.2 R is beside it
    const double over = 0.05 + R * sqrt(1.0 - 2.0 * 0.16);
    check_close(find(&state, self).height, (0.05 + R + over) / 120.0, 1e-12);
    clod_state_fini(&state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cones),
        cmocka_unit_test(slopes),
        cmocka_unit_test(no_heap_no_angle),
        cmocka_unit_test(a_disc_covers_cells),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
