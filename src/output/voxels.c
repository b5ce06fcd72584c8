#include "output/voxels.h"

#include "base/memory.h"
#include "output/folder_files.h"
#include "output/vtk_cells.h"

#define CORNERS 8

/** Corners of each cube, x fastest, as VTK counts those of a voxel; owned, NULL without memory. */
static double (*corners_of(const clod_voxels *self))[3]
{
    double(*at)[3] = clod_memory_alloc(CORNERS * self->count + 1, sizeof *at);
    for (size_t c = 0; at != NULL && c < CORNERS * self->count; c++) {
        const int bits = (int)(c % CORNERS);
        for (int a = 0; a < 3; a++) {
            at[c][a] = self->corner[c / CORNERS][a] + ((bits >> a) & 1 ? self->edge : 0.0);
        }
    }
    return at;
}

static bool put_voxels(clod_hdf *hdf, const clod_voxels *self, clod_status *status)
{
    double(*at)[3] = corners_of(self);
    if (at == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu cells of a map",
                                self->count);
    }
    const clod_hdf_column points = {VTK_POINTS, "m", CLOD_HDF_F64, 3, CORNERS * self->count, at,
                                    sizeof *at};
    clod_vtk_cells_head(hdf);
    clod_hdf_put_ints(hdf, "/", "step", &self->step, 1);
    clod_hdf_put_real(hdf, "/", VTK_TIME, self->time);
    clod_hdf_put(hdf, &points);
    for (size_t k = 0; k < self->column_count; k++) {
        clod_hdf_put(hdf, &self->columns[k]);
    }
    clod_memory_free(at);
    return clod_vtk_cells_put(hdf, self->count, VTK_VOXEL, CORNERS, status);
}

bool clod_voxels_write(const clod_folder *folder, const char *name, const clod_voxels *self,
                       clod_status *status)
{
    clod_folder_draft draft;
    if (!clod_folder_draft_begin(&draft, folder, name, status)) {
        return false;
    }
    const clod_hdf_place place = {folder, name, draft.descriptor, 0};
    clod_hdf *hdf = clod_hdf_create(&place, CLOD_HDF_PICTURE, status);
    bool good = hdf != NULL;
    if (good) {
        good = put_voxels(hdf, self, status);
        clod_status finishing; // an error before it is the one to tell
        uint64_t size;
        good = clod_hdf_finish(&hdf, &size, good ? status : &finishing) && good;
    }
    return clod_folder_draft_end(&draft, good, status);
}
