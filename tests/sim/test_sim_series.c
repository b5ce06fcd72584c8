/** The series in the hands of a program: inlets, a gauge and a belt against what must be. */

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "output/temp_folder.h"
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

/** The same belt, which swings: it has no one speed. */
static const char SHAKEN[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.2, friction: 0.5}}\n"
    "time: {step: 1e-4 s, design_stress: 100 Pa}\n"
    "domain: {min: [-0.1 m, -0.3 m, -0.1 m], max: [1.2 m, 0.3 m, 0.2 m], open: delete}\n"
    "walls: {feed: {material: ore, oscillation: {amplitude: 1 mm, frequency: 5 Hz}, shapes: [\n"
    "  {belt: {from: [0 m, 0 m, 0 m], runs: [{length: 1 m}], width: 400 mm, speed: 1 m/s}}]}}\n"
    "gauges: {all: {region: {box: {min: [0 m, -0.3 m, -0.1 m], max: [1 m, 0.3 m, 0.2 m]}},\n"
    "  direction: [1, 0, 0], belt: feed}}\n"
    "stages: [{name: run, duration: 1 s}]\n";

/** Grains that come to rest on a floor; a roof above, which stands before it in the case. */
static const char PILE[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.2, friction: 0.5, "
    "rolling: epsd2, rolling_friction: 0.3}}\n"
    "time: {step: 1e-4 s, design_stress: 100 Pa}\n"
    "domain: {min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.2 m]}\n"
    "grains:\n"
    "  - {material: ore, count: 20, radius: {distribution: uniform, min: 5 mm, max: 5 mm},\n"
    "     region: {box: {min: [-60 mm, -60 mm, 5 mm], max: [60 mm, 60 mm, 30 mm]}}}\n"
    "walls:\n"
    "  roof: {material: ore, shapes: [{plane: {point: [0 m, 0 m, 0.2 m], normal: [0, 0, -1]}}]}\n"
    "  floor: {material: ore, shapes: [{plane: {point: [0 m, 0 m, 0 m]}}]}\n"
    "build_up: {speed: 10 mm/s}\n"
    "output: {surfaces: true}\n"
    "stages: [{name: run, duration: 1 s}]\n";

/** Grains in two layers above a plate at which they leave. */
static const char PLATE[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.2, friction: 0.5}}\n"
    "time: {step: 1e-4 s, design_stress: 100 Pa}\n"
    "domain: {min: [-0.1 m, -0.1 m, -0.1 m], max: [0.1 m, 0.1 m, 0.3 m]}\n"
    "grains:\n"
    "  - {material: ore, count: 12, radius: {distribution: uniform, min: 5 mm, max: 5 mm},\n"
    "     region: {box: {min: [-60 mm, -60 mm, 10 mm], max: [60 mm, 60 mm, 30 mm]}}}\n"
    "  - {material: ore, count: 7, radius: {distribution: uniform, min: 5 mm, max: 5 mm},\n"
    "     region: {box: {min: [-60 mm, -60 mm, 200 mm], max: [60 mm, 60 mm, 220 mm]}}}\n"
    "walls:\n"
    "  plate: {material: ore, shapes: [{box: {center: [0 m, 0 m, -5 mm], size: [0.2 m, 0.2 m, "
    "10 mm]}}]}\n"
    "  floor: {material: ore, shapes: [{plane: {point: [0 m, 0 m, -50 mm]}}]}\n"
    "outlets: {plate: {wall: plate}}\n"
    "stages: [{name: run, duration: 1 s}]\n";

/** A wall below all grains. */
static const char LOW[] = "{material: ore, shapes: [{plane: {point: [0 m, 0 m, -50 mm]}}]}";

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

