#pragma once
/**
 * @file sim_series.h
 * The series of a simulation (clod/sim.h, which includes this header): what the case measures,
 * as `clod run` writes it into series.csv.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/sim_walls.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** One value of a row of the series. */
typedef struct clod_sim_column {
    const char *name; ///< as in series.csv: "gauge_chute.flow"
    const char *unit; ///< as there: "kg/s"; "1" for a plain number
    double value;     ///< not a number where there is nothing to tell
} clod_sim_column;

/**
 * Open the series now, or begin it anew: from now on gauges, clumps, build-up, loads of surfaces
 * and belts, the balance and residence times of the case are measured during clod_sim_advance.
 * It is open from the start when the case has inlets, which are among the measures: their
 * grains come, with ids that count up from the largest at the start. It goes through
 * checkpoints, also those that `clod run` wrote.
 *
 * Means of the whole run (output.steady_since) count from now on.
 *
 * Its columns are those of the walls that there are now. While it is open walls may come and go:
 *
 * - A wall that is gone has no values (not a number) until one of its name comes.
 * - A wall of another name has no column; clod_sim_wall_look tells its forces.
 * - The surfaces of a wall that comes have no sums, and so no values.
 * - A wall that comes is no outlet. An outlet whose wall is gone keeps its counts.
 *
 * Some walls of the case can neither go nor come while it is open, because a measure needs them:
 *
 * - a wall with a belt that has a column `pull`;
 * - a wall that is the belt of a gauge (gauges.NAME.belt);
 * - with build_up, a wall with a mesh, or with a belt, which is one.
 *
 * Errors  a request that is wrong, as clod_sim_change; CLOD_FAILED: memory.
 * Test    tests/sim/test_sim_series.c
 */
bool clod_sim_open_series(clod_sim *self, clod_status *status);

/**
 * Take a row: the columns of series.csv (docs/results-folder.md) behind its first four. Rates
 * and means are those since the row before, or since the series was opened (of surfaces, since
 * the simulation began); the means of walls (clod_sim_wall) begin anew. When rows are taken at the times of
 * `clod run` the values have the same bits.
 *
 * @param columns  [out] [count], owned by the simulation; names and units stay until the series
 *                 is opened anew, values until the next row
 * @param count    [out] the same for every row
 * Errors  CLOD_USAGE: the series is not open; as clod_sim_change; CLOD_FAILED: memory.
 * Test    tests/sim/test_sim_series.c
 */
bool clod_sim_series_row(clod_sim *self, const clod_sim_column **columns, size_t *count,
                         clod_status *status);

#ifdef __cplusplus
}
#endif
