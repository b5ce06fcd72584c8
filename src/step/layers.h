#pragma once
/**
 * @file layers.h
 * The order in which grains lie in memory: layers across the longest side of the bed, lines
 * across its next one in each layer, each as wide as the smallest and the largest radius
 * together, and along the lines by position. So the partners of a grain are at most about one
 * layer behind it, two for the largest of very different grains, however large the bed is; but
 * for those across a periodic longest side.
 *
 * A bed whose layers would be larger than a second cache is cut into strips across its second
 * longest side first, with layers of their own; the few partners across a strip's side are far.
 */

#include <stddef.h>
#include <stdint.h>

typedef struct clod_layers {
    int axis[3];        ///< along which layers, lines and places in a line ascend
    double min[3];      ///< m, of the grains' centres along each of them
    double scale[3];    ///< steps of the key per metre: layers, lines, places
    double strips;      ///< how many
    double strip_scale; ///< strips per metre along the axis of the lines
} clod_layers;

/** What the layers of a bed follow from: of parts of it they may be merged in any order. */
typedef struct clod_layers_extent {
    double min[3], max[3]; ///< m, of the grains' centres
    double least, largest; ///< m, radii
    size_t count;          ///< grains
} clod_layers_extent;

clod_layers_extent clod_layers_extent_of(const double (*position)[4], size_t count);
void clod_layers_extent_merge(clod_layers_extent *self, const clod_layers_extent *other);
clod_layers clod_layers_from(const clod_layers_extent *extent);

/**
 * Layers of a bed.
 *
 * @param position  [count] x, y, z, radius [m]
 * Errors  none.   Threads  pure.   Test  tests/step/test_layers.c
 */
clod_layers clod_layers_of(const double (*position)[4], size_t count);

/** Where a grain of the bed belongs: keys ascend by strip, layer, line and position. */
uint64_t clod_layers_key(const clod_layers *self, const double position[4]);

/** Rows of the fullest layer of a strip of a bed in this order. */
size_t clod_layers_fullest(const clod_layers *self, const double (*position)[4], size_t count);
