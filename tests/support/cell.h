#pragma once
/**
 * @file cell.h
 * What the tests of all testers' cells share: cases, and grains by brute force.
 */

#include <string.h>

#include "geometry/wall_gap.h"
#include "state/state.h"
#include "support/case_of.h"

static inline void cell_end(clod_case *from, clod_state *state)
{
    clod_state_fini(state);
    clod_case_destroy(&from);
}

/** No grain touches another one or a wall. */
static inline void cell_check_nothing_touches(const clod_state *state)
{
    const clod_grains *g = &state->grains;
    for (size_t i = 0; i < g->count; i++) {
        const double *p = g->position[i];
        for (int w = 0; w < (int)state->walls.count; w++) {
            const clod_wall *wall = &state->walls.wall[w];
            for (int k = 0; k < wall->shape_count; k++) {
                const clod_gap gap =
                    clod_wall_gap(&wall->shapes[k], (clod_vec3){p[0], p[1], p[2]});
                check_at_least(gap.distance, p[3]);
            }
        }
        for (size_t j = i + 1; j < g->count; j++) {
            const double *q = g->position[j];
            const double reach = p[3] + q[3];
            const double square = (p[0] - q[0]) * (p[0] - q[0]) +
                                  (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]);
            check_at_least(square, reach * reach);
        }
    }
}
