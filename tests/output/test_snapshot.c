// Snapshots: every rule of the VTKHDF 1.0 UnstructuredGrid layout, the arrays that people look
// for, and the series index. The triangles of the walls: test_wall_mesh.c.
// Layout: VTK documentation, "VTKHDF File Format", version 1.0.

#include <hdf5.h>
#include <jansson.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "output/snapshot.h"

#include "temp_folder.h"
#include "vtk_file.h"

#define GRAINS 4

#define assert_near(found, expected, error) assert_true(fabs((found) - (expected)) <= (error))

static const double PLACE[GRAINS][4] = {{0.010, 0.02, 0.03, 0.0030},
                                        {0.015, 0.02, 0.03, 0.0031},
                                        {0.099, 0.02, 0.03, 0.0032},
                                        {0.050, 0.05, 0.05, 0.0029}};

/** Grains 0-1 and, over the periodic border in x, 0-2 touch; 3 rests on the wall. */
static clod_state sample_state(void)
{
    clod_status status;
    clod_state state = {.time = 0.25, .step = 100, .domain = {.max = {0.1, 0.2, 0.3}}};
    state.domain.periodic[0] = true;
    for (uint64_t g = 0; g < GRAINS; g++) {
        const double v = 0.1 * (double)(g + 1);
        assert_true(clod_grains_add(&state.grains, PLACE[g], (double[3]){v, -v, 2 * v},
                                    (double[3]){3 * v, 4 * v, 5 * v}, 2500.0, (uint16_t)(g % 2),
                                    70 + g, &status));
        state.grains.load[g][0] = 7 * v;
    }
    state.contact_count = state.contact_capacity = 3;
    state.wall_contact_count = 1;
    state.contacts = clod_memory_alloc(3, sizeof *state.contacts);
    state.contacts[0] = (clod_contact){0, 1, -1, {1, 2, 3, 4, 5, 6, 7, 8}};
    state.contacts[1] = (clod_contact){0, 2, -1, {11, 12, 13, 14, 15, 16, 17, 18}};
    state.contacts[2] = (clod_contact){3, 0, 0, {21, 22, 23, 24, 25, 26, 27, 28}};
    state.walls.count = 1;
    state.walls.wall = clod_memory_alloc(1, sizeof *state.walls.wall);
    state.walls.wall[0].material = 2;
    state.walls.wall[0].spin_axis.z = 1.0;
    state.walls.wall[0].velocity.z = -0.5;
    state.walls.wall[0].shape_count = 1;
    state.walls.wall[0].shapes = clod_memory_alloc(1, sizeof(clod_shape));
    state.walls.wall[0].shapes[0] =
        (clod_shape){.kind = CLOD_SHAPE_PLANE,
                     .center = {0.0, 0.0, 0.01},
                     .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    return state;
}

static void grains_are_vertices_with_the_arrays_people_look_for(void **folder)
{
    clod_status status;
    clod_state state = sample_state();
    assert_true(clod_snapshot_write(temp_folder(folder), "run", 123, &state, NULL, false,
                                    &(clod_snapshot_film){{0}}, &status));
    assert_false(temp_exists(folder, "contacts_000123.hdf"));
    const hid_t file = open_file(folder, "snap_000123.hdf");
    check_head(file);
    check_cells(file, GRAINS, 1, 1); // VTK_VERTEX
    float points[GRAINS][3], radius[GRAINS], mass[GRAINS];
    float velocity[GRAINS][3], omega[GRAINS][3], force[GRAINS][3];
    int64_t id[GRAINS];
    int32_t type[GRAINS], coordination[GRAINS];
    read_reals(file, "VTKHDF/Points", GRAINS, 3, &points[0][0]);
    read_reals(file, "VTKHDF/PointData/radius", GRAINS, 0, radius);
    read_reals(file, "VTKHDF/PointData/mass", GRAINS, 0, mass);
    read_reals(file, "VTKHDF/PointData/velocity", GRAINS, 3, &velocity[0][0]);
    read_reals(file, "VTKHDF/PointData/omega", GRAINS, 3, &omega[0][0]);
    read_reals(file, "VTKHDF/PointData/force", GRAINS, 3, &force[0][0]);
    read_longs(file, "VTKHDF/PointData/id", GRAINS, id);
    read_array(file, "VTKHDF/PointData/type", H5T_INTEGER, 2, GRAINS, 0, H5T_NATIVE_INT32,
               type);
    read_array(file, "VTKHDF/PointData/coordination", H5T_INTEGER, 4, GRAINS, 0,
               H5T_NATIVE_INT32, coordination);
    // by hand: grain 0 touches 1 and 2, grain 3 touches the wall
    const int32_t expected_coordination[GRAINS] = {2, 1, 1, 1};
    for (int g = 0; g < GRAINS; g++) {
        const double v = 0.1 * (g + 1);
        assert_true(radius[g] == (float)PLACE[g][3]);
        const double sphere = 2500.0 * 4.0 / 3.0 * M_PI * pow(PLACE[g][3], 3);
        assert_near((double)mass[g] / sphere, 1.0, 1e-6);
        assert_int_equal(id[g], 70 + g);
        assert_int_equal(type[g], g % 2);
        assert_int_equal(coordination[g], expected_coordination[g]);
        for (int d = 0; d < 3; d++) {
            assert_true(points[g][d] == (float)PLACE[g][d]);
            assert_true(velocity[g][d] == (float)((double[3]){v, -v, 2 * v}[d]));
            assert_true(omega[g][d] == (float)((3 + d) * v));
            assert_true(force[g][d] == (float)(d == 0 ? 7 * v : 0.0));
        }
    }
    H5Fclose(file);
    clod_state_fini(&state);
}

static void contacts_are_lines_that_stay_together_over_a_periodic_border(void **folder)
{
    clod_status status;
    clod_state state = sample_state();
    assert_true(clod_snapshot_write(temp_folder(folder), "seed1", 0, &state, NULL, true,
                                    &(clod_snapshot_film){{0}}, &status));
    const hid_t file = open_file(folder, "seed1_contacts_000000.hdf");
    check_head(file);
    check_cells(file, 2, 2, 3); // VTK_LINE
    float points[4][3], overlap[2], plastic[2], spring[2][3], roll[2][3];
    int64_t id[2][2];
    read_reals(file, "VTKHDF/Points", 4, 3, &points[0][0]);
    read_reals(file, "VTKHDF/CellData/overlap", 2, 0, overlap);
    read_reals(file, "VTKHDF/CellData/plastic", 2, 0, plastic);
    read_reals(file, "VTKHDF/CellData/spring", 2, 3, &spring[0][0]);
    read_reals(file, "VTKHDF/CellData/roll", 2, 3, &roll[0][0]);
    read_array(file, "VTKHDF/CellData/id", H5T_INTEGER, 8, 2, 2, H5T_NATIVE_INT64, id);
    // by hand: domain 0.1 m long, so grain 2 at 0.099 shows at -0.001 beside grain 0 at 0.010
    const double x[4] = {0.010, 0.015, 0.010, -0.001};
    for (int p = 0; p < 4; p++) {
        assert_near((double)points[p][0], x[p], 1e-8);
        assert_near((double)points[p][1], 0.02, 1e-8);
    }
    assert_near((double)overlap[0], 0.0030 + 0.0031 - 0.005, 1e-9);
    assert_near((double)overlap[1], 0.0030 + 0.0032 - 0.011, 1e-9); // apart: history is left
    assert_int_equal(id[0][0], 70);
    assert_int_equal(id[0][1], 71);
    assert_int_equal(id[1][1], 72);
    for (int c = 0; c < 2; c++) {
        assert_true(plastic[c] == (float)(10 * c + 1));
        for (int d = 0; d < 3; d++) {
            assert_true(spring[c][d] == (float)(10 * c + 3 + d));
            assert_true(roll[c][d] == (float)(10 * c + 6 + d));
        }
    }
    H5Fclose(file);
    clod_state_fini(&state);
}

static void walls_are_triangles(void **folder)
{
    clod_status status;
    clod_state state = sample_state();
    assert_true(clod_snapshot_write(temp_folder(folder), "run", 1, &state, NULL, false,
                                    &(clod_snapshot_film){{0}}, &status));
    const hid_t file = open_file(folder, "walls_000001.hdf");
    check_head(file);
    check_cells(file, 2, 3, 5); // VTK_TRIANGLE
    float points[6][3], velocity[2][3];
    int32_t wall[2], type[2], shape[2];
    read_reals(file, "VTKHDF/Points", 6, 3, &points[0][0]);
    read_reals(file, "VTKHDF/CellData/velocity", 2, 3, &velocity[0][0]);
    read_array(file, "VTKHDF/CellData/wall", H5T_INTEGER, 4, 2, 0, H5T_NATIVE_INT32, wall);
    read_array(file, "VTKHDF/CellData/type", H5T_INTEGER, 4, 2, 0, H5T_NATIVE_INT32, type);
    read_array(file, "VTKHDF/CellData/shape", H5T_INTEGER, 4, 2, 0, H5T_NATIVE_INT32, shape);
    // by hand: square of the domain's longest side, 0.3, about its middle (0.05, 0.1)
    for (int p = 0; p < 6; p++) {
        assert_near(fabs((double)points[p][0] - 0.05), 0.15, 1e-7);
        assert_near(fabs((double)points[p][1] - 0.10), 0.15, 1e-7);
        assert_near((double)points[p][2], 0.01, 1e-8);
    }
    for (int t = 0; t < 2; t++) {
        assert_int_equal(wall[t], 0);
        assert_int_equal(type[t], 2);
        assert_int_equal(shape[t], 0); // plane, docs/howto/paraview.md
        assert_near((double)velocity[t][2], -0.5, 1e-7);
    }
    H5Fclose(file);
    clod_state_fini(&state);
}

static void an_empty_state_makes_empty_pictures(void **folder)
{
    clod_status status;
    const clod_state state = {0};
    assert_true(clod_snapshot_write(temp_folder(folder), "run", 0, &state, NULL, true,
                                    &(clod_snapshot_film){{0}}, &status));
    const char *const names[] = {"snap_000000.hdf", "walls_000000.hdf", "contacts_000000.hdf"};
    for (int n = 0; n < 3; n++) {
        const hid_t file = open_file(folder, names[n]);
        check_head(file);
        check_cells(file, 0, 1, 0);
        H5Fclose(file);
    }
}

/** Whether the index lists exactly these numbers, at a tenth of a second each. */
static void check_series(void **folder, const char *series, const char *prefix,
                         const int *numbers, size_t count)
{
    char path[PATH_MAX], name[64];
    json_t *index = json_load_file(temp_path(path, folder, series), 0, NULL);
    assert_string_equal(json_string_value(json_object_get(index, "file-series-version")),
                        "1.0");
    json_t *files = json_object_get(index, "files");
    assert_int_equal(json_array_size(files), count);
    for (size_t n = 0; n < count; n++) {
        json_t *entry = json_array_get(files, n);
        snprintf(name, sizeof name, "%s_%06d.hdf", prefix, numbers[n]);
        assert_string_equal(json_string_value(json_object_get(entry, "name")), name);
        assert_true(json_real_value(json_object_get(entry, "time")) == 0.1 * numbers[n]);
        assert_true(temp_exists(folder, name));
    }
    json_decref(index);
}

static void write_numbers(void **folder, clod_state *state, clod_snapshot_film *film, int first,
                          int last)
{
    clod_status status;
    for (int n = first; n <= last; n++) {
        state->time = 0.1 * n;
        assert_true(clod_snapshot_write(temp_folder(folder), "run", n, state, NULL, true, film,
                                        &status));
    }
}

static void a_series_resumes_without_the_later_snapshots(void **folder)
{
    clod_status status;
    clod_state state = sample_state();
    assert_true(
        clod_snapshot_resume(temp_folder(folder), "run", 0.0, &status)); // nothing there yet
    assert_false(temp_exists(folder, "run.hdf.series"));
    clod_snapshot_film film = {{0}};
    write_numbers(folder, &state, &film, 0, 2);
    const clod_snapshot_film at_2 = film;
    write_numbers(folder, &state, &film, 3, 4);
    check_series(folder, "run.hdf.series", "snap", (int[]){0, 1, 2, 3, 4}, 5);
    check_series(folder, "run_walls.hdf.series", "walls", (int[]){0, 1, 2, 3, 4}, 5);
    check_series(folder, "run_contacts.hdf.series", "contacts", (int[]){0, 1, 2, 3, 4}, 5);
    assert_true(clod_snapshot_check(temp_folder(folder), "run", 0.2, &at_2, &status));
    assert_false(clod_snapshot_check(temp_folder(folder), "run", 0.1, &at_2, &status));
    assert_true(clod_snapshot_resume(temp_folder(folder), "run", 0.2, &status));
    check_series(folder, "run.hdf.series", "snap", (int[]){0, 1, 2}, 3);
    check_series(folder, "run_walls.hdf.series", "walls", (int[]){0, 1, 2}, 3);
    check_series(folder, "run_contacts.hdf.series", "contacts", (int[]){0, 1, 2}, 3);
    assert_false(temp_exists(folder, "snap_000003.hdf"));
    assert_false(temp_exists(folder, "walls_000004.hdf"));
    film = at_2;
    write_numbers(folder, &state, &film, 2, 3); // the moment of the checkpoint is written again
    check_series(folder, "run.hdf.series", "snap", (int[]){0, 1, 2, 3}, 4);
    clod_state_fini(&state);
}

static void an_index_that_was_changed_is_refused(void **folder)
{
    static const char INDEX[] = "run_walls.hdf.series";
    clod_status status;
    char path[PATH_MAX], changed[4096];
    size_t size;
    clod_state state = sample_state();
    clod_snapshot_film film = {{0}};
    write_numbers(folder, &state, &film, 0, 2);
    char *index = temp_read(folder, INDEX, &size);
    assert_true(size < sizeof changed);
    memcpy(changed, index, size + 1);
    *strstr(changed, "walls_000001") = 'v'; // one bit
    temp_write(folder, INDEX, changed, size);
    assert_false(clod_snapshot_check(temp_folder(folder), "run", 0.2, &film, &status));
    assert_non_null(strstr(status.text, "run_walls.hdf.series was changed, or is damaged"));
    assert_false(
        clod_snapshot_write(temp_folder(folder), "run", 3, &state, NULL, true, &film, &status));
    assert_int_equal(unlink(temp_path(path, folder, INDEX)), 0); // as the text says
    assert_true(clod_snapshot_check(temp_folder(folder), "run", 0.2, &film, &status));
    write_numbers(folder, &state, &film, 3, 3);
    check_series(folder, INDEX, "walls", (int[]){3}, 1);
    clod_memory_free(index);
    clod_state_fini(&state);
}

static void the_same_state_gives_the_same_bytes(void **folder)
{
    clod_status status;
    size_t size_1, size_2;
    clod_state state = sample_state();
    assert_true(clod_snapshot_write(temp_folder(folder), "run", 0, &state, NULL, false,
                                    &(clod_snapshot_film){{0}}, &status));
    char *first = temp_read(folder, "snap_000000.hdf", &size_1);
    sleep(1); // no time stamps
    assert_true(clod_snapshot_write(temp_folder(folder), "run", 0, &state, NULL, false,
                                    &(clod_snapshot_film){{0}}, &status));
    char *second = temp_read(folder, "snap_000000.hdf", &size_2);
    assert_int_equal(size_1, size_2);
    assert_memory_equal(first, second, size_1);
    clod_memory_free(first);
    clod_memory_free(second);
    clod_state_fini(&state);
}

static void failures_are_told(void **folder)
{
    clod_status status;
    char path[PATH_MAX], text[2 * PATH_MAX];
    const clod_state state = {0};
    temp_path(path, folder, "run.hdf.series");
    assert_int_equal(symlink(path, path), 0); // an error, and not a list that is not there
    assert_false(clod_snapshot_check(temp_folder(folder), "run", 9.0,
                                     &(clod_snapshot_film){{0}}, &status));
    assert_false(clod_snapshot_resume(temp_folder(folder), "run", 0.0, &status));
    assert_non_null(strstr(status.text, "Too many levels of symbolic links"));
    assert_int_equal(unlink(path), 0);
    assert_true(clod_snapshot_check(temp_folder(folder), "run", 9.0, &(clod_snapshot_film){{0}},
                                    &status));
    const char *const bad[] = {"", "[]", "{\"files\": [{\"name\": 1}]}", "{\"files\": "};
    for (size_t b = 0; b < sizeof bad / sizeof *bad; b++) {
        temp_write(folder, "run.hdf.series", bad[b], strlen(bad[b]));
        assert_false(clod_snapshot_write(temp_folder(folder), "run", 0, &state, NULL, false,
                                         &(clod_snapshot_film){{0}}, &status));
        snprintf(text, sizeof text,
                 "%s/run.hdf.series is not a list of snapshots. Put back the file as the run "
                 "left it, or remove it: the next snapshot then starts a new one.",
                 (char *)*folder);
        assert_string_equal(status.text, text);
        assert_false(clod_snapshot_check(temp_folder(folder), "run", 9.0,
                                         &(clod_snapshot_film){{0}}, &status));
        assert_string_equal(status.text, text);
    }
    // an index that names a file elsewhere must not make clod remove it
    const char *elsewhere = "{\"files\": [{\"name\": \"../other.hdf\", \"time\": 9.0}]}";
    temp_write(folder, "run.hdf.series", elsewhere, strlen(elsewhere));
    assert_false(clod_snapshot_resume(temp_folder(folder), "run", 0.0, &status));
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(grains_are_vertices_with_the_arrays_people_look_for),
        FOLDER_TEST(contacts_are_lines_that_stay_together_over_a_periodic_border),
        FOLDER_TEST(walls_are_triangles),
        FOLDER_TEST(an_empty_state_makes_empty_pictures),
        FOLDER_TEST(a_series_resumes_without_the_later_snapshots),
        FOLDER_TEST(an_index_that_was_changed_is_refused),
        FOLDER_TEST(the_same_state_gives_the_same_bytes),
        FOLDER_TEST(failures_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
