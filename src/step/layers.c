#include "step/layers.h"

#include <math.h>

// Bits of the key for layer or line, and for the position in a line; the strip has the 7 that
// are left.
#define BITS 18
#define POSITION_BITS 21
#define STEPS(bits) ((double)((1 << (bits)) - 1))
#define MOST_STRIPS 127.0
#define FULL_LAYER 5000.0 ///< grains: their rows take 0.8 MB (docs/adr/0017)

/** Axes from the longest side to the shortest; equal sides as x, y, z. */
static void order_axes(clod_layers *self, const double extent[3])
{
    for (int a = 0; a < 3; a++) {
        int longer = 0;
        for (int b = 0; b < 3; b++) {
            longer += b < a ? extent[b] >= extent[a] : extent[b] > extent[a];
        }
        self->axis[longer] = a;
    }
}

clod_layers_extent clod_layers_extent_of(const double (*position)[4], size_t count)
{
    double min[3] = {INFINITY, INFINITY, INFINITY}, max[3] = {-INFINITY, -INFINITY, -INFINITY};
    double least = INFINITY, largest = 0.0; // radii: not their sum, which has an order
    for (size_t g = 0; g < count; g++) {
        for (int a = 0; a < 3; a++) {
            const double x = position[g][a]; // finite: no need of fmin
            min[a] = x < min[a] ? x : min[a];
            max[a] = x > max[a] ? x : max[a];
        }
        const double radius = position[g][3];
        least = radius < least ? radius : least;
        largest = radius > largest ? radius : largest;
    }
    return (clod_layers_extent){.min = {min[0], min[1], min[2]},
                                .max = {max[0], max[1], max[2]},
                                .least = least,
                                .largest = largest,
                                .count = count};
}

void clod_layers_extent_merge(clod_layers_extent *self, const clod_layers_extent *other)
{
    for (int a = 0; a < 3; a++) {
        self->min[a] = fmin(self->min[a], other->min[a]);
        self->max[a] = fmax(self->max[a], other->max[a]);
    }
    self->least = fmin(self->least, other->least);
    self->largest = fmax(self->largest, other->largest);
    self->count += other->count;
}

clod_layers clod_layers_from(const clod_layers_extent *bed)
{
    clod_layers self = {.axis = {0, 1, 2}, .strips = 1.0};
    if (bed->count == 0) {
        return self;
    }
    double extent[3];
    for (int a = 0; a < 3; a++) {
        extent[a] = bed->max[a] - bed->min[a];
    }
    order_axes(&self, extent);
    for (int k = 0; k < 3; k++) {
        const double length = extent[self.axis[k]];
        const double finest = length > 0.0 ? STEPS(k < 2 ? BITS : POSITION_BITS) / length : 0.0;
        self.min[k] = bed->min[self.axis[k]];
        self.scale[k] = k < 2 ? fmin(1.0 / (bed->least + bed->largest), finest) : finest;
    }
    const double layers = floor(extent[self.axis[0]] * self.scale[0]) + 1.0;
    const double width = extent[self.axis[1]];
    if (width > 0.0) {
        self.strips = fmin(ceil((double)bed->count / layers / FULL_LAYER), MOST_STRIPS);
        self.strip_scale = self.strips / width;
    }
    return self;
}

clod_layers clod_layers_of(const double (*position)[4], size_t count)
{
    const clod_layers_extent extent = clod_layers_extent_of(position, count);
    return clod_layers_from(&extent);
}

static uint64_t part_of_key(const clod_layers *self, const double position[4], int k)
{
    return (uint64_t)((position[self->axis[k]] - self->min[k]) * self->scale[k]);
}

/** Strip and layer. */
static uint64_t layer_of(const clod_layers *self, const double position[4])
{
    const double strip = (position[self->axis[1]] - self->min[1]) * self->strip_scale;
    return (uint64_t)fmin(strip, self->strips - 1.0) << BITS | part_of_key(self, position, 0);
}

uint64_t clod_layers_key(const clod_layers *self, const double position[4])
{
    return (layer_of(self, position) << BITS | part_of_key(self, position, 1))
               << POSITION_BITS |
           part_of_key(self, position, 2);
}

size_t clod_layers_fullest(const clod_layers *self, const double (*position)[4], size_t count)
{
    size_t fullest = 0, begin = 0;
    for (size_t g = 0; g < count; g++) {
        if (layer_of(self, position[g]) != layer_of(self, position[begin])) {
            begin = g;
        }
        fullest = g + 1 - begin > fullest ? g + 1 - begin : fullest;
    }
    return fullest;
}
