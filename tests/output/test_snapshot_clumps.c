// Clumps and pull-off forces in snapshots, and maps of cubes.

#include <hdf5.h>
#include <math.h>

#include "output/snapshot.h"
#include "output/voxels.h"

#include "temp_folder.h"
#include "vtk_file.h"

#define GRAINS 4

/** Four grains; 0 and 1, 0 and 2 touch. */
static clod_state sample_state(void)
{
    clod_status status;
    clod_state state = {.domain = {.max = {0.1, 0.2, 0.3}}};
    for (uint64_t g = 0; g < GRAINS; g++) {
        const double place[4] = {0.01 * (double)g, 0.02, 0.03, 6e-3};
        const double none[3] = {0.0, 0.0, 0.0};
        assert_true(
            clod_grains_add(&state.grains, place, none, none, 2500.0, 0, 70 + g, &status));
    }
    state.contact_count = state.contact_capacity = 2;
    state.contacts = clod_memory_alloc(2, sizeof *state.contacts);
    state.contacts[0] = (clod_contact){0, 1, -1, {1}};
    state.contacts[1] = (clod_contact){0, 2, -1, {11}};
    return state;
}

/** Seven times the plastic overlap, for the files to have. */
static clod_contact_strength sample_strength(const void *laws, const clod_contact *contact)
{
    const double *factor = laws;
    return (clod_contact_strength){.pull_off = *factor * contact->history[0]};
}

static void clumps_and_pull_off_are_there_when_they_are_known(void **folder)
{
    clod_status status;
    clod_state state = sample_state();
    const double seven = 7.0;
    clod_contact_list list;
    clod_contact_source from = clod_contact_source_of(&list, &state);
    from.laws = &seven;
    from.strength = sample_strength;
    clod_bed_view view;
    const clod_bed_source bed = clod_bed_source_of(&view, &state, &from);
    assert_true(clod_snapshot_write(temp_folder(folder), "run", 0, &state, NULL, true,
                                    &(clod_snapshot_film){{0}}, &status));
    assert_true(clod_grains_keep_clumps(&state.grains, &status));
    state.grains.clump[1] = (clod_grain_clump){.number = (uint64_t)1 << 60, .size = 3};
    assert_true(clod_snapshot_write(temp_folder(folder), "run", 1, &state, &bed, true,
                                    &(clod_snapshot_film){{0}}, &status));
    hid_t file = open_file(folder, "snap_000000.hdf");
    assert_true(H5Lexists(file, "VTKHDF/PointData/clump", H5P_DEFAULT) == 0);
    H5Fclose(file);
    int64_t clump[GRAINS];
    int32_t size[GRAINS];
    file = open_file(folder, "snap_000001.hdf");
    read_longs(file, "VTKHDF/PointData/clump", GRAINS, clump);
    read_array(file, "VTKHDF/PointData/clump_size", H5T_INTEGER, 4, GRAINS, 0, H5T_NATIVE_INT32,
               size);
    assert_true(clump[1] == (int64_t)1 << 60 && clump[0] == 0);
    assert_true(size[1] == 3 && size[0] == 0);
    H5Fclose(file);
    float pull[2];
    file = open_file(folder, "contacts_000000.hdf");
    read_reals(file, "VTKHDF/CellData/pull_off", 2, 0, pull);
    assert_true(pull[0] == 0.0F && pull[1] == 0.0F);
    H5Fclose(file);
    file = open_file(folder, "contacts_000001.hdf");
    read_reals(file, "VTKHDF/CellData/pull_off", 2, 0, pull);
    assert_true(pull[0] == 7.0F && pull[1] == 77.0F);
    H5Fclose(file);
    clod_state_fini(&state);
}

/** Two cubes of 0.5 m: eight corners each, x fastest, as VTK_VOXEL has them. */
static void voxels_are_cubes(void **folder)
{
    clod_status status;
    const double corner[2][3] = {{1.0, 2.0, 3.0}, {-1.0, 0.0, 0.5}};
    const double force[2] = {4.0, 8.0};
    const clod_hdf_column column = {
        "VTKHDF/CellData/force", "N", CLOD_HDF_F64, 1, 2, force, sizeof *force};
    const clod_voxels voxels = {corner, 2, 0.5, &column, 1, 7, 0.25};
    assert_true(clod_voxels_write(temp_folder(folder), "map.hdf", &voxels, &status));
    const hid_t file = open_file(folder, "map.hdf");
    check_head(file);
    check_cells(file, 2, 8, 11); // VTK_VOXEL
    float points[16][3], found[2];
    read_reals(file, "VTKHDF/Points", 16, 3, &points[0][0]);
    read_reals(file, "VTKHDF/CellData/force", 2, 0, found);
    assert_true(found[0] == 4.0F && found[1] == 8.0F);
    const float expected[8][3] = {{1.0F, 2.0F, 3.0F}, {1.5F, 2.0F, 3.0F}, {1.0F, 2.5F, 3.0F},
                                  {1.5F, 2.5F, 3.0F}, {1.0F, 2.0F, 3.5F}, {1.5F, 2.0F, 3.5F},
                                  {1.0F, 2.5F, 3.5F}, {1.5F, 2.5F, 3.5F}};
    assert_memory_equal(points, expected, sizeof expected);
    assert_true(points[8][0] == -1.0F && points[15][2] == 1.0F);
    H5Fclose(file);
    const clod_voxels none = {NULL, 0, 0.5, NULL, 0, 7, 0.25};
    assert_true(clod_voxels_write(temp_folder(folder), "map.hdf", &none, &status));
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(clumps_and_pull_off_are_there_when_they_are_known),
        FOLDER_TEST(voxels_are_cubes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
