#pragma once
/**
 * @file partition.h
 * Which rank owns which part of space: recursive coordinate bisection of a grid of blocks, by the
 * numbers of grains in them. Every rank makes the same from the same numbers. No result depends
 * on where the cuts are.
 *
 * Source  Berger and Bokhari (1987), doi:10.1109/TC.1987.1676942.   Test  tests/step/test_partition.c
 */

#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"
#include "state/domain.h"

/** Most blocks of the grid, and along an axis. */
enum { CLOD_PARTITION_BLOCKS = 16384, CLOD_PARTITION_ACROSS = 64 };

typedef struct clod_partition {
    int ranks;
    int32_t n[3];                 ///< blocks along each axis
    double min[3];                ///< m
    double width[3];              ///< m, of a block
    int32_t *owner;               ///< [blocks] rank of each
    int32_t *weight;              ///< [blocks] grains in each
    double (*low)[3], (*high)[3]; ///< [ranks] m, box of each; low = high: it has no block
} clod_partition;

bool clod_partition_init(clod_partition *self, int ranks, clod_status *status);

/** A grid over a box, without any grains in it. */
void clod_partition_begin(clod_partition *self, const double min[3], const double max[3]);

/** Count a grain in its block. */
void clod_partition_add(clod_partition *self, const double position[3]);

/** Grains of another rank in each block onto those of this one; a block with more than INT32_MAX
 *  weighs as much as that. */
void clod_partition_merge(int32_t *into, const int32_t *from, size_t blocks);

/** Number of blocks: `weight` has so many. */
size_t clod_partition_blocks(const clod_partition *self);

/** Cut by the weights of all ranks. */
void clod_partition_cut(clod_partition *self);

/** The rank that owns a place; places beyond the box belong to the nearest block. */
int clod_partition_owner(const clod_partition *self, const double position[3]);

/** Whether a place is within `reach` [m] of the box of a rank, along every axis, by the nearest
 *  image where the domain is periodic. */
bool clod_partition_reaches(const clod_partition *self, const clod_domain *domain, int rank,
                            const double position[3], double reach);

void clod_partition_fini(clod_partition *self);
