#include "sim/history_map.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/cell_count.h"
#include "base/memory.h"
#include "measure/strength_grid.h"
#include "output/voxels.h"
#include "output/vtk_cells.h"

/** Sums over all samples of the steady time. */
typedef struct history_map {
    int64_t samples;
    clod_strength_cell cell[]; ///< x fastest
} history_map;

static clod_strength_grid grid_of(const clod_case *from)
{
    const clod_case_history_map *map = &from->history_map;
    const double *low = map->has_region ? map->region.min : from->domain_min;
    const double *high = map->has_region ? map->region.max : from->domain_max;
    clod_strength_grid grid = {.edge = map->cell};
    for (int a = 0; a < 3; a++) {
        grid.low[a] = low[a];
        grid.cells[a] = (int64_t)clod_cell_count(high[a] - low[a], map->cell);
    }
    return grid;
}

static size_t map_size(const clod_case *from)
{
    const clod_strength_grid grid =
        from->history_map.present ? grid_of(from) : (clod_strength_grid){0};
    return from->history_map.present
               ? sizeof(history_map) +
                     (size_t)clod_strength_grid_cells(&grid) * sizeof(clod_strength_cell)
               : 0;
}

static bool map_look(void *memory, const clod_free_moment *now, clod_status *status)
{
    history_map *self = memory;
    if (!now->from->history_map.present || now->survey->contacts->strength == NULL ||
        clod_steady_time_block(&now->steady, now->state->time) < 0) {
        return true;
    }
    const clod_strength_grid grid = grid_of(now->from);
    self->samples++;
    return clod_strength_grid_add(&grid, now->survey, self->cell, status);
}

// ---- report, summary, file

/** Cells that ever had a contact. */
static size_t used_cells(const history_map *self, const clod_strength_grid *grid)
{
    size_t used = 0;
    for (int64_t k = 0; k < clod_strength_grid_cells(grid); k++) {
        used += self->cell[k].contacts > 0;
    }
    return used;
}

/** Largest past force of a cell's contacts [N]; below 0: it had none. */
static double force_of(const clod_strength_cell *cell)
{
    return cell->contacts > 0 ? cell->most_pressed : -1.0;
}

/** What a cell's contacts gained of past force, summed over the samples [N/s]; below 0: nothing. */
static double gain_of(const clod_strength_cell *cell)
{
    return cell->gaining > 0 ? clod_strength_force_value(&cell->pressed_gain) : -1.0;
}

/** The first cell with the largest value; NULL: none has one. */
static const clod_strength_cell *largest(const history_map *self,
                                         const clod_strength_grid *grid,
                                         double (*value)(const clod_strength_cell *))
{
    const clod_strength_cell *best = NULL;
    double most = -1.0;
    for (int64_t k = 0; k < clod_strength_grid_cells(grid); k++) {
        const double found = value(&self->cell[k]);
        if (found > most) {
            best = &self->cell[k];
            most = found;
        }
    }
    return best;
}

static void corner_of(const clod_strength_grid *grid, int64_t k, double corner[3])
{
    for (int a = 0; a < 3; a++) {
        corner[a] = grid->low[a] + grid->edge * (double)(k % grid->cells[a]);
        k /= grid->cells[a];
    }
}

/** Print the middle of a cell. */
static void put_middle(FILE *out, const clod_strength_grid *grid, int64_t k)
{
    double corner[3];
    corner_of(grid, k, corner);
    fprintf(out, "in the one at (%.4g, %.4g, %.4g) m", corner[0] + 0.5 * grid->edge,
            corner[1] + 0.5 * grid->edge, corner[2] + 0.5 * grid->edge);
}

/** Mean of a sample [N/s]. */
static double gained(const history_map *self, const clod_strength_force *sum)
{
    return clod_strength_force_value(sum) / (double)self->samples;
}

static void map_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    const history_map *self = memory;
    if (!now->from->history_map.present) {
        return;
    }
    const clod_strength_grid grid = grid_of(now->from);
    fprintf(out, "  history map           %zu of %" PRId64 " cells had contacts",
            used_cells(self, &grid), clod_strength_grid_cells(&grid));
    const clod_strength_cell *best = largest(self, &grid, force_of);
    if (best != NULL) {
        fprintf(out, "; pressed most, %.4g N, ", best->most_pressed);
        put_middle(out, &grid, best - self->cell);
        fprintf(out, ", which pulls with up to %.4g N", best->most_pull_off);
    }
    const clod_strength_cell *most = largest(self, &grid, gain_of);
    if (most != NULL) {
        fprintf(out, "; gains most, %.4g N/s of past force, ",
                gained(self, &most->pressed_gain));
        put_middle(out, &grid, most - self->cell);
    }
    fputs(" (history_map.hdf)\n", out);
}

static bool map_told(const clod_case *from)
{
    return from->history_map.present;
}

static void map_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)from;
    (void)state;
    clod_free_paths_add(paths, NULL,
                        "since_s cells used_cells samples cell_m strongest.corner_m.[0-2] "
                        "strongest.largest_past_force_N strongest.largest_pull_off_N "
                        "gains_most.corner_m.[0-2] gains_most.past_force_N_per_s "
                        "gains_most.pull_off_N_per_s");
}