/** What a measure needs stays, and says so; a wall of another name may come and go. */
static void walls_that_are_measured_stay(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(BELT, 1);
    CHECK(clod_sim_open_series(sim, &status));
    expect_refused(
        clod_sim_remove_wall(sim, "feed", &status),
        "clod_sim_remove_wall: the series is open, and the column feed.pull needs the "
        "wall 'feed'");
    CHECK(clod_sim_add_wall_from_text(sim, "floor", LOW, &status));
    CHECK(clod_sim_advance(sim, 1, &status));
    CHECK(clod_sim_remove_wall(sim, "floor", &status));
    CHECK(clod_sim_advance(sim, 1, &status));
    assert_int_equal(clod_sim_wall_count(sim), 1);
    clod_sim_destroy(&sim);
    sim = sim_made(SHAKEN, 1); // the gauge's belt is no belt with a pull: it swings
    CHECK(clod_sim_open_series(sim, &status));
    expect_refused(clod_sim_remove_wall(sim, "feed", &status), "gauges.all.belt needs");
    clod_sim_destroy(&sim);
}

/** A wall that was removed before takes nothing with it: its columns have no values. */
static void a_belt_that_is_gone_has_no_pull(void **unused)
{
    (void)unused;
    const clod_sim_column *columns;
    size_t count;
    clod_sim *sim = sim_made(BELT, 1);
    CHECK(clod_sim_remove_wall(sim, "feed", &status));
    CHECK(clod_sim_open_series(sim, &status));
    expect_refused(clod_sim_add_wall_from_text(sim, "feed", LOW, &status),
                   "clod_sim_add_wall: the series is open, and the column feed.pull needs");
    CHECK(clod_sim_advance(sim, 200, &status));
    CHECK(clod_sim_series_row(sim, &columns, &count, &status));
    assert_true(isnan(value_of(columns, count, "feed.pull", "N")));
    assert_true(isnan(value_of(columns, count, "gauge_all.belt_power", "W")));
    assert_true(value_of(columns, count, "gauge_all.mass", "kg") > 0.0);
    clod_sim_destroy(&sim);
}

/** The mass of the grains that rest on the floor of PILE [kg]. */
#define PILE_MASS (20.0 * 2500.0 * 4.0 / 3.0 * M_PI * 125e-9)

static void *kept_row(const clod_sim_column *columns, size_t count)
{
    double *row = malloc(count * sizeof *row);
    assert_non_null(row);
    for (size_t k = 0; k < count; k++) {
        row[k] = columns[k].value;
    }
    return row;
}

/**
 * The roof goes, something else comes, the roof comes back. The columns stay; those of the roof have
 * no value while it is away, and all others have the bits of a simulation in which it stayed.
 */
static void columns_stay_when_walls_go(void **unused)
{
    (void)unused;
    const clod_sim_column *columns;
    size_t count, before;
    clod_sim *sim = sim_made(PILE, 1), *calm = sim_made(PILE, 2);
    CHECK(clod_sim_open_series(sim, &status));
    CHECK(clod_sim_open_series(calm, &status));
    for (int k = 0; k < 4; k++) {
        CHECK(clod_sim_advance(calm, 1500, &status));
        CHECK(clod_sim_series_row(calm, &columns, &before, &status));
        double *row = kept_row(columns, before);
        if (k == 1) {
            CHECK(clod_sim_remove_wall(sim, "roof", &status));
            CHECK(clod_sim_add_wall_from_text(sim, "attic", LOW, &status));
        } else if (k == 3) {
            CHECK(clod_sim_remove_wall(sim, "attic", &status));
            CHECK(clod_sim_add_wall_from_text(sim, "roof", LOW, &status));
        }
        CHECK(clod_sim_advance(sim, 1500, &status));
        CHECK(clod_sim_series_row(sim, &columns, &count, &status));
        assert_int_equal(count, before);
        int missing = 0;
        for (size_t c = 0; c < count; c++) {
            const bool roof = strncmp(columns[c].name, "roof.", 5) == 0 ||
                              strncmp(columns[c].name, "surface_roof.", 13) == 0;
            assert_null(strstr(columns[c].name, "attic"));
            missing += roof && isnan(columns[c].value);
            assert_true(roof || memcmp(&columns[c].value, &row[c], sizeof *row) == 0);
        }
        free(row);
        assert_true(k == 0 || missing > 0 || k == 3);
        assert_true(isnan(value_of(columns, count, "roof.force_z", "N")) == (k == 1 || k == 2));
        assert_true(isnan(value_of(columns, count, "roof.resting_mass", "kg")) ==
                    (k == 1 || k == 2));
        assert_true(isnan(value_of(columns, count, "surface_roof.force_z", "N")) == (k > 0));
    }
    check_relative(value_of(columns, count, "floor.resting_mass", "kg"), PILE_MASS, 1e-12);
    check_close(value_of(columns, count, "roof.resting_mass", "kg"), 0.0, 0.0);
    clod_sim_destroy(&sim);
    clod_sim_destroy(&calm);
}

