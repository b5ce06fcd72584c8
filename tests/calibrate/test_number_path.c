// Numbers of a free run by their paths: the unit that the name has, and what a summary gives.
#include "calibrate/number.h"
#include "sim/free_summary.h"
#include "support/check.h"

#define DEGREE 0.017453292519943295 // pi/180

static char ore[] = "ore";
static clod_case_material materials[] = {{.name = ore}};
static clod_case_wall walls[] = {{.name = "floor", .material = ore, .spin_axis = {0, 0, 1}},
                                 {.name = "at_2_m", .material = ore, .spin_axis = {0, 0, 1}}};
static clod_case_repose reposes[] = {{.name = "heap"}};
static clod_case_gauge gauges[] = {{.name = "exit", .direction = {1.0, 0.0, 0.0}},
                                   {.name = "at_60_deg", .profile_bins = 4}};
static clod_case heap = {.materials = materials,
                         .material_count = 1,
                         .walls = walls,
                         .wall_count = 2,
                         .reposes = reposes,
                         .repose_count = 1,
                         .gauges = gauges,
                         .gauge_count = 2,
                         .build_up = {.present = true}};
static clod_plan_test test = {.middle = &heap};

static int list_paths(void **state)
{
    (void)state;
    clod_status status = {CLOD_OK, ""};
    return clod_free_summary_paths(&heap, &test.paths, &status) ? 0 : 1;
}

static int free_paths(void **state)
{
    (void)state;
    clod_free_paths_fini(&test.paths);
    return 0;
}

/** The unit in which a number is given and shown. */
static const char *unit_of(const char *path)
{
    const clod_number *number = clod_number_find(&test, path);
    if (number == NULL) {
        fail_msg("%s is none", path);
    }
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
    assert_string_equal(unit_of("walls.1.torque_Nm.2"), "N m");
    assert_string_equal(unit_of("kinetic_energy_J"), "J");
    assert_string_equal(unit_of("gauges.exit.mass_kg.mean"), "kg");
    assert_string_equal(unit_of("gauges.exit.mass_flow_kg_per_s.mean"), "kg/s");
    assert_string_equal(unit_of("gauges.exit.speed_m_per_s.deviation"), "m/s");
    assert_string_equal(unit_of("gauges.at_60_deg.samples"), ""); // the user's name has none
    assert_string_equal(unit_of("build_up.at_2_m.mean_kg"), "kg");
    assert_string_equal(unit_of("build_up.floor.rate_kg_per_s"), "kg/s");
}

static void what_is_never_negative(void **state)
{
    (void)state;
    static const char *const AMOUNTS[] = {"kinetic_energy_J",
                                          "time_s",
                                          "grains",
                                          "coordination",
                                          "gauges.exit.mass_kg.mean",
                                          "gauges.exit.speed_m_per_s.deviation",
                                          "build_up.floor.mean_kg"};
    static const char *const OTHERS[] = {"walls.0.force_N.2", "repose.heap.height_m",
                                         "gauges.exit.mass_flow_kg_per_s.mean",
                                         "build_up.floor.rate_kg_per_s"};
    for (size_t k = 0; k < sizeof AMOUNTS / sizeof *AMOUNTS; k++) {
        assert_true(
            clod_number_path_is_amount(clod_number_find(&test, AMOUNTS[k]), AMOUNTS[k]));
    }
    for (size_t k = 0; k < sizeof OTHERS / sizeof *OTHERS; k++) {
        assert_false(clod_number_path_is_amount(clod_number_find(&test, OTHERS[k]), OTHERS[k]));
    }
}

/** Whether a target of the test with this number is one; the number of no test is none. */
static bool is_amount(const char *number, size_t count)
{
    const clod_plan plan = {.tests = &test, .test_count = count};
    clod_plan_target target = {.test = 0};
    snprintf(target.number, sizeof target.number, "%s", number);
    return clod_number_is_amount(&plan, &target);
}

