#pragma once
/**
 * @file vtk_cells.h
 * What every unstructured grid of VTKHDF 1.0 has: its head, and cells that share no points.
 */

#include "output/hdf.h"

// datasets and groups of a grid
#define VTK_POINTS "VTKHDF/Points"
#define VTK_POINT_DATA "VTKHDF/PointData"
#define VTK_CELL_DATA "VTKHDF/CellData"
#define VTK_TYPES "VTKHDF/Types"
#define VTK_OFFSETS "VTKHDF/Offsets"
#define VTK_CONNECTIVITY "VTKHDF/Connectivity"
#define VTK_TIME "time_s" ///< attribute of the root, clod's own [s]
#define VTK_PARTS VTK_CELL_DATA "/part"
#define VTK_PARTS_NAMES "names" ///< attribute of it, clod's own: "WALL.PART", one a line

// cell types of VTK, vtkCellType.h
#define VTK_VERTEX 1
#define VTK_LINE 3
#define VTK_TRIANGLE 5
#define VTK_VOXEL 11

/** The group and its attributes. */
void clod_vtk_cells_head(clod_hdf *hdf);

/**
 * The cells: number c has the points c * corners ... c * corners + corners - 1.
 *
 * @param type  of all cells
 * Errors  CLOD_FAILED: memory; what the disk says is kept by `hdf`.
 * Threads one per file.   Test  tests/output/test_snapshot.c
 */
bool clod_vtk_cells_put(clod_hdf *hdf, size_t cells, uint8_t type, int64_t corners,
                        clod_status *status);