/** A wall whose column has the name of another wall's surface puts nothing there. */
static void a_name_of_another_measure_is_no_match(void **unused)
{
    (void)unused;
    const clod_sim_column *columns;
    size_t count;
    clod_sim *sim = sim_made(PILE, 1);
    CHECK(clod_sim_open_series(sim, &status));
    CHECK(clod_sim_advance(sim, 1500, &status));
    CHECK(clod_sim_series_row(sim, &columns, &count, &status));
    assert_true(value_of(columns, count, "surface_floor.force_z", "N") < -0.1);
    CHECK(clod_sim_remove_wall(sim, "floor", &status));
    CHECK(clod_sim_add_wall_from_text(
        sim, "surface_floor", "{material: ore, shapes: [{plane: {point: [0 m, 0 m, 0 m]}}]}",
        &status));
    CHECK(clod_sim_advance(sim, 1500, &status));
    CHECK(clod_sim_series_row(sim, &columns, &count, &status));
    clod_sim_wall wall;
    CHECK(clod_sim_wall_look(sim, clod_sim_wall_index(sim, "surface_floor"), &wall, &status));
    assert_true(wall.force[2] < -0.1); // it carries the grains
    assert_true(isnan(value_of(columns, count, "surface_floor.force_z", "N")));
    assert_true(isnan(value_of(columns, count, "floor.force_z", "N")));
    clod_sim_destroy(&sim);
}

/** The lower grains reach the plate within sqrt(2 h/g) = 71 ms of a fall of 25 mm, the upper ones not
 *  before 195 mm and 199 ms. An outlet whose wall is gone keeps what it counted, and a wall that comes,
 *  of whatever name, is no outlet. */
static void an_outlet_keeps_its_counts(void **unused)
{
    (void)unused;
    static const char BOX[] =
        "{material: ore, shapes: [{box: {center: [0 m, 0 m, -5 mm], size: "
        "[0.2 m, 0.2 m, 10 mm]}}]}";
    const char *const names[] = {"plate", "other"};
    const double grain = 2500.0 * 4.0 / 3.0 * M_PI * 125e-9;
    for (int k = 0; k < 2; k++) {
        const clod_sim_column *columns;
        size_t count;
        clod_sim *sim = sim_made(PLATE, 1);
        CHECK(clod_sim_open_series(sim, &status));
        CHECK(clod_sim_advance(sim, 1500, &status));
        CHECK(clod_sim_series_row(sim, &columns, &count, &status));
        check_close(value_of(columns, count, "outlet_plate.grains", "1"), 12.0, 0.0);
        CHECK(clod_sim_remove_wall(sim, "plate", &status));
        CHECK(clod_sim_advance(sim, 100, &status));
        CHECK(clod_sim_add_wall_from_text(sim, names[k], BOX, &status));
        CHECK(clod_sim_advance(sim, 1400, &status));
        clod_sim_wall wall;
        CHECK(clod_sim_wall_look(sim, clod_sim_wall_index(sim, names[k]), &wall, &status));
        assert_true(wall.mean_force[2] < 0.0); // they met it
        CHECK(clod_sim_series_row(sim, &columns, &count, &status));
        check_close(value_of(columns, count, "outlet_plate.grains", "1"), 12.0, 0.0);
        check_relative(value_of(columns, count, "outlet_plate.mass", "kg"), 12.0 * grain,
                       1e-12);
        assert_int_equal(clod_sim_grain_count(sim), 7);
        clod_sim_destroy(&sim);
    }
}

