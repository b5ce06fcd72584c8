#include "setup/begin.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/memory.h"
#include "config/region.h"
#include "config/testers.h"
#include "setup/grains.h"
#include "setup/jenike_cell.h"
#include "setup/ring_cell.h"
#include "setup/state.h"
#include "setup/uniaxial_cell.h"
#include "setup/wall_friction_cell.h"

/** Solid fraction of grains that stand for those of an inlet. */
#define LOOSE 0.1

/** What a case begins with: one row for each kind of case. */
typedef struct cell {
    bool (*make)(const clod_case *from, int64_t seed, clod_state *state, clod_status *status);
    /** Sizes and amount of a tester's grains. */
    bool (*amount)(const clod_case *from, clod_sizes *sizes, clod_amount *amount,
                   clod_status *status);
    size_t count; ///< where clod_case has the number of them
} cell;

static const cell CELL[CLOD_CASE_KINDS] = {
    [CLOD_CASE_FREE] = {.make = clod_setup_state},
    [CLOD_CASE_RING_SHEAR] = {clod_setup_ring_cell, clod_ring_cell_amount,
                              offsetof(clod_case, ring_shear.grain_count)},
    [CLOD_CASE_JENIKE] = {clod_setup_jenike_cell, clod_jenike_cell_amount,
                          offsetof(clod_case, jenike.grain_count)},
    [CLOD_CASE_UNIAXIAL] = {clod_setup_uniaxial_cell, clod_uniaxial_cell_amount,
                            offsetof(clod_case, uniaxial.grain_count)},
    [CLOD_CASE_WALL_FRICTION] = {clod_setup_wall_friction_cell, clod_wall_friction_cell_amount,
                                 offsetof(clod_case, wall_friction.grain_count)},
    [CLOD_CASE_CONTACT_BENCH] = {.make = clod_setup_state}, // as it is: no grains
};

bool clod_begin_state(const clod_case *from, int64_t seed, clod_state *state,
                      clod_status *status)
{
    return CELL[clod_case_kind_of(from)].make(from, seed, state, status);
}

bool clod_begin_has_grains(const clod_case *from, clod_status *status)
{
    return !clod_config_begins_empty(from) ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: the case has no grains; give grains, or add them by a program "
                            "of your own (clod_sim_add_grain)",
                            from->path);
}

bool clod_begin_expect(const clod_case *from, double share, double *grains, clod_status *status)
{
    const cell *row = &CELL[clod_case_kind_of(from)];
    if (row->amount == NULL) {
        return clod_setup_grains_open(from, status) &&
               clod_setup_grains_expect(from, share, grains, status);
    }
    clod_sizes sizes;
    clod_amount amount;
    if (!row->amount(from, &sizes, &amount, status)) {
        return false;
    }
    *grains = clod_amount_expect(&amount);
    return clod_amount_fits(amount.key, *grains, 1.0, status);
}

bool clod_begin_fill(const clod_case *from, double *grains, clod_status *status)
{
    clod_sizes sizes;
    clod_amount amount;
    if (!CELL[clod_case_kind_of(from)].amount(from, &sizes, &amount, status)) {
        return false;
    }
    amount.count = 0;
    *grains = round(clod_amount_expect(&amount));
    return true;
}

/** Grains in the region of an inlet, loosely, for those that come through it. */
static bool stand_for_inlet(clod_case_grains *group, clod_status *status)
{
    clod_case_region *r = &group->region;
    clod_sizes sizes;
    const bool good = clod_sizes_init(&sizes, group, status);
    if (good) {
        const double largest = cbrt(clod_sizes_largest_volume(&sizes));
        r->depth =
            clod_region_is_face(r) ? 3.0 * largest : 0.0; // some grains, one behind the other
        const double room = LOOSE * clod_region_area(r) * clod_region_height(r);
        const double most = fmax(1.0, floor(room / clod_sizes_mean_volume(&sizes)));
        group->count = (int64_t)fmin((double)group->count, most);
        group->comes = false;
    }
    clod_sizes_fini(&sizes);
    return good;
}

/** The share of a group; a number takes the place of a mass or a height. */
static bool thin_groups(clod_case *thin, double share, clod_status *status)
{
    for (size_t k = 0; k < thin->grains_count; k++) {
        clod_case one = *thin;
        double grains;
        one.grains = &thin->grains[k];
        one.grains_count = 1;
        if (!clod_setup_grains_expect(&one, 0.0, &grains, status)) {
            return false;
        }
        clod_case_grains *group = &thin->grains[k];
        group->count = (int64_t)ceil(grains * share);
        group->mass = group->fill_height = 0.0;
        if (group->comes && !stand_for_inlet(group, status)) {
            return false;
        }
    }
    return true;
}

bool clod_begin_sample(const clod_case *from, double expected, double most, clod_state *state,
                       clod_status *status)
{
    const cell *row = &CELL[clod_case_kind_of(from)];
    clod_case thin = *from;
    *state = (clod_state){0};
    if (row->amount != NULL) {
        const int64_t count = (int64_t)fmin(most, expected);
        memcpy((char *)&thin + row->count, &count, sizeof count);
        return clod_begin_state(&thin, from->seed, state, status);
    }
    thin.grains = clod_memory_alloc(from->grains_count, sizeof *thin.grains);
    if (thin.grains == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a sample of the grains");
    }
    memcpy(thin.grains, from->grains, from->grains_count * sizeof *thin.grains);
    const bool good = thin_groups(&thin, fmin(1.0, most / expected), status) &&
                      clod_begin_state(&thin, from->seed, state, status);
    clod_memory_free(thin.grains);
    return good;
}
