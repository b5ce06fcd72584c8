#include "setup/insertion_grid.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"

/** Cells that spheres touch on average, at most, as far as room is made ahead. */
#define NOTES_MOST 8.0

/** Cells first to last that a sphere touches in each direction. */
typedef struct clod_insertion_range {
    int32_t first[3], last[3];
} clod_insertion_range;

/** Room for what is expected, so that nothing is copied while it grows; unused pages take no memory. */
static bool reserve(clod_insertion_grid *self, size_t spheres)
{
    double cells = 1.0; // that a sphere touches
    for (int a = 0; a < 3; a++) {
        cells *= 1.0 + 2.0 * self->largest * self->inverse[a];
    }
    const size_t notes = (size_t)((double)spheres * fmin(cells, NOTES_MOST));
    return clod_room_for(&self->sphere, &self->sphere_capacity, spheres,
                         sizeof *self->sphere) &&
           clod_room_for(&self->note, &self->capacity, notes, sizeof *self->note);
}

bool clod_insertion_grid_begin(clod_insertion_grid *self, const double low[3],
                               const double high[3], const double period[3], double largest,
                               size_t spheres, clod_status *status)
{
    self->largest = largest;
    self->count = self->sphere_count = self->added = 0;
    double volume = 1.0;
    for (int a = 0; a < 3; a++) {
        volume *= high[a] - low[a];
    }
    const double edge = cbrt(volume / (double)(spheres + 1));
    size_t cells = 1;
    for (int a = 0; a < 3; a++) {
        const double wanted = (high[a] - low[a]) / edge;
        self->low[a] = low[a];
        self->high[a] = high[a];
        self->period[a] = period[a];
        self->cells[a] = (int32_t)fmin(fmax(wanted, 1.0), 1000.0);
        self->inverse[a] = self->cells[a] / (high[a] - low[a]);
        cells *= (size_t)self->cells[a];
    }
    if (!clod_room_for(&self->head, &self->head_capacity, cells, sizeof *self->head) ||
        !reserve(self, spheres)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory to insert grains");
    }
    memset(self->head, 0xff, cells * sizeof *self->head); // CLOD_INSERTION_NONE
    return true;
}

static int32_t cell_of(const clod_insertion_grid *self, int axis, double x)
{
    const double c = (x - self->low[axis]) * self->inverse[axis];
    return (int32_t)fmin(fmax(c, 0.0), self->cells[axis] - 1.0);
}

static clod_insertion_range range_of(const clod_insertion_grid *self, const double place[4])
{
    clod_insertion_range range;
    for (int a = 0; a < 3; a++) {
        range.first[a] = cell_of(self, a, place[a] - place[3]);
        range.last[a] = cell_of(self, a, place[a] + place[3]);
    }
    return range;
}

static bool apart(const double a[4], const double b[4])
{
    const double x = a[0] - b[0];
    const double y = a[1] - b[1];
    const double z = a[2] - b[2];
    const double reach = a[3] + b[3];
    return x * x + y * y + z * z >= reach * reach;
}

static size_t cell_index(const clod_insertion_grid *self, int32_t x, int32_t y, int32_t z)
{
    return ((size_t)z * (size_t)self->cells[1] + (size_t)y) * (size_t)self->cells[0] +
           (size_t)x;
}

static bool cell_clear(const clod_insertion_grid *self, size_t cell, const double place[4])
{
    for (uint32_t n = self->head[cell]; n != CLOD_INSERTION_NONE; n = self->note[n].next) {
        if (!apart(place, self->sphere[self->note[n].sphere].place)) {
            return false;
        }
    }
    return true;
}

bool clod_insertion_grid_clear(const clod_insertion_grid *self, const double place[4])
{
    const size_t middle = cell_index(self, cell_of(self, 0, place[0]),
                                     cell_of(self, 1, place[1]), cell_of(self, 2, place[2]));
    if (!cell_clear(self, middle, place)) { // most of what is in the way is there
        return false;
    }
    const clod_insertion_range r = range_of(self, place);
    for (int32_t z = r.first[2]; z <= r.last[2]; z++) {
        for (int32_t y = r.first[1]; y <= r.last[1]; y++) {
            for (int32_t x = r.first[0]; x <= r.last[0]; x++) {
                if (!cell_clear(self, cell_index(self, x, y, z), place)) {
                    return false;
                }
            }
        }
    }
    return true;
}

