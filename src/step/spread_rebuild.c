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
    if (!clod_migrate(spread, state, choose_skin, &choice, status)) {
        return false;
    }
    clod_grains_pad(&state->grains);
    const bool sorted = clod_neighbour_sort_as_built(&step->neighbour, state, status);
    return clod_spread_agree(spread, sorted, status) && clod_spread_sorted(step, status);
}
