#include "setup/pieces.h"

bool clod_setup_pieces_inside(const clod_case *from, const clod_state *state, size_t first,
                              double diameter, clod_status *status)
{
    const clod_grains *grains = &state->grains;
    for (size_t g = first; from->has_domain && g < grains->count; g++) {
        for (int a = 0; a < 3; a++) {
            const double beyond = from->periodic[a] ? diameter : 0.0;
            const double x = grains->position[g][a];
            if (!(x >= from->domain_min[a] - beyond && x <= from->domain_max[a] + beyond)) {
                return clod_status_fail(
                    status, CLOD_USAGE,
                    "grains: grain %llu is outside the domain: %c = %g m, allowed %g to %g m; "
                    "move it, or enlarge the domain",
                    (unsigned long long)grains->id[g], "xyz"[a], x, from -> domain_min[a],
                    from -> domain_max[a]);
            }
        }
    }
    return true;
}

bool clod_setup_pieces_give(clod_setup_pieces *self, bool all, clod_status *status)
{
    clod_state *state = self->state;
    const size_t rows = state->grains.count - self->kept;
    if (rows == 0 || (!all && rows < self->taker->piece)) {
        return true;
    }
    clod_setup_tally_add(self->tally, state, self->kept);
    if (self->outside.code == CLOD_OK) { // told when all groups have found their places
        clod_setup_pieces_inside(self->from, state, self->kept, self->diameter, &self->outside);
    }
    const bool good = self->taker->take(self->taker->context, state, self->kept, status);
    self->kept = state->grains.count;
    return good;
}

bool clod_setup_pieces_near(clod_setup_pieces *self, const clod_domain_box *box,
                            clod_setup_places *found, clod_status *status)
{
    *found = (clod_setup_places){0};
    return !self->some ||
           self->taker->near(self->taker->context, &self->state->domain, box, found, status);
}
