#include "setup/arrival.h"

#include <string.h>

#include "base/memory.h"
#include "setup/state.h"
#include "state/ids.h"

bool clod_setup_arrival_loads(const clod_changes *queue)
{
    bool any = false;
    for (size_t k = 0; k < queue->new_walls; k++) {
        any |= queue->new_wall[k].load != CLOD_LOAD_NONE;
    }
    return any;
}

/** Ids of the grains that there are, and of those that come behind them; NULL without memory. */
static uint64_t *list_ids(const clod_state *state, clod_status *status)
{
    const size_t old = state->grains.count, fresh = state->changes.new_grains;
    uint64_t *id = clod_memory_alloc(old + fresh + 1, sizeof *id);
    if (id == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for a list of %zu grains",
                         old + fresh);
        return NULL;
    }
    if (old > 0) { // else there may be no array
        memcpy(id, state->grains.id, old * sizeof *id);
    }
    for (size_t k = 0; k < fresh; k++) {
        id[old + k] = state->changes.new_grain[k].id;
    }
    return id;
}

static bool add_old(clod_grains *to, const clod_case *from, const clod_grains *grains,
                    size_t row, clod_status *status)
{
    return clod_grains_add(to, grains->position[row], grains->velocity[row],
                           grains->angular_velocity[row],
                           from->materials[grains->material[row]].density,
                           grains->material[row], grains->id[row], status);
}

/** Grains in the order of their ids, so that no sum depends on where the search put them. */
static bool add_grains(clod_state *after, const clod_case *from, const clod_state *state,
                       clod_status *status)
{
    const clod_changes *queue = &state->changes;
    const size_t old = state->grains.count, all = old + queue->new_grains;
    uint64_t *id = list_ids(state, status);
    clod_ids order = {0};
    bool good = id != NULL && clod_ids_init(&order, id, all, status) &&
                clod_grains_reserve(&after->grains, all, status);
    size_t lost = 0;
    for (size_t k = 0; good && k < all; k++) { // the lost ids ascend too
        const size_t row = order.item[k].index;
        if (row >= old) {
            good = clod_new_grain_join(&queue->new_grain[row - old], &after->grains, status);
        } else if (lost < queue->lost_grains && queue->lost_grain[lost] == id[row]) {
            lost++;
        } else {
            good = add_old(&after->grains, from, &state->grains, row, status);
        }
    }
    clod_ids_fini(&order);
    clod_memory_free(id);
    return good;
}

static bool is_lost(const clod_changes *queue, const clod_wall *wall)
{
    bool lost = false;
    for (size_t k = 0; k < queue->lost_walls; k++) {
        lost |= strcmp(queue->lost_wall[k], wall->name) == 0;
    }
    return lost;
}

static bool add_walls(clod_walls *to, const clod_state *state, clod_status *status)
{
    const clod_changes *queue = &state->changes;
    const size_t most = (size_t)state->walls.count + queue->new_walls;
    to->wall = clod_memory_alloc(most, sizeof *to->wall);
    if (to->wall == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a list of %zu walls", most);
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        if (!is_lost(queue, &state->walls.wall[w])) {
            to->wall[to->count++] = state->walls.wall[w];
        }
    }
    for (size_t k = 0; k < queue->new_walls; k++) {
        to->wall[to->count++] = queue->new_wall[k];
    }
    return true;
}

bool clod_setup_arrival_init(clod_state *after, const clod_case *from, const clod_state *state,
                             clod_status *status)
{
    *after = (clod_state){.dt = state->dt};
    memcpy(after->gravity, state->gravity, sizeof after->gravity);
    return add_walls(&after->walls, state, status) && add_grains(after, from, state, status);
}

void clod_setup_arrival_damp(clod_state *after, const clod_timestep *timestep,
                             const clod_changes *queue)
{
    clod_setup_damping(after, timestep);
    const clod_wall *come = after->walls.wall + after->walls.count - queue->new_walls;
    for (size_t k = 0; k < queue->new_walls; k++) {
        queue->new_wall[k].damping = come[k].damping;
    }
}

void clod_setup_arrival_fini(clod_state *after)
{
    clod_grains_fini(&after->grains);
    clod_memory_free(after->walls.wall);
    *after = (clod_state){0};
}
