// The file of a grid that a run leaves: what ParaView opens, with the numbers of closed forms.

#include <hdf5.h>
#include <math.h>
#include <stdio.h>

#include "clod/case.h"
#include "clod/run.h"
#include "output/vtk_file.h"
#include "support/case_of.h"

#define WIDTH 0.012
#define CELL 0.004
#define PIECES 2000

/** A grain alone, and two that overlap by 0.1 mm: 1 N with 1e4 N/m. Nothing moves before the first
 *  sample. */
static const char CASE[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 1, friction: 0}}\n"
    "gravity: [0 m/s2, 0 m/s2, 0 m/s2]\n"
    "time: {step: 1e-6 s, design_stress: 1 kPa, overlap_limit: 10 %}\n"
    "domain: {min: [0 m, 0 m, 0 m], max: [0.1 m, 0.1 m, 0.1 m]}\n"
    "grains: [{material: ore, file: grains.csv}]\n"
    "fields:\n"
    "  all:\n"
    "    region: {box: {min: [0 m, 0 m, 0 m], max: [0.1 m, 0.08 m, 0.08 m]}}\n"
    "    cell: 4 mm\n"
    "    width: 12 mm\n"
    "stages: [{name: run, duration: 2e-6 s}]\n"
    "output: {series_interval: 1e-6 s, steady_since: 0 s}\n";

static const double GRAIN[3][4] = {{0.02, 0.0213, 0.0227, 0.002},
                                   {0.05, 0.0501, 0.0497, 0.003},
                                   {0.0559, 0.0501, 0.0497, 0.003}};

static void run(void **folder)
{
    static clod_status status;
    char path[PATH_MAX], *report = NULL;
    FILE *out = fopen(temp_path(path, folder, "grains.csv"), "w");
    assert_non_null(out);
    fputs("x [m],y [m],z [m],radius [m]\n", out);
    for (int g = 0; g < 3; g++) {
        fprintf(out, "%.17g,%.17g,%.17g,%.17g\n", GRAIN[g][0], GRAIN[g][1], GRAIN[g][2],
                GRAIN[g][3]);
    }
    assert_int_equal(fclose(out), 0);
    clod_case *made = case_at(temp_path(path, folder, "case.yaml"), CASE, NULL, 0);
    char results[PATH_MAX];
    const clod_run_options options = {.directory = temp_path(results, folder, "out"),
                                      .threads = 1};
    const bool good = clod_run(made, &options, &report, &status);
    if (!good) {
        print_error("%s\n", status.text);
    }
    assert_true(good);
    clod_run_free(report);
    clod_case_destroy(&made);
}

/** Lucy's polynomial, written out. */
static double kernel(const double a[3], const double b[3])
{
    double square = 0.0;
    for (int c = 0; c < 3; c++) {
        square += (a[c] - b[c]) * (a[c] - b[c]);
    }
    const double q = sqrt(square) / WIDTH;
    return q < 1.0 ? 105.0 / (16.0 * M_PI * pow(WIDTH, 3.0)) *
                         (1.0 - 6.0 * q * q + 8.0 * pow(q, 3.0) - 3.0 * pow(q, 4.0))
                   : 0.0;
}

static double density_at(const double at[3])
{
    double sum = 0.0;
    for (int g = 0; g < 3; g++) {
        sum += 2500.0 * 4.0 / 3.0 * M_PI * pow(GRAIN[g][3], 3.0) * kernel(at, GRAIN[g]);
    }
    return sum;
}

/** 1 N along a branch of 5.9 mm along x. */
static double stress_at(const double at[3])
{
    double sum = 0.0;
    for (int k = 0; k < PIECES; k++) {
        const double p[3] = {GRAIN[1][0] + 0.0059 * (k + 0.5) / PIECES, GRAIN[1][1],
                             GRAIN[1][2]};
        sum += kernel(at, p) / PIECES;
    }
    return 0.0059 * sum;
}

static hsize_t rows_of(hid_t file, const char *name)
{
    hsize_t found[2] = {0, 0};
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
    H5Sget_simple_extent_dims(space, found, NULL);
    H5Sclose(space);
    H5Dclose(set);
    return found[0];
}

static void close_to(double found, double expected, double scale)
{
    if (!(fabs(found - expected) <= 1e-5 * scale)) {
        print_error("%.9g, expected %.9g\n", found, expected);
        fail();
    }
}

static void the_file_has_closed_forms(void **folder)
{
    static float points[20000][8][3], density[20000], contact[20000][9], coordination[20000];
    double mass = 0.0, stress = 0.0;
    run(folder);
    const hid_t file = open_file(folder, "out/field_all.hdf");
    const hsize_t n = rows_of(file, "VTKHDF/CellData/density");
    assert_true(n > 200 && n < 20000);
    check_head(file);
    check_cells(file, (int64_t)n, 8, 11); // VTK_VOXEL
    read_reals(file, "VTKHDF/Points", 8 * n, 3, &points[0][0][0]);
    read_reals(file, "VTKHDF/CellData/density", n, 0, density);
    read_reals(file, "VTKHDF/CellData/contact_stress", n, 9, &contact[0][0]);
    read_reals(file, "VTKHDF/CellData/coordination", n, 0, coordination);
    H5Fclose(file);
    for (hsize_t c = 0; c < n; c++) {
        double at[3];
        for (int a = 0; a < 3; a++) { // the file has float32 points: whole cells
            at[a] = CELL * (rint((double)points[c][0][a] / CELL) + 0.5);
        }
        close_to((double)density[c], density_at(at), 100.0);
        close_to((double)contact[c][0], stress_at(at), 1e4);
        for (int k = 1; k < 9; k++) {
            close_to((double)contact[c][k], 0.0, 1e4);
        }
        if (at[0] < 0.03) { // only the grain alone is near
            assert_true(coordination[c] == 0.0F);
        }
        mass += (double)density[c] * CELL * CELL * CELL;
        stress += (double)contact[c][0] * CELL * CELL * CELL;
    }
    // sums over cells of a third of the width: the masses, and force times branch
    const double whole = 2500.0 * 4.0 / 3.0 * M_PI * (8e-9 + 2.0 * 27e-9);
    close_to(mass / whole, 1.0, 300.0); // 0.3 %
    close_to(stress / 0.0059, 1.0, 300.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(the_file_has_closed_forms, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
