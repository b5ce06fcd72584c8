#include "output/vtk_cells.h"

#include "base/memory.h"

/** The numbers 0, step, 2 step, ... */
static bool put_multiples(clod_hdf *hdf, const char *name, size_t rows, int64_t step,
                          clod_status *status)
{
    const size_t most = rows < CLOD_HDF_SLAB ? rows : CLOD_HDF_SLAB;
    int64_t *numbers = clod_memory_alloc(most + 1, sizeof *numbers);
    if (numbers == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for a snapshot.");
    }
    clod_hdf_column column = {name, NULL, CLOD_HDF_I64, 1, rows, numbers, sizeof *numbers};
    clod_hdf_make(hdf, &column);
    for (size_t first = 0; first < rows; first += column.rows) {
        column.rows = rows - first < most ? rows - first : most;
        for (size_t r = 0; r < column.rows; r++) {
            numbers[r] = (int64_t)(first + r) * step;
        }
        clod_hdf_put_rows(hdf, &column, first);
    }
    clod_memory_free(numbers);
    return true;
}

bool clod_vtk_cells_put(clod_hdf *hdf, size_t cells, uint8_t type, int64_t corners,
                        clod_status *status)
{
    const size_t points = cells * (size_t)corners;
    const int64_t sizes[3] = {(int64_t)points, (int64_t)cells, (int64_t)points};
    const clod_hdf_column columns[] = {
        {"VTKHDF/NumberOfPoints", NULL, CLOD_HDF_I64, 1, 1, &sizes[0], 8},
        {"VTKHDF/NumberOfCells", NULL, CLOD_HDF_I64, 1, 1, &sizes[1], 8},
        {"VTKHDF/NumberOfConnectivityIds", NULL, CLOD_HDF_I64, 1, 1, &sizes[2], 8},
        {VTK_TYPES, NULL, CLOD_HDF_U8, 1, cells, &type, 0}, // all of one type
    };
    for (size_t k = 0; k < sizeof columns / sizeof *columns; k++) {
        clod_hdf_put(hdf, &columns[k]);
    }
    return put_multiples(hdf, VTK_CONNECTIVITY, points, 1, status) &&
           put_multiples(hdf, VTK_OFFSETS, cells + 1, corners, status);
}

void clod_vtk_cells_head(clod_hdf *hdf)
{
    const int64_t version[2] = {1, 0};
    clod_hdf_group(hdf, "VTKHDF");
    clod_hdf_put_ints(hdf, "VTKHDF", "Version", version, 2);
    clod_hdf_put_text(hdf, "VTKHDF", "Type", "UnstructuredGrid");
}
