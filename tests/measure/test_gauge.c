// Gauges on states made by hand: every expected number is computed by hand.

#include "measure/gauge.h"

#include <string.h>

#include "measure/gauge_pass.h"
#include "support/check.h"
#include "support/dice.h"

static clod_status status;
static const double GRAVITY[3] = {0.0, 0.0, -10.0};
static const double NONE[3] = {0.0, 0.0, 0.0};

/** A box of 2 x 4 x 2 m about (1, 0, 1). */
static const clod_outlet BOX = {.low = {0.0, -2.0, 0.0}, .high = {2.0, 2.0, 2.0}};

static void add(clod_state *state, double x, double y, double z, double r, double m,
                const double v[3])
{
    const size_t g = state->grains.count;
    const double position[4] = {x, y, z, r};
    assert_true(clod_grains_add(&state->grains, position, v, NONE, 1.0, 0, g + 1, &status));
    state->grains.velocity[g][3] = m; // masses as round as the rest
}

/** Two grains in the box and one beside it. */
static void make_two(clod_state *state)
{
    *state = (clod_state){.gravity = {0.0, 0.0, -10.0}, .dt = 1e-3};
    add(state, 0.5, -1.0, 0.5, 0.1, 1.0, (const double[]){3.0, 0.0, 4.0});
    add(state, 1.5, 1.0, 1.5, 0.2, 3.0, (const double[]){1.0, 0.0, 0.0});
    add(state, 2.5, 0.0, 1.0, 0.5, 6.0, (const double[]){9.0, 9.0, 9.0});
    state->grains.load[0][0] = 2.0;             // N; 2 x 3 = 6 W
    state->grains.load[1][5] = 7.0;             // N m
    state->grains.angular_velocity[1][1] = 2.0; // 14 W
    state->grains.angular_velocity[1][3] = 0.5; // 1/I: 0.5 x 2 x 4 = 4 J
}

static void sample(const clod_gauge *gauge, const clod_state *state, double *sums)
{
    const clod_gauge_part part = {.gauge = *gauge, .sums = sums};
    const clod_survey survey = clod_survey_of(state, NULL);
    assert_true(clod_gauge_pass(&part, 1, &survey, &status));
}

static void two_grains_are_summed(void **unused)
{
    (void)unused;
    clod_state state;
    double sums[CLOD_GAUGE_SUMS], v[CLOD_GAUGE_VALUES];
    make_two(&state);
    const clod_gauge gauge =
        clod_gauge_of(&BOX, (const double[]){5.0, 0.0, 0.0}, NONE, GRAVITY);
    sample(&gauge, &state, sums);
    clod_gauge_values(&gauge, sums, v);
    check_close(v[CLOD_GAUGE_OF_GRAINS], 2.0, 0.0);
    check_close(v[CLOD_GAUGE_OF_MASS], 4.0, 0.0);
    check_close(v[CLOD_GAUGE_OF_FLOW], (3.0 + 3.0) / 2.0, 1e-15); // over 2 m
    check_close(v[CLOD_GAUGE_OF_VELOCITY], 6.0 / 4.0, 1e-15);
    check_close(v[CLOD_GAUGE_OF_VELOCITY + 1], 0.0, 0.0);
    check_close(v[CLOD_GAUGE_OF_VELOCITY + 2], 1.0, 1e-15);
    check_close(v[CLOD_GAUGE_OF_SPEED], (5.0 + 3.0) / 4.0, 1e-15);
    check_close(v[CLOD_GAUGE_OF_ANGLE], 33.690067525979785, 1e-12); // atan(1/1.5)
    // from the mean (1.5, 0, 1): (1.5, 0, 3) and (-0.5, 0, -1)
    check_close(v[CLOD_GAUGE_OF_FLUCTUATION], sqrt((11.25 + 3.0 * 1.25) / 4.0), 1e-14);
    check_close(v[CLOD_GAUGE_OF_CENTER], (0.5 + 4.5) / 4.0, 1e-15);
    check_close(v[CLOD_GAUGE_OF_CENTER + 1], 0.5, 1e-15);
    check_close(v[CLOD_GAUGE_OF_CENTER + 2], 1.25, 1e-15);
    check_close(v[CLOD_GAUGE_OF_OFFSET], 0.5, 1e-15); // to the left of +x: +y
    check_close(v[CLOD_GAUGE_OF_WIDTH], sqrt((2.25 + 3.0 * 0.25) / 4.0), 1e-15);
    check_close(v[CLOD_GAUGE_OF_SORTING], 1.0, 1e-12); // the larger one is to the left
    check_close(v[CLOD_GAUGE_OF_RADIUS], 0.7 / 4.0, 1e-15);
    check_close(v[CLOD_GAUGE_OF_RADIUS_RATIO], 0.175 / 0.37, 1e-15); // all: 3.7 / 10
    check_close(v[CLOD_GAUGE_OF_ENERGY], 12.5 + 1.5 + 4.0, 1e-13);
    check_close(sums[CLOD_GAUGE_LIFTING], 4.0 * 10.0, 1e-13);
    check_close(sums[CLOD_GAUGE_ACCELERATION], 6.0 + 14.0, 1e-13);
    clod_state_fini(&state);
}

