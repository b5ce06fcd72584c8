#include "report/field_slice.h"

#include <math.h>
#include <stdio.h>

#include "base/memory.h"
#include "picture/vtkhdf.h"

#define CORNERS 8       ///< points of a cell in the file, the least corner first
#define LEVEL 1e-6      ///< of gravity: a smaller part counts as none
#define ENOUGH_CELLS 3L ///< a plane is as high and wide, if there is one

/** What speaks for the plane across an axis, the first most; more is better. */
typedef struct merit {
    double of[4];
} merit;

static merit merit_of(const long cells[3], const double gravity[3], int across)
{
    static const double LAST[3] = {2.0, 3.0, 1.0}; // y, x, z
    const int one = (across + 1) % 3, other = (across + 2) % 3;
    const double g =
        sqrt(gravity[0] * gravity[0] + gravity[1] * gravity[1] + gravity[2] * gravity[2]);
    const double off = g > 0.0 ? fabs(gravity[across]) / g : 0.0;
    const bool wide = cells[one] >= ENOUGH_CELLS && cells[other] >= ENOUGH_CELLS;
    return (merit){
        {wide ? 1.0 : 0.0, off > LEVEL ? -off : 0.0, -(double)cells[across], LAST[across]}};
}

static bool is_better(const merit *self, const merit *other)
{
    for (int k = 0; k < 4; k++) {
        if (self->of[k] != other->of[k]) {
            return self->of[k] > other->of[k];
        }
    }
    return false;
}

/** Make columns and rows few enough. */
static void thin(clod_field_slice *self)
{
    for (self->stride = 1;; self->stride++) {
        const long from = self->stride / 2;
        self->columns = (size_t)((self->cells[self->right] - 1 - from) / self->stride + 1);
        self->rows = (size_t)((self->cells[self->up] - 1 - from) / self->stride + 1);
        if (self->columns * self->rows <= CLOD_FIELD_SLICE_MOST) {
            return;
        }
    }
}

void clod_field_slice_choose(clod_field_slice *self, const long cells[3],
                             const double gravity[3])
{
    *self = (clod_field_slice){0};
    merit best = merit_of(cells, gravity, 0);
    for (int a = 0; a < 3; a++) {
        const merit of = merit_of(cells, gravity, a);
        self->cells[a] = cells[a];
        if (is_better(&of, &best)) {
            best = of;
            self->across = a;
        }
    }
    const int n = self->across;
    self->right = n == 0 ? 1 : 0;
    self->up = n == 2 ? 1 : 2;
    if (fabs(gravity[self->right]) > fabs(gravity[self->up])) {
        const int kept = self->right;
        self->right = self->up;
        self->up = kept;
    }
    const double within = hypot(gravity[self->right], gravity[self->up]);
    self->gravity = within > 0.0 && fabs(gravity[n]) <= LEVEL * within;
    self->layer = (cells[n] - 1) / 2;
    thin(self);
}

double clod_field_slice_place(const clod_field_slice *self)
{
    return self->corner[self->across] + self->cell * ((double)self->layer + 0.5);
}

/** Number of the shown cell at a least corner; -1: none is; -2: that of no cell of the grid. */
static long cell_at(const clod_field_slice *self, const double corner[3])
{
    long at[3];
    for (int a = 0; a < 3; a++) {
        const double place = (corner[a] - self->corner[a]) / self->cell;
        at[a] = lround(fmin(fmax(place, -1.0), (double)self->cells[a]));
        if (!(fabs(place - (double)at[a]) < 0.01) || at[a] < 0 || at[a] >= self->cells[a]) {
            return -2;
        }
    }
    const long stride = self->stride, half = stride / 2;
    const long column = at[self->right], row = at[self->up];
    const bool shown =
        at[self->across] == self->layer && column % stride == half && row % stride == half;
    return shown ? row / stride * (long)self->columns + column / stride : -1;
}

/** Columns of the file, and the points. */
typedef struct source {
    double (*point)[3];
    double *density, *pressure, *velocity, *coordination;
} source;

static void drop(source *self)
{
    clod_memory_free(self->point);
    clod_memory_free(self->density);
    clod_memory_free(self->pressure);
    clod_memory_free(self->velocity);
    clod_memory_free(self->coordination);
}

/** Owned numbers; NULL: no such column, or no memory. */
static double *read_column(const clod_vtkhdf *file, const char *name, size_t components,
                           clod_status *status)
{
    const clod_vtkhdf_column *column = clod_vtkhdf_find(file, CLOD_VTKHDF_CELLS, name);
    if (column == NULL || column->components != components) {
        status->code = CLOD_USAGE;
        return NULL;
    }
    return clod_vtkhdf_read(file, CLOD_VTKHDF_CELLS, column, status);
}

