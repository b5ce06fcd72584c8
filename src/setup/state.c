#include "setup/state.h"

#include <math.h>
#include <string.h>

#include "config/testers.h"
#include "setup/bed.h"
#include "setup/bound.h"
#include "setup/domain.h"
#include "setup/grains.h"
#include "setup/region_walls.h"
#include "setup/walls.h"

/** Solid fraction assumed of a settled bed. */
#define BED_FRACTION 0.6

bool clod_setup_timestep(const clod_case *from, const clod_state *state, clod_timestep *result,
                         clod_status *status)
{
    *result = (clod_timestep){0};
    clod_setup_bound bound;
    const bool good = clod_setup_bound_init(&bound, from, state, status);
    if (good) {
        *result = clod_setup_bound_timestep(&bound, from);
    }
    clod_setup_bound_fini(&bound);
    return good && clod_timestep_accept(result, status);
}

void clod_setup_damping_on(clod_state *state, const clod_setup_bed *bed,
                           const clod_timestep *timestep)
{
    for (int32_t w = 0; w < state->walls.count; w++) {
        clod_wall *wall = &state->walls.wall[w];
        const double area = clod_setup_bed_pressed_area(wall, bed);
        if (wall->load == CLOD_LOAD_NONE || !(area > 0.0) || !(bed->volume > 0.0)) {
            continue; // on no bed it stays without damping
        }
        const double height = bed->volume / (BED_FRACTION * area);
        const double k =
            clod_setup_bed_stiffness(timestep->unloading, area, height, bed->radius_mean);
        clod_setup_wall_damping(wall, k);
    }
}

void clod_setup_damping(clod_state *state, const clod_timestep *timestep)
{
    const clod_setup_bed bed = clod_setup_bed_of(state);
    clod_setup_damping_on(state, &bed, timestep);
}

/** Time step of the grains that have been added up. */
static bool choose_step(const clod_case *from, const clod_setup_tally *tally,
                        const clod_state *state, clod_timestep *result, clod_status *status)
{
    *result = (clod_timestep){0};
    clod_setup_bound bound;
    const bool good = clod_setup_bound_init_of(&bound, from, tally, state, status);
    if (good) {
        *result = clod_setup_bound_timestep(&bound, from);
    }
    clod_setup_bound_fini(&bound);
    return good && clod_timestep_accept(result, status);
}

/** Everything but walls and regions; *tally is made. */
static bool make_bed(const clod_case *from, int64_t seed, const clod_setup_taker *taker,
                     clod_state *state, clod_setup_tally *tally, clod_status *status)
{
    if (from->has_domain) {
        clod_setup_domain(from, state); // insertion asks where space is periodic
    }
    clod_timestep timestep;
    const bool made = taker != NULL
                          ? clod_setup_grains_give(from, seed, taker, state, tally, status)
                          : clod_setup_grains(from, seed, state, tally, status);
    const clod_setup_bed *bed = &tally->bed;
    if (!made || !choose_step(from, tally, state, &timestep, status)) {
        return false;
    }
    if (bed->grains == 0 && !clod_config_begins_empty(from) &&
        clod_setup_grains_coming(from) == 0) {
        return clod_status_fail(status, CLOD_USAGE, "grains: the case has no grains");
    }
    clod_setup_domain_around(from, bed->low, bed->high, state);
    clod_setup_damping_on(state, bed, &timestep);
    state->dt = timestep.step;
    return clod_setup_wall_pace(&state->walls, state->dt, status);
}

bool clod_setup_state_give(const clod_case *from, int64_t seed, const clod_setup_taker *taker,
                           clod_state *state, clod_setup_bed *bed, clod_status *status)
{
    *state = (clod_state){.build_motion = -1.0,
                          .adhesion = from->stage_count > 0 ? from->stages[0].adhesion : 1.0};
    memcpy(state->gravity, from->gravity, sizeof state->gravity);
    if (!clod_setup_walls(from, &state->walls, status) ||
        !clod_setup_regions_reached(from, &state->walls, status)) {
        return false;
    }
    clod_setup_tally tally = {0};
    const bool good = make_bed(from, seed, taker, state, &tally, status);
    *bed = tally.bed;
    clod_setup_tally_fini(&tally);
    return good;
}

bool clod_setup_state(const clod_case *from, int64_t seed, clod_state *state,
                      clod_status *status)
{
    clod_setup_bed bed;
    return clod_setup_state_give(from, seed, NULL, state, &bed, status);
}
