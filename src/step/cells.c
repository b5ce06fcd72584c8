#include "step/cells.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

static bool within_skin(const clod_state *state, const double a[4], const double b[4],
                        double skin)
{
    const double x = clod_domain_separation(&state->domain, 0, a[0], b[0]);
    const double y = clod_domain_separation(&state->domain, 1, a[1], b[1]);
    const double z = clod_domain_separation(&state->domain, 2, a[2], b[2]);
    const double reach = a[3] + b[3] + skin;
    return x * x + y * y + z * z < reach * reach;
}

bool clod_cells_all_pairs(clod_neighbour *self, const clod_state *state)
{
    for (size_t i = 0; i < state->grains.count; i++) {
        self->pairs.start[i] = (uint32_t)self->pairs.count;
        for (size_t j = i + 1; j < state->grains.count; j++) {
            if (within_skin(state, state->build_position[i], state->build_position[j],
                            self->skin) &&
                !clod_neighbour_add(&self->pairs, j)) {
                return false;
            }
        }
    }
    self->pairs.start[state->grains.count] = (uint32_t)self->pairs.count;
    return true;
}

/** Extent of the grid along one axis. */
static void extent(const clod_state *state, int axis, double *min, double *max)
{
    if (state->domain.periodic[axis]) {
        *min = state->domain.min[axis];
        *max = state->domain.max[axis];
        return;
    }
    *min = INFINITY;
    *max = -INFINITY;
    for (size_t g = 0; g < state->grains.count; g++) {
        *min = fmin(*min, state->build_position[g][axis]);
        *max = fmax(*max, state->build_position[g][axis]);
    }
}

double clod_cells_most(size_t grains)
{
    return fmin(8.0 * (double)grains + 64.0, (double)(INT32_MAX - 1));
}

clod_cells_grid clod_cells_grid_of(const clod_neighbour *self, const clod_state *state)
{
    clod_cells_grid grid;
    double width = 2.0 * self->radius_max + self->skin;
    const double most = clod_cells_most(state->grains.count);
    double cells = INFINITY;
    while (cells > most) {
        cells = 1.0;
        for (int a = 0; a < 3; a++) {
            double max;
            extent(state, a, &grid.min[a], &max);
            const double length = max - grid.min[a];
            const double n = fmin(fmax(floor(length / width), 1.0), 1e6);
            grid.n[a] = (int32_t)n;
            grid.inverse_width[a] = length > 0.0 ? n / length : 0.0;
            grid.periodic[a] = state->domain.periodic[a];
            cells *= n;
        }
        width *= 1.26; // twice the volume
    }
    return grid;
}

/** Grains by cell, in ascending order within each (a counting sort is stable). */
bool clod_cells_fill(clod_neighbour *self, const clod_state *state)
{
    const clod_cells_grid *grid = &self->grid;
    const size_t grains = state->grains.count;
    const size_t cells = (size_t)grid->n[0] * (size_t)grid->n[1] * (size_t)grid->n[2];
    if (cells + 1 > self->cell_capacity) {
        clod_memory_free(self->cell_start);
        self->cell_capacity = cells + cells / 2 + 1;
        self->cell_start = clod_memory_alloc(self->cell_capacity, sizeof *self->cell_start);
        if (self->cell_start == NULL) {
            self->cell_capacity = 0;
            return false;
        }
    }
    memset(self->cell_start, 0, (cells + 1) * sizeof *self->cell_start);
    for (size_t g = 0; g < grains; g++) {
        const double *p = state->build_position[g];
        const int32_t x = clod_cells_along(grid, 0, p[0]);
        const int32_t y = clod_cells_along(grid, 1, p[1]);
        const int32_t z = clod_cells_along(grid, 2, p[2]);
        self->cell_of[g] = (z * grid->n[1] + y) * grid->n[0] + x;
        self->cell_start[self->cell_of[g] + 1]++;
    }
    for (size_t c = 0; c < cells; c++) {
        self->cell_start[c + 1] += self->cell_start[c];
    }
    for (size_t g = grains;
         g-- > 0;) { // from behind: afterwards start[c + 1] is the start of c
        self->cell_item[--self->cell_start[self->cell_of[g] + 1]] = (int32_t)g;
    }
    return true;
}

/** Cells to look at along one axis: up to three, none twice. */
static int around(const clod_cells_grid *grid, int axis, int32_t c, int32_t out[3])
{
    const int32_t n = grid->n[axis];
    int count = 0;
    for (int32_t d = -1; d <= 1; d++) {
        int32_t at = c + d;
        if (grid->periodic[axis]) {
            at = (at + n) % n;
        } else if (at < 0 || at >= n) {
            continue;
        }
        bool seen = false;
        for (int k = 0; k < count; k++) {
            seen |= out[k] == at;
        }
        if (!seen) {
            out[count++] = at;
        }
    }
    return count;
}

/** Later partners of i in one cell. */
static bool search_cell(const clod_neighbour *self, const clod_state *state, size_t i,
                        int32_t cell, size_t cells, clod_pairs *to)
{
    const int32_t begin = self->cell_start[cell + 1];
    const int32_t end =
        (size_t)cell + 1 == cells ? (int32_t)state->grains.count : self->cell_start[cell + 2];
    for (int32_t k = begin; k < end; k++) {
        const size_t j = (size_t)self->cell_item[k];
        if (j > i &&
            within_skin(state, state->build_position[i], state->build_position[j],
                        self->skin) &&
            !clod_neighbour_add(to, j)) {
            return false;
        }
    }
    return true;
}

/** Put the candidates from `first` on into ascending j; a handful of items. */
static void order_tail(clod_pairs *self, size_t first)
{
    for (size_t k = first + 1; k < self->count; k++) {
        const clod_partner moving = self->item[k];
        size_t at = k;
        while (at > first && self->item[at - 1].j > moving.j) {
            self->item[at] = self->item[at - 1];
            at--;
        }
        self->item[at] = moving;
    }
}

bool clod_cells_find_pairs(const clod_neighbour *self, const clod_state *state, size_t begin,
                           size_t end, clod_pairs *to)
{
    const clod_cells_grid *grid = &self->grid;
    const size_t cells = (size_t)grid->n[0] * (size_t)grid->n[1] * (size_t)grid->n[2];
    for (size_t i = begin; i < end; i++) {
        const size_t first = to->count;
        to->start[i] = (uint32_t)first;
        int32_t x[3], y[3], z[3];
        const double *p = state->build_position[i];
        const int nx = around(grid, 0, clod_cells_along(grid, 0, p[0]), x);
        const int ny = around(grid, 1, clod_cells_along(grid, 1, p[1]), y);
        const int nz = around(grid, 2, clod_cells_along(grid, 2, p[2]), z);
        for (int c = 0; c < nx * ny * nz; c++) {
            const int32_t cell =
                (z[c / (nx * ny)] * grid->n[1] + y[c / nx % ny]) * grid->n[0] + x[c % nx];
            if (!search_cell(self, state, i, cell, cells, to)) {
                return false;
            }
        }
        order_tail(to, first);
    }
    return true;
}
