/** The series in the hands of a program: inlets, a gauge and a belt against what must be. */

#include <string.h>

#include "support/sim_made.h"

/** A stream of 1 kg/s that falls through a gauge and out of the domain. */
static const char FALL[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.5}}\n"
    "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
    "time: {step: 1e-4 s, design_stress: 100 Pa}\n"
    "domain: {min: [-0.1 m, -0.1 m, -0.3 m], max: [0.1 m, 0.1 m, 0.1 m], open: delete}\n"
    "grains:\n"
    "  - material: ore\n"
    "    radius: {distribution: uniform, min: 4.5 mm, max: 5.5 mm}\n"
    "    inlet: {mass_flow: 1 kg/s}\n"
    "    region: {box: {min: [-80 mm, -80 mm, -20 mm], max: [80 mm, 80 mm, 20 mm]}}\n"
    "    velocity: [0 m/s, 0 m/s, -1 m/s]\n"
    "gauges:\n"
    "  fall: {region: {box: {min: [-0.1 m, -0.1 m, -0.2 m], max: [0.1 m, 0.1 m, -0.1 m]}},\n"
    "         direction: [0, 0, -1]}\n"
    "stages: [{name: run, duration: 1 s}]\n";

/** Grains on a belt that a gauge names. */
static const char BELT[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.2, friction: 0.5}}\n"
    "time: {step: 1e-4 s, design_stress: 100 Pa}\n"
    "domain: {min: [-0.1 m, -0.3 m, -0.1 m], max: [1.2 m, 0.3 m, 0.2 m], open: delete}\n"
    "grains:\n"
    "  - {material: ore, count: 40, radius: {distribution: uniform, min: 4.9 mm, max: 5.1 mm},\n"
    "     region: {box: {min: [10 mm, -150 mm, 5 mm], max: [60 mm, 150 mm, 30 mm]}}}\n"
    "walls: {feed: {material: ore, shapes: [\n"
    "  {belt: {from: [0 m, 0 m, 0 m], runs: [{length: 1 m}], width: 400 mm, speed: 1 m/s}}]}}\n"
    "gauges: {all: {region: {box: {min: [0 m, -0.3 m, -0.1 m], max: [1 m, 0.3 m, 0.2 m]}},\n"
    "  direction: [1, 0, 0], belt: feed}}\n"
    "stages: [{name: run, duration: 1 s}]\n";

/** A value of the next row. */
static double value_of(const clod_sim_column *columns, size_t count, const char *name,
                       const char *unit)
{
    for (size_t k = 0; k < count; k++) {
        if (strcmp(columns[k].name, name) == 0) {
            assert_string_equal(columns[k].unit, unit);
            return columns[k].value;
        }
    }
    fail_msg("the series has no %s", name);
    return 0.0;
}

/** What has come is the flow times the time, to half a grain and what is due in 1 ms; the gauge
 *  has it too once the stream fills it: 0.1 kg in 0.1 s, and grains of 1.3 g. */
static void an_inlet_and_a_gauge(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(FALL, 2);
    const clod_sim_column *columns;
    size_t count;
    assert_int_equal(clod_sim_grain_count(sim), 0);
    CHECK(clod_sim_advance(sim, 4000, &status));
    CHECK(clod_sim_series_row(sim, &columns, &count, &status));
    CHECK(clod_sim_advance(sim, 1000, &status));
    CHECK(clod_sim_series_row(sim, &columns, &count, &status));
    const double grain = 2500.0 * 4.0 / 3.0 * M_PI * 5.5e-3 * 5.5e-3 * 5.5e-3;
    const double came = value_of(columns, count, "inlet_1.mass", "kg");
    assert_true(fabs(came - 0.5) < 0.5 * grain + 1e-3);
    const double flow = value_of(columns, count, "gauge_fall.mass_flow", "kg/s");
    assert_true(fabs(flow - 1.0) < 0.1);
    clod_sim_exchange exchange;
    CHECK(clod_sim_exchange_look(sim, &exchange, &status));
    check_close(value_of(columns, count, "inlet_1.grains", "1"), (double)exchange.added, 0.0);
    check_relative(came, exchange.added_mass, 1e-12);
    clod_sim_destroy(&sim);
}

/** Means of walls that begin anew between two rows take no work from belts and gauges. */
static void means_of_walls_do_not_disturb(void **unused)
{
    (void)unused;
    const clod_sim_column *columns;
    double power[2], pull[2];
    for (int k = 0; k < 2; k++) {
        size_t count;
        clod_sim *sim = sim_made(BELT, 1);
        expect_refused(clod_sim_series_row(sim, &columns, &count, &status),
                       "clod_sim_series_row: the series is not open");
        CHECK(clod_sim_open_series(sim, &status));
        CHECK(clod_sim_advance(sim, 777, &status));
        if (k == 1) {
            clod_sim_reset_wall_means(sim);
        }
        CHECK(clod_sim_advance(sim, 223, &status));
        CHECK(clod_sim_series_row(sim, &columns, &count, &status));
        power[k] = value_of(columns, count, "gauge_all.belt_power", "W");
        pull[k] = value_of(columns, count, "feed.pull", "N");
        clod_sim_destroy(&sim);
    }
    assert_true(power[0] > 1e-3 && pull[0] > 1e-3);
    check_relative(power[1], power[0], 1e-12);
    check_relative(pull[1], pull[0], 1e-12);
}

static void walls_stay_while_it_is_open(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(BELT, 1);
    CHECK(clod_sim_open_series(sim, &status));
    expect_refused(clod_sim_remove_wall(sim, "feed", &status), "the series is open");
    expect_refused(clod_sim_add_wall_from_text(
                       sim, "floor",
                       "{material: ore, shapes: [{plane: {point: [0 mm, 0 mm, -9 mm]}}]}",
                       &status),
                   "clod_sim_add_wall: the series is open");
    CHECK(clod_sim_advance(sim, 1, &status));
    assert_int_equal(clod_sim_wall_count(sim), 1);
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_inlet_and_a_gauge),
        cmocka_unit_test(means_of_walls_do_not_disturb),
        cmocka_unit_test(walls_stay_while_it_is_open),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
