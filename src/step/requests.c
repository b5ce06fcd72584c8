#include "step/requests.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "state/ids.h"
#include "step/leavers.h"
#include "step/neighbour.h"

// ---- the order of the queue

static int by_number(const void *a, const void *b)
{
    const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

static int by_id(const void *a, const void *b)
{
    return by_number(&((const clod_new_grain *)a)->id, &((const clod_new_grain *)b)->id);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const clod_wall *)a)->name, ((const clod_wall *)b)->name);
}

static void sort(void *items, size_t count, size_t size,
                 int (*compare)(const void *, const void *))
{
    if (count > 1) { // else there may be no array
        qsort(items, count, size, compare);
    }
}

static void sort_queue(clod_changes *queue)
{
    sort(queue->new_grain, queue->new_grains, sizeof *queue->new_grain, by_id);
    sort(queue->lost_grain, queue->lost_grains, sizeof *queue->lost_grain, by_number);
    sort(queue->new_wall, queue->new_walls, sizeof *queue->new_wall, by_name);
}

// ---- grains

static bool find_lost(clod_requests *found, const clod_changes *queue, const clod_ids *rows,
                      clod_status *status)
{
    for (size_t k = 0; k < queue->lost_grains; k++) {
        const uint64_t id = queue->lost_grain[k];
        const bool twice = k > 0 && queue->lost_grain[k - 1] == id;
        found->lost_row[k] = clod_ids_row(rows, id);
        if (twice || found->lost_row[k] < 0) {
            return clod_status_fail(
                status, CLOD_USAGE, "grain %llu cannot be removed: %s", (unsigned long long)id,
                twice ? "it is to be removed twice" : "there is none with this id");
        }
    }
    return true;
}

/** Whether the grain of this id goes: then another may have the id. */
static bool is_lost(const clod_changes *queue, uint64_t id)
{
    return queue->lost_grains > 0 && bsearch(&id, queue->lost_grain, queue->lost_grains,
                                             sizeof *queue->lost_grain, by_number) != NULL;
}

/** Whether every period is long enough for the largest grain that comes. */
static bool check_periods(const clod_state *state, clod_status *status)
{
    double largest = 0.0;
    for (size_t k = 0; k < state->changes.new_grains; k++) {
        largest = fmax(largest, state->changes.new_grain[k].position[3]);
    }
    return clod_neighbour_periods_fit(&state->domain, largest, status);
}

static bool numbers_are_good(const clod_new_grain *g)
{
    bool good = g->position[3] > 0.0 && isfinite(g->position[3]) && g->density > 0.0 &&
                isfinite(g->density);
    for (int a = 0; a < 3; a++) {
        good = good && isfinite(g->position[a]) && isfinite(g->velocity[a]) &&
               isfinite(g->angular_velocity[a]);
    }
    return good;
}

static bool fail_twice(uint64_t id, clod_status *status)
{
    return clod_status_fail(status, CLOD_USAGE,
                            "grain %llu cannot be added: another one has this id",
                            (unsigned long long)id);
}

/** One grain that is to come: its numbers, its material, its position and its id. */
static bool check_new(const clod_state *state, const clod_laws *laws, const clod_ids *rows,
                      size_t k, clod_status *status)
{
    const clod_new_grain *grain = &state->changes.new_grain[k];
    const unsigned long long id = grain->id;
    if (!numbers_are_good(grain)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "grain %llu cannot be added: position and velocities must be "
                                "finite, radius (%g m) and density (%g kg/m3) positive",
                                id, grain->position[3], grain->density);
    }
    if (grain->material >= laws->materials) {
        return clod_status_fail(status, CLOD_USAGE,
                                "grain %llu cannot be added: material %d is unknown, there are "
                                "%d",
                                id, grain->material, laws->materials);
    }
    if (clod_leavers_face(&state->domain, grain->position) >= 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "grain %llu cannot be added: (%g, %g, %g) m is outside of the "
                                "domain",
                                id, grain->position[0], grain->position[1], grain->position[2]);
    }
    const bool twice = k > 0 && state->changes.new_grain[k - 1].id == grain->id; // they ascend
    return (!twice && (clod_ids_row(rows, id) < 0 || is_lost(&state->changes, grain->id))) ||
           fail_twice(grain->id, status);
}

bool clod_requests_check_ids(const clod_grains *grains, const uint64_t *ids, size_t count,
                             clod_status *status)
{
    clod_ids rows = {0};
    bool good = clod_ids_init(&rows, grains->id, grains->count, status);
    for (size_t k = 0; good && k < count; k++) {
        good = clod_ids_row(&rows, ids[k]) < 0 || fail_twice(ids[k], status);
    }
    clod_ids_fini(&rows);
    return good;
}