/** Means are those of sums: a look at nothing halves what is inside, and not the velocity. */
static void samples_are_added_before_they_are_divided(void **unused)
{
    (void)unused;
    clod_state state, empty = {.gravity = {0.0, 0.0, -10.0}};
    double sums[CLOD_GAUGE_SUMS], more[CLOD_GAUGE_SUMS], v[CLOD_GAUGE_VALUES];
    make_two(&state);
    const clod_gauge gauge =
        clod_gauge_of(&BOX, (const double[]){-1.0, 0.0, 0.5}, NONE, GRAVITY);
    sample(&gauge, &state, sums);
    sample(&gauge, &empty, more);
    clod_gauge_values(&gauge, more, v);
    check_close(v[CLOD_GAUGE_OF_MASS], 0.0, 0.0);
    assert_true(isnan(v[CLOD_GAUGE_OF_VELOCITY]) && isnan(v[CLOD_GAUGE_OF_WIDTH]));
    assert_true(isnan(v[CLOD_GAUGE_OF_ANGLE]) && isnan(v[CLOD_GAUGE_OF_RADIUS]));
    for (int k = 0; k < CLOD_GAUGE_SUMS; k++) {
        sums[k] += more[k];
    }
    sums[CLOD_GAUGE_WORK] = 300.0;
    sums[CLOD_GAUGE_TIME] = 4.0;
    clod_gauge_values(&gauge, sums, v);
    check_close(v[CLOD_GAUGE_OF_MASS], 2.0, 0.0);
    check_close(v[CLOD_GAUGE_OF_VELOCITY], 1.5, 1e-15);
    check_close(v[CLOD_GAUGE_OF_FLOW], -1.5, 1e-15); // against direction, by the faces of x
    check_close(v[CLOD_GAUGE_OF_POWER], 75.0, 1e-13);
    check_close(v[CLOD_GAUGE_OF_LIFTING], 20.0, 1e-13);
    check_close(v[CLOD_GAUGE_OF_ACCELERATION], 10.0, 1e-13);
    check_close(v[CLOD_GAUGE_OF_HEAT], 45.0, 1e-13);
    clod_state_fini(&state);
}

/** Grains of one size have no sorting, whatever rounding says. */
static void one_size_has_no_sorting(void **unused)
{
    (void)unused;
    clod_state state = {0};
    double sums[CLOD_GAUGE_SUMS], v[CLOD_GAUGE_VALUES];
    for (int k = 0; k < 7; k++) {
        add(&state, 0.1 + 0.2 * k, -0.3 * k, 0.7, 0.003175, 0.1 + 0.01 * k, NONE);
    }
    const clod_gauge gauge =
        clod_gauge_of(&BOX, (const double[]){1.0, 0.0, 0.0}, NONE, GRAVITY);
    sample(&gauge, &state, sums);
    clod_gauge_values(&gauge, sums, v);
    assert_true(isnan(v[CLOD_GAUGE_OF_SORTING]));
    check_relative(v[CLOD_GAUGE_OF_RADIUS], 0.003175, 1e-15);
    clod_state_fini(&state);
}

/** Directions that follow from others, and extents along them. */
static void directions_follow(void **unused)
{
    (void)unused;
    const clod_outlet round = {.low = {-1.0, -1.0, 0.0}, .high = {1.0, 1.0, 3.0}, .outer = 1.0};
    double low, high;
    clod_gauge self = clod_gauge_of(&round, (const double[]){0.0, 0.0, -2.0}, NONE, GRAVITY);
    check_close(clod_vec3_length(self.across), 0.0, 0.0); // an upright stream: none
    assert_int_equal(self.flow_axis, 2);
    check_close(self.flow_length, -3.0, 0.0);
    clod_gauge_extent(&self, (clod_vec3){0.6, 0.8, 0.0}, &low, &high);
    check_close(low, -1.0, 1e-15); // a circle from all sides
    check_close(high, 1.0, 1e-15);
    // along a slope of 3 in 4: across to the left, up away from it
    self = clod_gauge_of(&BOX, (const double[]){0.0, 4.0, 3.0}, NONE, GRAVITY);
    check_close(self.across.x, -1.0, 1e-15);
    check_close(self.up.y, -0.6, 1e-15);
    check_close(self.up.z, 0.8, 1e-15);
    clod_gauge_extent(&self, self.direction, &low, &high);
    check_close(low, 0.6 - (0.8 * 2.0 + 0.6 * 1.0), 1e-15);
    check_close(high, 0.6 + (0.8 * 2.0 + 0.6 * 1.0), 1e-15);
}