/** Raise *worst to the largest overlap with the spheres noted in a cell. */
static void cell_overlap(const clod_insertion_grid *self, size_t cell, const double place[4],
                         double *worst, size_t *sphere)
{
    for (uint32_t n = self->head[cell]; n != CLOD_INSERTION_NONE; n = self->note[n].next) {
        const clod_insertion_sphere *sphere_there = &self->sphere[self->note[n].sphere];
        const double *other = sphere_there->place;
        if (!apart(place, other)) {
            const double x = place[0] - other[0];
            const double y = place[1] - other[1];
            const double z = place[2] - other[2];
            const double overlap = place[3] + other[3] - sqrt(x * x + y * y + z * z);
            if (overlap > *worst) {
                *worst = overlap;
                *sphere = sphere_there->number;
            }
        }
    }
}

double clod_insertion_grid_overlap(const clod_insertion_grid *self, const double place[4],
                                   size_t *sphere)
{
    double worst = 0.0;
    const clod_insertion_range r = range_of(self, place);
    for (int32_t z = r.first[2]; z <= r.last[2]; z++) {
        for (int32_t y = r.first[1]; y <= r.last[1]; y++) {
            for (int32_t x = r.first[0]; x <= r.last[0]; x++) {
                cell_overlap(self, cell_index(self, x, y, z), place, &worst, sphere);
            }
        }
    }
    return worst;
}

static bool fail_without_room(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "no memory to insert grains");
}

/** Note the sphere that was kept last in a cell. Notes and spheres are counted with 32 bits. */
static bool note_in(clod_insertion_grid *self, size_t cell, clod_status *status)
{
    if (self->count == CLOD_INSERTION_NONE ||
        !clod_room_for_one(&self->note, &self->capacity, self->count, sizeof *self->note)) {
        return fail_without_room(status);
    }
    self->note[self->count] =
        (clod_insertion_note){(uint32_t)(self->sphere_count - 1), self->head[cell]};
    self->head[cell] = (uint32_t)self->count++;
    return true;
}

/** A sphere, or an image of it, that is noted in cells then. */
static bool keep(clod_insertion_grid *self, const double place[4], clod_status *status)
{
    if (self->sphere_count == CLOD_INSERTION_NONE ||
        !clod_room_for_one(&self->sphere, &self->sphere_capacity, self->sphere_count,
                           sizeof *self->sphere)) {
        return fail_without_room(status);
    }
    clod_insertion_sphere *sphere = &self->sphere[self->sphere_count++];
    memcpy(sphere->place, place, sizeof sphere->place);
    sphere->number = (uint32_t)self->added;
    return true;
}

/** Note one image of a sphere. */
static bool add_image(clod_insertion_grid *self, const double place[4], clod_status *status)
{
    if (!keep(self, place, status)) {
        return false;
    }
    const clod_insertion_range r = range_of(self, place);
    for (int32_t z = r.first[2]; z <= r.last[2]; z++) {
        for (int32_t y = r.first[1]; y <= r.last[1]; y++) {
            for (int32_t x = r.first[0]; x <= r.last[0]; x++) {
                if (!note_in(self, cell_index(self, x, y, z), status)) {
                    return false;
                }
            }
        }
    }
    return true;
}

/** Coordinates of a sphere's images along an axis, if a sphere in the box can reach them; how many. */
static int images(const clod_insertion_grid *self, int axis, const double place[4], double x[3])
{
    const double reach = place[3] + self->largest;
    int count = 0;
    for (int k = 0; k < (self->period[axis] > 0.0 ? 3 : 1); k++) {
        const double turn = k == 2 ? -1.0 : (double)k; // itself first
        const double moved = place[axis] + turn * self->period[axis];
        if (moved >= self->low[axis] - reach && moved <= self->high[axis] + reach) {
            x[count++] = moved;
        }
    }
    return count;
}

bool clod_insertion_grid_add(clod_insertion_grid *self, const double place[4],
                             clod_status *status)
{
    double x[3], y[3], z[3];
    const int nx = images(self, 0, place, x);
    const int ny = images(self, 1, place, y);
    const int nz = images(self, 2, place, z);
    for (int image = 0; image < nx * ny * nz; image++) {
        const double moved[4] = {x[image % nx], y[image / nx % ny], z[image / nx / ny],
                                 place[3]};
        if (!add_image(self, moved, status)) {
            return false;
        }
    }
    self->added++;
    return true;
}

void clod_insertion_grid_fini(clod_insertion_grid *self)
{
    clod_memory_free(self->head);
    clod_memory_free(self->note);
    clod_memory_free(self->sphere);
    *self = (clod_insertion_grid){0};
}
