#include "geometry/sphere_grid.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"

/** Cells first to last that a sphere touches in each direction. */
typedef struct clod_sphere_range {
    int32_t first[3], last[3];
} clod_sphere_range;

/** Room for what is expected, so that little is copied while it grows: unused pages take no memory. */
static bool reserve(clod_sphere_grid *self, size_t cells, size_t spheres)
{
    return clod_room_for(&self->cell, &self->cell_capacity, cells + cells / 2,
                         sizeof *self->cell) &&
           clod_room_for(&self->sphere, &self->sphere_capacity, spheres,
                         sizeof *self->sphere) &&
           clod_room_for(&self->number, &self->number_capacity, spheres, sizeof *self->number);
}

bool clod_sphere_grid_begin(clod_sphere_grid *self, const double low[3], const double high[3],
                            const double period[3], double largest, size_t spheres,
                            clod_status *status)
{
    self->largest = largest;
    self->sphere_count = self->added = 0;
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
    if (!reserve(self, cells, spheres)) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a grid of grains");
    }
    self->cell_count = cells;
    memset(self->cell, 0xff, cells * sizeof *self->cell); // CLOD_SPHERE_NONE
    return true;
}

static int32_t cell_of(const clod_sphere_grid *self, int axis, double x)
{
    const double c = (x - self->low[axis]) * self->inverse[axis];
    return (int32_t)fmin(fmax(c, 0.0), self->cells[axis] - 1.0);
}

static clod_sphere_range range_of(const clod_sphere_grid *self, const double place[4])
{
    clod_sphere_range range;
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

static size_t cell_index(const clod_sphere_grid *self, int32_t x, int32_t y, int32_t z)
{
    return ((size_t)z * (size_t)self->cells[1] + (size_t)y) * (size_t)self->cells[0] +
           (size_t)x;
}

static bool cell_clear(const clod_sphere_grid *self, size_t c, const double place[4])
{
    for (; c != CLOD_SPHERE_NONE; c = self->cell[c].more) {
        const clod_sphere_cell *cell = &self->cell[c];
        for (int k = 0; k < CLOD_SPHERE_NOTES && cell->sphere[k] != CLOD_SPHERE_NONE; k++) {
            if (!apart(place, self->sphere[cell->sphere[k]])) {
                return false;
            }
        }
    }
    return true;
}

bool clod_sphere_grid_clear(const clod_sphere_grid *self, const double place[4])
{
    const size_t middle = cell_index(self, cell_of(self, 0, place[0]),
                                     cell_of(self, 1, place[1]), cell_of(self, 2, place[2]));
    if (!cell_clear(self, middle, place)) { // most of what is in the way is there
        return false;
    }
    const clod_sphere_range r = range_of(self, place);
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

/** Raise *worst to the largest overlap with the spheres noted in a cell, the newest first. */
static void cell_overlap(const clod_sphere_grid *self, size_t c, const double place[4],
                         double *worst, size_t *sphere)
{
    for (; c != CLOD_SPHERE_NONE; c = self->cell[c].more) {
        for (int k = CLOD_SPHERE_NOTES - 1; k >= 0; k--) {
            const uint32_t note = self->cell[c].sphere[k];
            if (note == CLOD_SPHERE_NONE || apart(place, self->sphere[note])) {
                continue;
            }
            const double *other = self->sphere[note];
            const double x = place[0] - other[0];
            const double y = place[1] - other[1];
            const double z = place[2] - other[2];
            const double overlap = place[3] + other[3] - sqrt(x * x + y * y + z * z);
            if (overlap > *worst) {
                *worst = overlap;
                *sphere = self->number[note];
            }
        }
    }
}

double clod_sphere_grid_overlap(const clod_sphere_grid *self, const double place[4],
                                size_t *sphere)
{
    double worst = 0.0;
    const clod_sphere_range r = range_of(self, place);
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
    return clod_status_fail(status, CLOD_FAILED, "no memory for a grid of grains");
}

/** Note the sphere that was kept last in a cell. Cells and spheres are counted with 32 bits. */
static bool note_in(clod_sphere_grid *self, size_t c, clod_status *status)
{
    const uint32_t sphere = (uint32_t)(self->sphere_count - 1);
    uint32_t *note = self->cell[c].sphere;
    for (int k = 0; k < CLOD_SPHERE_NOTES; k++) {
        if (note[k] == CLOD_SPHERE_NONE) {
            note[k] = sphere;
            return true;
        }
    }
    if (self->cell_count == CLOD_SPHERE_NONE ||
        !clod_room_for_one(&self->cell, &self->cell_capacity, self->cell_count,
                           sizeof *self->cell)) {
        return fail_without_room(status);
    }
    self->cell[self->cell_count] = self->cell[c]; // the older ones
    memset(&self->cell[c], 0xff, sizeof *self->cell);
    self->cell[c].sphere[0] = sphere;
    self->cell[c].more = (uint32_t)self->cell_count++;
    return true;
}

/** A sphere, or an image of it, that is noted in cells then. */
static bool keep(clod_sphere_grid *self, const double place[4], clod_status *status)
{
    if (self->sphere_count == CLOD_SPHERE_NONE ||
        !clod_room_for_one(&self->sphere, &self->sphere_capacity, self->sphere_count,
                           sizeof *self->sphere) ||
        !clod_room_for_one(&self->number, &self->number_capacity, self->sphere_count,
                           sizeof *self->number)) {
        return fail_without_room(status);
    }
    memcpy(self->sphere[self->sphere_count], place, sizeof *self->sphere);
    self->number[self->sphere_count++] = (uint32_t)self->added;
    return true;
}

/** Note one image of a sphere. */
static bool add_image(clod_sphere_grid *self, const double place[4], clod_status *status)
{
    if (!keep(self, place, status)) {
        return false;
    }
    const clod_sphere_range r = range_of(self, place);
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
static int images(const clod_sphere_grid *self, int axis, const double place[4], double x[3])
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

bool clod_sphere_grid_add(clod_sphere_grid *self, const double place[4], clod_status *status)
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

void clod_sphere_grid_fini(clod_sphere_grid *self)
{
    clod_memory_free(self->cell);
    clod_memory_free(self->sphere);
    clod_memory_free(self->number);
    *self = (clod_sphere_grid){0};
}