/** A sphere of 1 m over bins of 1 m: caps by their formulas. */
static void a_sphere_is_cut_by_bins(void **unused)
{
    (void)unused;
    clod_state state = {0};
    add(&state, 1.0, 0.0, 1.0, 1.0, 8.0, NONE);
    add(&state, 1.0, 1.75, 0.5, 0.5, 1.0, NONE);   // reaches beyond the end by half
    add(&state, 1.0, -1.6, 0.3, 0.2, 1.0, NONE);   // its middle is 0.1 m from the border
    add(&state, 1.0, -1.7, 0.05, 0.05, 1.0, NONE); // below it
    const clod_gauge gauge =
        clod_gauge_of(&BOX, (const double[]){1.0, 0.0, 0.0}, NONE, GRAVITY);
    const clod_gauge_axis axis = clod_gauge_axis_of(&gauge, gauge.across, 8); // of 0.5 m
    clod_gauge_bins bins = {0};
    double sums[CLOD_GAUGE_SUMS];
    const clod_gauge_part part = {
        .gauge = gauge, .sums = sums, .profile = &bins, .across = axis};
    const clod_survey survey = clod_survey_of(&state, NULL);
    assert_true(clod_gauge_pass(&part, 1, &survey, &status));
    clod_gauge_bin bin = clod_gauge_bins_of(&bins, &axis, 0); // -2 to -1.5
    check_close(bin.lower, 0.0, 1e-15);
    check_close(bin.upper, 0.5, 1e-15);
    check_close(bin.mass, 1.0 + 27.0 / 32.0, 1e-14);
    check_close(bin.mean, (0.05 + 0.3 * 27.0 / 32.0) / (59.0 / 32.0), 1e-14);
    bin = clod_gauge_bins_of(&bins, &axis, 1); // -1.5 to -1
    check_close(bin.upper, 0.3 + sqrt(0.03), 1e-14);
    check_close(bin.mass, 5.0 / 32.0, 1e-14);
    bin = clod_gauge_bins_of(&(clod_gauge_bins){.samples = 1.0}, &axis, 1); // nothing
    assert_true(isnan(bin.upper) && isnan(bin.mean));
    check_close(bin.mass, 0.0, 0.0);
    bin = clod_gauge_bins_of(&bins, &axis, 2); // -1 to -0.5
    check_close(bin.at, -0.75, 1e-15);
    check_close(bin.upper, 1.0 + sqrt(0.75), 1e-15);
    check_close(bin.lower, 1.0 - sqrt(0.75), 1e-15);
    check_close(bin.mass, 8.0 * 5.0 / 32.0, 1e-15); // cap h^2 (3r - h)/4 with h = 0.5
    check_close(bin.mean, 1.0, 1e-15);
    bin = clod_gauge_bins_of(&bins, &axis, 3); // -0.5 to 0
    check_close(bin.upper, 2.0, 1e-15);
    check_close(bin.mass, 8.0 * (0.5 - 5.0 / 32.0), 1e-15);
    bin = clod_gauge_bins_of(&bins, &axis, 7); // 1.5 to 2, and what is beyond; 1.25 is the edge
    check_close(bin.mass, 1.0 * 27.0 / 32.0, 1e-15); // all but a cap of half a radius
    check_close(bin.upper, 1.0, 1e-15);
    bins.samples += 1.0; // one in which there was nothing
    bin = clod_gauge_bins_of(&bins, &axis, 2);
    check_close(bin.share, 0.5, 0.0);
    check_close(bin.mass, 4.0 * 5.0 / 32.0, 1e-15);
    clod_state_fini(&state);
}

#define MANY 300
#define BOXES 5

/** Boxes that overlap, with bins: in one pass each has the bits that it has alone, whatever the
 *  order of the grains. */