static bool check_grains(clod_requests *found, const clod_state *state, const clod_laws *laws,
                         clod_status *status)
{
    const clod_changes *queue = &state->changes;
    if (queue->lost_grains + queue->new_grains == 0) {
        return true;
    }
    found->lost_row = clod_memory_alloc(queue->lost_grains + 1, sizeof *found->lost_row);
    if (found->lost_row == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a list of changes");
    }
    clod_ids rows = {0};
    bool good = clod_ids_init(&rows, state->grains.id, state->grains.count, status) &&
                find_lost(found, queue, &rows, status);
    for (size_t k = 0; good && k < queue->new_grains; k++) {
        good = check_new(state, laws, &rows, k, status);
    }
    clod_ids_fini(&rows);
    return good && check_periods(state, status);
}

// ---- walls

/** A wall by its name. */
typedef struct named_wall {
    const char *name;
    int32_t wall;
} named_wall;

static int by_wall_name(const void *a, const void *b)
{
    return strcmp(((const named_wall *)a)->name, ((const named_wall *)b)->name);
}

/** Number of a wall, or -1. */
static int32_t wall_of(const named_wall *names, int32_t count, const char *name)
{
    const named_wall wanted = {name, -1};
    const named_wall *found =
        bsearch(&wanted, names, (size_t)count, sizeof *names, by_wall_name);
    return found != NULL ? found->wall : -1;
}

/** Ranks of the walls: those that go, then the new numbers of the others. */
static bool rank_walls(int32_t *rank, const clod_state *state, const named_wall *names,
                       clod_status *status)
{
    const clod_changes *queue = &state->changes;
    const int32_t count = state->walls.count;
    memset(rank, 0, (size_t)count * sizeof *rank);
    for (size_t k = 0; k < queue->lost_walls; k++) {
        const int32_t wall = wall_of(names, count, queue->lost_wall[k]);
        if (wall < 0) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "wall '%s' cannot be removed: there is none of this name",
                                    queue->lost_wall[k]);
        }
        rank[wall] = -1;
    }
    int32_t next = 0;
    for (int32_t w = 0; w < count; w++) {
        rank[w] = rank[w] < 0 ? -1 : next++;
    }
    return true;
}

/** No name twice, among walls that stay and walls that come. */
static bool check_names(const int32_t *rank, const clod_state *state, const named_wall *names,
                        clod_status *status)
{
    const clod_changes *queue = &state->changes;
    for (size_t k = 0; k < queue->new_walls; k++) {
        const char *name = queue->new_wall[k].name;
        const int32_t wall = wall_of(names, state->walls.count, name);
        const bool twice = k > 0 && strcmp(queue->new_wall[k - 1].name, name) == 0;
        if (twice || (wall >= 0 && rank[wall] >= 0)) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "wall '%s' cannot be added: another one has this name",
                                    name);
        }
    }
    return true;
}

static bool check_walls(clod_requests *found, const clod_state *state, clod_status *status)
{
    const clod_changes *queue = &state->changes;
    if (queue->lost_walls + queue->new_walls == 0) {
        return true;
    }
    const size_t count = (size_t)state->walls.count;
    named_wall *names = clod_memory_alloc(count + 1, sizeof *names);
    found->wall_rank = clod_memory_alloc(count + 1, sizeof *found->wall_rank);
    bool good = names != NULL && found->wall_rank != NULL;
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "no memory for a list of %zu walls", count);
    } else {
        for (size_t w = 0; w < count; w++) {
            names[w] = (named_wall){state->walls.wall[w].name, (int32_t)w};
        }
        qsort(names, count, sizeof *names, by_wall_name);
        good = rank_walls(found->wall_rank, state, names, status) &&
               check_names(found->wall_rank, state, names, status);
    }
    clod_memory_free(names);
    return good;
}

bool clod_requests_check(clod_requests *found, clod_state *state, const clod_laws *laws,
                         clod_status *status)
{
    *found = (clod_requests){0};
    if (state->changes.lacks_memory) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a list of changes");
    }
    sort_queue(&state->changes);
    return check_walls(found, state, status) && check_grains(found, state, laws, status);
}

void clod_requests_fini(clod_requests *self)
{
    clod_memory_free(self->lost_row);
    clod_memory_free(self->wall_rank);
    *self = (clod_requests){0};
}
