// Files of the grids: the mean at the end, and frames beside snapshots.

#include <inttypes.h>
#include <limits.h>
#include <string.h>

#include "base/memory.h"
#include "measure/continuum_pass.h"
#include "output/hdf_series.h"
#include "output/voxels.h"
#include "output/vtk_cells.h"
#include "sim/fields.h"

/** Numbers of a cell in the file. */
typedef struct cell_row {
    double corner[3];
    double value[CLOD_CONTINUUM_NUMBERS];
} cell_row;

/** Whether a grain or a contact has ever reached a cell. */
static bool is_used(const double *sums)
{
    bool used = false;
    for (int k = 0; k < CLOD_CONTINUUM_SUMS; k++) {
        used = used || sums[k] != 0.0;
    }
    return used;
}

int64_t clod_fields_used(const clod_continuum *field, const double (*sums)[CLOD_CONTINUUM_SUMS])
{
    int64_t used = 0;
    for (int64_t p = 0; p < clod_continuum_points(field); p++) {
        used += is_used(sums[p]);
    }
    return used;
}

/** Write the rows; `corner` has room for those of all. */
static bool write_cells(const cell_row *rows, double (*corner)[3], size_t count,
                        const clod_case_field *field, const char *name,
                        const clod_free_moment *now, const clod_folder *folder,
                        clod_status *status)
{
    char dataset[CLOD_CONTINUUM_VALUES][64];
    clod_hdf_column columns[CLOD_CONTINUUM_VALUES];
    for (int v = 0; v < CLOD_CONTINUUM_VALUES; v++) {
        const clod_continuum_value *value = &CLOD_CONTINUUM_VALUE[v];
        snprintf(dataset[v], sizeof dataset[v], VTK_CELL_DATA "/%s", value->name);
        columns[v] = (clod_hdf_column){dataset[v],   value->unit,
                                       CLOD_HDF_F64, (size_t)value->components,
                                       count,        &rows->value[value->first],
                                       sizeof *rows};
    }
    for (size_t k = 0; k < count; k++) {
        memcpy(corner[k], rows[k].corner, sizeof *corner);
    }
    const clod_voxels voxels = {(const double(*)[3])corner,
                                count,
                                field->cell,
                                columns,
                                CLOD_CONTINUUM_VALUES,
                                now->state->step,
                                now->state->time};
    return clod_voxels_write(folder, name, &voxels, status);
}

/** Where a grid is written to. */
typedef struct grid_file {
    const clod_folder *folder;
    char name[NAME_MAX + 1];
} grid_file;

/** Name of a file: that of the part of a test, of the field, and what is behind them. */
static void name_file(char name[NAME_MAX + 1], const char *part, const clod_case_field *asked,
                      const char *behind)
{
    snprintf(name, NAME_MAX + 1, "%s%sfield_%s%s", part != NULL ? part : "",
             part != NULL ? "_" : "", asked->name, behind);
}

/** Write the cells that something has reached. */
static bool write_grid(const clod_case_field *asked, const double (*sums)[CLOD_CONTINUUM_SUMS],
                       double samples, const clod_free_moment *now, const grid_file *file,
                       clod_status *status)
{
    const clod_continuum field = clod_fields_make(asked);
    const size_t used = (size_t)clod_fields_used(&field, sums);
    cell_row *rows = clod_memory_alloc(used + 1, sizeof *rows);
    double(*corner)[3] = clod_memory_alloc(used + 1, sizeof *corner);
    bool good = rows != NULL && corner != NULL;
    size_t count = 0;
    for (int64_t p = 0; good && p < clod_continuum_points(&field); p++) {
        if (is_used(sums[p])) {
            clod_continuum_corner(&field, p, rows[count].corner);
            clod_continuum_values(&field, sums[p], samples, rows[count++].value);
        }
    }
    good = good ? write_cells(rows, corner, count, asked, file->name, now, file->folder, status)
                : clod_status_fail(status, CLOD_FAILED, "no memory for %s", file->name);
    clod_memory_free(rows);
    clod_memory_free(corner);
    return good;
}

bool clod_fields_write_part(const clod_frame *to, const void *memory,
                            const clod_free_moment *now, clod_status *status)
{
    bool good = true;
    for (size_t k = 0; good && k < now->from->field_count; k++) {
        const clod_case_field *asked = &now->from->fields[k];
        const double samples = (double)clod_fields_samples(clod_fields_memory(memory, k));
        grid_file file = {.folder = to->folder};
        name_file(file.name, to->part, asked, ".hdf");
        good = asked->cell == 0.0 || write_grid(asked, clod_fields_grid(memory, now->from, k),
                                                samples, now, &file, status);
    }
    return good;
}

bool clod_fields_write(const clod_folder *folder, const void *memory,
                       const clod_free_moment *now, clod_status *status)
{
    return clod_fields_write_part(&(clod_frame){.folder = folder}, memory, now, status);
}

// ---- frames

#define INDEX ".hdf.series" ///< of the list of a grid's frames

/** Frames that a run that was cut off had put there later go, with their files: before this one is
 *  written, which has the name of one of them. */
static bool cut_frames(const clod_field_memory *self, const clod_case_field *asked,
                       const clod_frame *frame, clod_status *status)
{
    char index[NAME_MAX + 1];
    name_file(index, frame->part, asked, INDEX);
    return self->frame_sum == 0 ||
           clod_hdf_series_cut(frame->folder, index, self->frame_time, status);
}

/** Put a frame into its series. */
static bool note_frame(clod_field_memory *self, const clod_case_field *asked,
                       const clod_free_moment *now, const clod_frame *frame, const char *file,
                       clod_status *status)
{
    char index[NAME_MAX + 1];
    name_file(index, frame->part, asked, INDEX);
    self->frame_time = now->state->time;
    return clod_hdf_series_add(frame->folder, index, file, now->state->time, &self->frame_sum,
                               status);
}

/** One grid as it is now. */
static bool write_frame(clod_field_memory *self, const clod_case_field *asked,
                        const clod_free_moment *now, const clod_frame *frame,
                        clod_status *status)
{
    const clod_continuum field = clod_fields_make(asked);
    double(*sums)[CLOD_CONTINUUM_SUMS] =
        clod_memory_alloc((size_t)clod_continuum_points(&field), sizeof *sums);
    if (sums == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a frame of fields.%s",
                                asked->name);
    }
    grid_file file = {.folder = frame->folder};
    char behind[40];
    snprintf(behind, sizeof behind, "-%06" PRId64 ".hdf", frame->number);
    name_file(file.name, frame->part, asked, behind);
    const clod_continuum_part part = {&field, sums};
    const bool good = clod_continuum_pass(&part, 1, now->survey, status) &&
                      cut_frames(self, asked, frame, status) &&
                      write_grid(asked, (const double(*)[CLOD_CONTINUUM_SUMS])sums, 1.0, now,
                                 &file, status) &&
                      note_frame(self, asked, now, frame, file.name, status);
    clod_memory_free(sums);
    return good;
}

bool clod_fields_picture(void *memory, const clod_free_moment *now, const clod_frame *frame,
                         clod_status *status)
{
    clod_field_memory *self = memory;
    bool good = true;
    for (size_t k = 0; good && k < now->from->field_count; k++) {
        const clod_case_field *asked = &now->from->fields[k];
        good = !asked->frames || write_frame(&self[k], asked, now, frame, status);
    }
    return good;
}
