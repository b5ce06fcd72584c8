#pragma once
/**
 * @file partition.h
 * Which rank owns which part of space: recursive coordinate bisection. Planes are put anywhere
 * along an axis, by the weights of the blocks of a grid, which are taken to be even within a
 * block; they stay until the bed is cut anew. Every rank makes the same from the same numbers. No
 * result depends on where the cuts are.
 *
 * Source  Berger and Bokhari (1987), doi:10.1109/TC.1987.1676942.   Test  tests/step/test_partition.c
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"
#include "state/domain.h"

/** Blocks of the grid: so many for each rank, but at least and at most; and of these, along an axis. */
enum {
    CLOD_PARTITION_EACH = 64,
    CLOD_PARTITION_LEAST = 16384,
    CLOD_PARTITION_MOST = 1 << 20,
    CLOD_PARTITION_ACROSS_LEAST = 64,
    CLOD_PARTITION_ACROSS_MOST = 256
};

/** Where a piece of the bed is cut: lower places belong to the lower ranks of the piece. */
typedef struct clod_partition_plane {
    int axis;
    double at; ///< m
} clod_partition_plane;

typedef struct clod_partition {
    int ranks;
    size_t most;                 ///< blocks
    int32_t across;              ///< of them, along an axis
    bool exists;                 ///< it has been cut, with some weight
    int32_t n[3];                ///< blocks along each axis, of the last grid
    double min[3];               ///< m
    double width[3];             ///< m, of a block
    float *weight;               ///< [most]
    clod_partition_plane *plane; ///< [ranks] of r > 0: below the upper half that begins with r
    double low[3], high[3];      ///< m, box of all
} clod_partition;

bool clod_partition_init(clod_partition *self, int ranks, clod_status *status);

/** A grid over a box, without any weight in it. */
void clod_partition_begin(clod_partition *self, const double min[3], const double max[3]);

/** Put a weight into the block at a place; 2^24 times of them at most add up. */
void clod_partition_add(clod_partition *self, const double position[3], double weight);

/** All weights times a factor. */
void clod_partition_scale(clod_partition *self, double factor);

/** Weights of another rank onto those of this one. */
void clod_partition_merge(float *into, const float *from, size_t blocks);

/** Number of blocks: `weight` has so many. */
size_t clod_partition_blocks(const clod_partition *self);

/** Cut by the weights of all ranks, along the axes of the last cut where they are still good: so
 *  planes move as little as the weights do. */
void clod_partition_cut(clod_partition *self);

/** All grains lie within a box, so those of each rank within its box between the planes. */
void clod_partition_bound(clod_partition *self, const double min[3], const double max[3]);

/** The rank that owns a place. */
int clod_partition_owner(const clod_partition *self, const double position[3]);

/**
 * The ranks whose boxes are within `reach` [m] of a place along every axis, by the nearest image where
 * the domain is periodic; as many steps as there are such ranks, times log2(ranks).
 *
 * @param rank  [ranks] [out] ascending
 * @return      how many
 */
int clod_partition_reach(const clod_partition *self, const clod_domain *domain,
                         const double position[3], double reach, int *rank);

void clod_partition_fini(clod_partition *self);
