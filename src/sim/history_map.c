#include "sim/history_map.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/cell_count.h"
#include "base/memory.h"
#include "output/voxels.h"
#include "output/vtk_cells.h"

#define AT_A_TIME 256 // contacts

/** A sum of forces in whole and small parts of a newton: in any order the same. */
typedef struct force_sum {
    int64_t whole; ///< N
    int64_t small; ///< 2^-40 N, less than 1 N
} force_sum;
#define SMALL_BITS 40

/** What the contacts of a cell remembered, over all samples of the steady time. */
typedef struct map_cell {
    int64_t contacts;
    force_sum pull_off, pressed;
    double most_pull_off, most_pressed; ///< N
} map_cell;

typedef struct history_map {
    int64_t samples;
    map_cell cell[]; ///< x fastest
} history_map;

/** The grid of a case. */
typedef struct map_grid {
    double low[3], edge; ///< m
    int64_t cells[3];
} map_grid;

static map_grid grid_of(const clod_case *from)
{
    const clod_case_history_map *map = &from->history_map;
    const double *low = map->has_region ? map->region.min : from->domain_min;
    const double *high = map->has_region ? map->region.max : from->domain_max;
    map_grid grid = {.edge = map->cell};
    for (int a = 0; a < 3; a++) {
        grid.low[a] = low[a];
        grid.cells[a] = (int64_t)clod_cell_count(high[a] - low[a], map->cell);
    }
    return grid;
}

static int64_t cells_of(const map_grid *grid)
{
    return grid->cells[0] * grid->cells[1] * grid->cells[2];
}

static size_t map_size(const clod_case *from)
{
    const map_grid grid = from->history_map.present ? grid_of(from) : (map_grid){0};
    return from->history_map.present
               ? sizeof(history_map) + (size_t)cells_of(&grid) * sizeof(map_cell)
               : 0;
}

static void add_force(force_sum *to, double force)
{
    const double whole = floor(force);
    to->whole += (int64_t)whole;
    to->small += (int64_t)ldexp(force - whole, SMALL_BITS);
    to->whole += to->small >> SMALL_BITS;
    to->small &= ((int64_t)1 << SMALL_BITS) - 1;
}

static double force_of(const force_sum *sum)
{
    return (double)sum->whole + ldexp((double)sum->small, -SMALL_BITS);
}

/** Coordinate of a contact, seen from the grain with the smaller id, within the domain [m]. */
static double position_along(const clod_domain *domain, int axis, const double a[4],
                             const double b[4])
{
    const double way = clod_domain_separation(domain, axis, b[axis], a[axis]);
    const double position = a[axis] + way * (a[3] / (a[3] + b[3]));
    const double low = domain->min[axis], high = domain->max[axis];
    if (domain->periodic[axis] && (position < low || position >= high)) {
        return position < low ? position + (high - low) : position - (high - low);
    }
    return position;
}

/** Cell of a contact; NULL: outside. */
static map_cell *cell_of(history_map *self, const map_grid *grid, const clod_state *state,
                         const clod_contact *contact)
{
    const clod_grains *grains = &state->grains;
    const bool rises = grains->id[contact->i] < grains->id[contact->j];
    const double *a = grains->position[rises ? contact->i : contact->j];
    const double *b = grains->position[rises ? contact->j : contact->i];
    int64_t at[3];
    for (int c = 0; c < 3; c++) {
        const double position = position_along(&state->domain, c, a, b);
        const double k = floor((position - grid->low[c]) / grid->edge);
        if (!(k >= 0.0 && k < (double)grid->cells[c])) {
            return NULL;
        }
        at[c] = (int64_t)k;
    }
    return &self->cell[(at[2] * grid->cells[1] + at[1]) * grid->cells[0] + at[0]];
}

static void add_contact(map_cell *cell, clod_contact_strength strength)
{
    cell->contacts++;
    add_force(&cell->pull_off, strength.pull_off);
    add_force(&cell->pressed, strength.pressed);
    cell->most_pull_off = fmax(cell->most_pull_off, strength.pull_off);
    cell->most_pressed = fmax(cell->most_pressed, strength.pressed);
}

/** The strength of each contact is asked of all of them in a row. */
static void map_sight(const void *memory, const clod_free_moment *now, clod_sight *sees)
{
    (void)memory;
    sees->whole |= now->from->history_map.present && now->row &&
                   clod_steady_time_block(&now->steady, now->state->time) >= 0;
}