static bool read_source(source *self, const clod_vtkhdf *file, clod_status *status)
{
    *self = (source){0};
    status->code = CLOD_USAGE;
    return file->rows[CLOD_VTKHDF_POINTS] == CORNERS * file->rows[CLOD_VTKHDF_CELLS] &&
           (self->point = clod_vtkhdf_points(file, status)) != NULL &&
           (self->density = read_column(file, "density", 1, status)) != NULL &&
           (self->pressure = read_column(file, "pressure", 1, status)) != NULL &&
           (self->velocity = read_column(file, "velocity", 3, status)) != NULL &&
           (self->coordination = read_column(file, "coordination", 1, status)) != NULL;
}

/** Take the cells of the plane; false: one is not of the grid. */
static bool fill(clod_field_slice *self, const source *from, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        const long at = cell_at(self, from->point[CORNERS * k]);
        if (at == -2) {
            return false;
        }
        if (at >= 0) {
            const double *v = from->velocity + 3 * k;
            self->value[CLOD_FIELD_SLICE_DENSITY][at] = from->density[k];
            self->value[CLOD_FIELD_SLICE_PRESSURE][at] = from->pressure[k];
            self->value[CLOD_FIELD_SLICE_SPEED][at] =
                sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            self->value[CLOD_FIELD_SLICE_COORDINATION][at] = from->coordination[k];
            self->value[CLOD_FIELD_SLICE_RIGHT][at] = v[self->right];
            self->value[CLOD_FIELD_SLICE_UP][at] = v[self->up];
        }
    }
    return true;
}

static bool make_room(clod_field_slice *self)
{
    const size_t count = self->columns * self->rows;
    bool good = true;
    for (int v = 0; v < CLOD_FIELD_SLICE_VALUES; v++) {
        self->value[v] = clod_memory_alloc(count, sizeof *self->value[v]);
        good = good && self->value[v] != NULL;
        for (size_t k = 0; good && k < count; k++) {
            self->value[v][k] = (double)NAN;
        }
    }
    return good;
}

/** The grid of the summary; false: it is not whole. */
static bool read_grid(clod_field_slice *self, const json_t *grid, const double gravity[3])
{
    const json_t *cells = json_object_get(grid, "cells");
    const json_t *corner = json_object_get(grid, "corner_m");
    long count[3];
    for (size_t a = 0; a < 3; a++) {
        count[a] = (long)json_integer_value(json_array_get(cells, a));
        if (count[a] < 1 || !json_is_number(json_array_get(corner, a))) {
            return false;
        }
    }
    clod_field_slice_choose(self, count, gravity);
    for (size_t a = 0; a < 3; a++) {
        self->corner[a] = json_number_value(json_array_get(corner, a));
    }
    self->cell = json_number_value(json_object_get(grid, "cell_m"));
    return self->cell > 0.0;
}

/** Say why; what HDF5 says of a snapshot does not fit. */
static bool fail(const char *path, clod_code code, clod_status *status)
{
    if (code == CLOD_FAILED) {
        return clod_status_fail(status, code, "No memory for the slice of %s.", path);
    }
    return clod_status_fail(status, CLOD_USAGE,
                            "%s is damaged, or is not the grid that summary.json tells of. "
                            "Remove it to have a page without it, or run the case again.",
                            path);
}

bool clod_field_slice_read(clod_field_slice *self, const json_t *grid, const double gravity[3],
                           const char *path, clod_status *status)
{
    clod_status why = {.code = CLOD_USAGE};
    source from = {0};
    *self = (clod_field_slice){0};
    clod_vtkhdf *file = read_grid(self, grid, gravity) ? clod_vtkhdf_open(path, &why) : NULL;
    bool good = file != NULL && read_source(&from, file, &why);
    if (good && !make_room(self)) {
        good = false;
        why.code = CLOD_FAILED;
    } else if (good) {
        good = fill(self, &from, file->rows[CLOD_VTKHDF_CELLS]);
        why.code = CLOD_USAGE;
    }
    drop(&from);
    clod_vtkhdf_close(&file);
    return good || fail(path, why.code, status);
}

bool clod_field_slice_shows(const clod_field_slice *self)
{
    for (size_t k = 0; k < self->columns * self->rows; k++) {
        if (isfinite(self->value[CLOD_FIELD_SLICE_DENSITY][k])) {
            return true;
        }
    }
    return false;
}

void clod_field_slice_fini(clod_field_slice *self)
{
    for (int v = 0; v < CLOD_FIELD_SLICE_VALUES; v++) {
        clod_memory_free(self->value[v]);
    }
    *self = (clod_field_slice){0};
}
