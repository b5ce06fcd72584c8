// Numbers of a free run by their paths: the unit that the name has, and what a summary gives.
#include "calibrate/number.h"
#include "support/check.h"

#define DEGREE 0.017453292519943295 // pi/180

static clod_case_repose reposes[] = {{.name = "heap"}};
static clod_case_gauge gauges[] = {{.name = "exit", .direction = {1.0, 0.0, 0.0}},
                                   {.name = "at_60_deg"}};
static const clod_case HEAP = {.reposes = reposes,
                               .repose_count = 1,
                               .gauges = gauges,
                               .gauge_count = 2,
                               .build_up = {.present = true}};

/** The unit in which a number is given and shown. */
static const char *unit_of(const char *path)
{
    const clod_number *number = clod_number_find(&HEAP, path);
    assert_non_null(number);
    assert_true(clod_number_is_path(number));
    return number->measure.unit;
}

static void the_end_of_the_name_is_the_unit(void **state)
{
    (void)state;
    assert_string_equal(unit_of("repose.heap.angle_deg"), "deg");
    assert_string_equal(unit_of("repose.heap.height_m"), "m");
    assert_string_equal(unit_of("repose.heap.strips"), "");
    assert_string_equal(unit_of("time_s"), "s");
    assert_string_equal(unit_of("walls.0.force_N.2"), "N");
    assert_string_equal(unit_of("walls.0.torque_Nm.2"), "");
    assert_string_equal(unit_of("gauges.exit.mass_kg.mean"), "kg");
    assert_string_equal(unit_of("gauges.exit.mass_flow_kg_per_s.mean"), "kg/s");
    assert_string_equal(unit_of("gauges.exit.speed_m_per_s.deviation"), "m/s");
    assert_string_equal(unit_of("gauges.at_60_deg.samples"), ""); // the user's name has none
    // what is below its name is not known before a run
    assert_string_equal(unit_of("build_up.exit.impacts_per_s"), "");
    assert_string_equal(unit_of("build_up.side.load_N_per_m"), ""); // no length
    assert_string_equal(unit_of("build_up.lid.torque_N_m"), "");
}

static void a_section_that_the_case_lacks_is_none(void **state)
{
    (void)state;
    assert_null(clod_number_find(&HEAP, "mixing.drum.lacey"));
    assert_null(clod_number_find(&HEAP, "repos.heap.angle_deg"));
    assert_null(clod_number_find(&HEAP, "repose.pile.angle_deg"));
    assert_null(clod_number_find(&HEAP, "repose.heap.angle"));
    assert_null(clod_number_find(&HEAP, "repose.heap.angle_deg.mean"));
    assert_null(clod_number_find(&HEAP, "repose.heap"));
    assert_null(clod_number_find(&HEAP, "build_up"));
    assert_null(clod_number_find(&HEAP, "walls..angle_rad"));
    assert_null(clod_number_find(&HEAP, "walls.1a.angle_rad"));
    assert_null(clod_number_find(&HEAP, "reposes.heap.angle_deg"));
    const clod_case none = {0};
    assert_null(clod_number_find(&none, "repose.heap.angle_deg"));
    assert_non_null(clod_number_find(&none, "kinetic_energy_J"));
}

static double read_of(const char *text, const char *path)
{
    json_error_t error;
    json_t *summary = json_loads(text, 0, &error);
    assert_non_null(summary);
    clod_plan_target target = {0};
    snprintf(target.number, sizeof target.number, "%s", path);
    clod_status status = {CLOD_OK, ""};
    double value = 0.0;
    assert_true(clod_number_path_read(summary, clod_number_find(&HEAP, path), &target, "out",
                                      &value, &status));
    json_decref(summary);
    return value;
}

static void values_are_si(void **state)
{
    (void)state;
    check_close(
        read_of("{\"repose\": {\"heap\": {\"angle_deg\": 30}}}", "repose.heap.angle_deg"),
        30.0 * DEGREE, 1e-15);
    check_close(read_of("{\"walls\": [{\"force_N\": [1, 2, 3]}]}", "walls.0.force_N.2"), 3.0,
                0.0);
    assert_true(isnan(
        read_of("{\"repose\": {\"heap\": {\"angle_deg\": null}}}", "repose.heap.angle_deg")));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_end_of_the_name_is_the_unit),
        cmocka_unit_test(a_section_that_the_case_lacks_is_none),
        cmocka_unit_test(values_are_si),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
