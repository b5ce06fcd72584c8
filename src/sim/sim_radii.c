// Radii of the grains of a simulation that change, all at once.
#include <math.h>

#include "base/memory.h"
#include "setup/bound.h"
#include "sim/sim.h"
#include "step/neighbour.h"

/** Whether the rows stay where they are until the radii are used. */
static bool rows_stay(const clod_sim *self, const char *function, clod_status *status)
{
    const clod_changes *queue = &self->state.changes;
    return queue->new_grains + queue->lost_grains + queue->new_walls + queue->lost_walls == 0 ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: grains or walls were asked to come or go, which sorts the "
                            "rows; call clod_sim_change first",
                            function);
}

/** Numbers that radii can be, not too large for the periods. */
static bool are_radii(const clod_sim *self, const double *radii, const char *function,
                      clod_status *status)
{
    double largest = 0.0;
    for (size_t g = 0; g < self->state.grains.count; g++) {
        if (!(radii[g] > 0.0 && isfinite(radii[g]))) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "%s: radius of grain %llu is %g m; give a finite number above 0", function,
                (unsigned long long)self->state.grains.id[g], radii[g]);
        }
        largest = fmax(largest, radii[g]);
    }
    return clod_neighbour_periods_fit(&self->state.domain, largest, status);
}

/** Radii of all rows, where `to` or `from` may be those of the grains. */
static void copy(double *to, size_t to_stride, const double *from, size_t from_stride,
                 size_t count)
{
    for (size_t g = 0; g < count; g++) {
        to[g * to_stride] = from[g * from_stride];
    }
}

bool clod_sim_set_radii(clod_sim *self, const double *radii, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(radii, status) ||
        !rows_stay(self, __func__, status) || !clod_step_see(&self->step, status) ||
        !are_radii(self, radii, __func__, status)) {
        return false;
    }
    clod_grains *grains = &self->state.grains;
    double *before = clod_memory_alloc(grains->count + 1, sizeof *before);
    if (before == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu radii", grains->count);
    }
    double energy;
    if (!clod_sim_balance(self, &energy, status)) {
        clod_memory_free(before);
        return false;
    }
    double *rows = &grains->position[0][3];
    copy(before, 1, rows, 4, grains->count);
    copy(rows, 4, radii, 1, grains->count);
    const bool good = clod_setup_bound_fits(self->from, &self->state, "these radii", status);
    if (good) {
        for (size_t g = 0; g < grains->count; g++) {
            if (radii[g] != before[g]) {
                clod_grains_set_size(grains, g, radii[g],
                                     self->from->materials[grains->material[g]].density);
            }
        }
        clod_sim_renew_loans(self);
        clod_sim_moved(self, energy);
    } else {
        copy(rows, 4, before, 1, grains->count);
    }
    clod_memory_free(before);
    return good;
}
