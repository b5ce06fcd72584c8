#pragma once
/** @file rolling_grains.h
 *  Grains that roll over seams of a mesh or over a plane, for tests that compare where they end. */

#include <string.h>

#include "support/sim_made.h"

#define ROLLING_GRAINS 20

/** Let grains fall, slide and roll to the left over x = 0 and what lies there; where they are in the end. */
static inline void roll_over(clod_sim *sim, double to[ROLLING_GRAINS][3])
{
    for (int g = 0; g < ROLLING_GRAINS; g++) {
        const clod_sim_grain grain = {
            .id = 1 + (uint64_t)g,
            .radius = 0.003,
            .position = {0.0003 + 0.0001 * g, 0.0071 * (g - 10), 0.0031 + 0.0001 * (g % 3)},
            .velocity = {-0.4, 0.005 * (g % 4), -0.1}};
        CHECK(clod_sim_add_grain(sim, &grain, &status));
    }
    CHECK(clod_sim_advance(sim, 30000, &status));
    const clod_sim_view view = sim_view(sim, "position");
    for (int g = 0; g < ROLLING_GRAINS; g++) {
        const size_t at = clod_sim_row_of_id(sim, 1 + (uint64_t)g);
        memcpy(to[g], clod_sim_row(&view, at), sizeof to[g]);
    }
    clod_sim_destroy(&sim);
}