/** A checkpoint of a simulation with other walls: its columns are those that this one opened with. */
static void rows_go_on_through_checkpoints(void **temporary)
{
    const char *folder = *temporary;
    const clod_sim_column *columns;
    size_t count, again;
    clod_sim *sim = sim_made(PILE, 1), *other = sim_made(PILE, 2);
    CHECK(clod_sim_open_series(sim, &status));
    CHECK(clod_sim_remove_wall(sim, "roof", &status));
    CHECK(clod_sim_add_wall_from_text(sim, "attic", LOW, &status));
    CHECK(clod_sim_add_wall_from_text(sim, "cellar", LOW, &status));
    CHECK(clod_sim_advance(sim, 1500, &status));
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    CHECK(clod_sim_open_series(other, &status));
    CHECK(clod_sim_series_row(other, &columns, &count, &status));
    CHECK(clod_sim_read_checkpoint(other, folder, NULL, &status));
    assert_int_equal(clod_sim_wall_count(other), 3);
    CHECK(clod_sim_advance(sim, 777, &status));
    CHECK(clod_sim_advance(other, 777, &status));
    CHECK(clod_sim_series_row(sim, &columns, &count, &status));
    double *row = kept_row(columns, count);
    CHECK(clod_sim_series_row(other, &columns, &again, &status));
    assert_int_equal(again, count);
    for (size_t c = 0; c < count; c++) {
        assert_true(memcmp(&columns[c].value, &row[c], sizeof *row) == 0 ||
                    (isnan(columns[c].value) && isnan(row[c])));
    }
    assert_true(isnan(value_of(columns, count, "roof.angle", "rad")));
    free(row);
    clod_sim_destroy(&sim);
    clod_sim_destroy(&other);
}

/** Parts of a mesh that build-up follows hang on it; other walls of the same case may go. */
static void build_up_needs_its_meshes(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(
        "materials: {ore: {density: 2500 kg/m3}}\n"
        "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.2, friction: 0.5}}\n"
        "time: {step: 1e-4 s, design_stress: 100 Pa}\n"
        "domain: {min: [-0.1 m, -0.3 m, -0.1 m], max: [1.2 m, 0.3 m, 0.2 m]}\n"
        "build_up: {}\n"
        "walls:\n"
        "  feed: {material: ore, velocity: [0 m/s, 0 m/s, 0.001 m/s], shapes: [\n"
        "    {belt: {from: [0 m, 0 m, 0 m], runs: [{length: 1 m}], width: 40 cm, speed: 1 m/s}}]}\n"
        "  roof: {material: ore, shapes: [{plane: {point: [0 m, 0 m, 0.2 m], normal: [0, 0, "
        "-1]}}]}\n"
        "stages: [{name: run, duration: 1 s}]\n",
        1);
    CHECK(clod_sim_open_series(sim, &status));
    expect_refused(clod_sim_remove_wall(sim, "feed", &status), "build_up, of the parts of");
    CHECK(clod_sim_remove_wall(sim, "roof", &status));
    CHECK(clod_sim_advance(sim, 1, &status));
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_inlet_and_a_gauge),
        cmocka_unit_test(means_of_walls_do_not_disturb),
        cmocka_unit_test(walls_that_are_measured_stay),
        cmocka_unit_test(a_belt_that_is_gone_has_no_pull),
        cmocka_unit_test(columns_stay_when_walls_go),
        cmocka_unit_test(an_outlet_keeps_its_counts),
        cmocka_unit_test(a_name_of_another_measure_is_no_match),
        cmocka_unit_test_setup_teardown(rows_go_on_through_checkpoints, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test(build_up_needs_its_meshes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
