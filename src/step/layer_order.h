#pragma once
/**
 * @file layer_order.h
 * The one total order of grains, found by several parts: by layers (layers.h), then by id. It
 * depends on neither parts nor threads.
 *
 * In phases, each when the one before is done by all: measure by all parts, begin by one thread,
 * find_keys by all parts, sort by all threads. The neighbour's `sort` then has the old row of each
 * new one, and its `rank` the new row of each old one.
 *
 * Test  tests/step/test_layer_order.c, test_reorder.c, test_same_bits.c, test_ranks.c
 */

#include "parallel/barrier.h"
#include "step/layers.h"
#include "step/neighbour.h"

/** What one part finds; on its own cache lines. */
struct clod_layer_order_part {
    _Alignas(64) clod_layers_extent extent; ///< of its rows that stay
    size_t begin;                           ///< place of their keys
    bool outside;                           ///< one of them has left the domain
};

typedef struct clod_layer_order {
    clod_neighbour *neighbour; ///< with room for the grains and the parts
    const clod_grains *grains;
    const double (*place)[4]; ///< [grains] where they are, or were: x, y, z, radius [m]
    size_t going;             ///< so many go: their rank is below 0, before and after
    int parts;
    clod_layers layers;
} clod_layer_order;

/** Room for what so many parts find; false without memory. */
bool clod_layer_order_reserve(clod_neighbour *neighbour, int parts);

/** Extent of a part's grains that stay. */
void clod_layer_order_measure(const clod_layer_order *self, int part);

/** The layers of all of them. */
void clod_layer_order_begin(clod_layer_order *self);

/** Keys of a part's grains that stay. */
void clod_layer_order_find_keys(const clod_layer_order *self, int part);

/** Sort them; every thread calls this with the parts it does. */
void clod_layer_order_sort(const clod_layer_order *self, clod_chunk parts,
                           clod_barrier *barrier);

/** All of that by one thread, as one part. */
void clod_layer_order_find(clod_layer_order *self);