static void targets_that_are_never_negative(void **state)
{
    (void)state;
    assert_true(is_amount("grains", 1));
    assert_false(is_amount("grains", 0));
    assert_false(is_amount("repose.heap.angle_deg", 1));
    assert_false(is_amount("walls.0.force_N.2", 1));
}

// Only of a heap, and the load of a belt: an angle at which grains hit a wall has no such bounds.
static void which_angles_have_bounds(void **state)
{
    (void)state;
    const clod_number *heap_angle = clod_number_find(&test, "repose.heap.angle_deg");
    assert_true(clod_number_path_is_repose(heap_angle));
    assert_ptr_equal(clod_number_find(&test, "repose.heap.mean_deg"), heap_angle);
    assert_true(fabs(heap_angle->least / DEGREE - 5.0) < 1e-12);
    assert_true(fabs(heap_angle->most / DEGREE - 90.0) < 1e-12);
    assert_false(
        clod_number_path_is_repose(clod_number_find(&test, "repose.heap.deviation_deg")));
    assert_true(isinf(clod_number_find(&test, "repose.heap.error_deg")->least));
    const clod_number *surcharge =
        clod_number_find(&test, "gauges.at_60_deg.profile.surcharge_deg");
    assert_true(clod_number_is_path(surcharge) && !clod_number_path_is_repose(surcharge));
    assert_true(fabs(surcharge->least / DEGREE + 90.0) < 1e-12);
    assert_true(fabs(surcharge->most / DEGREE - 90.0) < 1e-12);
}

static void a_section_that_the_case_lacks_is_none(void **state)
{
    (void)state;
    static const char *const NONE[] = {"mixing.drum.lacey",
                                       "repos.heap.angle_deg",
                                       "repose.pile.angle_deg",
                                       "repose.heap.angle",
                                       "repose.heap.angle_deg.mean",
                                       "repose.heap",
                                       "build_up",
                                       "build_up.floor",
                                       "build_up.ceiling.mass_kg",
                                       "reposes.heap.angle_deg"};
    for (size_t k = 0; k < sizeof NONE / sizeof *NONE; k++) {
        if (clod_number_find(&test, NONE[k]) != NULL) {
            fail_msg("%s is one", NONE[k]);
        }
    }
    clod_case none = {0};
    clod_plan_test empty = {.middle = &none};
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_free_summary_paths(&none, &empty.paths, &status));
    assert_null(clod_number_find(&empty, "repose.heap.angle_deg"));
    assert_null(clod_number_find(&empty, "walls.0.angle_rad"));
    assert_non_null(clod_number_find(&empty, "kinetic_energy_J"));
    clod_free_paths_fini(&empty.paths);
}

static void a_place_beyond_the_end_of_a_list_is_none(void **state)
{
    (void)state;
    static const char *const PLACE[] = {"", "1a", "a", "-1", "2", "99999999999999999999", "1 "};
    for (size_t k = 0; k < sizeof PLACE / sizeof *PLACE; k++) {
        char path[64];
        snprintf(path, sizeof path, "walls.%s.angle_rad", PLACE[k]);
        assert_null(clod_number_find(&test, path));
    }
    assert_non_null(clod_number_find(&test, "walls.1.angle_rad"));
    assert_non_null(clod_number_find(&test, "walls.0.force_N.2"));
    assert_null(clod_number_find(&test, "walls.0.force_N.3")); // x, y, z
}

/** Of a name in a list of its own. */
static const clod_number *row_of(const char *name)
{
    clod_free_paths paths = {0};
    clod_free_paths_add(&paths, NULL, "%s", name);
    const clod_number *found = clod_number_path_find(&paths, name);
    clod_free_paths_fini(&paths);
    assert_non_null(found);
    return found;
}

