// Meshes that the suite writes: read again, beside what they should be.

#include <math.h>

#include "clod/mesh.h"
#include "output/temp_folder.h"
#include "support/check.h"
#include "verify/facets.h"

static clod_status status;

static clod_mesh_report report_of(const clod_verify_facets *file)
{
    const clod_mesh_placing metres = {.unit = 1.0, .scale = 1.0};
    clod_mesh *mesh = clod_mesh_read(file->path, &metres, &status);
    assert_non_null(mesh);
    clod_mesh_report report;
    assert_true(clod_mesh_examine(mesh, 0.0, &report, &status));
    clod_mesh_destroy(&mesh);
    return report;
}

/** A bar: closed, its volume that of a box. */
static void a_box_is_closed(void **temporary)
{
    clod_verify_facets file;
    const double c = cos(0.3), s = sin(0.3);
    const clod_vec3 half[3] = {
        {0.2 * c, 0.2 * s, 0.0}, {-0.1 * s, 0.1 * c, 0.0}, {0.0, 0.0, 0.05}};
    assert_true(clod_verify_facets_open(&file, *temporary, "bar", &status));
    clod_verify_facets_box(&file, (clod_vec3){1.0, 2.0, 3.0}, half);
    assert_true(clod_verify_facets_close(&file, &status));
    const clod_mesh_report report = report_of(&file);
    assert_int_equal((int)report.read_facets, 12);
    assert_true(report.closed);
    check_close(report.volume, 0.4 * 0.2 * 0.1, 1e-8); // outwards: positive
}

/** A tube and a cone: the area of the sides, whose mean distance from the axis is the radius. */
static void a_lathe_turns_a_line(void **temporary)
{
    static const double LINE[][2] = {{0.1, 0.0}, {0.2, 0.3}, {0.2, 0.5}};
    clod_verify_facets file;
    assert_true(clod_verify_facets_open(&file, *temporary, "hopper", &status));
    clod_verify_facets_lathe(&file, LINE, 3, 90);
    assert_true(clod_verify_facets_close(&file, &status));
    const clod_mesh_report report = report_of(&file);
    const double area = M_PI * 0.3 * hypot(0.1, 0.3) + 2.0 * M_PI * 0.2 * 0.2;
    assert_int_equal((int)report.read_facets, 2 * 2 * 90);
    check_relative(report.area, area, 1e-3);
    const double half =
        M_PI / 90.0; // corners are out by a third, middles of sides in by a sixth
    check_relative(report.box[1][0], 0.2 * (1.0 + half * half / 3.0), 1e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_box_is_closed, temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_lathe_turns_a_line, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
