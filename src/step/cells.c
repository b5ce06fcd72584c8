#include "step/cells.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"

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
    const double(*place)[4] = clod_neighbour_places(self, state);
    for (size_t i = 0; i < state->grains.count; i++) {
        self->pairs.start[i] = (uint32_t)self->pairs.count;
        for (size_t j = i + 1; j < state->grains.count; j++) {
            if (within_skin(state, place[i], place[j], self->skin) &&
                !clod_neighbour_add(&self->pairs, j)) {
                return false;
            }
        }
    }
    self->pairs.start[state->grains.count] = (uint32_t)self->pairs.count;
    return true;
}

/** Extent of the grid along each axis. */
static void extent(const clod_neighbour *self, const clod_state *state, double min[3],
                   double max[3])
{
    const double(*place)[4] = clod_neighbour_places(self, state);
    for (int a = 0; a < 3; a++) {
        const bool periodic = state->domain.periodic[a];
        min[a] = periodic ? state->domain.min[a] : place[0][a];
        max[a] = periodic ? state->domain.max[a] : place[0][a];
        for (size_t g = 1; !periodic && g < state->grains.count; g++) {
            const double x = place[g][a]; // finite: no need of fmin
            min[a] = x < min[a] ? x : min[a];
            max[a] = x > max[a] ? x : max[a];
        }
    }
}

double clod_cells_most(size_t grains)
{
    return fmin(8.0 * (double)grains + 64.0, (double)(INT32_MAX - 1));
}