static void units_with_several_letters_are_not_taken_for_their_last(void **state)
{
    (void)state;
    static const char *const UNIT[][2] = {{"archard_m3_per_s", "m3/s"},
                                          {"finnie_depth_m_per_s", "m/s"},
                                          {"impacts_per_s", "1/s"},
                                          {"temperature_m2_per_s2", "m2/s2"},
                                          {"wall_force_N_per_m3", "N/m3"},
                                          {"density_kg_per_m3", "kg/m3"},
                                          {"volume_m3", "m3"},
                                          {"area_m2", "m2"},
                                          {"shear_power_W", "W"},
                                          {"torque_Nm", "N m"},
                                          {"largest_pressure_Pa", "Pa"},
                                          {"mass_share", ""},
                                          {"m", ""},
                                          {"kg", ""}};
    for (size_t k = 0; k < sizeof UNIT / sizeof *UNIT; k++) {
        assert_string_equal(row_of(UNIT[k][0])->unit, UNIT[k][1][0] == '\0' ? "1" : UNIT[k][1]);
        assert_string_equal(row_of(UNIT[k][0])->measure.unit, UNIT[k][1]);
    }
}

static double read_of(const char *text, const char *path)
{
    json_error_t error;
    json_t *summary = json_loads(text, 0, &error);
    assert_non_null(summary);
    clod_plan_target target = {0};
    snprintf(target.number, sizeof target.number, "%s", path);
    const double value = clod_number_path_read(
        summary, &CLOD_NUMBERS_PATH[CLOD_NUMBERS_PATH_COUNT - 1], &target);
    json_decref(summary);
    return value;
}

static void values_are_si(void **state)
{
    (void)state;
    json_error_t error;
    json_t *summary = json_loads("{\"repose\": {\"heap\": {\"angle_deg\": 30}}}", 0, &error);
    const clod_plan_target target = {.number = "repose.heap.angle_deg"};
    check_close(clod_number_path_read(summary, clod_number_find(&test, target.number), &target),
                30.0 * DEGREE, 1e-15);
    json_decref(summary);
}

static void names_lead_to_values(void **state)
{
    (void)state;
    check_close(read_of("{\"a\": [{\"b\": [1, 2, 3]}, {\"b\": 4}]}", "a.0.b.2"), 3.0, 0.0);
    check_close(read_of("{\"a\": [{\"b\": [1, 2, 3]}, {\"b\": 4}]}", "a.1.b"), 4.0, 0.0);
    // parts of meshes are behind the names of their walls, with a point between
    static const char PARTS[] =
        "{\"b\": {\"chute\": {\"kg\": 1}, \"chute.lip\": {\"kg\": 2}, \"chute.kg\": {\"kg\": 3}}}";
    check_close(read_of(PARTS, "b.chute.kg"), 1.0, 0.0);
    check_close(read_of(PARTS, "b.chute.lip.kg"), 2.0, 0.0);
    check_close(read_of(PARTS, "b.chute.kg.kg"), 3.0, 0.0);
}

static void what_a_run_does_not_have_is_no_number(void **state)
{
    (void)state;
    assert_true(isnan(read_of("{\"a\": {\"b\": null}}", "a.b")));
    assert_true(isnan(read_of("{\"a\": {\"b\": \"text\"}}", "a.b")));
    assert_true(isnan(read_of("{\"a\": {\"b\": [1]}}", "a.b.1")));
    assert_true(isnan(read_of("{\"a\": {\"b\": 1}}", "a.b.c")));
    assert_true(isnan(read_of("{\"a\": {\"b\": 1}}", "c.b")));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_end_of_the_name_is_the_unit),
        cmocka_unit_test(units_with_several_letters_are_not_taken_for_their_last),
        cmocka_unit_test(what_is_never_negative),
        cmocka_unit_test(targets_that_are_never_negative),
        cmocka_unit_test(which_angles_have_bounds),
        cmocka_unit_test(a_section_that_the_case_lacks_is_none),
        cmocka_unit_test(a_place_beyond_the_end_of_a_list_is_none),
        cmocka_unit_test(values_are_si),
        cmocka_unit_test(names_lead_to_values),
        cmocka_unit_test(what_a_run_does_not_have_is_no_number),
    };
    return cmocka_run_group_tests(tests, list_paths, free_paths);
}