static void gauges_in_one_pass_are_each_alone(void **unused)
{
    (void)unused;
    clod_state state = {.gravity = {0.0, 0.0, -10.0}}, turned = {.gravity = {0.0, 0.0, -10.0}};
    dice d = {7};
    double numbers[MANY][8];
    for (int g = 0; g < MANY; g++) {
        for (int k = 0; k < 8; k++) {
            numbers[g][k] = dice_real(&d, -1.0, 1.0);
        }
    }
    for (int g = 0; g < MANY; g++) {
        const double *p = numbers[g], *q = numbers[MANY - 1 - g];
        add(&state, p[0], p[1], p[2], 0.1 + 0.05 * p[3], 2.0 + p[4], p + 5);
        add(&turned, q[0], q[1], q[2], 0.1 + 0.05 * q[3], 2.0 + q[4], q + 5);
    }
    double together[BOXES][CLOD_GAUGE_SUMS], alone[CLOD_GAUGE_SUMS];
    static clod_gauge_bins bins[BOXES], one;
    clod_gauge_part parts[BOXES];
    for (int k = 0; k < BOXES; k++) {
        const clod_outlet box = {.low = {-1.0 + 0.3 * k, -1.0, -0.9},
                                 .high = {-0.4 + 0.3 * k, 0.5 + 0.1 * k, 0.9}};
        const clod_gauge gauge =
            clod_gauge_of(&box, (const double[]){1.0, 0.0, 0.0}, NONE, GRAVITY);
        parts[k] = (clod_gauge_part){.gauge = gauge,
                                     .sums = together[k],
                                     .trajectory = &bins[k],
                                     .along = clod_gauge_axis_of(&gauge, gauge.direction, 6)};
    }
    const clod_survey survey = clod_survey_of(&state, NULL);
    const clod_survey other = clod_survey_of(&turned, NULL);
    assert_true(clod_gauge_pass(parts, BOXES, &survey, &status));
    for (int k = 0; k < BOXES; k++) {
        clod_gauge_part part = parts[k];
        memset(&one, 0, sizeof one);
        part.sums = alone;
        part.trajectory = &one;
        assert_true(clod_gauge_pass(&part, 1, &other, &status));
        assert_memory_equal(alone, together[k], sizeof alone);
        assert_memory_equal(&one, &bins[k], sizeof one);
        assert_true(alone[CLOD_GAUGE_GRAINS] > 10.0 && alone[CLOD_GAUGE_GRAINS] < 0.5 * MANY);
    }
    clod_state_fini(&state);
    clod_state_fini(&turned);
}

/** Bins below a parabola of ISO 5048 and one more bin, rarely seen: its angle and area. */
static void a_parabola_has_its_surcharge_angle(void **unused)
{
    (void)unused;
    const clod_gauge_axis axis = {.low = -1.0, .width = 0.1, .count = 20};
    const double b = 1.2, slope = tan(20.0 * M_PI / 180.0);
    clod_gauge_bins bins = {.samples = 4.0};
    double area = 0.0;
    for (int k = 4; k < 16; k++) { // 12 bins: from -0.6 to 0.6
        const double u = 2.0 * (axis.low + (k + 0.5) * axis.width) / b;
        const double top = 0.3 + 0.05 * u + 0.25 * b * slope * (1.0 - u * u);
        bins.seen[k] = 4.0;
        bins.upper[k] = 4.0 * top;
        bins.lower[k] = 4.0 * 0.1;
        area += 0.1 * (top - 0.1);
    }
    bins.seen[17] = 1.0;
    bins.upper[17] = 9.0;
    bins.lower[17] = 1.0;
    const clod_gauge_section section = clod_gauge_bins_section(&bins, &axis);
    check_close(section.surcharge, 20.0 * M_PI / 180.0, 1e-12);
    check_close(section.width, b, 1e-14);
    check_close(section.area, area + 0.1 * 8.0 / 4.0, 1e-14);
    // by hand: 0.2 b and b^2 tan/6, and the 12 bins' midpoint rule has (1/12)^2 / 2 too much
    const double cap = b * b * slope / 6.0;
    check_close(area, 0.2 * b + cap * (1.0 + 0.5 / 144.0), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_grains_are_summed),
        cmocka_unit_test(samples_are_added_before_they_are_divided),
        cmocka_unit_test(one_size_has_no_sorting),
        cmocka_unit_test(directions_follow),
        cmocka_unit_test(gauges_in_one_pass_are_each_alone),
        cmocka_unit_test(a_sphere_is_cut_by_bins),
        cmocka_unit_test(a_parabola_has_its_surcharge_angle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