clod_cells_grid clod_cells_grid_of(const clod_neighbour *self, const clod_state *state)
{
    clod_cells_grid grid;
    double max[3];
    extent(self, state, grid.min, max);
    double width = 2.0 * self->radius_max + self->skin;
    const double most = clod_cells_most(state->grains.count);
    double cells = INFINITY;
    while (cells > most) {
        cells = 1.0;
        for (int a = 0; a < 3; a++) {
            const double length = max[a] - grid.min[a];
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

static size_t cells_of(const clod_cells_grid *grid)
{
    return (size_t)grid->n[0] * (size_t)grid->n[1] * (size_t)grid->n[2];
}

bool clod_cells_begin(clod_neighbour *self, size_t grains)
{
    const size_t cells = cells_of(&self->grid);
    if (cells + 1 > self->cell_capacity) {
        clod_memory_free(self->cell_start);
        clod_memory_free(self->cell_last);
        self->cell_capacity = cells + cells / 2 + 1;
        self->cell_start = clod_memory_alloc(self->cell_capacity, sizeof *self->cell_start);
        self->cell_last = clod_memory_alloc(self->cell_capacity, sizeof *self->cell_last);
        if (self->cell_start == NULL || self->cell_last == NULL) {
            self->cell_capacity = 0;
            return false;
        }
    }
    memset(self->cell_start, 0, (cells + 1) * sizeof *self->cell_start);
    memset(self->cell_last, -1, cells * sizeof *self->cell_last);
    self->place_stride = grains + CLOD_LANES; // a vector may read beyond the last grain
    return clod_room_for(&self->cell_place, &self->place_capacity, 4 * self->place_stride,
                         sizeof *self->cell_place);
}

/** Add to a number that other threads may add to; what it was. */
static int32_t add(int32_t *number, int32_t by, bool shared)
{
    if (shared) {
        return __atomic_fetch_add(number, by, __ATOMIC_RELAXED);
    }
    const int32_t was = *number;
    *number = was + by;
    return was;
}

/** Note a row of a cell, if it is the last one yet. */
static void note_row(int32_t *last, int32_t row, bool shared)
{
    if (!shared) {
        *last = row > *last ? row : *last;
        return;
    }
    int32_t was = __atomic_load_n(last, __ATOMIC_RELAXED);
    while (was < row && !__atomic_compare_exchange_n(last, &was, row, true, __ATOMIC_RELAXED,
                                                     __ATOMIC_RELAXED)) {
    }
}

void clod_cells_count(clod_neighbour *self, const clod_state *state, clod_chunk grains,
                      bool shared)
{
    const double(*place)[4] = clod_neighbour_places(self, state);
    for (size_t g = grains.begin; g < grains.end; g++) {
        self->cell_of[g] = clod_cells_at(&self->grid, place[g]);
        add(&self->cell_start[self->cell_of[g] + 1], 1, shared);
        note_row(&self->cell_last[self->cell_of[g]], (int32_t)g, shared);
    }
}

void clod_cells_add(clod_neighbour *self)
{
    const size_t cells = cells_of(&self->grid);
    for (size_t c = 0; c < cells; c++) {
        self->cell_start[c + 1] += self->cell_start[c];
    }
}

void clod_cells_enter(clod_neighbour *self, const clod_state *state, clod_chunk grains,
                      bool shared)
{
    const double(*place)[4] = clod_neighbour_places(self, state);
    for (size_t g = grains.end; g-- > grains.begin;) { // each cell is filled from behind
        int32_t *start = &self->cell_start[self->cell_of[g] + 1];
        const int32_t at = add(start, -1, shared) - 1;
        self->cell_item[at] = (int32_t)g;
        for (size_t c = 0; c < 4; c++) {
            self->cell_place[c * self->place_stride + (size_t)at] = place[g][c];
        }
    }
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

/** Runs of cells to look at along x, one behind the other in memory: at most two. */
static int around_x(const clod_cells_grid *grid, int32_t c, int32_t first[2], int32_t last[2])
{
    const int32_t n = grid->n[0];
    const bool whole = grid->periodic[0] && n <= 3;
    const bool wraps = grid->periodic[0] && !whole && (c == 0 || c == n - 1);
    first[0] = whole || c == 0 ? 0 : c - 1;
    last[0] = whole || c == n - 1 ? n - 1 : c + 1;
    first[1] = last[1] = c == 0 ? n - 1 : 0;
    return wraps ? 2 : 1;
}

/** Later partners of i among some grains. */
static bool search_run(const clod_neighbour *self, const clod_kernel_search *search,
                       const double p[4], size_t i, clod_chunk items, clod_pairs *to)
{
    int32_t found[64];
    for (size_t first = items.begin; first < items.end; first += 64) {
        const size_t left = items.end - first;
        const size_t rows =
            self->kernel->within(search, p, (int32_t)i, first, left < 64 ? left : 64, found);
        for (size_t k = 0; k < rows; k++) {
            if (!clod_neighbour_add(to, (size_t)found[k])) {
                return false;
            }
        }
    }
    return true;
}

/** Grains of the cells [first, last], which lie one behind the other, without cells at their ends
 *  that have no row beyond i. */
static clod_chunk items_of(const clod_neighbour *self, size_t grains, size_t i, int32_t first,
                           int32_t last)
{
    while (first <= last && self->cell_last[first] <= (int32_t)i) {
        first++;
    }
    if (first > last) {
        return (clod_chunk){0, 0};
    }
    while (self->cell_last[last] <= (int32_t)i) {
        last--;
    }
    const size_t next = (size_t)last + 1;
    return (clod_chunk){(size_t)self->cell_start[first + 1],
                        next == cells_of(&self->grid) ? grains
                                                      : (size_t)self->cell_start[next + 1]};
}

static clod_kernel_search search_of(const clod_neighbour *self, const clod_domain *domain)
{
    clod_kernel_search search = {.skin = self->skin, .row = self->cell_item};
    for (size_t c = 0; c < 4; c++) {
        search.place[c] = self->cell_place + c * self->place_stride;
    }
    for (int a = 0; a < 3; a++) {
        if (domain->periodic[a]) {
            search.period[a] = domain->max[a] - domain->min[a];
            search.inverse_period[a] = 1.0 / search.period[a];
        }
    }
    return search;
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

/** Later partners of i, in any order. */
static bool search_around(const clod_neighbour *self, const clod_state *state,
                          const clod_kernel_search *search, size_t i, clod_pairs *to)
{
    const clod_cells_grid *grid = &self->grid;
    const double *p = clod_neighbour_places(self, state)[i];
    int32_t first[2], last[2], y[3], z[3];
    const int nx = around_x(grid, clod_cells_along(grid, 0, p[0]), first, last);
    const int ny = around(grid, 1, clod_cells_along(grid, 1, p[1]), y);
    const int nz = around(grid, 2, clod_cells_along(grid, 2, p[2]), z);
    bool room = true;
    for (int c = 0; c < nz; c++) {
        for (int b = 0; b < ny; b++) {
            const int32_t line = (z[c] * grid->n[1] + y[b]) * grid->n[0];
            for (int a = 0; a < nx; a++) {
                const clod_chunk items =
                    items_of(self, state->grains.count, i, line + first[a], line + last[a]);
                room = room && search_run(self, search, p, i, items, to);
            }
        }
    }
    return room;
}

bool clod_cells_find_pairs(const clod_neighbour *self, const clod_state *state, size_t begin,
                           size_t end, clod_pairs *to)
{
    if (begin == end) { // without grains there are no places
        return true;
    }
    const clod_kernel_search search = search_of(self, &state->domain);
    for (size_t i = begin; i < end; i++) {
        const size_t first = to->count;
        to->start[i] = (uint32_t)first;
        if (!search_around(self, state, &search, i, to)) {
            return false;
        }
        order_tail(to, first);
    }
    return true;
}
