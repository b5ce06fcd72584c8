#pragma once
/**
 * @file mesh_points.h
 * Points found near a segment: boxes around points that lie near each other on a Z-order curve.
 * Time for a segment grows with the points near it and with the boxes on its way: of n points that fill
 * a volume evenly, a long one passes some n^(1/3) boxes, of those that fill a plane n^(1/2).
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CLOD_MESH_POINTS_LEAF 8 ///< points below one box

typedef struct clod_mesh_points {
    const double (*places)[3]; ///< borrowed
    uint32_t *order;           ///< [count] the points along the curve
    double (*boxes)[2][3];     ///< [nodes] a binary tree, node n above 2 n + 1 and 2 n + 2; the
                               ///< last `leaves` have CLOD_MESH_POINTS_LEAF points each
    size_t count, nodes, leaves;
} clod_mesh_points;

/** A point near a segment. */
typedef struct clod_mesh_hit {
    uint32_t point;
    double along; ///< distance from the segment's begin to the nearest place on its line [m]
} clod_mesh_hit;

/** Hits of a segment; the room is kept for the next one. */
typedef struct clod_mesh_hits {
    clod_mesh_hit *items; ///< [room] owned (clod_memory_free)
    size_t count, room;
    size_t boxes; ///< that were looked at for all segments: what the searches cost
} clod_mesh_hits;

/**
 * Sort points.
 *
 * @param places   places of all points, by number
 * @param points   [count] numbers of those that can be found; at least one
 * @return         false without memory; free with clod_mesh_points_fini in any case
 * Test  tests/mesh/test_mesh_points.c
 */
bool clod_mesh_points_init(clod_mesh_points *self, const double (*places)[3],
                           const uint32_t *points, size_t count);

/**
 * Points within `reach` of the inside of a segment: farther than `reach` from both its ends,
 * measured along it.
 *
 * @param hits  [out] sorted by `along`
 * @return      false without memory
 */
bool clod_mesh_points_near(const clod_mesh_points *self, const double begin[3],
                           const double end[3], double reach, clod_mesh_hits *hits);

/** Make a box hold another one. */
void clod_mesh_points_grow(double box[2][3], const double low[3], const double high[3]);

void clod_mesh_points_fini(clod_mesh_points *self);
