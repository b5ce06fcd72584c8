// Where grains are spread over ranks: what a rebuild does in place of a new order.
#include <string.h>

#include "step/migrate.h"

/** What the wide skin follows from. */
typedef struct skin_choice {
    clod_neighbour *neighbour;
    const clod_state *state;
    double speed; ///< m/s
} skin_choice;

static void note_radii(clod_neighbour *neighbour, const clod_layers_extent *bed)
{
    neighbour->radius_min = bed->least;
    neighbour->radius_max = bed->largest;
}

static double choose_skin(const void *context, const clod_layers_extent *bed)
{
    const skin_choice *choice = context;
    note_radii(choice->neighbour, bed);
    clod_neighbour_choose_skin(choice->neighbour, choice->state, choice->speed);
    return choice->neighbour->skin;
}

static void merge_leavers(const void *context, void *into, const void *from)
{
    (void)context;
    clod_leavers_merge(into, from);
}

void clod_spread_mark_leavers(clod_step *step, const clod_leavers_outlets *outlets,
                              double half_kick, clod_leavers *sums)
{
    clod_state *state = step->state;
    int32_t *rank = step->neighbour.rank;
    for (size_t g = 0; g < state->grains.count; g++) { // ghosts are counted by their owners
        rank[g] = clod_spread_owns(step->spread, (int32_t)g) ? 0 : CLOD_NEIGHBOUR_GOES;
    }
    clod_leavers_mark(sums, state, outlets, half_kick, rank);
    for (size_t g = 0; g < state->grains.count; g++) {
        if (!clod_spread_owns(step->spread, (int32_t)g) &&
            clod_leavers_exit(outlets, &state->domain, state->grains.position[g]) < 0) {
            rank[g] = 0;
        }
    }
    clod_ranks_merge(step->spread->ranks, sums, sizeof *sums, merge_leavers, NULL);
}

void clod_spread_disown(clod_step *step)
{
    for (size_t g = 0; g < step->state->grains.count; g++) {
        if (step->neighbour.rank[g] == CLOD_NEIGHBOUR_GOES) {
            step->spread->owner[g] = CLOD_SPREAD_NOBODY;
        }
    }
}

bool clod_spread_sorted(clod_step *step, clod_status *status)
{
    note_radii(&step->neighbour, &step->spread->bed);
    return clod_spread_list(step->spread, step->state, step->neighbour.skin, status);
}

bool clod_spread_rebuild(clod_step *step, double speed, clod_status *status)
{
    clod_state *state = step->state;
    clod_spread *spread = step->spread;
    memcpy(state->build_position, state->grains.position,
           state->grains.count * sizeof *state->build_position);
    const skin_choice choice = {&step->neighbour, state, speed};
    if (!clod_migrate(spread, state, state, choose_skin, &choice, status)) {
        return false;
    }
    clod_grains_pad(&state->grains);
    const bool sorted = clod_neighbour_sort_as_built(&step->neighbour, state, status);
    return clod_spread_agree(spread, sorted, status) && clod_spread_sorted(step, status);
}
