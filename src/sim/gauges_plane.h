#pragma once
/**
 * @file gauges_plane.h
 * What has passed the plane of a gauge (docs/gauges.md): columns, lines and numbers of gauges that
 * have one.
 */

#include "sim/gauges.h"

/** Columns of a gauge with a plane, behind those of its stream. */
#define CLOD_GAUGES_PLANE_COLUMNS 5

/** The run begins. */
void clod_gauges_plane_begin(clod_gauges *self, const clod_case *from, const clod_state *state);

/** Note the edges of blocks that are behind by now. */
void clod_gauges_plane_note(clod_gauges *self, const clod_free_moment *now);

/** Steps to the next edge of a block, or one of those before it; INT64_MAX: there is none. */
int64_t clod_gauges_plane_plan(const clod_gauges *self, const clod_case *from,
                               const clod_state *state, const clod_steady_time *steady);

/** Flows forward less back in the blocks of the steady time, of a gauge that has a plane.
 *  @param block  [CLOD_STEADY_BLOCKS] kg/s;  @return  blocks that are over */
int clod_gauges_plane_blocks(const clod_gauges *self, size_t gauge, double *block);

/** "passed_forward [1]" of column k. */
const char *clod_gauges_plane_column(size_t k);

/** Values of the columns [CLOD_GAUGES_PLANE_COLUMNS] of a gauge of the case that has a plane; the flow is that since the
 *  row before. */
void clod_gauges_plane_row(clod_gauges *self, const clod_free_moment *now, size_t gauge,
                           double *row);

/** A line of the report, numbers of a gauge's object in the summary, and their paths; nothing without
 *  a plane. */
void clod_gauges_plane_report(FILE *out, const clod_gauges *self, const clod_free_moment *now,
                              size_t gauge);
void clod_gauges_plane_json(json_t *object, const clod_gauges *self,
                            const clod_free_moment *now, size_t gauge);
void clod_gauges_plane_paths(const clod_case_gauge *gauge, clod_free_paths *paths);