static json_t *map_json(const void *memory, const clod_free_moment *now)
{
    const history_map *self = memory;
    const clod_strength_grid grid = grid_of(now->from);
    const clod_strength_cell *best = largest(self, &grid, force_of);
    json_t *object = json_pack("{s:f, s:I, s:I, s:I, s:f}", "since_s", now->steady.since,
                               "cells", (json_int_t)clod_strength_grid_cells(&grid),
                               "used_cells", (json_int_t)used_cells(self, &grid), "samples",
                               (json_int_t)self->samples, "cell_m", grid.edge);
    if (best != NULL) {
        double corner[3];
        corner_of(&grid, best - self->cell, corner);
        json_object_set_new(object, "strongest",
                            json_pack("{s:[fff], s:f, s:f}", "corner_m", corner[0], corner[1],
                                      corner[2], "largest_past_force_N", best->most_pressed,
                                      "largest_pull_off_N", best->most_pull_off));
    }
    const clod_strength_cell *most = largest(self, &grid, gain_of);
    if (most != NULL) {
        double corner[3];
        corner_of(&grid, most - self->cell, corner);
        json_object_set_new(object, "gains_most",
                            json_pack("{s:[fff], s:f, s:f}", "corner_m", corner[0], corner[1],
                                      corner[2], "past_force_N_per_s",
                                      gained(self, &most->pressed_gain), "pull_off_N_per_s",
                                      gained(self, &most->pull_off_gain)));
    }
    return object;
}

/** Numbers of a cell in the file. */
typedef struct cell_row {
    double corner[3];
    double contacts; ///< mean of a sample
    double mean_pressed, most_pressed, mean_pull_off, most_pull_off;
    double gaining;                     ///< contacts, mean of a sample
    double pressed_gain, pull_off_gain; ///< N/s, of all contacts of the cell, mean of a sample
} cell_row;

static cell_row row_of(const history_map *self, const clod_strength_grid *grid, int64_t k)
{
    const clod_strength_cell *cell = &self->cell[k];
    const double count = (double)cell->contacts;
    cell_row row = {.contacts = count / (double)self->samples,
                    .mean_pressed = clod_strength_force_value(&cell->pressed) / count,
                    .most_pressed = cell->most_pressed,
                    .mean_pull_off = clod_strength_force_value(&cell->pull_off) / count,
                    .most_pull_off = cell->most_pull_off,
                    .gaining = (double)cell->gaining / (double)self->samples,
                    .pressed_gain = gained(self, &cell->pressed_gain),
                    .pull_off_gain = gained(self, &cell->pull_off_gain)};
    corner_of(grid, k, row.corner);
    return row;
}

/** Write the rows; `corner` has room for those of all. */
static bool write_cells(const cell_row *rows, double (*corner)[3], size_t count, double edge,
                        const clod_free_moment *now, const clod_folder *folder,
                        clod_status *status)
{
    const size_t row = sizeof *rows;
#define COLUMN(name, unit, field)                                                              \
    {                                                                                          \
        VTK_CELL_DATA "/" name, unit, CLOD_HDF_F64, 1, count, &rows->field, row                \
    }
    const clod_hdf_column columns[] = {
        COLUMN("contacts", "1", contacts),
        COLUMN("mean_past_force", "N", mean_pressed),
        COLUMN("largest_past_force", "N", most_pressed),
        COLUMN("mean_pull_off", "N", mean_pull_off),
        COLUMN("largest_pull_off", "N", most_pull_off),
        COLUMN("gaining", "1", gaining),
        COLUMN("past_force_gain", "N/s", pressed_gain),
        COLUMN("pull_off_gain", "N/s", pull_off_gain),
    };
#undef COLUMN
    for (size_t k = 0; k < count; k++) {
        memcpy(corner[k], rows[k].corner, sizeof *corner);
    }
    const clod_voxels voxels = {(const double(*)[3])corner,
                                count,
                                edge,
                                columns,
                                sizeof columns / sizeof *columns,
                                now->state->step,
                                now->state->time};
    return clod_voxels_write(folder, "history_map.hdf", &voxels, status);
}

static bool map_files(const clod_folder *folder, const void *memory,
                      const clod_free_moment *now, clod_status *status)
{
    const history_map *self = memory;
    if (!now->from->history_map.present) {
        return true;
    }
    const clod_strength_grid grid = grid_of(now->from);
    const size_t used = used_cells(self, &grid);
    cell_row *rows = clod_memory_alloc(used + 1, sizeof *rows);
    double(*corner)[3] = clod_memory_alloc(used + 1, sizeof *corner);
    bool good = rows != NULL && corner != NULL;
    size_t count = 0;
    for (int64_t k = 0; good && k < clod_strength_grid_cells(&grid); k++) {
        if (self->cell[k].contacts > 0) {
            rows[count++] = row_of(self, &grid, k);
        }
    }
    good = good ? write_cells(rows, corner, count, grid.edge, now, folder, status)
                : clod_status_fail(status, CLOD_FAILED, "no memory for history_map.hdf");
    clod_memory_free(rows);
    clod_memory_free(corner);
    return good;
}

const clod_free_measure CLOD_MEASURE_HISTORY_MAP = {.key = "history_map",
                                                    .size = map_size,
                                                    .look = map_look,
                                                    .report = map_report,
                                                    .told = map_told,
                                                    .paths = map_paths,
                                                    .json = map_json,
                                                    .write = map_files};
