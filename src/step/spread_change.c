// Where grains are spread over ranks: grains that come between two steps.
#include <math.h>

#include "base/memory.h"
#include "state/ids.h"
#include "step/records.h"
#include "step/requests.h"
#include "step/spread.h"

bool clod_spread_make_room(clod_spread *self, clod_state *state, size_t rows,
                           clod_status *status)
{
    const size_t known = state->grains.count;
    if (!clod_records_reserve(state, rows, status)) {
        return false;
    }
    if (rows > self->owner_room) {
        int32_t *grown = clod_memory_grow(self->owner, known, rows, sizeof *grown);
        if (grown == NULL) {
            return clod_status_fail(status, CLOD_FAILED, "no memory for %zu grains", rows);
        }
        self->owner = grown;
        self->owner_room = rows;
    }
    for (size_t g = known; g < rows; g++) {
        self->owner[g] = self->ranks->rank;
    }
    return true;
}

bool clod_spread_check_ids(clod_spread *self, const clod_state *state, clod_status *status)
{
    const clod_changes *queue = &state->changes;
    size_t count = queue->new_grains;
    clod_ranks_tell(self->ranks, &count, sizeof count);
    uint64_t *ids = clod_memory_alloc(count + 1, sizeof *ids);
    const bool room = ids != NULL || clod_status_fail(status, CLOD_FAILED,
                                                      "no memory for %zu new grains", count);
    if (!clod_ranks_agree(self->ranks, room, status)) {
        clod_memory_free(ids);
        return false;
    }
    for (size_t k = 0; k < queue->new_grains; k++) { // of rank 0
        ids[k] = queue->new_grain[k].id;
    }
    clod_ranks_tell(self->ranks, ids, count * sizeof *ids);
    const bool good = clod_requests_check_ids(&state->grains, ids, count, status);
    clod_memory_free(ids);
    return clod_ranks_agree(self->ranks, good, status);
}

double clod_spread_fastest(const clod_step *step)
{
    const clod_state *state = step->state;
    double speed2 = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *v = state->grains.velocity[g];
        if (clod_spread_owns(step->spread, (int32_t)g)) {
            speed2 = fmax(speed2, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        }
    }
    double fastest = sqrt(-clod_spread_least(step->spread, -speed2));
    for (int32_t w = 0; w < state->walls.count; w++) {
        fastest = fmax(fastest, clod_wall_speed_bound(&state->walls.wall[w]));
    }
    return fastest;
}