static bool map_look(void *memory, const clod_free_moment *now, clod_status *status)
{
    (void)status;
    history_map *self = memory;
    if (!now->from->history_map.present || now->survey->contacts->strength == NULL ||
        clod_steady_time_block(&now->steady, now->state->time) < 0) {
        return true;
    }
    const map_grid grid = grid_of(now->from);
    const clod_contact_source *contacts = now->survey->contacts;
    clod_contact some[AT_A_TIME];
    size_t pairs, walls, count;
    self->samples++;
    contacts->begin(contacts->context, &pairs, &walls);
    do {
        count = contacts->next(contacts->context, some, AT_A_TIME);
        for (size_t k = 0; k < count && some[k].shape < 0; k++) {
            map_cell *cell = cell_of(self, &grid, now->state, &some[k]);
            if (cell != NULL) {
                add_contact(cell, contacts->strength(contacts->laws, &some[k]));
            }
        }
    } while (count == AT_A_TIME && some[AT_A_TIME - 1].shape < 0);
    return true;
}

// ---- report, summary, file

/** Cells that ever had a contact. */
static size_t used_cells(const history_map *self, const map_grid *grid)
{
    size_t used = 0;
    for (int64_t k = 0; k < cells_of(grid); k++) {
        used += self->cell[k].contacts > 0;
    }
    return used;
}

/** The cell with the strongest contact; NULL: there was none. */
static const map_cell *strongest(const history_map *self, const map_grid *grid)
{
    const map_cell *best = NULL;
    for (int64_t k = 0; k < cells_of(grid); k++) {
        const map_cell *cell = &self->cell[k];
        if (cell->contacts > 0 && (best == NULL || cell->most_pressed > best->most_pressed)) {
            best = cell;
        }
    }
    return best;
}

static void corner_of(const map_grid *grid, int64_t k, double corner[3])
{
    for (int a = 0; a < 3; a++) {
        corner[a] = grid->low[a] + grid->edge * (double)(k % grid->cells[a]);
        k /= grid->cells[a];
    }
}

static void map_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    const history_map *self = memory;
    if (!now->from->history_map.present) {
        return;
    }
    const map_grid grid = grid_of(now->from);
    const map_cell *best = strongest(self, &grid);
    fprintf(out, "  history map           %zu of %" PRId64 " cells had contacts",
            used_cells(self, &grid), cells_of(&grid));
    if (best != NULL) {
        double corner[3];
        corner_of(&grid, best - self->cell, corner);
        fprintf(out,
                "; pressed most, %.4g N, in the one at (%.4g, %.4g, %.4g) m, which pulls with "
                "up to %.4g N",
                best->most_pressed, corner[0] + 0.5 * grid.edge, corner[1] + 0.5 * grid.edge,
                corner[2] + 0.5 * grid.edge, best->most_pull_off);
    }
    fputs(" (history_map.hdf)\n", out);
}

static json_t *map_json(const void *memory, const clod_free_moment *now)
{
    const history_map *self = memory;
    if (!now->from->history_map.present) {
        return NULL;
    }
    const map_grid grid = grid_of(now->from);
    const map_cell *best = strongest(self, &grid);
    json_t *object = json_pack("{s:f, s:I, s:I, s:I, s:f}", "since_s", now->steady.since,
                               "cells", (json_int_t)cells_of(&grid), "used_cells",
                               (json_int_t)used_cells(self, &grid), "samples",
                               (json_int_t)self->samples, "cell_m", grid.edge);
    if (best != NULL) {
        double corner[3];
        corner_of(&grid, best - self->cell, corner);
        json_object_set_new(object, "strongest",
                            json_pack("{s:[fff], s:f, s:f}", "corner_m", corner[0], corner[1],
                                      corner[2], "largest_past_force_N", best->most_pressed,
                                      "largest_pull_off_N", best->most_pull_off));
    }
    return object;
}

/** Numbers of a cell in the file. */
typedef struct cell_row {
    double corner[3];
    double contacts; ///< mean of a sample
    double mean_pressed, most_pressed, mean_pull_off, most_pull_off;
} cell_row;

static cell_row row_of(const history_map *self, const map_grid *grid, int64_t k)
{
    const map_cell *cell = &self->cell[k];
    const double count = (double)cell->contacts;
    cell_row row = {.contacts = count / (double)self->samples,
                    .mean_pressed = force_of(&cell->pressed) / count,
                    .most_pressed = cell->most_pressed,
                    .mean_pull_off = force_of(&cell->pull_off) / count,
                    .most_pull_off = cell->most_pull_off};
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
    const map_grid grid = grid_of(now->from);
    const size_t used = used_cells(self, &grid);
    cell_row *rows = clod_memory_alloc(used + 1, sizeof *rows);
    double(*corner)[3] = clod_memory_alloc(used + 1, sizeof *corner);
    bool good = rows != NULL && corner != NULL;
    size_t count = 0;
    for (int64_t k = 0; good && k < cells_of(&grid); k++) {
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
                                                    .sight = map_sight,
                                                    .look = map_look,
                                                    .report = map_report,
                                                    .json = map_json,
                                                    .write = map_files};
