#include "step/wall_cells.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"
#include "state/limits.h"
#include "step/cells.h"
#include "step/wall_mesh.h"

// ---- which shapes are near which cells

/** Size of a cell along an axis [m]. */
static double width_of(const clod_cells_grid *grid, int axis)
{
    return grid->inverse_width[axis] > 0.0 ? 1.0 / grid->inverse_width[axis] : 0.0;
}

/** Whether a shape may be within `reach` of a grain whose centre is in a cell: the cell's centre
 *  decides. */
static bool cell_is_near(const clod_wall_rows *rows, const clod_wall_entry *shape,
                         const clod_cells_grid *grid, const int32_t at[3], double reach)
{
    double centre[3], diagonal2 = 0.0;
    for (int a = 0; a < 3; a++) {
        const double width = width_of(grid, a);
        centre[a] = grid->min[a] + ((double)at[a] + 0.5) * width;
        diagonal2 += width * width;
    }
    const double half = 0.5 * sqrt(diagonal2) * (1.0 + 1e-6); // and rounding of cells' borders
    return clod_wall_rows_may_reach(rows, shape->wall, shape->shape, centre, half, reach);
}

/** Cells that the box about a shape reaches; false: none. */
static bool cells_of(const clod_wall_rows *rows, const clod_wall_entry *shape,
                     const clod_cells_grid *grid, double reach, int32_t first[3],
                     int32_t last[3])
{
    double low[3], high[3];
    clod_wall_rows_box(rows, shape->wall, shape->shape, low, high);
    for (int a = 0; a < 3; a++) {
        const double slack = reach + 1e-6 * width_of(grid, a);
        const double end = grid->min[a] + grid->n[a] * width_of(grid, a);
        if (low[a] - slack > end || high[a] + slack < grid->min[a]) {
            return false;
        }
        first[a] = clod_cells_along(grid, a, low[a] - slack);
        last[a] = clod_cells_along(grid, a, high[a] + slack);
    }
    return true;
}

/** Note a shape for every cell in which a grain may be near it. */
static bool enter_shape(clod_wall_cells *self, const clod_wall_rows *rows,
                        const clod_wall_entry *shape, const clod_cells_grid *grid, double reach)
{
    int32_t first[3], last[3], at[3];
    if (!cells_of(rows, shape, grid, reach, first, last)) {
        return true;
    }
    for (at[2] = first[2]; at[2] <= last[2]; at[2]++) {
        for (at[1] = first[1]; at[1] <= last[1]; at[1]++) {
            for (at[0] = first[0]; at[0] <= last[0]; at[0]++) {
                if (!cell_is_near(rows, shape, grid, at, reach)) {
                    continue;
                }
                if (!clod_room_for_one(&self->entry, &self->entry_capacity, self->count,
                                       sizeof *self->entry)) {
                    return false;
                }
                clod_wall_entry *entry = &self->entry[self->count++];
                *entry = *shape;
                entry->cell = (at[2] * grid->n[1] + at[1]) * grid->n[0] + at[0];
            }
        }
    }
    return true;
}

/** All shapes, in ascending order, and then by cell: a counting sort keeps that order. */
bool clod_wall_cells_fill(clod_neighbour *search, const clod_state *state)
{
    clod_wall_cells *self = &search->wall_cells;
    const clod_walls *walls = &state->walls;
    const clod_wall_rows *rows = &search->build_rows;
    const clod_cells_grid *grid = &search->grid;
    const double reach = search->radius_max + search->skin;
    self->count = 0;
    if (walls->count == 0) {
        return true;
    }
    for (int32_t w = 0; w < walls->count; w++) {
        for (int32_t s = 0; s < walls->wall[w].shape_count; s++) {
            const clod_wall_entry shape = {.wall = w, .shape = s};
            const bool removes = walls->wall[w].shapes[s].outlet > 0; // it pushes no grain
            if (removes || clod_wall_rows_patch(rows, w, s)->slot > 0) {
                continue; // what finds a patch finds its slots
            }
            if (!enter_shape(self, rows, &shape, grid, reach)) {
                return false;
            }
        }
    }
    const size_t cells = (size_t)grid->n[0] * (size_t)grid->n[1] * (size_t)grid->n[2];
    if (!clod_room_for(&self->start, &self->start_capacity, cells + 2, sizeof *self->start) ||
        !clod_room_for(&self->sorted, &self->sorted_capacity, self->count + 1,
                       sizeof *self->sorted)) {
        return false;
    }
    memset(self->start, 0, (cells + 2) * sizeof *self->start);
    for (size_t k = 0; k < self->count; k++) {
        self->start[self->entry[k].cell + 2]++;
    }
    for (size_t c = 0; c < cells; c++) {
        self->start[c + 2] += self->start[c + 1];
    }
    for (size_t k = 0; k < self->count; k++) { // afterwards start[c] is where cell c begins
        self->sorted[self->start[self->entry[k].cell + 1]++] = self->entry[k];
    }
    return true;
}

