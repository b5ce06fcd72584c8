// Walls of a checkpoint come back whole; what the file says of them must hold together.

#include "output/checkpoint_columns.h"
#include "output/checkpoint_walls.h"
#include "output/folder_files.h"

#include "temp_folder.h"

#include "random_state.h"

/** Write walls as they are, read them again; whether that went well. */
static bool there_and_back(void **folder, const clod_walls *walls, clod_walls *found,
                           clod_status *status)
{
    const clod_hdf_place place = {
        temp_folder(folder), "w",
        clod_folder_open_file(temp_folder(folder), "w", O_RDWR | O_CREAT | O_TRUNC, status), 0};
    assert_true(place.descriptor >= 0);
    clod_hdf *hdf = clod_hdf_create(&place, CLOD_HDF_EXACT, status);
    assert_non_null(hdf);
    assert_true(clod_checkpoint_walls_put(hdf, walls, status));
    uint64_t size;
    assert_true(clod_hdf_finish(&hdf, &size, status));
    hdf = clod_hdf_open(&place, size, status);
    assert_non_null(hdf);
    const bool good = clod_checkpoint_walls_get(hdf, found, "w", status);
    clod_status reading;
    assert_true(clod_hdf_end_reading(&hdf, &reading));
    close(place.descriptor);
    return good;
}

static void walls_come_back_whole(void **folder)
{
    clod_status status;
    clod_state state = random_state(1), other = random_state(2);
    assert_true(there_and_back(folder, &state.walls, &other.walls, &status));
    assert_int_equal(other.walls.count, RANDOM_STATE_WALLS);
    for (int w = 0; w < RANDOM_STATE_WALLS; w++) {
        assert_string_equal(other.walls.wall[w].name, state.walls.wall[w].name);
        assert_int_equal(other.walls.wall[w].shape_count, w + 1);
        for (int s = 0; s <= w; s++) {
            assert_shapes_equal(&other.walls.wall[w].shapes[s], &state.walls.wall[w].shapes[s]);
        }
    }
    clod_state_fini(&state);
    clod_state_fini(&other);
}

/** Read these walls: they must be refused, and leave none behind. */
static void expect_refused(void **folder, const clod_walls *walls)
{
    clod_status status;
    clod_walls found = {0};
    assert_false(there_and_back(folder, walls, &found, &status));
    assert_int_equal(status.code, CLOD_FAILED);
    assert_string_equal(status.text,
                        "w holds walls whose shapes clod does not know. Start over "
                        "with --fresh.");
    assert_int_equal(found.count, 0);
    assert_null(found.wall);
}

static void nonsense_is_refused(void **folder)
{
    clod_state state = random_state(1);
    clod_shape *shape = &state.walls.wall[2].shapes[2];
    const clod_shape good = *shape;
    shape->kind = (clod_shape_kind)CLOD_SHAPE_KINDS;
    expect_refused(folder, &state.walls);
    shape->kind = (clod_shape_kind)-1;
    expect_refused(folder, &state.walls);
    *shape = good;
    shape->side = (clod_side)2;
    expect_refused(folder, &state.walls);
    *shape = good;
    memset(state.walls.wall[1].name, 'x', sizeof state.walls.wall[1].name);
    expect_refused(folder, &state.walls);
    clod_state_fini(&state);
}

/** Walls of which one says that it has so many shapes, where the file has five. */
static void shapes_must_be_there(void **folder)
{
    clod_status status;
    clod_shape shapes[5] = {{0}};
    for (int32_t said = -1; said <= 6; said++) {
        clod_wall two[2] = {{.name = "a", .shape_count = said},
                            {.name = "b", .shape_count = 0}};
        const clod_hdf_place place = {temp_folder(folder), "w",
                                      clod_folder_open_file(temp_folder(folder), "w",
                                                            O_RDWR | O_CREAT | O_TRUNC,
                                                            &status),
                                      0};
        clod_hdf *hdf = clod_hdf_create(&place, CLOD_HDF_EXACT, &status);
        assert_non_null(hdf);
        clod_checkpoint_columns columns;
        clod_checkpoint_columns_of_walls(&columns, two, 2);
        for (size_t c = 0; c < columns.count; c++) {
            clod_hdf_put(hdf, &columns.column[c]);
        }
        clod_checkpoint_columns_of_shapes(&columns, shapes, 5);
        for (size_t c = 0; c < columns.count; c++) {
            clod_hdf_put(hdf, &columns.column[c]);
        }
        uint64_t size;
        assert_true(clod_hdf_finish(&hdf, &size, &status));
        hdf = clod_hdf_open(&place, size, &status);
        assert_non_null(hdf);
        clod_walls found = {0};
        assert_int_equal(clod_checkpoint_walls_get(hdf, &found, "w", &status), said == 5);
        assert_true(clod_hdf_end_reading(&hdf, &status));
        assert_int_equal(found.count, said == 5 ? 2 : 0);
        close(place.descriptor);
        clod_walls_fini(&found);
    }
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(walls_come_back_whole),
        FOLDER_TEST(nonsense_is_refused),
        FOLDER_TEST(shapes_must_be_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
