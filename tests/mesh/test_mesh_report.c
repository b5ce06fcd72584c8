// What the mesh doctor doubts, and its report as text and JSON.

#include <jansson.h>
#include <math.h>

#include "mesh/mesh_maker.h"

/** Report of a box of `size` in each direction from `low` on, in a unit. */
static clod_mesh_report box(float low, float size, double unit, double radius, clod_mesh **mesh)
{
    maker *made = maker_new();
    maker_box(made, (const float[3]){low, low, low}, (const float[3]){size, size, size});
    const clod_mesh_placing placing = {.unit = unit, .scale = 1.0};
    *mesh = maker_read(made, &placing);
    return maker_report(*mesh, radius);
}

/** The only warning has this text; none when it is NULL. */
static void check_warning(float low, float size, double unit, double radius, const char *text)
{
    clod_mesh *mesh;
    const clod_mesh_report report = box(low, size, unit, radius, &mesh);
    for (size_t w = 0; w < report.warning_count; w++) {
        if (text == NULL || strstr(report.warnings[w], text) == NULL) {
            print_error("%s\n", report.warnings[w]);
        }
    }
    assert_int_equal(report.warning_count, text == NULL ? 0 : 1);
    assert_true(text == NULL || strstr(report.warnings[0], text) != NULL);
    clod_mesh_destroy(&mesh);
}

// From 10 to 1000 diameters of a grain, from 1 mm to 1 km: nothing to say.
static void sizes_are_doubted(void **state)
{
    (void)state;
    check_warning(0.0f, 1000.0f, 1e-3, 0.0, NULL);
    check_warning(0.0f, 1000.0f, 1e-3, 0.003, NULL);   // 167 diameters
    check_warning(0.0f, 1000.0f, 1e-3, 0.00051, NULL); // 980
    check_warning(0.0f, 1000.0f, 1e-3, 0.00049, "1020 grain diameters");
    check_warning(0.0f, 1000.0f, 1e-3, 0.049, NULL); // 10.2
    check_warning(0.0f, 1000.0f, 1e-3, 0.051, "9.8 grain diameters");
    check_warning(0.0f, 1000.0f, 1.0, 0.003, "1.67e+05 grain"); // numbers of mm
    check_warning(0.0f, 1000.0f, 1.0, 0.003, "plausible in: mm.");
    check_warning(0.0f, 1001.0f, 1.0, 0.0, "a plant has from 1 mm to 1 km");
    check_warning(0.0f, 1001.0f, 1.0, 0.0, "plausible in: ft, in, cm, mm, um.");
    check_warning(0.0f, 0.99f, 1e-3, 0.0, "a plant has from 1 mm to 1 km");
    check_warning(0.0f, 1e9f, 1e-3, 1e-3, "none of the usual units");
}

// 1000 m from the origin a float has steps of 6e-5 m: 1/1000 of a grain of 61 mm.
static void rounding_is_doubted(void **state)
{
    (void)state;
    check_warning(1000.0f, 20.0f, 1.0, 0.125, NULL);
    check_warning(1000.0f, 20.0f, 1.0, 0.120, "rounded to 0.00012 m");
    check_warning(1000.0f, 11.0f, 1.0, 0.0, "rounded to 0.00012 m");
    check_warning(1000.0f, 13.0f, 1.0, 0.0, NULL);
}

// The longest edge of each facet of a unit box is sqrt 2.
static void fine_facets_are_counted(void **state)
{
    (void)state;
    clod_mesh *mesh;
    clod_mesh_report report = box(0.0f, 1.0f, 1.0, 1.41, &mesh);
    assert_int_equal(report.small_facets, 0);
    clod_mesh_destroy(&mesh);
    report = box(0.0f, 1.0f, 1.0, 1.42, &mesh);
    assert_int_equal(report.small_facets, 12);
    assert_int_equal(report.warning_count, 2);
    assert_non_null(strstr(report.warnings[1], "12 of 12 facets are smaller than the radius"));
    clod_mesh_destroy(&mesh);
}

// A room: the box with every facet turned.
static void normals_that_point_inwards_are_told(void **state)
{
    (void)state;
    maker *made = maker_new();
    maker_box(made, (const float[3]){1, 1, 1}, (const float[3]){1, 1, 1});
    for (size_t f = 0; f < 12; f++) {
        char *at = made->bytes + 84 + 50 * f, kept[12];
        memcpy(kept, at + 24, 12);
        memmove(at + 24, at + 36, 12);
        memcpy(at + 36, kept, 12);
    }
    clod_mesh *mesh;
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_true(report.volume == -1.0);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_CONCAVE], 12);
    assert_int_equal(report.warning_count, 1);
    assert_non_null(strstr(report.warnings[0], "point inwards"));
    char *text = clod_mesh_text(mesh, &report);
    assert_non_null(strstr(text, "volume   1 m3"));
    clod_mesh_free(text);
    clod_mesh_destroy(&mesh);
}

// A name that is no UTF-8 does not spoil the JSON: a question mark for each such byte.
static void names_of_any_bytes(void **state)
{
    (void)state;
    static const char OBJ[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng \xFF\xFE\nf 1 2 3\n";
    clod_status status = {CLOD_OK, ""};
    clod_mesh *mesh = clod_mesh_parse("a.obj", OBJ, sizeof OBJ - 1, &METRES, &status);
    assert_non_null(mesh);
    const clod_mesh_report report = maker_report(mesh, 0.0);
    char *text = clod_mesh_json(mesh, &report);
    assert_non_null(text);
    json_t *all = json_loads(text, 0, NULL);
    assert_non_null(all);
    const json_t *part = json_array_get(json_object_get(all, "parts"), 0);
    assert_string_equal(json_string_value(json_object_get(part, "name")), "??");
    assert_true(json_is_null(json_object_get(all, "volume_m3")));
    json_decref(all);
    clod_mesh_free(text);
    clod_mesh_destroy(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sizes_are_doubted),
        cmocka_unit_test(rounding_is_doubted),
        cmocka_unit_test(fine_facets_are_counted),
        cmocka_unit_test(normals_that_point_inwards_are_told),
        cmocka_unit_test(names_of_any_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