// ---- which shapes are near which grains

/** Add a grain and a shape to the candidates if they are within the skin. */
static bool try_shape(const clod_neighbour *self, const clod_state *state,
                      const clod_laws *laws, size_t g, const clod_wall_entry *shape,
                      clod_wall_candidates *to)
{
    const double *p = clod_neighbour_places(self, state)[g];
    const double reach = p[3] + self->skin;
    const clod_wall_rows *rows = &self->build_rows;
    if (clod_wall_rows_patch(rows, shape->wall, shape->shape)->surface != NULL) {
        const int32_t first = clod_wall_mesh_first(rows, shape->wall, shape->shape);
        const clod_wall_mesh_place at = {g, shape->wall, first};
        return clod_wall_mesh_find(self, state, laws, at, to);
    }
    const bool removes = state->walls.wall[shape->wall].shapes[shape->shape].outlet > 0;
    if (removes || !clod_wall_rows_is_near(rows, shape->wall, shape->shape, p, reach)) {
        return true;
    }
    if (to->count == CLOD_LIMITS_WALL_PAIRS ||
        !clod_room_for_one(&to->item, &to->capacity, to->count, sizeof *to->item)) {
        return false;
    }
    const int32_t law =
        clod_laws_index(laws, state->grains.material[g],
                        clod_wall_material(&state->walls.wall[shape->wall], shape->shape));
    to->item[to->count++] = (clod_wall_candidate){
        .i = (int32_t)g, .wall = shape->wall, .shape = shape->shape, .law = law};
    return true;
}

/** Whether an entry is of the mesh of the one before: all its patches have been tried. */
static bool is_known(const clod_neighbour *self, const clod_wall_entry *before,
                     const clod_wall_entry *entry)
{
    const clod_wall_rows *rows = &self->build_rows;
    return before != NULL && before->wall == entry->wall &&
           clod_wall_rows_patch(rows, entry->wall, entry->shape)->surface != NULL &&
           clod_wall_mesh_first(rows, before->wall, before->shape) ==
               clod_wall_mesh_first(rows, entry->wall, entry->shape);
}

bool clod_wall_cells_find(const clod_neighbour *self, const clod_state *state,
                          const clod_laws *laws, clod_chunk grains, clod_wall_candidates *to)
{
    const clod_wall_cells *cells = &self->wall_cells;
    if (cells->count == 0) {
        return true;
    }
    const double(*place)[4] = clod_neighbour_places(self, state);
    for (size_t g = grains.begin; g < grains.end; g++) {
        const int32_t cell = clod_cells_at(&self->grid, place[g]);
        const clod_wall_entry *before = NULL;
        for (size_t k = cells->start[cell]; k < cells->start[cell + 1]; k++) {
            const clod_wall_entry *entry = &cells->sorted[k];
            if (!is_known(self, before, entry) && !try_shape(self, state, laws, g, entry, to)) {
                return false;
            }
            before = entry;
        }
    }
    return true;
}

bool clod_wall_cells_find_all(const clod_neighbour *self, const clod_state *state,
                              const clod_laws *laws, clod_chunk grains,
                              clod_wall_candidates *to)
{
    for (size_t g = grains.begin; g < grains.end; g++) {
        for (int32_t w = 0; w < state->walls.count; w++) {
            for (int32_t s = 0; s < state->walls.wall[w].shape_count; s++) {
                const clod_wall_entry shape = {.wall = w, .shape = s};
                const clod_wall_entry before = {.wall = w, .shape = s - 1};
                if (!is_known(self, s > 0 ? &before : NULL, &shape) &&
                    !try_shape(self, state, laws, g, &shape, to)) {
                    return false;
                }
            }
        }
    }
    return true;
}

void clod_wall_cells_fini(clod_wall_cells *self)
{
    clod_memory_free(self->entry);
    clod_memory_free(self->sorted);
    clod_memory_free(self->start);
    *self = (clod_wall_cells){0};
}
